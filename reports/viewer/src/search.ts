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
  let index: { texts: string[]; questions: string[]; oracles: string[]; measures: string[]; verdicts: string[]; causes: string[]; ledger: string[] } | null = null;
  const build = () => {
    const origins = new Set(findings.because);
    for (const column of [findings.law, findings.cause_because, findings.shipped_because, findings.proof]) for (const t of column) origins.delete(t);
    return {
      // The origin of a tolerance is the same prose for thousands of findings and would drown what is searched for.
      texts: report.texts.map((text, i) => (origins.has(i) ? "" : indexed(text))),
      questions: report.questions.map((q) => indexed(`${q.id} ${q.title} ${q.pair ?? ""}`)),
      oracles: report.oracles.map((o) => indexed(`${o.name} ${o.library}`)),
      measures: names.measure.map((m) => indexed(m.name)),
      verdicts: names.verdict.map(indexed),
      causes: names.cause.map(indexed),
      ledger: report.ledger.map((entry) => indexed(`${entry.reason} ${entry.upstream}`)),
    };
  };
  return {
    matches: (text, query) => { const all = indexed(text); return wordsOf(query).every((w) => all.includes(w)); },
    find(query) {
      const words = wordsOf(query);
      if (words.length === 0) return null;
      index ??= build();
      const found = new Uint8Array(findings.question.length).fill(1);
      for (const w of words) {
        const mark = (texts: string[]): Uint8Array => Uint8Array.from(texts, (text) => (text.includes(w) ? 1 : 0));
        const texts = mark(index.texts);
        const questions = mark(index.questions);
        const oracles = mark(index.oracles);
        const measures = mark(index.measures);
        const verdicts = mark(index.verdicts);
        const causes = mark(index.causes);
        const ledger = mark(index.ledger);
        for (let i = 0; i < found.length; ++i) {
          // An index of -1 reads undefined, which is no match.
          if (found[i] && !(questions[findings.question[i]] || oracles[findings.oracle[i]] || measures[findings.measure[i]] ||
              verdicts[findings.verdict[i]] || causes[findings.cause[i]] || ledger[findings.ledger[i]] || texts[findings.law[i]] ||
              texts[findings.proof[i]] || texts[findings.cause_because[i]] || texts[findings.shipped_because[i]])) found[i] = 0;
        }
      }
      return found;
    },
  };
}
