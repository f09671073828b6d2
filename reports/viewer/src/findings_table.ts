import { address, questionAddress } from "./address";
import { bands, sizeMeaning, verdictBefore } from "./bands";
import type { Question } from "./data";
import { h, type Child } from "./dom";
import { downloadCsv } from "./download";
import type { SortKey } from "./filter";
import { length, numberOf, quantity, ratio, share, spaced } from "./format";
import { lawName } from "./expectation";
import { marked, reasonOf } from "./matched";
import { variantWords } from "./proof_clause";
import type { Run } from "./run";
import { virtualList, type VirtualList } from "./virtual";
import { badgeOf, engine } from "./widgets";

export interface FindingsTable {
  element: HTMLElement;
  list: VirtualList;
  /** @param query the words that were searched for: rows mark them, and say where else a finding has them */
  set(found: number[], query?: string): void;
  dispose(): void;
}

const columns: { key: SortKey; name: string }[] = [
  { key: "severity", name: "Grade" }, { key: "question", name: "Question" }, { key: "oracle", name: "Oracle" },
  // Newtons, metres and radians have no common order: both columns are put in order by the share.
  { key: "measure", name: "Law or measure" }, { key: "share", name: "Error" }, { key: "share", name: "Share" },
];

/** Returns the measure of a finding, in words. */
export function measureOf(run: Run, finding: number): string {
  const { findings, names, questions } = run.report;
  const measure = spaced(names.measure[findings.measure[finding]]?.name ?? "");
  const law = lawName(questions[findings.question[finding]], run.text(findings.law[finding]));
  return law ? `${law}: ${measure}` : measure;
}

/** The verdicts on an oracle that gives no usable answer, in words. */
const silences: Record<string, string | undefined> = { crashed: "crashed", "timed out": "hung", invalid: "invalid" };

/** The words for a finding without a size: a crash, a hang, an invalid answer, a wrong hit or miss; "" for any other. */
export function wordsOf(run: Run, finding: number): string {
  const { findings, names, questions } = run.report;
  const silence = silences[verdictBefore(run.report, finding)];
  if (silence) return silence;
  if (names.measure[findings.measure[finding]]?.name !== "touching" || !(numberOf(findings.value[finding]) > 0)) return "";
  const isHit = questions[findings.question[finding]].contact?.truth.touching === "apart";
  // Nobody sees a hit that is missed by the last digits of its input.
  if (bands[run.band[finding]] === "rounding") return isHit ? "false hit, by a rounding" : "hit missed by a rounding";
  return isHit ? "false hit" : "missed hit";
}

/** The certified separation of a wrong hit or miss: its error [m]; NaN for any other finding. */
export function wrongTouchOf(run: Run, finding: number): number {
  const { findings: f, questions } = run.report;
  const isTouch = run.report.names.measure[f.measure[finding]]?.name === "touching" && /hit/.test(wordsOf(run, finding));
  return isTouch ? f.share[finding] * questions[f.question[finding]].size : NaN;
}

const headings: Record<string, (what: string) => string> = { crashed: (what) => `crashed on ${what}`, hung: (what) => `hung on ${what}`, invalid: (what) => `gave an invalid answer to ${what}` };

/** A finding as a heading: "separation error 4.8 cm", "crashed on this question". */
export function headingOf(run: Run, finding: number): string {
  const words = wordsOf(run, finding);
  if (words === "") return `${measureOf(run, finding)} ${valueOf(run, finding)}`;
  if (!(words in headings)) return valueOf(run, finding);
  const variant = variantWords[run.report.names.measure[run.report.findings.measure[finding]]?.name];
  return headings[words]?.(`this question${variant ? `, ${variant}` : ""}`) ?? words;
}

export const silentNouns: Record<string, string> = { crashed: "a crash", hung: "a hang", invalid: "an invalid answer" };

/** A finding as a noun: "separation error 4.8 cm", "a crash". */
export function nounOf(run: Run, finding: number): string {
  const words = wordsOf(run, finding);
  return words === "" ? headingOf(run, finding) : silentNouns[words] ?? `a ${valueOf(run, finding)}`;
}

/** The error of a finding, written in one way wherever it is read: "55 cm", "176° and 3 cm", "missed hit, 70 cm", "crashed". */
export function valueOf(run: Run, finding: number): string {
  const words = wordsOf(run, finding);
  const touch = wrongTouchOf(run, finding);
  if (words !== "") return touch > 0 ? `${words}, ${length(touch)}` : words;
  const turn = run.turn(finding);
  if (turn !== null) return turn;
  const { findings, names } = run.report;
  return quantity(findings.value[finding], names.measure[findings.measure[finding]]?.unit ?? "");
}

/** The body by whose size an error is divided, in words that follow "5 % of". */
export const sizedPartOf = ({ world }: Question): string =>
  !world ? "the smaller body" : world.bodies.some((body) => !body.fixed) ? "the smallest moving body" : "the extent of its points";

/** Whether the value of a finding is a length by which something is wrong. */
export function isLength(run: Run, finding: number): boolean {
  const { findings, names } = run.report;
  return names.measure[findings.measure[finding]]?.kind === "length" && wordsOf(run, finding) === "" && run.turn(finding) === null;
}

/** The scale of the errors of a world by their unit, in words that follow "5 % of": see reports/worlds/study/motion_scale.h. */
const wholes: Record<string, string | undefined> = {
  "m/s": "the greatest speed", "rad/s": "the greatest spin at that speed", "N s": "the momentum of all at the greatest speed", "N m s": "the angular momentum of all at the greatest speed",
  J: "the energy of all at the greatest speed", N: "the force that would stop all within the size", s: "the time for the size at the greatest speed", rad: "a radian", "": "one",
};

