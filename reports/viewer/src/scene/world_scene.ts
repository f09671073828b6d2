import * as three from "three";
import type { Run } from "../run";
import type { Motion, Vec3, World } from "../data";
import { colourOf, prefersDark } from "../engines";
import { dot, rotate, sub, times, unit } from "../vector";
import { arrow, ball, dispose, path, quaternion, solid, toScene, type Frame } from "./parts";
import { formOf, type Form } from "./shapes";
import { reach } from "./support";

export interface WorldScene {
  root: three.Group;
  frame: Frame;
  radius: number;
  centre: three.Vector3;
  up: Vec3;
  /** Shows the world at a time [s]. */
  setTime(time: number): void;
  /** Shows an oracle solid, as a ghost or not at all. */
  show(oracle: number, how: "solid" | "ghost" | "hidden"): void;
  showTrails(visible: boolean): void;
  showImpulses(visible: boolean): void;
  /** Marks points, joined by a line. */
  mark(points: Vec3[]): void;
  /** A marked point in the scene; null if there is none. */
  marked(index: number): three.Vector3 | null;
  /** Position of a moving thing in the scene at the time that is shown. */
  bodyAt(oracle: number, body: number): three.Vector3;
}

/** Channels of the track of a body. */
export const channel = { x: 0, y: 1, z: 2, qw: 3, qx: 4, qy: 5, qz: 6, vx: 7, vy: 8, vz: 9, wx: 10, wy: 11, wz: 12 } as const;
const impulseChannels = { sample: 0, p: 3, J: 9 } as const;

export const answered = (motion: Motion | undefined): boolean => motion !== undefined && (motion.bodies.some((b) => b !== null) || motion.points !== undefined);

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

/** Bounds of what moves: its start, and its path as the first oracle tells it that keeps within reason. */
function bounds(run: Run, world: World, order: number[]): three.Box3 {
  const box = new three.Box3();
  const grow = (p: Vec3, r: number): void => {
    box.expandByPoint(new three.Vector3(p[0] - r, p[1] - r, p[2] - r));
    box.expandByPoint(new three.Vector3(p[0] + r, p[1] + r, p[2] + r));
  };
  const first = order.find((o) => answered(world.motions[o]));
  world.bodies.forEach((body, b) => {
    if (body.fixed) return;
    const r = reach(body.shape);
    grow(body.start.p, r);
    const track = first === undefined ? null : world.motions[first].bodies[b];
    if (!track) return;
    const c = run.channels(track);
    for (let i = 0; i < c[0].length; ++i) grow([c[0][i], c[1][i], c[2][i]], r);
  });
  const points = first === undefined ? undefined : world.motions[first].points;
  if (points) {
    const c = run.channels(points);
    for (let k = 0; k + 2 < c.length; k += 3) for (let i = 0; i < c[k].length; ++i) grow([c[k][i], c[k + 1][i], c[k + 2][i]], world.particles[k / 3]?.radius ?? 0);
  }
  if (box.isEmpty()) for (const body of world.bodies) grow(body.start.p, Math.max(reach(body.shape), 0.5));
  if (box.isEmpty()) grow([0, 0, 0], 1);
  return box;
}

/** The part of one engine in a world: its bodies, particles, cloths, joints and trails. */
interface Actor { group: three.Group; trails: three.Group; setPose(time: { sample: number; part: number }): void; restyle(how: "solid" | "ghost"): void; bodies: (three.Object3D | null)[] }

