import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { h, fill } from "./dom";
import { colourOf, prefersDark, type Look } from "./engines";
import { apart } from "./format";

export interface Line { name: string; look: Look | null; values: (number | null)[]; solid: boolean }

export interface PlotData {
  times: number[];
  unit: string;
  lines: Line[];
  /** The truth, drawn dashed and without colour, with its tolerance as a band. */
  truth?: { values: (number | null)[]; tolerance: number };
  /** A bound that must not be passed, drawn as a line. */
  bound?: number;
  logarithmic: boolean;
  /** The step to which the values are rounded in the data. */
  step?: number;
  /** A sentence beside the plot that a reader needs. */
  note?: string;
}

const axisFont = "11px system-ui, sans-serif";

/** A plot over time whose cursor is the time that the reader looks at. */
export interface Plot {
  element: HTMLElement;
  set(data: PlotData): void;
  setTime(time: number): void;
  dispose(): void;
}

/** @param seek called with the time that the reader clicks
 *  @param empty what is said where nothing can be drawn */
export function makePlot(name: string, seek: (time: number) => void, empty: string): Plot {
  const place = h("div", { class: "plot-place" });
  const values = h("p", { class: "plot-values" });
  const note = h("p", { class: "plot-note quiet" });
  const element = h("figure", { class: "plot", role: "group", "aria-label": name }, place, note, values);
  let plot: uPlot | null = null;
  let data: PlotData | null = null;
  let now = 0;

  // An element over the plot: to draw the plot again for each frame of a playback would cost half of the frames.
  const cursor = h("div", { class: "plot-cursor", "aria-hidden": "true" });
  const placeCursor = (): void => {
    if (!plot) return;
    const x = plot.valToPos(now, "x");
    cursor.hidden = !(x >= 0 && x <= plot.over.clientWidth);
    cursor.style.setProperty("transform", `translateX(${x}px)`);
  };
  /** The tolerance around the truth. */
  const drawBand = (u: uPlot): void => {
    if (!data?.truth || !(data.truth.tolerance > 0)) return;
    // A logarithmic axis has the sizes: below the tolerance of a truth of zero all is within it.
    const lowest = u.scales.y.min ?? 0;
    const within = (value: number): number => (data!.logarithmic ? Math.max(value, lowest) : value);
    const size = data.logarithmic ? Math.abs : (x: number): number => x;
    const { times, truth: { values: list, tolerance } } = data;
    const known = list.map((v, i) => [times[i], v] as const).filter((pair): pair is readonly [number, number] => pair[1] !== null);
    const { ctx, bbox } = u;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    ctx.beginPath();
    for (const [t, v] of known) ctx.lineTo(u.valToPos(t, "x", true), u.valToPos(within(size(v) + tolerance), "y", true));
    for (const [t, v] of known.reverse()) ctx.lineTo(u.valToPos(t, "x", true), u.valToPos(within(size(v) - tolerance), "y", true));
    ctx.fillStyle = prefersDark() ? "rgba(255,255,255,0.17)" : "rgba(0,0,0,0.13)";
    ctx.fill();
    ctx.restore();
  };
  const positive = (list: (number | null)[]): (number | null)[] => data!.logarithmic ? list.map((v) => (v === null || v === 0 ? null : Math.abs(v))) : list;
  /** Names the lines that are no engine's, beside them. */
  const nameLines = (u: uPlot): void => {
    if (!data) return;
    const { ctx, bbox } = u;
    const scale = devicePixelRatio;
    const put = (text: string, value: number, end: boolean): void => {
      const y = Math.max(bbox.top + 14 * scale, Math.min(bbox.top + bbox.height - 4 * scale, u.valToPos(value, "y", true) - 5 * scale));
      const x = end ? bbox.left + bbox.width - 6 * scale : bbox.left + 6 * scale;
      if (!Number.isFinite(y)) return;
      ctx.textAlign = end ? "right" : "left";
      ctx.strokeText(text, x, y);
      ctx.fillText(text, x, y);
    };
    ctx.save();
    ctx.font = `600 ${12 * scale}px system-ui, sans-serif`;
    ctx.fillStyle = prefersDark() ? "#fff" : "#000";
    ctx.strokeStyle = prefersDark() ? "#14171c" : "#fff";
    ctx.lineWidth = 3 * scale;
    const shownLast = data.truth ? positive(data.truth.values).filter((v, i): v is number => v !== null && data!.times[i] <= (u.scales.x.max ?? Infinity)).at(-1) : undefined;
    if (shownLast !== undefined) put("truth", shownLast, true);
    if (data.bound !== undefined && (!data.logarithmic || data.bound > 0)) put(data.truth ? "tolerance" : "bound", data.bound, false);
    ctx.restore();
  };
  const tell = (): void => {
    if (!data) return;
    const { times, lines, unit, truth } = data;
    let i = 0;
    while (i + 1 < times.length && times[i + 1] <= now) ++i;
    const known = [...(truth ? [{ name: "truth (dashed)", value: truth.values[i] }] : []), ...lines.map((l) => ({ name: l.name, value: l.values[i] }))]
      .filter((v): v is { name: string; value: number } => v.value !== null && v.value !== undefined);
    const texts = apart(known.map(({ value }) => value), 4);
    fill(values, texts.length ? `${known.map(({ name }, k) => `${name} ${texts[k]}`).join(" · ")} ${unit}` : "");
  };
  const draw = (): void => {
    plot?.destroy();
    plot = null;
    if (!data) return;
    const { times, lines, truth, unit, bound, logarithmic } = data;
    if (times.length < 2 || lines.length === 0) { fill(place, h("p", { class: "quiet" }, empty)); return; }
    fill(place);
    const dark = prefersDark();
    const ink = dark ? "#c9cdd4" : "#474e59";
    const rule = dark ? "#343a44" : "#e3e6ea";
    const columns: (number | null)[][] = [];
    const series: uPlot.Series[] = [{}];
    // Points that are moved to whole pixels make a straight line crooked.
    const plain = { points: { show: false }, spanGaps: false, pxAlign: 0 };
    for (const { look, values: list, solid } of lines) {
      columns.push(positive(list));
      series.push({ ...plain, stroke: look ? colourOf(look) : ink, width: solid ? 2.5 : 1.4, dash: look?.dash });
    }
    // Last, so that the engine that keeps to it does not hide it.
    if (truth) {
      columns.push(positive(truth.values));
      series.push({ ...plain, stroke: dark ? "#fff" : "#000", dash: [6, 5], width: 1.5 });
    }
    if (bound !== undefined && (!logarithmic || bound > 0)) {
      columns.push(times.map(() => bound));
      series.push({ ...plain, stroke: ink, width: 1, dash: [2, 3] });
    }
    note.textContent = data.note ?? "";
    note.hidden = note.textContent === "";
    const axis = { stroke: ink, grid: { stroke: rule, width: 1 }, ticks: { stroke: rule, width: 1 }, font: axisFont };
    plot = new uPlot({
      width: Math.max(200, place.clientWidth), height: 180,
      legend: { show: false },
      cursor: { drag: { x: true, y: false }, points: { show: false } },
      scales: { x: { time: false }, y: logarithmic ? { distr: 3 } : { range: (_u, low, high) => padded(low, high, mostSteps * (data?.step ?? 0)) } },
      axes: [{ ...axis, values: (_u, ticks) => ticks.map((t) => `${t} s`), size: 28 }, { ...axis, ...(logarithmic ? { filter: (_u: uPlot, splits: number[]) => splits, grid: { ...axis.grid, filter: decades }, ticks: { ...axis.ticks, filter: decades } } : {}), size: (_u, labels) => Math.max(66, 22 + widest(labels ?? [])), values: (_u, ticks) => tickLabels(ticks, logarithmic, unit) }],
      series,
      hooks: { drawAxes: [drawBand], draw: [nameLines, placeCursor] },
    }, [times, ...columns] as uPlot.AlignedData, place);
    plot.over.append(cursor);
    placeCursor();
    plot.over.addEventListener("click", () => {
      const left = plot?.cursor.left;
      if (plot && left !== undefined && left >= 0) seek(plot.posToVal(left, "x"));
    });
    tell();
  };
  const observer = new ResizeObserver(() => {
    if (plot && place.clientWidth > 0) plot.setSize({ width: place.clientWidth, height: 180 });
    else if (!plot && place.clientWidth > 0) draw();
  });
  observer.observe(place);
  return {
    element,
    set(next) { data = next; if (place.clientWidth > 0) draw(); },
    setTime(time) { now = time; placeCursor(); tell(); },
    dispose() { observer.disconnect(); plot?.destroy(); },
  };
}

