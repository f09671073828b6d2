import { valuesOf } from "./address";
import { bands, faultBands, type Band } from "./bands";
import { numberOf } from "./format";
import type { Run } from "./run";

/** Filters of the list of findings, as in its address. Several values of a key are alternatives; keys add up. */
export const filterKeys = ["verdict", "oracle", "group", "pair", "measure", "law", "cause", "cluster", "entry", "question"] as const;
export type FilterKey = (typeof filterKeys)[number];

export const sortKeys = ["gravity", "question", "oracle", "measure", "value", "share"] as const;
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

type Test = (finding: number) => boolean;

/** A test that a column has one of the values, by a table over its index. */
function columnTest(column: number[], count: number, accepts: (index: number) => boolean): Test {
  const table = Uint8Array.from({ length: count }, (_, i) => (accepts(i) ? 1 : 0));
  return (f) => table[column[f]] === 1;
}

function testOf(run: Run, key: FilterKey, values: string[]): Test {
  const { report } = run;
  const { findings: f, names } = report;
  const has = (value: string | undefined): boolean => value !== undefined && values.includes(value);
  switch (key) {
    case "verdict": return columnTest(f.verdict, names.verdict.length, (i) => has(names.verdict[i]));
    case "oracle": return columnTest(f.oracle, report.oracles.length, (i) => has(report.oracles[i].name));
    case "group": return columnTest(f.question, report.questions.length, (i) => has(report.questions[i].group));
    case "pair": return columnTest(f.question, report.questions.length, (i) => has(report.questions[i].pair));
    case "question": return columnTest(f.question, report.questions.length, (i) => has(report.questions[i].id));
    case "measure": return columnTest(f.measure, names.measure.length, (i) => has(names.measure[i].name));
    case "cause": return columnTest(f.cause, names.cause.length, (i) => has(names.cause[i]));
    case "law": return columnTest(f.law, report.texts.length, (i) => has(report.texts[i]));
    case "entry": return columnTest(f.ledger, report.ledger.length, (i) => has(String(i)));
    case "cluster": return columnTest(f.cluster, report.clusters.length, (i) => has(String(i)));
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
  const gravity = Float64Array.from(f.share, (share, i) => run.band[i] * 1e3 - (run.band[i] < faults ? Math.min(999, 500 + 20 * Math.log10(Math.max(Math.abs(share), 1e-25))) : 0));
  let keys: ArrayLike<number>;
  const questionRank = (): number[] => rank(questions, (q) => q.id);
  switch (key) {
    case "gravity": keys = gravity; break;
    case "question": { const r = questionRank(); keys = f.question.map((q) => r[q]); break; }
    case "oracle": { const r = rank(oracles, (o) => o.name); keys = f.oracle.map((o) => r[o]); break; }
    case "measure": { const r = rank(names.measure, (m) => m.name); keys = f.measure.map((m) => r[m]); break; }
    case "value": keys = f.value.map((v) => { const x = -Math.abs(numberOf(v)); return Number.isNaN(x) ? -Infinity : x; }); break;
    case "share": keys = f.share.map((s) => -Math.abs(s)); break;
  }
  order = Uint32Array.from(keys, (_, i) => i).sort((a, b) => keys[a] - keys[b] || gravity[a] - gravity[b] || a - b);
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
  const sort = query.get("sort") as SortKey | null;
  const order = orderBy(run, sort && sortKeys.includes(sort) ? sort : "gravity");
  const perBand = bands.map(() => 0);
  const found: number[] = [];
  next: for (const i of order) {
    if (words && !words[i]) continue;
    for (const test of tests) if (!test(i)) continue next;
    ++perBand[run.band[i]];
    if (wanted[run.band[i]]) found.push(i);
  }
  if (query.get("down") === "0") found.reverse();
  return { found, perBand };
}
