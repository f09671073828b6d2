import { address, withValue } from "../address";
import { decades, powerOfTen } from "../charts";
import { bands } from "../bands";
import { h } from "../dom";
import { downloadCsv } from "../download";
import { colourOf, prefersDark } from "../engines";
import { findingAddress } from "../findings_table";
import { counted, ratio, spaced } from "../format";
import { logHistogram, quantile } from "../histogram";
import type { MakeView } from "../view";
import { button, engine } from "../widgets";

/** Room for errors of exactly 0, which a logarithm has no place for, and for marks at the ends [px of 640]. */
const [zeroRoom, endRoom] = [34, 10];
const bins = 80;

/** The part of sorted errors that is above a bound. */
const partOver = (sorted: number[], bound: number): number => { const first = sorted.findIndex((e) => e > bound); return first < 0 ? 0 : (sorted.length - first) / sorted.length; };

/** Orders of the oracles, by their sorted errors. */
const orders: { key: string; name: string; of(sorted: number[]): number }[] = [
  // The worst comes first because a median of 0 says nothing of an engine that is wrong by half of the size at times.
  { key: "worst", name: "smallest worst first", of: (e) => e[e.length - 1] ?? 0 },
  { key: "median", name: "smallest median first", of: (e) => quantile(e, 0.5) }, { key: "most", name: "smallest 90 % first", of: (e) => quantile(e, 0.9) },
  { key: "large", name: "smallest part over 0.1 % of the size first", of: (e) => partOver(e, 1e-3) }, { key: "name", name: "by name", of: () => 0 },
];

interface Row { oracle: number; values: number[]; zeros: number; worst: number }

