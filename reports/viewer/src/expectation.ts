import type { Question } from "./data";

/** The names of the expectations of each question: "expected of thrown at 0.4 s". The program names them by their place in the file, "expect[0]", which
 * says nothing to a reader. */
const kept = new WeakMap<Question, string[]>();

const quoted = (block: string, key: string): string => new RegExp(`^\\s*${key}\\s*=\\s*["']([^"'\\n]*)["']`, "m").exec(block)?.[1] ?? "";
const numbered = (block: string, key: string): string => new RegExp(`^\\s*${key}\\s*=\\s*([-+.\\deE]+)`, "m").exec(block)?.[1] ?? "";
/** The fact that is expected, where the measure does not say it. The measure of a place is its position error, and says enough. */
const factOf = (block: string): string => {
  const touched = quoted(block, "touches");
  if (touched) return `touches ${touched}`;
  const topples = /^\s*topples\s*=\s*(true|false)/m.exec(block)?.[1];
  if (topples) return topples === "true" ? "topples" : "does not topple";
  return /^\s*rests\s*=/m.test(block) ? "rests" : "";
};

/** The names of the expectations of a file, in its order. */
function namesIn(question: Question): string[] {
  const known = kept.get(question);
  if (known) return known;
  // A table ends where the next one begins.
  const blocks = question.toml.split(/^\s*\[\[expect\]\]\s*$/m).slice(1).map((text) => text.split(/^\s*\[/m)[0]);
  const names = blocks.map((block) => {
    const file = quoted(block, "trajectory");
    const about = quoted(block, "body") || (file && `the motion in ${file}`);
    const [at, by] = [numbered(block, "at"), numbered(block, "by")];
    const fact = factOf(block);
    return about === "" ? "" : `expected of ${about}${fact && `: ${fact}`}${at ? ` at ${Number(at)} s` : by ? ` by ${Number(by)} s` : ""}`;
  });
  kept.set(question, names);
  return names;
}

const isExpectation = /^expect\[(\d+)\]$/;

/** The name of a law for a reader: an expectation is named after what it expects. */
export function lawName(question: Question | undefined, law: string): string {
  const place = isExpectation.exec(law)?.[1];
  const name = place === undefined || !question ? "" : namesIn(question)[Number(place)] ?? "";
  return name === "" ? law.replaceAll("_", " ") : name;
}

/** A proof without the place of its expectation in the file, which its heading says in words. */
export const withoutPlace = (proof: string): string => proof.replace(/^expect\[\d+\]: /, "");
