import { svg } from "./dom";
import { digits } from "./format";

/** Labels of powers of ten between two exponents, at most `most` of them. */
export function decades(low: number, high: number, most: number): number[] {
  const step = Math.max(1, Math.ceil((high - low) / most));
  return Array.from({ length: Math.floor((high - low) / step) + 1 }, (_, i) => low + i * step);
}

export const powerOfTen = (exponent: number): string => (exponent >= -3 && exponent <= 2 ? digits(10 ** exponent) : `1e${exponent}`);

/** Bars over a logarithmic axis. */
export function barChart(counts: number[], low: number, high: number, name: string): SVGElement {
  const [width, height, foot] = [320, 90, 18];
  const most = Math.max(1, ...counts);
  const w = width / counts.length;
  return svg("svg", { viewBox: `0 0 ${width} ${height + foot}`, class: "bars", role: "img", "aria-label": name },
    counts.map((count, i) => count > 0 && svg("rect", { x: i * w + 0.5, width: Math.max(w - 1, 1), y: height - Math.max(2, (count / most) * (height - 4)), height: Math.max(2, (count / most) * (height - 4)) }, svg("title", {}, String(count)))),
    svg("line", { x1: 0, x2: width, y1: height, y2: height }),
    decades(low, high, 6).map((e) => {
      const x = ((e - low) / (high - low)) * width;
      return svg("text", { x, y: height + 13, "text-anchor": e === low ? "start" : e === high ? "end" : "middle" }, powerOfTen(e));
    }));
}
