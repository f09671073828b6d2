import { digits } from "./format";

const number = /-?\d+(?:\.\d+)?(?:e[+-]?\d+)?/gi;

/** Names in quotation marks and places in files: their digits are no quantities. */
export const verbatim = /(“[^”]*”|[^\s“”]{1,200}\.(?:csv|toml):\d+)/u;

/** The differences in a proof, which have three digits. */
const difference = /a difference of \S+|\S+ \S+ (?:more|less)\b/g;

const vector = "\\([^()]*\\)";
/** Parts of proofs, and how a clause says them without vectors, which nobody reads in a list. */
const shorter: [RegExp, string][] = [
  [/^[a-z_]+(?:\[\d+\])?(?:, true of every motion)?: /, ""],
  [new RegExp(`says n = ${vector}, along which B must move ([^ ]+) m; moving B by ([^ ]+) m along ${vector} separates them`), "makes B move $1 m, where $2 m are enough"],
  [new RegExp(`says n = ${vector}, along which`), "says a normal along which"],
  [/(variant \([a-z_]+): [^()]*(?:\([^()]*\)[^()]*)*\)/, "$1)"],
  [/answers the question, but not its variant \((\w+)\): /, "answers the question, but not the same one $1, although that changes nothing else: "],
  [/for its variant \((\w+)\),? (?:mapped back, )?it says/, "for the same question $1 it says"],
  [/max_A n·x − min_B n·x is/, "the overlap is"],
  [/\b(?:points\[\d+\]\.)?n_AB_W\b/, "its normal"],
  [new RegExp(`it says n = ${vector}, along which`), "it says one along which"],
  [new RegExp(` along ${vector}; the overlap along it`), " along its normal; the overlap along that"],
  [new RegExp(`(moving B by [^ ]+ m) along ${vector} separates`), "$1 separates"],
  [new RegExp(`puts its points at ${vector} on A and ${vector} on B; these are`), "puts its points"],
  [new RegExp(`the point ${vector} lies`), "a point lies"],
  [/(?:\.{1,2})?\/?(?:[\w.-]+\/){2,}([\w.-]+:\d)/, "$1"],
  [new RegExp(`the plane n·x = [^ ]+ with n = ${vector} separates`), "a plane separates"],
];

/** Variants of a contact question in words. */
export const variantWords: Record<string, string | undefined> = { swap: "with A and B swapped", rigid_motion: "moved as a whole", scaling: "scaled", relabelling: "with the axes of its boxes renamed", perturbation: "with B moved by a rounding" };
const variantNames = new RegExp(`the same (question|one) (${Object.keys(variantWords).join("|")})\\b`, "g");

/** A number to at least so many digits, and to more where another one of `others` would read the same: a difference may be the proof. */
export function shortest(value: number, others: number[], least: number): string {
  const written = (x: number, count: number): string => digits(x, count).replace("−", "-");
  // "1e-3" and "0.001" are one number.
  const reads = (x: number, count: number): number => Number(written(x, count));
  let count = least;
  while (count < 17 && others.some((other) => other !== value && reads(other, count) === reads(value, count))) ++count;
  return written(value, count);
}

/** A proof for a list of faults: without the name of the law that it starts with and without most vectors, its numbers as short as they differ. */
export function proofClause(proof: string): string {
  const text = shorter.reduce((words, [long, short]) => words.replace(long, short), proof).replace(variantNames, (_, noun: string, name: string) => `the same ${noun} ${variantWords[name]}`);
  const pieces = text.split(verbatim);
  // A difference is rounded already: told apart from the numbers that it is of, these would no longer add up to it.
  const values = pieces.flatMap((piece, i) => (i % 2 === 0 ? piece.replace(difference, "").match(number) ?? [] : [])).map(Number);
  return pieces.map((piece, i) => (i % 2 === 1 ? piece : piece.replace(number, (found, at: number) => {
    // Digits of a name, those of a file's line and the number of a step are no quantities.
    if (/[\p{L}_:/]/u.test(piece.charAt(at - 1)) || /\bstep $/.test(piece.slice(0, at)) || found.replace(/[^\d]/g, "").length <= 3) return found;
    return shortest(Number(found), values, 3);
  }))).join("");
}