/** @param order the oracles, the most trusted first: the view fits the path of the first */
export function buildWorld(run: Run, world: World, order: number[]): WorldScene {
  const box = bounds(run, world, order);
  const middle = box.getCenter(new three.Vector3()).toArray() as Vec3;
  const radiusInMetres = Math.max(box.getSize(new three.Vector3()).length() / 2, 1e-9);
  const frame: Frame = { centre: middle, scale: 1 / radiusInMetres };
  const up = upOf(world);
  const dark = prefersDark();
  const root = new three.Group();

  const forms = new Map<string, Form>();
  const formFor = (b: number): Form => {
    const shape = world.bodies[b].shape;
    const key = JSON.stringify(shape);
    let form = forms.get(key);
    if (!form) forms.set(key, form = formOf(shape, frame.scale, 2.2));
    return form;
  };
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
  });

  const anchor = (bodies: (three.Object3D | null)[], balls: three.Object3D[], index: number, p: Vec3): three.Vector3 => {
    if (index < 0) return toScene(frame, p);
    if (index >= world.bodies.length) return balls[index - world.bodies.length]?.position.clone() ?? toScene(frame, p);
    const body = bodies[index];
    const start = world.bodies[index].start;
    const offset = new three.Vector3(...p).multiplyScalar(frame.scale);
    return body ? offset.applyQuaternion(body.quaternion).add(body.position) : offset.applyQuaternion(quaternion(start.q)).add(toScene(frame, start.p));
  };

  // If there are many ghosts, only their edges are drawn. Their faces are hardly visible and cost the most time.
  const crowded = world.bodies.filter((b) => !b.fixed).length * world.motions.filter(answered).length > 60;

  const makeActor = (oracle: number): Actor | null => {
    const motion = world.motions[oracle];
    if (!answered(motion)) return null;
    const colour = colourOf(run.looks[oracle]);
    const group = new three.Group();
    const trails = new three.Group();
    group.add(trails);
    const bodies = world.bodies.map((body, b) => {
      if (body.fixed || !motion.bodies[b]) return null;
      const object = solid(formFor(b), { colour, opacity: 0.2, edgeOpacity: 0.8 });
      group.add(object);
      return object;
    });
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
    tracks.forEach((c) => {
      if (!c || c[0].length < 2 || world.bodies.length * c[0].length > 60000) return;
      trails.add(path(Array.from(c[0], (_, i) => toScene(frame, [c[0][i], c[1][i], c[2][i]])), colour, 0.55));
    });
    return {
      group, trails, bodies,
      setPose(at) {
        tracks.forEach((c, b) => {
          const object = bodies[b];
          if (!c || !object) return;
          object.position.copy(toScene(frame, [mix(c[0], at), mix(c[1], at), mix(c[2], at)]));
          const last = c[0].length - 1;
          const [i, k] = [Math.min(at.sample, last), Math.min(at.sample + 1, last)];
          object.quaternion.set(c[4][i], c[5][i], c[6][i], c[3][i]).slerp(new three.Quaternion(c[4][k], c[5][k], c[6][k], c[3][k]), at.part).normalize();
        });
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
        for (const trail of trails.children) (trail as three.Line).geometry.setDrawRange(0, at.sample + 1);
      },
      restyle(how) {
        for (const object of bodies) {
          object?.traverse((part) => {
            const { material } = part as Partial<three.Mesh>;
            if (material instanceof three.MeshLambertMaterial) {
              part.visible = how === "solid" || !crowded;
              material.opacity = how === "solid" ? 1 : 0.1;
              if (material.transparent !== (how === "ghost")) {
                material.transparent = how === "ghost";
                material.needsUpdate = true;
              }
              material.depthWrite = how === "solid";
              // Where a ghost is at the same place, the solid is seen.
              material.polygonOffsetFactor = material.polygonOffsetUnits = how === "solid" ? 1 : 4;
            } else if (material instanceof three.LineBasicMaterial) {
              // The edges of a solid would not be seen on it in its own colour.
              part.renderOrder = how === "solid" ? 2 : 1;
              material.color.set(colour);
              if (how === "solid") material.color.lerp(new three.Color(material.color.getHSL({ h: 0, s: 0, l: 0 }).l > 0.5 ? "#000000" : "#ffffff"), 0.55);
            }
          });
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
      if (actor) { root.add(actor.group); actor.trails.visible = trailsShown; actor.setPose(sampleAt(world.times, time)); }
    }
    return actor;
  };
  let time = world.times[0] ?? 0;
  let trailsShown = true;
  let impulsesShown = true;
  let solidOracle = -1;
  let impulseSample = -1;
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
      // The length is the square root of the impulse, so that weak impulses next to an impact are visible.
      J.setLength(0.5 * Math.sqrt(size(i) / most));
      impulses.add(arrow(toScene(frame, [c[3][i], c[4][i], c[5][i]]), J, 0.006, colour));
      ++drawn;
    }
  };

  return {
    root, frame, up, radius: 1, centre: new three.Vector3(),
    setTime(now) {
      time = now;
      const at = sampleAt(world.times, now);
      for (const actor of actors.values()) if (actor?.group.visible) actor.setPose(at);
      drawImpulses(at.part > 0 ? at.sample + 1 : at.sample, false);
    },
    show(oracle, how) {
      if (how === "hidden") {
        const actor = actors.get(oracle);
        if (actor) actor.group.visible = false;
        return;
      }
      const actor = actorOf(oracle);
      if (how === "solid" && solidOracle !== oracle) { solidOracle = oracle; drawImpulses(impulseSample, true); }
      if (!actor) return;
      actor.group.visible = true;
      actor.restyle(how);
      actor.setPose(sampleAt(world.times, time));
    },
    showTrails(visible) {
      trailsShown = visible;
      for (const actor of actors.values()) if (actor) actor.trails.visible = visible;
    },
    showImpulses(visible) {
      impulsesShown = visible;
      drawImpulses(impulseSample, true);
    },
    mark(points) {
      for (const old of [...marks.children]) dispose(old);
      const colour = dark ? "#ff9ecf" : "#b3006b";
      markedPoints = points.map((p) => toScene(frame, p));
      marks.add(...markedPoints.map((p) => ball(p, 0.022, colour)), path(markedPoints, colour));
    },
    marked: (index) => markedPoints[index] ?? null,
    bodyAt: (oracle, body) => actors.get(oracle)?.bodies[body]?.position.clone() ?? toScene(frame, world.bodies[body]?.start.p ?? middle),
  };
}
