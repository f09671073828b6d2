import { powerOfTen } from "../charts";
import { bands, faultBands } from "../bands";
import { h, svg, type Child } from "../dom";
import { colourOf, cornersOf, type Look } from "../engines";
import { measureOf, valueOf } from "../findings_table";
import { numberOf, quantity } from "../format";
import type { StepStudy } from "../proofs";
import type { Run } from "../run";
import { engine } from "../widgets";

/** The measures that compare a motion with that of a changed world, and what was changed. */
const changes: [measure: string, name: string][] = [
  ["stability", "start moved by a rounding"], ["heading", "world turned about gravity"], ["translation", "world moved"], ["mirror", "world mirrored"],
  ["permutation", "bodies in another order"], ["mass_scaling", "all masses scaled"], ["limit_error", "a quarter of the step"], ["determinism", "run again"],
];
const [width, height, low, high] = [320, 26, -16, 2];

function mark(x: number, look: Look, words: string): SVGElement {
  const fill = colourOf(look);
  const y = height / 2;
  const shape = look.corners === 0 ? svg("circle", { cx: x, cy: y, r: 4.5, fill }) : svg("polygon", { points: cornersOf(look.corners).map(([u, v]) => `${x + 5.5 * u},${y + 5.5 * v}`).join(" "), fill });
  shape.append(svg("title", {}, words));
  return shape;
}

/** The errors of one finding at the step, a half and a quarter of it: a line over two logarithmic axes. */
function studyPlot(run: Run, finding: number, study: StepStudy): HTMLElement {
  const { findings: f, oracles } = run.report;
  const [w, hh, margin] = [104, 64, 10];
  const logs = study.errors.map((e) => Math.log10(Math.max(Math.abs(e), 1e-300)));
  const top = Math.max(...logs);
  // Two decades at least, so that an error that stays is a level line.
  const bottom = Math.min(...logs, top - 2);
  const points = logs.map((l, i) => [margin + (i / 2) * (w - 2 * margin), margin + ((top - l) / (top - bottom)) * (hh - 2 * margin)] as const);
  const colour = colourOf(run.looks[f.oracle[finding]]);
  const said = study.errors.map((e) => quantity(e, study.unit)).join(", ");
  return h("figure", { class: "study" },
    svg("svg", { viewBox: `0 0 ${w} ${hh}`, role: "img", "aria-label": `${oracles[f.oracle[finding]].name}, ${measureOf(run, finding)}: ${said} at the step, a half and a quarter of it` },
      svg("rect", { x: 0.5, y: 0.5, width: w - 1, height: hh - 1 }),
      svg("polyline", { points: points.map((p) => p.join(",")).join(" "), stroke: colour }), points.map(([x, y]) => svg("circle", { cx: x, cy: y, r: 3, fill: colour }))),
    h("figcaption", {}, engine(run, f.oracle[finding]), ` ${measureOf(run, finding)}: ${said}`));
}

/** The step study: what becomes of each fault at smaller steps, in small plots with the same axes. */
function stepStudies(run: Run, question: number): Child {
  const studies = [...run.findingsOf(question)].map((i) => ({ i, study: run.study(i) }))
    .filter((s): s is { i: number; study: StepStudy } => s.study !== null);
  if (studies.length === 0) return null;
  return [
    h("h2", {}, "Step study"), h("p", {}, "Faults at the step, a half and a quarter of it, from left to right, the error logarithmic. An error of the step falls; a defect stays."),
    h("div", { class: "studies" }, studies.slice(0, 40).map(({ i, study }) => studyPlot(run, i, study)))];
}

/** How far each oracle moves a changed world from the world itself: one small plot for each change, all over the same logarithmic axis. */
export function variantsPanel(run: Run, question: number): Child {
  const { findings: f, names, oracles } = run.report;
  const plots = changes.map(([measure, name]) => {
    const found = [...run.findingsOf(question)].filter((i) => names.measure[f.measure[i]]?.name === measure && run.band[i] <= bands.indexOf("passed"));
    if (found.length === 0) return null;
    const place = (value: number): number => 4 + ((Math.max(low, Math.min(high, Math.log10(Math.max(value, 1e-300)))) - low) / (high - low)) * (width - 8);
    const words = (i: number): string => `${oracles[f.oracle[i]].name}: ${valueOf(run, i)}, allowed ${quantity(f.tolerance[i], names.measure[f.measure[i]].unit)}`;
    const wrong = found.filter((i) => run.band[i] < faultBands.length);
    return h("figure", { class: "variant" },
      h("figcaption", {}, h("b", {}, name), wrong.length ? `: ${wrong.map((i) => `${oracles[f.oracle[i]].name} ${valueOf(run, i)}`).join(", ")} too far` : ": all within tolerance"),
      svg("svg", { viewBox: `0 0 ${width} ${height}`, class: "variant-strip", role: "img", "aria-label": `${name}: ${found.map(words).join("; ")}` },
        svg("line", { x1: 4, x2: width - 4, y1: height / 2, y2: height / 2 }),
        found.map((i) => mark(place(Math.abs(numberOf(f.value[i]))), run.looks[f.oracle[i]], words(i)))));
  }).filter((plot) => plot !== null);
  const studies = stepStudies(run, question);
  if (plots.length === 0) return [h("p", {}, "This world was simulated in no variant."), studies];
  return [
    h("p", {}, "The same world, changed in a way that must not change the motion. A mark is the largest difference of an oracle to its own motion: distance + angle × radius, with the radius of the largest body."),
    plots,
    h("p", { class: "axis variant-axis", "aria-hidden": "true" }, [-16, -10, -4, 2].map((e) => h("span", {}, `${powerOfTen(e)} m`))),
    studies];
}
