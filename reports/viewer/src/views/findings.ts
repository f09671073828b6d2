import { address, toggled, valuesOf, withValue, type Address } from "../address";
import { bands, bandTexts, faultBands } from "../bands";
import { countsList, countsOf } from "../counts";
import { fill, h, type Child } from "../dom";
import { bandsOf, filterKeys, findMatches, optionsOf, orderBy, sortKeys, type FilterKey, type SortKey } from "../filter";
import { downloadFindings, findingAddress, findingsTable } from "../findings_table";
import { faultOf } from "../fault_address";
import { counted } from "../format";
import type { Run } from "../run";
import { synonymsOf, usualWords } from "../synonyms";
import type { MakeView } from "../view";
import { button } from "../widgets";

const names: Record<FilterKey, string> = {
  verdict: "verdict", oracle: "oracle", group: "group", pair: "pair of shapes", measure: "measure", law: "law", cause: "cause", cluster: "fault", entry: "ledger entry", question: "question",
};

/** The name of a filter's value on the page. Addresses have the number of a fault or of a ledger entry; the page shows its sentence. */
function nameOfValue(run: Run, key: FilterKey, value: string): string {
  const { report } = run;
  if (key === "cluster") return report.clusters[faultOf(run, value)]?.title ?? value;
  if (key !== "entry") return value;
  const entry = report.ledger[Number(value)];
  return entry ? `${entry.oracle}, ${entry.fault ?? entry.reason}` : value;
}

/** Words that are offered to a reader who has found nothing. */
const mostTries = 8;

