import { h, type Child } from "./dom";
import { findingAddress, nounOf, shareInWords, silentNouns, valueOf, wordsOf } from "./findings_table";
import { faultAddress } from "./fault_address";
import { counted } from "./format";
import { errorOf, withError } from "./error_in_proof";
import { proofClause } from "./proof_clause";
import { bandOfCluster, extentOf, type Run } from "./run";
import { thumbnail } from "./scene/thumbnail";
import { responsibleMark } from "./responsible";
import { statusOf } from "./status";
import { badge, engine, upstreamLink } from "./widgets";
import { marker } from "./engines";

/** Causes in words that a reader understands who has never seen the page. */
export const causeTexts: Record<string, { name: string; meaning: string }> = {
  convention: { name: "a convention", meaning: "Converted from another known convention, the answer is right." },
  tie: { name: "a tie", meaning: "Several answers are equally right, and a rounding decides between them." },
  precision: { name: "rounding", meaning: "The arithmetic of the engine: the answer is right for an input that differs by roundings." },
  discretisation: { name: "the time step", meaning: "The error vanishes as the time step gets smaller." },
  model: { name: "its model", meaning: "The engine solves another problem on purpose: rounded corners, a margin, another law." },
  setting: { name: "our setting", meaning: "The adapter of this repository changes a default of the engine. With the defaults, the engine is right." },
  defect: { name: "a defect", meaning: "No convention, tie, rounding, time step or model accounts for it." },
};

/** The engines that share a fault: the libraries, or the oracles if all are of one library. */
function enginesOf(run: Run, list: number[]): HTMLElement {
  const { oracles } = run.report;
  const title = list.map((o) => oracles[o].name).join(", ");
  const first = new Map<string, number>();
  for (const o of list) if (!first.has(oracles[o].library)) first.set(oracles[o].library, o);
  if (first.size === 1) {
    const most = list.length > 3 ? 2 : 3;
    return h("p", { class: "engines", title }, list.slice(0, most).map((o) => engine(run, o)), list.length > most && h("span", { class: "quiet" }, `and ${list.length - most} more`), h("span", { class: "version" }, `${oracles[list[0]].library} ${oracles[list[0]].version}`));
  }
  return h("p", { class: "engines", title }, [...first].map(([library, o]) => h("span", { class: "engine" }, marker(run.looks[o]), h("span", { class: "name" }, library), h("span", { class: "version" }, oracles[o].version))));
}

/** How large a fault is at its worst: the error of its worst finding, and its share of the size. */
export function sizeOf(run: Run, c: number): { value: string; part: string } {
  const { worst, unit } = run.report.clusters[c];
  if (unit === "" && wordsOf(run, worst) === "") return { value: nounOf(run, worst), part: "" };
  return { value: wordsOf(run, worst) in silentNouns ? nounOf(run, worst) : valueOf(run, worst), part: shareInWords(run, worst) };
}

/** The proof of the worst finding of a fault, in short. */
const clauseOf = (run: Run, c: number): string => proofClause(run.text(run.report.findings.proof[run.report.clusters[c].worst] ?? -1));

/** The height that a row is thought to have before it was in sight [px]. */
export const faultRowHeight = (): number => (innerWidth < 760 ? 190 : innerWidth < 1100 ? 96 : 62);

/** A fault in a line of the ranked list: what is wrong and the proof, whose, how large, why. */
export function faultRow(run: Run, c: number, rank: number): HTMLElement {
  const { report } = run;
  const cluster = report.clusters[c];
  const question = report.questions[report.findings.question[cluster.worst] ?? cluster.questions[0]];
  const oracle = report.findings.oracle[cluster.worst] ?? cluster.oracles[0];
  const clause = clauseOf(run, c);
  const worst = findingAddress(run, cluster.worst);
  const cause = report.names.cause[cluster.cause] ?? "";
  const status = statusOf(run, cluster);
  const size = sizeOf(run, c);
  const cell = (name: string, ...children: Child[]): HTMLElement => h("div", { class: name }, children);
  return h("div", { role: "listitem", class: "card" },
    cell("card-rank number", String(rank)),
    h("a", { href: worst, class: "card-picture", tabindex: "-1", "aria-hidden": "true" },
      question && thumbnail(run, question, [oracle], cluster.worst, 84, 58)),
    cell("card-text",
      h("h2", {}, h("a", { href: worst, dir: "auto", title: `${cluster.title}\nOpens its worst question: ${question?.title ?? ""}` }, cluster.title)),
      clause !== "" && h("p", { class: "proof-line", dir: "auto", title: run.text(report.findings.proof[cluster.worst]) }, h("b", {}, "Proof: "), withError(clause, errorOf(run, cluster.worst), (part) => part))),
    cell("card-engines", enginesOf(run, cluster.oracles)),
    cell("card-size", h("p", {}, h("b", { class: "size" }, size.value), size.part && [" ", h("span", { class: "part" }, size.part)]),
      h("p", { class: "extent" }, h("a", { href: faultAddress(run, c), title: extentOf(cluster) }, `in ${counted(cluster.questions.length, "question")}`))),
    cell("card-why", h("p", { class: "card-head" }, badge(bandOfCluster(cluster)), responsibleMark(cluster) ?? h("span", cause === "" ? { title: `An answer without a number has none that a study could tell apart.${cluster.reason === "" ? "" : ` The ledger says: ${cluster.reason}`}` } : { title: causeTexts[cause]?.meaning ?? cause }, cause === "" ? "cause not studied" : causeTexts[cause]?.name ?? cause)),
      h("p", { class: "card-status" }, status.name !== "" && h("span", { class: status.isFailure ? "new" : "quiet", title: status.meaning }, status.name), status.name !== "" && cluster.upstream !== "" && " · ", upstreamLink(cluster.upstream))));
}
