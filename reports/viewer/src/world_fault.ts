import { faultBands } from "./bands";
import type { Placed, Vec3, World } from "./data";
import type { Run } from "./run";
import { differsFromTruth, type Quantity } from "./series";
import { answered } from "./scene/motion_extent";
import { overlapAlong, reach } from "./scene/support";
import type { Ball } from "./scene/stage";
import { channel, sampleAt, type WorldScene } from "./scene/world_scene";
import { toScene } from "./scene/parts";
import { profileView, startingView } from "./scene/view_direction";
import { add, cross, dot, norm, sub, times } from "./vector";
import * as three from "three";

/** The parts of a world that a finding is about: the moving bodies that its proof names, the moment, and the points that it cites. `inStep` is the middle
 * of the step whose reported contacts it is about [s], null if it is not about contacts. */
export interface WorldFault { finding: number; bodies: number[]; fixed: number[]; time: number; points: Vec3[]; inStep: number | null; passes: boolean }

/** How far the middle of a step is from the moment of a finding about its contacts [steps]: a place is that at the start of the step, the others sum up to its end. */
const middleOfStep: Record<string, number | undefined> = { contact_place: 0.5, momentum_balance: -0.5, angular_momentum_balance: -0.5, cone_violation: -0.5 };

/** The oracles whose motion of a world shows no fault, the subject first. */
export function trustedOf(run: Run, world: World, question: number): number[] {
  const { subject } = run.report;
  return world.motions.map((_, o) => o).filter((o) => answered(world.motions[o]) && run.band[run.gravest(question, o)] >= faultBands.length)
    .sort((a, b) => Number(b === subject) - Number(a === subject) || a - b);
}

export function worldFault(run: Run, world: World, finding: number): WorldFault {
  const { findings: f, names } = run.report;
  const { bodies, points } = run.cited(finding);
  const named = bodies.filter((b) => world.bodies[b] !== undefined);
  const measure = names.measure[f.measure[finding]]?.name ?? "";
  const time = f.time?.[finding] ?? -1;
  const middle = middleOfStep[measure];
  return {
    finding, passes: measure === "passage", bodies: named.filter((b) => !world.bodies[b].fixed), fixed: named.filter((b) => world.bodies[b].fixed),
    time, points, inStep: middle === undefined || time < 0 ? null : time + middle * world.dt,
  };
}

/** The quantities of the two plots that show a fault: the curve of its law, or the coordinate along which its body moves, and how far that body is from
 * that of the solid oracle; the spin and the energy of a body that turns in place. Indices into `menu`, −1 for none. */
export function plotsOf(run: Run, world: World, menu: Quantity[], fault: WorldFault, oracle: number): [number, number] {
  const { findings: f, names } = run.report;
  const measure = names.measure[f.measure[fault.finding]]?.name ?? "";
  const moving = world.bodies.map((_, b) => b).filter((b) => !world.bodies[b].fixed);
  const body = fault.bodies[0] ?? (moving.length === 1 ? moving[0] : -1);
  const about = (q: Quantity): boolean => q.body === undefined || fault.bodies.length === 0 || fault.bodies.includes(q.body);
  const first = measure.split("_")[0];
  const ofCurve = (pick: (q: Quantity) => boolean): number => menu.findIndex((q) => q.curve !== undefined && about(q) && pick(q));
  const ofKey = (key: string): number => menu.findIndex((q) => q.key === key || q.also === key);
  // A finding may have two curves. The error shows more than the motion, which is far larger.
  const shows = (q: Quantity): boolean => q.curve?.finding === fault.finding || (q.curve?.shows?.includes(fault.finding) ?? false);
  const candidates = [
    menu.findIndex((q) => shows(q) && about(q) && !differsFromTruth(run, q)),
    menu.findIndex((q) => shows(q) && about(q)),
    ofCurve((q) => q.body === body && q.curve!.breaks?.[oracle] !== undefined && q.curve!.breaks[oracle] !== null),
    ofCurve((q) => q.curve!.quantity.includes(first) && measure !== "passage"),
    ofKey(`${mostMoved(run, world, body, oracle, fault.time)}${body}`),
  ];
  const one = candidates.find((i) => i >= 0) ?? -1;
  return [one, menu.findIndex((q) => (menu[one]?.key === `spin${body}` ? q.curve?.quantity === "energy" : q.key === `apart${body}`))];
}

