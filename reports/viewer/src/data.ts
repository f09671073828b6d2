/**
 * The data of a report, format version 1: the contract between `reports/writers` (which writes it) and `reports/viewer` (which reads it).
 *
 * The page holds it as base64 in `<script type="application/octet-stream" id="report-data">`. Decoded and inflated (zlib, the browser's
 * `DecompressionStream("deflate")`), the bytes are: "TSRD", u32 version, u32 length of the JSON in bytes, the JSON (UTF-8), then the blob.
 * Numbers are little-endian. A `Track` refers to the blob. Every string comes from engines, files or users: untrusted text.
 * A reader ignores keys that it does not know; a key with `?` may be missing.
 */
export type Vec3 = [number, number, number];
export type Quat = [number, number, number, number]; // w, x, y, z
/** Index into `Report.texts`; -1 for none. */
export type Text = number;

/** A table of samples: `width` channels of `samples` numbers, channel after channel. Each channel is a sequence of zigzag LEB128 varints, the
 * differences of consecutive integers (the first from 0); a number is integer * scale[channel]. NaN never occurs. */
export interface Track { at: number; samples: number; scale: number[] }

export interface Report {
  format: "touchstone report data";
  version: 1;
  program: string;      // "touchstone 0.1.0"
  command: string;      // the command that made the run, without paths of the output: "touchstone run contact"
  sentence: string;     // what was asked: "15 oracles answered 556 contact questions; 4 oracles support none of them."
  conclusion: string;   // the last line of the console: "OK: …" or "FAILED: …"
  failed: boolean;      // whether the exit code is not 0
  exit_code?: number;   // 2: no answer of the subject was verified
  subject: number;      // index into oracles
  oracles: Oracle[];
  questions: Question[];          // contact questions first, then worlds, each sorted by id
  texts: string[];
  names: { verdict: string[]; undecided: string[]; grade: string[]; cause: string[]; shipped: string[]; proof?: string[]; claim?: string[]; measure: { name: string; unit: string; kind: "length" | "angle" | "count" | "fraction" | "other" }[] };
  findings: Findings;
  proofs?: Proofs;                // not in the data of older programs
  cited?: Cited;                  // not in the data of older programs
  studies?: Studies;
  clusters: Cluster[];            // ranked, the worst for a user first
  ledger: LedgerEntry[];
  faults: string[];               // of the scenario files and the ledger
  regressions: { oracle: string; what: string }[];
  /** Times on the clock that the oracles took, by question and oracle; null where one was not asked [s]. */
  seconds?: (number | null)[][];
  /** Sums over all worlds by kind of motion and by law, and over all contact questions by kind [s]. */
  spent?: { motions: Record<string, number>; laws: Record<string, number>; contacts: Record<string, number> };
  sweep?: Sweep;
  compare?: { old: string; new: string; rows: { kind: "worse" | "no longer judged" | "new" | "gone" | "better"; question: string; oracle: string; measure: string; law: string;
    before: number | string | null; after: number | string | null; unit: string; what: string }[] };
}

export interface Oracle {
  name: string; library: string; version: string; unit_roundoff: number; isolated: boolean;
  contacts: boolean; worlds: boolean;                       // the kinds of question that it answers
  settings: { name: string; value: string; why: string }[];
  parameters: { name: string; set: string; shipped: string }[]; // of worlds, as set here and as the engine ships; may be empty
}

export interface Question {
  id: string; group: string; title: string; kind: "contact" | "world";
  pair?: string;                  // "box–box", contact questions only
  toml: string;                   // the scenario file that asks it again
  own?: boolean;                  // whether only that file asks it: the program knows no such id
  size: number;                   // extent of the smaller body (contact) or of the motion's smallest moving body (world) [m]
  rounding: (number | string)[];  // length by which rounding alone may change the answer of each oracle [m]
  contact?: Contact;
  world?: World;
}

