import type { Vec3 } from "./data";

/** The geometry that a proof states in its sentence. Points and directions there have all their digits (reports/contacts/proof.h), so that they
 * read back as the numbers of the program. */
const number = String.raw`-?\d+(?:\.\d+)?(?:e[-+]?\d+)?`;
const vector = String.raw`\((${number}), (${number}), (${number})\)`;
const variantPattern = new RegExp(String.raw`for its variant \((\w+)(?:: (.*?))?\), mapped back, it says n = ${vector}`);
const placesPattern = new RegExp(String.raw`at (${number}) s (.+?) is at ${vector} and ${vector}`);
const commonPattern = new RegExp(String.raw`the point ${vector} lies .* inside both`);

const vectorAt = (match: RegExpExecArray, first: number): Vec3 => [Number(match[first]), Number(match[first + 1]), Number(match[first + 2])];

/** The normal that an oracle states for a variant of the question, mapped back into the question itself. */
export interface ContactVariant { name: string; how: string; n: Vec3 }

export function contactVariant(proof: string): ContactVariant | null {
  const match = variantPattern.exec(proof);
  return match && { name: match[1], how: match[2] ?? "", n: vectorAt(match, 3) };
}

/** Where a body is in the world and in a variant of it, mapped back. */
export interface WorldVariant { time: number; body: string; own: Vec3; variant: Vec3 }

export function worldVariant(proof: string): WorldVariant | null {
  const match = placesPattern.exec(proof);
  return match && { time: Number(match[1]), body: match[2], own: vectorAt(match, 3), variant: vectorAt(match, 6) };
}

/** The point inside both bodies that proves that they touch. */
export function commonPoint(proof: string): Vec3 | null {
  const match = commonPattern.exec(proof);
  return match && vectorAt(match, 1);
}

const studyPattern = new RegExp(String.raw`(${number}), (${number}) and (${number})(?: \S+)? at the step, a half and a quarter of it: (.+)$`);

/** The error at the step of a world, a half and a quarter of it, and what follows of that. */
export interface StepStudy { errors: [number, number, number]; conclusion: string }

export function stepStudy(cause: string): StepStudy | null {
  const match = studyPattern.exec(cause);
  return match && { errors: [Number(match[1]), Number(match[2]), Number(match[3])], conclusion: match[4] };
}