/** Whether a body turns by over a radian while its centre stays within a hundredth of its extent. */
function turnsInPlace(world: World, body: number, c: Float64Array[]): boolean {
  const spins = c[channel.wx].map((w, i) => Math.hypot(w, c[channel.wy][i], c[channel.wz][i]));
  const ways = c[channel.x].map((x, i) => Math.hypot(x - c[channel.x][0], c[channel.y][i] - c[channel.y][0], c[channel.z][i] - c[channel.z][0]));
  const time = (world.times.at(-1) ?? 0) - (world.times[0] ?? 0);
  return Math.max(...spins) * time > 1 && Math.max(...ways) < 0.01 * reach(world.bodies[body].shape);
}

/** The coordinate along which a body moves fastest at a time; its spin if it turns in place. */
function mostMoved(run: Run, world: World, body: number, oracle: number, time: number): string {
  const track = world.motions[oracle]?.bodies[body];
  if (!track) return "z";
  const c = run.channels(track);
  const at = Math.min(sampleAt(world.times, time).sample, c[0].length - 1);
  const speeds = [channel.vx, channel.vy, channel.vz].map((k) => Math.abs(c[k][at]));
  if (turnsInPlace(world, body, c)) return "spin";
  return "xyz"[speeds.indexOf(Math.max(...speeds))] ?? "z";
}

/** A part of a scene: a ball, in units of the scene, and the direction to look from where one shows more than others. */
export interface Region { centre: three.Vector3; radius: number; from: Vec3 | null }

/** Bodies are seen together up to so many times their radius apart. */
const nearBy = 8;

/** A body that is so many times larger than the smallest is not fitted: the part of it that is near is in sight. */
const muchLarger = 4;

/** The region around what a fault is about: its bodies, as `oracles` have them at `moments`, and the points that its proof cites. Oracles that have a body
 * far from where the first one has it are left out. Null if it names nothing, or if the view of everything is no larger. Leaves the scene at the last of
 * the moments. */
export function regionOf(run: Run, view: WorldScene, world: World, fault: WorldFault, oracles: number[], moments: number[]): Region | null {
  const sizeOf = (b: number): number => reach(world.bodies[b].shape) * view.frame.scale;
  const named = fault.bodies.slice(0, 4);
  const sizes = named.map(sizeOf).filter((r) => r > 0);
  const smallest = sizes.length ? Math.min(...sizes) : 0;
  const fitted = [...named, ...fault.fixed.filter((b) => sizeOf(b) > 0)].filter((b) => sizeOf(b) < muchLarger * smallest);
  const around: { at: three.Vector3; radius: number }[] = fault.points.slice(0, 2).map((p) => ({ at: toScene(view.frame, p), radius: 0 }));
  const [oracle] = oracles;
  for (const time of moments) {
    view.setTime(time);
    for (const b of fitted) {
      const own = view.bodyAt(oracle, b);
      around.push({ at: own, radius: sizeOf(b) });
      for (const other of oracles.slice(1)) {
        const at = view.bodyAt(other, b);
        if (at.distanceTo(own) < nearBy * sizeOf(b)) around.push({ at, radius: sizeOf(b) });
      }
    }
  }
  if (around.length === 0) return null;
  const box = new three.Box3();
  for (const { at, radius } of around) box.expandByPoint(at.clone().subScalar(radius)).expandByPoint(at.clone().addScalar(radius));
  const centre = box.getCenter(new three.Vector3());
  // Beside a larger body there is room for a part of it.
  const room = sizes.some((r) => r >= muchLarger * smallest) ? 3 : 1.8;
  const radius = Math.max(1.3 * Math.max(...around.map((a) => a.at.distanceTo(centre) + a.radius)), room * smallest, 1e-3);
  if (radius >= view.radius && centre.length() + radius <= 1.5 * view.radius) return null;
  return { centre, radius, from: fault.passes ? acrossMotion(run, view, world, fault, oracle) : null };
}

