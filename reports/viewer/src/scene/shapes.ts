import * as three from "three";
import { ConvexGeometry } from "three/examples/jsm/geometries/ConvexGeometry.js";
import type { Shape } from "../data";

/** Surface and edges of a shape. */
export interface Form { surface: three.BufferGeometry; edges: three.BufferGeometry }

function ring(radius: number, z: number, ringSteps: number, axis: "x" | "y" | "z" = "z"): number[] {
  const points: number[] = [];
  for (let i = 0; i < ringSteps; ++i) {
    for (const k of [i, i + 1]) {
      const a = (2 * Math.PI * k) / ringSteps;
      const [u, v] = [radius * Math.cos(a), radius * Math.sin(a)];
      points.push(...(axis === "z" ? [u, v, z] : axis === "x" ? [0, u, v + z] : [u, 0, v + z]));
    }
  }
  return points;
}

/** A half circle over or under the height z, in the plane across x or y. */
function arch(radius: number, z: number, up: boolean, ringSteps: number, axis: "x" | "y"): number[] {
  const points: number[] = [];
  for (let i = 0; i < ringSteps / 2; ++i) {
    for (const k of [i, i + 1]) {
      const a = (2 * Math.PI * k) / ringSteps;
      const [u, w] = [radius * Math.cos(a), z + (up ? 1 : -1) * radius * Math.sin(a)];
      points.push(...(axis === "x" ? [0, u, w] : [u, 0, w]));
    }
  }
  return points;
}

function uprights(bottom: number, top: number, low: number, high: number): number[] {
  return [[1, 0], [0, 1], [-1, 0], [0, -1]].flatMap(([x, y]) => [bottom * x, bottom * y, low, top * x, top * y, high]);
}

function lines(points: number[]): three.BufferGeometry {
  return new three.BufferGeometry().setAttribute("position", new three.Float32BufferAttribute(points, 3));
}

function grid(extent: number): number[] {
  const points: number[] = [];
  for (let i = -5; i <= 5; ++i) {
    const t = (i / 5) * extent;
    points.push(t, -extent, 0, t, extent, 0, -extent, t, 0, extent, t, 0);
  }
  return points;
}

const sharp = (surface: three.BufferGeometry): three.BufferGeometry => new three.EdgesGeometry(surface, 1);

/** A ball whose opposite quarters are darker: one of a single colour seems to slide where it rolls. */
function quartered(ball: three.BufferGeometry): three.BufferGeometry {
  const surface = ball.toNonIndexed();
  const place = surface.getAttribute("position");
  const tones: number[] = [];
  // A face lies in one quarter, because the sides of its polygon are a multiple of four.
  for (let face = 0; face + 2 < place.count; face += 3) {
    const [x, z] = [0, 1, 2].reduce(([a, b], k) => [a + place.getX(face + k), b + place.getY(face + k)], [0, 0]);
    const tone = x * z > 0 ? 0.62 : 1;
    for (let k = 0; k < 9; ++k) tones.push(tone);
  }
  return surface.setAttribute("color", new three.Float32BufferAttribute(tones, 3));
}

/** Builds a shape, its lengths multiplied by `scale`. A half-space is a square patch with sides of 2 `extent`, in scaled units.
 * @param steps sides of the polygon that stands for a circle */
export function formOf(shape: Shape, scale: number, extent: number, steps = 32): Form {
  switch (shape.type) {
    case "sphere": {
      const r = shape.radius * scale;
      return { surface: quartered(new three.SphereGeometry(r, steps, steps / 2)), edges: lines([...ring(r, 0, steps), ...ring(r, 0, steps, "x"), ...ring(r, 0, steps, "y")]) };
    }
    case "box": {
      const surface = new three.BoxGeometry(...(shape.half.map((s) => 2 * s * scale) as [number, number, number]));
      return { surface, edges: sharp(surface) };
    }
    case "capsule": {
      const [r, half] = [shape.radius * scale, (shape.length / 2) * scale];
      return {
        surface: new three.CapsuleGeometry(r, 2 * half, steps / 4, steps).rotateX(Math.PI / 2),
        edges: lines([...ring(r, half, steps), ...ring(r, -half, steps), ...uprights(r, r, -half, half),
          ...(["x", "y"] as const).flatMap((axis) => [...arch(r, half, true, steps, axis), ...arch(r, -half, false, steps, axis)])]),
      };
    }
    case "cylinder": {
      const [r, half] = [shape.radius * scale, (shape.length / 2) * scale];
      return {
        surface: new three.CylinderGeometry(r, r, 2 * half, steps).rotateX(Math.PI / 2),
        edges: lines([...ring(r, half, steps), ...ring(r, -half, steps), ...uprights(r, r, -half, half)]),
      };
    }
    case "cone": {
      const [r, half] = [shape.radius * scale, (shape.length / 2) * scale];
      return {
        surface: new three.ConeGeometry(r, 2 * half, steps).rotateX(Math.PI / 2),
        edges: lines([...ring(r, -half, steps), ...uprights(r, 0, -half, half)]),
      };
    }
    case "half_space": return { surface: new three.PlaneGeometry(2 * extent, 2 * extent), edges: lines(grid(extent)) };
    case "hull": {
      const points = shape.vertices.map((v) => new three.Vector3(...v).multiplyScalar(scale));
      const surface = new ConvexGeometry(points);
      if (surface.getAttribute("position").count > 0) return { surface, edges: sharp(surface) };
      // A hull too flat for the hull builder: its vertices, joined.
      return { surface, edges: lines(points.flatMap((a, i) => points.slice(i + 1).flatMap((b) => [...a.toArray(), ...b.toArray()]))) };
    }
  }
}
