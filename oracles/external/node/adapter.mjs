/** What the adapters for engines on npm share: how engines are loaded, and conversions.
 *
 * Import this module before any engine: it redirects what they print, see
 * touchstone_oracle.mjs. Vectors are lists of 3 numbers in the world frame [m], quaternions
 * are w, x, y, z unless a name says XYZW. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

import {
  Unsupported,
  rotated,
  serve,
} from "../../../docs/examples/oracles/node/touchstone_oracle.mjs";

export { Unsupported, rotated, serve };

/** The folder in which `npm ci` installed package.json of this folder. */
const ENGINES = process.env.TOUCHSTONE_ENGINES;

/** Returns the path of a file of an npm package, "package/file". */
export function pathInPackage(file) {
  if (!ENGINES) {
    throw new Error("set TOUCHSTONE_ENGINES to the folder that holds node_modules of the engines");
  }
  return join(ENGINES, "node_modules", file);
}

/** Loads a module of an npm package, "package/file". */
export function load(file) {
  return import(pathToFileURL(pathInPackage(file)));
}

/** Returns the version that an npm package states, for engines that do not tell their own. */
export function versionOf(name) {
  return JSON.parse(readFileSync(pathInPackage(`${name}/package.json`), "utf8")).version;
}

export const ALL_SHAPES = [
  "sphere",
  "box",
  "capsule",
  "cylinder",
  "cone",
  "convex_hull",
  "half_space",
];

/** Returns each ordered pair of `shapes` for which `matches(a, b)` holds. */
export function pairsOf(shapes, matches = () => true) {
  return shapes.flatMap((a) => shapes.filter((b) => matches(a, b)).map((b) => [a, b]));
}

export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const plus = (a, b) => a.map((number, i) => number + b[i]);
export const minus = (a, b) => a.map((number, i) => number - b[i]);
export const times = (v, factor) => v.map((number) => number * factor);

export const unit = (v) => times(v, 1 / Math.hypot(...v));

export const fromXyz = (v) => [v.x, v.y, v.z];
export const toXyz = ([x, y, z]) => ({ x, y, z });
export const toXyzw = ([w, x, y, z]) => ({ x, y, z, w });
export const fromXyzw = (q) => [q.w, q.x, q.y, q.z];

/** The quaternions that turn an engine's axis of capsules, cylinders and cones to z. */
export const Y_TO_Z = [Math.SQRT1_2, Math.SQRT1_2, 0, 0];
export const X_TO_Z = [Math.SQRT1_2, 0, -Math.SQRT1_2, 0];

/** Returns the rotation that turns by b, then by a. */
export function product(a, b) {
  return [
    a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
    a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
    a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
    a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
  ];
}

export const isRoundAboutZ = (body) => ["capsule", "cylinder", "cone"].includes(body.shape);

/** Returns the rotation of the shape in an engine whose axis is turned to z by `axis_to_z`. */
export function turnedToAxis(body, axis_to_z) {
  return isRoundAboutZ(body) ? product(body.quaternion, axis_to_z) : body.quaternion;
}

/** Returns a bound of the distance of two bodies, for engines that search within one. [m] */
export function farthestApart(A, B) {
  return 1 + 2 * (Math.hypot(...minus(B.position, A.position)) + radius(A) + radius(B));
}

function radius(body) {
  const sizes = [body.radius, body.half_length, body.half_height, body.half_extents];
  const vertices = (body.vertices ?? []).map((vertex) => Math.hypot(...vertex));
  return sizes.flat().reduce((sum, size) => sum + (size ?? 0), Math.max(0, ...vertices));
}

/** Refuses a hull of fewer vertices than an engine takes. */
export function requireVertices({ vertices }, least) {
  if (vertices.length < least) {
    throw new Unsupported(`the engine makes hulls of at least ${least} vertices`);
  }
}

/** Returns the answer of an engine that gives a point on each surface.
 * @param normal From A to B, of unit length as far as the engine makes it so.
 * @param separation Negative if the bodies overlap. [m] */
export function fromWitnesses(p_A, p_B, normal, separation) {
  const touching = separation <= 0;
  const answer = { touching, separation, normal, witnesses: [p_A, p_B] };
  if (touching) answer.points = [{ position: times(plus(p_A, p_B), 0.5), separation }];
  return answer;
}

/** Returns a parameter that a user may choose, see docs/oracle_protocol.md. */
export function parameter(name, here, shipped, least, most, what, why, whole = false) {
  return { name, here, shipped, least, most, whole, what, why };
}

export const setting = (name, value, why) => ({ name, value, why });
