import { h, type Child } from "./dom";
import { valueOf, wrongTouchOf } from "./findings_table";
import { length, numberOf } from "./format";
import type { Run } from "./run";

/** The error of a finding: its number in the unit of its measure, and as it is written wherever it is read. */
export interface ShownError { value: number; unit: string; shown: string }

/** The error that the proof of a finding may state; null for a crash and the like. */
export function errorOf(run: Run, finding: number): ShownError | null {
  const { findings: f, names } = run.report;
  const touch = wrongTouchOf(run, finding);
  if (touch > 0) return { value: touch, unit: "m", shown: length(touch) };
  const { unit } = names.measure[f.measure[finding]] ?? { unit: "" };
  const value = numberOf(f.value[finding]);
  return unit === "" || !(value > 0) || !Number.isFinite(value) ? null : { value, unit, shown: valueOf(run, finding) };
}

/** Proofs write differences with three digits. */
const alike = 6e-3;

/** A text in three parts, of which the second is the number of an error with its unit; the last that it has. Null if it has none. */
export function splitAtError(text: string, { value, unit }: Pick<ShownError, "value" | "unit">): [string, string, string] | null {
  const numbers = new RegExp(`(?<![\\p{L}\\d_:/.(-])\\d+(?:\\.\\d+)?(?:e[+-]?\\d+)? ${unit.replace("/", "\\/")}(?![\\p{L}\\d/])`, "giu");
  const found = [...text.matchAll(numbers)].filter((match) => Math.abs(parseFloat(match[0]) - value) <= alike * value).at(-1);
  return found ? [text.slice(0, found.index), found[0], text.slice(found.index + found[0].length)] : null;
}

/** A text with its error marked, and written as elsewhere.
 * @param rest makes the other parts */
export function withError(text: string, error: ShownError | null, rest: (part: string) => Child): Child[] {
  const parts = error && splitAtError(text, error);
  return parts ? [rest(parts[0]), h("b", { class: "error-value", title: `The error: ${parts[1]}` }, error.shown), rest(parts[2])] : [rest(text)];
}
