import { address, withValue, type Address } from "../address";
import { bands, faultBands } from "../bands";
import { closeUp } from "../close_up";
import type { Question, Vec3 } from "../data";
import { fill, h, svg, type Child } from "../dom";
import { downloadCsv, downloadPicture, fileName } from "../download";
import { findingsAddress, measureOf, nounOf, sizedPartOf, valueOf, wordsOf } from "../findings_table";
import { digits, length, numberOf, precise, share, spaced } from "../format";
import { pathsOf, type Path } from "../performance";
import { contactVariant } from "../proofs";
import { makePlayer } from "../player";
import type { Run } from "../run";
import { buildContact, hasNormal, touchingWithin } from "../scene/contact_scene";
import { makeStage } from "../scene/stage";
import { profileView } from "../scene/view_direction";
import { dot } from "../vector";
import type { View } from "../view";
import { askedOfContact, questionHead } from "./question_head";
import { badgeOf, button, commands, engine, tabs, versionOf } from "../widgets";
import { faultsIn, faultsOf, measuresTable, oraclesOf } from "./verdicts";
import * as three from "three";

const hidden = (text: string): HTMLElement => h("span", { class: "visually-hidden" }, text);
const vector = (v: Vec3): string => `(${v.map((x) => digits(x, 6)).join(", ")})`;

/** How long the proof plays [s]. */
const proofTime = 2;

const middleOf = (lo: number, hi: number): number => lo / 2 + hi / 2;

/** The words shown in place of a separation; none where the band says all. */
const statusWords: Record<string, string | undefined> = { crashed: "it crashed", "timed out": "it hung" };

/** A separation that an engine gives; a dash where it gives none. */
const separationText = (s: number | string | undefined): string => (s === undefined ? "–" : length(numberOf(s)));

