import * as three from "three";
import type { Answer, Contact, Placed, Vec3 } from "../data";
import { colourOf, prefersDark, type Look } from "../engines";
import { across, add, dot, isFinite3, middle, norm, rotate, sub, times, unit } from "../vector";
import { digits, length, precise } from "../format";
import type { Path } from "../performance";
import { makeCut } from "./section";
import { alignZ, arrow, ball, disc, dispose, hatched, planePatch, quaternion, rod, solid, spot, toScene, type Frame } from "./parts";
import { formOf } from "./shapes";
import { overlapAlong, reach, support } from "./support";

/** A copy of B in a moment of the animated proof: how far it has moved, how far the proof says that it moves, and the gap between A and the copy along
 * its direction, negative while they overlap [m]. */
export interface PathState { along: Vec3; moved: number; whole: number; gap: number }

/** A moment of the animated proof: how far B has moved along the certified normal [m], and the gap between A and B [m], negative while they overlap;
 * and the copies of B that move as an oracle says. */
export interface ProofState { moved: number; gap: number; paths: PathState[] }

export interface ContactScene {
  root: three.Group;
  frame: Frame;
  /** A remark on the drawing for the reader; usually empty. */
  note: string;
  /** Radius of what is worth seeing, in units of the scene. */
  radius: number;
  /** The ball around all of both bodies, in the scene. */
  allCentre: three.Vector3;
  allRadius: number;
  /** Where A and B are, for their labels. */
  A: () => three.Vector3;
  B: () => three.Vector3;
  /** Whether there is a certificate that can be performed. */
  provable: boolean;
  /** Radius, in units of the scene, of what is worth seeing while the proof is performed: B where it ends too, unless that is very far. */
  radiusOfProof(): number;
  /** Performs the proof up to `part`, from 0 to 1. */
  prove(part: number): ProofState;
  show(oracle: number, visible: boolean): void;
  /** Chooses the ways that copies of B take beside the certified one, in the colour of an oracle; -1 for none.
   * @param variant the normal of a variant of the question, mapped back, which is drawn */
  explain(oracle: number, paths: readonly Path[], variant?: Vec3): void;
  /** Marks at most two points that the proof is about. */
  markPoints(points: Vec3[], name: "common point" | "point of the proof"): void;
  /** Texts that stay at points of the drawing; null while there is nothing to name. */
  names: { text: string | (() => string); at: () => three.Vector3 | null }[];
}

/** Reach of a body, in units of the scene, beyond which single precision does not draw it well. */
const tooLarge = 400;

export const hasNormal = (n: Vec3 | undefined): n is Vec3 => n !== undefined && isFinite3(n) && norm(n) > 0.5;

/** The contact: a point midway between the surfaces where they are nearest along n. The certificate's points do not tell it alone, because
 * they may be any corner of a face. The right candidate is the one at which a line along n leaves A and enters B. */
export function contactCentre({ A, B, truth }: Contact): Vec3 {
  const away = A.shape.type === "half_space" ? B.p : B.shape.type === "half_space" ? A.p : middle(A.p, B.p);
  if (!isFinite3(truth.pA) || !isFinite3(truth.pB) || !hasNormal(truth.n)) return away;
  const n = unit(truth.n);
  const s = -overlapAlong(A, B, n);
  if (!Number.isFinite(s)) return away;
  const corners = truth.patch.filter(isFinite3);
  const candidates = [
    ...(corners.length ? [corners.reduce<Vec3>((sum, p) => add(sum, times(1 / corners.length, p)), [0, 0, 0])] : []),
    add(truth.pA, times(s / 2, n)), sub(truth.pB, times(s / 2, n)), middle(truth.pA, truth.pB),
  ];
  const small = B.shape.type === "half_space" || (A.shape.type !== "half_space" && reach(A.shape) < reach(B.shape)) ? A : B;
  const miss = (candidate: Vec3): number => {
    // A corner is on the boundary, where rounding decides whether a line meets the body: a little further in it does.
    const c = add(candidate, times(1e-3, sub(small.p, candidate)));
    const [a, b] = [makeCut(A, c, n)([0, 0, 0]), makeCut(B, c, n)([0, 0, 0])];
    return a && b ? Math.abs(a[1] + s / 2) + Math.abs(b[0] - s / 2) : Infinity;
  };
  const misses = candidates.map(miss);
  return candidates[misses.indexOf(Math.min(...misses))];
}

