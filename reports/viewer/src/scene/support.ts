import type { Placed, Shape, Vec3 } from "../data";
import { add, dot, rotate, rotateBack } from "../vector";

/** The point of a shape, in its frame, that is farthest along d; null if it has none. */
function supportInFrame(shape: Shape, d: Vec3): Vec3 | null {
  const sign = (x: number): number => (x < 0 ? -1 : 1);
  const size = Math.hypot(...d);
  const rim = Math.hypot(d[0], d[1]);
  switch (shape.type) {
    case "sphere": return size > 0 ? [shape.radius * d[0] / size, shape.radius * d[1] / size, shape.radius * d[2] / size] : [0, 0, 0];
    case "box": return [shape.half[0] * sign(d[0]), shape.half[1] * sign(d[1]), shape.half[2] * sign(d[2])];
    case "capsule": {
      const r = size > 0 ? shape.radius / size : 0;
      return [r * d[0], r * d[1], r * d[2] + sign(d[2]) * shape.length / 2];
    }
    case "cylinder": {
      const r = rim > 0 ? shape.radius / rim : 0;
      return [r * d[0], r * d[1], sign(d[2]) * shape.length / 2];
    }
    case "cone": {
      const r = rim > 0 ? shape.radius / rim : 0;
      const base: Vec3 = [r * d[0], r * d[1], -shape.length / 2];
      const apex: Vec3 = [0, 0, shape.length / 2];
      return dot(apex, d) > dot(base, d) ? apex : base;
    }
    case "hull": return shape.vertices.reduce((best, v) => (dot(v, d) > dot(best, d) ? v : best));
    case "half_space": return size > 0 && d[2] > 0 && rim <= 1e-9 * size ? [0, 0, 0] : null;
  }
}

/** The point of a body that is farthest along d, in the world; null for a half-space that has none. */
export function support({ shape, p, q }: Placed, d: Vec3): Vec3 | null {
  const point = supportInFrame(shape, rotateBack(q, d));
  return point && add(p, rotate(q, point));
}

/** Overlap of A and B along the unit normal n: max over A of n·x − min over B of n·x. Negative is a gap; infinite if a half-space
 * never ends along n. */
export function overlapAlong(A: Placed, B: Placed, n: Vec3): number {
  const a = support(A, n);
  const b = support(B, [-n[0], -n[1], -n[2]]);
  return a && b ? dot(n, [a[0] - b[0], a[1] - b[1], a[2] - b[2]]) : Infinity;
}

/** Radius of a ball around the origin of its frame that holds a shape; 0 for a half-space, which no ball holds. */
export function reach(shape: Shape): number {
  switch (shape.type) {
    case "sphere": return shape.radius;
    case "box": return Math.hypot(...shape.half);
    case "capsule": return shape.radius + shape.length / 2;
    case "cylinder": case "cone": return Math.hypot(shape.radius, shape.length / 2);
    case "hull": return Math.max(...shape.vertices.map((v) => Math.hypot(...v)));
    case "half_space": return 0;
  }
}