/** The scale of an error, in words that follow "5 % of"; "" where it has none. */
export function wholeOf(run: Run, finding: number): string {
  const { findings: f, names, questions } = run.report;
  const { unit } = names.measure[f.measure[finding]] ?? { unit: "" };
  if (unit === "m" || wrongTouchOf(run, finding) > 0) return sizedPartOf(questions[f.question[finding]]);
  return wordsOf(run, finding) === "" ? wholes[unit] ?? "" : "";
}

/** The error as a share of what it is divided by: "22 % of the energy of all at the greatest speed"; "" where it has none. */
export function shareInWords(run: Run, finding: number): string {
  const whole = wholeOf(run, finding);
  const { share: shares, measure } = run.report.findings;
  if (whole === "" || run.turn(finding) !== null || !(Math.abs(shares[finding]) > 0) || (run.report.names.measure[measure[finding]]?.unit ?? "") === "") return "";
  return share(shares[finding], whole);
}

/** The share without the words: "22 %". */
export const shareOf = (run: Run, finding: number): string => (shareInWords(run, finding) === "" ? "" : ratio(run.report.findings.share[finding]));

/** The address of a finding: its question, with its oracle and the finding explained, and a world just before the moment of the fault. */
export function findingAddress(run: Run, finding: number): string {
  const { findings, questions, oracles } = run.report;
  const question = questions[findings.question[finding]];
  return questionAddress(question.id, { o: oracles[findings.oracle[finding]].name, f: String(finding) });
}

export function downloadFindings(run: Run, found: number[]): void {
  const { findings: f, names, questions, oracles } = run.report;
  downloadCsv("findings.csv", [
    ["band", "verdict", "question", "oracle", "law", "measure", "value", "unit", "tolerance", "share of the size", "cause", "proof", "known because", "upstream"],
    ...found.map((i) => {
      const entry = run.report.ledger[f.ledger[i]];
      return [bands[run.band[i]], names.verdict[f.verdict[i]], questions[f.question[i]].id, oracles[f.oracle[i]].name, run.text(f.law[i]), names.measure[f.measure[i]].name,
        f.value[i], names.measure[f.measure[i]].unit, f.tolerance[i], f.share[i], names.cause[f.cause[i]] ?? "", run.text(f.proof[i]), entry?.reason ?? "", entry?.upstream ?? ""];
    }),
  ]);
}

/** The list of findings.
 * @param sortLink the address that sorts by a column, and how the list is sorted by it now; none if it cannot be sorted */
export function findingsTable(run: Run, sortLink?: (key: SortKey) => { href: string; sorted: "ascending" | "descending" | "none" }): FindingsTable {
  const { findings: f, questions, oracles } = run.report;
  let found: number[] = [];
  let words = "";
  const cell = (name: string, ...children: Child[]): HTMLElement => h("div", { role: "cell", class: name, title: children.every((c) => typeof c === "string") ? children.join("") : undefined }, children);
  const list = virtualList("rowgroup", () => (innerWidth < 760 ? 104 : 64) + (words === "" ? 0 : 38), (row) => {
    const i = found[row];
    const question = questions[f.question[i]];
    const [oracle, measure] = [oracles[f.oracle[i]].name, measureOf(run, i)];
    const reason = words === "" ? null : reasonOf(run, i, words, [question.title, question.id, oracle, measure]);
    return h("div", { role: "row", class: "finding" },
      cell("c-band", badgeOf(run, i)),
      cell("c-question", h("a", { href: findingAddress(run, i), class: "title", dir: "auto", title: question.title }, marked(question.title, words)), h("span", { class: "id", title: question.id }, marked(question.id, words)),
        reason && h("span", { class: "found", dir: "auto", title: reason.text }, h("b", {}, `${reason.name}: `), marked(reason.text, words))),
      cell("c-engine", engine(run, f.oracle[i], words)),
      h("div", { role: "cell", class: "c-measure", title: measure }, marked(measure, words)),
      cell("c-value number", valueOf(run, i)),
      h("div", { role: "cell", class: "c-share number", title: shareInWords(run, i) || undefined }, shareOf(run, i)));
  });
  const head = h("div", { role: "rowgroup", class: "head" });
  const drawHead = (): void => {
    head.replaceChildren(h("div", { role: "row", class: "finding" }, columns.map(({ key, name }, c) => {
      const sort = sortLink?.(key);
      return h("div", { role: "columnheader", class: c > 3 ? "number" : "", "aria-sort": c === 4 ? undefined : sort?.sorted },
        sort ? h("a", { href: sort.href, title: key === "share" ? `Sort by the share: errors in different units have no other order. ${sizeMeaning}` : `Sort by ${name.toLowerCase()}.` }, name, c === 4 ? "" : sort.sorted === "descending" ? " ▾" : sort.sorted === "ascending" ? " ▴" : "") : name);
    })));
  };
  const element = h("div", { role: "table", class: "findings-table", "aria-label": "Findings" }, head, list.element);
  return {
    element, list,
    set(next, query = "") {
      found = next;
      words = query;
      element.setAttribute("aria-rowcount", String(found.length + 1));
      drawHead();
      list.setCount(found.length);
    },
    dispose: () => list.dispose(),
  };
}

/** The address of the findings of a cell of the matrix or of a count. */
export const findingsAddress = (query: Record<string, string>): string => address(["findings"], query);
