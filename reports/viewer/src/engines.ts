import type { Report } from "./data";
import { svg } from "./dom";

/** How an engine looks, the same on every screen. */
export interface Look {
  /** Colours of Okabe and Ito, which people with any colour vision tell apart; the dark one on light ground. */
  light: string;
  dark: string;
  /** Corners of its marker; 0 is a disc, and a negative number a star of as many points. */
  corners: number;
  dash: number[];
}

const looks: Record<string, [light: string, dark: string]> = {
  touchstone: ["#33383f", "#f2f2f2"], bullet: ["#d08700", "#f0a830"], ode: ["#2f94c9", "#56b4e9"], fcl: ["#009e73", "#1fc495"],
  libccd: ["#9a8f00", "#f0e442"], mujoco: ["#d55e00", "#f2813a"], dart: ["#b5618f", "#dd92bd"],
};
const spare: [string, string][] = [["#0072b2", "#5aa9dd"], ["#7a5195", "#b18ccf"], ["#6b6b6b", "#a9a9a9"], ["#8c564b", "#c99a8f"]];
// Polygons of more than four corners look like a disc at this size: stars do not.
const corners = [0, 4, 3, -4, -3, -6];
const dashes: number[][] = [[], [8, 3], [3, 3], [10, 3, 2, 3], [1.5, 3], [14, 4]];

function hash(text: string): number {
  let sum = 0;
  for (const c of text) sum = (sum * 31 + (c.codePointAt(0) ?? 0)) >>> 0;
  return sum;
}

function family(name: string, library: string): string {
  const words = `${name} ${library}`.toLowerCase();
  if (words.startsWith("cookbook")) return "touchstone";
  return Object.keys(looks).find((key) => words.includes(key)) ?? library.toLowerCase();
}

/** Looks of all oracles: colour by engine, marker and dash by the oracle within its engine. */
export function findLooks(oracles: Report["oracles"]): Look[] {
  const seen = new Map<string, number>();
  return oracles.map(({ name, library }) => {
    const engine = family(name, library);
    const turn = seen.get(engine) ?? 0;
    seen.set(engine, turn + 1);
    const [light, dark] = looks[engine] ?? spare[hash(engine) % spare.length];
    return { light, dark, corners: corners[turn % corners.length], dash: dashes[turn % dashes.length] };
  });
}

export const prefersDark = (): boolean => matchMedia("(prefers-color-scheme: dark)").matches;

export const colourOf = (look: Look): string => (prefersDark() ? look.dark : look.light);

/** The marker of an engine as a picture of 12 × 12. */
export function marker(look: Look): SVGElement {
  const shape = look.corners === 0
    ? svg("circle", { cx: 6, cy: 6, r: 4.6 })
    : svg("polygon", { points: cornersOf(look.corners).map(([x, y]) => `${6 + 5.4 * x},${6 + 5.4 * y}`).join(" ") });
  shape.setAttribute("fill", colourOf(look));
  return svg("svg", { class: "marker", viewBox: "0 0 12 12", "aria-hidden": "true" }, shape);
}

/** Corners of a regular polygon of radius 1, one at the top, or two for a square; of a star if `count` is negative. */
export function cornersOf(count: number): [number, number][] {
  const turn = count === 4 ? Math.PI / 4 : 0;
  const points = count < 0 ? -2 * count : count;
  return Array.from({ length: points }, (_, i) => {
    const angle = turn + (2 * Math.PI * i) / points - Math.PI / 2;
    const radius = count < 0 && i % 2 ? 0.38 : 1;
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  });
}
