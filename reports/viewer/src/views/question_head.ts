import { bands, faultBands } from "../bands";
import type { Question, Shape } from "../data";
import { fill, h, type Child } from "../dom";
import { errorOf, withError } from "../error_in_proof";
import { findingsAddress, headingOf, measureOf, shareInWords, valueOf, wordsOf } from "../findings_table";
import { faultAddress } from "../fault_address";
import { digits } from "../format";
import { proofClause } from "../proof_clause";
import { responsibleMarkOf } from "../responsible";
import type { Run } from "../run";
import { badge, versionOf } from "../widgets";
import { badgeOn } from "./verdicts";

/** The heading of a question: what was asked, and the fault that is explained, with its proof. */
export interface QuestionHead {
  element: HTMLElement;
  /** Says which finding is explained; -1 for none. */
  tell(finding: number): void;
}

/** @param asked the question in one sentence */
export function questionHead(run: Run, question: Question, asked: Child): QuestionHead {
  const told = h("div", { class: "told", role: "status" });
  return {
    element: h("header", { class: "question-head" },
      h("p", { class: "quiet where" }, h("a", { href: findingsAddress({ group: question.group }) }, question.group), question.pair && ` · ${question.pair}`, " · ", h("span", { class: "id" }, question.id)),
      h("h1", { dir: "auto" }, question.title),
      h("p", { class: "asked" }, h("b", {}, "Asked: "), asked),
      told),
    tell(finding) {
      told.hidden = finding < 0;
      if (finding < 0) return;
      told.style.setProperty("border-color", `var(--${bands[run.band[finding]]})`);
      fill(told, ...faultOf(run, finding));
    },
  };
}

/** The fault of a finding, and its proof in short. */
function faultOf(run: Run, finding: number): Child[] {
  const { findings: f, clusters, oracles } = run.report;
  const band = bands[run.band[finding]];
  const name = oracles[f.oracle[finding]].name;
  const c = f.cluster[finding];
  const proof = run.text(f.proof[finding]);
  if (run.band[finding] >= faultBands.length) return [h("p", {}, badgeOn(run, f.question[finding], f.oracle[finding], finding), " ", h("b", {}, name), " ", versionOf(run, f.oracle[finding]), band === "passed" ? ": no measurement of it shows a fault." : proof !== "" && `: ${proofClause(proof)}`)];
  const title = clusters[c]?.title;
  return [
    h("p", {}, badge(band), " ", [responsibleMarkOf(run, finding), " "], h("b", {}, name), " ", versionOf(run, f.oracle[finding]), ": ", title ? h("a", { class: "told-fault", dir: "auto", href: faultAddress(run, c), title: "Opens this fault with all its questions" }, title) : h("span", { class: "told-fault" }, headingOf(run, finding))),
    h("p", { class: "told-error" }, "Error: ", h("b", { class: "error-value" }, valueOf(run, finding)), ` (${[wordsOf(run, finding) === "" && measureOf(run, finding), shareInWords(run, finding)].filter((part) => part !== false && part !== "").join(", ") || "no size"})`),
    proof !== "" && h("p", { class: "proof-line", dir: "auto", title: proof }, h("b", {}, "Proof: "), withError(proofClause(proof), errorOf(run, finding), (part) => part))];
}

const names: Record<Shape["type"], string> = { sphere: "a sphere", box: "a box", capsule: "a capsule", cylinder: "a cylinder", cone: "a cone", half_space: "a half-space", hull: "a convex hull" };

/** The question of two shapes in one sentence. */
export const askedOfContact = (A: Shape, B: Shape): string => `do A, ${names[A.type]}, and B, ${names[B.type]}, touch; how deep or how far apart, along which normal and where?`;

/** Words for a gravity [m/s²]. */
export const gravityInWords = (g: number[]): string => (g.every((x) => x === 0) ? "without gravity" : `under gravity (${g.map((x) => digits(x, 4)).join(", ")}) m/s²`);
