import { questionAddress, address, valuesOf, toggled } from "../address";
import type { Report } from "../data";
import { fill, h } from "../dom";
import { downloadCsv } from "../download";
import { counted, quantity, spaced } from "../format";
import type { MakeView } from "../view";
import { virtualList } from "../virtual";
import { button } from "../widgets";
import { notFound } from "./not_found";

type ComparedRow = NonNullable<Report["compare"]>["rows"][number];

const kinds: { kind: ComparedRow["kind"]; glyph: string; band: string }[] = [
  { kind: "worse", glyph: "▲", band: "grave" }, { kind: "no longer judged", glyph: "?", band: "undecidable" }, { kind: "new", glyph: "◆", band: "large" }, { kind: "better", glyph: "▼", band: "passed" }, { kind: "gone", glyph: "–", band: "unasked" },
];

export const compareView: MakeView = (run, at) => {
  const { compare } = run.report;
  if (!compare) return notFound("There is no comparison of two runs");
  let query = at.query;
  let shown: ComparedRow[] = [];
  const said = (value: number | string | null, unit: string): string => (value === null ? "not measured" : quantity(value, unit));
  const list = virtualList("rowgroup", () => (innerWidth < 760 ? 88 : 46), (i) => {
    const row = shown[i];
    const kind = kinds.find((k) => k.kind === row.kind)!;
    return h("div", { role: "row", class: "finding" },
      h("div", { role: "cell", class: "c-band" }, h("span", { class: `badge ${kind.band}` }, h("span", { "aria-hidden": "true" }, kind.glyph), ` ${row.kind}`)),
      h("div", { role: "cell", class: "c-question" }, h("a", { href: questionAddress(row.question, { o: row.oracle }) }, row.question), h("span", { class: "id" }, row.what)),
      h("div", { role: "cell", class: "c-engine" }, row.oracle),
      h("div", { role: "cell", class: "c-measure" }, row.law ? `${spaced(row.law)}: ${spaced(row.measure)}` : spaced(row.measure)),
      h("div", { role: "cell", class: "c-value number" }, said(row.before, row.unit)),
      h("div", { role: "cell", class: "c-share number" }, said(row.after, row.unit)));
  });
  const table = h("div", { role: "table", class: "findings-table", "aria-label": "Differences" },
    h("div", { role: "rowgroup", class: "head" }, h("div", { role: "row", class: "finding" }, ["", "Question", "Oracle", "Law or measure", "Before", "After"].map((t, c) => h("div", { role: "columnheader", class: c > 3 ? "number" : "" }, t || h("span", { class: "visually-hidden" }, "Change"))))), list.element);
  const chips = h("p", { class: "chips" });
  const draw = (): void => {
    const wanted = valuesOf(query, "kind");
    shown = kinds.flatMap(({ kind }) => compare.rows.filter((r) => r.kind === kind && (wanted.length === 0 || wanted.includes(kind))));
    fill(chips, kinds.map(({ kind, glyph, band }) => h("a", { class: `chip ${band}`, href: address(["compare"], toggled(query, "kind", kind)), "aria-current": wanted.includes(kind) ? "true" : undefined },
      h("span", { "aria-hidden": "true" }, glyph), ` ${kind} `, h("b", {}, compare.rows.filter((r) => r.kind === kind).length))));
    table.setAttribute("aria-rowcount", String(shown.length + 1));
    list.setCount(shown.length);
  };
  queueMicrotask(draw);
  return {
    title: "Two runs compared",
    element: h("section", {}, h("h1", {}, "Two runs compared"), h("p", {}, `Before: ${compare.old}. After: ${compare.new}. ${counted(compare.rows.length, "difference")}. Worse, and no longer judged, fail a comparison. `,
      button("CSV", () => downloadCsv("compare.csv", [["change", "question", "oracle", "law", "measure", "before", "after", "unit", "what"], ...compare.rows.map((r) => [r.kind, r.question, r.oracle, r.law, r.measure, r.before ?? "", r.after ?? "", r.unit, r.what])]), { class: "small" })), chips, table),
    update(next) { query = next.query; draw(); return true; },
    dispose: () => list.dispose(),
  };
};
