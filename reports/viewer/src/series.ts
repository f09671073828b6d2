import type { Curve, Track, World } from "./data";
import type { Line, PlotData } from "./plots";
import type { Run } from "./run";
import { reach } from "./scene/support";
import { channel } from "./scene/world_scene";

/** A quantity of a world that can be plotted: a curve of the data, or a property of a body. */
export interface Quantity {
  key: string; name: string; body?: number; curve?: Curve; unit: string;
  /** The key of the property of a body that the curve is. */
  also?: string;
}

const bodyQuantities: { key: string; name: string; unit: string; channels: number[]; of(c: Float64Array[], i: number): number }[] = [
  { key: "x", name: "x", unit: "m", channels: [channel.x], of: (c, i) => c[channel.x][i] },
  { key: "y", name: "y", unit: "m", channels: [channel.y], of: (c, i) => c[channel.y][i] },
  { key: "z", name: "z", unit: "m", channels: [channel.z], of: (c, i) => c[channel.z][i] },
  { key: "speed", name: "speed", unit: "m/s", channels: [channel.vx, channel.vy, channel.vz], of: (c, i) => Math.hypot(c[channel.vx][i], c[channel.vy][i], c[channel.vz][i]) },
  { key: "vx", name: "velocity x", unit: "m/s", channels: [channel.vx], of: (c, i) => c[channel.vx][i] },
  { key: "vy", name: "velocity y", unit: "m/s", channels: [channel.vy], of: (c, i) => c[channel.vy][i] },
  { key: "vz", name: "velocity z", unit: "m/s", channels: [channel.vz], of: (c, i) => c[channel.vz][i] },
  { key: "spin", name: "spin", unit: "rad/s", channels: [channel.wx, channel.wy, channel.wz], of: (c, i) => Math.hypot(c[channel.wx][i], c[channel.wy][i], c[channel.wz][i]) },
];
const apartKey = "apart";
const turnedKey = "turned";

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
    { key: `${turnedKey}${b}`, name: `angle of ${body.name} to ${solidName}'s`, unit: "rad", body: b },
  ]).filter((item) => {
    const same = curves.find((curve) => curve.name === item.name);
    if (same) same.also = item.key;
    return same === undefined;
  });
  return [...curves.sort((a, b) => shown(a) - shown(b)), ...bodies];
}

function padded(values: ArrayLike<number>, count: number): (number | null)[] {
  return Array.from({ length: count }, (_, i) => (i < values.length && Number.isFinite(values[i]) ? values[i] : null));
}

const noTruth = "Not a difference: no formula of this quantity is known.";

/** Whether a quantity has a truth that differs from it: an error is a difference itself. */
export function differsFromTruth(run: Run, { curve }: Quantity): boolean {
  return curve?.truth !== undefined && run.channels(curve.truth)[0].some((value) => value !== 0);
}

/** The largest absolute value of the lines of a quantity of some oracles. */
export function largestOf(run: Run, world: World, quantity: Quantity, oracles: number[]): number {
  return plotData(run, world, quantity, oracles, -1, false, false).lines.reduce((most, { values }) => values.reduce((m: number, v) => Math.max(m, Math.abs(v ?? 0)), most), 0);
}

/** The angle between two rotations, whose quaternions may have either sign [rad]. */
export function angleBetween(a: Float64Array[], b: Float64Array[], i: number): number {
  const half = Math.abs(a[channel.qw][i] * b[channel.qw][i] + a[channel.qx][i] * b[channel.qx][i] + a[channel.qy][i] * b[channel.qy][i] + a[channel.qz][i] * b[channel.qz][i]);
  // The data round rotations to 1e-4: angles below 1.6 degrees are not told from none.
  return half > 0.9999 ? 0 : 2 * Math.acos(half);
}

const distanceBetween = (a: Float64Array[], b: Float64Array[], i: number): number => Math.hypot(a[0][i] - b[0][i], a[1][i] - b[1][i], a[2][i] - b[2][i]);

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
      step: Math.max(0, ...shown.map((o) => curve.motions[o]?.scale[0] ?? 0)),
      truth: truth ? { values: toTruth ? zero! : truth, tolerance: curve.tolerance ?? 0 } : undefined,
      bound: truth ? ((toTruth || !differsFromTruth(run, quantity)) && logarithmic ? curve.tolerance : undefined) : curve.tolerance,
      note: difference && !truth ? noTruth : undefined,
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
      const between = quantity.key === `${turnedKey}${body}` ? angleBetween : distanceBetween;
      put(o, padded(Array.from({ length: Math.min(r[0].length, c[0].length) }, (_, i) => between(c, r, i)), count));
    }
  }
  const channels = kind ? kind.channels : quantity.unit === "rad" ? [channel.qw] : [0, 1, 2];
  const steps = shown.map((o) => Math.max(0, ...channels.map((k) => trackOf(o)?.scale[k] ?? 0)));
  return { times: world.times, unit: quantity.unit, lines, logarithmic, step: (kind ? 1 : 2) * Math.max(0, ...steps), note: difference ? noTruth : undefined };
}

/** Where a body of an oracle first is elsewhere than that of another: how far [m] and turned by how much [rad]; the radius of the body, 0 for a ball [m]. */
export interface Difference { sample: number; body: number; oracle: number; distance: number; angle: number; radius: number }

/** The first sample at which a body of one of the oracles is farther from the reference's than `size`: by distance + angle × radius, for all but balls,
 * whose spin nobody sees. Angles below 1.6 degrees are not counted: the data round rotations to 1e-4. */
export function firstDifference(run: Run, world: World, reference: number, oracles: number[], size: number): Difference | null {
  let best: Difference | null = null;
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
        const [distance, angle] = [distanceBetween(c, r, i), radius > 0 ? angleBetween(c, r, i) : 0];
        if (distance + radius * angle > size) { best = { sample: i, body, oracle, distance, angle, radius }; break; }
      }
    }
  });
  return best;
}
