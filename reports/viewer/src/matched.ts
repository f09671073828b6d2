import { h, type Child } from "./dom";
import type { Run } from "./run";
import { wordPattern, partsOf, wordsOf } from "./search";
import { synonymsOf } from "./synonyms";

/** A part of a text that a query finds. */
type Range = [start: number, end: number];

/** Where a text has one of some words or phrases in small letters: whole words, or parts of compound ones, from their beginnings. */
function rangesOf(text: string, phrases: string[]): Range[] {
  const words = [...text.matchAll(wordPattern)].map((m) => ({ at: m.index, word: m[0] }));
  const ranges: Range[] = [];
  for (const phrase of phrases) {
    const wanted = phrase.split(" ");
    const last = wanted[wanted.length - 1];
    words.forEach((_, i) => {
      if (wanted.every((w, k) => { const found = words[i + k]?.word.toLowerCase() ?? ""; return k + 1 < wanted.length ? found === w : found.startsWith(w); }))
        ranges.push([words[i].at, words[i + wanted.length - 1].at + last.length]);
    });
    if (wanted.length > 1) continue;
    for (const { at, word } of words) {
      let place = at;
      for (const part of partsOf(word)) {
        if (part !== word && part.toLowerCase().startsWith(last)) ranges.push([place, place + last.length]);
        place += part.length;
      }
    }
  }
  ranges.sort((a, b) => a[0] - b[0] || b[1] - a[1]);
  return ranges.filter(([start], i) => i === 0 || start >= ranges[i - 1][1]);
}

/** The words and phrases that each word of a query finds. */
const phrasesOf = (query: string): string[][] => wordsOf(query).map((w) => synonymsOf(w.slice(1)));

/** A text with what a query finds in it marked. */
export function marked(text: string, query: string): Child[] {
  if (query === "") return [text];
  const parts: Child[] = [];
  let end = 0;
  for (const [start, stop] of rangesOf(text, phrasesOf(query).flat())) {
    parts.push(text.slice(end, start), h("mark", {}, text.slice(start, stop)));
    end = stop;
  }
  return [...parts, text.slice(end)];
}

/** Letters before what is found. */
const before = 24;

/** Why a query finds a finding, where its row does not show it: the name of the text that has the word, and its part around the word. */
export function reasonOf(run: Run, finding: number, query: string, shown: string[]): { name: string; text: string } | null {
  const { findings: f, questions, oracles, names, ledger } = run.report;
  const hidden = phrasesOf(query).filter((phrases) => !shown.some((text) => rangesOf(text, phrases).length > 0));
  if (hidden.length === 0) return null;
  const entry = ledger[f.ledger[finding]] ?? ledger[f.outgrown?.[finding] ?? -1];
  const texts: [name: string, text: string][] = [
    ["fault", entry?.fault ?? ""], ["proof", run.text(f.proof[finding])], ["reason", entry?.reason ?? ""], ["cause", names.cause[f.cause[finding]] ?? ""], ["cause", run.text(f.cause_because[finding])],
    ["as shipped", run.text(f.shipped_because[finding])], ["upstream", entry?.upstream ?? ""], ["verdict", names.verdict[f.verdict[finding]] ?? ""], ["pair", questions[f.question[finding]].pair ?? ""], ["library", oracles[f.oracle[finding]].library],
  ];
  for (const [name, text] of texts) {
    const [first] = rangesOf(text, hidden[0]);
    if (!first) continue;
    const start = Math.max(0, first[0] - before);
    // From the beginning of a word on.
    const from = start === 0 ? 0 : text.indexOf(" ", start) + 1;
    return { name, text: (from > 0 && from <= first[0] ? "… " : "") + text.slice(from > first[0] ? first[0] : from) };
  }
  return null;
}
