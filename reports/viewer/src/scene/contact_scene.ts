import * as three from "three";
import type { Answer, Contact, Placed, Vec3 } from "../data";
import { colourOf, prefersDark, type Look } from "../engines";
import { add, dot, isFinite3, middle, norm, rotate, sub, times, unit } from "../vector";
import { digits } from "../format";
import { makeCut } from "./section";
import { alignZ, arrow, ball, disc, dispose, hatched, planePatch, quaternion, rod, solid, spot, toScene, type Frame } from "./parts";
import { formOf } from "./shapes";
import { overlapAlong, reach } from "./support";

/** A moment of the animated proof: how far B has moved [m], and the gap between A and B [m], negative while they overlap. */
export interface ProofState { moved: number; gap: number; claimMoved?: number; claimGap?: number }

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
  /** Performs the proof up to `part`, from 0 to 1. */
  prove(part: number): ProofState;
  show(oracle: number, visible: boolean): void;
  /** Chooses the claimed direction that is performed beside the shortest: the oracle's normal, or `along`, the one of a variant of the question;
   * -1 for none. */
  explain(oracle: number, along?: Vec3): void;
  /** Marks the point that is in both bodies; null for none. */
  markCommon(p: Vec3 | null): void;
  /** Texts that stay at points of the drawing; null while there is nothing to name. */
  names: { text: string; at: () => three.Vector3 | null }[];
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
  // Beside something ten times its size, the small body is what the question is about.
  if (all.radius > 10 * reach(small.shape)) return { frame: { centre: small.p, scale: 1 / (4 * reach(small.shape)) }, all };
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
    certificate.add(ball(toScene(frame, truth.pA), 0.018, truthColour), ball(toScene(frame, truth.pB), 0.018, truthColour), plane);
  }

  const layers = contact.answers.map((answer, o) => {
    const layer = answer.status === "answered" ? answerParts(answer, contact, frame, looks[o]) : new three.Group();
    layer.visible = false;
    root.add(layer);
    return layer;
  });

  const home = bodies[1].position.clone();
  const common = spot(new three.Vector3(), 0.024, dark ? "#ff9ecf" : "#b3006b");
  common.visible = false;
  root.add(common);
  const variant = new three.Group();
  root.add(variant);
  let variantTip: three.Vector3 | null = null;
  const [a, b] = [truth.pA, truth.pB].map((p) => (plane && isFinite3(p) ? toScene(frame, p) : null));
  const isOne = a !== null && b !== null && a.distanceTo(b) < 0.03;
  const depth = -size;
  const apart = truth.touching === "apart";
  const opened = 0.12 / frame.scale;
  let claim: { n: Vec3; overlap: number; ghost: three.Group } | null = null;
  const rulers = new three.Group();
  root.add(rulers);

  const drawRuler = (along: Vec3, size: number, colour: string): void => {
    const start = toScene(frame, surface ?? touch);
    const way = new three.Vector3(...along).multiplyScalar(size * frame.scale);
    rulers.add(arrow(start, way, 0.011, colour));
  };

  return {
    root, frame, note, radius: 1, allRadius: all.radius * frame.scale, allCentre: toScene(frame, all.centre),
    A: () => (A.shape.type === "half_space" ? bodies[0].position.clone().add(new three.Vector3(1.2, 0, 0).applyQuaternion(bodies[0].quaternion)) : bodies[0].position),
    B: () => (B.shape.type === "half_space" ? bodies[1].position.clone().add(new three.Vector3(1.2, 0, 0).applyQuaternion(bodies[1].quaternion)) : bodies[1].position),
    provable: n !== null && Number.isFinite(depth),
    prove(part) {
      for (const ruler of [...rulers.children]) ruler.removeFromParent();
      if (!n || !Number.isFinite(depth)) return { moved: 0, gap: NaN };
      if (apart) {
        // The plane sweeps the gap from A to B: it touches both only at the ends.
        plane?.position.copy(toScene(frame, add(surface!, times(size * part, n))));
        return { moved: 0, gap: -depth };
      }
      // The certified depth first, then an opening that can be seen.
      const travel = (overlap: number): number => (Math.max(overlap, 0) + opened) * part;
      const moved = travel(depth);
      bodies[1].position.copy(home).addScaledVector(new three.Vector3(...n), moved * frame.scale);
      const state: ProofState = { moved, gap: -overlapAlong(A, { ...B, p: add(B.p, times(moved, n)) }, n) };
      if (part > 0) drawRuler(n, Math.min(moved, Math.max(depth, 0)), truthColour);
      if (claim) {
        const claimMoved = travel(claim.overlap);
        claim.ghost.visible = part > 0;
        claim.ghost.position.copy(home).addScaledVector(new three.Vector3(...claim.n), claimMoved * frame.scale);
        state.claimMoved = claimMoved;
        state.claimGap = -overlapAlong(A, { ...B, p: add(B.p, times(claimMoved, claim.n)) }, claim.n);
        if (part > 0) drawRuler(claim.n, Math.min(claimMoved, Math.max(claim.overlap, 0)), (claim.ghost.userData.colour as string));
      }
      return state;
    },
    show(oracle, visible) { layers[oracle].visible = visible; },
    names: [
      { text: isOne ? "a, b" : "a", at: () => a },
      { text: "b", at: () => (isOne ? null : b) },
      { text: "common point", at: () => (common.visible ? common.position : null) },
      { text: "n of the variant", at: () => variantTip },
    ],
    markCommon(p) {
      common.visible = p !== null;
      if (p) common.position.copy(toScene(frame, p));
    },
    explain(oracle, other) {
      claim?.ghost.removeFromParent();
      claim = null;
      for (const old of [...variant.children]) dispose(old);
      variantTip = null;
      if (hasNormal(other)) {
        const from = toScene(frame, touch);
        const way = new three.Vector3(...unit(other)).multiplyScalar(0.55);
        variantTip = from.clone().add(way);
        variant.add(arrow(from, way, 0.013, colourOf(looks[oracle])));
      }
      const said = other ?? contact.answers[oracle]?.n;
      if (!n || !hasNormal(said)) return;
      const along = unit(said);
      const overlap = overlapAlong(A, B, along);
      if (!Number.isFinite(overlap) || dot(along, n) > 1 - 1e-9) return;
      const ghost = place(B, frame);
      const colour = colourOf(looks[oracle]);
      ghost.userData.colour = colour;
      ghost.add(solid(formOf(B.shape, frame.scale, 1.5), { colour, opacity: 0.12, edgeOpacity: 0.8 }));
      ghost.visible = false;
      root.add(ghost);
      claim = { n: along, overlap, ghost };
    },
  };
}
