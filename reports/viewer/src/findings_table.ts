import { address, questionAddress } from "./address";
import { answering, bands } from "./bands";
import { h, type Child } from "./dom";
import { downloadCsv } from "./download";
import type { SortKey } from "./filter";
import { numberOf, quantity, ratio, spaced } from "./format";
import type { Run } from "./run";
import { virtualList, type VirtualList } from "./virtual";
import { badge, engine } from "./widgets";

export interface FindingsTable {
  element: HTMLElement;
  list: VirtualList;
  set(found: number[]): void;
  dispose(): void;
}

const columns: { key: SortKey; name: string }[] = [
  { key: "gravity", name: "Band" }, { key: "question", name: "Question" }, { key: "oracle", name: "Oracle" },
  { key: "measure", name: "Law or measure" }, { key: "value", name: "Error" }, { key: "share", name: "Of the size" },
];

/** Returns the measure of a finding, in words. */
export function measureOf(run: Run, finding: number): string {
  const { findings, names } = run.report;
  const measure = spaced(names.measure[findings.measure[finding]]?.name ?? "");
  const law = spaced(run.text(findings.law[finding]));
  return law ? `${law}: ${measure}` : measure;
}

/** The words for a finding without a size: a crash, a hang, an invalid answer, a wrong hit or miss; "" for any other. */
export function wordsOf(run: Run, finding: number): string {
  const { findings, names, ledger, questions } = run.report;
  const measure = names.measure[findings.measure[finding]]?.name;
  if (!(numberOf(findings.value[finding]) > 0)) return "";
  if (measure === answering) {
    const verdict = names.verdict[findings.verdict[finding]];
    switch (verdict === "known" ? ledger[findings.ledger[finding]]?.verdict : verdict) {
      case "crashed": return "crashed";
      case "timed out": return "hung";
      case "invalid": return "invalid";
      default: return "no usable answer";
    }
  }
  if (measure !== "touching") return "";
  return questions[findings.question[finding]].contact?.truth.touching === "apart" ? "false hit" : "missed hit";
}

const headings: Record<string, string> = { crashed: "crashed on this question", hung: "hung on this question", invalid: "gave an invalid answer to this question" };

/** A finding as a heading: "separation error 4.8 cm", "crashed on this question". */
export function headingOf(run: Run, finding: number): string {
  const words = wordsOf(run, finding);
  return words === "" ? `${measureOf(run, finding)} ${valueOf(run, finding)}` : headings[words] ?? words;
}

export function valueOf(run: Run, finding: number): string {
  const words = wordsOf(run, finding);
  if (words !== "") return words;
  const { findings, names } = run.report;
  return quantity(findings.value[finding], names.measure[findings.measure[finding]]?.unit ?? "");
}

/** The share of the size, where the measure is a length. */
export function shareOf(run: Run, finding: number): string {
  const { findings, names } = run.report;
  return names.measure[findings.measure[finding]]?.kind === "length" ? ratio(findings.share[finding]) : "";
}

/** The address of a finding: its question, with its oracle explained, and a world just before the moment of the fault. */
export function findingAddress(run: Run, finding: number): string {
  const { findings, questions, oracles } = run.report;
  const question = questions[findings.question[finding]];
  return questionAddress(question.id, { o: oracles[findings.oracle[finding]].name, f: question.world ? String(finding) : "" });
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
  const { findings: f, questions } = run.report;
  let found: number[] = [];
  const cell = (name: string, ...children: Child[]): HTMLElement => h("div", { role: "cell", class: name, title: children.every((c) => typeof c === "string") ? children.join("") : undefined }, children);
  const list = virtualList("rowgroup", () => (innerWidth < 760 ? 104 : 64), (row) => {
    const i = found[row];
    const question = questions[f.question[i]];
    return h("div", { role: "row", class: "finding" },
      cell("c-band", badge(bands[run.band[i]])),
      cell("c-question", h("a", { href: findingAddress(run, i), class: "title", dir: "auto", title: question.title }, question.title), h("span", { class: "id", title: question.id }, question.id)),
      cell("c-engine", engine(run, f.oracle[i])),
      cell("c-measure", measureOf(run, i)),
      cell("c-value number", valueOf(run, i)),
      cell("c-share number", shareOf(run, i)));
  });
  const head = h("div", { role: "rowgroup", class: "head" });
  const drawHead = (): void => {
    head.replaceChildren(h("div", { role: "row", class: "finding" }, columns.map(({ key, name }, c) => {
      const sort = sortLink?.(key);
      return h("div", { role: "columnheader", class: c > 3 ? "number" : "", "aria-sort": sort?.sorted },
        sort ? h("a", { href: sort.href, title: `Sort by ${name.toLowerCase()}` }, name, sort.sorted === "descending" ? " ▾" : sort.sorted === "ascending" ? " ▴" : "") : name);
    })));
  };
  const element = h("div", { role: "table", class: "findings-table", "aria-label": "Findings" }, head, list.element);
  return {
    element, list,
    set(next) {
      found = next;
      element.setAttribute("aria-rowcount", String(found.length + 1));
      drawHead();
      list.setCount(found.length);
    },
    dispose: () => list.dispose(),
  };
}

/** The address of the findings of a cell of the matrix or of a count. */
export const findingsAddress = (query: Record<string, string>): string => address(["findings"], query);
