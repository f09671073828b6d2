import type { Report } from "./data";

/** How bad a finding is, the gravest first. */
export const bands = ["grave", "large", "small", "rounding", "undecidable", "passed", "unasked"] as const;
export type Band = (typeof bands)[number];

export interface BandText { name: string; glyph: string; meaning: string }

export const bandTexts: Record<Band, BandText> = {
  grave: { name: "grave", glyph: "◆", meaning: "wrong by over 10 % of the size, a wrong hit or miss, a crash, or no number" },
  large: { name: "large", glyph: "▲", meaning: "wrong by over 0.1 % of the size" },
  small: { name: "small", glyph: "●", meaning: "wrong by over one millionth of the size" },
  rounding: { name: "rounding", glyph: "◦", meaning: "wrong by at most one millionth of the size" },
  undecidable: { name: "undecidable", glyph: "?", meaning: "no answer can be proved right or wrong" },
  passed: { name: "passed", glyph: "✓", meaning: "within the derived tolerance of the truth" },
  unasked: { name: "not answered", glyph: "–", meaning: "the engine does not answer this question" },
};

/** The bands of faults. */
export const faultBands: readonly Band[] = ["grave", "large", "small", "rounding"];

const bandOfVerdict: Record<string, Band> = {
  pass: "passed", undecidable: "undecidable", unsupported: "unasked", "not asked": "unasked",
  crashed: "grave", "timed out": "grave", invalid: "grave",
};

/** The band of a grade, in the order of `enum class Grade`; none for grade 0, a fault without a size. */
const bandOfGrade: (Band | undefined)[] = [undefined, "rounding", "small", "large", "grave", "grave"];

const bandOfShare = (share: number): Band => share > 0.1 ? "grave" : share > 1e-3 ? "large" : share > 1e-6 ? "small" : "rounding";

export function bandOf(verdict: string, grade: number, share: number): Band {
  return bandOfVerdict[verdict] ?? bandOfGrade[grade] ?? bandOfShare(Math.abs(share));
}

/** The band of each finding, as an index into `bands`. */
export function findBands(report: Report): Uint8Array {
  const { verdict, grade, share } = report.findings;
  return Uint8Array.from(verdict, (v, i) => bands.indexOf(bandOf(report.names.verdict[v] ?? "", grade[i], share[i] ?? 0)));
}
