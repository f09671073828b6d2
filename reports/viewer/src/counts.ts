import { bands, faultBands } from "./bands";
import { h } from "./dom";
import { counted } from "./format";
import type { Run } from "./run";

/** How many of each thing a run has, and how many of them show a fault. */
export interface Counts {
  faults: number;
  /** Questions with a finding, and all. */
  questions: number; allQuestions: number;
  /** Pairs of a question and an oracle with a finding, and all that were measured. */
  answers: number; allAnswers: number;
  /** Measurements that are faults, and all. */
  findings: number; measurements: number;
}

const kept = new WeakMap<Run, Counts>();

export function countsOf(run: Run): Counts {
  const known = kept.get(run);
  if (known) return known;
  const { findings: f, questions, oracles, clusters } = run.report;
  const unasked = bands.indexOf("unasked");
  const best = new Uint8Array(questions.length * oracles.length).fill(unasked);
  let [findings, measurements] = [0, 0];
  for (let i = 0; i < f.question.length; ++i) {
    const at = f.question[i] * oracles.length + f.oracle[i];
    best[at] = Math.min(best[at], run.band[i]);
    if (run.band[i] < faultBands.length) ++findings;
    if (run.band[i] !== unasked) ++measurements;
  }
  const wrongQuestions = new Set<number>();
  let [answers, allAnswers] = [0, 0];
  best.forEach((band, at) => {
    if (band === unasked) return;
    ++allAnswers;
    if (band >= faultBands.length) return;
    ++answers;
    wrongQuestions.add(Math.floor(at / oracles.length));
  });
  const counts = { faults: clusters.length, questions: wrongQuestions.size, allQuestions: questions.length, answers, allAnswers, findings, measurements };
  kept.set(run, counts);
  return counts;
}

/** The counts side by side, each with what it counts; the same on every screen that has one of them. */
export function countsList(run: Run): HTMLElement {
  const c = countsOf(run);
  const of = (all: number, noun: string): string => `of ${counted(all, noun)}`;
  const items: [string, string][] = [
    [counted(c.faults, "fault"), "One fault is one cause, shown by any number of findings."],
    [counted(c.questions, "question"), `with a fault, ${of(c.allQuestions, "question")}. A question is a scenario: a contact question or a world.`],
    [counted(c.answers, "answer"), `with a fault, ${of(c.allAnswers, "answer")}. An answer is what one oracle says to one question; a crash is one too.`],
    [counted(c.findings, "finding"), `${of(c.measurements, "measurement")}. A finding is one wrong measurement of an answer.`],
  ];
  return h("dl", { class: "counts", "aria-label": "What is counted" }, items.map(([count, meaning]) => h("div", {}, h("dt", {}, count), h("dd", {}, meaning))));
}