export const findingsView: MakeView = (run, start) => {
  let query = start.query;
  let found: number[] = [];
  let chosen = -1;
  let looking = 0;
  const options = filterKeys.map((key) => ({ key, values: optionsOf(run, key) })).filter(({ values }) => values.length > 1);
  const chips = h("div", { class: "chips", role: "group", "aria-label": "Bands" });
  const filters = h("div", { class: "filters" });
  const active = h("span", { class: "filters" });
  const selects = options.map(({ key, values }) => {
    const items = values.map((value) => h("option", { value }, value));
    const title = h("option", { value: "" }, names[key]);
    const select = h("select", { "aria-label": `Filter by ${names[key]}`, on: { change: () => { const { value } = select; select.value = ""; if (value) location.hash = go(toggled(query, key, value)); } } },
      title, items);
    return { key, select, title, items, ticked: "" };
  });
  fill(filters, selects.map(({ select }) => select), active);
  const count = h("p", { class: "count", role: "status" });
  const nothing = h("div");
  const go = (next: URLSearchParams): string => address(["findings"], next);

  const table = findingsTable(run, (key: SortKey) => {
    const current = (query.get("sort") as SortKey | null) ?? "severity";
    const same = current === key;
    const reversed = same && query.get("down") === "0";
    let next = withValue(query, "sort", key === "severity" ? "" : key);
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
      // The closed menu says what is chosen.
      filter.title.textContent = values.length === 0 ? names[filter.key] : `${names[filter.key]}: ${values.length === 1 ? values[0] : `${values.length} chosen`}`;
      filter.select.classList.toggle("chosen", values.length > 0);
      for (const item of filter.items) item.textContent = (values.includes(item.value) ? "✓ " : "") + item.value;
    }
    fill(active,
      filterKeys.flatMap((key) => valuesOf(query, key).map((value) =>
        h("a", { class: "chip active", href: go(toggled(query, key, value)), title: `${nameOfValue(run, key, value)}\nTake this filter away` }, `${names[key]}: ${nameOfValue(run, key, value)} `, h("span", { "aria-hidden": "true" }, "×")))),
      query.get("q") && h("a", { class: "chip active", href: go(withValue(query, "q", "")), title: "Take the search away" }, `“${query.get("q")}” `, h("span", { "aria-hidden": "true" }, "×")));
    // A measurement is called a finding if it is a fault.
    const faulty = wanted.every((band) => faultBands.includes(band));
    const shown = faulty ? "finding" : "row";
    const total = faulty ? countsOf(run).findings : run.band.length;
    const also = (query.get("q")?.match(/[\p{L}\p{N}]+/gu) ?? []).flatMap((word) => synonymsOf(word).slice(1));
    const all = counted(total, shown);
    const bySize = ["share", "value"].includes(query.get("sort") ?? "") && found.length > 1;
    fill(count, found.length === total ? (total === 0 ? "No findings. " : `${total === 1 ? "The only" : "All"} ${total === 1 ? shown : all}. `) : `${counted(found.length, shown)} shown, of ${all}. `, also.length > 0 && `Also searched for: ${[...new Set(also)].slice(0, 6).join(", ")}. `, bySize && "In the order of the share of the size, since errors in different units have no other. ",
      button("CSV", () => downloadFindings(run, found), { class: "small", title: "Save this table as comma-separated values" }));
    clearTimeout(looking);
    fill(nothing, found.length === 0 && wayOut(matches.perBand));
    table.element.hidden = found.length === 0;
    table.set(found, query.get("q") ?? "");
  };
  /** Ways on for a reader who has found nothing. */
  const wayOut = (perBand: number[]): Child => {
    const q = query.get("q") ?? "";
    const used = filterKeys.flatMap((key) => valuesOf(query, key).map((value) => ({ key, value })));
    const hidden = perBand.reduce((sum, count) => sum + count, 0);
    const words = (q.match(/[\p{L}\p{N}]+/gu) ?? []).slice(0, 4);
    const isNarrowed = q !== "" || used.length > 0 || query.has("band");
    // Other words are looked for one at a time after the answer is there, so that a key never waits for all of them.
    const [alike, often] = [h("li", { hidden: true }), h("li", { hidden: true })];
    const tries: string[] = [];
    const tryNext = (left: string[]): void => {
      const word = left[0];
      if (word === undefined || tries.length === mostTries) return;
      if (run.search.find(word)?.includes(1)) tries.push(word);
      often.hidden = tries.length === 0;
      fill(often, "Often searched for: ", tries.map((found, i) => [i > 0 && ", ", h("a", { href: searchFor(found) }, found)]));
      looking = window.setTimeout(tryNext, 0, left.slice(1));
    };
    if (isNarrowed) looking = window.setTimeout(() => {
      const spelled = words.flatMap((word) => run.search.alike(word).map((other) => ({ word, other })));
      alike.hidden = spelled.length === 0;
      fill(alike, "Spelled alike: ", spelled.slice(0, 6).map(({ word, other }, i) => [i > 0 && ", ", h("a", { href: go(withValue(query, "q", q.replace(word, other))) }, other)]));
      looking = window.setTimeout(tryNext, 0, usualWords.filter((word) => !words.includes(word)));
    }, 300);
    const searchFor = (text: string): string => go(withValue(new URLSearchParams(), "q", text));
    return h("div", { class: "nothing" },
      h("h2", {}, q ? `Nothing found for “${q}”` : isNarrowed ? "No finding passes these filters" : "No measurement of this run is wrong"),
      h("ul", {},
        hidden > 0 && h("li", {}, h("a", { href: go(withValue(query, "band", "all")) }, `${counted(hidden, "measurement")} of other grades`), " match, those that passed included."),
        used.length > 0 && q !== "" && h("li", {}, h("a", { href: searchFor(q) }, `Search for “${q}” without the filters`)),
        used.length > 1 && used.slice(0, 6).map(({ key, value }) => h("li", {}, h("a", { href: go(toggled(query, key, value)) }, `Without ${names[key]}: ${nameOfValue(run, key, value)}`))),
        alike,
        isNarrowed && h("li", {}, h("a", { href: address(["findings"]) }, "Clear the search and all filters")),
        often));
  };
  const element = h("section", {}, h("h1", {}, "Findings"), countsList(run), chips, filters, count, nothing, table.element);
  queueMicrotask(show);
  // The order by severity is the one that nearly everybody asks for. The others, and the index of the search, are made while nobody waits: one at a
  // time, so that a filter never waits for all of them.
  const chores = [() => run.search.find("warm"), ...sortKeys.map((key) => () => orderBy(run, key))];
  const doChore = (): void => {
    chores.shift()?.();
    if (chores.length > 0) idle = window.setTimeout(doChore, 50);
  };
  let idle = window.setTimeout(doChore, 400);

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
    dispose() { clearTimeout(idle); clearTimeout(looking); table.dispose(); },
  };
};
