import { address, toggled, valuesOf, withValue, type Address } from "../address";
import { bands, bandTexts } from "../bands";
import { fill, h } from "../dom";
import { bandsOf, filterKeys, findMatches, optionsOf, orderBy, sortKeys, type FilterKey, type SortKey } from "../filter";
import { downloadFindings, findingAddress, findingsTable } from "../findings_table";
import { counted } from "../format";
import type { MakeView } from "../view";
import { button } from "../widgets";

const names: Record<FilterKey, string> = {
  verdict: "verdict", oracle: "oracle", group: "group", pair: "pair of shapes", measure: "measure", law: "law", cause: "cause", cluster: "fault", entry: "ledger entry", question: "question",
};

export const findingsView: MakeView = (run, start) => {
  let query = start.query;
  let found: number[] = [];
  let chosen = -1;
  const options = filterKeys.map((key) => ({ key, values: optionsOf(run, key) })).filter(({ values }) => values.length > 1);
  const chips = h("div", { class: "chips", role: "group", "aria-label": "Bands" });
  const filters = h("div", { class: "filters" });
  const count = h("p", { class: "count", role: "status" });
  const go = (next: URLSearchParams): string => address(["findings"], next);

  const table = findingsTable(run, (key: SortKey) => {
    const current = (query.get("sort") as SortKey | null) ?? "gravity";
    const same = current === key;
    const reversed = same && query.get("down") === "0";
    let next = withValue(query, "sort", key === "gravity" ? "" : key);
    next = withValue(next, "down", same && !reversed ? "0" : "");
    const falling = key === "question" || key === "oracle" || key === "measure" ? reversed : !reversed;
    return { href: go(next), sorted: same ? (falling ? "descending" : "ascending") : "none" };
  });

  const show = (): void => {
    const matches = findMatches(run, query);
    found = matches.found;
    chosen = -1;
    const active = bandsOf(query);
    const explicit = query.has("band");
    fill(chips, bands.map((band, i) => h("a", {
      class: `chip ${band}`, href: go(toggled(query.get("band") === "all" ? withValue(query, "band", "") : query, "band", band)),
      "aria-current": explicit && active.includes(band) ? "true" : undefined, title: bandTexts[band].meaning,
    }, h("span", { "aria-hidden": "true" }, bandTexts[band].glyph), ` ${bandTexts[band].name} `, h("b", {}, matches.perBand[i].toLocaleString("en")))));
    fill(filters,
      options.map(({ key, values }) => {
        const select = h("select", { "aria-label": `Filter by ${names[key]}`, on: { change: () => { if (select.value) location.hash = go(toggled(query, key, select.value)); } } },
          h("option", { value: "" }, names[key]),
          values.map((value) => h("option", { value }, (valuesOf(query, key).includes(value) ? "✓ " : "") + value)));
        return select;
      }),
      filterKeys.flatMap((key) => valuesOf(query, key).map((value) =>
        h("a", { class: "chip active", href: go(toggled(query, key, value)), title: "Take this filter away" }, `${names[key]}: ${value} `, h("span", { "aria-hidden": "true" }, "×")))),
      query.get("q") && h("a", { class: "chip active", href: go(withValue(query, "q", "")), title: "Take the search away" }, `“${query.get("q")}” `, h("span", { "aria-hidden": "true" }, "×")));
    fill(count, `${counted(found.length, "finding")}${explicit || query.has("verdict") ? "" : found.length === 1 ? ", a fault" : ", all faults"} of ${counted(run.report.findings.question.length, "measurement")}. `,
      button("CSV", () => downloadFindings(run, found), { class: "small", title: "Save this table as comma-separated values" }));
    table.set(found);
  };
  const element = h("section", {}, h("h1", {}, "Findings"), chips, filters, count, table.element);
  // The order by gravity is the one that nearly everybody asks for; the others while nobody waits.
  queueMicrotask(show);
  const idle = window.setTimeout(() => { for (const key of sortKeys) orderBy(run, key); run.search.find("warm"); }, 400);

  const move = (step: number): void => {
    if (found.length === 0) return;
    chosen = Math.max(0, Math.min(found.length - 1, chosen + step));
    table.list.reveal(chosen);
  };
  return {
    title: "Findings", element,
    keys: [
      { keys: ["j"], does: "next finding", run: () => move(1) },
      { keys: ["k"], does: "previous finding", run: () => move(-1) },
      { keys: ["o"], does: "open the finding", run: () => { if (chosen >= 0) location.hash = findingAddress(run, found[chosen]); } },
    ],
    update(next: Address) { query = next.query; show(); return true; },
    dispose() { clearTimeout(idle); table.dispose(); },
  };
};
