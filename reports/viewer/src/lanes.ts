import { faultBands } from "./bands";
import type { World } from "./data";
import { fill, h, svg } from "./dom";
import { colourOf } from "./engines";
import { lawName } from "./expectation";
import { spaced, seconds } from "./format";
import type { Run } from "./run";

/** When an oracle breaks a law: first, at the latest, and worst [s]. `isFirst` is false where only the worst moment is known. */
interface Break { oracle: number; time: number; worst: number; isFirst: boolean }

/** The name of the lane of a finding: its law, or its measure. */
const laneOf = (run: Run, i: number): string => lawName(run.report.questions[run.report.findings.question[i]], run.text(run.report.findings.law[i])) || spaced(run.report.names.measure[run.report.findings.measure[i]].name);

/** When a law is broken, in words. */
const momentsOf = (b: Break): string => (!b.isFirst ? `at or before ${seconds(b.worst)}, its worst moment` : b.worst > b.time ? `from ${seconds(b.time)} on, worst at ${seconds(b.worst)}` : `at ${seconds(b.time)}`);

/** When the oracles break the laws of a world: one lane for each law and measure. */
export function breaksOf(run: Run, question: number, world: World): Map<string, Break[]> {
  const { findings: f } = run.report;
  const lanes = new Map<string, Break[]>();
  // The worst moment is that of the gravest finding of a law.
  const put = (name: string, oracle: number, time: number, worst: number, isFirst: boolean): void => {
    const lane = lanes.get(name) ?? [];
    const known = lane.find((b) => b.oracle === oracle);
    if (!known) lane.push({ oracle, time, worst, isFirst });
    else if (time < known.time) Object.assign(known, { time, isFirst });
    lanes.set(name, lane);
  };
  const gravestFirst = [...run.findingsOf(question)].filter((i) => run.band[i] < faultBands.length).sort((a, b) => run.band[a] - run.band[b] || f.share[b] - f.share[a]);
  for (const i of gravestFirst) {
    const worst = f.time?.[i] ?? -1;
    const first = f.first?.[i] ?? -1;
    if (worst >= 0) put(laneOf(run, i), f.oracle[i], first >= 0 ? Math.min(first, worst) : worst, worst, first >= 0);
  }
  // A curve that shows a finding is in the lane of that finding's law.
  for (const curve of world.curves) curve.breaks?.forEach((time, o) => { if (time !== null && (curve.shows?.[o] ?? null) === null) put(`${curve.quantity}${curve.body === undefined ? "" : ` of ${world.bodies[curve.body]?.name ?? ""}`}`, o, time, time, true); });
  return lanes;
}

/** The lanes under the time slider: a law is red from the moment at which the first of the shown engines breaks it, with a mark for each;
 * contacts of one engine are ticks. A click goes to the moment. */
export function makeLanes(run: Run, question: number, world: World, seek: (time: number) => void): { element: HTMLElement; set(shown: number[], solid: number): void } {
  const all = breaksOf(run, question, world);
  const [start, end] = [world.times[0] ?? 0, world.times[world.times.length - 1] ?? 1];
  const at = (time: number): number => (100 * (time - start)) / Math.max(end - start, 1e-12);
  const element = h("div", { class: "lanes" });
  const go = (time: number) => ({ click: () => seek(time) });
  return {
    element,
    set(shown, solid) {
      const rows = [...all].map(([name, breaks]) => {
        const broken = breaks.filter((b) => shown.includes(b.oracle)).sort((a, b) => a.time - b.time);
        if (broken.length === 0) return null;
        const picture = svg("svg", { viewBox: "0 0 100 10", preserveAspectRatio: "none", class: "lane", "aria-hidden": "true" },
          svg("rect", { x: at(broken[0].time), y: 2, width: Math.max(0.4, 100 - at(broken[0].time)), height: 6, class: "broken" }),
          broken.map((b) => svg("rect", { x: Math.min(99.4, at(b.time)), y: 0, width: 0.6, height: 10, fill: colourOf(run.looks[b.oracle]) })),
          broken.filter((b) => b.worst > b.time).map((b) => svg("rect", { x: Math.min(99.2, Math.max(0, at(b.worst) - 0.4)), y: 3.5, width: 0.8, height: 3, class: "worst", fill: colourOf(run.looks[b.oracle]) })));
        const words = broken.map((b) => `${run.report.oracles[b.oracle].name} ${momentsOf(b)}`).join(", ");
        return h("div", { class: "lane-row" },
          h("button", { type: "button", class: "lane-name", title: `Broken by ${words}`, on: go(broken[0].time) }, name, h("span", { class: "visually-hidden" }, ` broken by ${words}`)), picture);
      });
      const track = world.motions[solid]?.impulses;
      let ticks: HTMLElement | null = null;
      if (track && track.samples > 0) {
        const samples = [...new Set(run.channels(track)[0])].slice(0, 600);
        ticks = h("div", { class: "lane-row" }, h("span", { class: "lane-name" }, `contacts of ${run.report.oracles[solid].name}`),
          svg("svg", { viewBox: "0 0 100 10", preserveAspectRatio: "none", class: "lane", "aria-hidden": "true" },
            samples.map((s) => svg("rect", { x: Math.min(99.7, at(world.times[s] ?? end)), y: 3, width: 0.3, height: 4, class: "tick" }))));
      }
      fill(element, rows.every((r) => r === null) && h("p", { class: "quiet" }, "No law is broken at a known time by the oracles shown."), rows, ticks);
    },
  };
}

