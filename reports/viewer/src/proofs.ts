import type { Report, Vec3 } from "./data";
import { digits, length } from "./format";
import { isFinite3, norm, sub } from "./vector";

/** The numbers of a proof. Lengths that it does not have are NaN [m]. */
export interface Proof {
  kind: string;
  claim: string;
  said: number;
  bound: number;
  /** The direction of the certificate, or the normal of a variant, mapped back. */
  n: Vec3 | null;
  /** n·x of the separating plane [m]. */
  offset: number;
  /** The normal that the answer claims. */
  claimed: Vec3 | null;
  points: Vec3[];
  /** How a variant differs: "swap: A and B exchanged". */
  change: string;
  body: string;
  time: number;
  /** The angle between the two places of a body [rad]. */
  angle: number;
}

/** The errors of a finding at the step of a world, a half and a quarter of it. */
export interface StepStudy { errors: [number, number, number]; unit: string }

const vectorOf = (v: unknown): Vec3 | null => (Array.isArray(v) && v.length === 3 && v.every((x) => typeof x === "number") && isFinite3(v as Vec3) ? (v as Vec3) : null);
const vectorsOf = (v: unknown): Vec3[] => (Array.isArray(v) ? v.map(vectorOf).filter((p) => p !== null) : []);
const lengthOf = (x: unknown): number => (typeof x === "number" ? x : NaN);

/** Returns the row of each finding in a table with a column of findings. */
function rowsOf(findings: number[] | undefined): Map<number, number> {
  return new Map((findings ?? []).map((finding, row) => [finding, row]));
}

/** Returns the function that looks the proof of a finding up; null if it is words alone, and in the data of runs that had no proofs. */
export function makeProofs(report: Report, text = (index: number): string => report.texts[index] ?? ""): (finding: number) => Proof | null {
  const { names } = report;
  let rows: Map<number, number> | undefined;
  return (finding) => {
    const { proofs } = report;
    const row = (rows ??= rowsOf(proofs?.finding)).get(finding);
    if (proofs === undefined || row === undefined) return null;
    return {
      kind: names.proof?.[proofs.kind?.[row]] ?? "", claim: names.claim?.[proofs.claim?.[row]] ?? "",
      said: lengthOf(proofs.said?.[row]), bound: lengthOf(proofs.bound?.[row]), offset: lengthOf(proofs.offset?.[row]), time: lengthOf(proofs.time?.[row]), angle: lengthOf(proofs.angle?.[row]),
      n: vectorOf(proofs.n?.[row]), claimed: vectorOf(proofs.claimed?.[row]),
      points: vectorsOf(proofs.points?.[row]),
      change: text(proofs.change?.[row] ?? -1), body: text(proofs.body?.[row] ?? -1),
    };
  };
}

/** The parts of a world that a proof names: bodies, as indices, and points [m]. */
export interface CitedParts { bodies: number[]; points: Vec3[] }

/** Returns the function that says of what kind the proof of a finding is; "" without one. It reads less than a proof. */
export function makeProofKinds(report: Report): (finding: number) => string {
  let rows: Map<number, number> | undefined;
  return (finding) => {
    const row = (rows ??= rowsOf(report.proofs?.finding)).get(finding);
    return row === undefined ? "" : report.names.proof?.[report.proofs?.kind?.[row] ?? -1] ?? "";
  };
}

/** Returns the function that looks up what the proof of a finding names; nothing in the data of programs that do not say it. */
export function makeCited(report: Report): (finding: number) => CitedParts {
  let rows: Map<number, number> | undefined;
  return (finding) => {
    const { cited } = report;
    const row = (rows ??= rowsOf(cited?.finding)).get(finding);
    const points: unknown = row === undefined ? [] : cited?.points?.[row];
    const bodies: unknown = row === undefined ? [] : cited?.bodies?.[row];
    return { bodies: Array.isArray(bodies) ? bodies.filter((b) => Number.isInteger(b)) : [], points: vectorsOf(points) };
  };
}

export function makeStudies(report: Report): (finding: number) => StepStudy | null {
  let rows: Map<number, number> | undefined;
  return (finding) => {
    const { studies } = report;
    const row = (rows ??= rowsOf(studies?.finding)).get(finding);
    const errors = row === undefined ? null : vectorOf(studies?.errors?.[row]);
    return errors && { errors, unit: studies?.unit?.[row!] ?? "" };
  };
}

/** The answer to a variant of a contact question, mapped back into the question itself: its normal, or else its separation. */
export interface ContactVariant { name: string; how: string; n: Vec3 | null; separation: number }

export function contactVariant(proof: Proof | null): ContactVariant | null {
  if (!proof?.kind.startsWith("variant")) return null;
  const colon = proof.change.indexOf(":");
  return {
    name: colon < 0 ? proof.change : proof.change.slice(0, colon), how: colon < 0 ? "" : proof.change.slice(colon + 1).trim(),
    n: proof.kind === "variant normal" ? proof.n : null, separation: proof.kind === "variant separation" ? proof.bound : NaN,
  };
}

/** The angle and the distance of the places of a proof, if most of its error, distance + angle × radius, is the angle: "176° and 3 cm". Nothing moves
 * by that error. Otherwise null. */
export function turnOf(proof: Proof | null, error: number): string | null {
  if (proof?.kind !== "places" || proof.points.length !== 2 || !(proof.angle > 0)) return null;
  const distance = norm(sub(proof.points[1], proof.points[0]));
  return error > 2 * distance ? `${digits((proof.angle * 180) / Math.PI)}° and ${length(distance)}` : null;
}

/** Where a body is in the world and in a variant of it, mapped back. */
export interface WorldVariant { time: number; body: string; own: Vec3; variant: Vec3 }

export function worldVariant(proof: Proof | null): WorldVariant | null {
  return proof?.kind === "places" && proof.points.length === 2 && Number.isFinite(proof.time)
    ? { time: proof.time, body: proof.body, own: proof.points[0], variant: proof.points[1] } : null;
}
