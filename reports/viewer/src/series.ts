import type { Curve, Track, World } from "./data";
import type { Line, PlotData } from "./plots";
import type { Run } from "./run";
import { reach } from "./scene/support";
import { channel } from "./scene/world_scene";

/** A quantity of a world that can be plotted: a curve of the data, or a property of a body. */
export interface Quantity { key: string; name: string; body?: number; curve?: Curve; unit: string }

const bodyQuantities: { key: string; name: string; unit: string; of(c: Float64Array[], i: number): number }[] = [
  { key: "x", name: "x", unit: "m", of: (c, i) => c[channel.x][i] },
  { key: "y", name: "y", unit: "m", of: (c, i) => c[channel.y][i] },
  { key: "z", name: "z", unit: "m", of: (c, i) => c[channel.z][i] },
  { key: "speed", name: "speed", unit: "m/s", of: (c, i) => Math.hypot(c[channel.vx][i], c[channel.vy][i], c[channel.vz][i]) },
  { key: "vx", name: "velocity x", unit: "m/s", of: (c, i) => c[channel.vx][i] },
  { key: "vy", name: "velocity y", unit: "m/s", of: (c, i) => c[channel.vy][i] },
  { key: "vz", name: "velocity z", unit: "m/s", of: (c, i) => c[channel.vz][i] },
  { key: "spin", name: "spin", unit: "rad/s", of: (c, i) => Math.hypot(c[channel.wx][i], c[channel.wy][i], c[channel.wz][i]) },
];
const apartKey = "apart";

/** The quantities of the menu. Those that show a fault come first. */
export function quantitiesOf(world: World, solidName: string): Quantity[] {
  const curves = world.curves.map((curve, i): Quantity => ({
    key: `curve${i}`, unit: curve.unit, curve, body: curve.body,
    name: curve.body === undefined ? curve.quantity : `${curve.quantity} of ${world.bodies[curve.body]?.name ?? curve.body}`,
  }));
  const shown = (q: Quantity): number => (q.curve?.breaks?.some((b) => b !== null) ? 0 : 1);
  const bodies = world.bodies.flatMap((body, b): Quantity[] => body.fixed ? [] : [
    ...bodyQuantities.map(({ key, name, unit }) => ({ key: `${key}${b}`, name: `${name} of ${body.name}`, unit, body: b })),
    { key: `${apartKey}${b}`, name: `distance of ${body.name} to ${solidName}'s`, unit: "m", body: b },
  ]);
  return [...curves.sort((a, b) => shown(a) - shown(b)), ...bodies];
}

function padded(values: ArrayLike<number>, count: number): (number | null)[] {
  return Array.from({ length: count }, (_, i) => (i < values.length && Number.isFinite(values[i]) ? values[i] : null));
}

/** The lines of a quantity, one for each oracle of `shown`. */
export function plotData(run: Run, world: World, quantity: Quantity, shown: number[], solid: number, logarithmic: boolean, difference: boolean): PlotData {
  const count = world.times.length;
  const lines: Line[] = [];
  const { curve } = quantity;
  const put = (o: number, values: (number | null)[]): void => { lines.push({ name: run.report.oracles[o].name, look: run.looks[o], values, solid: o === solid }); };
  if (curve) {
    const truth = curve.truth ? padded(run.channels(curve.truth)[0], count) : null;
    const toTruth = difference && truth !== null;
    for (const o of shown) {
      const track = curve.motions[o];
      if (!track) continue;
      const values = padded(run.channels(track)[0], count);
      put(o, toTruth ? values.map((v, i) => (v === null || truth[i] === null ? null : v - truth[i])) : values);
    }
    const zero = truth?.map(() => 0);
    return {
      times: world.times, unit: quantity.unit, lines, logarithmic,
      truth: truth ? { values: toTruth ? zero! : truth, tolerance: curve.tolerance ?? 0 } : undefined,
      bound: truth ? (toTruth && logarithmic ? curve.tolerance : undefined) : curve.tolerance,
    };
  }
  const body = quantity.body!;
  const trackOf = (o: number): Track | null => world.motions[o]?.bodies[body] ?? null;
  const kind = bodyQuantities.find(({ key }) => quantity.key === `${key}${body}`);
  const reference = trackOf(solid);
  for (const o of shown) {
    const track = trackOf(o);
    if (!track) continue;
    const c = run.channels(track);
    if (kind) put(o, padded(Array.from(c[0], (_, i) => kind.of(c, i)), count));
    else if (reference && o !== solid) {
      const r = run.channels(reference);
      put(o, padded(Array.from({ length: Math.min(r[0].length, c[0].length) }, (_, i) => Math.hypot(c[0][i] - r[0][i], c[1][i] - r[1][i], c[2][i] - r[2][i])), count));
    }
  }
  return { times: world.times, unit: quantity.unit, lines, logarithmic };
}

/** The first sample at which a body of one of the oracles is farther from the reference's than `size`: by distance + angle × radius, for all but balls,
 * whose spin nobody sees. Angles below 1.6 degrees are not counted: the data round rotations to 1e-4. */
export function firstDifference(run: Run, world: World, reference: number, oracles: number[], size: number): { sample: number; body: number; oracle: number } | null {
  let best: { sample: number; body: number; oracle: number } | null = null;
  world.bodies.forEach((_, body) => {
    const a = world.motions[reference]?.bodies[body];
    if (!a) return;
    const r = run.channels(a);
    const radius = world.bodies[body].shape.type === "sphere" ? 0 : reach(world.bodies[body].shape);
    for (const oracle of oracles) {
      const b = oracle === reference ? null : world.motions[oracle]?.bodies[body];
      if (!b) continue;
      const c = run.channels(b);
      const end = Math.min(r[0].length, c[0].length, best ? best.sample : Infinity);
      for (let i = 0; i < end; ++i) {
        // The cosine of half the angle between two rotations, whose quaternions may have either sign.
        const half = Math.abs(c[channel.qw][i] * r[channel.qw][i] + c[channel.qx][i] * r[channel.qx][i] + c[channel.qy][i] * r[channel.qy][i] + c[channel.qz][i] * r[channel.qz][i]);
        const angle = half > 0.9999 ? 0 : 2 * Math.acos(half);
        if (Math.hypot(c[0][i] - r[0][i], c[1][i] - r[1][i], c[2][i] - r[2][i]) + radius * angle > size) { best = { sample: i, body, oracle }; break; }
      }
    }
  });
  return best;
}
