/** Words for one thing: those that readers of the field type, and those in which the ids, titles, laws, measures and proofs of a report have it. */
const groups: { asked: string[]; written: string[] }[] = [
  { asked: ["tunnel", "tunnelling", "tunneling", "ccd"], written: ["passes through", "pass through", "passed through", "passage", "never passes", "tunnel"] },
  { asked: ["penetration", "depth", "deep", "overlap", "sink", "interpenetration"], written: ["penetrat", "depth", "deep", "overlap", "sink", "separation error", "inside both"] },
  { asked: ["normal", "direction", "axis"], written: ["normal", "direction", "axis", "excess", "mixed normals"] },
  { asked: ["drift", "energy", "conservation"], written: ["drift", "conserves", "energy"] },
  { asked: ["friction", "coulomb", "slip", "slide"], written: ["friction", "coulomb", "slip", "slid", "cone violation"] },
  { asked: ["bounce", "restitution", "rebound", "elastic"], written: ["bounc", "restitution", "rebound", "elastic", "impact"] },
  { asked: ["crash", "segfault", "abort", "signal"], written: ["crash", "abort", "signal", "segmentation"] },
  { asked: ["hang", "freeze", "timeout", "endless"], written: ["hang", "hung", "timed out", "endless"] },
  { asked: ["explode", "explosion", "blowup", "unstable", "diverge"], written: ["diverged", "not finite", "explo", "grow", "stability"] },
  { asked: ["missed", "false", "collision"], written: ["missed", "false", "touching", "collision", "apart"] },
  { asked: ["resting", "jitter", "sleep", "stack", "pile"], written: ["rests", "resting", "rest motion", "jitter", "sleep", "stack", "pile"] },
  { asked: ["constraint", "joint", "rod", "spring"], written: ["joint", "rod", "spring", "constraint"] },
  { asked: ["manifold", "contacts"], written: ["contact", "patch", "manifold"] },
];

/** Letters from which on a word is told from the others that begin alike. */
const tells = 4;

const isAsked = (asked: string, word: string): boolean => word.length >= Math.min(tells, asked.length) && (asked.startsWith(word) || word.startsWith(asked));

/** The words and phrases, in small letters, that say what a reader's word says; the word itself comes first. */
export function synonymsOf(word: string): string[] {
  const small = word.toLowerCase();
  return [...new Set([small, ...groups.filter((g) => g.asked.some((asked) => isAsked(asked, small))).flatMap((g) => g.written)])];
}

/** Words that a report is often searched for, one of each group. */
export const usualWords: string[] = groups.map((g) => g.asked[0]);

/** Changes of a letter that make one word the other, at most `most` + 1. */
function distance(a: string, b: string, most: number): number {
  if (Math.abs(a.length - b.length) > most) return most + 1;
  let row = Array.from({ length: b.length + 1 }, (_, j) => j);
  for (let i = 1; i <= a.length; ++i) {
    const next = [i];
    for (let j = 1; j <= b.length; ++j) next[j] = Math.min(row[j] + 1, next[j - 1] + 1, row[j - 1] + (a[i - 1] === b[j - 1] ? 0 : 1));
    row = next;
  }
  return row[b.length];
}

/** The words of a list that are spelled most like `word`, at most three of them. */
export function alike(word: string, list: string[]): string[] {
  const small = word.toLowerCase();
  const most = small.length < 5 ? 1 : 2;
  return list.filter((other) => other !== small).map((other) => ({ other, far: Math.min(distance(small, other, most), distance(small, other.slice(0, small.length), most) + 0.5) }))
    .filter(({ far }) => far <= most).sort((a, b) => a.far - b.far || (a.other < b.other ? -1 : 1)).slice(0, 3).map(({ other }) => other);
}
