/** Playback rates that the reader can choose, and their names. */
export const rates: { rate: number; name: string }[] = [
  ...[100, 50, 20, 10, 5, 2].map((n) => ({ rate: 1 / n, name: `1/${n}` })), ...[1, 2, 4].map((rate) => ({ rate, name: String(rate) })),
];

/** How long a short motion plays at first [s]. */
const firstSight = 4;

/** The rate at which a motion is played at first: that of life, or slower for one that would be over before it is seen.
 * @param duration how long the motion lasts [s] */
export function startingRate(duration: number): number {
  const wanted = Math.min(1, duration / firstSight);
  const far = (rate: number): number => Math.abs(Math.log(rate / wanted));
  return rates.reduce((best, { rate }) => (far(rate) < far(best) ? rate : best), 1);
}
