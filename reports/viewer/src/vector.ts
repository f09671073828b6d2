import type { Quat, Vec3 } from "./data";

export const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const sub = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const times = (s: number, a: Vec3): Vec3 => [s * a[0], s * a[1], s * a[2]];
export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vec3, b: Vec3): Vec3 => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const norm = (a: Vec3): number => Math.hypot(...a);
export const isFinite3 = (a: Vec3): boolean => a.every(Number.isFinite);
export const middle = (a: Vec3, b: Vec3): Vec3 => [a[0] / 2 + b[0] / 2, a[1] / 2 + b[1] / 2, a[2] / 2 + b[2] / 2];

/** The unit vector along a; a itself if it is zero. */
export function unit(a: Vec3): Vec3 {
  const size = norm(a);
  return size > 0 ? times(1 / size, a) : a;
}

export function rotate(q: Quat, v: Vec3): Vec3 {
  const axis: Vec3 = [q[1], q[2], q[3]];
  const t = times(2, cross(axis, v));
  return add(add(v, times(q[0], t)), cross(axis, t));
}

export const rotateBack = (q: Quat, v: Vec3): Vec3 => rotate([q[0], -q[1], -q[2], -q[3]], v);

/** A unit vector across a. */
export function across(a: Vec3): Vec3 {
  const least = Math.min(...a.map(Math.abs));
  const axis: Vec3 = Math.abs(a[2]) === least ? [0, 0, 1] : Math.abs(a[1]) === least ? [0, 1, 0] : [1, 0, 0];
  return unit(cross(cross(a, axis), a));
}
