import type { Report } from "./data";
import { digits } from "./format";

/** A question that an oracle was asked, and the time that this took [s]. */
export interface Cell { question: number; oracle: number; seconds: number }

export type CellOrder = "seconds" | "question" | "oracle";

const units: [number, string][] = [[1, "s"], [1e-3, "ms"], [1e-6, "µs"]];

/** Writes a time with the unit that suits it: "12.3 s", "4.56 ms", "0.12 µs". */
export function duration(seconds: number): string {
  const [size, unit] = units.find(([size]) => seconds >= 0.9995 * size) ?? units[seconds > 0 ? 2 : 0];
  return `${digits(seconds / size)} ${unit}`;
}

/** The cells that were asked, of one oracle or of all (""), in an order: by time the longest first, by name the longest of a name first. */
export function cellsOf({ seconds = [], questions, oracles }: Report, oracle = "", order: CellOrder = "seconds", reversed = false): Cell[] {
  const cells = seconds.flatMap((row, question) => row.flatMap((time, o) => (time === null || (oracle !== "" && oracles[o].name !== oracle) ? [] : [{ question, oracle: o, seconds: time }])));
  const nameOf = (c: Cell): string => (order === "question" ? questions[c.question].id : order === "oracle" ? oracles[c.oracle].name : "");
  const compare = (a: Cell, b: Cell): number => { const [x, y] = [nameOf(a), nameOf(b)]; return x === y ? 0 : x < y ? -1 : 1; };
  cells.sort((a, b) => (reversed ? -1 : 1) * (order === "seconds" ? b.seconds - a.seconds : compare(a, b)) || b.seconds - a.seconds);
  return cells;
}

/** The sums by oracle, the largest first. */
export function sumsByOracle(cells: Cell[]): { oracle: number; seconds: number }[] {
  const sums = new Map<number, number>();
  for (const { oracle, seconds } of cells) sums.set(oracle, (sums.get(oracle) ?? 0) + seconds);
  return [...sums].map(([oracle, seconds]) => ({ oracle, seconds })).sort((a, b) => b.seconds - a.seconds);
}
