import * as three from "three";
import type { Run } from "../run";
import type { Vec3, World } from "../data";
import { colourOf, prefersDark } from "../engines";
import { dot, rotate, sub, times, unit } from "../vector";
import { arrow, ball, dispose, path, quaternion, solid, spot, toScene, type Frame } from "./parts";
import { groundGrid, makeDropLines } from "./ground";
import { makeBatch } from "./instances";
import type { Ball } from "./stage";
import { answered, motionExtent } from "./motion_extent";
import { formOf, type Form } from "./shapes";

export interface WorldScene {
  root: three.Group;
  frame: Frame;
  radius: number;
  centre: three.Vector3;
  /** Balls that hold all that moves over the whole motion, in the scene. */
  extent: Ball[];
  /** The oracles whose motion leaves the extent, and when [s]. */
  left: Map<number, number>;
  up: Vec3;
  /** Shows the world at a time [s]. */
  setTime(time: number): void;
  /** Shows an oracle solid, as a ghost or not at all. */
  show(oracle: number, how: "solid" | "ghost" | "hidden"): void;
  /** Whether the motion of an oracle has ended before the time that is shown: it has diverged, and is drawn no more. */
  hasEnded(oracle: number): boolean;
  showTrails(visible: boolean): void;
  showImpulses(visible: boolean): void;
  /** Draws impulses, and the grid of the ground, for a view of that radius around a point, in units of the scene; without a point for the whole. */
  sizeImpulses(seen: number, around?: three.Vector3): void;
  /** Marks points, joined by a line.
   * @param seen radius of what is in sight, in units of the scene */
  mark(points: Vec3[], seen?: number): void;
  /** A marked point in the scene; null if there is none. */
  marked(index: number): three.Vector3 | null;
  /** Position of a body in the scene at the time that is shown; that at the start of one that is fixed. */
  bodyAt(oracle: number, body: number): three.Vector3;
  /** Position of a particle in the scene at the time that is shown; null if the oracle has none. */
  particleAt(oracle: number, particle: number): three.Vector3 | null;
  /** Where a fixed body is named: on the part of it that is drawn. */
  groundAt(body: number): three.Vector3;
}

/** Channels of the track of a body. */
export const channel = { x: 0, y: 1, z: 2, qw: 3, qx: 4, qy: 5, qz: 6, vx: 7, vy: 8, vz: 9, wx: 10, wy: 11, wz: 12 } as const;
const impulseChannels = { sample: 0, p: 3, J: 9 } as const;

export function upOf(world: World): Vec3 {
  const up = unit(times(-1, world.gravity));
  return Math.hypot(...up) > 0.5 ? up : [0, 0, 1];
}

/** Where `time` is among the samples: the one before it, and the part of the way to the next. */
export function sampleAt(times_: number[], time: number): { sample: number; part: number } {
  let [low, high] = [0, times_.length - 1];
  while (low < high) {
    const mid = (low + high + 1) >> 1;
    if (times_[mid] <= time) low = mid;
    else high = mid - 1;
  }
  const next = Math.min(low + 1, times_.length - 1);
  return { sample: low, part: next > low ? Math.max(0, Math.min(1, (time - times_[low]) / (times_[next] - times_[low]))) : 0 };
}

const mix = (values: Float64Array, { sample, part }: { sample: number; part: number }): number => {
  const last = values.length - 1;
  const a = values[Math.min(sample, last)];
  return a + part * (values[Math.min(sample + 1, last)] - a);
};

/** The part of one engine in a world: its bodies, particles, cloths, joints and trails. */
interface Actor { group: three.Group; trails: three.Object3D; setPose(time: { sample: number; part: number }): void; restyle(how: "solid" | "ghost"): void; bodies: (Pose | null)[]; balls: three.Object3D[] }

interface Pose { position: three.Vector3; quaternion: three.Quaternion }

// Scratch of setPose(), which is called for each oracle in each frame.
const nextTurn = new three.Quaternion();
const matrix = new three.Matrix4();
const unscaled = new three.Vector3(1, 1, 1);

