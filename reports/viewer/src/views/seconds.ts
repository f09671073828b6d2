import { address, questionAddress, withValue } from "../address";
import { h, type Child } from "../dom";
import { downloadCsv } from "../download";
import { counted, ratio, spaced } from "../format";
import { cellsOf, duration, sumsByOracle, type CellOrder } from "../timings";
import type { MakeView } from "../view";
import { button, engine } from "../widgets";

const pageSize = 200;
const columns: [CellOrder, string][] = [["seconds", "Time"], ["question", "Question"], ["oracle", "Oracle"]];

const bar = (part: number): HTMLElement => h("td", { class: "whole" }, h("span", { class: "time-bar", "aria-hidden": "true", style: { width: `${100 * part}%` } }));

/** A table of sums with bars, each with its share of `whole` [s]. Sums below a hundredth of the largest are left out. */
function sums(title: string, meaning: string, rows: [name: Child, seconds: number][], whole: number): Child {
  const most = Math.max(...rows.map(([, seconds]) => seconds));
  const shown = rows.filter(([, seconds]) => seconds > 0 && seconds >= most / 100).sort((a, b) => b[1] - a[1]);
  return shown.length > 0 && h("div", { class: "time-sums" }, h("h2", {}, title), h("p", { class: "quiet" }, meaning), h("table", { class: "plain", "aria-label": title },
    h("tbody", {}, shown.map(([name, seconds]) => h("tr", {}, h("th", { scope: "row" }, name), h("td", { class: "number" }, duration(seconds)), h("td", { class: "number" }, ratio(seconds / whole)), bar(seconds / most))))));
}

export const secondsView: MakeView = (run, at) => {
  const { report } = run;
  const { oracles, questions, spent } = report;
  const all = cellsOf(report);
  const byOracle = sumsByOracle(all);
  const whole = byOracle.reduce((sum, { seconds }) => sum + seconds, 0);
  const only = at.query.get("oracle") ?? "";
  const order = columns.find(([key]) => key === at.query.get("sort"))?.[0] ?? "seconds";
  const reversed = at.query.get("down") === "0";
  const cells = cellsOf(report, only, order, reversed);
  const shown = cells.slice(0, Math.max(pageSize, Number(at.query.get("rows")) || 0));
  const most = Math.max(...cells.map((c) => c.seconds).concat(1e-9));
  const go = (query: URLSearchParams): string => address(["seconds"], query);
  const sortAddress = (key: CellOrder): string => go(withValue(withValue(at.query, "sort", key === "seconds" ? "" : key), "down", key === order && !reversed ? "0" : ""));
  const sorted = (key: CellOrder): string => ((key === "seconds") === reversed ? "ascending" : "descending");
  const oracleBox = h("select", { "aria-label": "Oracle", on: { change: () => { location.hash = go(withValue(at.query, "oracle", oracleBox.value)); } } },
    h("option", { value: "" }, "all oracles"), byOracle.map(({ oracle }) => h("option", { value: oracles[oracle].name, selected: oracles[oracle].name === only }, oracles[oracle].name)));
  const named = (of: Record<string, number> = {}): [string, number][] => Object.entries(of).map(([name, seconds]) => [spaced(name), seconds]);
  const save = (): void => downloadCsv("seconds.csv", [["question", "oracle", "seconds"], ...cells.map((c) => [questions[c.question].id, oracles[c.oracle].name, c.seconds])]);
  const element = h("section", {}, h("h1", {}, "Seconds"),
    h("p", {}, `Answers and worlds took ${duration(whole)} on the clock, added over all threads. They depend on the machine and on what else it did.`),
    h("div", { class: "time-tables" },
      sums("By oracle", "answers, and worlds with their judgement", byOracle.map(({ oracle, seconds }) => [engine(run, oracle), seconds]), whole),
      spent && sums("By kind of motion", "of all worlds", named(spent.motions), whole),
      spent && sums("By law", "the judgement alone", named(spent.laws), whole),
      spent && sums("By kind of contact question", "of all oracles, and of the referee", named(spent.contacts), Object.values(spent.contacts).reduce((a, b) => a + b, 0))),
    h("h2", {}, "Every answer and world"),
    h("p", { class: "toolbar" }, oracleBox, button("CSV", save, { class: "small" }), h("span", { class: "count", role: "status" }, shown.length < cells.length ? `${shown.length} of ${counted(cells.length, "row")}` : counted(cells.length, "row"))),
    h("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Every answer and world" }, h("table", { class: "plain stacked seconds" },
      h("thead", {}, h("tr", {}, columns.map(([key, name]) => h("th", { scope: "col", class: key === "seconds" ? "number" : undefined, "aria-sort": key === order ? sorted(key) : undefined },
        h("a", { href: sortAddress(key), title: `Sort by ${name.toLowerCase()}` }, name, key === order ? (sorted(key) === "ascending" ? " ▴" : " ▾") : ""))), h("th", { scope: "col" }, h("span", { class: "visually-hidden" }, "share of the longest")))),
      h("tbody", {}, shown.map((c) => h("tr", {}, h("td", { class: "number", "data-label": "time" }, duration(c.seconds)),
        h("th", { scope: "row" }, h("a", { href: questionAddress(questions[c.question].id, { o: oracles[c.oracle].name }), title: questions[c.question].title }, questions[c.question].id)),
        h("td", { "data-label": "oracle" }, engine(run, c.oracle)), bar(c.seconds / most)))))),
    shown.length < cells.length && h("p", {}, h("a", { href: go(withValue(at.query, "rows", String(5 * shown.length))) }, "Show more")));
  return { title: "Seconds", element };
};
