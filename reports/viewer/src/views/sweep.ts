import { address, questionAddress, withValue } from "../address";
import { bandOfNamed, bands, bandTexts, faultBands, sizeMeaning, type Band } from "../bands";
import { decades, powerOfTen } from "../charts";
import type { Sweep } from "../data";
import { h, svg, type Child } from "../dom";
import { downloadCsv } from "../download";
import { colourOf } from "../engines";
import { wordsOf } from "../findings_table";
import { capital, counted, length, numberOf, quantity, ratio, short, spaced } from "../format";
import type { Run } from "../run";
import { prose } from "../symbols";
import type { MakeView } from "../view";
import { badge, button, engine, newBadge } from "../widgets";
import { notFound } from "./not_found";

/** The answers that a cell of the heat map counts. */
const shows: { key: string; name: string; bands: readonly Band[] }[] = [
  { key: "", name: "all faults", bands: faultBands },
  ...([...faultBands, "undecidable", "passed"] as Band[]).map((band) => ({ key: band, name: bandTexts[band].name, bands: [band] })),
];

/** Lower ends of the steps of the heat map's colour, as shares of the answers, and how strong each is [%]. */
const steps: [least: number, strength: number, name: string][] = [[0.1, 46, "10 % and more"], [0.01, 30, "1 % and more"], [1e-3, 18, "0.1 % and more"], [0, 9, "fewer"]];
const strengthOf = (part: number): number => (part > 0 ? steps.find(([least]) => part >= least)![1] : 0);

export interface HeatCell { asked: number; counted: number }

/** A dimension of the heat map, down or across. Motions are told apart by law instead of by measure. */
export type Dimension = "family" | "pair" | "oracle" | "measure";

/** The name of a measurand, a measure with the law that a motion is judged by: "excess"; "pendulum: position_error", as in a run. */
export const measurandName = ({ names }: Sweep, measure: number, law = -1): string => {
  const name = names.measure[measure] ?? "";
  return law >= 0 ? `${names.law?.[law] ?? ""}: ${name}` : name;
};

/** The name by which the heat map tells measurands apart: the law, or the measure where there is none. */
const groupName = ({ names }: Sweep, measure: number, law = -1): string => (law >= 0 ? names.law?.[law] : names.measure[measure]) ?? "";

/** Whether a measurand is `wanted`, or belongs to that law. */
const isOf = (measurand: string, wanted: string): boolean => measurand === wanted || measurand.startsWith(`${wanted}: `);

/** Names along a dimension, and the place of each row of a table among them. */
function namesAlong(sweep: Sweep, dimension: Dimension): { names: string[]; of(table: Partial<Record<string, unknown[]>>, row: number): number } {
  if (dimension !== "measure") return { names: sweep.names[dimension], of: (table, row) => (table[dimension]?.[row] ?? -1) as number };
  const { findings } = sweep;
  const nameAt = (table: Partial<Record<string, unknown[]>>, row: number): string => groupName(sweep, table.measure?.[row] as number, table.law?.[row] as number | undefined);
  const names = [...new Set((findings?.measure ?? []).map((_, i) => nameAt({ ...findings }, i)))].sort();
  const places = new Map(names.map((name, i) => [name, i]));
  return { names, of: (table, row) => places.get(nameAt(table, row)) ?? -1 };
}

/** Whether anything was measured in the answers with a verdict. */
const wasAsked = (verdict: string): boolean => verdict !== "unsupported";

/** The names of everything whose values are kept, sorted. */
export const measurands = (sweep: Sweep): string[] => [...new Set(sweep.sketches.measure.map((measure, i) => measurandName(sweep, measure, sweep.sketches.law?.[i])))].sort();

export interface HeatMap { rows: string[]; columns: string[]; cells: HeatCell[][]; counts: "answers" | "measurements" }

/** Counts what was asked in each row and column, and what is in the wanted bands: answers, or measurements where measures are told apart.
 * @param keeps the values of other dimensions that are counted */