export const accuracyView: MakeView = (run, at) => {
  const { report } = run;
  const { findings: f, names, oracles, questions } = report;
  const lengths = names.measure.map((m) => m.kind === "length");
  const measures = names.measure.map((m) => m.name).filter((_, i) => lengths[i] && f.measure.includes(i));
  const measure = at.query.get("measure") ?? (measures.includes("separation_error") ? "separation_error" : measures[0] ?? "");
  const pair = at.query.get("pair") ?? "";
  const pairs = [...new Set(questions.map((q) => q.pair ?? "worlds"))].sort();
  const undecided = bands.indexOf("undecidable");

  // Oracles that answer other questions are not comparable: one can be chosen, whose questions alone are then counted, or those that all answer.
  const only = at.query.get("only") ?? "";
  const sharers = oracles.findIndex((o) => o.name === only);
  const answeredBy = questions.map(() => new Set<number>());
  for (let i = 0; i < f.question.length; ++i) {
    if (names.measure[f.measure[i]]?.name === measure && run.band[i] !== undecided && run.band[i] <= bands.indexOf("passed") && (!pair || (questions[f.question[i]].pair ?? "worlds") === pair)) answeredBy[f.question[i]].add(f.oracle[i]);
  }
  const measured = new Set(answeredBy.flatMap((set) => [...set]));
  const isCompared = (q: number): boolean => only === "" || (only === "all" ? answeredBy[q].size === measured.size : answeredBy[q].has(sharers));

  const rows: Row[] = oracles.map((_, oracle) => ({ oracle, values: [], zeros: 0, worst: -1 }));
  for (let i = 0; i < f.question.length; ++i) {
    if (names.measure[f.measure[i]]?.name !== measure || run.band[i] === undecided || run.band[i] > bands.indexOf("passed")) continue;
    if (pair && (questions[f.question[i]].pair ?? "worlds") !== pair) continue;
    if (!isCompared(f.question[i])) continue;
    const row = rows[f.oracle[i]];
    const size = Math.abs(f.share[i]);
    if (size > 0) row.values.push(size);
    else ++row.zeros;
    if (row.worst < 0 || size > Math.abs(f.share[row.worst])) row.worst = i;
  }
  const full = rows.filter((r) => r.worst >= 0);
  for (const row of full) row.values.sort((a, b) => a - b);
  const all = (row: Row): number[] => [...new Array<number>(row.zeros).fill(0), ...row.values];
  const order = orders.find((o) => o.key === at.query.get("sort")) ?? orders[0];
  full.sort((a, b) => (order.key === "name" ? (oracles[a.oracle].name < oracles[b.oracle].name ? -1 : 1) : order.of(all(a)) - order.of(all(b))));

  // The axis holds the errors up to 1e12; others are marked at its ends.
  const exponents = full.flatMap((r) => (r.values.length ? [Math.log10(r.values[0]), Math.log10(r.values[r.values.length - 1])] : [])).filter(Number.isFinite);
  // A few errors far below all others would leave most of the axis empty: one in a hundred may be marked at its end.
  const spread = full.flatMap((r) => r.values).map(Math.log10).sort((a, b) => a - b);
  const least = Math.min(...full.map((r) => Math.log10(r.values[Math.floor(r.values.length / 2)] ?? 1)).filter(Number.isFinite), spread[Math.floor(spread.length / 100)] ?? -3);
  const low = Math.max(-30, Math.floor(Math.min(-3, least)));
  const high = Math.min(12, Math.ceil(Math.max(0, ...exponents)));
  const span = 640 - zeroRoom - endRoom;
  const place = (value: number): number => (value > 0 ? zeroRoom + Math.max(0, Math.min(1, (Math.log10(value) - low) / (high - low))) * span : zeroRoom / 2);

  const ticks = decades(low, high, 6);
  const axis = (): HTMLElement => h("span", { class: "axis" }, h("span", {}, "0"), ticks.slice(1).map((e) => h("span", { style: { left: `${(100 * place(10 ** e)) / 640}%` } }, powerOfTen(e))));
  const strip = (row: Row): HTMLElement => {
    const canvas = h("canvas", { width: 640, height: 52, class: "strip", role: "img", "aria-label": `Distribution of the errors of ${oracles[row.oracle].name}` });
    const context = canvas.getContext("2d");
    if (!context) return canvas;
    const counts = logHistogram(row.values, low, high, bins);
    const most = Math.max(1, row.zeros, ...counts);
    const w = span / bins;
    context.strokeStyle = prefersDark() ? "#343a44" : "#dfe3e8";
    for (const e of ticks) { const x = zeroRoom + ((e - low) / (high - low)) * span; context.beginPath(); context.moveTo(x, 0); context.lineTo(x, 52); context.stroke(); }
    context.fillStyle = colourOf(run.looks[row.oracle]);
    // The height is the square root of the count, because the rare large errors matter most.
    counts.forEach((count, i) => { if (count) { const height = 46 * Math.sqrt(count / most); context.fillRect(zeroRoom + i * w, 52 - height, w - 1, height); } });
    if (row.zeros > 0) { const height = 46 * Math.sqrt(row.zeros / most); context.fillRect(zeroRoom / 2 - 8, 52 - height, 16, height); }
    const ink = prefersDark() ? "#fff" : "#000";
    const errors = all(row);
    context.fillStyle = context.strokeStyle = ink;
    context.fillRect(place(quantile(errors, 0.5)) - 1.5, 0, 4, 52);
    context.lineWidth = 2;
    context.strokeRect(place(quantile(errors, 0.9)) - 3, 10, 6, 32);
    const [x, y] = [place(errors[errors.length - 1] ?? 0), 26];
    context.beginPath();
    for (const s of [-1, 1]) { context.moveTo(x - 6, y - 6 * s); context.lineTo(x + 6, y + 6 * s); }
    context.stroke();
    return canvas;
  };
  const select = (key: string, label: string, options: string[], chosen: string, none?: string): HTMLElement => {
    const box = h("select", { "aria-label": label, on: { change: () => { location.hash = address(["accuracy"], withValue(at.query, key, box.value)); } } },
      none !== undefined && h("option", { value: "" }, none), options.map((value) => h("option", { value, selected: value === chosen }, spaced(value))));
    return box;
  };
  const sortAddress = (key: string): string => address(["accuracy"], withValue(at.query, "sort", key === orders[0].key ? "" : key));
  const columns: [string, string][] = [["Measured", ""], ["Exactly 0", ""], ["Median", "median"], ["90 % within", "most"], ["Over 0.1 %", "large"], ["Worst", "worst"]];
  const orderBox = h("select", { "aria-label": "Order of the oracles", on: { change: () => { location.hash = sortAddress(orderBox.value); } } },
    orders.map(({ key, name }) => h("option", { value: key, selected: key === order.key }, name)));
  const onlyBox = h("select", { "aria-label": "Questions that are compared", on: { change: () => { location.hash = address(["accuracy"], withValue(at.query, "only", onlyBox.value)); } } },
    h("option", { value: "" }, "each oracle's own questions"), h("option", { value: "all", selected: only === "all" }, "only questions that all answer"),
    oracles.map((o, i) => measured.has(i) && h("option", { value: o.name, selected: only === o.name }, `only questions of ${o.name}`)));
  const save = (): void => downloadCsv("accuracy.csv", [["oracle", "measurements", "median", "90 %", "part over 0.1 %", "worst", "worst question"],
    ...full.map((r) => [oracles[r.oracle].name, r.values.length + r.zeros, quantile(all(r), 0.5), quantile(all(r), 0.9), partOver(all(r), 1e-3), Math.abs(f.share[r.worst]), questions[f.question[r.worst]].id])]);
  const element = h("section", {}, h("h1", {}, "Accuracy"),
    h("p", {}, "How the errors of each oracle are distributed, as shares of the size of the question. Errors of exactly 0 have a bar of their own at the left. Each oracle is measured on the questions that it answers, unless you choose questions that others answer too. Undecidable measurements are left out."),
    h("p", { class: "toolbar" }, select("measure", "Measure", measures, measure), select("pair", "Pair of shapes", pairs, pair, "all pairs"), onlyBox, h("label", {}, "Order ", orderBox), button("CSV", save, { class: "small" })),
    h("p", { class: "marks" }, ["▮ median", "▯ 90 % are smaller", "✕ worst", "bars: how many, to the square root, because the rare large errors matter most"].map((text) => h("span", {}, text))),
    full.length === 0 ? h("p", {}, only === "all" ? "No question is answered by all oracles: choose those of one." : "No oracle has such a measurement.") : h("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Accuracy" }, h("table", { class: "plain accuracy stacked" },
      h("thead", {}, h("tr", {}, h("th", { scope: "col", "aria-sort": order.key === "name" ? "ascending" : undefined }, h("a", { href: sortAddress("name"), title: "Sort by name" }, "Oracle", order.key === "name" ? " ▴" : "")), h("th", { scope: "col" }, axis()),
        columns.map(([name, key]) => h("th", { scope: "col", class: "number", "aria-sort": key === order.key ? "ascending" : undefined }, key ? h("a", { href: sortAddress(key), title: `Sort by ${name.toLowerCase()}` }, name, key === order.key ? " ▴" : "") : name)))),
      h("tbody", {}, full.map((row) => h("tr", {},
        h("th", { scope: "row" }, engine(run, row.oracle)), h("td", { class: "whole" }, strip(row), h("div", { class: "own-axis", "aria-hidden": "true" }, axis())),
        h("td", { class: "number", "data-label": "measured" }, (row.values.length + row.zeros).toLocaleString("en")), h("td", { class: "number", "data-label": "exactly 0" }, row.zeros.toLocaleString("en")),
        h("td", { class: "number", "data-label": "median" }, ratio(quantile(all(row), 0.5))), h("td", { class: "number", "data-label": "90 % within" }, ratio(quantile(all(row), 0.9))),
        h("td", { class: "number", "data-label": "over 0.1 %" }, ratio(partOver(all(row), 1e-3))), h("td", { class: "number", "data-label": "worst" }, h("a", { href: findingAddress(run, row.worst), title: questions[f.question[row.worst]].title }, ratio(f.share[row.worst])))))))),
    h("p", { class: "quiet" }, `${counted(full.reduce((sum, r) => sum + r.values.length + r.zeros, 0), "measurement")} in ${counted(full.length, "oracle")}.`));
  return { title: "Accuracy", element };
};
