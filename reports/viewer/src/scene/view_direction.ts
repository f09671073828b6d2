import * as three from "three";
import type { Vec3 } from "../data";
import { across } from "../vector";

/** The direction from which a scene is seen at first. */
export function startingView(up: Vec3): Vec3 {
  const side = across(up);
  const other = new three.Vector3(...up).cross(new three.Vector3(...side));
  return new three.Vector3(...side).multiplyScalar(0.55).addScaledVector(other, 0.75).addScaledVector(new three.Vector3(...up), 0.45).toArray() as Vec3;
}

/** The direction from which a normal is seen in profile, in the plane of the screen, and the one that an engine claims with it: whatever moves along them
 * then moves across the screen, not towards the reader. */
export function profileView(n: Vec3, claimed: Vec3 | null, up: Vec3 = [0, 0, 1]): Vec3 {
  const start = new three.Vector3(...startingView(up));
  const normal = new three.Vector3(...n).normalize();
  const side = claimed ? normal.clone().cross(new three.Vector3(...claimed).normalize()) : new three.Vector3();
  // An angle too small to be seen leaves the choice of the side to the eye.
  if (side.length() < 0.02) side.copy(start).addScaledVector(normal, -start.dot(normal));
  if (side.length() < 0.02) side.set(...across(n));
  return side.multiplyScalar(side.dot(start) < 0 ? -1 : 1).normalize().toArray() as Vec3;
}