export type Shape =
  | { type: "sphere"; radius: number } | { type: "box"; half: Vec3 } | { type: "capsule"; radius: number; length: number }
  | { type: "cylinder"; radius: number; length: number } | { type: "cone"; radius: number; length: number }   // axis z, origin as in docs/conventions.md
  | { type: "half_space" }        // z <= 0 of its frame
  | { type: "hull"; vertices: Vec3[] };

export interface Placed { shape: Shape; p: Vec3; q: Quat }

export interface Contact {
  A: Placed; B: Placed;
  truth: { touching: "apart" | "touching" | "undecided"; lo: number; hi: number; method: string; n: Vec3; pA: Vec3; pB: Vec3; patch: Vec3[] };
  answers: Answer[];              // indexed like Report.oracles
}

export interface Answer {
  status: "answered" | "unsupported" | "crashed" | "timed out" | "not asked";
  reason: string;
  touching?: boolean; n?: Vec3; separation?: number;
  points?: { p: Vec3; s: number; n?: Vec3 }[];
  witnesses?: [Vec3, Vec3];
}

export interface World {
  dt: number; steps: number; gravity: Vec3;
  bodies: { name: string; shape: Shape; fixed: boolean; start: { p: Vec3; q: Quat } }[];
  particles: { name: string; radius: number }[];
  springs: { A: number; B: number; pA: Vec3; pB: Vec3 }[];  // body index; particle index + bodies.length; -1 world; anchors in body frames
  joints: { A: number; B: number; pA: Vec3; pB: Vec3; kind: string }[];
  cloths: { rows: number; columns: number }[];
  claims: string[];               // laws that the file claims, in words
  times: number[];                // of the samples kept here [s]
  thinned: number;                // every n-th sample of the run is kept, and those about the moments of proofs; 1: all
  motions: Motion[];              // indexed like Report.oracles
  /** Curves of one body or of the whole world over `times`. */
  curves: Curve[];
}

export interface Motion {
  status: Answer["status"]; reason: string; diverged_at_step?: number;
  /** Per body, in the order of `bodies`: channels x y z qw qx qy qz vx vy vz wx wy wz. A fixed body has none (null). */
  bodies: (Track | null)[];
  points?: Track;                 // particles then nodes of cloths: channels x y z of each
  /** Contact impulses summed over each pair of bodies and kept interval (sample k: the interval before kept sample k): channels sample, A, B, px py pz, nx ny nz, Jx Jy Jz, separation; one "sample" each. */
  impulses?: Track;
}

export interface Curve {
  quantity: string; unit: string; body?: number;      // "energy", "J"
  truth?: Track;                                      // one channel; where it is known
  tolerance?: number;                                 // band around the truth, or allowed rise
  finding?: number;                                   // the finding that it shows, index into findings
  shows?: (number | null)[];                          // the finding of each oracle whose measure and truth it shows, index into findings
  breaks?: (number | null)[];                         // time [s] at which each oracle first leaves the band, indexed like oracles
  motions: (Track | null)[];                          // indexed like Report.oracles, one channel
}

/** One column a property, all of one length. */
export interface Findings {
  question: number[]; oracle: number[]; measure: number[]; law: Text[]; reference: Text[];
  verdict: number[]; undecided: number[]; grade: number[]; cause: number[]; shipped: number[];
  value: (number | string)[]; tolerance: (number | string)[];  // strings "inf", "-inf", "nan" where JSON has no number
  share: number[];                // error as a share of the size of the question [-]; the value itself for what is no length
  because: Text[];                // origin of the tolerance
  cause_because: Text[]; shipped_because: Text[]; proof: Text[];
  ledger: number[];               // entry that excuses it, or -1
  outgrown?: number[];            // entry that knows it, but allows less, or -1
  cluster: number[];              // cluster, or -1
  time?: number[];                // the moment of a world that the proof is about, that of the worst value [s], or -1
  first?: number[];               // the first moment at which it is broken, at the latest [s], or -1; not in the data of older programs
}

/** The parts of a world that a proof names, of the findings whose proofs name any. */
export interface Cited {
  finding: number[];              // rising
  bodies: number[][];             // indices into World.bodies, in the order of the sentence
  points: Vec3[][];               // in the world frame [m]
}

