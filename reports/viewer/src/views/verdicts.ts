import { bands } from "../bands";
import { fill, h, type Child } from "../dom";
import { headingOf, measureOf, valueOf } from "../findings_table";
import { quantity, share, spaced } from "../format";
import type { Run } from "../run";
import { badge, engine, upstreamLink } from "../widgets";

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

/** Shows the faults of an oracle on a question, with proof, cause and ledger entry.
 * @param more what a view adds to the proof of a finding */
export function faultsOf(run: Run, question: number, oracle: number, more: (finding: number) => Child = () => null): Child {
  const { findings: f, names, ledger, oracles } = run.report;
  const all = findingsIn(run, question, oracle);
  const faults = faultsIn(run, question, oracle);
  const told = faults.length ? faults : all.filter((i) => run.text(f.proof[i]) !== "").slice(0, 3);
  if (told.length === 0) return h("p", {}, `Nothing is wrong with the answer of ${oracles[oracle].name}: ${all.length === 1 ? "its one measurement is" : `its ${all.length} measurements are`} within tolerance.`);
  const undecided = (i: number): string => (run.band[i] === bands.indexOf("undecidable") ? names.undecided[f.undecided[i]] ?? "" : "");
  const reasons = new Set<number>();
  return told.slice(0, 30).map((i) => {
    const entry = ledger[f.ledger[i]];
    const first = entry && !reasons.has(f.ledger[i]);
    if (entry) reasons.add(f.ledger[i]);
    const shipped = names.shipped[f.shipped[i]] ?? "";
    return h("article", { class: "fault" },
      h("h3", {}, badge(bands[run.band[i]], names.verdict[f.verdict[i]]), " ", headingOf(run, i), names.measure[f.measure[i]]?.kind === "length" && ` (${share(f.share[i])})`, undecided(i) && `: ${undecided(i)}`),
      run.text(f.proof[i]) && h("p", { class: "proof", dir: "auto" }, run.text(f.proof[i])),
      more(i),
      f.cause[i] >= 0 && names.cause[f.cause[i]] && h("p", {}, h("b", {}, "Cause: "), names.cause[f.cause[i]], run.text(f.cause_because[i]) && `: ${run.text(f.cause_because[i])}`),
      shipped && run.text(f.shipped_because[i]) && h("p", {}, h("b", {}, `Fails ${shipped}: `), run.text(f.shipped_because[i])),
      first && h("p", { dir: "auto" }, h("b", {}, "Known: "), entry.reason, " ", upstreamLink(entry.upstream)));
  });
}

/** Every measurement of a question, of one oracle or of all. */
export function measuresTable(run: Run, question: number, oracle: number): HTMLElement {
  const { findings: f, names } = run.report;
  const body = h("tbody");
  const rows = [...run.findingsOf(question)].filter((i) => oracle < 0 || f.oracle[i] === oracle).sort((a, b) => run.band[a] - run.band[b] || f.oracle[a] - f.oracle[b]);
  fill(body, rows.slice(0, 400).map((i) => h("tr", {},
    h("td", {}, badge(bands[run.band[i]], names.verdict[f.verdict[i]])),
    oracle < 0 && h("td", {}, engine(run, f.oracle[i])),
    h("td", {}, measureOf(run, i), run.text(f.reference[i]) && h("span", { class: "quiet" }, ` against ${spaced(run.text(f.reference[i]))}`)),
    h("td", { class: "number" }, valueOf(run, i)),
    h("td", { class: "number", title: run.text(f.because[i]) }, quantity(f.tolerance[i], names.measure[f.measure[i]]?.unit ?? "")))));
  return h("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Measures" },
    h("table", { class: "plain measures" },
      h("thead", {}, h("tr", {}, h("th", { scope: "col" }, "Verdict"), oracle < 0 && h("th", { scope: "col" }, "Oracle"), h("th", { scope: "col" }, "Measure"), h("th", { scope: "col", class: "number" }, "Value"), h("th", { scope: "col", class: "number" }, "Tolerance"))),
      body),
    rows.length > 400 && h("p", { class: "quiet" }, `The gravest 400 of ${rows.length}.`));
}
