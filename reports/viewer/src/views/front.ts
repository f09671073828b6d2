import { address, toggled, valuesOf, withValue, type Address } from "../address";
import { bands, bandTexts, faultBands, type Band } from "../bands";
import { countsList } from "../counts";
import { fill, h } from "../dom";
import { findingsAddress, headingOf } from "../findings_table";
import { counted } from "../format";
import { bandOfCluster, type Run } from "../run";
import { thumbnail } from "../scene/thumbnail";
import { prose } from "../symbols";
import type { MakeView } from "../view";
import { virtualList } from "../virtual";
import { badge, engine, upstreamLink } from "../widgets";
import { smallMatrix } from "./matrix";

/** Orders of the faults: the largest value first, and equal ones in the order of the report. */
const orders: { key: string; name: string; of(run: Run, cluster: number): number }[] = [
  { key: "harm", name: "worst for a user first", of: () => 0 },
  { key: "share", name: "largest error of the size first", of: ({ report }, c) => (report.clusters[c].unit === "m" ? report.clusters[c].share : -1) },
  { key: "questions", name: "most questions first", of: ({ report }, c) => report.clusters[c].questions.length },
  { key: "oracles", name: "most oracles first", of: ({ report }, c) => report.clusters[c].oracles.length },
  { key: "ordinary", name: "most ordinary question first", of: ({ report }, c) => report.clusters[c].ordinary },
  { key: "new", name: "new ones first", of: ({ report }, c) => (report.clusters[c].is_new ? 1 : 0) },
];

/** The oracles that passed something and have no fault. */
function neverWrong({ report, band }: Run): number[] {
  const [passed, wrong] = [new Set<number>(), new Set<number>()];
  report.findings.oracle.forEach((o, i) => {
    if (bands[band[i]] === "passed") passed.add(o);
    else if (band[i] < faultBands.length) wrong.add(o);
  });
  return [...passed].filter((o) => !wrong.has(o)).sort((a, b) => a - b);
}

/** How many faults each oracle has a part in: those that are grave or unusable, and all. */
function faultsByOracle(run: Run, clusterBands: Band[]): HTMLElement {
  const { clusters, oracles } = run.report;
  const rows = oracles.map((_, o) => {
    const own = clusters.map((_c, c) => c).filter((c) => clusters[c].oracles.includes(o));
    return { o, all: own.length, grave: own.filter((c) => clusterBands[c] === "grave" || clusterBands[c] === "crash").length };
  }).filter(({ all }) => all > 0).sort((a, b) => b.grave - a.grave || b.all - a.all || a.o - b.o);
  return h("table", { class: "plain" },
    h("thead", {}, h("tr", {}, h("th", { scope: "col" }, "Oracle"), ["Grave", "All"].map((t) => h("th", { scope: "col", class: "number" }, t)))),
    h("tbody", {}, rows.map(({ o, all, grave }) => h("tr", {}, h("th", { scope: "row" }, engine(run, o)), h("td", { class: "number" }, grave), h("td", { class: "number" }, all)))));
}

/** Whether the run passes, and which faults it knows: two statements, so that neither is taken for the other. */
function conclusionOf(run: Run): HTMLElement {
  const { report } = run;
  const fresh = report.clusters.filter((c) => c.is_new).length;
  const known = report.clusters.filter((c) => !c.is_new);
  const engines = new Set(known.flatMap((c) => c.oracles.map((o) => report.oracles[o].library)));
  const outside = `${counted(fresh, "fault")} ${fresh === 1 ? "is" : "are"} not in the ledger`;
  const why = report.failed ? (fresh > 0 ? `. ${outside}.` : ".")
    : report.clusters.length === 0 ? ": no fault was found." : fresh === 0 ? ": every failure is in the ledger of known faults." : `, although ${outside}.`;
  return h("div", { class: report.failed ? "conclusion failed" : "conclusion" },
    h("p", { class: "passes" }, h("b", {}, report.failed ? "✗ The run fails" : "✓ The run passes"), why),
    known.length > 0 && h("p", { class: "faulty" }, h("b", {}, `${counted(known.length, "fault")} of ${counted(engines.size, "engine")}`), ` ${known.length === 1 ? "is" : "are"} proved and known.`),
    h("p", { class: "quiet" }, report.conclusion));
}

