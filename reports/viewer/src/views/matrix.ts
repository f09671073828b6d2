import { bands, bandTexts, type Band } from "../bands";
import { h } from "../dom";
import { downloadCsv } from "../download";
import { findingsAddress } from "../findings_table";
import { counted } from "../format";
import { marker } from "../engines";
import type { Run } from "../run";
import type { MakeView } from "../view";
import { address } from "../address";
import { badge, button } from "../widgets";

/** The gravest band of each group and oracle, and how many questions of the group have it. */
interface Matrix { band(group: number, oracle: number): Band; count(group: number, oracle: number): number; size(group: number): number }

const made = new WeakMap<Run, Matrix>();

function matrixOf(run: Run): Matrix {
  const kept = made.get(run);
  if (kept) return kept;
  const { findings, questions, oracles } = run.report;
  const perQuestion = new Uint8Array(questions.length * oracles.length).fill(bands.indexOf("unasked"));
  for (let i = 0; i < findings.question.length; ++i) {
    const at = findings.question[i] * oracles.length + findings.oracle[i];
    perQuestion[at] = Math.min(perQuestion[at], run.band[i]);
  }
  const worst = new Uint8Array(run.groups.length * oracles.length).fill(bands.indexOf("unasked"));
  const counts = new Uint16Array(worst.length);
  const sizes = new Uint16Array(run.groups.length);
  questions.forEach((_, q) => {
    ++sizes[run.groupOf[q]];
    for (let o = 0; o < oracles.length; ++o) {
      const at = run.groupOf[q] * oracles.length + o;
      const band = perQuestion[q * oracles.length + o];
      if (band < worst[at]) { worst[at] = band; counts[at] = 0; }
      if (band === worst[at]) ++counts[at];
    }
  });
  const matrix: Matrix = {
    band: (g, o) => bands[worst[g * oracles.length + o]],
    count: (g, o) => counts[g * oracles.length + o],
    size: (g) => sizes[g],
  };
  made.set(run, matrix);
  return matrix;
}

/** The matrix as a picture that links to the large one. */
export function smallMatrix(run: Run): HTMLElement {
  const matrix = matrixOf(run);
  const { oracles } = run.report;
  const [w, hh] = [Math.max(6, Math.min(14, Math.floor(300 / oracles.length))), 9];
  const canvas = h("canvas", { width: oracles.length * w * 2, height: run.groups.length * hh * 2, role: "img", "aria-label": "Matrix of scenario groups and oracles, coloured by the gravest band" });
  canvas.style.setProperty("width", `${oracles.length * w}px`);
  const draw = (): void => {
    const context = canvas.getContext("2d");
    const style = getComputedStyle(document.documentElement);
    if (!context) return;
    run.groups.forEach((_, g) => oracles.forEach((_o, o) => {
      context.fillStyle = style.getPropertyValue(`--${matrix.band(g, o)}-cell`);
      context.fillRect(o * w * 2, g * hh * 2, w * 2 - 2, hh * 2 - 2);
    }));
  };
  draw();
  return h("a", { href: "#/matrix", class: "small-matrix" }, canvas);
}

export const matrixView: MakeView = (run) => {
  const matrix = matrixOf(run);
  const { oracles } = run.report;
  const table = h("table", { class: "matrix" },
    h("caption", { class: "visually-hidden" }, "The gravest band of each group of scenarios and oracle, with the number of questions in it"),
    h("thead", {}, h("tr", {}, h("th", { scope: "col" }, "Group"),
      oracles.map((o, i) => h("th", { scope: "col" }, h("a", { href: address(["oracles", o.name]), class: "upright" }, marker(run.looks[i]), o.name))))),
    h("tbody", {}, run.groups.map((group, g) => h("tr", {},
      h("th", { scope: "row" }, h("a", { href: findingsAddress({ group }) }, group), h("span", { class: "quiet" }, ` ${matrix.size(g)}`)),
      oracles.map((o, i) => {
        const band = matrix.band(g, i);
        const count = matrix.count(g, i);
        const words = `${group}, ${o.name}: ${bandTexts[band].name} in ${count} of ${counted(matrix.size(g), "question")}`;
        return h("td", { class: `cell ${band}` }, h("a", { href: findingsAddress({ group, oracle: o.name, band }), title: words, "aria-label": words }, bandTexts[band].glyph, band === "unasked" || band === "passed" ? "" : ` ${count}`));
      })))));
  const save = (): void => downloadCsv("matrix.csv", [["group", ...oracles.map((o) => o.name)],
    ...run.groups.map((group, g) => [group, ...oracles.map((_, o) => `${matrix.band(g, o)} ${matrix.count(g, o)}`)])]);
  const element = h("section", {}, h("h1", {}, "Groups × oracles"),
    h("p", {}, "A cell shows the gravest band of an oracle in a group of scenarios, and in how many of its questions. It opens those findings. ", button("CSV", save, { class: "small" })),
    h("p", { class: "legend" }, bands.map((band) => badge(band))),
    h("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Matrix" }, table));
  return { title: "Groups × oracles", element };
};
