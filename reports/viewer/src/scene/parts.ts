import * as three from "three";
import type { Quat, Vec3 } from "../data";
import { cornersOf, type Look } from "../engines";
import { across, cross } from "../vector";
import type { Form } from "./shapes";

/** A map from the world to the scene that a graphics card, with its 24 bits, draws well: the scene has a radius of about 1. */
export interface Frame { centre: Vec3; scale: number }

/** A point of the world in the scene. The subtraction is in doubles, before anything is rounded to single precision. */
export const toScene = ({ centre, scale }: Frame, p: Vec3): three.Vector3 =>
  new three.Vector3((p[0] - centre[0]) * scale, (p[1] - centre[1]) * scale, (p[2] - centre[2]) * scale);

export const quaternion = (q: Quat): three.Quaternion => new three.Quaternion(q[1], q[2], q[3], q[0]);

export interface Style { colour: string; opacity: number; edge?: string; edgeOpacity?: number }

/** A solid with its edges, translucent unless its opacity is 1. */
export function solid({ surface, edges }: Form, { colour, opacity, edge, edgeOpacity }: Style): three.Group {
  const group = new three.Group();
  const clear = opacity < 1;
  const mesh = new three.Mesh(surface, new three.MeshLambertMaterial({
    // A solid is closed: its back is never seen, and costs as much as its front.
    color: colour, transparent: clear, opacity, depthWrite: !clear, side: surface instanceof three.PlaneGeometry ? three.DoubleSide : three.FrontSide,
    polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
  }));
  mesh.userData.convex = true;
  const outline = new three.LineSegments(edges, new three.LineBasicMaterial({ color: edge ?? colour, transparent: true, opacity: edgeOpacity ?? 0.9 }));
  group.add(mesh, outline);
  return group;
}

/** Gives an object the frame whose z axis is n. */
export function alignZ(object: three.Object3D, n: Vec3): void {
  const x = across(n);
  const y = cross(n, x);
  object.quaternion.setFromRotationMatrix(new three.Matrix4().makeBasis(
    new three.Vector3(...x), new three.Vector3(...y), new three.Vector3(...n)));
}

/** A flat mark with the corners of an engine's marker, across n. */
export function disc(at: three.Vector3, n: Vec3, radius: number, look: Look, colour: string): three.Object3D {
  const geometry = look.corners === 0 ? new three.CircleGeometry(radius, 24)
    : new three.ShapeGeometry(new three.Shape(cornersOf(look.corners).map(([x, y]) => new three.Vector2(x * radius * 1.15, y * radius * 1.15))));
  const mesh = new three.Mesh(geometry, new three.MeshBasicMaterial({ color: colour, side: three.DoubleSide, transparent: true, opacity: 0.9 }));
  mesh.position.copy(at);
  alignZ(mesh, n);
  mesh.renderOrder = 3;
  return mesh;
}

/** A rod between two points. */
export function rod(from: three.Vector3, to: three.Vector3, radius: number, colour: string): three.Object3D {
  const way = to.clone().sub(from);
  const size = way.length();
  const mesh = new three.Mesh(new three.CylinderGeometry(radius, radius, Math.max(size, 1e-9), 8), new three.MeshBasicMaterial({ color: colour }));
  mesh.position.copy(from).addScaledVector(way, 0.5);
  if (size > 0) mesh.quaternion.setFromUnitVectors(new three.Vector3(0, 1, 0), way.divideScalar(size));
  mesh.userData.convex = true;
  return mesh;
}

/** An arrow from a point along a vector. */
export function arrow(from: three.Vector3, along: three.Vector3, radius: number, colour: string): three.Object3D {
  const size = along.length();
  const group = new three.Group();
  if (size === 0) return group;
  const head = Math.min(size * 0.4, radius * 7);
  const neck = from.clone().addScaledVector(along, (size - head) / size);
  const tip = new three.Mesh(new three.ConeGeometry(radius * 2.6, head, 12), new three.MeshBasicMaterial({ color: colour }));
  tip.position.copy(from).addScaledVector(along, (size - head / 2) / size);
  tip.quaternion.setFromUnitVectors(new three.Vector3(0, 1, 0), along.clone().divideScalar(size));
  tip.userData.convex = true;
  group.add(rod(from, neck, radius, colour), tip);
  return group;
}