export const frontView: MakeView = (run, start) => {
  const { report } = run;
  const clusterBands: Band[] = report.clusters.map((c) => bandOfCluster(run, c));
  let shown: number[] = [];
  let chosen = -1;

  const card = (place: number): HTMLElement => {
    const c = shown[place];
    const cluster = report.clusters[c];
    const question = report.questions[report.findings.question[cluster.worst] ?? cluster.questions[0]];
    const proof = run.text(report.findings.proof[cluster.worst] ?? -1) || headingOf(run, cluster.worst);
    return h("div", { role: "listitem", class: "card" },
      h("a", { href: address(["f", String(c)]), class: "card-picture", tabindex: "-1", "aria-hidden": "true" },
        question && thumbnail(run, question, cluster.oracles, report.findings.time?.[cluster.worst] ?? -1)),
      h("div", { class: "card-text" },
        h("p", { class: "card-head" }, badge(clusterBands[c]), h("span", { class: cluster.is_new ? "new" : "quiet", title: cluster.is_new ? "not in the ledger" : "in the ledger of known and accepted faults" }, cluster.is_new ? "new" : "known"), upstreamLink(cluster.upstream),
          h("a", { href: findingsAddress({ cluster: String(c) }) }, counted(cluster.questions.length, "question"))),
        h("h2", {}, h("a", { href: address(["f", String(c)]), dir: "auto", title: cluster.title }, cluster.title)),
        h("p", { class: "extent" }, cluster.extent),
        h("p", { class: "proof-line", dir: "auto", title: proof }, prose(proof)),
        h("p", { class: "engines" }, cluster.oracles.slice(0, 8).map((o) => engine(run, o)), cluster.oracles.length > 8 && h("span", { class: "quiet" }, `and ${cluster.oracles.length - 8} more`))));
  };
  const list = virtualList("list", () => (innerWidth < 760 ? 268 : innerWidth < 1400 ? 194 : 186), card);
  let current = start.query;
  const sort = h("select", { "aria-label": "Order of the faults", on: { change: () => { location.hash = address([], withValue(current, "sort", sort.value === orders[0].key ? "" : sort.value)); } } },
    orders.map(({ key, name }) => h("option", { value: key }, name)));
  const chips = h("div", { class: "chips", role: "group", "aria-label": "Bands" });
  const show = (query: URLSearchParams): void => {
    current = query;
    const wanted = valuesOf(query, "band");
    shown = report.clusters.map((_, c) => c).filter((c) => wanted.length === 0 || wanted.includes(clusterBands[c]));
    chosen = -1;
    fill(chips, faultBands.map((band) => h("a", {
      class: `chip ${band}`, href: address([], toggled(query, "band", band)), "aria-current": wanted.includes(band) ? "true" : undefined, title: bandTexts[band].meaning,
    }, h("span", { "aria-hidden": "true" }, bandTexts[band].glyph), ` ${bandTexts[band].name} `, h("b", {}, clusterBands.filter((b) => b === band).length))));
    const order = orders.find(({ key }) => key === query.get("sort")) ?? orders[0];
    sort.value = order.key;
    const values = shown.map((c) => order.of(run, c));
    shown = shown.map((c, i) => [c, i] as const).sort((a, b) => values[b[1]] - values[a[1]] || a[1] - b[1]).map(([c]) => c);
    list.setCount(shown.length);
  };

  const perVerdict = report.names.verdict.map(() => 0);
  for (const v of report.findings.verdict) ++perVerdict[v];
  const graves = clusterBands.filter((b) => b === "grave" || b === "crash").length;
  const fresh = report.clusters.filter((c) => c.is_new).length;
  const ours = report.clusters.filter((c) => c.oracles.includes(report.subject)).length;
  const right = neverWrong(run);
  const subject = report.oracles[report.subject]?.name ?? "the subject";
  const element = h("section", { class: "front" },
    h("h1", { class: "visually-hidden" }, "What the run found"),
    h("p", { class: "sentence" }, report.sentence, " ",
      report.clusters.length === 0 ? "No fault was found."
        : `They show ${counted(report.clusters.length, "fault")}; ${graves === 0 ? "none" : graves} of them ${graves === 1 ? "is" : "are"} grave or leave no usable answer, ${fresh === 0 ? "none" : fresh} ${fresh === 1 ? "is" : "are"} new, ${ours === 0 ? "none" : ours} ${ours === 1 ? "is" : "are"} in ${subject}.`),
    conclusionOf(run), countsList(run),
    right.length > 0 && h("p", { class: "engines" }, h("span", {}, "Never proved wrong:"), right.map((o) => engine(run, o))),
    report.faults.length > 0 && h("details", { class: "notes" }, h("summary", {}, counted(report.faults.length, "remark") + " on the scenario files and the ledger"), h("ul", {}, report.faults.slice(0, 200).map((fault) => h("li", {}, fault)))),
    report.regressions.length > 0 && h("details", { class: "notes", open: true }, h("summary", {}, counted(report.regressions.length, "regression")), h("ul", {}, report.regressions.slice(0, 200).map((r) => h("li", {}, h("b", {}, r.oracle), " ", r.what)))),
    h("div", { class: "columns" },
      h("div", { class: "main-column" }, h("div", { class: "toolbar" }, chips, h("div", { class: "sort" }, sort)), list.element),
      h("div", { class: "side-column" },
        h("h2", {}, h("a", { href: "#/matrix" }, "Groups × oracles")), smallMatrix(run),
        h("h2", {}, h("a", { href: "#/oracles" }, "Faults by oracle")), faultsByOracle(run, clusterBands),
        h("h2", {}, "Measurements by verdict"),
        h("table", { class: "plain" }, h("tbody", {}, report.names.verdict.map((verdict, v) => perVerdict[v] > 0 && h("tr", {},
          h("th", { scope: "row" }, h("a", { href: findingsAddress({ verdict }) }, verdict)), h("td", { class: "number" }, perVerdict[v].toLocaleString("en")))))),
        h("h2", {}, "Bands"),
        h("dl", { class: "bands" }, bands.map((band) => [h("dt", {}, badge(band)), h("dd", {}, bandTexts[band].meaning)])))));
  queueMicrotask(() => show(start.query));

  const move = (step: number): void => {
    if (shown.length === 0) return;
    chosen = Math.max(0, Math.min(shown.length - 1, chosen + step));
    list.reveal(chosen);
    list.element.querySelector<HTMLElement>(`[data-index="${chosen}"] h2 a`)?.focus({ preventScroll: true });
  };
  return {
    title: "What the run found", element,
    keys: [
      { keys: ["j"], does: "next fault", run: () => move(1) },
      { keys: ["k"], does: "previous fault", run: () => move(-1) },
      { keys: ["o"], does: "open the fault", run: () => { if (chosen >= 0) location.hash = address(["f", String(shown[chosen])]); } },
    ],
    update(next: Address) { show(next.query); return true; },
    dispose: () => list.dispose(),
  };
};
