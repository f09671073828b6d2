import { bands } from "../bands";
import { fill, h, type Child } from "../dom";
import { errorOf } from "../error_in_proof";
import { withoutPlace } from "../expectation";
import { headingOf, measureOf, shareInWords, valueOf } from "../findings_table";
import { quantity, spaced } from "../format";
import { proofText } from "../proof_text";
import { causeOf } from "../responsible";
import type { Run } from "../run";
import { shippedOnlyOf } from "../shipped_only";
import { badge, badgeOf, engine, modelOf, upstreamLink } from "../widgets";

/** The oracles with a finding on a question, the gravest first. */
export function oraclesOf(run: Run, question: number): number[] {
  const gravest = run.report.oracles.map((_, o) => run.gravest(question, o));
  return gravest.map((_, o) => o).filter((o) => gravest[o] >= 0)
    .sort((a, b) => run.band[gravest[a]] - run.band[gravest[b]] || run.report.findings.share[gravest[b]] - run.report.findings.share[gravest[a]] || a - b);
}

/** The findings of an oracle on a question, the gravest first. */
function findingsIn(run: Run, question: number, oracle: number): number[] {
  const { oracle: of, share } = run.report.findings;
  return [...run.findingsOf(question)].filter((i) => of[i] === oracle).sort((a, b) => run.band[a] - run.band[b] || share[b] - share[a]);
}

/** Those of them that are faults. */
export const faultsIn = (run: Run, question: number, oracle: number): number[] => findingsIn(run, question, oracle).filter((i) => run.band[i] < bands.indexOf("undecidable"));

/** The cause of a finding, and what it was told from. */
function causeLine(run: Run, finding: number): Child {
  const { verdict, meaning, measured } = causeOf(run, finding);
  if (verdict === "") return null;
  return meaning === "" ? h("p", {}, h("b", {}, "Cause: "), verdict, measured && [": ", proofText(measured)])
    : [h("p", { title: meaning }, h("b", {}, "Cause: "), verdict), measured && h("p", {}, h("b", {}, "Measured: "), proofText(measured))];
}

/** The numbers of what was measured of an oracle on a question: "passed 6, 1 undecidable"; the badge alone would say only the worst. */
export function countsOf(run: Run, question: number, oracle: number): { passed: number; undecidable: number } {
  const { oracle: of } = run.report.findings;
  const own = [...run.findingsOf(question)].filter((i) => of[i] === oracle);
  const count = (band: (typeof bands)[number]): number => own.filter((i) => bands[run.band[i]] === band).length;
  return { passed: count("passed"), undecidable: count("undecidable") };
}

/** The badge of an oracle on a question: that of its worst finding, or what it passed if only some measurements are undecidable. */
export function badgeOn(run: Run, question: number, oracle: number, worst: number): HTMLElement {
  const { passed, undecidable } = countsOf(run, question, oracle);
  return bands[run.band[worst]] === "undecidable" && passed > 0 ? badge("undecidable", `passed ${passed}, ${undecidable} undecidable`) : badgeOf(run, worst);
}

/** Shows the faults of an oracle on a question, with proof, cause and ledger entry.
 * @param more what a view adds to the proof of a finding
 * @param asked the finding that comes first, if it is one of these: that of the address */