/** The decades alone: nine lines in each of many would be a grey ground. */
const decades = (_u: uPlot, splits: number[]): (number | null)[] => {
  const isDecade = (t: number): boolean => Math.abs(Math.log10(t) - Math.round(Math.log10(t))) < 1e-9;
  return splits.filter(isDecade).length < 2 ? splits : splits.map((t) => (isDecade(t) ? t : null));
};

/** Decades of a logarithmic axis that have a label, at most; with fewer than two, every tick has one. */
const mostDecades = 7;

/** The labels of the ticks of an axis, each unlike the others; of a logarithmic axis, the decades have one. */
export function tickLabels(ticks: (number | null)[], logarithmic: boolean, unit: string): string[] {
  const decadeOf = (t: number | null): number => (t === null || !(t > 0) ? NaN : Math.log10(t));
  const decades = ticks.map(decadeOf).filter((d) => Math.abs(d - Math.round(d)) < 1e-9).map(Math.round);
  const every = Math.ceil(decades.length / mostDecades);
  const isNamed = ticks.map((t) => t !== null && (!logarithmic || decades.length < 2 || (Math.abs(decadeOf(t) - Math.round(decadeOf(t))) < 1e-9 && (Math.round(decadeOf(t)) - decades[0]) % every === 0)));
  const names = apart(ticks.filter((t, i): t is number => isNamed[i] && t !== null));
  let next = 0;
  return isNamed.map((named) => (named ? `${names[next++]} ${unit}` : ""));
}

/** Width of the widest of the labels of an axis. [px] */
function widest(labels: (string | null)[]): number {
  const context = document.createElement("canvas").getContext("2d");
  if (!context) return 0;
  context.font = axisFont;
  return Math.max(0, ...labels.map((label) => context.measureText(label ?? "").width));
}

/** So many steps of the rounding are no fewer pixels than a plot is high: they cannot be seen. */
const mostSteps = 150;

/** A range with room around the values, also where they are all alike; at least as wide as `least`. */
export function padded(low: number, high: number, least = 0): [number, number] {
  const room = Math.max((high - low) * 0.06, (least - (high - low)) / 2) || Math.abs(high) * 0.1 || 1;
  return [low - room, high + room];
}
