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
