import { bands, bandTexts, type Band } from "../bands";
import { countsList } from "../counts";
import { h } from "../dom";
import { downloadCsv } from "../download";
import { findingsAddress } from "../findings_table";
import { counted } from "../format";
import { marker } from "../engines";
import type { Run } from "../run";
import type { MakeView } from "../view";
import { address } from "../address";
import { badge, button } from "../widgets";

/** The gravest grade of each group and oracle, how many questions of the group have it, and how many passed. */
interface Matrix { band(group: number, oracle: number): Band; count(group: number, oracle: number): number; passed(group: number, oracle: number): number; size(group: number): number }

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
  const passed = new Uint16Array(worst.length);
  const sizes = new Uint16Array(run.groups.length);
  questions.forEach((_, q) => {
    ++sizes[run.groupOf[q]];
    for (let o = 0; o < oracles.length; ++o) {
      const at = run.groupOf[q] * oracles.length + o;
      const band = perQuestion[q * oracles.length + o];
      if (bands[band] === "passed") ++passed[at];
      if (band < worst[at]) { worst[at] = band; counts[at] = 0; }
      if (band === worst[at]) ++counts[at];
    }
  });
  const matrix: Matrix = {
    band: (g, o) => bands[worst[g * oracles.length + o]],
    count: (g, o) => counts[g * oracles.length + o],
    passed: (g, o) => passed[g * oracles.length + o],
    size: (g) => sizes[g],
  };
  made.set(run, matrix);
  return matrix;
}

const nameFont = "10.5px system-ui, sans-serif";

/** Width of a name in the small matrix [px]. */
function widthOf(name: string): number {
  const context = document.createElement("canvas").getContext("2d");
  if (!context) return 0;
  context.font = nameFont;
  return context.measureText(name).width;
}

/** The matrix as a picture with names. The cell under the pointer says what it is, and opens its findings. */
export function smallMatrix(run: Run): HTMLElement {
  const matrix = matrixOf(run);
  const { oracles } = run.report;
  // The names are whole unless they are very long, and a column is never narrower than the letters of its name.
  const widest = (names: string[], limit: number): number => Math.min(limit, Math.ceil(Math.max(0, ...names.map(widthOf))) + 8);
  const isAnswered = (g: number): boolean => oracles.some((_, o) => matrix.band(g, o) !== "unasked");
  const rows = run.groups.map((_, g) => g).filter(isAnswered);
  const leftOut = run.groups.length - rows.length;
  const [left, top, hh] = [widest(rows.map((g) => run.groups[g]), 200), widest(oracles.map(({ name }) => name), 150), 12];
  const w = Math.max(12, Math.min(18, Math.floor((400 - left) / oracles.length)));
  const [width, height] = [left + oracles.length * w, top + rows.length * hh];
  const canvas = h("canvas", { width: width * 2, height: height * 2, role: "img", "aria-label": "Matrix of groups of questions, down, and oracles, across, coloured by the gravest grade" });
  canvas.style.setProperty("width", `${width}px`);
  const draw = (): void => {
    const context = canvas.getContext("2d");
    const style = getComputedStyle(document.documentElement);
    if (!context) return;
    context.scale(2, 2);
    context.font = nameFont;
    context.textBaseline = "middle";
    const ink = style.getPropertyValue("--ink");
    const cut = (text: string, room: number): string => {
      if (context.measureText(text).width <= room) return text;
      let end = text.length;
      while (end > 1 && context.measureText(`${text.slice(0, end)}…`).width > room) --end;
      return `${text.slice(0, end)}…`;
    };
    context.fillStyle = ink;
    oracles.forEach(({ name }, o) => {
      context.save();
      context.translate(left + (o + 0.5) * w, top - 4);
      context.rotate(-Math.PI / 2);
      context.fillText(cut(name, top - 6), 0, 0);
      context.restore();
    });
    rows.forEach((g, row) => {
      context.fillStyle = ink;
      context.fillText(cut(run.groups[g], left - 6), 0, top + (row + 0.5) * hh);
      oracles.forEach((_o, o) => {
        context.fillStyle = style.getPropertyValue(`--${matrix.band(g, o)}-cell`);
        context.fillRect(left + o * w, top + row * hh, w - 1, hh - 1);
      });
    });
  };
  const link = h("a", { href: "#/matrix", class: "small-matrix", "aria-label": "Open the matrix of groups and oracles", on: {
    mousemove: (event: MouseEvent) => {
      const box = canvas.getBoundingClientRect();
      const zoom = width / box.width;
      const [o, row] = [Math.floor(((event.clientX - box.left) * zoom - left) / w), Math.floor(((event.clientY - box.top) * zoom - top) / hh)];
      const oracle = oracles[o];
      const g = rows[row] ?? -1;
      const group = run.groups[g];
      link.title = oracle && group ? wordsOf(matrix, g, o, group, oracle.name) : "";
      link.href = oracle && group ? findingsAddress({ group, oracle: oracle.name, band: matrix.band(g, o) }) : "#/matrix";
    },
    mouseleave: () => { link.href = "#/matrix"; link.title = ""; },
  } }, canvas);
  queueMicrotask(draw);
  return h("div", {}, h("p", { class: "quiet" }, "Down: groups of questions. Across: oracles. Colour: the gravest grade. A cell opens its findings."),
    h("ul", { class: "marks cells", "aria-label": "Colours of the matrix" }, bands.map((band) => h("li", { title: bandTexts[band].meaning }, h("span", { class: `cell-key ${band}`, "aria-hidden": "true" }), bandTexts[band].name))), link,
    leftOut > 0 && h("p", { class: "quiet" }, `Left out: ${counted(leftOut, "group")} that no oracle of this run supports.`));
}

