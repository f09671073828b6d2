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

const [low, high, bins] = [-18, 2, 80];

/** Orders of the oracles, by their sorted errors. */
const orders: { key: string; name: string; of(sorted: number[]): number }[] = [
  { key: "median", name: "smallest median first", of: (e) => quantile(e, 0.5) }, { key: "most", name: "smallest 90 % first", of: (e) => quantile(e, 0.9) },
  { key: "worst", name: "smallest worst first", of: (e) => e[e.length - 1] ?? 0 }, { key: "name", name: "by name", of: () => 0 },
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

  const rows: Row[] = oracles.map((_, oracle) => ({ oracle, values: [], zeros: 0, worst: -1 }));
  for (let i = 0; i < f.question.length; ++i) {
    if (names.measure[f.measure[i]]?.name !== measure || run.band[i] === undecided || run.band[i] > bands.indexOf("passed")) continue;
    if (pair && (questions[f.question[i]].pair ?? "worlds") !== pair) continue;
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

  const strip = (row: Row): HTMLElement => {
    const canvas = h("canvas", { width: 640, height: 52, class: "strip", role: "img", "aria-label": `Distribution of the errors of ${oracles[row.oracle].name}` });
    const context = canvas.getContext("2d");
    if (!context) return canvas;
    const counts = logHistogram(row.values, low, high, bins);
    const most = Math.max(1, ...counts);
    const w = 640 / bins;
    context.strokeStyle = prefersDark() ? "#343a44" : "#dfe3e8";
    for (const e of decades(low, high, 10)) { const x = ((e - low) / (high - low)) * 640; context.beginPath(); context.moveTo(x, 0); context.lineTo(x, 52); context.stroke(); }
    context.fillStyle = colourOf(run.looks[row.oracle]);
    // The height is the square root of the count, because the rare large errors matter most.
    counts.forEach((count, i) => { if (count) { const height = 46 * Math.sqrt(count / most); context.fillRect(i * w, 52 - height, w - 1, height); } });
    const place = (value: number): number => Math.max(1, Math.min(637, ((Math.log10(Math.max(value, 1e-300)) - low) / (high - low)) * 640));
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
  const orderBox = h("select", { "aria-label": "Order of the oracles", on: { change: () => { location.hash = address(["accuracy"], withValue(at.query, "sort", orderBox.value === orders[0].key ? "" : orderBox.value)); } } },
    orders.map(({ key, name }) => h("option", { value: key, selected: key === order.key }, name)));
  const save = (): void => downloadCsv("accuracy.csv", [["oracle", "measurements", "median", "90 %", "worst", "worst question"],
    ...full.map((r) => [oracles[r.oracle].name, r.values.length + r.zeros, quantile(all(r), 0.5), quantile(all(r), 0.9), Math.abs(f.share[r.worst]), questions[f.question[r.worst]].id])]);
  const element = h("section", {}, h("h1", {}, "Accuracy"),
    h("p", {}, "How the errors of each oracle are distributed, as shares of the size of the question. Errors of exactly 0 have no bar. Undecidable measurements are left out."),
    h("p", { class: "toolbar" }, select("measure", "Measure", measures, measure), select("pair", "Pair of shapes", pairs, pair, "all pairs"), h("label", {}, "Order ", orderBox), button("CSV", save, { class: "small" })),
    h("p", { class: "marks" }, ["▮ median", "▯ 90 % are smaller", "✕ worst", "bars: how many, to the square root, because the rare large errors matter most"].map((text) => h("span", {}, text))),
    full.length === 0 ? h("p", {}, "No oracle has such a measurement.") : h("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Accuracy" }, h("table", { class: "plain accuracy stacked" },
      h("thead", {}, h("tr", {}, h("th", { scope: "col" }, "Oracle"), h("th", { scope: "col" }, h("span", { class: "axis" }, decades(low, high, 5).map((e) => h("span", {}, powerOfTen(e))))),
        ["Measured", "Exactly 0", "Median", "90 % within", "Worst"].map((name) => h("th", { scope: "col", class: "number" }, name)))),
      h("tbody", {}, full.map((row) => h("tr", {},
        h("th", { scope: "row" }, engine(run, row.oracle)), h("td", { class: "whole" }, strip(row)),
        h("td", { class: "number", "data-label": "measured" }, (row.values.length + row.zeros).toLocaleString("en")), h("td", { class: "number", "data-label": "exactly 0" }, row.zeros.toLocaleString("en")),
        h("td", { class: "number", "data-label": "median" }, ratio(quantile(all(row), 0.5))), h("td", { class: "number", "data-label": "90 % within" }, ratio(quantile(all(row), 0.9))),
        h("td", { class: "number", "data-label": "worst" }, h("a", { href: findingAddress(run, row.worst), title: questions[f.question[row.worst]].title }, ratio(f.share[row.worst])))))))),
    h("p", { class: "quiet" }, `${counted(full.reduce((sum, r) => sum + r.values.length + r.zeros, 0), "measurement")} in ${counted(full.length, "oracle")}.`));
  return { title: "Accuracy", element };
};