function chooseFrame(contact: Contact): { frame: Frame; all: { centre: Vec3; radius: number } } {
  const finite = [contact.A, contact.B].filter((b) => b.shape.type !== "half_space").sort((a, b) => reach(a.shape) - reach(b.shape));
  const around = (centre: Vec3, bodies: Placed[]): number => Math.max(...bodies.map((b) => norm(sub(b.p, centre)) + reach(b.shape)));
  const middleOfAll = contactCentre(contact);
  const all = { centre: middleOfAll, radius: around(middleOfAll, finite) };
  const small = finite[0];
  const gap = contact.truth.touching === "apart" && Number.isFinite(contact.truth.lo) ? contact.truth.lo : 0;
  if (all.radius > 10 * reach(small.shape) && gap > reach(small.shape)) return { frame: { centre: middleOfAll, scale: 1 / (gap / 2 + 2.5 * reach(small.shape)) }, all };
  // Beside something twenty times its size, the small body is what the question is about.
  if (all.radius > 20 * reach(small.shape)) return { frame: { centre: small.p, scale: 1 / (4 * reach(small.shape)) }, all };
  return { frame: { centre: middleOfAll, scale: 1 / all.radius }, all };
}

/** The place of a body in the scene. A half-space is shown as the patch of its face that is nearest to the centre. */
function place(body: Placed, { centre, scale }: Frame): three.Group {
  const group = new three.Group();
  let at = body.p;
  if (body.shape.type === "half_space") {
    const n = rotate(body.q, [0, 0, 1]);
    at = sub(centre, times(dot(n, sub(centre, body.p)), n));
  }
  group.position.copy(toScene({ centre, scale }, at));
  group.quaternion.copy(quaternion(body.q));
  return group;
}

function answerParts(answer: Answer, contact: Contact, frame: Frame, look: Look): three.Group {
  const group = new three.Group();
  const colour = colourOf(look);
  const points = (answer.points ?? []).filter((point) => isFinite3(point.p));
  const n0 = hasNormal(answer.n) ? unit(answer.n) : undefined;
  for (const { p, s, n } of points) {
    const along = hasNormal(n) ? unit(n) : n0 ?? contact.truth.n;
    if (!hasNormal(along)) continue;
    const at = toScene(frame, p);
    const half = new three.Vector3(...along).multiplyScalar((Number.isFinite(s) ? Math.max(-1, Math.min(1, s * frame.scale)) : 0) / 2);
    group.add(disc(at, along, 0.028, look, colour), rod(at.clone().sub(half), at.clone().add(half), 0.005, colour));
  }
  if (n0) {
    const from = points.length ? points.reduce<Vec3>((sum, { p }) => add(sum, times(1 / points.length, p)), [0, 0, 0])
      : answer.witnesses ? middle(...answer.witnesses) : contactCentre(contact);
    if (isFinite3(from)) group.add(arrow(toScene(frame, from), new three.Vector3(...n0).multiplyScalar(0.42), 0.008, colour));
  }
  for (const w of answer.witnesses ?? []) if (isFinite3(w)) group.add(ball(toScene(frame, w), 0.014, colour));
  return group;
}