/** Bodies are followed one at a time if the region of all is so many times larger than the smallest. */
const farApart = 25;

/** A body that is so many times smaller than the view is a speck, of less than four pixels. */
const speck = 60;

/** The region around the bodies that move, where `oracle` has them at the time that is shown, and the body that it follows: one of them if all together
 * would be specks, else none, −1. Null without such bodies. */
export function movingRegion(view: WorldScene, world: World, oracle: number, about: number[]): { centre: three.Vector3; radius: number; follows: number } | null {
  const moving = world.bodies.map((_, b) => b).filter((b) => !world.bodies[b].fixed);
  if (moving.length === 0) return null;
  const sizeOf = (b: number): number => Math.max(reach(world.bodies[b].shape) * view.frame.scale, 1e-6);
  const box = new three.Box3();
  for (const b of moving) box.expandByPoint(view.bodyAt(oracle, b).subScalar(sizeOf(b))).expandByPoint(view.bodyAt(oracle, b).addScalar(sizeOf(b)));
  const centre = box.getCenter(new three.Vector3());
  const radius = 1.1 * Math.max(...moving.map((b) => view.bodyAt(oracle, b).distanceTo(centre) + sizeOf(b)));
  if (radius < farApart * Math.min(...moving.map(sizeOf))) return { centre, radius: Math.max(radius, 2.5 * Math.min(...moving.map(sizeOf))), follows: -1 };
  const one = moving.find((b) => about.includes(b)) ?? moving[0];
  return { centre: view.bodyAt(oracle, one), radius: 6 * sizeOf(one), follows: one };
}

/** Whether the view of everything shows one of some moving bodies as a speck; of all bodies if none is named. */
export const isWide = (view: WorldScene, world: World, about: number[] = []): boolean =>
  world.bodies.some((body, b) => !body.fixed && (about.length === 0 || about.includes(b)) && reach(body.shape) > 0 && reach(body.shape) * view.frame.scale * speck < view.radius);

/** How a body that passes through another is shown: from before they meet until it is behind, from the side, with room for where the trusted oracle has it. */
export interface PassageView { from: number; until: number; mover: number; balls: Ball[]; direction: Vec3 }

/** Samples in which a body passes through another, at most. */
const longestPassage = 24;