export function faultsOf(run: Run, question: number, oracle: number, more: (finding: number) => Child = () => null, asked = -1): Child {
  const { findings: f, names, ledger, oracles } = run.report;
  const all = findingsIn(run, question, oracle);
  const faults = faultsIn(run, question, oracle);
  const isFirst = (i: number): number => Number(i === asked);
  const told = faults.length ? [...faults].sort((a, b) => isFirst(b) - isFirst(a)) : all.filter((i) => run.text(f.proof[i]) !== "").slice(0, 3);
  const { passed, undecidable } = countsOf(run, question, oracle);
  if (told.length === 0 && undecidable > 0) return h("p", {}, `No measurement of ${oracles[oracle].name} shows a fault: ${passed} ${passed === 1 ? "is" : "are"} within tolerance, and ${undecidable} cannot be decided: `, [...new Set(all.filter((i) => bands[run.band[i]] === "undecidable").map((i) => `${measureOf(run, i)} (${names.undecided[f.undecided[i]] || "truth unknown"})`))].join(", "), ".");
  if (told.length === 0) return [h("p", {}, `Nothing is wrong with the answer of ${oracles[oracle].name}: ${all.length === 1 ? "its one measurement is" : `its ${all.length} measurements are`} within tolerance.`),
    shippedOnlyOf(run, oracle, question).map((i) => h("p", {}, h("b", {}, "Fails as shipped only: "), measureOf(run, i), ", ", proofText(run.text(f.shipped_because[i])), "."))];
  const undecided = (i: number): string => (run.band[i] === bands.indexOf("undecidable") ? names.undecided[f.undecided[i]] ?? "" : "");
  const reasons = new Set<number>();
  return told.slice(0, 30).map((i) => {
    const isExcused = f.ledger[i] >= 0;
    const place = isExcused ? f.ledger[i] : f.outgrown?.[i] ?? -1;
    const entry = ledger[place];
    const first = entry && !reasons.has(place);
    if (entry) reasons.add(place);
    const shipped = names.shipped[f.shipped[i]] ?? "";
    return h("article", { class: "fault" },
      h("h3", {}, badge(bands[run.band[i]], names.verdict[f.verdict[i]]), " ", headingOf(run, i), shareInWords(run, i) !== "" && ` (${shareInWords(run, i)})`, undecided(i) && `: ${undecided(i)}`),
      run.text(f.proof[i]) && h("p", { class: "proof", dir: "auto" }, proofText(withoutPlace(run.text(f.proof[i])), errorOf(run, i))),
      more(i),
      causeLine(run, i),
      shipped && run.text(f.shipped_because[i]) && h("p", {}, h("b", {}, `Fails ${shipped}: `), proofText(run.text(f.shipped_because[i]))),
      first && h("p", { dir: "auto" }, h("b", {}, isExcused ? "Known: " : "Known, now larger than its bound: "), entry.reason, " ", upstreamLink(entry.upstream)));
  });
}

/** Every measurement of a question, of one oracle or of all. */
export function measuresTable(run: Run, question: number, oracle: number): HTMLElement {
  const { findings: f, names } = run.report;
  const body = h("tbody");
  const rows = [...run.findingsOf(question)].filter((i) => oracle < 0 || f.oracle[i] === oracle).sort((a, b) => run.band[a] - run.band[b] || f.oracle[a] - f.oracle[b]);
  fill(body, rows.slice(0, 400).map((i) => h("tr", {},
    h("td", {}, modelOf(run, i) ? badgeOf(run, i) : badge(bands[run.band[i]], names.verdict[f.verdict[i]])),
    oracle < 0 && h("td", {}, engine(run, f.oracle[i])),
    h("td", {}, measureOf(run, i), run.text(f.reference[i]) && h("span", { class: "quiet" }, ` against ${spaced(run.text(f.reference[i]))}`), modelOf(run, i) !== "" && h("span", { class: "quiet" }, `, follows its documented model: ${modelOf(run, i)}`)),
    h("td", { class: "number" }, valueOf(run, i)),
    h("td", { class: "number", title: run.text(f.because[i]) }, quantity(f.tolerance[i], names.measure[f.measure[i]]?.unit ?? "")))));
  return h("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Measures" },
    h("table", { class: "plain measures" },
      h("thead", {}, h("tr", {}, h("th", { scope: "col" }, "Verdict"), oracle < 0 && h("th", { scope: "col" }, "Oracle"), h("th", { scope: "col" }, "Measure"), h("th", { scope: "col", class: "number" }, "Value"), h("th", { scope: "col", class: "number" }, "Tolerance"))),
      body),
    rows.length > 400 && h("p", { class: "quiet" }, `The gravest 400 of ${rows.length}.`));
}
