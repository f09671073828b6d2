import { address, withValue, type Address } from "../address";
import { bands } from "../bands";
import { closeUp } from "../close_up";
import type { Question, Vec3 } from "../data";
import { fill, h, svg, type Child } from "../dom";
import { downloadCsv, downloadPicture, fileName } from "../download";
import { findingsAddress, valueOf } from "../findings_table";
import { digits, length, numberOf, share, spaced } from "../format";
import { commonPoint, contactVariant, type ContactVariant } from "../proof_text";
import { makePlayer } from "../player";
import type { Run } from "../run";
import { buildContact, hasNormal } from "../scene/contact_scene";
import { makeStage } from "../scene/stage";
import type { View } from "../view";
import { badge, button, command, engine, tabs } from "../widgets";
import { faultsIn, faultsOf, measuresTable, oraclesOf } from "./verdicts";
import * as three from "three";

const hidden = (text: string): HTMLElement => h("span", { class: "visually-hidden" }, text);
const vector = (v: Vec3): string => `(${v.map((x) => digits(x, 6)).join(", ")})`;

/** How long the proof plays [s]. */
const proofTime = 2;

const middleOf = (lo: number, hi: number): number => lo / 2 + hi / 2;

/** The words shown in place of a separation. */
const statusWords: Record<string, string> = { crashed: "it crashed", "timed out": "it hung", unsupported: "unsupported", "not asked": "not asked" };

/** A separation that an engine gives; a dash where it gives none. */
const separationText = (s: number | string | undefined): string => (s === undefined ? "–" : length(numberOf(s)));

