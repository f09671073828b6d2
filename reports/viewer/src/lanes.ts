import { faultBands } from "./bands";
import type { World } from "./data";
import { fill, h, svg } from "./dom";
import { colourOf } from "./engines";
import { spaced, seconds } from "./format";
import type { Run } from "./run";

interface Break { oracle: number; time: number }

/** When the oracles break the laws of a world: one lane for each law and measure. */
export function breaksOf(run: Run, question: number, world: World): Map<string, Break[]> {
  const { findings: f, names } = run.report;
  const lanes = new Map<string, Break[]>();
  const put = (name: string, oracle: number, time: number): void => {
    const lane = lanes.get(name) ?? [];
    const known = lane.find((b) => b.oracle === oracle);
    if (known) known.time = Math.min(known.time, time);
    else lane.push({ oracle, time });
    lanes.set(name, lane);
  };
  for (const i of run.findingsOf(question)) {
    const time = f.time?.[i] ?? -1;
    if (time >= 0 && run.band[i] < faultBands.length) put(spaced(run.text(f.law[i]) || names.measure[f.measure[i]].name), f.oracle[i], time);
  }
  for (const curve of world.curves) curve.breaks?.forEach((time, o) => { if (time !== null) put(`${curve.quantity}${curve.body === undefined ? "" : ` of ${world.bodies[curve.body]?.name ?? ""}`}`, o, time); });
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
          broken.map((b) => svg("rect", { x: Math.min(99.4, at(b.time)), y: 0, width: 0.6, height: 10, fill: colourOf(run.looks[b.oracle]) })));
        const words = broken.map((b) => `${run.report.oracles[b.oracle].name} at ${seconds(b.time)}`).join(", ");
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