/** The tooltip of a cell. */
function wordsOf(matrix: Matrix, g: number, o: number, group: string, oracle: string): string {
  const band = matrix.band(g, o);
  return `${group}, ${oracle}: ${bandTexts[band].name} in ${matrix.count(g, o)} of ${counted(matrix.size(g), "question")}${band !== "passed" && band !== "unasked" ? `, passed ${matrix.passed(g, o)}` : ""}`;
}

export const matrixView: MakeView = (run) => {
  const matrix = matrixOf(run);
  const { oracles } = run.report;
  const table = h("table", { class: "matrix" },
    h("caption", { class: "visually-hidden" }, "The gravest grade of each group of scenarios and oracle, with the number of questions in it"),
    h("thead", {}, h("tr", {}, h("th", { scope: "col" }, "Group"),
      oracles.map((o, i) => h("th", { scope: "col" }, h("a", { href: address(["oracles", o.name]), class: "upright" }, marker(run.looks[i]), o.name))))),
    h("tbody", {}, run.groups.map((group, g) => h("tr", {},
      h("th", { scope: "row" }, h("a", { href: findingsAddress({ group }) }, group.split(/(?<=[/_])/).map((part, i) => [i > 0 && h("wbr"), part])), h("span", { class: "quiet" }, ` ${matrix.size(g)}`)),
      oracles.map((o, i) => {
        const band = matrix.band(g, i);
        const count = matrix.count(g, i);
        const words = wordsOf(matrix, g, i, group, o.name);
        return h("td", { class: `cell ${band}` }, h("a", { href: findingsAddress({ group, oracle: o.name, band }), title: words, "aria-label": words }, bandTexts[band].glyph, band === "unasked" ? "" : ` ${count}`,
          matrix.passed(g, i) > 0 && h("span", { class: "passes-bar", style: { width: `${(100 * matrix.passed(g, i)) / matrix.size(g)}%` } })));
      })))));
  const save = (): void => downloadCsv("matrix.csv", [["group", ...oracles.map((o) => o.name)],
    ...run.groups.map((group, g) => [group, ...oracles.map((_, o) => `${matrix.band(g, o)} ${matrix.count(g, o)}`)])]);
  const element = h("section", {}, h("h1", {}, "Groups × oracles"),
    h("p", {}, "A cell shows the gravest grade of an oracle in a group of questions, and the number of its questions with that grade. The line at its foot is the part of the questions that passed. A cell opens its findings. ", button("CSV", save, { class: "small" })),
    countsList(run),
    h("p", { class: "legend" }, bands.map((band) => badge(band))),
    h("div", { class: "scroll matrix-scroll", tabindex: "0", role: "region", "aria-label": "Matrix" }, table));
  return { title: "Groups × oracles", element };
};
