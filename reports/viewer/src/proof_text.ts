import { h, type Child } from "./dom";
import { withError, type ShownError } from "./error_in_proof";
import { shortest, verbatim } from "./proof_clause";
import { prose } from "./symbols";

/** Digits of a number in a sentence; a tooltip has all. */
const shownDigits = 6;

const number = "-?\\d+(?:\\.\\d+)?(?:e[+-]?\\d+)?";
const numberOrVector = new RegExp(`(\\(${number}(?:, ${number})+\\)|(?<![\\p{L}\\d_:/.])${number}(?![\\p{L}\\d_:/]))`, "iu");
const eachNumber = new RegExp(number, "gi");

/** Whether a number is written with more digits than a sentence needs. */
const isLong = (text: string): boolean => text.replace(/e.*$/i, "").replace(/^[-0.]+/, "").replace(/\D/g, "").length > shownDigits;

/** A part of a proof: as it is shown, and as the proof has it. */
export interface ProofPart {
  shown: string;
  whole: string;
}

/** A proof in parts: its numbers to six digits, or to as many as tell two of them apart.
 * @param whole the proof of which the text is a part */
export function proofParts(text: string, whole = text): ProofPart[] {
  const pieces = text.split(verbatim);
  const values = whole.split(verbatim).flatMap((piece, i) => (i % 2 === 0 ? piece.match(eachNumber) ?? [] : [])).map(Number);
  const rounded = (found: string): string => (isLong(found) ? shortest(Number(found), values, shownDigits) : found);
  return pieces.flatMap((piece, i) => (i % 2 === 1 ? [{ shown: piece, whole: piece }]
    : piece.split(numberOrVector).map((whole, j) => ({ shown: j % 2 === 1 ? whole.replace(eachNumber, rounded) : whole, whole }))));
}

/** A proof as prose; a tooltip has all digits of what is rounded.
 * @param error the error that it states, which is marked */
export function proofText(text: string, error: ShownError | null = null): Child[] {
  return withError(text, error, (part) => proofParts(part, text).map(({ shown, whole }) => (shown === whole ? prose(whole) : h("span", { class: "rounded", title: whole }, shown))));
}
