import { bandOf, bands, findBands, type Band } from "./bands";
import type { Cluster, Report, Track } from "./data";
import { decodeTrack, type ReportData } from "./decode";
import { findLooks, type Look } from "./engines";
import { makeCited, makeProofKinds, makeProofs, makeStudies, turnOf, type CitedParts, type Proof, type StepStudy } from "./proofs";
import { numberOf } from "./format";
import { makeSearch, type Search } from "./search";

/** A report with what every screen derives from it. */
export interface Run {
  report: Report;
  /** Band of each finding, an index into `bands`. */
  band: Uint8Array;
  /** The numbers of the findings of a question, of all its oracles. */
  findingsOf(question: number): Uint32Array;
  /** The gravest finding of an oracle on a question; -1 if it has none. */
  gravest(question: number, oracle: number): number;
  questionOf(id: string): number;
  groups: string[];
  /** Index into `groups` for each question. */
  groupOf: Uint16Array;
  looks: Look[];
  search: Search;
  /** The numbers of the proof of a finding; null if it is words alone. */
  proof(finding: number): Proof | null;
  /** The parts of a world that the proof of a finding names. */
  cited(finding: number): CitedParts;
  study(finding: number): StepStudy | null;
  /** The size of a finding that is mostly an angle: "176° and 3 cm"; null for any other. */
  turn(finding: number): string | null;
  channels(track: Track): Float64Array[];
  text(index: number): string;
}

export function makeRun({ report, blob, text: textOf }: ReportData): Run {
  const band = findBands(report);
  const { question, oracle, share } = report.findings;
  const starts = new Uint32Array(report.questions.length + 1);
  for (const q of question) ++starts[q + 1];
  for (let q = 0; q < report.questions.length; ++q) starts[q + 1] += starts[q];
  const sorted = new Uint32Array(question.length);
  const next = starts.slice();
  question.forEach((q, i) => { sorted[next[q]++] = i; });
  const findingsOf = (q: number): Uint32Array => sorted.subarray(starts[q], starts[q + 1]);

  const ids = new Map(report.questions.map((q, i) => [q.id, i]));
  const groups = [...new Set(report.questions.map((q) => q.group))];
  const groupIndex = new Map(groups.map((g, i) => [g, i]));
  const kept = new Map<number, Float64Array[]>();
  const text = (index: number): string => (index < 0 ? "" : textOf ? textOf(index) : report.texts[index] ?? "");
  const proof = makeProofs(report, text);
  const kindOfProof = makeProofKinds(report);
  return {
    report, band, findingsOf, groups,
    gravest(q, o) {
      let best = -1;
      for (const i of findingsOf(q)) {
        if (oracle[i] !== o) continue;
        if (best < 0 || band[i] < band[best] || (band[i] === band[best] && band[i] < bands.indexOf("undecidable") && share[i] > share[best])) best = i;
      }
      return best;
    },
    questionOf: (id) => ids.get(id) ?? -1,
    groupOf: Uint16Array.from(report.questions, (q) => groupIndex.get(q.group) ?? 0),
    looks: findLooks(report.oracles),
    search: makeSearch(report),
    proof,
    turn: (finding) => (kindOfProof(finding) !== "places" ? null : turnOf(proof(finding), numberOf(report.findings.value[finding]))),
    cited: makeCited(report),
    study: makeStudies(report),
    channels(track) {
      let result = kept.get(track.at);
      if (!result) {
        if (kept.size > 2000) kept.clear();
        result = decodeTrack(blob, track);
        kept.set(track.at, result);
      }
      return result;
    },
    text,
  };
}

/** The engines and the size of a fault. The program says "scenario", and the page says "question". */
export const extentOf = (cluster: Cluster): string => cluster.extent.replace(/\bscenario(s?)\b/g, "question$1");

/** The band of a cluster: the gravest of its findings. */
export const bandOfCluster = (cluster: Cluster): Band => bandOf("fail", cluster.grade);