export function contactView(run: Run, q: number, question: Question, start: Address): View {
  const contact = question.contact!;
  const { truth } = contact;
  const { oracles, findings } = run.report;
  let query = start.query;
  const ranked = oraclesOf(run, q);
  const named = oracles.findIndex((o) => o.name === query.get("o"));
  let explained = named >= 0 && ranked.includes(named) ? named : ranked[0] ?? -1;
  // The finding of the address, or else the gravest of the oracle that is explained.
  let asked = query.has("f") ? Number(query.get("f")) : -1;
  const told = (): number => (findings.question[asked] === q && findings.oracle[asked] === explained ? asked : explained < 0 ? -1 : run.gravest(q, explained));
  const shown = new Set<number>(explained >= 0 ? [explained] : []);

  const view = buildContact(contact, run.looks);
  const stage = makeStage(1 / view.frame.scale, [0, 0, 1], `Three-dimensional view of ${question.title}`);
  stage.scene.add(view.root);
  // Only when the page opens: two oracles are compared from one place.
  const lookInProfile = (): void => { if (hasNormal(truth.n)) stage.lookFrom(profileView(truth.n, paths.find(({ along }) => Math.abs(dot(along, truth.n)) < 0.9998)?.along ?? null)); };
  stage.fit(new three.Vector3(), view.radius);
  stage.label("A", view.A);
  stage.label("B", view.B);
  for (const { text, at } of view.names) stage.label(text, at, "beside");
  // Where the depth is seen in the large view, a close-up would only cover it.
  const inset = Math.max(Math.abs(truth.lo), Math.abs(truth.hi)) < 0.04 * question.size ? closeUp(contact, run.looks) : null;
  if (inset) stage.keepClear(() => (getComputedStyle(inset.element).position === "absolute" ? inset.element.offsetWidth : 0));
  const reading = h("output", { class: "reading", "aria-live": "polite" });
  const playButton = button("▶ Play the proof", () => play(), { class: "primary" });
  const slider = h("input", { type: "range", min: 0, max: 1000, value: 0, "aria-label": "Progress of the proof", on: { input: () => { const time = (Number(slider.value) / 1000) * proofTime; player.stop(); player.seek(time); } } });

  const player = makePlayer(0, proofTime, (time, playing) => {
    const state = view.prove(time / proofTime);
    inset?.draw([...shown], state, explained);
    slider.value = String(Math.round((time / proofTime) * 1000));
    fill(playButton, playing ? "❚❚ Pause" : time >= proofTime ? "↺ Play again" : "▶ Play the proof");
    stage.element.dataset.gap = String(state.gap);
    fill(reading, sayState(time, state));
    stage.invalidate();
  }, true);

  // The view widens once for a body that moves out of sight; after that the reader's own view stays.
  let widest = 1.1;
  function play(): void {
    const radius = view.radiusOfProof();
    if (!player.playing() && radius > widest) {
      widest = radius;
      stage.fit(new three.Vector3(), radius);
    }
    player.toggle();
  }

  function sayState(time: number, state: ReturnType<typeof view.prove>): string {
    const left = (moved: number, gap: number): string => (Math.abs(gap) <= touchingWithin(moved) ? "A and B just touch" : gap < 0 ? `still ${length(-gap)} too deep` : `a gap of ${length(gap)}`);
    const error = performed >= 0 && run.band[performed] < faultBands.length ? ` The error: ${nounOf(run, performed)}.` : "";
    const certifiedNow = truth.touching === "apart" ? `The plane fits between A and B: a gap of ${length(state.gap)}` : time === 0 ? "" : `B moved ${precise(state.moved)}: ${left(state.moved, state.gap)}`;
    if (time === 0) return certifiedNow && `${certifiedNow}.`;
    const ways = state.paths.map(({ moved, whole, gap }, i): string => (whole < 0
      ? `; ${length(-moved)} nearer, of the ${length(-whole)} that ${oracles[explained].name} says are free, ${gap < 0 ? `A and B overlap by ${length(-gap)}` : `a gap of ${length(gap)} is left`}`
      : `; along ${paths[i].words}, moved ${precise(moved)}: ${left(whole, gap)}`));
    return `${certifiedNow}${ways.join("")}.${error}`;
  }

  const applyShown = (): void => {
    oracles.forEach((_, o) => view.show(o, shown.has(o)));
    player.seek(player.time());
  };
  /** The finding whose proof is performed, -1 for none, and the ways of B that show it. */
  let performed = -1;
  let paths: Path[] = [];
  const drawProof = (finding: number): void => {
    performed = finding;
    const proof = finding < 0 ? null : run.proof(finding);
    paths = explained < 0 ? [] : pathsOf(contact, contact.answers[explained], proof, oracles[explained].name);
    view.explain(explained, paths, contactVariant(proof)?.n ?? undefined);
    if (proof?.kind === "common point") view.markPoints(proof.points, "common point");
    else view.markPoints(proof?.points ?? [], "point of the proof");
  };
  const ofProof = (i: number): Child => {
    const proof = run.proof(i);
    const variant = contactVariant(proof);
    const isMoved = i !== performed && proof !== null && pathsOf(contact, contact.answers[explained], proof, "").length > 0;
    return [
      variant && h("p", {}, h("b", {}, "Variant: "), `${spaced(variant.name)}${variant.how ? `, ${variant.how}` : ""}. The error is the larger of two changes once the answer is mapped back: that of the distance, and that of the overlap along the normal.`),
      isMoved && button("Perform this proof", () => { asked = i; explain(explained); play(); }, { class: "small" })];
  };
  const explain = (oracle: number): void => {
    explained = oracle;
    shown.add(oracle);
    player.stop();
    drawProof(told());
    head.tell(told());
    player.seek(0);
    applyShown();
    drawList();
    remember({ o: oracles[oracle].name, f: told() < 0 ? "" : String(told()) });
    tabList.select(query.get("tab") ?? "proof");
  };

  const list = h("tbody");
  const drawList = (): void => fill(list, ranked.map((o) => {
    const answer = contact.answers[o];
    const worst = o === explained ? told() : run.gravest(q, o);
    return h("tr", { class: o === explained ? "chosen" : "" },
      h("td", {}, h("input", { type: "checkbox", "aria-label": `Show the answer of ${oracles[o].name}`, checked: shown.has(o), disabled: answer?.status !== "answered",
        on: { change: (event: Event) => { if ((event.target as HTMLInputElement).checked) shown.add(o); else shown.delete(o); applyShown(); } } })),
      h("td", {}, h("input", { type: "radio", name: "explain", "aria-label": `Explain ${oracles[o].name}`, checked: o === explained, on: { change: () => explain(o) } })),
      h("th", { scope: "row" }, engine(run, o), versionOf(run, o)),
      h("td", {}, badgeOf(run, worst)),
      h("td", { class: "number", "data-label": "separation" }, answer?.status === "answered" ? (answer.separation === undefined ? (answer.touching ? "touching" : "apart") : separationText(answer.separation)) : statusWords[answer?.status ?? ""] ?? ""),
      h("td", { class: "number error", "data-label": "error", title: measureOf(run, worst) }, run.band[worst] < bands.indexOf("undecidable") ? [valueOf(run, worst), wordsOf(run, worst) === "" && h("span", { class: "of-measure" }, measureOf(run, worst))] : ""));
  }));
  const remember = (values: Record<string, string>): void => {
    for (const [key, value] of Object.entries(values)) query = withValue(query, key, value);
    history.replaceState(history.state, "", address(["s", question.id], query));
  };

  const truthLine = (): string => {
    if (truth.touching === "apart") return `A and B are apart by ${length(truth.lo)}.`;
    if (truth.touching === "undecided") return "Whether A and B touch is within the rounding of the input.";
    const depth = Math.max(-truth.lo, 0);
    return `A and B overlap: the certified shortest way out is ${length(depth)}, ${share(depth / question.size, sizedPartOf(question))}.`;
  };
  const certified = (): string => `Certified separation: ${digits(middleOf(truth.lo, truth.hi), 9)} m${truth.hi > truth.lo ? `, known to ${length((truth.hi - truth.lo) / 2)}` : ""}. Method: ${truth.method}.`;
  const tabList = tabs([
    { key: "proof", name: "Proof", make: () => [
      h("p", { class: "numbers" }, certified(), hasNormal(truth.n) && ` The shortest way out is along n = ${vector(truth.n)}.`),
      explained >= 0 && h("h2", {}, engine(run, explained)),
      explained >= 0 && faultsOf(run, q, explained, ofProof)] },
    { key: "measures", name: "Measures", make: () => [
      button("CSV of the answers", saveAnswers, { class: "small" }), measuresTable(run, q, explained)] },
    { key: "file", name: "File", make: () => h("pre", { tabindex: "0" }, question.toml) },
    { key: "reproduce", name: "Reproduce", make: () => [
      commands(question, oracles[explained]?.name ?? "", [
        ["All answers with proofs:", "touchstone explain ID --all"],
        explained >= 0 && [`${oracles[explained].name} alone, with nothing excused:`, "touchstone run ID --subject ORACLE --ledger /dev/null"],
        explained >= 0 && faultsIn(run, q, explained).length > 0 && ["The same fault in a question as small as can be:", "touchstone shrink ID --oracle ORACLE"],
        explained >= 0 && isReproducible(run, q, explained) && ["A program that shows the fault with the engine alone:", "touchstone reproduce ID --oracle ORACLE --out fault"]]),
      h("p", {}, h("a", { href: findingsAddress({ question: question.id, band: "all" }) }, "Every measurement of this question"))] },
  ], query.get("tab") ?? "proof", (key) => remember({ tab: key }));

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
  const head = questionHead(run, question, [askedOfContact(contact.A.shape, contact.B.shape), " ", h("b", {}, "Truth: "), truthLine()]);
  const element = h("section", { class: "question" },
    head.element,
      h("div", { class: "stage-column" },
        stage.element,
        inset?.element,
        view.note !== "" && h("p", { class: "quiet" }, view.note),
        h("div", { class: "toolbar", role: "toolbar", "aria-label": "View" },
          view.provable && [playButton, slider],
          axes.map(([name, d]) => button(name, () => look(d), { title: `Look along ${name}` })),
          hasNormal(truth.n) && button("n", () => look(truth.n), { title: "Look along the normal" }),
          hasNormal(truth.n) && button("n⊥", () => look(sideOf(truth.n)), { title: "Look across the normal" }),
          button("Fit", fit), button("PNG", () => { void picture(); })),
        reading,
        contactLegend(truth.patch.length, view.provable && truth.touching === "touching")),
      h("div", { class: "side-panel" },
        h("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Answers" },
          h("table", { class: "plain verdicts" },
            h("caption", {}, "Tick: its contacts are shown. Dot: it is explained below, and its direction performed with the proof."),
            h("thead", {}, h("tr", {}, h("th", { scope: "col" }, hidden("show")), h("th", { scope: "col" }, hidden("explain")), h("th", { scope: "col" }, "oracle"), h("th", { scope: "col" }, "worst"), h("th", { scope: "col", class: "number" }, "separation"), h("th", { scope: "col", class: "number" }, "error"))),
            list)),
        tabList.element));
  drawProof(told());
  lookInProfile();
  head.tell(told());
  player.seek(0);
  applyShown();
  drawList();

  return {
    title: question.title, element,
    keys: [
      ...(view.provable ? [{ keys: ["p", " "], does: "play the proof", run: () => play() }] : []),
      ...axes.map(([name, d]) => ({ keys: [name], does: `look along ${name}`, run: () => look(d) })),
      ...(hasNormal(truth.n) ? [{ keys: ["n"], does: "look along the normal", run: () => look(truth.n) }] : []),
      { keys: ["f"], does: "fit", run: fit },
      { keys: ["1", "2", "3", "4", "5", "6", "7", "8", "9"], does: "show one oracle alone", run: (key) => {
        const o = ranked[Number(key) - 1];
        if (o === undefined) return;
        shown.clear();
        explain(o);
      } },
      { keys: ["0"], does: "show all oracles", run: () => { for (const o of ranked) if (contact.answers[o].status === "answered") shown.add(o); applyShown(); drawList(); } },
      { keys: ["u"], does: "up to the group's findings", run: () => { location.hash = findingsAddress({ group: question.group }); } },
    ],
    dispose() { player.stop(); stage.dispose(); },
  };
}