/** The numbers of the proofs that have any, one column a property. Lengths are null where a proof has none [m]. */
export interface Proofs {
  finding: number[];              // rising
  kind: number[]; claim: number[];  // indices into names.proof and names.claim, see reports/finding/proof.h
  said: (number | null)[]; bound: (number | null)[];
  n: (Vec3 | null)[]; offset: (number | null)[]; claimed: (Vec3 | null)[]; points: Vec3[][];
  change: Text[]; body: Text[]; time: (number | null)[];
  angle?: (number | null)[];      // between the places of a body [rad]
}

/** The errors at the step of a world, a half and a quarter of it, of the findings whose cause was told from them. */
export interface Studies { finding: number[]; errors: [number, number, number][]; unit: string[] }

/** The results of a sweep. Columns hold indices into `names` of their own, −1 for none: worlds have no pair, contact questions no law. */
export interface Sweep {
  kind?: "contact" | "world";                   // contact in the data of older programs, which lack all that has a `?`
  settings: { name: string; value: string }[];
  asked: number; failed: number; kept: number;  // questions; failed answers; failures that the file has kept
  /** Answers by their gravest finding. */
  answers: { family: number[]; pair: number[]; oracle: number[]; verdict: number[]; grade: number[]; count: number[] };
  /** Findings: every measure of every answer, over all pairs. */
  findings?: { family: number[]; oracle: number[]; measure: number[]; law: number[]; verdict: number[]; grade: number[]; count: number[] };
  bins_per_decade: number;
  /** `bins`: bin, count, bin, count, …; bin b holds values from 10^(b / bins_per_decade) on. */
  sketches: { pair: number[]; oracle: number[]; measure: number[]; law?: number[]; zeros: number[]; infinite: number[]; bins: number[][] };
  /** The failures whose questions are in `questions`, gravest first. */
  failures: { question: number[]; family?: number[]; pair?: number[]; oracle: number[]; measure: number[]; law?: number[]; verdict: number[]; grade: number[]; value: (number | string)[]; share: number[]; proof: string[]; is_new?: boolean[] };
  /** The worst findings of each measure whose questions are in `questions`, whatever their verdicts, the most tolerances first. */
  worst?: { question: number[]; family: number[]; pair: number[]; oracle: number[]; measure: number[]; law: number[]; verdict: number[]; grade: number[]; value: (number | string)[]; tolerance: (number | string)[]; tolerances: (number | string)[]; share: number[] };
  names: { oracle: string[]; family: string[]; pair: string[]; measure: string[]; law?: string[]; verdict: string[]; grade: string[] };
}

/** The party that is responsible for a fault: the engine, a setting that its adapter chooses, or a simplification that the engine documents. */
export type Responsible = "engine" | "adapter" | "model";

/** Faults with one cause: of one reason of the ledger, or of one engine, measure and cause outside it. */
export interface Cluster {
  title: string;                  // the fault as one sentence
  extent: string;                 // whose it is, in how many scenarios, and the largest error in metres and per cent
  sentence?: string;              // both in one, in the data of runs before there was a title
  reason: string;                 // the ledger's text, or the cause in words
  upstream: string;               // link, "unreported", or ""
  is_new: boolean;                // not in the ledger
  has_outgrown?: boolean;         // in the ledger, and larger than its bound there
  counts?: boolean;               // whether it fails the run; not in the data of older programs
  grade: number;                  // the gravest, index into names.grade
  cause: number;
  responsible?: Responsible;      // not in the data of older programs
  oracles: number[];              // that share it, most affected first
  questions: number[];            // gravest first
  worst: number;                  // finding, index into findings
  error: number; unit: string;    // of the worst, "m"
  share: number;
  ordinary: number;               // 0 … 1, how ordinary its most ordinary question is
}

export interface LedgerEntry {
  scenarios: string[]; oracle: string; version: string; verdict: string; measures: string[]; cause: string; responsible?: Responsible; fault?: string; reason: string; upstream: string; expires: string;
  uses: number;                   // findings that it hides in this run
}
