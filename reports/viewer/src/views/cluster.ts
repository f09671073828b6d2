import { h } from "../dom";
import { faultAddress, faultName, faultOf } from "../fault_address";
import { downloadFindings, findingAddress, findingsAddress, findingsTable, isLength, nounOf, shareInWords } from "../findings_table";
import { errorOf } from "../error_in_proof";
import { capital, counted } from "../format";
import { leftOut, logHistogram } from "../histogram";
import { barChart } from "../charts";
import { orderBy } from "../filter";
import { bandOfCluster, extentOf } from "../run";
import { thumbnail } from "../scene/thumbnail";
import { responsibleMark, responsibleOf, responsibleTexts } from "../responsible";
import { statusOf } from "../status";
import type { MakeView } from "../view";
import { badge, button, commands, engine, upstreamLink, versionOf } from "../widgets";
import { proofText } from "../proof_text";
import { prose } from "../symbols";
import { contactLegend } from "./contact";
import { notFound } from "./not_found";

/** Ends of the axis of errors, as exponents of the share of the size. */
const [lowest, highest] = [-17, 2];

export const clusterView: MakeView = (run, at) => {
  const { report } = run;
  const { findings: f } = report;
  const number = faultOf(run, at.path[1] ?? "");
  const cluster = report.clusters[number];
  if (!cluster) return notFound(`There is no fault “${at.path[1] ?? ""}”`);
  const found = [...orderBy(run, "severity")].filter((i) => f.cluster[i] === number);
  const question = report.questions[f.question[cluster.worst] ?? cluster.questions[0]];
  const worst = findingAddress(run, cluster.worst);
  const band = bandOfCluster(cluster);
  const status = statusOf(run, cluster);
  const lengths = found.filter((i) => isLength(run, i)).map((i) => Math.abs(f.share[i]));
  const shares = lengths.filter((s) => s > 0);
  const table = findingsTable(run);
  const proof = run.text(f.proof[cluster.worst] ?? -1);
  const cause = report.names.cause[cluster.cause];
  // The ledger's reason may begin with the fault itself, or with its last words: that is the heading.
  const stem = cluster.title.replace(/\.$/, "");
  const begin = cluster.reason.split(/[.:;](?:\s|$)/)[0];
  const said = cluster.reason.startsWith(stem) ? stem.length : begin !== "" && stem.endsWith(begin) ? begin.length : 0;
  const rest = cluster.reason.slice(said).replace(/^[.:;,\s]+/, "");
  const why = said > 0 ? rest.charAt(0).toUpperCase() + rest.slice(1) : rest;
  const element = h("section", { class: "cluster" },
    h("p", { class: "card-head" }, badge(band), responsibleMark(cluster), status.name !== "" && h("span", { class: status.isFailure ? "new" : "quiet" }, `${status.name}: ${status.meaning}`), upstreamLink(cluster.upstream)),
    h("h1", { dir: "auto" }, prose(cluster.title)),
    h("p", { class: "extent" }, extentOf(cluster)),
    h("div", { class: "columns" },
      h("div", { class: "main-column" },
        question && h("a", { href: worst, class: "large-picture", "aria-label": `Open ${question.id}` },
          thumbnail(run, question, [...new Set([f.oracle[cluster.worst], ...cluster.oracles])], cluster.worst, 840, 420)),
        question?.contact && contactLegend(question.contact.truth.patch.length),
        question?.world && h("p", { class: "marks" }, "Solid: the first of the oracles that simulates it. Edges: the second."),
        question && h("p", {}, "Its worst question: ", h("a", { href: worst, dir: "auto" }, question.title), ".")),
      h("div", { class: "side-column" },
        h("h2", {}, "Oracles"), h("p", { class: "engines" }, cluster.oracles.map((o) => h("span", {}, engine(run, o), " ", versionOf(run, o)))),
        h("h2", {}, "How large"),
        h("p", {}, `The worst: ${nounOf(run, cluster.worst)}`, shareInWords(run, cluster.worst) !== "" && `, ${shareInWords(run, cluster.worst)}`, `; ${counted(cluster.questions.length, "question")} in all.`),
        shares.length > 1 && h("figure", {}, barChart(logHistogram(shares, lowest, highest, 38), lowest, highest, "Number of findings by error as a share of the size"), h("figcaption", {}, leftOut(found.length, lengths, [lowest, highest]))),
        why && [h("h2", {}, "Why"), h("p", { dir: "auto" }, prose(why))],
        cause && h("p", {}, h("b", {}, "Cause: "), cause),
        responsibleOf(cluster) !== "engine" && h("p", {}, h("b", {}, `${capital(responsibleTexts[responsibleOf(cluster)].name)}: `), responsibleTexts[responsibleOf(cluster)].meaning),
        proof && [h("h2", {}, "Proof of the worst"), h("p", { dir: "auto", class: "proof" }, proofText(proof, errorOf(run, cluster.worst)))],
        h("h2", {}, "See it yourself"), question && commands(question, "", [["", "touchstone explain ID"]]))),
    h("h2", {}, "Its findings"),
    h("p", { class: "count" }, counted(found.length, "finding"), " ", h("a", { href: findingsAddress({ cluster: faultName(run, number) }) }, "filter and sort them"), " ", button("CSV", () => downloadFindings(run, found), { class: "small" })),
    table.element);
  queueMicrotask(() => table.set(found));
  const step = (by: number): void => { if (report.clusters[number + by]) location.hash = faultAddress(run, number + by); };
  return {
    title: cluster.title, element,
    keys: [
      { keys: ["j"], does: "next fault", run: () => step(1) },
      { keys: ["k"], does: "previous fault", run: () => step(-1) },
      { keys: ["u"], does: "up to all faults", run: () => { location.hash = "#/"; } },
      { keys: ["o"], does: "open its worst question", run: () => { location.hash = worst; } },
    ],
    dispose: () => table.dispose(),
  };
};