/** Whether `touchstone reproduce` can write a program for a fault of an oracle: see docs/reproduce.md. */
function isReproducible(run: Run, q: number, oracle: number): boolean {
  const { findings, names, oracles, questions } = run.report;
  const { A, B } = questions[q].contact!;
  const has = (type: string): boolean => A.shape.type === type || B.shape.type === type;
  const { library } = oracles[oracle];
  if (!["Bullet", "DART", "FCL", "MuJoCo", "ODE", "libccd"].includes(library) || (library === "ODE" && has("hull"))) return false;
  const checked = ["touching", "separation_error", ...(has("half_space") ? [] : ["consistency_error", "excess", "duality_gap"])];
  return faultsIn(run, q, oracle).some((i) => checked.includes(names.measure[findings.measure[i]]?.name));
}

/** The legend of the marks in the view.
 * @param corners those of the true patch
 * @param isPerformed whether a proof is performed in the view, with its ways */
export function contactLegend(corners: number, isPerformed = false): HTMLElement {
  const item = (mark: SVGElement, text: string): HTMLElement => h("li", {}, mark, " ", text);
  const picture = (...parts: SVGElement[]): SVGElement => svg("svg", { viewBox: "0 0 16 12", class: "key", "aria-hidden": "true" }, parts);
  const line = (className: string, more: Record<string, number> = {}): SVGElement => svg("line", { x1: 2, y1: 6, x2: 14, y2: 6, class: className, ...more });
  return h("ul", { class: "marks", "aria-label": "Marks of the view" },
    item(picture(svg("rect", { x: 1, y: 1, width: 14, height: 10, class: "key-a" })), "A"), item(picture(svg("rect", { x: 1, y: 1, width: 14, height: 10, class: "key-b" })), "B"),
    item(picture(svg("rect", { x: 1, y: 1, width: 14, height: 10, class: "key-plane" })), "certified plane"),
    item(picture(svg("circle", { cx: 8, cy: 6, r: 4, class: "key-truth" })), "a, b: extreme points of A and B along the certified normal"),
    corners > 2 && item(picture(svg("rect", { x: 1, y: 1, width: 14, height: 10, class: "key-patch" }), svg("path", { d: "M3 11 11 1M8 11 15 3", class: "key-hatch" })), "true patch"),
    corners === 2 && item(picture(svg("path", { d: "M1 11 15 1", class: "key-hatch" })), "true patch, a line"),
    item(picture(svg("circle", { cx: 8, cy: 6, r: 3, class: "key-oracle" }), line("key-oracle-line", { x1: 8, x2: 8, y1: 0, y2: 12 })), "contact of an oracle, its stem as long as its depth"),
    item(picture(line("key-oracle-line"), svg("path", { d: "M10 2 15 6 10 10", class: "key-oracle" })), "normal of an oracle"),
    isPerformed && [
      item(picture(line("key-way"), svg("path", { d: "M8 1 15 6 8 11", class: "key-truth" })), "played: the certified way of B"),
      item(picture(line("key-oracle-line", { "stroke-width": 4 }), svg("path", { d: "M8 1 15 6 8 11", class: "key-oracle" })), "played: the way of the chosen oracle; thin: what is left; broken: not to scale"),
      item(picture(svg("rect", { x: 1, y: 1, width: 14, height: 10, class: "key-ghost" })), "played: copy of B on that way")]);
}

/** A level direction across n, from which the gap is seen in profile. */
function sideOf(n: Vec3): Vec3 {
  const level: Vec3 = [n[1], -n[0], 0];
  return Math.hypot(...level) > 1e-6 ? level : [0, -1, 0];
}