export function ball(at: three.Vector3, radius: number, colour: string): three.Object3D {
  const mesh = new three.Mesh(new three.SphereGeometry(radius, 16, 12), new three.MeshBasicMaterial({ color: colour }));
  mesh.position.copy(at);
  mesh.userData.convex = true;
  return mesh;
}

/** A ball that is seen through whatever is before it. */
export function spot(at: three.Vector3, radius: number, colour: string): three.Object3D {
  const mesh = ball(at, radius, colour) as three.Mesh<three.SphereGeometry, three.MeshBasicMaterial>;
  mesh.material.depthTest = false;
  mesh.material.transparent = true;
  mesh.renderOrder = 5;
  return mesh;
}

/** A line through points. */
export function path(points: three.Vector3[], colour: string, opacity = 1): three.Line {
  const line = new three.Line(new three.BufferGeometry().setFromPoints(points),
    new three.LineBasicMaterial({ color: colour, transparent: opacity < 1, opacity }));
  line.frustumCulled = false;
  return line;
}

/** A square of a plane with the normal n, with its outline. */
export function planePatch(at: three.Vector3, n: Vec3, half: number, colour: string): three.Group {
  const group = new three.Group();
  const surface = new three.PlaneGeometry(2 * half, 2 * half);
  const mesh = new three.Mesh(surface, new three.MeshBasicMaterial({ color: colour, transparent: true, opacity: 0.16, side: three.DoubleSide, depthWrite: false }));
  mesh.userData.convex = true;
  group.add(mesh, new three.LineSegments(new three.EdgesGeometry(surface), new three.LineBasicMaterial({ color: colour })));
  group.position.copy(at);
  alignZ(group, n);
  return group;
}

/** A convex polygon with an outline and hatching. */
export function hatched(corners: three.Vector3[], n: Vec3, colour: string, spacing: number): three.Group {
  const group = new three.Group();
  group.add(path([...corners, corners[0]], colour));
  if (corners.length < 3) return group;
  const u = new three.Vector3(...across(n));
  const v = new three.Vector3(...n).cross(u);
  const hatchAlong = u.clone().add(v).normalize();
  const hatchAcross = u.clone().sub(v).normalize();
  const heights = corners.map((c) => c.dot(hatchAcross));
  const [low, high] = [Math.min(...heights), Math.max(...heights)];
  const step = Math.max(spacing, (high - low) / 60);
  const points: three.Vector3[] = [];
  for (let level = low + step / 2; level < high; level += step) {
    const cuts: three.Vector3[] = [];
    corners.forEach((a, i) => {
      const k = (i + 1) % corners.length;
      if ((heights[i] - level) * (heights[k] - level) < 0) cuts.push(a.clone().lerp(corners[k], (level - heights[i]) / (heights[k] - heights[i])));
    });
    cuts.sort((a, b) => a.dot(hatchAlong) - b.dot(hatchAlong));
    if (cuts.length >= 2) points.push(cuts[0], cuts[cuts.length - 1]);
  }
  group.add(new three.LineSegments(new three.BufferGeometry().setFromPoints(points), new three.LineBasicMaterial({ color: colour, transparent: true, opacity: 0.7 })));
  return group;
}

/** Frees what the graphics card holds of an object and its children. */
export function dispose(object: three.Object3D): void {
  object.traverse((part) => {
    const { geometry, material } = part as Partial<three.Mesh>;
    geometry?.dispose();
    if (material) for (const m of Array.isArray(material) ? material : [material]) m.dispose();
  });
  object.removeFromParent();
}