export function buildContact(contact: Contact, looks: Look[]): ContactScene {
  const { A, B, truth } = contact;
  const { frame, all } = chooseFrame(contact);
  const dark = prefersDark();
  const root = new three.Group();
  const n = hasNormal(truth.n) ? unit(truth.n) : null;
  const touch = contactCentre(contact);
  const size = n ? -overlapAlong(A, B, n) : NaN;
  // Where a line along n through the contact leaves A.
  const surface = n && Number.isFinite(size) ? sub(touch, times(size / 2, n)) : null;
  let note = "";
  const bodies = [A, B].map((body, i) => {
    let group = place(body, frame);
    let { shape } = body;
    if (n && surface && shape.type !== "half_space" && reach(shape) * frame.scale > tooLarge) {
      // Single precision has no digits left for its corners: the plane that touches it stands for it.
      group = new three.Group();
      group.position.copy(toScene(frame, i === 0 ? surface : add(surface, times(size, n))));
      alignZ(group, i === 0 ? n : times(-1, n));
      shape = { type: "half_space" };
      note = `${i === 0 ? "A" : "B"} is ${digits(reach(body.shape) * frame.scale, 1)} times larger than this view: its surface here is drawn as a plane.`;
    }
    const colour = i === 0 ? (dark ? "#7f93b8" : "#8fa3c9") : (dark ? "#b59a74" : "#cbb38c");
    const edge = i === 0 ? (dark ? "#b9c8e6" : "#3d5179") : (dark ? "#e3cda9" : "#73572a");
    group.add(solid(formOf(shape, frame.scale, 1.5), { colour, edge, opacity: shape.type === "half_space" ? 0.22 : 0.36, edgeOpacity: shape.type === "half_space" ? 0.35 : 0.85 }));
    root.add(group);
    return group;
  });
  const truthColour = dark ? "#f5f5f5" : "#111111";
  const certificate = new three.Group();
  root.add(certificate);
  if (n && truth.patch.length > 1) certificate.add(hatched(truth.patch.map((p) => toScene(frame, p)), n, truthColour, 0.05));
  const plane = n && surface && isFinite3(truth.pA) ? planePatch(toScene(frame, surface), n, 0.6, dark ? "#ff9ecf" : "#b3006b") : null;
  if (n && plane && isFinite3(truth.pB)) {
    certificate.add(ball(toScene(frame, truth.pA), 0.018, truthColour), plane);
  }
  // The extreme point b belongs to B and moves with it.
  const dotB = n && plane && isFinite3(truth.pB) ? ball(toScene(frame, truth.pB), 0.018, truthColour) : null;
  if (dotB) certificate.add(dotB);

  const layers = contact.answers.map((answer, o) => {
    const layer = answer.status === "answered" ? answerParts(answer, contact, frame, looks[o]) : new three.Group();
    layer.visible = false;
    root.add(layer);
    return layer;
  });

  const home = bodies[1].position.clone();
  const spots = [0, 1].map(() => spot(new three.Vector3(), 0.024, dark ? "#ff9ecf" : "#b3006b"));
  for (const mark of spots) mark.visible = false;
  root.add(...spots);
  let nameOfSpots = "";
  const spotNamed = (name: string, i: number): three.Vector3 | null => (spots[i].visible && nameOfSpots === name ? spots[i].position : null);
  const variant = new three.Group();
  root.add(variant);
  let variantTip: three.Vector3 | null = null;
  const a = dotB ? toScene(frame, truth.pA) : null;
  const homeOfB = dotB?.position.clone();
  const isOne = (): boolean => a !== null && dotB !== null && a.distanceTo(dotB.position) < 0.03;
  const depth = -size;
  const apart = truth.touching === "apart";
  interface Claim extends Path {
    ghost: three.Group;
    /** The way as far as it is seen [m]: the arrow of a longer one is broken, and says its length. A copy that comes nearer stays in sight. */
    shown: number;
  }
  let claims: Claim[] = [];
  const rulers = new three.Group();
  root.add(rulers);
  /** Lengths on the arrows. */
  const mostWritten = 5;
  let written: { text: string; at: three.Vector3 }[] = [];
  /** Units of the scene beyond which an arrow is broken, and where a broken one ends. */
  const [mostDrawn, brokenEnd] = [2.5, 1.15];
  const isBroken = (way: number): boolean => way * frame.scale > mostDrawn;
  const drawnWay = (way: number): number => (isBroken(way) ? brokenEnd / frame.scale : Math.max(-1 / frame.scale, way));

  /** Draws an arrow of a length along a direction, from a point, and writes a text on it. A broken one has two strokes across it. */
  const drawRuler = (start: three.Vector3, along: Vec3, size: number, colour: string, text: string, thickness = 0.011, broken = false): three.Vector3 => {
    const way = new three.Vector3(...along).multiplyScalar(size * frame.scale);
    if (broken && way.length() > 0.2) {
      const side = new three.Vector3(...across(along)).multiplyScalar(0.05);
      const place = (part: number): three.Vector3 => start.clone().addScaledVector(way, part);
      rulers.add(rod(start, place(0.56), thickness, colour), arrow(place(0.62), way.clone().multiplyScalar(0.38), thickness, colour));
      for (const part of [0.56, 0.62]) {
        const tilt = way.clone().setLength(0.02);
        rulers.add(rod(place(part).add(side).add(tilt), place(part).sub(side).sub(tilt), thickness * 0.7, colour));
      }
    } else rulers.add(arrow(start, way, thickness, colour));
    if (text !== "" && written.length < mostWritten) written.push({ text, at: start.clone().addScaledVector(way, 0.5) });
    return start.clone().add(way);
  };

  /** The name of a body is midway between its middle and its end away from the other: away from the contact, where there is much to name. */
  const nameAt = (i: number): three.Vector3 => {
    const body = contact[i === 0 ? "A" : "B"];
    const at = bodies[i].position.clone();
    if (body.shape.type === "half_space") return at.add(new three.Vector3(1.2, 0, 0).applyQuaternion(bodies[i].quaternion));
    const away = n && times(i === 0 ? -1 : 1, n);
    const end = away && reach(body.shape) * frame.scale < 2 ? support(body, away) : null;
    return end && away ? at.addScaledVector(new three.Vector3(...away), 0.6 * dot(away, sub(end, body.p)) * frame.scale) : at;
  };

  return {
    root, frame, note, radius: 1, allRadius: all.radius * frame.scale, allCentre: toScene(frame, all.centre),
    A: () => nameAt(0), B: () => nameAt(1),
    provable: n !== null && Number.isFinite(depth),
    radiusOfProof() {
      const radius = reach(B.shape) * frame.scale;
      if (!n || apart || !Number.isFinite(depth) || !(radius < 2)) return 1;
      const ends = [[n, Math.max(depth, 0)] as const, ...claims.map(({ along, shown }) => [along, shown] as const)];
      return Math.min(3, Math.max(1, ...ends.map(([along, way]) => home.clone().addScaledVector(new three.Vector3(...along), way * frame.scale).length() + radius)));
    },
    prove(part) {
      for (const ruler of [...rulers.children]) dispose(ruler);
      written = [];
      if (!n || !Number.isFinite(depth)) return { moved: 0, gap: NaN, paths: [] };
      // The plane sweeps the gap from A to B: it touches both only at the ends.
      if (apart) plane?.position.copy(toScene(frame, add(surface!, times(size * part, n))));
      // B stops where it just touches A: the proof is about this length.
      const moved = apart ? 0 : Math.max(depth, 0) * part;
      const shift = new three.Vector3(...n).multiplyScalar(moved * frame.scale);
      bodies[1].position.copy(home).add(shift);
      if (dotB) dotB.position.copy(homeOfB!).add(shift);
      const start = toScene(frame, surface ?? touch);
      if (part > 0 && moved > 0) drawRuler(start, n, moved, truthColour, precise(moved));
      const paths = claims.map(({ along, way, short, shown, ghost }): PathState => {
        const seen = shown * part;
        const state: PathState = { along, moved: isBroken(way) ? way * part : seen, whole: way, gap: NaN };
        state.gap = -overlapAlong(A, { ...B, p: add(B.p, times(state.moved, along)) }, along);
        ghost.visible = part > 0 && way !== 0;
        ghost.position.copy(home).addScaledVector(new three.Vector3(...along), seen * frame.scale);
        const colour = ghost.userData.colour as string;
        const name = short === "" ? "" : `${short}: `;
        if (part > 0) {
          // Whatever comes nearer starts at B, which is beyond the gap.
          const from = way < 0 && surface && n ? toScene(frame, add(surface, times(-depth, n))) : start;
          const tip = drawRuler(from, along, seen, colour, way === 0 ? "" : `${name}${precise(state.moved)}`, 0.011, isBroken(way));
          // The overlap that is left at the end of the way.
          const left = -state.gap;
          if (part === 1 && way >= 0 && left > touchingWithin(way)) drawRuler(tip, along, drawnWay(left), colour, `${length(left)} left`, 0.005, isBroken(left));
        }
        return state;
      });
      return { moved, gap: -overlapAlong(A, { ...B, p: add(B.p, times(moved, n)) }, n), paths };
    },
    show(oracle, visible) { layers[oracle].visible = visible; },
    names: [
      { text: "a, b", at: () => (isOne() ? a : null) },
      { text: "a", at: () => (isOne() ? null : a) },
      { text: "b", at: () => (isOne() ? null : dotB?.position ?? null) },
      { text: "common point", at: () => spotNamed("common point", 0) },
      ...spots.map((_, i) => ({ text: "point of the proof", at: () => spotNamed("point of the proof", i) })),
      { text: "n of the variant", at: () => variantTip },
      ...Array.from({ length: mostWritten }, (_, i) => ({ text: () => written[i]?.text ?? "", at: () => written[i]?.at ?? null })),
    ],
    markPoints(points, name) {
      nameOfSpots = name;
      spots.forEach((mark, i) => {
        mark.visible = points[i] !== undefined;
        if (mark.visible) mark.position.copy(toScene(frame, points[i]));
      });
    },
    explain(oracle, paths, variantNormal) {
      for (const { ghost } of claims) dispose(ghost);
      for (const old of [...variant.children]) dispose(old);
      variantTip = null;
      if (hasNormal(variantNormal)) {
        const from = toScene(frame, touch);
        const way = new three.Vector3(...unit(variantNormal)).multiplyScalar(0.55);
        variantTip = from.clone().add(way);
        variant.add(arrow(from, way, 0.013, colourOf(looks[oracle])));
      }
      claims = !n ? [] : paths.map((path) => {
        const ghost = place(B, frame);
        const colour = colourOf(looks[oracle]);
        ghost.userData.colour = colour;
        ghost.add(solid(formOf(B.shape, frame.scale, 1.5), { colour, opacity: 0.12, edgeOpacity: 0.8 }));
        ghost.visible = false;
        root.add(ghost);
        return { ...path, ghost, shown: drawnWay(path.way) };
      });
    },
  };
}

/** The largest gap or overlap after a way of a length that is its rounding [m]. */
export const touchingWithin = (way: number): number => 1e-6 * Math.abs(way);