export function heatMap(sweep: Sweep, down: Dimension, across: Dimension, wanted: readonly Band[], keeps: Partial<Record<"family" | "pair" | "oracle", number>>): HeatMap {
  const [rows, columns] = [namesAlong(sweep, down), namesAlong(sweep, across)];
  const { names, answers, findings } = sweep;
  const byMeasure = down === "measure" || across === "measure";
  const table = byMeasure ? findings : answers;
  const cells = rows.names.map(() => columns.names.map(() => ({ asked: 0, counted: 0 })));
  table?.count.forEach((count, i) => {
    const cell = cells[rows.of({ ...table }, i)]?.[columns.of({ ...table }, i)];
    const verdict = names.verdict[table.verdict[i]] ?? "";
    const isKept = Object.entries(keeps).every(([key, value]) => value < 0 || !(key in table) || (table as unknown as Record<string, number[]>)[key][i] === value);
    if (!cell || !isKept || !wasAsked(verdict)) return;
    cell.asked += count;
    if (wanted.includes(bandOfNamed(verdict, names.grade[table.grade[i]] ?? ""))) cell.counted += count;
  });
  return { rows: rows.names, columns: columns.names, cells, counts: byMeasure ? "measurements" : "answers" };
}

export interface Distribution { zeros: number; infinite: number; bins: Map<number, number>; total: number }

/** The distribution of a measurand for each oracle, over one pair of shapes, or over all (-1). */
export function distributions(sweep: Sweep, measurand: string, pair: number): Distribution[] {
  const { sketches, names } = sweep;
  const result = names.oracle.map((): Distribution => ({ zeros: 0, infinite: 0, bins: new Map(), total: 0 }));
  sketches.measure.forEach((m, i) => {
    const of = result[sketches.oracle[i]];
    if (!of || measurandName(sweep, m, sketches.law?.[i]) !== measurand || (pair >= 0 && sketches.pair[i] !== pair)) return;
    of.zeros += sketches.zeros[i];
    of.infinite += sketches.infinite[i];
    const bins = sketches.bins[i];
    for (let k = 0; k + 1 < bins.length; k += 2) of.bins.set(bins[k], (of.bins.get(bins[k]) ?? 0) + bins[k + 1]);
  });
  for (const of of result) of.total = of.zeros + of.infinite + [...of.bins.values()].reduce((a, b) => a + b, 0);
  return result;
}

/** The value below which a part of a distribution is, to a bin: its upper edge. */
export function quantileOf({ zeros, bins, total }: Distribution, part: number, perDecade: number): number {
  let left = Math.ceil(part * total) - zeros;
  if (total === 0) return NaN;
  if (left <= 0) return 0;
  for (const [bin, count] of [...bins].sort((a, b) => a[0] - b[0])) if ((left -= count) <= 0) return 10 ** ((bin + 1) / perDecade);
  return Infinity;
}

const [width, height, zeroRoom] = [560, 44, 30];

function strip(of: Distribution, low: number, high: number, perDecade: number, colour: string, name: string): SVGElement {
  const most = Math.max(1, of.zeros, ...of.bins.values());
  const place = (exponent: number): number => zeroRoom + ((exponent - low) / (high - low)) * (width - zeroRoom);
  const bar = (x: number, w: number, count: number): string => { const top = height - (height - 3) * Math.sqrt(count / most); return `M${x.toFixed(1)} ${height}V${top.toFixed(1)}h${w.toFixed(1)}V${height}z`; };
  const w = (width - zeroRoom) / ((high - low) * perDecade);
  const bars = [...of.bins].map(([bin, count]) => bar(Math.max(zeroRoom, place(bin / perDecade)), Math.max(w - 0.8, 0.8), count));
  if (of.zeros > 0) bars.push(bar(6, 16, of.zeros));
  return svg("svg", { viewBox: `0 0 ${width} ${height}`, class: "sweep-strip", role: "img", "aria-label": name, preserveAspectRatio: "none" },
    svg("path", { class: "grid", d: decades(low, high, 10).map((e) => `M${place(e).toFixed(1)} 0V${height}`).join("") }),
    svg("path", { d: bars.join(""), fill: colour }));
}

/** The oracle as the run knows it, or by its name if its failures were not asked again. */
const oracleNamed = (run: Run, name: string): Child => {
  const o = run.report.oracles.findIndex((oracle) => oracle.name === name);
  return o < 0 ? name : engine(run, o);
};

/** Rows of a table that are listed. */
const mostRows = 60;

