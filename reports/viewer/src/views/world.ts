import { address, withValue, type Address } from "../address";
import { bands, faultBands } from "../bands";
import type { Question } from "../data";
import { fill, h, type Child } from "../dom";
import { downloadCsv, downloadPicture, fileName } from "../download";
import { findingsAddress, measureOf, valueOf } from "../findings_table";
import { counted, digits, seconds, spaced } from "../format";
import { makeLanes } from "../lanes";
import { makePlayer } from "../player";
import { makePlot } from "../plots";
import { worldVariant } from "../proof_text";
import type { Run } from "../run";
import { makeStage, startingView } from "../scene/stage";
import { answered, buildWorld, sampleAt } from "../scene/world_scene";
import { firstDifference, plotData, quantitiesOf } from "../series";
import type { View } from "../view";
import { badge, button, command, engine, tabs } from "../widgets";
import { faultsOf, measuresTable, oraclesOf } from "./verdicts";
import { variantsPanel } from "./world_variants";
import { reach } from "../scene/support";

export function worldView(run: Run, q: number, question: Question, start: Address): View {
  const world = question.world!;
  const { oracles, subject } = run.report;
  let query = start.query;
  const ranked = oraclesOf(run, q);
  const movers = ranked.filter((o) => answered(world.motions[o]));
  const named = oracles.findIndex((o) => o.name === query.get("o"));
  // The solid engine is the one that passes, so that the ghosts show what the others do differently.
  const passes = (o: number): boolean => run.band[run.gravest(q, o)] >= faultBands.length;
  let solid = movers.includes(subject) && passes(subject) ? subject : [...movers].reverse().find(passes) ?? movers[0] ?? -1;
  let explained = named >= 0 && ranked.includes(named) ? named : ranked[0] ?? -1;
  // An address that names an oracle asks about that one: it is solid, and seen where it parts from the one that is trusted.
  const trusted = solid;
  const isNamed = named >= 0 && movers.includes(named);
  if (isNamed) solid = named;
  let shown = new Set(query.get("solo") === "1" && solid >= 0 ? [solid] : movers);

  const view = buildWorld(run, world, [solid, subject, ...movers]);
  const stage = makeStage(1 / view.frame.scale, view.up, `Playback of ${question.title}`);
  stage.scene.add(view.root);
  stage.lookFrom(startingView(view.up));
  stage.fit(view.centre, view.radius);
  stage.label("world", () => view.marked(0), true);
  stage.label("variant", () => view.marked(1), true);

  const first = world.times[0] ?? 0;
  const end = world.times[world.times.length - 1] ?? 0;
  const clock = h("output", { class: "clock" });
  const slider = h("input", { type: "range", min: 0, max: Math.max(1, world.times.length - 1), step: "any", value: 0, "aria-label": "Time", on: { input: () => { const time = timeAt(Number(slider.value)); player.stop(); player.seek(time); } } });
  const playButton = button("▶ Play", () => player.toggle(), { class: "primary" });
  const timeAt = (sample: number): number => {
    const i = Math.floor(sample);
    return (world.times[i] ?? end) + (sample - i) * ((world.times[i + 1] ?? end) - (world.times[i] ?? end));
  };

  let followed = -1;
  const plots = [0, 1].map((i) => makePlot(i === 0 ? "First plot" : "Second plot", (time) => { player.stop(); player.seek(time); }, "None of the oracles shown has this quantity."));
  const player = makePlayer(first, end, (time, playing) => {
    view.setTime(time);
    const { sample, part } = sampleAt(world.times, time);
    slider.value = String(sample + part);
    slider.setAttribute("aria-valuetext", seconds(time));
    fill(clock, `${seconds(time)} of ${seconds(end)}, step ${Math.round(time / world.dt)}`);
    stage.element.dataset.time = String(time);
    fill(playButton, playing ? "❚❚ Stop" : time >= end ? "↺ Play again" : "▶ Play");
    if (followed >= 0) stage.follow(view.bodyAt(solid, followed));
    for (const plot of plots) plot.setTime(time);
    stage.invalidate();
  }, false);
  const stepBy = (count: number): void => { player.stop(); player.seek(world.times[Math.max(0, Math.min(world.times.length - 1, sampleAt(world.times, player.time() + 1e-9).sample + count))] ?? first); };
  const lanes = makeLanes(run, q, world, (time) => { player.stop(); player.seek(time); });

  // Plots.
  const log = h("input", { type: "checkbox", id: "log", on: { change: () => drawPlots() } });
  const toTruth = h("input", { type: "checkbox", id: "to-truth", on: { change: () => drawPlots() } });
  let menu = quantitiesOf(world, oracles[solid]?.name ?? "");
  const selects = plots.map((_, i) => h("select", { "aria-label": i === 0 ? "Quantity of the first plot" : "Quantity of the second plot", on: { change: () => { remember(`y${i}`, selects[i].value); drawPlots(); } } }));
  const drawMenu = (): void => selects.forEach((select, i) => {
    const chosen = select.value || query.get(`y${i}`) || (menu[i] ?? menu[0])?.key || "";
    fill(select, menu.map((item) => h("option", { value: item.key }, item.name)));
    select.value = chosen;
    if (select.selectedIndex < 0) select.selectedIndex = 0;
  });
  const drawPlots = (): void => plots.forEach((plot, i) => {
    const quantity = menu.find((item) => item.key === selects[i].value);
    if (quantity) plot.set(plotData(run, world, quantity, movers.filter((o) => shown.has(o)), solid, log.checked, toTruth.checked));
    plot.setTime(player.time());
  });

  const showAll = button("Show all", () => all(), { class: "small" });
  const list = h("tbody");
  const drawList = (): void => fill(list, ranked.map((o) => {
    const moves = movers.includes(o);
    const worst = run.gravest(q, o);
    return h("tr", { class: o === explained ? "chosen" : "" },
      h("td", {}, h("input", { type: "checkbox", "aria-label": `Show ${oracles[o].name}`, checked: shown.has(o), disabled: !moves,
        on: { change: (event: Event) => { if ((event.target as HTMLInputElement).checked) shown.add(o); else shown.delete(o); apply(); } } })),
      h("td", {}, h("input", { type: "radio", name: "solid", "aria-label": `Draw ${oracles[o].name} solid`, checked: o === solid, disabled: !moves, on: { change: () => { solid = o; shown.add(o); apply(); } } })),
      h("th", { scope: "row" }, engine(run, o)),
      h("td", {}, badge(bands[run.band[worst]])),
      h("td", { class: "number", "data-label": "error" }, run.band[worst] < faultBands.length ? valueOf(run, worst) : moves ? "" : world.motions[o]?.status ?? "not asked"),
      h("td", {}, button("Explain", () => explain(o), { class: "small", "aria-pressed": String(o === explained) })));
  }));
  const apply = (): void => {
    oracles.forEach((_, o) => view.show(o, !shown.has(o) ? "hidden" : o === solid ? "solid" : "ghost"));
    menu = quantitiesOf(world, oracles[solid]?.name ?? "");
    drawMenu();
    drawPlots();
    drawList();
    lanes.set([...shown], solid);
    showAll.hidden = movers.every((o) => shown.has(o));
    player.seek(player.time());
  };
  const remember = (key: string, value: string): void => {
    query = withValue(query, key, value);
    history.replaceState(history.state, "", address(["s", question.id], query));
  };
  const explain = (o: number): void => {
    explained = o;
    remember("o", oracles[o].name);
    drawList();
    tabList.select("proof");
  };
  const solo = (o: number): void => { shown = new Set([o]); solid = o; apply(); };
  const all = (): void => { shown = new Set(movers); apply(); };

  /** Goes to the first moment at which one of `others` is elsewhere than `reference`, and lets the camera follow that body. */
  const jumpToDifference = (reference: number, others: number[], seeks: boolean): void => {
    const sizes = world.bodies.filter((b) => !b.fixed).map((b) => reach(b.shape)).filter((r) => r > 0);
    const size = 0.01 * (sizes.length ? Math.min(...sizes) : 1 / view.frame.scale);
    const difference = firstDifference(run, world, reference, others, size);
    fill(note, difference
      ? `${oracles[difference.oracle].name} parts from ${oracles[reference].name} by over 1 % of the smallest body at ${seconds(world.times[difference.sample])}: ${world.bodies[difference.body].name}.`
      : `The oracles shown keep within 1 % of the smallest body of ${oracles[reference]?.name ?? "one another"}.`);
    if (!difference) return;
    player.stop();
    followed = difference.body;
    follow.value = String(followed);
    player.seek(seeks ? world.times[difference.sample] : player.time());
    const quantity = menu.find((item) => item.body === difference.body && item.key.startsWith("apart"));
    if (quantity) { selects[1].value = quantity.key; drawPlots(); }
  };
  /** Opens the world just before the fault of the address: where its law breaks, or else where the oracles part. */
  const openAtFault = (): void => {
    if (isNamed && named !== trusted && query.get("solo") !== "1") jumpToDifference(trusted, [named], false);
    if (query.has("t") || !isNamed) return;
    const f = run.report.findings;
    const finding = query.has("f") ? Number(query.get("f")) : -1;
    const isOurs = f.question[finding] === q && f.oracle[finding] === named;
    const variant = isOurs ? worldVariant(run.text(f.proof[finding])) : null;
    const broken = isOurs ? f.time?.[finding] ?? -1 : -1;
    const sizes = world.bodies.filter((b) => !b.fixed).map((b) => reach(b.shape)).filter((r) => r > 0);
    const parts = named !== trusted ? firstDifference(run, world, trusted, [named], 0.01 * (sizes.length ? Math.min(...sizes) : 1 / view.frame.scale)) : null;
    const [time, what] = broken >= 0 ? [broken, `${oracles[named].name} is wrong in ${measureOf(run, finding)}`]
      : variant ? [variant.time, `${oracles[named].name} and its variant are farthest apart`]
        : parts ? [world.times[parts.sample], `${oracles[named].name} parts from ${oracles[trusted].name}`] : [-1, ""];
    if (time < 0) return;
    const before = world.times.filter((t) => t < time).at(-1) ?? first;
    player.seek(before);
    note.prepend(`Opened at ${seconds(before)}, ${before < time ? "just before" : "where"} ${what} (${seconds(time)}). `);
  };
  const note = h("p", { class: "reading", role: "status" });
  const ofVariant = (i: number): Child => {
    const variant = worldVariant(run.text(run.report.findings.proof[i]));
    return variant && [
      h("p", {}, "The error is the largest over all bodies and samples of distance + angle × radius, with the radius of the largest body."),
      button("Show both places", () => {
        player.stop();
        view.mark([variant.own, variant.variant]);
        player.seek(variant.time);
        const [own, other] = [view.marked(0)!, view.marked(1)!];
        const shape = world.bodies.find((b) => b.name === variant.body)?.shape;
        followed = -1;
        follow.value = "-1";
        stage.fit(own.clone().lerp(other, 0.5), Math.max(own.distanceTo(other), shape ? 2.5 * reach(shape) * view.frame.scale : 0, 0.05));
        fill(note, `${variant.body} in the world itself, and in its variant mapped back, at ${seconds(variant.time)}.`);
        stage.invalidate();
      }, { class: "small" })];
  };

  const tabList = tabs([
    { key: "proof", name: "Proof", make: () => explained < 0 ? "No oracle was asked." : [
      h("h2", {}, engine(run, explained)),
      world.motions[explained]?.reason && h("p", {}, world.motions[explained].reason),
      world.motions[explained]?.diverged_at_step !== undefined && world.motions[explained].diverged_at_step! > 0 && h("p", {}, `Its motion diverged at step ${world.motions[explained].diverged_at_step}.`),
      faultsOf(run, q, explained, ofVariant)] },
    { key: "variants", name: "Variants", make: () => variantsPanel(run, q) },
    { key: "measures", name: "Measures", make: () => measuresTable(run, q, explained) },
    { key: "file", name: "File", make: () => h("pre", { tabindex: "0" }, question.toml) },
    { key: "reproduce", name: "Reproduce", make: () => [
      h("p", {}, "All oracles with proofs:"), command(`touchstone explain ${question.id} --all`),
      explained >= 0 && [h("p", {}, `The motion of ${oracles[explained].name} as a table:`), command(`touchstone simulate ${question.id} --oracle ${oracles[explained].name} --csv motion.csv`),
        h("p", {}, "With the oracle's own settings:"), command(`touchstone explain ${question.id} --against ${oracles[explained].name} --as-shipped`)],
      h("p", {}, h("a", { href: findingsAddress({ question: question.id, band: "all" }) }, "Every measurement of this question"))] },
  ], query.get("tab") ?? "proof", (key) => remember("tab", key));

  const speed = h("select", { "aria-label": "Speed", on: { change: () => { player.speed = Number(speed.value); } } },
    [0.02, 0.1, 0.25, 0.5, 1, 2, 4].map((s) => h("option", { value: s, selected: s === 1 }, `× ${s}`)));
  const follow = h("select", { "aria-label": "Camera follows", on: { change: () => { followed = Number(follow.value); player.seek(player.time()); } } },
    h("option", { value: -1 }, "camera stays"), world.bodies.map((b, i) => !b.fixed && h("option", { value: i }, `follow ${b.name}`)));
  const toggle = (text: string, change: (on: boolean) => void): HTMLElement => h("label", {}, h("input", { type: "checkbox", checked: true, on: { change: (e: Event) => { change((e.target as HTMLInputElement).checked); stage.invalidate(); } } }), text);
  const savePlots = (): void => {
    const quantity = menu.find((item) => item.key === selects[0].value);
    if (!quantity) return;
    const data = plotData(run, world, quantity, movers.filter((o) => shown.has(o)), solid, false, false);
    downloadCsv(fileName(`${question.id}_${quantity.name}`, "csv"), [["time [s]", ...(data.truth ? ["truth"] : []), ...data.lines.map((l) => `${l.name} [${quantity.unit}]`)],
      ...data.times.map((t, i) => [t, ...(data.truth ? [data.truth.values[i] ?? ""] : []), ...data.lines.map((l) => l.values[i] ?? "")])]);
  };
  const axes: [string, [number, number, number]][] = [["x", [1, 0, 0]], ["y", [0, -1, 0]], ["z", [0, 0, 1]]];
  const fit = (): void => { followed = -1; follow.value = "-1"; stage.fit(view.centre, view.radius); };

  const element = h("section", { class: "question" },
    h("header", { class: "question-head" },
      h("p", { class: "quiet" }, h("a", { href: findingsAddress({ group: question.group }) }, question.group), " · ", h("span", { class: "id" }, question.id)),
      h("h1", { dir: "auto" }, question.title),
      world.claims.length > 0 && h("p", {}, h("b", {}, "Claimed: "), [...new Set(world.claims)].map(spaced).join("; "), "."),
      h("p", { class: "quiet" }, `${counted(world.steps, "step")} of ${digits(world.dt, 6)} s, gravity (${world.gravity.map((g) => digits(g, 4)).join(", ")}) m/s²`,
        world.thinned > 1 && `; one in ${world.thinned} samples of the run is kept here`, ".")),
    h("div", { class: "stage-and-panel" },
      h("div", { class: "stage-column" },
        stage.element,
        h("div", { class: "time-panel" },
          h("div", { class: "toolbar", role: "toolbar", "aria-label": "Time" }, playButton, button("◂", () => stepBy(-1), { title: "One sample back", "aria-label": "One sample back" }), button("▸", () => stepBy(1), { title: "One sample on", "aria-label": "One sample on" }), speed, clock,
            movers.length > 1 && button("First difference", () => jumpToDifference(solid, [...shown], true))),
          h("div", { class: "lane-row" }, h("span", { class: "lane-name" }, "time"), slider),
          lanes.element, note),
        h("div", { class: "toolbar", role: "toolbar", "aria-label": "View" },
          axes.map(([name, d]) => button(name, () => stage.lookFrom(d), { title: `Look along ${name}` })), button("Fit", fit), follow,
          toggle("trails", (on) => view.showTrails(on)), toggle("impulses", (on) => view.showImpulses(on)),
          button("PNG", () => { void stage.picture().then((picture) => downloadPicture(fileName(question.id, "png"), picture)); })),
        h("div", { class: "plots" },
          h("div", { class: "toolbar" }, h("label", { for: "log" }, log, "logarithmic"), world.curves.some((c) => c.truth) && h("label", { for: "to-truth" }, toTruth, "difference to the truth"), button("CSV", savePlots, { class: "small" }),
            h("span", { class: "quiet" }, "Dashed and uncoloured: the truth, in its tolerance. Drag to zoom, double-click to zoom out, click to go there.")),
          plots.map((plot, i) => [selects[i], plot.element]))),
      h("div", { class: "side-panel" },
        h("p", { class: "toolbar" }, showAll),
        h("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Oracles" },
          h("table", { class: "plain verdicts" },
            h("caption", {}, "Tick: it is shown. Dot: it is solid, the others are ghosts."),
            h("thead", {}, h("tr", {}, h("th", { scope: "col" }, h("span", { class: "visually-hidden" }, "show")), h("th", { scope: "col" }, h("span", { class: "visually-hidden" }, "solid")), h("th", { scope: "col" }, "oracle"), h("th", { scope: "col" }, "worst"), h("th", { scope: "col", class: "number" }, "error"), h("th", { scope: "col" }, h("span", { class: "visually-hidden" }, "explain")))),
            list)),
        tabList.element)));
  apply();
  player.seek(Number(query.get("t")) || first);
  openAtFault();

  return {
    title: question.title, element,
    keys: [
      { keys: [" "], does: "play or stop", run: () => player.toggle() },
      { keys: ["ArrowLeft"], does: "one sample back", run: () => stepBy(-1) },
      { keys: ["ArrowRight"], does: "one sample on", run: () => stepBy(1) },
      { keys: ["1", "2", "3", "4", "5", "6", "7", "8", "9"], does: "one oracle alone", run: (key) => { const o = movers[Number(key) - 1]; if (o !== undefined) solo(o); } },
      { keys: ["0"], does: "all oracles", run: all },
      ...axes.map(([name, d]) => ({ keys: [name], does: `look along ${name}`, run: () => stage.lookFrom(d) })),
      { keys: ["f"], does: "fit", run: fit },
      { keys: ["d"], does: "first difference", run: () => jumpToDifference(solid, [...shown], true) },
      { keys: ["u"], does: "up to the group's findings", run: () => { location.hash = findingsAddress({ group: question.group }); } },
    ],
    dispose() { player.stop(); for (const plot of plots) plot.dispose(); stage.dispose(); },
  };
}
