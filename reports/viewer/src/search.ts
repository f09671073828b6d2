import type { Report } from "./data";

/** Finds findings by words. */
export interface Search {
  /** Marks the findings that contain every word of the query, or returns null for a query without words. */
  find(query: string): Uint8Array | null;
  /** Whether a text contains every word of the query. */
  matches(text: string, query: string): boolean;
}

const word = /[\p{L}\p{N}]+/gu;
const hump = /(?<=\p{Ll})(?=\p{Lu})|(?<=\p{Lu})(?=\p{Lu}\p{Ll})|(?<=\p{L})(?=\p{N})|(?<=\p{N})(?=\p{L})/u;

/** The words of a text in small letters, each after a space, and the parts of compound ones: "btGjkEpa2" also as "bt gjk epa 2".
 * A query word matches the beginning of one of them, so that "EPA" does not find "separated". */
export function indexed(text: string): string {
  let result = "";
  for (const [whole] of text.matchAll(word)) {
    result += " " + whole;
    const parts = whole.split(hump);
    if (parts.length > 1) result += " " + parts.join(" ");
  }
  return result.toLowerCase();
}

export const wordsOf = (query: string): string[] => (query.match(word) ?? []).map((w) => " " + w.toLowerCase());

export function makeSearch(report: Report): Search {
  const { findings, names } = report;
  // Built when first asked for: most readers never search.
  let index: { column: Int32Array; texts: string[] }[] | null = null;
  const build = () => {
    const origins = new Set(findings.because);
    for (const column of [findings.law, findings.cause_because, findings.shipped_because, findings.proof]) for (const t of column) origins.delete(t);
    // The origin of a tolerance is the same prose for thousands of findings and would drown what is searched for.
    const texts = report.texts.map((text, i) => (origins.has(i) ? "" : indexed(text)));
    return [
      { column: Int32Array.from(findings.question), texts: report.questions.map((q) => indexed(`${q.id} ${q.title} ${q.pair ?? ""}`)) },
      { column: Int32Array.from(findings.oracle), texts: report.oracles.map((o) => indexed(`${o.name} ${o.library}`)) },
      { column: Int32Array.from(findings.measure), texts: names.measure.map((m) => indexed(m.name)) },
      { column: Int32Array.from(findings.verdict), texts: names.verdict.map(indexed) },
      { column: Int32Array.from(findings.cause), texts: names.cause.map(indexed) },
      { column: Int32Array.from(findings.ledger), texts: report.ledger.map((entry) => indexed(`${entry.reason} ${entry.upstream}`)) },
      ...[findings.law, findings.proof, findings.cause_because, findings.shipped_because].map((column) => ({ column: Int32Array.from(column), texts })),
    ];
  };
  /** Marks of the texts that have a word, at index + 1. Four columns share their texts, so the last word of each list is kept. */
  const kept = new WeakMap<string[], { word: string; marks: Uint8Array }>();
  const marksOf = (texts: string[], word: string): Uint8Array => {
    const last = kept.get(texts);
    if (last?.word === word) return last.marks;
    const marks = new Uint8Array(texts.length + 1);
    // A text that has a longer word has its beginning too: letters typed one after the other narrow the search.
    const narrows = last !== undefined && word.startsWith(last.word);
    for (let i = 0; i < texts.length; ++i) if ((!narrows || last.marks[i + 1]) && texts[i].includes(word)) marks[i + 1] = 1;
    kept.set(texts, { word, marks });
    return marks;
  };
  return {
    matches: (text, query) => { const all = indexed(text); return wordsOf(query).every((w) => all.includes(w)); },
    find(query) {
      const words = wordsOf(query);
      if (words.length === 0) return null;
      index ??= build();
      const found = new Uint8Array(findings.question.length).fill(1);
      for (const w of words) {
        const parts = index.map(({ column, texts }) => ({ column, marks: marksOf(texts, w) })).filter(({ marks }) => marks.includes(1));
        const hits = new Uint8Array(found.length);
        // The marks are at index + 1, since −1 stands for none.
        for (const { column, marks } of parts) for (let i = 0; i < hits.length; ++i) hits[i] |= marks[column[i] + 1];
        for (let i = 0; i < found.length; ++i) found[i] &= hits[i];
      }
      return found;
    },
  };
}