export const sweepView: MakeView = (run, at) => {
  const { report } = run;
  const { sweep } = report;
  if (!sweep) return notFound("This report is not that of a sweep");
  const { names } = sweep;
  const { query } = at;
  const isOfWorlds = sweep.kind === "world";
  const measureWord = isOfWorlds ? "law" : "measure";
  const noun = isOfWorlds ? "world" : "question";
  const go = (key: string, value: string): string => address(["sweep"], withValue(query, key, value));
  const chosen = (key: "family" | "pair" | "oracle"): number => names[key].indexOf(query.get(key) ?? "");
  const [family, pair, oracle] = [chosen("family"), chosen("pair"), chosen("oracle")];

  // A measure or a law may be chosen; the distributions need a measure.
  const present = measurands(sweep);
  const wanted = [...present, ...(sweep.findings?.measure ?? []).map((m, i) => groupName(sweep, m, sweep.findings!.law[i]))].includes(query.get("measure") ?? "") ? query.get("measure")! : "";
  const among = present.filter((name) => wanted === "" || isOf(name, wanted));
  const measure = among.includes("separation_error") ? "separation_error" : mostFailed(sweep, among.length > 0 ? among : present);
  const infoOf = (name: string) => report.names.measure.find((m) => m.name === name);
  const unit = infoOf(measure.split(": ").at(-1)!)?.unit ?? "";

  const select = (key: string, label: string, options: string[], value: string, none?: string, text = spaced): HTMLElement => {
    const box = h("select", { "aria-label": label, on: { change: () => { location.hash = go(key, box.value); } } },
      none !== undefined && h("option", { value: "" }, none), options.map((option) => h("option", { value: option, selected: option === value }, text(option))));
    return box;
  };
  const dimensionText = (d: string): string => (d === "measure" ? measureWord : d);

  // Rows and columns of the heat map. Counts by measure are sums over the pairs of shapes.
  const hasMeasures = sweep.findings !== undefined;
  const downs = (["family", "pair", "measure"] as Dimension[]).filter((d) => (d === "measure" ? hasMeasures : d === "family" || names.pair.length > 0));
  const down = downs.find((d) => d === query.get("rows")) ?? "family";
  const acrosses = (["oracle", "measure"] as Dimension[]).filter((d) => d === "oracle" || (hasMeasures && down === "family"));
  const across = acrosses.find((d) => d === query.get("columns")) ?? "oracle";
  const show = shows.find(({ key }) => key === (query.get("show") ?? "")) ?? shows[0];
  // A filter on a dimension of the map only marks its row or column.
  const index = { family, pair, oracle };
  const keeps = Object.fromEntries(Object.entries(index).filter(([key]) => key !== down && key !== across)) as Partial<typeof index>;
  const map = heatMap(sweep, down, across, show.bands, keeps);
  const isAsked = (r: number, c: number): boolean => map.cells[r][c].asked > 0;
  const rows = map.rows.map((_, r) => r).filter((r) => map.columns.some((_, c) => isAsked(r, c)));
  const columns = map.columns.map((_, c) => c).filter((c) => across === "oracle" || rows.some((r) => isAsked(r, c)));
  const isChosen = (dimension: Dimension, name: string): boolean => (dimension === "measure" ? wanted : query.get(dimension) ?? "") === name;
  const cellView = (r: number, c: number): HTMLElement => {
    const { asked: of, counted: count } = map.cells[r][c];
    const [row, column] = [map.rows[r], map.columns[c]];
    if (of === 0) return h("td", { class: "heat", title: `${row}, ${column}: nothing was asked, or nothing is supported` }, "");
    const both = isChosen(down, row) && isChosen(across, column);
    const words = `${row}, ${column}: ${count.toLocaleString("en")} of ${of.toLocaleString("en")} ${map.counts} are ${show.name === "all faults" ? "faults" : show.name}`;
    const next = withValue(withValue(query, down, both ? "" : row), across, both ? "" : column);
    return h("td", { class: both ? "heat chosen" : "heat", style: { background: `color-mix(in srgb, var(--heat) ${strengthOf(count / of)}%, var(--ground))` } },
      h("a", { href: address(["sweep"], next), title: words, "aria-label": words }, count > 0 ? ratio(count / of) : "0"));
  };
  const { answers } = sweep;
  const save = (): void => downloadCsv("sweep.csv", map.counts === "answers"
    ? [["family", "pair", "oracle", "verdict", "grade", "answers"],
      ...answers.count.map((count, i) => [names.family[answers.family[i]], names.pair[answers.pair[i]] ?? "", names.oracle[answers.oracle[i]], names.verdict[answers.verdict[i]], names.grade[answers.grade[i]] ?? "", count])]
    : [["family", "oracle", "law", "measure", "verdict", "grade", "measurements"],
      ...sweep.findings!.count.map((count, i) => { const f = sweep.findings!; return [names.family[f.family[i]], names.oracle[f.oracle[i]], names.law?.[f.law[i]] ?? "", names.measure[f.measure[i]], names.verdict[f.verdict[i]], names.grade[f.grade[i]] ?? "", count]; })]);
  const filtered = [keeps.family !== undefined && family >= 0 && names.family[family], keeps.pair !== undefined && pair >= 0 && map.counts === "answers" && names.pair[pair], keeps.oracle !== undefined && oracle >= 0 && names.oracle[oracle]].filter((name) => name !== false);

  const spread = distributions(sweep, measure, pair);
  const full = spread.map((of, o) => ({ of, o })).filter(({ of, o }) => of.total > 0 && (oracle < 0 || o === oracle));
  const per = sweep.bins_per_decade;
  const exponents = full.flatMap(({ of }) => [...of.bins.keys()].map((bin) => bin / per));
  const low = Math.max(-40, Math.floor(Math.min(-3, ...exponents)));
  const high = Math.min(20, Math.ceil(Math.max(0, ...exponents.map((e) => e + 1 / per))));
  const upTo = (value: number): string => (value === 0 ? "0" : unit === "m" ? length(value) : quantity(value, unit));

  /** The finding of the page that a row of the sweep is about; -1 if it was not found again. */
  const findingOf = (q: number, o: string, measureName: string, law: string): number => {
    const { findings, names: runNames, oracles } = report;
    return [...run.findingsOf(q)].filter((i) => oracles[findings.oracle[i]].name === o && runNames.measure[findings.measure[i]]?.name === measureName && run.text(findings.law[i]) === law)
      .sort((a, b) => run.band[a] - run.band[b] || findings.share[b] - findings.share[a])[0] ?? -1;
  };
  /** Rows of a table that the filters keep, with what all of them show. */
  const listOf = (table: NonNullable<Sweep["worst"]> | Sweep["failures"], measurand: string) => table.question.map((_, i) => i).filter((i) => {
    const question = report.questions[table.question[i]];
    return question !== undefined && (oracle < 0 || table.oracle[i] === oracle) && (pair < 0 || (table.pair ? table.pair[i] === pair : question.pair === names.pair[pair]))
      && (family < 0 || (table.family ? table.family[i] === family : question.id.split("/")[1] === names.family[family]))
      && (measurand === "" || isOf(measurandName(sweep, table.measure[i], table.law?.[i]), measurand));
  }).map((i) => {
    const question = report.questions[table.question[i]];
    const [o, name, law] = [names.oracle[table.oracle[i]], names.measure[table.measure[i]] ?? "", names.law?.[table.law?.[i] ?? -1] ?? ""];
    const finding = findingOf(table.question[i], o, name, law);
    return { i, question, o, finding, info: infoOf(name), measurand: spaced(law === "" ? name : `${law}: ${name}`),
      href: questionAddress(question.id, { o, f: question.world && finding >= 0 ? String(finding) : "" }) };
  });
  const worstOfAll = sweep.worst ? listOf(sweep.worst, measure) : [];
  /** The worst question of an oracle by the chosen measure, in tolerances, if it can be opened; and the one of the largest error. */
  const worstOf = (name: string) => worstOfAll.find((row) => row.o === name);
  const largestOf = (name: string) => worstOfAll.filter((row) => row.o === name).sort((a, b) => numberOf(sweep.worst!.value[b.i]) - numberOf(sweep.worst!.value[a.i]))[0];
  // One of each oracle, so that those which pass are seen too; all of a chosen one.
  const worst = oracle >= 0 ? worstOfAll : worstOfAll.filter((row) => row === worstOf(row.o));
  const failures = listOf(sweep.failures, wanted);
  const active = ([["family", names.family[family]], ["pair", names.pair[pair]], ["oracle", names.oracle[oracle]], ["measure", wanted || undefined]] as const).filter(([, name]) => name !== undefined)
    .map(([key, name]) => h("a", { class: "chip active", href: go(key, ""), title: "Take this filter away" }, `${dimensionText(key)}: ${spaced(name!)} `, h("span", { "aria-hidden": "true" }, "×")));
  const tableOf = (label: string, columnsOf: string[], lines: HTMLElement[]): HTMLElement => h("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": label }, h("table", { class: "plain stacked" },
    h("thead", {}, h("tr", {}, columnsOf.map((t, c) => h("th", { scope: "col", class: c > 3 ? "number" : "" }, t)))), h("tbody", {}, lines)));
  const opens = isOfWorlds ? "Each opens as a world, with its playback, laws and proofs." : "Each opens as a contact question, with all answers and proofs.";

  const element = h("section", { class: "sweep" }, h("h1", {}, isOfWorlds ? "Sweep of worlds" : "Sweep"),
    h("p", {}, `${counted(sweep.asked, `generated ${noun}`)} in ${counted(names.family.length, "family", "families")}${names.pair.length > 0 ? ` and ${counted(names.pair.length, "pair")} of shapes` : ""}, put to ${counted(names.oracle.length, "oracle")}; ${counted(sweep.failed, "answer")} failed. Nothing is excused: the ledger of known faults is about the catalogue.`),
    h("details", {}, h("summary", {}, "Settings"), h("table", { class: "plain" }, h("tbody", {}, sweep.settings.map((s) => h("tr", {}, h("th", { scope: "row" }, spaced(s.name)), h("td", {}, s.value)))))),
    h("p", { class: "toolbar" }, select("family", "Family", names.family, names.family[family] ?? "", "all families"), names.pair.length > 0 && select("pair", "Pair of shapes", names.pair, names.pair[pair] ?? "", "all pairs"), select("oracle", "Oracle", names.oracle, names.oracle[oracle] ?? "", "all oracles"), active),
    h("h2", {}, "How often"),
    h("p", { class: "toolbar" }, "Rows ", select("rows", "Rows of the heat map", downs, down, undefined, dimensionText), acrosses.length > 1 && [" columns ", select("columns", "Columns of the heat map", acrosses, across, undefined, dimensionText)], " cells ", (() => {
      const box = h("select", { "aria-label": "What a cell counts", on: { change: () => { location.hash = go("show", box.value); } } }, shows.map(({ key, name }) => h("option", { value: key, selected: key === show.key }, name)));
      return box;
    })(), button("CSV", save, { class: "small" })),
    h("ul", { class: "marks", "aria-label": "Colours of the heat map" }, steps.map(([, strength, name]) => h("li", {}, h("span", { class: "cell-key", "aria-hidden": "true", style: { background: `color-mix(in srgb, var(--heat) ${strength}%, var(--ground))` } }), name))),
    h("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Heat map" }, h("table", { class: "matrix" },
      h("caption", { class: "visually-hidden" }, `The part of the ${map.counts} that are ${show.name}, by ${dimensionText(down)} and ${dimensionText(across)}`),
      h("thead", {}, h("tr", {}, h("th", { scope: "col" }, capital(dimensionText(down))), columns.map((c) => h("th", { scope: "col" }, h("span", { class: "upright" }, across === "oracle" ? map.columns[c] : spaced(map.columns[c])))))),
      h("tbody", {}, rows.map((r) => h("tr", {}, h("th", { scope: "row" }, spaced(map.rows[r])), columns.map((c) => cellView(r, c))))))),
    h("p", { class: "quiet" }, `Parts of the ${map.counts}${filtered.length ? ` of ${filtered.join(", ")}` : ""}; what an oracle does not support does not count. ${map.counts === "measurements" ? `Each ${measureWord} of each answer counts${names.pair.length > 0 ? ", over all pairs of shapes" : ""}. ` : ""}A cell selects its row and column for the lists below.`),
    h("h2", {}, "How large"),
    h("p", { class: "toolbar" }, select("measure", capital(measureWord), present, measure), h("span", { class: "quiet" }, `${pair >= 0 ? `${names.pair[pair]}, ` : names.pair.length > 0 ? "all pairs, " : ""}all families; the axis is logarithmic${unit ? `, in ${unit}` : ""}, the height the square root of the count. Values of 0 have a bar of their own at the left.`)),
    full.length === 0 ? h("p", {}, "No oracle has such a measurement.") : h("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Distributions" }, h("table", { class: "plain accuracy stacked" },
      h("thead", {}, h("tr", {}, h("th", { scope: "col" }, "Oracle"), h("th", { scope: "col" }, h("span", { class: "axis" }, h("span", {}, "0"), decades(low, high, 5).slice(1).filter((e) => e < high).map((e) => h("span", { style: { left: `${(100 * (zeroRoom + ((e - low) / (high - low)) * (width - zeroRoom))) / width}%` } }, powerOfTen(e))))),
        ["Measured", "Median up to", "99 % up to", "Worst up to"].map((t) => h("th", { scope: "col", class: "number" }, t)))),
      h("tbody", {}, full.map(({ of, o }) => h("tr", {}, h("th", { scope: "row" }, oracleNamed(run, names.oracle[o])),
        h("td", { class: "whole" }, strip(of, low, high, per, colourOf(run.looks[report.oracles.findIndex((x) => x.name === names.oracle[o])] ?? run.looks[0]), `Distribution of the ${spaced(measure)} of ${names.oracle[o]}`)),
        h("td", { class: "number", "data-label": "measured" }, of.total.toLocaleString("en")),
        ([["median", 0.5], ["99 %", 0.99], ["worst", 1]] as const).map(([label, part]) => {
          const text = upTo(quantileOf(of, part, per));
          const href = part === 1 ? largestOf(names.oracle[o])?.href : undefined;
          return h("td", { class: "number", "data-label": label }, href ? h("a", { href, title: `Open the ${noun} with the largest error of ${names.oracle[o]} that was asked again` }, text) : text);
        })))))),
    sweep.worst && [
      h("h2", {}, "Worst cases"),
      h("p", {}, `${oracle >= 0 ? "The worst" : "The worst of each oracle"} by ${spaced(measure)}, in multiples of the tolerance, also if it passes. ${opens}`),
      worst.length === 0 ? h("p", { class: "quiet" }, "None was asked again.") : tableOf("Worst cases", ["Verdict", capital(noun), "Oracle", "Error", "Tolerance", "Tolerances", "Of the size"], worst.slice(0, mostRows).map(({ i, question, o, finding, info, href }) => {
        const w = sweep.worst!;
        return h("tr", {}, h("td", {}, badge(finding >= 0 ? bands[run.band[finding]] : bandOfNamed(names.verdict[w.verdict[i]] ?? "", names.grade[w.grade[i]] ?? ""))),
          h("td", { class: "whole" }, h("a", { href, dir: "auto" }, question.title)), h("td", {}, oracleNamed(run, o)),
          h("td", { class: "number", "data-label": "error" }, quantity(w.value[i], info?.unit ?? "")), h("td", { class: "number", "data-label": "tolerance" }, quantity(w.tolerance[i], info?.unit ?? "")),
          h("td", { class: "number", "data-label": "tolerances" }, short(numberOf(w.tolerances[i]))), h("td", { class: "number", "data-label": "of the size" }, info?.kind === "length" ? ratio(w.share[i]) : ""));
      }))],
    h("h2", {}, "Gravest kept failures"),
    h("p", {}, `${counted(failures.length, "failure")} asked again${mostRows < failures.length ? `, the gravest ${mostRows} shown` : ""}, of ${sweep.kept.toLocaleString("en")} that the sweep has kept. ${opens} ${sizeMeaning}`),
    failures.length > 0 && tableOf("Gravest kept failures", ["Grade", capital(noun), "Oracle", isOfWorlds ? "Law and measure" : "Measure", "Error", "Of the size"], failures.slice(0, mostRows).map(({ i, question, o, finding, info, measurand, href }) => {
      const f = sweep.failures;
      return h("tr", {}, h("td", {}, badge(bandOfNamed(names.verdict[f.verdict[i]] ?? "", names.grade[f.grade[i]] ?? "")), f.is_new?.[i] && [" ", newBadge("the ledger of known faults has no entry of this oracle, verdict, measure and cause")]),
        h("td", { class: "whole" }, h("a", { href, dir: "auto" }, question.title), h("p", { class: "proof-line", dir: "auto" }, prose(f.proof[i]))),
        h("td", {}, oracleNamed(run, o)), h("td", {}, measurand),
        h("td", { class: "number", "data-label": "error" }, (finding >= 0 && wordsOf(run, finding)) || quantity(f.value[i], info?.unit ?? "")), h("td", { class: "number", "data-label": "of the size" }, info?.kind === "length" ? ratio(f.share[i]) : ""));
    })));
  return { title: isOfWorlds ? "Sweep of worlds" : "Sweep", element };
};

/** The measurand with the most faults among some, or the first. */
function mostFailed(sweep: Sweep, among: string[]): string {
  const { findings: f, names } = sweep;
  const faults = new Map<string, number>();
  f?.count.forEach((count, i) => {
    if (!faultBands.includes(bandOfNamed(names.verdict[f.verdict[i]] ?? "", names.grade[f.grade[i]] ?? ""))) return;
    const name = measurandName(sweep, f.measure[i], f.law[i]);
    faults.set(name, (faults.get(name) ?? 0) + count);
  });
  return [...among].sort((a, b) => (faults.get(b) ?? 0) - (faults.get(a) ?? 0))[0] ?? "";
}
