import type { Report } from "./data";

/** How bad a finding is, the gravest first. */
export const bands = ["crash", "grave", "large", "small", "rounding", "undecidable", "passed", "unasked"] as const;
export type Band = (typeof bands)[number];

export interface BandText { name: string; glyph: string; meaning: string }

export const bandTexts: Record<Band, BandText> = {
  crash: { name: "unusable", glyph: "✖", meaning: "no usable answer: a crash, a hang, a number that is not finite, or a contact that contradicts itself" },
  grave: { name: "grave", glyph: "◆", meaning: "wrong by over 10 % of the size, or a wrong hit or miss" },
  large: { name: "large", glyph: "▲", meaning: "wrong by over 0.1 % of the size" },
  small: { name: "small", glyph: "●", meaning: "wrong by over one millionth of the size" },
  rounding: { name: "rounding", glyph: "◦", meaning: "wrong by at most one millionth of the size" },
  undecidable: { name: "undecidable", glyph: "?", meaning: "no answer can be proved right or wrong" },
  passed: { name: "passed", glyph: "✓", meaning: "within the derived tolerance of the truth" },
  unasked: { name: "not asked", glyph: "–", meaning: "the oracle does not answer questions of this kind" },
};

/** The bands of faults. */
export const faultBands: readonly Band[] = ["crash", "grave", "large", "small", "rounding"];

const bandOfVerdict: Record<string, Band> = {
  pass: "passed", undecidable: "undecidable", unsupported: "unasked", "not asked": "unasked",
  crashed: "crash", "timed out": "crash", invalid: "crash",
};

/** The band of a grade, in the order of `enum class Grade`; none for grade 0, a fault without a size. */
const bandOfGrade: (Band | undefined)[] = [undefined, "rounding", "small", "large", "grave", "grave"];

const bandOfShare = (share: number): Band => share > 0.1 ? "grave" : share > 1e-3 ? "large" : share > 1e-6 ? "small" : "rounding";

/** @param silent whether the measure is that of having answered at all */
export function bandOf(verdict: string, grade: number, share: number, silent = false): Band {
  return bandOfVerdict[verdict] ?? (silent ? "crash" : bandOfGrade[grade] ?? bandOfShare(Math.abs(share)));
}

/** The measure of having answered. */
export const answering = "answering";

/** The band of each finding, as an index into `bands`. */
export function findBands(report: Report): Uint8Array {
  const { verdict, grade, share, measure } = report.findings;
  const silent = report.names.measure.map((m) => m.name === answering);
  return Uint8Array.from(verdict, (v, i) => bands.indexOf(bandOf(report.names.verdict[v] ?? "", grade[i], share[i] ?? 0, silent[measure[i]])));
}
