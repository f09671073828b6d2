import { address, withValue } from "../address";
import type { LedgerEntry } from "../data";
import { fill, h } from "../dom";
import { downloadCsv } from "../download";
import { findingsAddress } from "../findings_table";
import { counted, spaced } from "../format";
import type { MakeView } from "../view";
import { button, upstreamLink } from "../widgets";

const pageSize = 100;

export const ledgerView: MakeView = (run, at) => {
  const { ledger } = run.report;
  const groups = new Map<string, LedgerEntry[]>();
  for (const entry of ledger) {
    const fault = entry.fault ?? entry.reason;
    const list = groups.get(fault);
    if (list) list.push(entry);
    else groups.set(fault, [entry]);
  }
  const uses = (entries: LedgerEntry[]): number => entries.reduce((sum, e) => sum + e.uses, 0);
  const sorted = [...groups].sort((a, b) => uses(b[1]) - uses(a[1]));
  let query = at.query;
  const list = h("div");
  const words = h("p", { class: "count", role: "status" });
  const input = h("input", { type: "search", placeholder: "words of a fault or reason, an oracle or a scenario", "aria-label": "Search the ledger", value: query.get("q") ?? "", on: { input: () => {
    query = withValue(withValue(query, "q", input.value), "page", "");
    history.replaceState(history.state, "", address(["ledger"], query));
    draw();
  } } });
  const draw = (): void => {
    const q = query.get("q") ?? "";
    // Entry by entry: another entry of a fault may have another reason, and its findings are not found by these words either.
    const matching = sorted.map(([fault, entries]) => [fault, entries.filter((e) => run.search.matches([fault, e.reason, e.upstream, e.oracle, e.cause, ...e.scenarios].join(" "), q))] as const).filter(([, entries]) => entries.length > 0);
    const page = Math.max(0, Math.min(Math.ceil(matching.length / pageSize) - 1, Number(query.get("page")) || 0));
    fill(words, `${counted(matching.length, "fault")}, ${counted(matching.reduce((sum, [, e]) => sum + e.length, 0), "entry", "entries")}, ${counted(matching.reduce((sum, [, e]) => sum + uses(e), 0), "finding")} accepted. `, button("CSV", save, { class: "small" }));
    fill(list, matching.slice(page * pageSize, (page + 1) * pageSize).map(([fault, entries]) => {
      const body = h("div", { class: "entries" });
      const upstreams = [...new Set(entries.map((e) => e.upstream))].filter((u) => u !== "");
      return h("details", { on: { toggle: (event: Event) => { if ((event.target as HTMLDetailsElement).open && !body.hasChildNodes()) fill(body, entriesOf(entries)); } } },
        h("summary", {}, h("span", { class: "reason", dir: "auto" }, fault),
          h("span", { class: "quiet" }, ` ${[...new Set(entries.map((e) => e.oracle))].join(", ")} · ${counted(entries.length, "entry", "entries")} · ${counted(uses(entries), "finding")}`)),
        h("p", {}, upstreams.map((u) => [upstreamLink(u), " · "]), h("a", { href: findingsAddress({ entry: entries.map((e) => ledger.indexOf(e)).join(","), band: "all" }) }, "the findings that it hides")), body);
    }),
    matching.length > pageSize && h("p", { class: "toolbar" },
      page > 0 && h("a", { href: address(["ledger"], withValue(query, "page", String(page - 1))) }, "← before"),
      h("span", { class: "quiet" }, `page ${page + 1} of ${Math.ceil(matching.length / pageSize)}`),
      (page + 1) * pageSize < matching.length && h("a", { href: address(["ledger"], withValue(query, "page", String(page + 1))) }, "after →")));
  };
  const entriesOf = (entries: LedgerEntry[]): HTMLElement[] => entries.slice(0, pageSize).map((e) => h("dl", { class: "entry" },
    [["Reason", h("span", { dir: "auto" }, e.reason)], ["Oracle", h("a", { href: address(["oracles", e.oracle]) }, e.oracle)], ["Version", e.version], ["Scenarios", h("span", { class: "id" }, e.scenarios.join(", "))], ["Measures", e.measures.map(spaced).join(", ")],
      ["Verdict", e.verdict], ["Cause", e.cause], ["Expires", e.expires], ["Hides", h("a", { href: findingsAddress({ entry: String(ledger.indexOf(e)), band: "all" }) }, counted(e.uses, "finding"))]]
      .filter(([, value]) => value !== "").map(([name, value]) => [h("dt", {}, name), h("dd", {}, value)])));
  const save = (): void => downloadCsv("ledger.csv", [["fault", "reason", "oracle", "version", "scenarios", "measures", "verdict", "cause", "upstream", "expires", "findings"],
    ...ledger.map((e) => [e.fault ?? e.reason, e.reason, e.oracle, e.version, e.scenarios.join(" "), e.measures.join(" "), e.verdict, e.cause, e.upstream, e.expires, e.uses])]);
  draw();
  return {
    title: "Ledger",
    element: h("section", { class: "ledger" }, h("h1", {}, "Ledger"), h("p", {}, `The known and accepted faults; ${ledger.some((e) => e.uses > 0) ? "what hides most in this run comes first" : "this run needed none of them"}. Each opens to its entries, with the reason of each.`), h("p", {}, input), words, list),
    update(next) { query = next.query; if (document.activeElement !== input) input.value = query.get("q") ?? ""; draw(); return true; },
  };
};
