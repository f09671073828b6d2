import { address, toggled, valuesOf, withValue, type Address } from "../address";
import { bands, bandTexts, faultBands } from "../bands";
import { countsList, countsOf } from "../counts";
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
  const active = h("span", { class: "filters" });
  const selects = options.map(({ key, values }) => {
    const items = values.map((value) => h("option", { value }, value));
    const select = h("select", { "aria-label": `Filter by ${names[key]}`, on: { change: () => { const { value } = select; select.value = ""; if (value) location.hash = go(toggled(query, key, value)); } } },
      h("option", { value: "" }, names[key]), items);
    return { key, select, items, ticked: "" };
  });
  fill(filters, selects.map(({ select }) => select), active);
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
    const wanted = bandsOf(query);
    const explicit = query.has("band");
    fill(chips, bands.map((band, i) => h("a", {
      class: `chip ${band}`, href: go(toggled(query.get("band") === "all" ? withValue(query, "band", "") : query, "band", band)),
      "aria-current": explicit && wanted.includes(band) ? "true" : undefined, title: bandTexts[band].meaning,
    }, h("span", { "aria-hidden": "true" }, bandTexts[band].glyph), ` ${bandTexts[band].name} `, h("b", {}, matches.perBand[i].toLocaleString("en")))));
    for (const filter of selects) {
      // Hundreds of options stay as they are unless their ticks change.
      const ticked = query.get(filter.key) ?? "";
      if (ticked === filter.ticked) continue;
      filter.ticked = ticked;
      const values = valuesOf(query, filter.key);
      for (const item of filter.items) item.textContent = (values.includes(item.value) ? "✓ " : "") + item.value;
    }
    fill(active,
      filterKeys.flatMap((key) => valuesOf(query, key).map((value) =>
        h("a", { class: "chip active", href: go(toggled(query, key, value)), title: "Take this filter away" }, `${names[key]}: ${value} `, h("span", { "aria-hidden": "true" }, "×")))),
      query.get("q") && h("a", { class: "chip active", href: go(withValue(query, "q", "")), title: "Take the search away" }, `“${query.get("q")}” `, h("span", { "aria-hidden": "true" }, "×")));
    // A measurement is called a finding if it is a fault.
    const faulty = wanted.every((band) => faultBands.includes(band));
    const shown = faulty ? "finding" : "row";
    const total = faulty ? countsOf(run).findings : run.band.length;
    fill(count, `${counted(found.length, shown)} shown, of ${counted(total, shown)}. `,
      button("CSV", () => downloadFindings(run, found), { class: "small", title: "Save this table as comma-separated values" }));
    table.set(found);
  };
  const element = h("section", {}, h("h1", {}, "Findings"), countsList(run), chips, filters, count, table.element);
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
