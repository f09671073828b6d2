import { address, withValue, type Address } from "../address";
import { faultBands } from "../bands";
import type { Question, World } from "../data";
import { fill, h, type Child } from "../dom";
import { downloadCsv, downloadPicture, fileName } from "../download";
import { findingsAddress, measureOf, nounOf, valueOf } from "../findings_table";
import { counted, digits, length, quoted, seconds, spaced } from "../format";
import { gravityInWords, questionHead } from "./question_head";
import { makeLanes } from "../lanes";
import { makePlayer } from "../player";
import { makePlot } from "../plots";
import { worldVariant } from "../proofs";
import type { Run } from "../run";
import { makeStage, type Ball } from "../scene/stage";
import { startingView } from "../scene/view_direction";
import { answered } from "../scene/motion_extent";
import { buildWorld, sampleAt } from "../scene/world_scene";
import { angleBetween, differsFromTruth, firstDifference, largestOf, plotData, quantitiesOf, type Difference, type Quantity } from "../series";
import type { View } from "../view";
import { button, commands, engine, tabs } from "../widgets";
import { badgeOn, faultsOf, measuresTable, oraclesOf } from "./verdicts";
import { variantsPanel } from "./world_variants";
import { overlapAlong, reach } from "../scene/support";
import { marker } from "../engines";
import { acrossMotion, isWide, movingRegion, passageOf, plotsOf, regionOf, trustedOf, worldFault, type WorldFault } from "../world_fault";
import { rates, startingRate } from "../playback_rate";
import { toScene } from "../scene/parts";
import type * as three from "three";

/** Bodies and particles up to whose number their names are shown at first: more would cover the picture. */
const mostNamed = 12;

/** Ghosts that may turn about one place. */
const mostGhosts = 4;

/** A plot whose fault is so many times larger than the truth is logarithmic at first: a linear one would show the truth as zero. */
const flattened = 1e3;

const everyMotion = " (of every motion)";