export function contactView(run: Run, q: number, question: Question, start: Address): View {
  const contact = question.contact!;
  const { truth } = contact;
  const { oracles } = run.report;
  let query = start.query;
  const ranked = oraclesOf(run, q);
  const named = oracles.findIndex((o) => o.name === query.get("o"));
  let explained = named >= 0 && ranked.includes(named) ? named : ranked[0] ?? -1;
  const shown = new Set<number>(explained >= 0 ? [explained] : []);

  const view = buildContact(contact, run.looks);
  const stage = makeStage(1 / view.frame.scale, [0, 0, 1], `Three-dimensional view of ${question.title}`);
  stage.scene.add(view.root);
  stage.fit(new three.Vector3(), view.radius);
  stage.label("A", view.A);
  stage.label("B", view.B);
  for (const { text, at } of view.names) stage.label(text, at, true);
  // Where the depth is seen in the large view, a close-up would only cover it.
  const inset = Math.max(Math.abs(truth.lo), Math.abs(truth.hi)) < 0.04 * question.size ? closeUp(contact, run.looks) : null;
  const reading = h("output", { class: "reading", "aria-live": "polite" });
  const playButton = button("▶ Play the proof", () => player.toggle(), { class: "primary" });
  const slider = h("input", { type: "range", min: 0, max: 1000, value: 0, "aria-label": "Progress of the proof", on: { input: () => { const time = (Number(slider.value) / 1000) * proofTime; player.stop(); player.seek(time); } } });

  const player = makePlayer(0, proofTime, (time, playing) => {
    const state = view.prove(time / proofTime);
    slider.value = String(Math.round((time / proofTime) * 1000));
    fill(playButton, playing ? "❚❚ Stop" : time >= proofTime ? "↺ Play again" : "▶ Play the proof");
    stage.element.dataset.gap = String(state.gap);
    fill(reading, sayState(time, state));
    stage.invalidate();
  }, true);

  function sayState(time: number, state: ReturnType<typeof view.prove>): string {
    if (truth.touching === "apart") return `The plane fits between A and B: a gap of ${length(state.gap)}.`;
    const now = (moved: number, gap: number): string => `moved ${length(moved)}: ${gap < 0 ? `still ${length(-gap)} too deep` : `a gap of ${length(gap)}`}`;
    if (time === 0) return "";
    return `B ${now(state.moved, state.gap)}` + (state.claimMoved === undefined ? "." : `; along the direction of ${oracles[explained].name} (${performed}), ${now(state.claimMoved, state.claimGap!)}.`);
  }

  const applyShown = (): void => {
    oracles.forEach((_, o) => view.show(o, shown.has(o)));
    inset?.draw([...shown]);
    stage.invalidate();
  };
  /** The gravest fault of an oracle decides what of a variant or of a common point is drawn. */
  const drawProof = (oracle: number, variant?: ContactVariant): void => {
    const proofs = oracle < 0 ? [] : faultsIn(run, q, oracle).map((i) => run.text(run.report.findings.proof[i]));
    const drawn = variant ?? (proofs.length ? contactVariant(proofs[0]) : null);
    view.explain(oracle, drawn?.n);
    view.markCommon(proofs.map(commonPoint).find((p) => p !== null) ?? null);
    performed = drawn ? `that of its variant “${spaced(drawn.name)}”` : "that of its answer";
  };
  let performed = "";
  const ofVariant = (i: number): Child => {
    const variant = contactVariant(run.text(run.report.findings.proof[i]));
    return variant && [
      h("p", {}, h("b", {}, "Variant: "), `${spaced(variant.name)}${variant.how ? `, ${variant.how}` : ""}. The error is the larger of two changes once the answer is mapped back: that of the distance, and that of the overlap along the normal.`),
      button("Draw the variant's normal", () => { player.stop(); drawProof(explained, variant); player.seek(0); stage.invalidate(); }, { class: "small" })];
  };
  const explain = (oracle: number): void => {
    explained = oracle;
    shown.add(oracle);
    player.stop();
    drawProof(oracle);
    player.seek(0);
    applyShown();
    drawList();
    tabList.select(query.get("tab") ?? "proof");
  };

  const list = h("tbody");
  const drawList = (): void => fill(list, ranked.map((o) => {
    const answer = contact.answers[o];
    const worst = run.gravest(q, o);
    return h("tr", { class: o === explained ? "chosen" : "" },
      h("td", {}, h("input", { type: "checkbox", "aria-label": `Show the answer of ${oracles[o].name}`, checked: shown.has(o), disabled: answer?.status !== "answered",
        on: { change: (event: Event) => { if ((event.target as HTMLInputElement).checked) shown.add(o); else shown.delete(o); applyShown(); } } })),
      h("td", {}, h("input", { type: "radio", name: "explain", "aria-label": `Explain ${oracles[o].name}`, checked: o === explained, on: { change: () => { explain(o); remember("o", oracles[o].name); } } })),
      h("th", { scope: "row" }, engine(run, o)),
      h("td", {}, badge(bands[run.band[worst]])),
      h("td", { class: "number", "data-label": "separation" }, answer?.status === "answered" ? (answer.separation === undefined ? (answer.touching ? "touching" : "apart") : separationText(answer.separation)) : statusWords[answer?.status ?? "not asked"]),
      h("td", { class: "number", "data-label": "error" }, run.band[worst] < bands.indexOf("undecidable") ? valueOf(run, worst) : ""));
  }));
  const remember = (key: string, value: string): void => {
    query = withValue(query, key, value);
    history.replaceState(history.state, "", address(["s", question.id], query));
  };

  const truthLine = (): string => {
    if (truth.touching === "apart") return `A and B are apart by ${length(truth.lo)}.`;
    if (truth.touching === "undecided") return "Whether A and B touch is within the rounding of the input.";
    const depth = Math.max(-truth.lo, 0);
    return `A and B overlap: the shortest way out is ${length(depth)}, ${share(depth / question.size)}.`;
  };
  const certified = (): string => `Certified separation: ${digits(middleOf(truth.lo, truth.hi), 9)} m${truth.hi > truth.lo ? `, known to ${length((truth.hi - truth.lo) / 2)}` : ""}. Method: ${truth.method}.`;
  const tabList = tabs([
    { key: "proof", name: "Proof", make: () => [
      h("p", { class: "numbers" }, certified(), hasNormal(truth.n) && ` The shortest way out is along n = ${vector(truth.n)}.`),
      explained >= 0 && h("h2", {}, engine(run, explained)),
      explained >= 0 && faultsOf(run, q, explained, ofVariant)] },
    { key: "measures", name: "Measures", make: () => [
      button("CSV of the answers", saveAnswers, { class: "small" }), measuresTable(run, q, explained)] },
    { key: "file", name: "File", make: () => h("pre", { tabindex: "0" }, question.toml) },
    { key: "reproduce", name: "Reproduce", make: () => [
      h("p", {}, "All answers with proofs:"), command(`touchstone explain ${question.id} --all`),
      explained >= 0 && [h("p", {}, `${oracles[explained].name} alone, with nothing excused:`), command(`touchstone run ${question.id} --subject ${oracles[explained].name} --ledger /dev/null`)],
      h("p", {}, h("a", { href: findingsAddress({ question: question.id, band: "all" }) }, "Every measurement of this question"))] },
  ], query.get("tab") ?? "proof", (key) => remember("tab", key));

  function saveAnswers(): void {
    downloadCsv(fileName(question.id, "csv"), [
      ["oracle", "status", "touching", "separation", "nx", "ny", "nz", "x", "y", "z", "separation of the point"],
      ...contact.answers.flatMap((a, o): (string | number)[][] => {
        const head = [oracles[o].name, a.status, a.touching === undefined ? "" : String(a.touching), a.separation ?? "", ...(a.n ?? ["", "", ""])];
        return a.points?.length ? a.points.map(({ p, s }) => [...head, ...p, s]) : [head];
      }),
    ]);
  }

  const look = (direction: Vec3): void => stage.lookFrom(direction);
  // Beside something much larger, the fit goes to and fro between the small body and all.
  let seesAll = false;
  const fit = (): void => {
    seesAll = !seesAll;
    if (seesAll) stage.fit(view.allCentre, view.allRadius);
    else stage.fit(new three.Vector3(), view.radius);
  };
  const picture = async (): Promise<void> => downloadPicture(fileName(question.id, "png"), await stage.picture());
  const axes: [string, Vec3][] = [["x", [1, 0, 0]], ["y", [0, -1, 0]], ["z", [0, 0, 1]]];
  const element = h("section", { class: "question" },
    h("header", { class: "question-head" },
      h("p", { class: "quiet" }, h("a", { href: findingsAddress({ group: question.group }) }, question.group), question.pair && ` · ${question.pair}`, " · ", h("span", { class: "id" }, question.id)),
      h("h1", { dir: "auto" }, question.title), h("p", {}, truthLine())),
    h("div", { class: "stage-and-panel" },
      h("div", { class: "stage-column" },
        stage.element,
        inset?.element,
        contactLegend(truth.patch.length > 1),
        view.note !== "" && h("p", { class: "quiet" }, view.note),
        h("div", { class: "toolbar", role: "toolbar", "aria-label": "View" },
          view.provable && [playButton, slider],
          axes.map(([name, d]) => button(name, () => look(d), { title: `Look along ${name}` })),
          hasNormal(truth.n) && button("n", () => look(truth.n), { title: "Look along the normal" }),
          hasNormal(truth.n) && button("n⊥", () => look(sideOf(truth.n)), { title: "Look across the normal" }),
          button("Fit", fit), button("PNG", () => { void picture(); })),
        reading),
      h("div", { class: "side-panel" },
        h("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Answers" },
          h("table", { class: "plain verdicts" },
            h("caption", {}, "Tick: its contacts are shown. Dot: it is explained below, and its direction performed with the proof."),
            h("thead", {}, h("tr", {}, h("th", { scope: "col" }, hidden("show")), h("th", { scope: "col" }, hidden("explain")), h("th", { scope: "col" }, "oracle"), h("th", { scope: "col" }, "worst"), h("th", { scope: "col", class: "number" }, "separation"), h("th", { scope: "col", class: "number" }, "error"))),
            list)),
        tabList.element)));
  drawProof(explained);
  player.seek(0);
  applyShown();
  drawList();

  return {
    title: question.title, element,
    keys: [
      ...(view.provable ? [{ keys: ["p", " "], does: "play the proof", run: () => player.toggle() }] : []),
      ...axes.map(([name, d]) => ({ keys: [name], does: `look along ${name}`, run: () => look(d) })),
      ...(hasNormal(truth.n) ? [{ keys: ["n"], does: "look along the normal", run: () => look(truth.n) }] : []),
      { keys: ["f"], does: "fit", run: fit },
      { keys: ["1", "2", "3", "4", "5", "6", "7", "8", "9"], does: "show one oracle alone", run: (key) => {
        const o = ranked[Number(key) - 1];
        if (o === undefined) return;
        shown.clear();
        explain(o);
        remember("o", oracles[o].name);
      } },
      { keys: ["0"], does: "show all oracles", run: () => { for (const o of ranked) if (contact.answers[o].status === "answered") shown.add(o); applyShown(); drawList(); } },
      { keys: ["u"], does: "up to the group's findings", run: () => { location.hash = findingsAddress({ group: question.group }); } },
    ],
    dispose() { player.stop(); stage.dispose(); },
  };
}

