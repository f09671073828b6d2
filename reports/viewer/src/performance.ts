import type { Answer, Contact, Vec3 } from "./data";
import { spaced } from "./format";
import { contactVariant, type Proof } from "./proofs";
import { hasNormal } from "./scene/contact_scene";
import { overlapAlong, reach } from "./scene/support";
import { dot, unit } from "./vector";

/** A way of B that a proof speaks of, performed by a copy of B beside the certified shortest way out. */
export interface Path {
  /** Unit vector of the movement of B in the world frame. */
  along: Vec3;
  /** How far B moves [m]; negative towards A. */
  way: number;
  /** The way in words that follow "along" or "as far as". */
  words: string;
  /** The way on its arrow, where two are drawn. */
  short: string;
}

const middleOf = (lo: number, hi: number): number => lo / 2 + hi / 2;

/** Kinds of proofs about points, counts and the like: no movement of B shows them. */
const unmoved = new Set(["opposite", "deepest", "witnesses", "duality", "off surfaces", "too shallow", "surplus", "off patch", "unspanned", "count", "mixed normals", "variant touch"]);

/** The separation that an answer states [m], where it differs from the certified one; undefined where it does not. */
function wrongSeparation({ truth, A, B }: Contact, { separation, touching }: Partial<Answer>): number | undefined {
  if (truth.touching === "undecided" || touching === undefined || separation === undefined || !Number.isFinite(separation)) return undefined;
  const size = Math.min(...[A, B].map((body) => reach(body.shape)).filter((r) => r > 0 && Number.isFinite(r)));
  return Math.abs(separation - middleOf(truth.lo, truth.hi)) > 1e-9 * size ? (touching ? Math.min(separation, 0) : separation) : undefined;
}

/** The ways that show a proof, with exactly the lengths that it states. The certified one is not among them.
 * @param proof null if the proof has no numbers: the ways of the answer itself are then shown */
export function pathsOf(contact: Contact, answer: Answer | undefined, proof: Proof | null, name: string): Path[] {
  const { truth, A, B } = contact;
  if (!hasNormal(truth.n) || answer === undefined) return [];
  const n = unit(truth.n);
  const overlaps = truth.touching === "touching";
  const depth = overlapAlong(A, B, n);
  const path = (along: Vec3 | null | undefined, way: number, words: string, short: string): Path[] => {
    if (!hasNormal(along ?? undefined) || !Number.isFinite(way)) return [];
    const direction = unit(along!);
    // The certified way is performed anyway.
    return dot(direction, n) > 1 - 1e-9 && Math.abs(way - depth) <= 1e-9 * Math.abs(depth) ? [] : [{ along: direction, way, words, short }];
  };
  const variant = contactVariant(proof);
  if (variant && proof && overlaps) {
    const of = `its variant “${spaced(variant.name)}”`;
    if (proof.kind === "variant normal") {
      return [...path(proof.claimed ?? answer.n, proof.claimed ? proof.said : NaN, `the direction of ${name} (that of its answer)`, "answer"), ...path(proof.n, proof.bound, `the direction of ${name} (that of ${of})`, "variant")];
    }
    if (proof.kind === "variant separation") {
      return [...path(n, -proof.said, `the certified direction, as far as ${name} says in its answer`, "answer"), ...path(n, -proof.bound, `the certified direction, as far as ${name} says in ${of}`, "variant")];
    }
  }
  if (proof && unmoved.has(proof.kind)) return [];
  if (proof && overlaps && Number.isFinite(proof.said)) {
    if (proof.kind === "overlap") return path(proof.claimed, -proof.said, `the direction of ${name}, as far as it says`, "");
    if (proof.claim === "normal") return path(proof.claimed, -proof.said, `the direction of ${name} (that of its answer)`, "");
    if (proof.claim === "separation" || proof.claim === "contact") {
      const own = proof.said < 0 && proof.claimed ? proof.claimed : null;
      return path(own ?? n, -proof.said, own ? `the direction of ${name}, as deep as it says` : `the certified direction, as deep as ${name} says`, "");
    }
  }
  const separation = wrongSeparation(contact, answer);
  const isAcross = overlaps && answer.touching === true && hasNormal(answer.n) && dot(unit(answer.n), n) < 1 - 1e-6;
  if (separation !== undefined && !isAcross) return path(n, -separation, `the certified direction, as deep as ${name} says`, "");
  // Bodies that are apart are separated by many directions.
  return overlaps && hasNormal(answer.n) ? path(answer.n, overlapAlong(A, B, unit(answer.n)), `the direction of ${name} (that of its answer)`, "") : [];
}
