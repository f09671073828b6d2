import type { Report } from "./data";
import { alike, synonymsOf, usualWords } from "./synonyms";

/** Finds findings by words. */
export interface Search {
  /** Marks the findings that contain every word of the query or a synonym of it, or returns null for a query without words. */
  find(query: string): Uint8Array | null;
  /** Whether a text contains every word of the query, or a synonym of it. */
  matches(text: string, query: string): boolean;
  /** Words of the report that are spelled like a word that finds nothing. */
  alike(word: string): string[];
}

/** The words of a text. */
export const wordPattern = /[\p{L}\p{N}]+/gu;
const hump = /(?<=\p{Ll})(?=\p{Lu})|(?<=\p{Lu})(?=\p{Lu}\p{Ll})|(?<=\p{L})(?=\p{N})|(?<=\p{N})(?=\p{L})/u;

/** Digits that are kept of a long number. Proofs state their numbers with all digits: these are half of all text, and nobody types them. */
const digitsKept = 6;
const longNumber = new RegExp(`^(\\p{N}{${digitsKept}})\\p{N}+e?$`, "u");
const shortened = (whole: string): string => whole.replace(longNumber, "$1");

/** The parts of a compound word: "bt", "Gjk", "Epa" and "2" of "btGjkEpa2". */
export const partsOf = (whole: string): string[] => whole.split(hump);

/** The words of a text in small letters, each after a space, and the parts of compound ones: "btGjkEpa2" also as "bt gjk epa 2".
 * A query word matches the beginning of one of them, so that "EPA" does not find "separated". */
export function indexed(text: string): string {
  let result = "";
  for (const [found] of text.matchAll(wordPattern)) {
    const whole = shortened(found);
    result += " " + whole;
    const parts = partsOf(whole);
    if (parts.length > 1) result += " " + parts.join(" ");
  }
  return result.toLowerCase();
}

/** The bit of the first letter of a word: one for each of a to z, one for digits, one for all other letters. */
function bitOf(code: number): number {
  if (code >= 97 && code <= 122) return 1 << (code - 97);
  return code >= 48 && code <= 57 ? 1 << 26 : 1 << 27;
}

/** The bits of all words of an indexed text: most texts have no word with the letter that a reader types first. */
function firstLetters(text: string): number {
  let bits = 0;
  for (let at = text.indexOf(" "); at >= 0; at = text.indexOf(" ", at + 1)) bits |= bitOf(text.charCodeAt(at + 1));
  return bits;
}

/** The words of a query, each after a space. */
export const wordsOf = (query: string): string[] => (query.match(wordPattern) ?? []).map((w) => " " + shortened(w).toLowerCase());

/** A column of findings, and the texts that it refers to, with their first letters. */
interface Part { column: Int32Array; texts: string[]; letters: Uint32Array }

export function makeSearch(report: Report): Search {
  const { findings, names } = report;
  // Built when first asked for: most readers never search.
  let index: Part[] | null = null;
  const build = (): Part[] => {
    const origins = new Set(findings.because);
    for (const column of [findings.law, findings.cause_because, findings.shipped_because, findings.proof]) for (const t of column) origins.delete(t);
    // The origin of a tolerance is the same prose for thousands of findings and would drown what is searched for.
    const texts = report.texts.map((text, i) => (origins.has(i) ? "" : indexed(text)));
    const parts = [
      { column: Int32Array.from(findings.question), texts: report.questions.map((q) => indexed(`${q.id} ${q.title} ${q.pair ?? ""}`)) },
      { column: Int32Array.from(findings.oracle), texts: report.oracles.map((o) => indexed(`${o.name} ${o.library}`)) },
      { column: Int32Array.from(findings.measure), texts: names.measure.map((m) => indexed(m.name)) },
      { column: Int32Array.from(findings.verdict), texts: names.verdict.map(indexed) },
      { column: Int32Array.from(findings.cause), texts: names.cause.map(indexed) },
      // The entry that excuses a fault, or that knows it and allows less.
      { column: Int32Array.from(findings.ledger, (entry, i) => (entry >= 0 ? entry : findings.outgrown?.[i] ?? -1)), texts: report.ledger.map((entry) => indexed(`${entry.fault ?? ""} ${entry.reason} ${entry.upstream}`)) },
      ...[findings.law, findings.proof, findings.cause_because, findings.shipped_because].map((column) => ({ column: Int32Array.from(column), texts })),
    ];
    const letters = new Map<string[], Uint32Array>();
    return parts.map((part) => {
      if (!letters.has(part.texts)) letters.set(part.texts, Uint32Array.from(part.texts, firstLetters));
      return { ...part, letters: letters.get(part.texts)! };
    });
  };
  /** The results for the last words: the marks of each list of texts, at index + 1, since −1 stands for none, and the findings. For a query that
   * grows by a word or a letter only its last word is new. */
  interface Found { marks: Map<string[], Uint8Array>; hits: Uint8Array }
  const recent = new Map<string, Found>();
  const most = 12;
  const findWord = (parts: Part[], word: string): Uint8Array => {
    const known = recent.get(word);
    if (known) return known.hits;
    const written = synonymsOf(word.slice(1)).map((w) => " " + w);
    // A text that has a longer word has its beginning too: letters typed one after the other narrow the search. The synonyms of a word are no
    // narrower than those of its beginning.
    const shorter = written.length > 1 ? undefined : [...recent.keys()].filter((other) => word.startsWith(other)).sort((x, y) => y.length - x.length)[0];
    const narrower = shorter === undefined ? undefined : recent.get(shorter)!.marks;
    const found: Found = { marks: new Map(), hits: new Uint8Array(findings.question.length) };
    const { hits } = found;
    const bit = written.reduce((bits, w) => bits | bitOf(w.charCodeAt(1)), 0);
    // One letter from a to z is told by its bit alone.
    const isLetter = word.length === 2 && bit < 1 << 26;
    for (const { column, texts, letters } of parts) {
      // Four columns share their texts.
      let marks = found.marks.get(texts);
      if (!marks) {
        marks = new Uint8Array(texts.length + 1);
        const last = narrower?.get(texts);
        for (let i = 0; i < texts.length; ++i) if ((letters[i] & bit) !== 0 && (!last || last[i + 1]) && (isLetter || written.some((w) => texts[i].includes(w)))) marks[i + 1] = 1;
        found.marks.set(texts, marks);
      }
      if (marks.includes(1)) for (let i = 0; i < hits.length; ++i) hits[i] |= marks[column[i] + 1];
    }
    recent.set(word, found);
    if (recent.size > most) recent.delete(recent.keys().next().value!);
    return hits;
  };
  return {
    matches: (text, query) => { const all = indexed(text); return wordsOf(query).every((w) => synonymsOf(w.slice(1)).some((s) => all.includes(" " + s))); },
    alike: (word) => {
      const names = [...report.names.measure.map((m) => m.name), ...report.oracles.map((o) => `${o.name} ${o.library}`), ...report.questions.map((q) => q.id), ...[...new Set(findings.law)].map((l) => report.texts[l] ?? "")];
      return alike(word, [...new Set([...usualWords, ...names.flatMap((name) => indexed(name).split(" "))])].filter((w) => w.length > 2));
    },
    find(query) {
      const words = wordsOf(query);
      if (words.length === 0) return null;
      index ??= build();
      const found = new Uint8Array(findings.question.length).fill(1);
      for (const w of words) {
        const hits = findWord(index, w);
        for (let i = 0; i < found.length; ++i) found[i] &= hits[i];
      }
      return found;
    },
  };
}
