import * as three from "three";
import type { Run } from "../run";
import type { Motion, Vec3, World } from "../data";
import { reach } from "./support";

/** Where the bodies of a world are over its motion. */
export interface MotionExtent {
  /** Bounds of all that moves, and of what is fixed beside it [m]. */
  box: three.Box3;
  /** Balls that hold every body at samples of its motion [m]. */
  balls: { at: Vec3; radius: number }[];
  /** The oracles whose motion leaves these bounds, and when a body of theirs does [s]. */
  left: Map<number, number>;
}

/** A motion counts unless it makes the bounds so many times larger than the one that is trusted: the others would be specks. */
const mostGrowth = 2.5;

/** Samples of a body that are looked at. */
const mostSamples = 80;

export const answered = (motion: Motion | undefined): boolean => motion !== undefined && (motion.bodies.some((b) => b !== null) || motion.points !== undefined);

const sizeOf = (box: three.Box3): number => (box.isEmpty() ? 0 : box.getSize(new three.Vector3()).length());

const grow = (box: three.Box3, [x, y, z]: Vec3, r: number): void => {
  box.expandByPoint(new three.Vector3(x - r, y - r, z - r)).expandByPoint(new three.Vector3(x + r, y + r, z + r));
};

interface Path { radius: number; at(sample: number): Vec3; samples: number }

/** The paths of the bodies, particles and nodes of one motion. */
function pathsOf(run: Run, world: World, motion: Motion): Path[] {
  const paths = motion.bodies.flatMap((track, b): Path[] => {
    if (!track || world.bodies[b]?.fixed) return [];
    const c = run.channels(track);
    return [{ radius: reach(world.bodies[b].shape), samples: c[0].length, at: (i) => [c[0][i], c[1][i], c[2][i]] }];
  });
  if (!motion.points) return paths;
  const c = run.channels(motion.points);
  for (let k = 0; k + 2 < c.length; k += 3) paths.push({ radius: world.particles[k / 3]?.radius ?? 0, samples: c[k].length, at: (i) => [c[k][i], c[k + 1][i], c[k + 2][i]] });
  return paths;
}

/** The extent of the motions of a world.
 * @param trusted oracles whose motion is right, the most trusted first; without any the middle one by size decides */
export function motionExtent(run: Run, world: World, trusted: number[]): MotionExtent {
  const balls: MotionExtent["balls"] = [];
  const start = new three.Box3();
  for (const body of world.bodies) if (!body.fixed) grow(start, body.start.p, reach(body.shape));
  const own = world.motions.map((motion, oracle) => {
    const box = start.clone();
    const paths = answered(motion) ? pathsOf(run, world, motion) : [];
    for (const { radius, samples, at } of paths) for (let i = 0; i < samples; ++i) grow(box, at(i), radius);
    return { oracle, paths, box };
  }).filter(({ paths }) => paths.length > 0);
  const bySize = [...own].sort((a, b) => sizeOf(a.box) - sizeOf(b.box));
  const base = own.find(({ oracle }) => oracle === trusted.find((o) => own.some((m) => m.oracle === o))) ?? bySize[Math.floor((bySize.length - 1) / 2)];
  const box = base ? base.box.clone() : start.clone();
  const limit = mostGrowth * sizeOf(box);
  const left = new Map<number, number>();
  const kept = bySize.filter((motion) => {
    const both = box.clone().union(motion.box);
    if (!(sizeOf(both) <= limit)) return false;
    box.copy(both);
    return true;
  });
  // A fixed body is shown whole if it is no larger than the motion.
  const isSmallBeside = limit / mostGrowth;
  for (const body of world.bodies) {
    const radius = reach(body.shape);
    if (!body.fixed || radius === 0) continue;
    const whole = box.clone();
    grow(whole, body.start.p, radius);
    if (!(sizeOf(whole) <= 1.6 * isSmallBeside) && !box.isEmpty()) continue;
    box.copy(whole);
    balls.push({ at: body.start.p, radius });
  }
  for (const body of world.bodies) if (!body.fixed) balls.push({ at: body.start.p, radius: reach(body.shape) });
  for (const { paths } of kept) for (const { radius, samples, at } of paths) {
    const step = Math.max(1, Math.floor(samples / mostSamples));
    for (let i = 0; i < samples; i += step) balls.push({ at: at(i), radius });
    if (samples > 0) balls.push({ at: at(samples - 1), radius });
  }
  if (box.isEmpty()) for (const body of world.bodies) { const radius = Math.max(reach(body.shape), 0.5); grow(box, body.start.p, radius); balls.push({ at: body.start.p, radius }); }
  if (box.isEmpty()) { grow(box, [0, 0, 0], 1); balls.push({ at: [0, 0, 0], radius: 1 }); }
  for (const { oracle, paths } of own) {
    if (kept.some((motion) => motion.oracle === oracle)) continue;
    const first = Math.min(...paths.map(({ samples, at }) => { for (let i = 0; i < samples; ++i) if (!box.containsPoint(new three.Vector3(...at(i)))) return i; return Infinity; }));
    left.set(oracle, world.times[first] ?? world.times.at(-1) ?? 0);
  }
  return { box, balls, left };
}
