import { address } from "../address";
import { h } from "../dom";
import { downloadFindings, findingAddress, findingsAddress, findingsTable, headingOf } from "../findings_table";
import { counted, digits, share } from "../format";
import { logHistogram } from "../histogram";
import { barChart } from "../charts";
import { orderBy } from "../filter";
import { bandOfCluster } from "../run";
import { thumbnail } from "../scene/thumbnail";
import type { MakeView } from "../view";
import { badge, button, command, engine, upstreamLink } from "../widgets";
import { prose } from "../symbols";
import { contactLegend } from "./contact";
import { notFound } from "./not_found";

export const clusterView: MakeView = (run, at) => {
  const { report } = run;
  const { findings: f } = report;
  const number = Number(at.path[1]);
  const cluster = report.clusters[number];
  if (!cluster) return notFound(`There is no fault number ${at.path[1] ?? ""}`);
  const found = [...orderBy(run, "gravity")].filter((i) => f.cluster[i] === number);
  const question = report.questions[f.question[cluster.worst] ?? cluster.questions[0]];
  const worst = findingAddress(run, cluster.worst);
  const band = bandOfCluster(run, cluster);
  const shares = found.filter((i) => report.names.measure[f.measure[i]]?.kind === "length").map((i) => Math.abs(f.share[i])).filter((s) => s > 0);
  const table = findingsTable(run);
  const proof = run.text(f.proof[cluster.worst] ?? -1);
  const cause = report.names.cause[cluster.cause];
  // The ledger's reason may begin with the fault itself, which is the heading.
  const stem = cluster.title.replace(/\.$/, "");
  const why = (cluster.reason.startsWith(stem) ? cluster.reason.slice(stem.length) : cluster.reason).replace(/^[.:;,\s]+/, "");
  const element = h("section", { class: "cluster" },
    h("p", { class: "card-head" }, badge(band), h("span", { class: cluster.is_new ? "new" : "quiet" }, cluster.is_new ? "new: not in the ledger" : "known: in the ledger"), upstreamLink(cluster.upstream)),
    h("h1", { dir: "auto" }, prose(cluster.title)),
    h("p", { class: "extent" }, cluster.extent),
    h("div", { class: "columns" },
      h("div", { class: "main-column" },
        question && h("a", { href: worst, class: "large-picture", "aria-label": `Open ${question.id}` },
          thumbnail(run, question, cluster.oracles, f.time?.[cluster.worst] ?? -1, 840, 420)),
        question?.contact && contactLegend(question.contact.truth.patch.length > 1),
        question?.world && h("p", { class: "marks" }, "Solid: the first oracle below that simulates it. Edges: the second."),
        question && h("p", {}, "Its worst question: ", h("a", { href: worst, dir: "auto" }, question.title), ".")),
      h("div", { class: "side-column" },
        h("h2", {}, "Oracles"), h("p", { class: "engines" }, cluster.oracles.map((o) => engine(run, o))),
        h("h2", {}, "How large"),
        h("p", {}, `The worst: ${headingOf(run, cluster.worst)}`, cluster.unit === "m" && `, ${share(cluster.share)}`, `; ${counted(cluster.questions.length, "question")} in all.`),
        shares.length > 1 && h("figure", {}, barChart(logHistogram(shares, -17, 2, 38), -17, 2, "Number of findings by error as a share of the size"), h("figcaption", {}, `${counted(shares.length, "finding")} by error as a share of the size, logarithmic`)),
        why && [h("h2", {}, "Why"), h("p", { dir: "auto" }, prose(why))],
        cause && h("p", {}, h("b", {}, "Cause: "), cause),
        proof && [h("h2", {}, "Proof of the worst"), h("p", { dir: "auto", class: "proof" }, prose(proof))],
        h("h2", {}, "See it yourself"), question && command(`touchstone explain ${question.id}`))),
    h("h2", {}, "Its findings"),
    h("p", { class: "count" }, counted(found.length, "finding"), " ", h("a", { href: findingsAddress({ cluster: String(number) }) }, "filter and sort them"), " ", button("CSV", () => downloadFindings(run, found), { class: "small" })),
    table.element);
  queueMicrotask(() => table.set(found));
  const step = (by: number): void => { if (report.clusters[number + by]) location.hash = address(["f", String(number + by)]); };
  return {
    title: `Fault ${number + 1}, ${digits(found.length)} findings`, element,
    keys: [
      { keys: ["j"], does: "next fault", run: () => step(1) },
      { keys: ["k"], does: "previous fault", run: () => step(-1) },
      { keys: ["u"], does: "up to all faults", run: () => { location.hash = "#/"; } },
      { keys: ["o"], does: "open its worst question", run: () => { location.hash = worst; } },
    ],
    dispose: () => table.dispose(),
  };
};