/** The view of a passage, as `oracle` has it and `trusted` has not; null if the proof does not name two bodies. */
export function passageOf(run: Run, view: WorldScene, world: World, fault: WorldFault, oracle: number, trusted: number): PassageView | null {
  const named = [...fault.bodies, ...fault.fixed];
  if (!fault.passes || fault.time < 0 || named.length < 2 || fault.bodies.length === 0) return null;
  const placeOf = (o: number, b: number, sample: number): Placed | null => {
    const { shape, fixed, start } = world.bodies[b];
    const track = world.motions[o]?.bodies[b];
    if (fixed || !track) return fixed ? { shape, ...start } : null;
    const c = run.channels(track);
    if (sample >= c[0].length) return null;
    const of = (k: number): number => c[k][sample];
    return { shape, p: [of(channel.x), of(channel.y), of(channel.z)], q: [of(channel.qw), of(channel.qx), of(channel.qy), of(channel.qz)] };
  };
  const last = sampleAt(world.times, fault.time + 1e-3 * world.dt).sample;
  const wayOf = (b: number): number => {
    const [was, is] = [placeOf(oracle, b, Math.max(0, last - 1)), placeOf(oracle, b, last)];
    return was && is ? norm(sub(is.p, was.p)) : 0;
  };
  const mover = fault.bodies.reduce((best, b) => (wayOf(b) > wayOf(best) ? b : best));
  const other = named.find((b) => b !== mover)!;
  const [A, B] = [placeOf(oracle, mover, last), placeOf(oracle, other, last)];
  const [wasA, wasB] = [placeOf(oracle, mover, Math.max(0, last - 1)), placeOf(oracle, other, Math.max(0, last - 1))];
  if (!A || !B || !wasA || !wasB) return null;
  const way = sub(sub(A.p, B.p), sub(wasA.p, wasB.p));
  const along = norm(way) > 1e-3 * reach(A.shape) ? times(1 / norm(way), way) : null;
  // A body is before the other while there is a gap along its way; a rod that sweeps through has no such way.
  const isBefore = (k: number): boolean => {
    const [a, b] = [placeOf(oracle, mover, k), placeOf(oracle, other, k)];
    return along !== null && a !== null && b !== null && overlapAlong(a, b, along) < 0;
  };
  let first = last - 1;
  while (first > Math.max(0, last - longestPassage) && !isBefore(first)) --first;
  if (!isBefore(first)) first = Math.max(0, last - 2);
  const start = placeOf(oracle, mover, first);
  if (!start) return null;
  const sizeOf = (b: number): number => reach(world.bodies[b].shape);
  const middle = times(0.5, add(start.p, A.p));
  const near = 2 * (norm(sub(A.p, start.p)) + sizeOf(mover));
  const balls: Ball[] = [];
  const hold = (p: Vec3, radius: number): void => { balls.push({ at: toScene(view.frame, p), radius: radius * view.frame.scale }); };
  for (const o of [oracle, trusted]) for (let k = first; k <= last; ++k) for (const b of [mover, other]) {
    const at = world.bodies[b].fixed ? null : placeOf(o, b, k);
    if (at && norm(sub(at.p, middle)) < near) hold(at.p, Math.min(sizeOf(b), near));
  }
  // The part of the other body where it is met; all of a larger one would make the mover small.
  const room = Math.min(sizeOf(other) || Infinity, Math.max(3 * sizeOf(mover), 0.3 * norm(sub(A.p, start.p))));
  const share = along ? Math.max(0, Math.min(1, dot(sub(B.p, start.p), along) / Math.max(dot(sub(A.p, start.p), along), 1e-12))) : 0.5;
  hold(add(start.p, times(share, sub(A.p, start.p))), room);
  const aside = along ? cross(along, view.up) : null;
  // The camera is a little above, so that the bodies look solid. The way leads from left to right.
  const direction = aside && norm(aside) > 0.1 ? add(times(1 / norm(aside), aside), times(0.12, view.up)) : along ? profileView(along, null, view.up) : acrossMotion(run, view, world, fault, oracle);
  return direction && { from: world.times[first], until: world.times[last], mover, balls, direction };
}

/** The direction from which the motion of the fastest body of a fault is seen in the plane of the screen: across its way, or along the axis it turns about. */
export function acrossMotion(run: Run, view: WorldScene, world: World, fault: WorldFault, oracle: number): Vec3 | null {
  let best: { speed: number; from: Vec3 } | null = null;
  for (const b of fault.bodies) {
    const track = world.motions[oracle]?.bodies[b];
    if (!track) continue;
    const c = run.channels(track);
    // Before the moment: what it strikes may have changed its way.
    const at = Math.max(0, Math.min(sampleAt(world.times, fault.time).sample - 1, c[0].length - 1));
    const v: Vec3 = [c[channel.vx][at], c[channel.vy][at], c[channel.vz][at]];
    const w: Vec3 = [c[channel.wx][at], c[channel.wy][at], c[channel.wz][at]];
    const [speed, rim] = [norm(v), norm(w) * reach(world.bodies[b].shape)];
    if (Math.max(speed, rim) > (best?.speed ?? 0)) best = { speed: Math.max(speed, rim), from: rim > speed ? w : profileView(v, null, view.up) };
  }
  if (best && dot(best.from, startingView(view.up)) < 0) best.from = times(-1, best.from);
  return best?.from ?? null;
}
