import * as three from "three";
import { ConvexHull } from "three/examples/jsm/math/ConvexHull.js";
import type { Placed, Shape, Vec3 } from "../data";
import { add, dot, rotateBack, sub, times } from "../vector";

/** The part of a line that is inside a body, as an interval of its parameter; null if the line misses it. */
export type Cut = [number, number] | null;

/** Roots of a t² + 2 b t + c. */
function roots(a: number, b: number, c: number): number[] {
  if (a === 0) return b === 0 ? [] : [-c / (2 * b)];
  const d = b * b - a * c;
  if (d < 0) return [];
  const q = -(b + Math.sign(b || 1) * Math.sqrt(d));
  return q === 0 ? [0] : [q / a, c / q];
}

interface Cutter {
  /** Parameters at which the line o + t d may cross the surface. */
  crossings(o: Vec3, d: Vec3): number[];
  inside(p: Vec3): boolean;
}

const level = (o: Vec3, d: Vec3, z: number): number[] => (d[2] === 0 ? [] : [(z - o[2]) / d[2]]);
const ballRoots = (o: Vec3, d: Vec3, r: number): number[] => roots(dot(d, d), dot(o, d), dot(o, o) - r * r);
const tubeRoots = (o: Vec3, d: Vec3, r: number): number[] =>
  roots(d[0] * d[0] + d[1] * d[1], o[0] * d[0] + o[1] * d[1], o[0] * o[0] + o[1] * o[1] - r * r);

function planesOf(shape: Shape): { n: Vec3; c: number }[] {
  if (shape.type === "half_space") return [{ n: [0, 0, 1], c: 0 }];
  if (shape.type === "box") {
    return shape.half.flatMap((half, axis) => [-1, 1].map((sign) => {
      const n: Vec3 = [0, 0, 0];
      n[axis] = sign;
      return { n, c: half };
    }));
  }
  if (shape.type !== "hull") return [];
  return new ConvexHull().setFromPoints(shape.vertices.map((v) => new three.Vector3(...v))).faces
    .map((face) => ({ n: face.normal.toArray() as Vec3, c: face.constant }));
}

function cutterOf(shape: Shape): Cutter | null {
  switch (shape.type) {
    case "sphere": return { crossings: (o, d) => ballRoots(o, d, shape.radius), inside: (p) => dot(p, p) <= shape.radius ** 2 };
    case "capsule": {
      const half = shape.length / 2;
      const clampZ = (z: number): number => Math.max(-half, Math.min(half, z));
      return {
        crossings: (o, d) => [...tubeRoots(o, d, shape.radius), ...ballRoots([o[0], o[1], o[2] - half], d, shape.radius), ...ballRoots([o[0], o[1], o[2] + half], d, shape.radius)],
        inside: (p) => p[0] ** 2 + p[1] ** 2 + (p[2] - clampZ(p[2])) ** 2 <= shape.radius ** 2,
      };
    }
    case "cylinder": {
      const half = shape.length / 2;
      return {
        crossings: (o, d) => [...tubeRoots(o, d, shape.radius), ...level(o, d, half), ...level(o, d, -half)],
        inside: (p) => Math.abs(p[2]) <= half && p[0] ** 2 + p[1] ** 2 <= shape.radius ** 2,
      };
    }
    case "cone": {
      const half = shape.length / 2;
      const slope = shape.radius / shape.length;
      return {
        crossings: (o, d) => {
          const k = slope * slope;
          const up = half - o[2];
          return [...roots(d[0] ** 2 + d[1] ** 2 - k * d[2] ** 2, o[0] * d[0] + o[1] * d[1] + k * up * d[2], o[0] ** 2 + o[1] ** 2 - k * up * up), ...level(o, d, half), ...level(o, d, -half)];
        },
        inside: (p) => Math.abs(p[2]) <= half && Math.hypot(p[0], p[1]) <= slope * (half - p[2]),
      };
    }
    default: return null;
  }
}

/** Makes a function that cuts a body with lines along n through a point: `cut(u)` is the line through centre + u. The parameter is
 * relative to the centre, so that a window of any smallness keeps the digits that doubles have. */
export function makeCut({ shape, p, q }: Placed, centre: Vec3, n: Vec3): (u: Vec3) => Cut {
  const direction = rotateBack(q, n);
  const base = rotateBack(q, sub(centre, p));
  const planes = planesOf(shape);
  const cutter = cutterOf(shape);
  return (u) => {
    const o = add(base, rotateBack(q, u));
    if (!cutter) {
      let [low, high] = [-Infinity, Infinity];
      for (const { n: m, c } of planes) {
        const rate = dot(m, direction);
        const room = c - dot(m, o);
        if (rate > 0) high = Math.min(high, room / rate);
        else if (rate < 0) low = Math.max(low, room / rate);
        else if (room < 0) return null;
      }
      return low < high ? [low, high] : null;
    }
    const ts = cutter.crossings(o, direction).filter(Number.isFinite).sort((a, b) => a - b);
    let result: Cut = null;
    for (let i = 0; i + 1 < ts.length; ++i) {
      if (ts[i] < ts[i + 1] && cutter.inside(add(o, times((ts[i] + ts[i + 1]) / 2, direction)))) result = [result ? result[0] : ts[i], ts[i + 1]];
    }
    return result;
  };
}