/** The question of a world in one sentence. */
function askedOfWorld(world: World): Child[] {
  const claims = [...new Set(world.claims)];
  const [universal, own] = [claims.filter((c) => c.endsWith(everyMotion)), claims.filter((c) => !c.endsWith(everyMotion))];
  const moving = world.bodies.filter((b) => !b.fixed).length;
  const what = [moving > 0 && counted(moving, "body", "bodies"), world.particles.length > 0 && counted(world.particles.length, "particle"), world.cloths.length > 0 && counted(world.cloths.length, "cloth")].filter((part) => part !== false);
  const every = h("span", { class: "rounded", title: universal.map((c) => spaced(c.slice(0, -everyMotion.length))).join("; ") }, counted(universal.length, "law"), " of every motion");
  return [`how do ${what.join(" and ")} move in ${counted(world.steps, "step")} of ${digits(world.dt, 6)} s, ${digits(world.steps * world.dt)} s in all, ${gravityInWords(world.gravity)}? `,
    claims.length > 0 && [h("b", {}, "Must hold: "), own.map(spaced).join("; "), universal.length > 0 && [own.length > 0 && "; ", every], "."]];
}

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

  // The finding of the address, or else the gravest of the oracle that is explained.
  const f = run.report.findings;
  const asked = query.has("f") ? Number(query.get("f")) : -1;
  const isOurs = named >= 0 && f.question[asked] === q && f.oracle[asked] === named;
  const gravest = explained >= 0 ? run.gravest(q, explained) : -1;
  const told = isOurs ? asked : gravest >= 0 && run.band[gravest] < faultBands.length ? gravest : -1;
  /** The finding that the heading and the table show of the oracle that is explained. */
  let shownFinding = told >= 0 ? told : gravest;
  const fault = told >= 0 ? worldFault(run, world, told) : null;

  const view = buildWorld(run, world, trustedOf(run, world, q));
  const stage = makeStage(1 / view.frame.scale, view.up, `Playback of ${question.title}`);
  stage.element.classList.add("of-world");
  stage.scene.add(view.root);
  stage.lookFrom(startingView(view.up));
  stage.fitAll(view.extent);
  const passage = fault ? passageOf(run, view, world, fault, explained, trusted) : null;
  let markNames = ["world", "variant"];
  stage.label(() => markNames[0], () => view.marked(0), "beside");
  stage.label(() => markNames[1], () => view.marked(1), "beside");
  /** Where a fixed body is named: one that is larger than the view at its part near the upper edge, clear of what happens in the middle. */
  const groundIn = (b: number): three.Vector3 => {
    const place = view.groundAt(b);
    const size = reach(world.bodies[b].shape) * view.frame.scale;
    const { centre, radius, above } = stage.seen();
    if (size === 0 || size < radius) return place;
    const up = above.clone();
    const offset = place.clone().sub(centre);
    const { shape, start } = world.bodies[b];
    const reaches = overlapAlong({ shape, ...start }, { shape: { type: "sphere", radius: 0 }, p: start.p, q: [1, 0, 0, 0] }, up.toArray()) * view.frame.scale;
    const wanted = 0.8 * radius - offset.dot(up);
    return place.addScaledVector(up, Math.max(-reaches, Math.min(reaches, wanted)));
  };
  const namesShown = h("input", { type: "checkbox", checked: world.bodies.length + world.particles.length <= mostNamed, on: { change: () => stage.invalidate() } });
  // Moving bodies are named first, so that the names of the ground make way.
  for (const fixed of [false, true]) world.bodies.forEach((body, b) => { if (body.fixed === fixed) stage.label(body.name, () => (!namesShown.checked ? null : fixed ? groundIn(b) : view.hasEnded(solid) ? null : view.bodyAt(solid, b))); });
  // The ghost that shows what should have happened says whose it is.
  if (passage && trusted >= 0 && trusted !== explained) {
    stage.label(`${oracles[trusted].name}: ${world.bodies[passage.mover].name}`, () => {
      const at = view.bodyAt(trusted, passage.mover);
      const size = reach(world.bodies[passage.mover].shape) * view.frame.scale;
      return shown.has(trusted) && solid !== trusted && at.distanceTo(view.bodyAt(solid, passage.mover)) > 2 * size ? at : null;
    });
  }
  world.particles.forEach((particle, k) => stage.label(particle.name, () => (namesShown.checked ? view.particleAt(solid, k) : null)));
  const legend = h("ul", { class: "stage-legend", "aria-label": "Colours of the oracles" });

  const first = world.times[0] ?? 0;
  const end = world.times[world.times.length - 1] ?? 0;
  const clock = h("output", { class: "clock" });
  const slider = h("input", { type: "range", min: 0, max: Math.max(1, world.times.length - 1), step: "any", value: 0, "aria-label": "Time", on: { input: () => { const time = timeAt(Number(slider.value)); player.stop(); player.seek(time); } } });
  const playButton = button("▶ Play", () => play(), { class: "primary" });
  const timeAt = (sample: number): number => {
    const i = Math.floor(sample);
    return (world.times[i] ?? end) + (sample - i) * ((world.times[i + 1] ?? end) - (world.times[i] ?? end));
  };

  // The moment is part of the address, so that a reload and a link open there. Browsers allow few changes of it in a second.
  let isOpened = false;
  let waitingTime = 0;
  const rememberTime = (time: number): void => {
    clearTimeout(waitingTime);
    waitingTime = window.setTimeout(() => remember("t", String(Number(time.toPrecision(7)))), 200);
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
    if (isOpened && !playing) rememberTime(time);
    fill(playButton, playing ? "❚❚ Pause" : time >= end ? "↺ Play again" : "▶ Play");
    if (followed >= 0) stage.follow(view.bodyAt(solid, followed));
    for (const plot of plots) plot.setTime(time);
    for (const item of legend.children) item.classList.toggle("ended", view.hasEnded(Number((item as HTMLElement).dataset.oracle)));
    stage.invalidate();
  }, false);
  /** Plays, and keeps in sight what a close view would soon lose: the camera follows a body of the fault. */
  let isClose = false;
  const play = (): void => {
    if (!player.playing() && isClose && !stage.isTouched()) {
      isClose = false;
      followed = fault?.bodies[0] ?? world.bodies.findIndex((b) => !b.fixed);
      follow.value = String(followed);
    }
    player.toggle();
  };
  const stepBy = (count: number): void => { player.stop(); player.seek(world.times[Math.max(0, Math.min(world.times.length - 1, sampleAt(world.times, player.time() + 1e-9).sample + count))] ?? first); };
  const lanes = makeLanes(run, q, world, (time) => { player.stop(); player.seek(time); });

  // Plots.
  const log = h("input", { type: "checkbox", id: "log", on: { change: () => drawPlots() } });
  const toTruth = h("input", { type: "checkbox", id: "to-truth", on: { change: () => drawPlots() } });
  let menu = quantitiesOf(world, oracles[solid]?.name ?? "");
  // The plots of the sentence that the reader comes from are about its body.
  const shownFirst = fault ? plotsOf(run, world, menu, fault, explained) : [-1, -1];
  log.checked = shownFirst.some((i) => menu[i] && trusted !== explained && largestOf(run, world, menu[i], [explained]) > flattened * largestOf(run, world, menu[i], [trusted]) && largestOf(run, world, menu[i], [trusted]) > 0);
  const selects = plots.map((_, i) => h("select", { "aria-label": i === 0 ? "Quantity of the first plot" : "Quantity of the second plot", on: { change: () => { remember(`y${i}`, selects[i].value); drawPlots(); } } }));
  const chosenIn = (i: number): Quantity | undefined => menu.find((item) => item.key === selects[i].value);
  const whyNot = h("span", { class: "quiet" });
  const drawMenu = (): void => selects.forEach((select, i) => {
    const wanted = select.value || query.get(`y${i}`) || "";
    const chosen = menu.find((item) => item.key === wanted || item.also === wanted)?.key || (menu[shownFirst[i]] ?? menu[i] ?? menu[0])?.key || "";
    fill(select, menu.map((item) => h("option", { value: item.key }, item.name)));
    select.value = chosen;
    if (select.selectedIndex < 0) select.selectedIndex = 0;
  });
  const drawPlots = (): void => plots.forEach((plot, i) => {
    const quantity = chosenIn(i);
    const differ = plots.some((_, k) => { const other = chosenIn(k); return other !== undefined && differsFromTruth(run, other); });
    toTruth.disabled = !differ;
    whyNot.textContent = differ ? "" : plots.some((_, k) => chosenIn(k)?.curve?.truth !== undefined) ? " (the plot is one)" : " (no formula of these is known)";
    if (quantity) plot.set(plotData(run, world, quantity, movers.filter((o) => shown.has(o)), solid, log.checked, toTruth.checked && !toTruth.disabled));
    plot.setTime(player.time());
  });

  const showAll = button("Show all", () => all(), { class: "small" });
  const showAllRow = h("p", { class: "toolbar" }, showAll);
  const list = h("tbody");
  const drawList = (): void => fill(list, ranked.map((o) => {
    const moves = movers.includes(o);
    const worst = o === explained && shownFinding >= 0 ? shownFinding : run.gravest(q, o);
    return h("tr", { class: o === explained ? "chosen" : "" },
      h("td", {}, h("input", { type: "checkbox", "aria-label": `Show ${oracles[o].name}`, checked: shown.has(o), disabled: !moves,
        on: { change: (event: Event) => { setShown(o, (event.target as HTMLInputElement).checked); } } })),
      h("td", {}, h("input", { type: "radio", name: "solid", "aria-label": `Draw ${oracles[o].name} solid`, checked: o === solid, disabled: !moves, on: { change: () => { solid = o; shown.add(o); apply(); } } })),
      h("th", { scope: "row" }, engine(run, o)),
      h("td", {}, badgeOn(run, q, o, worst)),
      h("td", { class: "number error", "data-label": "error", title: measureOf(run, worst) }, run.band[worst] < faultBands.length ? valueOf(run, worst) : ""),
      h("td", {}, button("Explain", () => explain(o), { class: "small", "aria-pressed": String(o === explained) })));
  }));
  const apply = (): void => {
    oracles.forEach((_, o) => view.show(o, !shown.has(o) ? "hidden" : o === solid ? "solid" : "ghost"));
    menu = quantitiesOf(world, oracles[solid]?.name ?? "");
    drawMenu();
    drawPlots();
    drawList();
    lanes.set([...shown], solid);
    fill(legend, movers.filter((o) => shown.has(o)).map((o) => h("li", { class: o === solid ? "solid" : "", "data-oracle": o }, marker(run.looks[o]), " ", oracles[o].name, o === solid && shown.size > 1 && " (solid)", endOf(o) && h("span", { class: "end" }, ` ${endOf(o)}`))));
    showAllRow.hidden = movers.every((o) => shown.has(o));
    player.seek(player.time());
  };
  /** Shows or hides an oracle. Where the solid one is hidden, the next that is shown becomes solid: ghosts alone are hard to see. */
  const setShown = (o: number, isShown: boolean): void => {
    if (isShown) shown.add(o);
    else shown.delete(o);
    if (!shown.has(solid)) solid = ranked.find((other) => shown.has(other)) ?? solid;
    apply();
  };
  const remember = (key: string, value: string): void => {
    query = withValue(query, key, value);
    history.replaceState(history.state, "", address(["s", question.id], query));
  };
  const explain = (o: number): void => {
    explained = o;
    remember("o", oracles[o].name);
    shownFinding = run.gravest(q, o);
    head.tell(shownFinding);
    drawList();
    tabList.select("proof");
  };
  /** Why a motion is not in sight to its end: it has diverged, or it goes far beyond the others. */
  const endOf = (o: number): string => {
    const leaves = view.left.get(o);
    const diverged = world.motions[o].diverged_at_step ?? 0;
    return [leaves !== undefined ? `leaves the view at ${seconds(leaves)}` : "", diverged > 0 ? `diverges at ${seconds(diverged * world.dt)}` : ""].filter((text) => text !== "").join(", ");
  };
  const solo = (o: number): void => { shown = new Set([o]); solid = o; apply(); };
  const all = (): void => { shown = new Set(movers); apply(); };

  /** Whether most of a difference, distance + angle × radius, is the angle. */
  const isTurned = ({ distance, angle, radius }: Difference): boolean => radius * angle > distance;
  const partsBy = (difference: Difference): string => {
    const { distance, angle } = difference;
    const turned = `${digits((angle * 180) / Math.PI, 2)}°`;
    return angle === 0 ? `${length(distance)} away` : isTurned(difference) ? `turned by ${turned}, and ${length(distance)} away` : `${length(distance)} away, and turned by ${turned}`;
  };
  /** Says when one of `others` is first elsewhere than `reference`; with `seeks` goes there, and the camera follows that body if it is small. */
  const jumpToDifference = (reference: number, others: number[], seeks: boolean): void => {
    const sizes = world.bodies.filter((b) => !b.fixed).map((b) => reach(b.shape)).filter((r) => r > 0);
    const size = 0.01 * (sizes.length ? Math.min(...sizes) : 1 / view.frame.scale);
    const difference = firstDifference(run, world, reference, others, size);
    fill(note, difference
      ? `${oracles[difference.oracle].name} parts from ${oracles[reference].name} by over 1 % of the smallest body at ${seconds(world.times[difference.sample])}: ${quoted(world.bodies[difference.body].name)} is ${partsBy(difference)}.`
      : `${others.length === 1 ? `${oracles[others[0]].name} keeps` : "The oracles shown keep"} within 1 % of the smallest body of ${oracles[reference]?.name ?? "one another"}.`);
    if (!difference) return;
    player.stop();
    if (seeks && isWide(view, world, [difference.body])) {
      followed = difference.body;
      follow.value = String(followed);
    }
    player.seek(seeks ? world.times[difference.sample] : player.time());
    const quantity = menu.find((item) => item.body === difference.body && item.key.startsWith(isTurned(difference) ? "turned" : "apart"));
    if (quantity && (seeks || shownFirst[1] < 0)) { selects[1].value = quantity.key; drawPlots(); }
  };
  /** Where many ghosts turn about one place nothing can be told apart: only the solid one and the trusted one are then shown. */
  const thinGhosts = (): void => {
    const about = fault?.bodies[0] ?? world.bodies.findIndex((b) => !b.fixed);
    const track = world.motions[solid]?.bodies[about];
    if (!isNamed || !track || shown.size <= mostGhosts || world.bodies[about].shape.type === "sphere") return;
    const own = run.channels(track);
    const k = Math.min(sampleAt(world.times, player.time()).sample, own[0].length - 1);
    const size = reach(world.bodies[about].shape);
    const over = movers.filter((o) => {
      const other = world.motions[o].bodies[about];
      if (o === solid || !other || other.samples <= k) return false;
      const c = run.channels(other);
      return Math.hypot(c[0][k] - own[0][k], c[1][k] - own[1][k], c[2][k] - own[2][k]) < size && angleBetween(c, own, k) > 0.1;
    });
    if (over.length < mostGhosts) return;
    shown = new Set([solid, trusted]);
    apply();
  };
  // Times are rounded in the data: moments within a thousandth of a step are one.
  const alike = 1e-3 * world.dt;
  /** Opens the world just before the fault of the address: where its law breaks, or else where the oracles part. */
  const openAtFault = (): void => {
    if (isNamed && named !== trusted && query.get("solo") !== "1") jumpToDifference(trusted, [named], false);
    if (!isNamed) return;
    const chosen = query.has("t") ? Number(query.get("t")) : NaN;
    const variant = isOurs ? worldVariant(run.proof(asked)) : null;
    const broken = isOurs && fault ? fault.time : -1;
    const sizes = world.bodies.filter((b) => !b.fixed).map((b) => reach(b.shape)).filter((r) => r > 0);
    const parts = named !== trusted ? firstDifference(run, world, trusted, [named], 0.01 * (sizes.length ? Math.min(...sizes) : 1 / view.frame.scale)) : null;
    const [time, what] = broken >= 0 ? [broken, `the moment of the proof: ${oracles[named].name}, ${nounOf(run, asked)}`]
      : variant ? [variant.time, `${oracles[named].name} and its variant are farthest apart`]
        : parts ? [world.times[parts.sample], `${oracles[named].name} parts from ${oracles[trusted].name}`] : [-1, ""];
    if (time < 0) { if (Number.isFinite(chosen)) player.seek(chosen); return; }
    // The contacts of a step are drawn within it.
    const inStep = broken >= 0 ? fault?.inStep ?? null : null;
    const before = passage && broken >= 0 ? passage.from : inStep !== null ? Math.max(first, Math.min(end, inStep)) : world.times.filter((t) => t < time - alike).at(-1) ?? first;
    player.seek(before);
    const when = passage && broken >= 0 ? "before the bodies meet;" : inStep !== null ? "in the step of" : before < time ? "just before" : broken >= 0 ? "at" : "where";
    if (fault && isOurs) lookAt(fault, time);
    // A moment of the address is another one than that of the fault; the view is the same.
    if (Number.isFinite(chosen)) { player.seek(chosen); return; }
    const since = broken >= 0 ? f.first?.[asked] ?? -1 : -1;
    note.prepend(`Opened at ${seconds(before)}, ${when} ${what} (${seconds(time)}${since >= 0 && since < time - alike ? `, its worst; beyond its tolerance since ${seconds(since)}` : ""}). `);
  };
  /** Fits the camera to what a fault is about: its bodies before and after its moment, and the points that its proof cites. */
  const lookAt = (about: WorldFault, time: number): void => {
    const now = player.time();
    if (passage && about === fault) { seePassage(); return; }
    markNames = about.points.length ? ["point of the proof", "point of the proof"] : markNames;
    // The whole motion is seen unless that makes a speck of a body.
    const region = isWide(view, world, about.bodies) ? regionOf(run, view, world, about, [solid, ...movers.filter((o) => o !== solid)], [now, world.times.find((t) => t > time - alike) ?? end]) : null;
    view.setTime(now);
    if (about.points.length) view.mark(about.points.slice(0, 2), region?.radius);
    const from = region ? region.from : about.passes ? acrossMotion(run, view, world, about, solid) : null;
    if (from) stage.lookFrom(from);
    if (!region) { stage.fitAll(pointsAndExtent(about)); return; }
    followed = -1;
    follow.value = "-1";
    stage.fit(region.centre, region.radius);
    view.sizeImpulses(region.radius, region.centre);
    isClose = true;
  };
  /** Sees a passage from the side. The camera stays, so that what is passed through stays in sight. */
  const seePassage = (): void => {
    followed = -1;
    follow.value = "-1";
    stage.lookFrom(passage!.direction);
    stage.fitAll(passage!.balls);
    view.sizeImpulses(Math.max(...passage!.balls.map((b) => b.radius)) * 2);
  };
  /** All that moves, and the points that a proof cites unless they are far away. */
  const pointsAndExtent = (about: WorldFault | null): Ball[] => [...view.extent, ...(about?.points ?? []).map((p) => ({ at: toScene(view.frame, p), radius: 0.02 })).filter(({ at }) => at.length() < 3)];
  const note = h("p", { class: "reading", role: "status" });
  const ofVariant = (i: number): Child => {
    const variant = worldVariant(run.proof(i));
    return variant && [
      h("p", {}, "The error is the largest over all bodies and samples of distance + angle × radius, with the radius of the largest body."),
      button("Show both places", () => {
        player.stop();
        markNames = ["world", "variant"];
        const size = reach(world.bodies.find((b) => b.name === variant.body)?.shape ?? { type: "half_space" }) * view.frame.scale;
        // The marks are points in bodies, not bodies: small, so that the body stays in sight.
        view.mark([variant.own, variant.variant], size > 0 ? 2.5 * size : 1);
        player.seek(variant.time);
        const [own, other] = [view.marked(0)!, view.marked(1)!];
        const shape = world.bodies.find((b) => b.name === variant.body)?.shape;
        followed = -1;
        follow.value = "-1";
        stage.fit(own.clone().lerp(other, 0.5), Math.max(own.distanceTo(other), shape ? 2.5 * reach(shape) * view.frame.scale : 0, 0.05));
        fill(note, `${quoted(variant.body)} in the world itself, and in its variant mapped back, at ${seconds(variant.time)}.`);
        stage.invalidate();
      }, { class: "small" })];
  };

  const tabList = tabs([
    { key: "proof", name: "Proof", make: () => explained < 0 ? "No oracle was asked." : [
      h("h2", {}, engine(run, explained)),
      world.motions[explained]?.reason && h("p", {}, world.motions[explained].reason),
      world.motions[explained]?.diverged_at_step !== undefined && world.motions[explained].diverged_at_step! > 0 && h("p", {}, `Its motion diverged at step ${world.motions[explained].diverged_at_step}.`),
      faultsOf(run, q, explained, ofVariant, shownFinding)] },
    { key: "variants", name: "Variants", make: () => variantsPanel(run, q) },
    { key: "measures", name: "Measures", make: () => measuresTable(run, q, explained) },
    { key: "file", name: "File", make: () => h("pre", { tabindex: "0" }, question.toml) },
    { key: "reproduce", name: "Reproduce", make: () => [
      commands(question, oracles[explained]?.name ?? "", [
        ["All oracles with proofs:", "touchstone explain ID --all"],
        explained >= 0 && [`The motion of ${oracles[explained].name} as a table:`, "touchstone simulate ID --oracle ORACLE --csv motion.csv"],
        explained >= 0 && ["With the oracle's own settings:", "touchstone explain ID --against ORACLE --as-shipped"],
        explained >= 0 && !passes(explained) && ["The same fault in a world as small as can be:", "touchstone shrink ID --oracle ORACLE"]]),
      h("p", {}, h("a", { href: findingsAddress({ question: question.id, band: "all" }) }, "Every measurement of this question"))] },
  ], query.get("tab") ?? "proof", (key) => remember("tab", key));

  // At first, a body takes two seconds to pass through another one.
  player.speed = startingRate(passage ? 2 * (passage.until - passage.from) : end - first);
  const speed = h("select", { "aria-label": "Speed", on: { change: () => { player.speed = Number(speed.value); } } },
    rates.map(({ rate, name }) => h("option", { value: rate, selected: rate === player.speed }, `× ${name}`)));
  const follow = h("select", { "aria-label": "Camera follows", on: { change: () => { followed = Number(follow.value); player.seek(player.time()); } } },
    h("option", { value: -1 }, "camera stays"), world.bodies.map((b, i) => !b.fixed && h("option", { value: i }, `follow ${quoted(b.name)}`)));
  const toggle = (text: string, change: (on: boolean) => void): HTMLElement => h("label", {}, h("input", { type: "checkbox", checked: true, on: { change: (e: Event) => { change((e.target as HTMLInputElement).checked); stage.invalidate(); } } }), text);
  const savePlots = (): void => {
    const quantity = menu.find((item) => item.key === selects[0].value);
    if (!quantity) return;
    const data = plotData(run, world, quantity, movers.filter((o) => shown.has(o)), solid, false, false);
    downloadCsv(fileName(`${question.id}_${quantity.name}`, "csv"), [["time [s]", ...(data.truth ? ["truth"] : []), ...data.lines.map((l) => `${l.name} [${quantity.unit}]`)],
      ...data.times.map((t, i) => [t, ...(data.truth ? [data.truth.values[i] ?? ""] : []), ...data.lines.map((l) => l.values[i] ?? "")])]);
  };
  const axes: [string, [number, number, number]][] = [["x", [1, 0, 0]], ["y", [0, -1, 0]], ["z", [0, 0, 1]]];
  const see = (centre: three.Vector3, radius: number, follows = -1): void => {
    followed = follows;
    follow.value = String(follows);
    stage.fit(centre, radius);
    view.sizeImpulses(radius, centre);
  };
  const seeMoving = (): boolean => {
    const region = movingRegion(view, world, solid, fault?.bodies ?? []);
    if (region) see(region.centre, region.radius, region.follows);
    return region !== null;
  };
  // The fit goes round: all that moves over the whole motion, the bodies of the fault, and all that move now.
  let seen = 0;
  const fit = (): void => {
    const region = fault && !passage && fault.bodies.length > 0 ? regionOf(run, view, world, fault, [solid], [player.time()]) : null;
    const seeAll = (): boolean => {
      followed = -1;
      follow.value = "-1";
      stage.fitAll(pointsAndExtent(fault));
      view.sizeImpulses(1);
      return true;
    };
    const stops = [seeAll, ...(passage ? [() => { seePassage(); return true; }] : []), ...(region ? [() => { see(region.centre, region.radius); return true; }] : []), seeMoving];
    while (!stops[seen++ % stops.length]()) continue;
  };

  const head = questionHead(run, question, askedOfWorld(world));
  const element = h("section", { class: "question" },
    head.element,
      h("div", { class: "stage-column" },
        stage.element, legend,
        h("div", { class: "time-panel" },
          h("div", { class: "toolbar", role: "toolbar", "aria-label": "Time" }, playButton, button("◂", () => stepBy(-1), { title: "One sample back", "aria-label": "One sample back" }), button("▸", () => stepBy(1), { title: "One sample on", "aria-label": "One sample on" }), speed, clock,
            movers.length > 1 && button("First difference", () => jumpToDifference(solid, [...shown], true))),
          h("div", { class: "lane-row" }, h("span", { class: "lane-name" }, "time"), slider),
          lanes.element, note,
          world.thinned > 1 && h("p", { class: "quiet" }, `One in ${world.thinned} samples of the run is kept here, and those about the faults.`)),
        h("div", { class: "toolbar", role: "toolbar", "aria-label": "View" },
          axes.map(([name, d]) => button(name, () => stage.lookFrom(d), { title: `Look along ${name}` })), button("Fit", fit), follow,
          toggle("trails", (on) => view.showTrails(on)), toggle("impulses", (on) => view.showImpulses(on)),
          h("label", {}, namesShown, "names"),
          button("PNG", () => { void stage.picture().then((picture) => downloadPicture(fileName(question.id, "png"), picture)); }))),
      h("div", { class: "side-panel" },
        showAllRow,
        h("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Oracles" },
          h("table", { class: "plain verdicts" },
            h("caption", {}, "Tick: it is shown. Dot: it is solid, the others are ghosts."),
            h("thead", {}, h("tr", {}, h("th", { scope: "col" }, h("span", { class: "visually-hidden" }, "show")), h("th", { scope: "col" }, h("span", { class: "visually-hidden" }, "solid")), h("th", { scope: "col" }, "oracle"), h("th", { scope: "col" }, "worst"), h("th", { scope: "col", class: "number" }, "error"), h("th", { scope: "col" }, h("span", { class: "visually-hidden" }, "explain")))),
            list)),
        tabList.element,
        h("div", { class: "plots" },
          h("div", { class: "toolbar" }, h("label", { for: "log" }, log, "logarithmic"), world.curves.some((c) => c.truth) && h("label", { for: "to-truth" }, toTruth, "difference to the truth", whyNot), button("CSV", savePlots, { class: "small" }),
            h("span", { class: "quiet" }, "Dashed, without a colour: the truth; shaded: its tolerance. Drag to zoom, double-click to zoom out, click to go there.")),
          plots.map((plot, i) => [selects[i], plot.element]))));
  apply();
  if (isWide(view, world) && !(isNamed && fault)) seeMoving();
  head.tell(shownFinding);
  player.seek(Number(query.get("t")) || first);
  openAtFault();
  thinGhosts();
  isOpened = true;

  return {
    title: question.title, element,
    keys: [
      { keys: [" "], does: "play or stop", run: () => play() },
      { keys: ["ArrowLeft"], does: "one sample back", run: () => stepBy(-1) },
      { keys: ["ArrowRight"], does: "one sample on", run: () => stepBy(1) },
      { keys: ["1", "2", "3", "4", "5", "6", "7", "8", "9"], does: "one oracle alone", run: (key) => { const o = movers[Number(key) - 1]; if (o !== undefined) solo(o); } },
      { keys: ["0"], does: "all oracles", run: all },
      ...axes.map(([name, d]) => ({ keys: [name], does: `look along ${name}`, run: () => stage.lookFrom(d) })),
      { keys: ["f"], does: "fit: the whole motion, what the fault is about, and what moves", run: fit },
      { keys: ["b"], does: "show or hide the names of bodies", run: () => { namesShown.checked = !namesShown.checked; stage.invalidate(); } },
      { keys: ["d"], does: "first difference", run: () => jumpToDifference(solid, [...shown], true) },
      { keys: ["u"], does: "up to the group's findings", run: () => { location.hash = findingsAddress({ group: question.group }); } },
    ],
    dispose() { player.stop(); clearTimeout(waitingTime); for (const plot of plots) plot.dispose(); stage.dispose(); },
  };
}
