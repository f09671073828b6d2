import { valuesOf } from "./address";
import { bands, faultBands, type Band } from "./bands";
import { faultName } from "./fault_address";
import type { Run } from "./run";

/** Filters of the list of findings, as in its address. Several values of a key are alternatives; keys add up. */
export const filterKeys = ["verdict", "oracle", "group", "pair", "measure", "law", "cause", "cluster", "entry", "question"] as const;
export type FilterKey = (typeof filterKeys)[number];

export const sortKeys = ["severity", "question", "oracle", "measure", "share"] as const;
export type SortKey = (typeof sortKeys)[number];

export interface Matches {
  /** The findings, in the order of the address. */
  found: number[];
  /** How many of each band there would be if no band were chosen, in the order of `bands`. */
  perBand: number[];
}

/** Values of a key that the findings can have, in the order of their names. */
export function optionsOf({ report, text }: Run, key: FilterKey): string[] {
  switch (key) {
    case "verdict": return report.names.verdict;
    case "oracle": return report.oracles.map((o) => o.name);
    case "group": return [...new Set(report.questions.map((q) => q.group))].sort();
    case "pair": return [...new Set(report.questions.map((q) => q.pair ?? ""))].filter((p) => p !== "").sort();
    case "measure": return report.names.measure.map((m) => m.name).sort();
    case "law": return [...new Set(report.findings.law)].filter((l) => l >= 0).map(text).sort();
    case "cause": return report.names.cause.filter((c) => c !== "");
    case "cluster": case "entry": case "question": return [];
  }
}

/** A column of findings and the indices that pass, at index + 1, since −1 stands for none. */
interface Test { column: Int32Array; passes: Uint8Array }

/** Columns as typed arrays: a loop over them allocates nothing. */
const columns = new WeakMap<number[], Int32Array>();

export function typed(column: number[]): Int32Array {
  let result = columns.get(column);
  if (!result) columns.set(column, result = Int32Array.from(column));
  return result;
}

function testOf(run: Run, key: FilterKey, values: string[]): Test {
  const { report } = run;
  const { findings: f, names } = report;
  const wanted = new Set(values);
  const test = <T>(column: number[], list: T[], name: (item: T, index: number) => string | undefined): Test => {
    const passes = new Uint8Array(list.length + 1);
    list.forEach((item, i) => { passes[i + 1] = wanted.has(name(item, i) ?? "") ? 1 : 0; });
    return { column: typed(column), passes };
  };
  const index = (_: unknown, i: number): string => String(i);
  switch (key) {
    case "verdict": return test(f.verdict, names.verdict, (v) => v);
    case "oracle": return test(f.oracle, report.oracles, (o) => o.name);
    case "group": return test(f.question, report.questions, (q) => q.group);
    case "pair": return test(f.question, report.questions, (q) => q.pair);
    case "question": return test(f.question, report.questions, (q) => q.id);
    case "measure": return test(f.measure, names.measure, (m) => m.name);
    case "cause": return test(f.cause, names.cause, (c) => c);
    case "law": return test(f.law, report.texts, (t) => t);
    case "entry": return test(f.ledger, report.ledger, index);
    case "cluster": return test(f.cluster, report.clusters, (_, c) => (wanted.has(faultName(run, c)) ? faultName(run, c) : String(c)));
  }
}

/** Orders of all findings, made when first asked for: a filter keeps an order, so that it never sorts. */
const orders = new WeakMap<Run, Map<SortKey, Uint32Array>>();

export function orderBy(run: Run, key: SortKey): Uint32Array {
  let kept = orders.get(run);
  if (!kept) orders.set(run, kept = new Map());
  let order = kept.get(key);
  if (order) return order;
  const { findings: f, names, questions, oracles } = run.report;
  const rank = <T>(list: T[], name: (item: T) => string): number[] => {
    const places: number[] = [];
    list.map((item, i) => [name(item), i] as const).sort((a, b) => (a[0] < b[0] ? -1 : a[0] > b[0] ? 1 : 0)).forEach(([, i], place) => { places[i] = place; });
    return places;
  };
  const faults = faultBands.length;
  const severity = Float64Array.from(f.share, (share, i) => run.band[i] * 1e3 - (run.band[i] < faults ? Math.min(999, 500 + 20 * Math.log10(Math.max(Math.abs(share), 1e-25))) : 0));
  let keys: ArrayLike<number>;
  const questionRank = (): number[] => rank(questions, (q) => q.id);
  switch (key) {
    case "severity": keys = severity; break;
    case "question": { const r = questionRank(); keys = f.question.map((q) => r[q]); break; }
    case "oracle": { const r = rank(oracles, (o) => o.name); keys = f.oracle.map((o) => r[o]); break; }
    case "measure": { const r = rank(names.measure, (m) => m.name); keys = f.measure.map((m) => r[m]); break; }
    case "share": keys = f.share.map((s) => -Math.abs(s)); break;
  }
  order = Uint32Array.from(keys, (_, i) => i).sort((a, b) => keys[a] - keys[b] || severity[a] - severity[b] || a - b);
  kept.set(key, order);
  return order;
}

/** The bands that an address asks for: those of faults unless it names some. */
export function bandsOf(query: URLSearchParams): Band[] {
  const named = valuesOf(query, "band").filter((b): b is Band => (bands as readonly string[]).includes(b));
  return named.length || query.get("band") === "all" ? (named.length ? named : [...bands]) : query.has("verdict") ? [...bands] : [...faultBands];
}

export function findMatches(run: Run, query: URLSearchParams): Matches {
  const tests = filterKeys.filter((key) => query.get(key)).map((key) => testOf(run, key, valuesOf(query, key)));
  const words = run.search.find(query.get("q") ?? "");
  const wanted = new Uint8Array(bands.length);
  for (const band of bandsOf(query)) wanted[bands.indexOf(band)] = 1;
  // Older addresses ask for an order by value, which mixed units.
  const sort = (query.get("sort") === "value" ? "share" : query.get("sort")) as SortKey | null;
  const order = orderBy(run, sort && sortKeys.includes(sort) ? sort : "severity");
  const { band } = run;
  const passes = words ?? new Uint8Array(band.length).fill(1);
  for (const { column, passes: table } of tests)
    for (let i = 0; i < passes.length; ++i) passes[i] &= table[column[i] + 1];
  const counts = new Uint32Array(bands.length);
  const matching = new Uint32Array(order.length);
  let count = 0;
  for (let k = 0; k < order.length; ++k) {
    const i = order[k];
    if (passes[i] === 0) continue;
    ++counts[band[i]];
    if (wanted[band[i]]) matching[count++] = i;
  }
  const found = new Array<number>(count);
  for (let k = 0; k < count; ++k) found[k] = matching[k];
  const perBand = Array.from(counts);
  if (query.get("down") === "0") found.reverse();
  return { found, perBand };
}
