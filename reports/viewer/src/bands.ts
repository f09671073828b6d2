import type { Report } from "./data";

/** How bad a finding is, the gravest first: the grades of a fault (`enum class Grade`), then what is none. */
export const bands = ["crash", "touch", "grave", "large", "small", "rounding", "undecidable", "passed", "unasked"] as const;
export type Band = (typeof bands)[number];

export interface BandText { name: string; glyph: string; meaning: string }

export const bandTexts: Record<Band, BandText> = {
  crash: { name: "unusable", glyph: "✖", meaning: "a crash, a hang, a number that is not finite, or a contact that contradicts itself" },
  touch: { name: "wrong hit or miss", glyph: "◈", meaning: "bodies that touch called apart or the reverse, beyond rounding, or a body that passes through another" },
  grave: { name: "over 10 %", glyph: "◆", meaning: "wrong by over 10 % of the size" },
  large: { name: "over 0.001", glyph: "▲", meaning: "wrong by over 0.1 % of the size" },
  small: { name: "over 1e-6", glyph: "●", meaning: "wrong by over one millionth of the size" },
  rounding: { name: "rounding", glyph: "◦", meaning: "wrong by at most one millionth of the size, a hit that is missed by that little included" },
  undecidable: { name: "undecidable", glyph: "?", meaning: "no answer can be proved right or wrong" },
  passed: { name: "passed", glyph: "✓", meaning: "within the derived tolerance of the truth" },
  unasked: { name: "unsupported", glyph: "–", meaning: "the oracle does not answer such a question: it says so, or is never asked questions of this kind" },
};

/** What "the size" is wherever errors are compared with it. */
export const sizeMeaning = "The size of a length is the extent of the smaller body of a contact question, or of the smallest moving body of a world. A speed (m/s) is compared with V, the greatest speed of its motion or what its load gives a body over its size; an energy (J) with ½ M V², M all that moves; a momentum (N s) with M V; an angular momentum (N m s) with M V × the size; a spin with V / the size; angles (rad) with one radian; numbers without a unit with one.";

/** The bands of faults. */
export const faultBands: readonly Band[] = ["crash", "touch", "grave", "large", "small", "rounding"];

/** The bands of verdicts that need no grade. */
const bandOfVerdict: Record<string, Band> = { pass: "passed", undecidable: "undecidable", unsupported: "unasked", "not asked": "unasked", crashed: "crash", "timed out": "crash" };

/** The band of a grade, in the order of `enum class Grade`. Older programs had no grade for some faults without a size. */
const bandOfGrade: Band[] = ["large", "rounding", "small", "large", "grave", "touch", "crash"];

/** An invalid answer is unusable, unless it has the size of a normal that is not of unit length. */
export const bandOf = (verdict: string, grade: number): Band => bandOfVerdict[verdict] ?? (verdict === "invalid" && (grade === 0 || grade > 4) ? "crash" : bandOfGrade[grade] ?? "crash");

/** The same, by the name of the grade. */
export const bandOfNamed = (verdict: string, grade: string): Band => bandOfVerdict[verdict] ?? faultBands.find((band) => bandTexts[band].name === grade) ?? "crash";

/** The verdict of a finding without the ledger: a crash that an entry excuses is one. */
export function verdictBefore({ findings, names, ledger }: Report, finding: number): string {
  const verdict = names.verdict[findings.verdict[finding]] ?? "";
  return verdict === "known" ? ledger[findings.ledger[finding]]?.verdict ?? verdict : verdict;
}

/** The band of each finding, as an index into `bands`. */
export function findBands(report: Report): Uint8Array {
  return Uint8Array.from(report.findings.grade, (grade, i) => bands.indexOf(bandOf(verdictBefore(report, i), grade)));
}