/** The legend of the marks in the view. */
export function contactLegend(hasPatch: boolean): HTMLElement {
  const item = (mark: SVGElement, text: string): HTMLElement => h("li", {}, mark, " ", text);
  const picture = (...parts: SVGElement[]): SVGElement => svg("svg", { viewBox: "0 0 16 12", class: "key", "aria-hidden": "true" }, parts);
  const line = (className: string, more: Record<string, number> = {}): SVGElement => svg("line", { x1: 2, y1: 6, x2: 14, y2: 6, class: className, ...more });
  return h("ul", { class: "marks", "aria-label": "Marks of the view" },
    item(picture(svg("rect", { x: 1, y: 1, width: 14, height: 10, class: "key-a" })), "A"), item(picture(svg("rect", { x: 1, y: 1, width: 14, height: 10, class: "key-b" })), "B"),
    item(picture(svg("rect", { x: 1, y: 1, width: 14, height: 10, class: "key-plane" })), "certified plane"),
    item(picture(svg("circle", { cx: 8, cy: 6, r: 4, class: "key-truth" })), "a, b: extreme points of A and B along the certified normal"),
    hasPatch && item(picture(svg("rect", { x: 1, y: 1, width: 14, height: 10, class: "key-patch" }), svg("path", { d: "M3 11 11 1M8 11 15 3", class: "key-hatch" })), "true patch"),
    item(picture(svg("circle", { cx: 8, cy: 6, r: 3, class: "key-oracle" }), line("key-oracle-line", { x1: 8, x2: 8, y1: 0, y2: 12 })), "contact of an oracle, its stem as long as its depth"),
    item(picture(line("key-oracle-line"), svg("path", { d: "M10 2 15 6 10 10", class: "key-oracle" })), "normal of an oracle"));
}

/** A level direction across n, from which the gap is seen in profile. */
function sideOf(n: Vec3): Vec3 {
  const level: Vec3 = [n[1], -n[0], 0];
  return Math.hypot(...level) > 1e-6 ? level : [0, -1, 0];
}
