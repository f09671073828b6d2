import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { h, fill } from "./dom";
import { colourOf, prefersDark, type Look } from "./engines";
import { digits } from "./format";

export interface Line { name: string; look: Look | null; values: (number | null)[]; solid: boolean }

export interface PlotData {
  times: number[];
  unit: string;
  lines: Line[];
  /** The truth, drawn dashed and without colour, with its tolerance as a band. */
  truth?: { values: (number | null)[]; tolerance: number };
  /** A bound that must not be passed, drawn as a line. */
  bound?: number;
  logarithmic: boolean;
}

/** A plot over time whose cursor is the time that the reader looks at. */
export interface Plot {
  element: HTMLElement;
  set(data: PlotData): void;
  setTime(time: number): void;
  dispose(): void;
}

/** @param seek called with the time that the reader clicks
 *  @param empty what is said where nothing can be drawn */
export function makePlot(name: string, seek: (time: number) => void, empty: string): Plot {
  const place = h("div", { class: "plot-place" });
  const values = h("p", { class: "plot-values" });
  const element = h("figure", { class: "plot", role: "group", "aria-label": name }, place, values);
  let plot: uPlot | null = null;
  let data: PlotData | null = null;
  let now = 0;

  // An element over the plot: to draw the plot again for each frame of a playback would cost half of the frames.
  const cursor = h("div", { class: "plot-cursor", "aria-hidden": "true" });
  const placeCursor = (): void => {
    if (!plot) return;
    const x = plot.valToPos(now, "x");
    cursor.hidden = !(x >= 0 && x <= plot.over.clientWidth);
    cursor.style.setProperty("transform", `translateX(${x}px)`);
  };
  /** The tolerance around the truth. */
  const drawBand = (u: uPlot): void => {
    if (!data?.truth || data.logarithmic || !(data.truth.tolerance > 0)) return;
    const { times, truth: { values: list, tolerance } } = data;
    const known = list.map((v, i) => [times[i], v] as const).filter((pair): pair is readonly [number, number] => pair[1] !== null);
    const { ctx, bbox } = u;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    ctx.beginPath();
    for (const [t, v] of known) ctx.lineTo(u.valToPos(t, "x", true), u.valToPos(v + tolerance, "y", true));
    for (const [t, v] of known.reverse()) ctx.lineTo(u.valToPos(t, "x", true), u.valToPos(v - tolerance, "y", true));
    ctx.fillStyle = prefersDark() ? "rgba(255,255,255,0.17)" : "rgba(0,0,0,0.13)";
    ctx.fill();
    ctx.restore();
  };
  const tell = (): void => {
    if (!data) return;
    const { times, lines, unit, truth } = data;
    let i = 0;
    while (i + 1 < times.length && times[i + 1] <= now) ++i;
    const texts = lines.filter((l) => l.values[i] !== null && l.values[i] !== undefined).slice(0, 6).map((l) => `${l.name} ${digits(l.values[i]!, 4)}`);
    if (truth && truth.values[i] !== null) texts.unshift(`truth ${digits(truth.values[i]!, 4)}`);
    fill(values, texts.length ? `${texts.join(" · ")} ${unit}` : "");
  };
  const positive = (list: (number | null)[]): (number | null)[] => data!.logarithmic ? list.map((v) => (v === null || v === 0 ? null : Math.abs(v))) : list;
  const draw = (): void => {
    plot?.destroy();
    plot = null;
    if (!data) return;
    const { times, lines, truth, unit, bound, logarithmic } = data;
    if (times.length < 2 || lines.length === 0) { fill(place, h("p", { class: "quiet" }, empty)); return; }
    fill(place);
    const dark = prefersDark();
    const ink = dark ? "#c9cdd4" : "#474e59";
    const rule = dark ? "#343a44" : "#e3e6ea";
    const columns: (number | null)[][] = [];
    const series: uPlot.Series[] = [{}];
    const plain = { points: { show: false }, spanGaps: false };
    for (const { look, values: list, solid } of lines) {
      columns.push(positive(list));
      series.push({ ...plain, stroke: look ? colourOf(look) : ink, width: solid ? 2.5 : 1.4, dash: look?.dash });
    }
    // Last, so that the engine that keeps to it does not hide it.
    if (truth) {
      columns.push(positive(truth.values));
      series.push({ ...plain, stroke: dark ? "#fff" : "#000", dash: [6, 5], width: 1.5 });
    }
    if (bound !== undefined && (!logarithmic || bound > 0)) {
      columns.push(times.map(() => bound));
      series.push({ ...plain, stroke: ink, width: 1, dash: [2, 3] });
    }
    const axis = { stroke: ink, grid: { stroke: rule, width: 1 }, ticks: { stroke: rule, width: 1 }, font: "11px system-ui, sans-serif" };
    plot = new uPlot({
      width: Math.max(200, place.clientWidth), height: 180,
      legend: { show: false },
      cursor: { drag: { x: true, y: false }, points: { show: false } },
      scales: { x: { time: false }, y: logarithmic ? { distr: 3 } : { range: (_u, low, high) => padded(low, high) } },
      axes: [{ ...axis, values: (_u, ticks) => ticks.map((t) => `${t} s`), size: 28 }, { ...axis, size: 66, values: (_u, ticks) => ticks.map((t, i) => (t === null || (logarithmic && ticks.length > 12 && i % 9 !== 0) ? "" : `${digits(t)} ${unit}`)) }],
      series,
      hooks: { drawAxes: [drawBand], draw: [placeCursor] },
    }, [times, ...columns] as uPlot.AlignedData, place);
    plot.over.append(cursor);
    placeCursor();
    plot.over.addEventListener("click", () => {
      const left = plot?.cursor.left;
      if (plot && left !== undefined && left >= 0) seek(plot.posToVal(left, "x"));
    });
    tell();
  };
  const observer = new ResizeObserver(() => {
    if (plot && place.clientWidth > 0) plot.setSize({ width: place.clientWidth, height: 180 });
    else if (!plot && place.clientWidth > 0) draw();
  });
  observer.observe(place);
  return {
    element,
    set(next) { data = next; if (place.clientWidth > 0) draw(); },
    setTime(time) { now = time; placeCursor(); tell(); },
    dispose() { observer.disconnect(); plot?.destroy(); },
  };
}

/** A range with room around the values, also where they are all alike. */
function padded(low: number, high: number): [number, number] {
  const room = (high - low) * 0.06 || Math.abs(high) * 0.1 || 1;
  return [low - room, high + room];
}
