import { counted } from "./format";

/** Counts in bins of equal width over [low, high] of the decimal logarithm; what is outside counts in the end bins. */
export function logHistogram(values: number[], low: number, high: number, bins: number): number[] {
  const counts = new Array<number>(bins).fill(0);
  for (const value of values) {
    if (!(value > 0)) continue;
    const place = Math.floor(((Math.log10(value) - low) / (high - low)) * bins);
    ++counts[Math.max(0, Math.min(bins - 1, place))];
  }
  return counts;
}

/** The value below which a part of the sorted values is, by the nearest rank. */
export const quantile = (sorted: number[], part: number): number =>
  sorted.length ? sorted[Math.min(sorted.length - 1, Math.max(0, Math.ceil(part * sorted.length) - 1))] : NaN;

/** Says how many findings a distribution of errors shows, and which it cannot show.
 * @param all the findings, also those that are no length
 * @param lengths the errors of those that are, as shares of the size */
export function leftOut(all: number, lengths: number[], [low, high]: [number, number]): string {
  const shares = lengths.filter((s) => s > 0);
  const beyond = shares.filter((s) => s < 10 ** low || s > 10 ** high).length;
  const without = all - lengths.length;
  const parts = [
    `${counted(shares.length, "finding")} of ${all.toLocaleString("en")} by error as a share of the size, logarithmic`,
    beyond > 0 && `${beyond.toLocaleString("en")} beyond the axis ${beyond === 1 ? "counts" : "count"} at its ends`,
    lengths.length > shares.length && `${(lengths.length - shares.length).toLocaleString("en")} without a size ${lengths.length - shares.length === 1 ? "is" : "are"} not shown`,
    without > 0 && `${without.toLocaleString("en")} that ${without === 1 ? "is no length (a hit or miss, a count, an angle, an energy) is" : "are no lengths (hits and misses, counts, angles, energies) are"} not shown`,
  ];
  return parts.filter((part) => part !== false).join("; ");
}
