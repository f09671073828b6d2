import * as three from "three";
import type { Vec3, World } from "../data";
import { add, cross, dot, rotate, sub, times, across } from "../vector";
import { toScene, type Frame } from "./parts";
import { reach } from "./support";

/** The upper side of a fixed body on which others can lie: a half-space, or a face of a box. */
interface Ground { p: Vec3; n: Vec3; isIn(q: Vec3): boolean }

/** Steeper sides are walls: 60 degrees. */
const leastRise = 0.5;

function groundsOf(world: World, up: Vec3): Ground[] {
  return world.bodies.flatMap(({ shape, fixed, start }): Ground[] => {
    if (!fixed) return [];
    if (shape.type === "half_space") {
      const n = rotate(start.q, [0, 0, 1]);
      return dot(n, up) > leastRise ? [{ p: start.p, n, isIn: () => true }] : [];
    }
    if (shape.type !== "box") return [];
    const axes = [0, 1, 2].map((k) => rotate(start.q, [k === 0 ? 1 : 0, k === 1 ? 1 : 0, k === 2 ? 1 : 0]));
    const rises = axes.map((axis) => Math.abs(dot(axis, up)));
    const k = rises.indexOf(Math.max(...rises));
    const n = times(dot(axes[k], up) < 0 ? -1 : 1, axes[k]);
    if (dot(n, up) <= leastRise) return [];
    return [{ p: add(start.p, times(shape.half[k], n)), n, isIn: (q) => axes.every((axis, i) => i === k || Math.abs(dot(axis, sub(q, start.p))) <= shape.half[i]) }];
  });
}

/** Bodies that have a line to the ground, at most. */
const mostLines = 64;

/** A body is in the air if its centre is so many times its radius above the ground: it cannot touch it. */
const inTheAir = 1.05;

/** Lines from bodies in the air straight down to the ground below, with a cross where they end: without them a height cannot be seen. */
export interface DropLines { lines: three.LineSegments; set(places: (Vec3 | null)[]): void }

export function makeDropLines(world: World, frame: Frame, up: Vec3, colour: string): DropLines {
  const grounds = groundsOf(world, up);
  const lines = new three.LineSegments(new three.BufferGeometry(), new three.LineBasicMaterial({ color: colour, transparent: true, opacity: 0.75 }));
  lines.frustumCulled = false;
  const sides = [across(up), cross(up, across(up))];
  return {
    lines,
    set(places) {
      const points: three.Vector3[] = [];
      places.forEach((place, b) => {
        const radius = reach(world.bodies[b].shape);
        if (!place || points.length >= 6 * mostLines) return;
        let best: Vec3 | null = null;
        let least = Infinity;
        for (const { p, n, isIn } of grounds) {
          const height = dot(n, sub(place, p)) / dot(n, up);
          const foot = sub(place, times(height, up));
          if (height > 0 && height < least && isIn(foot)) { least = height; best = foot; }
        }
        if (!best || least <= inTheAir * radius) return;
        points.push(toScene(frame, place), toScene(frame, best));
        for (const side of sides) for (const sign of [-1, 1]) points.push(toScene(frame, add(best, times(sign * 0.5 * radius, side))));
      });
      lines.geometry.dispose();
      lines.geometry = new three.BufferGeometry().setFromPoints(points);
      lines.visible = points.length > 0;
    },
  };
}

/** Squares of a view, about as many as this across it. */
const squares = 6;

/** A grid on the half-spaces of a world, as fine as a close view needs; null without one. */
export function groundGrid(world: World, frame: Frame, centre: three.Vector3, radius: number, colour: string): three.LineSegments | null {
  const wanted = (2 * radius) / frame.scale / squares;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const spacing = power * ([5, 2, 1].find((m) => m * power <= wanted) ?? 1);
  const points: three.Vector3[] = [];
  for (const { shape, fixed, start } of world.bodies) {
    if (!fixed || shape.type !== "half_space") continue;
    const n = rotate(start.q, [0, 0, 1]);
    const [u, v] = [rotate(start.q, [1, 0, 0]), rotate(start.q, [0, 1, 0])];
    const at: Vec3 = [frame.centre[0] + centre.x / frame.scale, frame.centre[1] + centre.y / frame.scale, frame.centre[2] + centre.z / frame.scale];
    const foot = sub(at, times(dot(n, sub(at, start.p)), n));
    // Lines at whole multiples of the spacing, so that they stay where they are when the view changes.
    const whole = (axis: Vec3): number => Math.round(dot(axis, sub(foot, start.p)) / spacing);
    const place = (i: number, k: number): three.Vector3 => toScene(frame, add(start.p, add(times(i * spacing, u), times(k * spacing, v))));
    const [i0, k0] = [whole(u), whole(v)];
    const far = 4 * squares;
    for (let i = -far; i <= far; ++i) points.push(place(i0 + i, k0 - far), place(i0 + i, k0 + far), place(i0 - far, k0 + i), place(i0 + far, k0 + i));
  }
  if (points.length === 0) return null;
  const grid = new three.LineSegments(new three.BufferGeometry().setFromPoints(points), new three.LineBasicMaterial({ color: colour, transparent: true, opacity: 0.35 }));
  grid.frustumCulled = false;
  return grid;
}
