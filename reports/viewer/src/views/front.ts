import { address, questionAddress, toggled, valuesOf, withValue, type Address } from "../address";
import { bands, bandTexts, faultBands, sizeMeaning, type Band } from "../bands";
import { countsList, countsOf } from "../counts";
import { fill, h, type Child } from "../dom";
import { faultRow, faultRowHeight } from "../fault_row";
import { findingAddress, findingsAddress, silentNouns, wordsOf } from "../findings_table";
import { capital, counted } from "../format";
import { bandOfCluster, type Run } from "../run";
import { responsibleOf, responsibles, responsibleTexts } from "../responsible";
import { hasLedger } from "../status";
import type { MakeView } from "../view";
import { virtualList } from "../virtual";
import { badge, engine } from "../widgets";
import { smallMatrix } from "./matrix";

/** Orders of the faults: the largest value first, and equal ones in the order of the report. */
const orders: { key: string; name: string; weighs: string; of(run: Run, cluster: number): number }[] = [
  { key: "harm", name: "worst for a user first", weighs: "Graver first. 4 × the engines or 10 × the questions count as a grade more, unusual questions as up to one less.", of: () => 0 },
  { key: "share", name: "largest share of the size first", weighs: "By the largest error as a share of the size. No usable answer comes first, counts come last.", of: (run, c) => (wordsOf(run, run.report.clusters[c].worst) in silentNouns ? Infinity : run.report.clusters[c].unit === "" ? -1 : run.report.clusters[c].share) },
  { key: "metres", name: "largest error in metres first", weighs: "By the largest error that is a length, in metres. Others come last.", of: ({ report }, c) => (report.clusters[c].unit === "m" && typeof report.clusters[c].error === "number" ? report.clusters[c].error : -1) },
  { key: "questions", name: "most questions first", weighs: "By the number of questions that show the fault.", of: ({ report }, c) => report.clusters[c].questions.length },
  { key: "oracles", name: "most oracles first", weighs: "By the number of oracles that share the fault.", of: ({ report }, c) => report.clusters[c].oracles.length },
  { key: "ordinary", name: "most ordinary question first", weighs: "By how ordinary the most ordinary of its questions is: sizes, masses, steps and distances that every engine is used for.", of: ({ report }, c) => report.clusters[c].ordinary },
  { key: "new", name: "new ones first", weighs: "Faults that the ledger does not know, or allows less of, come first.", of: ({ report }, c) => (report.clusters[c].is_new || report.clusters[c].has_outgrown ? 1 : 0) },
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

/** How many faults each oracle has a part in: those over 10 % or graver, and all. */
function faultsByOracle(run: Run, clusterBands: Band[]): HTMLElement {
  const { clusters, oracles } = run.report;
  const rows = oracles.map((_, o) => {
    const own = clusters.map((_c, c) => c).filter((c) => clusters[c].oracles.includes(o));
    return { o, all: own.length, grave: own.filter((c) => bands.indexOf(clusterBands[c]) <= bands.indexOf("grave")).length };
  }).filter(({ all }) => all > 0).sort((a, b) => b.grave - a.grave || b.all - a.all || a.o - b.o);
  return h("table", { class: "plain" },
    h("thead", {}, h("tr", {}, h("th", { scope: "col" }, "Oracle"), ["Over 10 % or graver", "All"].map((t) => h("th", { scope: "col", class: "number" }, t)))),
    h("tbody", {}, rows.map(({ o, all, grave }) => h("tr", {}, h("th", { scope: "row" }, engine(run, o)), h("td", { class: "number" }, grave), h("td", { class: "number" }, all)))));
}

/** A list of clauses as one sentence: "a, b and c". */
const inARow = (parts: Child[]): Child[] => parts.flatMap((part, i) => (i === 0 ? [part] : [i + 1 === parts.length ? " and " : ", ", part]));

/** Why a run fails, in clauses: nothing verified, new faults, known ones that have grown, the files. */
function reasonsToFail(run: Run): Child[] {
  const { failed, subject, exit_code } = run.report;
  if (exit_code === 2) return [`no answer of ${run.report.oracles[subject].name} was verified`];
  // A run fails by what counts for the exit code, and by nothing else.
  const clusters = run.report.clusters.filter(({ counts }) => !failed || counts !== false);
  const regressions = run.report.regressions;
  // Remarks on the files would fail the run.
  const faults = failed ? run.report.faults : [];
  const verb = (n: number, one: string, many: string): string => (n === 1 ? one : many);
  const outgrown = clusters.filter((c) => c.has_outgrown).length;
  const fresh = clusters.filter((c) => c.is_new).length;
  const improved = faults.filter(isImproved).length;
  const link = (text: string): HTMLElement => h("a", { href: address([], { sort: "new" }) }, text);
  return [
    fresh > 0 && link(`${counted(fresh, "fault")} ${verb(fresh, "is", "are")} ${hasLedger(run) ? "not in the ledger" : "found"}`),
    outgrown > 0 && link(`${counted(outgrown, "known fault")} ${verb(outgrown, "is", "are")} now larger than the ledger allows`),
    improved > 0 && `${counted(improved, "entry", "entries")} of the ledger ${verb(improved, "hides", "hide")} less than ${verb(improved, "it allows", "they allow")} and can be lowered or removed`,
    faults.length > improved && `${counted(faults.length - improved, "scenario file or entry", "scenario files or entries")} of the ledger ${verb(faults.length - improved, "is", "are")} at fault`,
    regressions.length > 0 && `${counted(regressions.length, "finding")} ${verb(regressions.length, "is", "are")} worse than in the baseline`,
  ].filter((reason) => reason !== false);
}

/** Whether a remark says that an entry of the ledger has become needless: nothing is wrong but the ledger. */
const isImproved = (fault: string): boolean => fault.includes(": improved: ");

/** Whether the run passes, and why it may pass with faults. */
function conclusionOf(run: Run): HTMLElement {
  const { report } = run;
  if (report.sweep) return h("div", { class: "conclusion" }, h("p", {}, "These are failures that the sweep has kept, asked again, and the worst cases of each measure. ", h("a", { href: address(["sweep"]) }, "The sweep"), " says how often faults occur."));
  const reasons = reasonsToFail(run);
  const why: Child = report.failed ? (reasons.length ? [": ", inARow(reasons), "."] : ["."])
    : report.clusters.length === 0 ? [": no fault was found."] : reasons.length === 0 ? [": every fault is in the ledger of accepted ones."] : [", although ", inARow(reasons), "."];
  return h("p", { class: report.failed ? "conclusion failed" : "conclusion" },
    h("span", { class: "passes" }, h("b", {}, report.failed ? "✗ The run fails" : "✓ The run passes"), why), " ", subjectOf(run));
}

/** The subject, and how it did. */
function subjectOf({ report, band }: Run): Child {
  const subject = report.oracles[report.subject];
  if (!subject) return null;
  const own = report.clusters.filter((c) => c.oracles.includes(report.subject)).length;
  const passed = report.findings.oracle.some((o, i) => o === report.subject && bands[band[i]] === "passed");
  const answered = new Set(report.findings.question.filter((_, i) => report.findings.oracle[i] === report.subject && bands[band[i]] !== "unasked")).size;
  const others = report.oracles.length - 1;
  return [h("a", { href: address(["oracles", subject.name]) }, subject.name), `, ${subject.library === "Touchstone" ? "the engine of this repository" : `${subject.library} ${subject.version}`}, is the engine under examination: `,
    own > 0 ? `it has a part in ${counted(own, "fault")}` : passed ? `it answers ${answered.toLocaleString("en")} of ${counted(report.questions.length, "question")} and was never proved wrong` : "it answered nothing here",
    others > 0 && `. ${others === 1 ? "The other oracle is" : `The other ${others} oracles are`} measured by the same truth`, "."];
}

/** Says what a run without a fault has verified. Lists its questions, one in a line, at most as many as a first screen has faults. */
function verified(run: Run): HTMLElement {
  const { report, band } = run;
  const ofQuestion = report.questions.map(() => ({ passed: new Set<number>(), open: new Set<number>() }));
  let [passed, undecidable] = [0, 0];
  report.findings.question.forEach((q, i) => {
    const kind = bands[band[i]];
    if (kind === "passed") { ++passed; ofQuestion[q].passed.add(report.findings.oracle[i]); }
    if (kind === "undecidable") { ++undecidable; ofQuestion[q].open.add(report.findings.oracle[i]); }
  });
  const { allAnswers, measurements } = countsOf(run);
  const of = `${counted(allAnswers, "answer")} to ${counted(report.questions.length, "question")}`;
  const sentence = passed === 0 ? "No answer could be measured, so nothing was verified."
    : undecidable === 0 ? `Verified: ${measurements === 1 ? "the only measurement" : `all ${counted(measurements, "measurement")}`} of ${of} ${measurements === 1 ? "is" : "are"} right to within the derived tolerance.`
      : `Verified: ${passed.toLocaleString("en")} of ${counted(measurements, "measurement")} of ${of} are right to within the derived tolerance. ${undecidable === 1 ? "One is" : `${undecidable.toLocaleString("en")} are`} undecidable: the truth is not known, or what must be allowed is more than a hundredth of the size.`;
  // Those that leave something open come first.
  const asked = report.questions.map((_, q) => q).sort((a, b) => Number(ofQuestion[b].open.size > 0) - Number(ofQuestion[a].open.size > 0) || a - b).slice(0, firstFaults);
  const anyOpen = asked.some((q) => ofQuestion[q].open.size > 0);
  const cell = (name: string, oracles: Set<number>): HTMLElement => h("td", { "data-label": oracles.size > 0 ? name : undefined }, oracles.size === 0 ? null : oracles.size > 3 ? counted(oracles.size, "oracle") : h("span", { class: "engines" }, [...oracles].map((o) => engine(run, o))));
  return h("div", { class: "verified" }, h("p", { class: "sentence" }, sentence),
    h("table", { class: "plain stacked" },
      h("thead", {}, h("tr", {}, ["Question", "Right in every measure", anyOpen && "Undecidable in part"].map((name) => name !== false && h("th", { scope: "col" }, name)))),
      h("tbody", {}, asked.map((q) => h("tr", {},
        h("th", { scope: "row" }, h("a", { href: questionAddress(report.questions[q].id), dir: "auto", title: report.questions[q].id }, report.questions[q].title)),
        cell("right", new Set([...ofQuestion[q].passed].filter((o) => !ofQuestion[q].open.has(o)))), anyOpen && cell("undecidable in part", ofQuestion[q].open))))));
}

/** Faults on the first screen; the rest is one click away. */
const firstFaults = 10;

export const frontView: MakeView = (run, start) => {
  const { report } = run;
  const clusterBands: Band[] = report.clusters.map((c) => bandOfCluster(c));
  let shown: number[] = [];
  let chosen = -1;

  const list = virtualList("list", faultRowHeight, (place) => faultRow(run, shown[place], place + 1), true);
  let current = start.query;
  const sort = h("select", { "aria-label": "Order of the faults", on: { change: () => { location.hash = address([], withValue(current, "sort", sort.value === orders[0].key ? "" : sort.value)); } } },
    orders.map(({ key, name }) => h("option", { value: key }, name)));
  const perWho = responsibles.map((key) => ({ key, count: report.clusters.filter((cluster) => responsibleOf(cluster) === key).length })).filter(({ count }) => count > 0);
  const who = h("select", { "aria-label": "Whose faults", title: perWho.map(({ key }) => `${capital(responsibleTexts[key].name)}: ${responsibleTexts[key].meaning}`).join("\n"), on: { change: () => { location.hash = address([], withValue(current, "whose", who.value)); } } },
    h("option", { value: "" }, "any responsible"), perWho.map(({ key, count }) => h("option", { value: key }, `${responsibleTexts[key].name} (${count})`)));
  const chips = h("div", { class: "chips", role: "group", "aria-label": "Bands" });
  const weighs = h("p", { class: "card-first", role: "status" });
  const more = h("p", { class: "more" });
  const show = (query: URLSearchParams): void => {
    current = query;
    const wanted = valuesOf(query, "band");
    const whose = valuesOf(query, "whose");
    shown = report.clusters.map((_, c) => c).filter((c) => (wanted.length === 0 || wanted.includes(clusterBands[c])) && (whose.length === 0 || whose.includes(responsibleOf(report.clusters[c]))));
    chosen = -1;
    const inBand = (band: Band): number => clusterBands.filter((b) => b === band).length;
    fill(chips, faultBands.filter((band) => inBand(band) > 0 || wanted.includes(band)).map((band) => h("a", {
      class: `chip ${band}`, href: address([], toggled(query, "band", band)), "aria-current": wanted.includes(band) ? "true" : undefined, title: bandTexts[band].meaning,
    }, h("span", { "aria-hidden": "true" }, bandTexts[band].glyph), ` ${bandTexts[band].name} `, h("b", {}, inBand(band)))));
    who.value = whose[0] ?? "";
    const order = orders.find(({ key }) => key === query.get("sort")) ?? orders[0];
    sort.value = order.key;
    fill(weighs, order.weighs);
    const values = shown.map((c) => order.of(run, c));
    shown = shown.map((c, i) => [c, i] as const).sort((a, b) => values[b[1]] - values[a[1]] || a[1] - b[1]).map(([c]) => c);
    const all = shown.length;
    const isAll = query.get("all") === "1";
    if (!isAll) shown = shown.slice(0, firstFaults);
    list.setCount(shown.length);
    fill(more, all === 0 ? [wanted.length + whose.length > 0 && ["No fault is like this. ", h("a", { href: address([], withValue(withValue(query, "band", ""), "whose", "")) }, "Show all faults")]]
      : all > firstFaults && h("a", { class: "all", href: address([], withValue(query, "all", isAll ? "" : "1")) }, isAll ? `Show the first ${firstFaults} only` : `Show all ${all}`),
      report.clusters.length > 0 ? h("a", { href: findingsAddress({}) }, "Search every finding") : h("a", { href: findingsAddress({ band: "all", sort: "question" }) }, "Every measurement"));
  };

  const perVerdict = report.names.verdict.map(() => 0);
  for (const v of report.findings.verdict) ++perVerdict[v];
  const right = neverWrong(run);
  const improved = report.faults.filter(isImproved);
  const wrongFiles = report.faults.filter((fault) => !isImproved(fault));
  const remarks = (list: string[], name: string): Child => list.length > 0 && h("details", { class: "notes" }, h("summary", {}, name), h("ul", {}, list.slice(0, 200).map((fault) => h("li", {}, fault))));
  const element = h("section", { class: "front" },
    conclusionOf(run),
    report.regressions.length > 0 && h("details", { class: "notes", open: true }, h("summary", {}, counted(report.regressions.length, "regression")), h("ul", {}, report.regressions.slice(0, 200).map((r) => h("li", {}, h("b", {}, r.oracle), " ", r.what)))),
    h("div", { class: "toolbar" }, h("h1", {}, report.clusters.length > 0 ? "What is wrong" : "No fault was found"), report.clusters.length > 0 && [chips, h("div", { class: "sort" }, perWho.length > 1 && [who, " "], sort)]),
    report.clusters.length > 0 && h("div", { class: "card card-names" }, weighs, ["Engines", "At worst", "Grade and cause"].map((name) => h("span", { "aria-hidden": "true" }, name))),
    report.clusters.length === 0 && verified(run), list.element, more,
    h("div", { class: "bookkeeping" },
      h("div", {},
        h("h2", {}, h("a", { href: "#/matrix" }, "Groups × oracles")), smallMatrix(run)),
      h("div", {},
        h("h2", {}, "What was asked"), h("p", { class: "sentence" }, report.sentence, " An oracle is an engine with one entry point and one precision."), countsList(run),
        right.length > 0 && h("p", { class: "engines" }, h("span", {}, "Never proved wrong:"), right.map((o) => engine(run, o))),
        remarks(improved, `${counted(improved.length, "entry", "entries")} of the ledger can be lowered or removed`),
        remarks(wrongFiles, `${counted(wrongFiles.length, "remark")} on the scenario files and the ledger`),
        !report.sweep && h("p", { class: "quiet" }, "The last line of the program: ", report.conclusion)),
      report.clusters.length > 0 && h("div", {},
        h("h2", {}, h("a", { href: "#/oracles" }, "Faults by oracle")), faultsByOracle(run, clusterBands)),
      h("div", {},
        h("h2", {}, "Measurements by verdict"),
        h("table", { class: "plain" }, h("tbody", {}, report.names.verdict.map((verdict, v) => perVerdict[v] > 0 && h("tr", {},
          h("th", { scope: "row" }, h("a", { href: findingsAddress({ verdict }) }, verdict)), h("td", { class: "number" }, perVerdict[v].toLocaleString("en")))))),
        h("h2", {}, "Bands"),
        h("dl", { class: "bands" }, bands.map((band) => [h("dt", {}, badge(band)), h("dd", {}, bandTexts[band].meaning)])), h("p", { class: "quiet" }, sizeMeaning))));
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
      { keys: ["o"], does: "open the worst question of the fault", run: () => { if (chosen >= 0) location.hash = findingAddress(run, report.clusters[shown[chosen]].worst); } },
    ],
    update(next: Address) { show(next.query); return true; },
    dispose: () => list.dispose(),
  };
};
