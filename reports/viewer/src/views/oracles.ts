import { questionAddress } from "../address";
import { bands, bandTexts, faultBands } from "../bands";
import { h, type Child } from "../dom";
import { faultAddress } from "../fault_address";
import { findingsAddress, measureOf } from "../findings_table";
import { counted, digits } from "../format";
import { proofText } from "../proof_text";
import { bandOfCluster, extentOf, type Run } from "../run";
import { shippedOnlyOf } from "../shipped_only";
import type { MakeView } from "../view";
import { badge, engine } from "../widgets";
import { notFound } from "./not_found";

export const oraclesView: MakeView = (run, at) => {
  const { oracles, findings, subject, clusters } = run.report;
  const name = at.path.slice(1).join("/");
  if (name === "") {
    return { title: "Oracles", element: h("section", {}, h("h1", {}, "Oracles"), h("p", {}, "An oracle is an engine with one entry point and one precision."), h("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Oracles" }, h("table", { class: "plain stacked" },
      h("thead", {}, h("tr", {}, ["Oracle", "Library", "Version", "Answers", "Arithmetic"].map((t) => h("th", { scope: "col" }, t)), faultBands.map((band) => h("th", { scope: "col", class: "number" }, badge(band))))),
      h("tbody", {}, oracles.map((o, i) => {
        const per = faultBands.map(() => 0);
        for (let k = 0; k < findings.oracle.length; ++k) if (findings.oracle[k] === i && run.band[k] < per.length) ++per[run.band[k]];
        return h("tr", {}, h("th", { scope: "row" }, engine(run, i), i === subject && h("span", { class: "quiet" }, " subject")), h("td", { "data-label": "Library" }, o.library), h("td", { "data-label": "Version" }, o.version), h("td", { "data-label": "Answers" }, kinds(o)), h("td", { "data-label": "Arithmetic" }, arithmetic(o.unit_roundoff)),
          per.map((count, b) => h("td", { class: "number", "data-label": bandTexts[faultBands[b]].name }, count > 0 ? h("a", { href: findingsAddress({ oracle: o.name, band: faultBands[b] }) }, count.toLocaleString("en")) : "0")));
      }))))) };
  }
  const index = oracles.findIndex((o) => o.name === name);
  const oracle = oracles[index];
  if (!oracle) return notFound(`There is no oracle “${name}”`);
  const per = bands.map(() => 0);
  for (let k = 0; k < findings.oracle.length; ++k) if (findings.oracle[k] === index) ++per[run.band[k]];
  const mine = clusters.map((c, i) => ({ c, i })).filter(({ c }) => c.oracles.includes(index));
  const element = h("section", {}, h("h1", {}, engine(run, index)),
    h("p", {}, `${oracle.library} ${oracle.version}, ${arithmetic(oracle.unit_roundoff)}; answers ${kinds(oracle)}`, oracle.isolated && ", in a process of its own", index === subject && "; the subject of this run", "."),
    h("p", { class: "chips" }, bands.map((band, b) => per[b] > 0 && h("a", { class: `chip ${band}`, href: findingsAddress({ oracle: oracle.name, band }) }, h("span", { "aria-hidden": "true" }, bandTexts[band].glyph), ` ${bandTexts[band].name} `, h("b", {}, per[b].toLocaleString("en"))))),
    mine.length > 0 && [h("h2", {}, "Its faults, the worst for a user first"), h("ol", {}, mine.map(({ c, i }) => h("li", { dir: "auto" }, badge(bandOfCluster(c)), " ", h("a", { href: faultAddress(run, i) }, c.title), " ", h("span", { class: "quiet" }, extentOf(c)))))],
    shippedOnly(run, index),
    h("h2", {}, "Settings of the adapter"),
    oracle.settings.length === 0 ? h("p", { class: "quiet" }, "None.") : h("table", { class: "plain" },
      h("thead", {}, h("tr", {}, ["Setting", "Value", "Why"].map((t) => h("th", { scope: "col" }, t)))),
      h("tbody", {}, oracle.settings.map((s) => h("tr", {}, h("th", { scope: "row" }, s.name), h("td", {}, s.value), h("td", {}, s.why))))),
    oracle.parameters.length > 0 && [h("h2", {}, "Parameters of worlds"), h("table", { class: "plain" },
      h("thead", {}, h("tr", {}, ["Parameter", "As set here", "As shipped"].map((t) => h("th", { scope: "col" }, t)))),
      h("tbody", {}, oracle.parameters.map((p) => h("tr", { class: p.set === p.shipped ? "" : "differs" }, h("th", { scope: "row" }, p.name), h("td", {}, p.set), h("td", {}, p.shipped)))))],
    h("p", { class: "quiet" }, counted(per.reduce((a, b) => a + b, 0), "measurement") + " in this run."));
  return { title: oracle.name, element };
};

/** The questions that the oracle answers right with the adapter's settings and wrong with the engine's own, one line each. */
function shippedOnly(run: Run, oracle: number): Child {
  const { findings: f, questions } = run.report;
  const first = new Map<number, number>();
  for (const i of shippedOnlyOf(run, oracle)) if (!first.has(f.question[i])) first.set(f.question[i], i);
  if (first.size === 0) return null;
  return [h("h2", {}, "Right as set here, wrong as the engine ships"), h("ul", {}, [...first].map(([q, i]) => h("li", { dir: "auto" },
    h("a", { href: questionAddress(questions[q].id, { o: run.report.oracles[oracle].name }), title: questions[q].id }, questions[q].title), ": ", measureOf(run, i), ", ", proofText(run.text(f.shipped_because[i])), ".")))];
}

const kinds = (o: { contacts: boolean; worlds: boolean }): string => [o.contacts && "contacts", o.worlds && "worlds"].filter(Boolean).join(" and ") || "nothing";
const arithmetic = (roundoff: number): string => (roundoff < 1e-12 ? "double precision" : roundoff < 1e-5 ? "single precision" : `rounds to ${digits(roundoff)}`);