/** The paths of all bodies of an oracle in one object, sample by sample, so that a range of it is the past. `drawn[k]` is the number of vertices
 * until sample k. */
function makeTrails(tracks: (Float64Array[] | null)[], { centre, scale }: Frame, colour: string): { trails: three.LineSegments; drawn: number[] } {
  const known = tracks.filter((c): c is Float64Array[] => c !== null && c[0].length > 1);
  const samples = Math.max(1, ...known.map((c) => c[0].length));
  const drawn = [0];
  const points: number[] = [];
  const fits = known.length * samples <= 60000;
  for (let k = 1; k < samples; ++k) {
    if (fits) for (const c of known) if (k < c[0].length) for (const i of [k - 1, k]) for (let axis = 0; axis < 3; ++axis) points.push((c[axis][i] - centre[axis]) * scale);
    drawn.push(points.length / 3);
  }
  const trails = new three.LineSegments(new three.BufferGeometry().setAttribute("position", new three.Float32BufferAttribute(points, 3)),
    new three.LineBasicMaterial({ color: colour, transparent: true, opacity: 0.55 }));
  trails.frustumCulled = false;
  return { trails, drawn };
}

/** @param trusted the oracles whose motion is right, the most trusted first: the view fits theirs, and those that keep near */
export function buildWorld(run: Run, world: World, trusted: number[]): WorldScene {
  const { box, balls: extent, left } = motionExtent(run, world, trusted);
  const middle = box.getCenter(new three.Vector3()).toArray() as Vec3;
  const radiusInMetres = Math.max(box.getSize(new three.Vector3()).length() / 2, 1e-9);
  const frame: Frame = { centre: middle, scale: 1 / radiusInMetres };
  const up = upOf(world);
  const dark = prefersDark();
  const root = new three.Group();

  // If there are many ghosts, only their edges are drawn, round shapes with fewer sides. Faces and trails of ghosts are hardly visible there and cost
  // the most time.
  const crowded = world.bodies.filter((b) => !b.fixed).length * world.motions.filter(answered).length > 60;

  const forms = new Map<string, Form>();
  const formFor = (b: number): Form => {
    const shape = world.bodies[b].shape;
    const key = JSON.stringify(shape);
    let form = forms.get(key);
    if (!form) forms.set(key, form = formOf(shape, frame.scale, 2.2, crowded ? 16 : 32));
    return form;
  };
  const grounds = new Map<number, three.Vector3>();
  world.bodies.forEach((body, b) => {
    if (!body.fixed) return;
    const ground = solid(formFor(b), { colour: dark ? "#5c6470" : "#c3c8d0", edge: dark ? "#8a93a1" : "#7c8694", opacity: 0.28, edgeOpacity: 0.55 });
    let p = body.start.p;
    if (body.shape.type === "half_space") {
      const n = rotate(body.start.q, [0, 0, 1]);
      p = sub(middle, times(dot(n, sub(middle, p)), n));
    }
    ground.position.copy(toScene(frame, p));
    ground.quaternion.copy(quaternion(body.start.q));
    root.add(ground);
    // A half-space fills the picture: its name is beside what moves on it.
    grounds.set(b, body.shape.type === "half_space" ? new three.Vector3(0.8, 0, 0).applyQuaternion(ground.quaternion).add(ground.position) : ground.position.clone());
  });

  const anchor = (bodies: (Pose | null)[], balls: three.Object3D[], index: number, p: Vec3): three.Vector3 => {
    if (index < 0) return toScene(frame, p);
    if (index >= world.bodies.length) return balls[index - world.bodies.length]?.position.clone() ?? toScene(frame, p);
    const body = bodies[index];
    const start = world.bodies[index].start;
    const offset = new three.Vector3(...p).multiplyScalar(frame.scale);
    return body ? offset.applyQuaternion(body.quaternion).add(body.position) : offset.applyQuaternion(quaternion(start.q)).add(toScene(frame, start.p));
  };

  const makeActor = (oracle: number): Actor | null => {
    const motion = world.motions[oracle];
    if (!answered(motion)) return null;
    const colour = colourOf(run.looks[oracle]);
    const group = new three.Group();
    const bodies = world.bodies.map((body, b): Pose | null => (body.fixed || !motion.bodies[b] ? null : { position: new three.Vector3(), quaternion: new three.Quaternion() }));
    const perForm = new Map<Form, number[]>();
    bodies.forEach((pose, b) => {
      if (!pose) return;
      const list = perForm.get(formFor(b));
      if (list) list.push(b);
      else perForm.set(formFor(b), [b]);
    });
    const batches = [...perForm].map(([form, list]) => ({ list, batch: makeBatch(form, list.length, colour) }));
    for (const { batch } of batches) group.add(batch.surfaces, batch.edges);
    const tracks = motion.bodies.map((track) => (track ? run.channels(track) : null));
    const points = motion.points ? run.channels(motion.points) : null;
    const balls = points ? world.particles.map((particle) => {
      const object = ball(new three.Vector3(), Math.max(particle.radius * frame.scale, 0.012), colour);
      group.add(object);
      return object;
    }) : [];
    const links = [...world.springs, ...world.joints];
    const linkLines = new three.LineSegments(new three.BufferGeometry().setFromPoints(links.flatMap(() => [new three.Vector3(), new three.Vector3()])),
      new three.LineBasicMaterial({ color: colour }));
    linkLines.frustumCulled = false;
    if (links.length) group.add(linkLines);
    // Threads of all cloths, as pairs of nodes; the nodes follow the particles.
    const threads: [number, number][] = [];
    let firstNode = world.particles.length;
    for (const { rows, columns } of world.cloths) {
      for (let r = 0; r < rows; ++r) for (let c = 0; c < columns; ++c) {
        const node = firstNode + r * columns + c;
        if (c + 1 < columns) threads.push([node, node + 1]);
        if (r + 1 < rows) threads.push([node, node + columns]);
      }
      firstNode += rows * columns;
    }
    const cloth = new three.LineSegments(new three.BufferGeometry().setFromPoints(threads.flatMap(() => [new three.Vector3(), new three.Vector3()])),
      new three.LineBasicMaterial({ color: colour, transparent: true, opacity: 0.8 }));
    cloth.frustumCulled = false;
    if (threads.length && points) group.add(cloth);
    const { trails, drawn } = makeTrails(tracks, frame, colour);
    group.add(trails);
    return {
      group, trails, bodies, balls,
      setPose(at) {
        tracks.forEach((c, b) => {
          const pose = bodies[b];
          if (!c || !pose) return;
          pose.position.set((mix(c[0], at) - middle[0]) * frame.scale, (mix(c[1], at) - middle[1]) * frame.scale, (mix(c[2], at) - middle[2]) * frame.scale);
          const last = c[0].length - 1;
          const i = Math.min(at.sample, last);
          const k = Math.min(at.sample + 1, last);
          pose.quaternion.set(c[4][i], c[5][i], c[6][i], c[3][i]).slerp(nextTurn.set(c[4][k], c[5][k], c[6][k], c[3][k]), at.part).normalize();
        });
        for (const { list, batch } of batches) {
          for (let i = 0; i < list.length; ++i) {
            const pose = bodies[list[i]]!;
            batch.set(i, matrix.compose(pose.position, pose.quaternion, unscaled));
          }
          batch.commit();
        }
        if (points) {
          const node = (k: number): three.Vector3 => toScene(frame, [mix(points[3 * k], at), mix(points[3 * k + 1], at), mix(points[3 * k + 2], at)]);
          balls.forEach((object, k) => { if (3 * k + 2 < points.length) object.position.copy(node(k)); });
          if (threads.length) {
            const place = cloth.geometry.getAttribute("position");
            threads.forEach(([a, b], i) => {
              if (3 * b + 2 >= points.length) return;
              const [pa, pb] = [node(a), node(b)];
              place.setXYZ(2 * i, pa.x, pa.y, pa.z);
              place.setXYZ(2 * i + 1, pb.x, pb.y, pb.z);
            });
            place.needsUpdate = true;
          }
        }
        if (links.length) {
          const place = linkLines.geometry.getAttribute("position");
          links.forEach((link, i) => {
            const [pa, pb] = [anchor(bodies, balls, link.A, link.pA), anchor(bodies, balls, link.B, link.pB)];
            place.setXYZ(2 * i, pa.x, pa.y, pa.z);
            place.setXYZ(2 * i + 1, pb.x, pb.y, pb.z);
          });
          place.needsUpdate = true;
        }
        trails.geometry.setDrawRange(0, drawn[Math.min(at.sample, drawn.length - 1)]);
      },
      restyle(how) {
        trails.userData.faint = how === "ghost" && crowded;
        trails.visible = trailsShown && !trails.userData.faint;
        for (const { batch: { surfaces, edges } } of batches) {
          surfaces.visible = how === "solid" || !crowded;
          const material = surfaces.material as three.MeshLambertMaterial;
          material.opacity = how === "solid" ? 1 : 0.1;
          if (material.transparent !== (how === "ghost")) {
            material.transparent = how === "ghost";
            material.needsUpdate = true;
          }
          material.depthWrite = how === "solid";
          // Where a ghost is at the same place, the solid is seen.
          material.polygonOffsetFactor = material.polygonOffsetUnits = how === "solid" ? 1 : 4;
          // The edges of a solid would not be seen on it in its own colour.
          edges.renderOrder = how === "solid" ? 2 : 1;
          edges.material.color.set(colour);
          if (how === "solid") edges.material.color.lerp(new three.Color(edges.material.color.getHSL({ h: 0, s: 0, l: 0 }).l > 0.5 ? "#000000" : "#ffffff"), 0.55);
        }
      },
    };
  };

  // Engines that are never shown are never built: most of a large world's bodies.
  const actors = new Map<number, Actor | null>();
  const actorOf = (oracle: number): Actor | null => {
    let actor = actors.get(oracle);
    if (actor === undefined) {
      actor = makeActor(oracle);
      actors.set(oracle, actor);
      if (actor) { root.add(actor.group); actor.setPose(sampleAt(world.times, time)); }
    }
    return actor;
  };
  let time = world.times[0] ?? 0;
  let trailsShown = true;
  let impulsesShown = true;
  let solidOracle = -1;
  let impulseSample = -1;
  let seenRadius = 1;
  const drops = makeDropLines(world, frame, up, dark ? "#9aa4b2" : "#626c7a");
  root.add(drops.lines);
  let grid: three.LineSegments | null = null;
  const drawDrops = (): void => {
    const poses = hasEnded(solidOracle) ? undefined : actors.get(solidOracle)?.bodies;
    drops.set(world.bodies.map((_, b): Vec3 | null => {
      const pose = poses?.[b];
      return pose ? [pose.position.x / frame.scale + middle[0], pose.position.y / frame.scale + middle[1], pose.position.z / frame.scale + middle[2]] : null;
    }));
  };
  const hidden = new Set<number>();
  /** The last time of each motion that ends before the others [s]: a pose that is kept would be read as one at rest. */
  const ends = world.motions.map((motion) => {
    const samples = Math.max(motion.points?.samples ?? 0, ...motion.bodies.map((track) => track?.samples ?? 0));
    return samples > 0 && samples < world.times.length ? world.times[samples - 1] : Infinity;
  });
  const hasEnded = (oracle: number): boolean => time > (ends[oracle] ?? Infinity) + 1e-9;
  const marks = new three.Group();
  let markedPoints: three.Vector3[] = [];
  root.add(marks);
  const impulses = new three.Group();
  root.add(impulses);

  const drawImpulses = (sample: number, force: boolean): void => {
    if (sample === impulseSample && !force) return;
    impulseSample = sample;
    for (const old of [...impulses.children]) dispose(old);
    const track = impulsesShown ? world.motions[solidOracle]?.impulses : undefined;
    if (!track) return;
    const c = run.channels(track);
    const size = (i: number): number => Math.hypot(c[impulseChannels.J][i], c[impulseChannels.J + 1][i], c[impulseChannels.J + 2][i]);
    let most = 0;
    for (let i = 0; i < track.samples; ++i) most = Math.max(most, size(i));
    if (most === 0) return;
    const colour = dark ? "#ffd166" : "#a03000";
    let drawn = 0;
    for (let i = 0; i < track.samples && drawn < 200; ++i) {
      if (c[impulseChannels.sample][i] !== sample || size(i) === 0) continue;
      const J = new three.Vector3(c[9][i], c[10][i], c[11][i]);
      // The impulse is that on B. On a body that cannot move nobody looks for it: A receives the opposite.
      const [A, B] = [c[1][i], c[2][i]];
      if (world.bodies[B]?.fixed && world.bodies[A]?.fixed === false) J.negate();
      // The length is the square root of the impulse, so that weak impulses next to an impact are visible.
      J.setLength(0.32 * seenRadius * Math.sqrt(size(i) / most));
      impulses.add(arrow(toScene(frame, [c[3][i], c[4][i], c[5][i]]), J, 0.006 * seenRadius, colour));
      ++drawn;
    }
  };

  return {
    root, frame, up, left, radius: 1, centre: new three.Vector3(),
    extent: extent.map(({ at, radius }) => ({ at: toScene(frame, at), radius: radius * frame.scale })),
    hasEnded,
    setTime(now) {
      time = now;
      const at = sampleAt(world.times, now);
      for (const [oracle, actor] of actors) {
        if (!actor || hidden.has(oracle)) continue;
        actor.group.visible = !hasEnded(oracle);
        if (actor.group.visible) actor.setPose(at);
      }
      drawImpulses(at.part > 0 ? at.sample + 1 : at.sample, false);
      drawDrops();
    },
    show(oracle, how) {
      if (how === "hidden") hidden.add(oracle);
      else hidden.delete(oracle);
      if (how === "hidden") {
        const actor = actors.get(oracle);
        if (actor) actor.group.visible = false;
        return;
      }
      const actor = actorOf(oracle);
      if (how === "solid" && solidOracle !== oracle) { solidOracle = oracle; drawImpulses(impulseSample, true); }
      if (!actor) return;
      actor.group.visible = !hasEnded(oracle);
      actor.restyle(how);
      actor.setPose(sampleAt(world.times, time));
      drawDrops();
    },
    showTrails(visible) {
      trailsShown = visible;
      for (const actor of actors.values()) if (actor) actor.trails.visible = visible && !actor.trails.userData.faint;
    },
    showImpulses(visible) {
      impulsesShown = visible;
      drawImpulses(impulseSample, true);
    },
    sizeImpulses(seen, around) {
      seenRadius = Math.min(1, seen);
      if (grid) dispose(grid);
      grid = around ? groundGrid(world, frame, around, seenRadius, dark ? "#8a93a1" : "#7c8694") : null;
      if (grid) root.add(grid);
      drawImpulses(impulseSample, true);
    },
    mark(points, seen = 1) {
      for (const old of [...marks.children]) dispose(old);
      const colour = dark ? "#ff9ecf" : "#b3006b";
      markedPoints = points.map((p) => toScene(frame, p));
      const apart = markedPoints.length > 1 ? markedPoints[0].distanceTo(markedPoints[1]) : Infinity;
      marks.add(...markedPoints.map((p) => spot(p, seen * Math.max(0.003, Math.min(0.022, apart / seen / 8)), colour)), path(markedPoints, colour));
    },
    marked: (index) => markedPoints[index] ?? null,
    bodyAt: (oracle, body) => actors.get(oracle)?.bodies[body]?.position.clone() ?? toScene(frame, world.bodies[body]?.start.p ?? middle),
    particleAt: (oracle, particle) => actors.get(oracle)?.balls[particle]?.position ?? null,
    groundAt: (body) => grounds.get(body) ?? toScene(frame, world.bodies[body]?.start.p ?? middle),
  };
}
