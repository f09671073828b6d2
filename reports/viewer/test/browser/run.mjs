// Opens the built page in a real browser and uses it as a reader would. Every check can fail; none depends on a clock, but for limits so wide
// that only a hang exceeds them.
import assert from "node:assert/strict";
import { readFile, rm, stat, writeFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { makeSample, hostile } from "../sample/make.mjs";
import { Blob, pack, fillPage } from "../sample/encode.mjs";
import { go, here, openBrowser, temporaryFolder, writePage } from "./browser.mjs";

const axe = await readFile(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const folder = temporaryFolder();
const sample = makeSample();
const url = await writePage(folder, "sample.html", sample);
const contactId = (pick) => sample.report.questions.find((q) => q.contact && pick(q.contact, q)).id;
const deep = contactId((c) => c.truth.touching === "touching" && c.truth.lo < -0.02 && c.A.shape.type === "box");
const apart = contactId((c) => c.truth.touching === "apart");
const shallow = contactId((c) => c.truth.touching === "touching" && c.truth.lo > -1e-5);
const views = {
  front: "#/", fault: "#/f/0", findings: "#/findings", matrix: "#/matrix", accuracy: "#/accuracy", engines: "#/oracles", engine: "#/oracles/bullet%2Fgjk", ledger: "#/ledger", compare: "#/compare",
  contact: `#/s/${encodeURIComponent(deep)}`, shallow: `#/s/${encodeURIComponent(shallow)}`, world: "#/s/world%2Fbounce%2Fball_002", cloth: "#/s/world%2Fbounce%2Fball_001", missing: "#/s/nothing",
};

const browser = await openBrowser();
let failures = 0;
const tests = [];
const test = (name, run) => tests.push({ name, run });

/** A page that fails the test on any error of the console, on any request, and on any attack that succeeds. */
async function withPage(options, run, address = url) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, reducedMotion: "no-preference", acceptDownloads: true, ...options });
  const page = await context.newPage();
  const troubles = [];
  page.on("console", (message) => { if (message.type() === "error") troubles.push(message.text()); });
  page.on("pageerror", (error) => troubles.push(error.stack ?? String(error)));
  page.on("request", (request) => { if (!/^(file|data|blob):/.test(request.url())) troubles.push(`request of ${request.url()}`); });
  page.on("dialog", (dialog) => { troubles.push("a dialog opened"); void dialog.dismiss(); });
  try {
    await page.goto(address);
    await page.waitForSelector("body[data-ready]");
    await run(page);
    assert.deepEqual(troubles, []);
    assert.equal(await page.evaluate(() => window.attacked), undefined, "a hostile text ran");
  } finally {
    await context.close();
  }
}

/** How many pixels of a part of the page differ from its most frequent colour. */
async function inkOf(page, selector) {
  const picture = (await page.locator(selector).first().screenshot()).toString("base64");
  return page.evaluate(async (base64) => {
    const image = new Image();
    image.src = `data:image/png;base64,${base64}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    const pixels = new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer);
    const counts = new Map();
    for (const p of pixels) counts.set(p, (counts.get(p) ?? 0) + 1);
    return pixels.length - Math.max(...counts.values());
  }, picture);
}

/** Waits until a picture is another than before; fails if it stays the same for long. */
async function changes(before, shot, message) {
  for (let i = 0; i < 40; ++i) {
    if (!before.equals(await shot())) return;
    await new Promise((done) => setTimeout(done, 100));
  }
  assert.fail(message);
}

const nodes = (page) => page.evaluate(() => document.querySelectorAll("*").length);

test("every view draws more than its ground, in light and dark, wide and on a phone", async () => {
  for (const [colorScheme, viewport] of [["light", { width: 1280, height: 800 }], ["dark", { width: 390, height: 800 }]]) {
    await withPage({ colorScheme, viewport }, async (page) => {
      for (const [name, hash] of Object.entries(views)) {
        await go(page, hash);
        assert.ok(await inkOf(page, "main") > 1500, `${name} is empty in ${colorScheme}`);
        const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        assert.ok(wide <= 0, `${name} is ${wide} px wider than a window of ${viewport.width} px`);
        assert.ok(await nodes(page) <= 5000, `${name} has over 5,000 nodes`);
      }
    });
  }
});

test("the three-dimensional views show bodies, with WebGL and without", async () => {
  for (const flat of [false, true]) {
    await withPage({}, async (page) => {
      for (const name of ["contact", "shallow", "world", "cloth"]) {
        await go(page, views[name]);
        assert.equal(await page.locator(".stage-note").count(), flat ? 1 : 0);
        await page.$$eval(".stage .labels, .scale-bar, .close-up, .stage-note", (parts) => parts.forEach((part) => part.style.setProperty("visibility", "hidden")));
        assert.ok(await inkOf(page, ".stage canvas") > 4000, `${name} shows no bodies${flat ? " without WebGL" : ""}`);
      }
    }, flat ? `${url}?flat` : url);
  }
});

test("small pictures are drawn", () => withPage({}, async (page) => {
  for (let i = 0; i < 40 && await inkOf(page, ".thumbnail") <= 300; ++i) await page.waitForTimeout(100);
  assert.ok(await inkOf(page, ".thumbnail") > 300);
}));

test("filters, their address and the back button agree", () => withPage({}, async (page) => {
  await go(page, "#/findings");
  const count = () => page.textContent(".count");
  const all = await count();
  await page.click(".chip.grave");
  await page.waitForFunction(() => location.hash === "#/findings?band=grave");
  const grave = await count();
  assert.notEqual(grave, all);
  assert.equal(await page.getAttribute(".chip.grave", "aria-current"), "true");
  assert.equal(await page.locator(".virtual .badge:not(.grave)").count(), 0);
  await page.selectOption("select[aria-label='Filter by oracle']", "bullet");
  await page.waitForFunction(() => location.hash.includes("oracle=bullet"));
  const engines = await page.$$eval(".c-engine", (cells) => cells.map((c) => c.textContent));
  assert.ok(engines.length > 0 && engines.every((e) => e === "bullet"));
  await page.goBack();
  assert.equal(await count(), grave);
  await page.goBack();
  assert.equal(await count(), all);
  await page.goForward();
  assert.equal(await count(), grave);
  await page.reload();
  await page.waitForSelector("body[data-ready]");
  assert.equal(await count(), grave);
}));

test("search finds words, keeps the focus, and is in the address", () => withPage({}, async (page) => {
  await page.keyboard.press("/");
  await page.keyboard.type("EPA");
  await page.waitForFunction(() => location.hash === "#/findings?q=EPA");
  assert.equal(await page.evaluate(() => document.activeElement.type), "search");
  const found = Number((await page.textContent(".count")).match(/[\d,]+/)[0].replace(",", ""));
  assert.ok(found > 0);
  await page.keyboard.type("xyzzy");
  assert.match(await page.textContent(".count"), /^0 findings/);
}));

test("coming back to a list finds the place where it was left", () => withPage({}, async (page) => {
  await go(page, "#/findings");
  await page.evaluate(() => scrollTo(0, 3000));
  await page.waitForTimeout(300);
  await page.locator(".virtual .c-question a").nth(9).click();
  await page.waitForSelector(".stage");
  assert.equal(await page.evaluate(() => scrollY), 0);
  await page.goBack();
  await page.waitForFunction(() => scrollY > 2500);
  assert.ok(await page.locator(".virtual [role=row]").count() > 5);
}));

test("columns sort", () => withPage({}, async (page) => {
  await go(page, "#/findings");
  await page.click(".head a:has-text('Oracle')");
  const names = await page.$$eval(".c-engine", (cells) => cells.map((c) => c.textContent));
  assert.deepEqual(names, [...names].sort());
  assert.equal(await page.locator("[aria-sort=ascending]").count(), 1);
}));

test("a count of the matrix opens as many findings of that group and engine", () => withPage({}, async (page) => {
  await go(page, "#/matrix");
  await page.click(".cell.grave a");
  await page.waitForFunction(() => location.hash.startsWith("#/findings?"));
  assert.doesNotMatch(await page.textContent(".count"), /^0 /);
}));

test("keys move through the findings and open one", () => withPage({}, async (page) => {
  await go(page, "#/findings");
  await page.keyboard.press("j");
  await page.keyboard.press("j");
  assert.equal(await page.evaluate(() => document.activeElement.closest("[data-index]").dataset.index), "1");
  await page.keyboard.press("o");
  await page.waitForFunction(() => location.hash.startsWith("#/s/"));
  await page.keyboard.press("?");
  assert.ok(await page.isVisible("dialog[open] kbd"));
  await page.keyboard.press("Escape");
  await page.keyboard.press("u");
  await page.waitForFunction(() => location.hash.startsWith("#/findings?group="));
}));

test("the proof ends in a gap, and a claimed direction takes longer", () => withPage({}, async (page) => {
  await go(page, views.contact);
  await page.locator(`tr:has-text("bullet") input[type=radio]`).first().check();
  const gap = () => page.$eval(".stage", (stage) => Number(stage.dataset.gap));
  const before = await page.locator(".stage canvas").screenshot();
  assert.ok(await gap() < 0, "the bodies overlap at first");
  await page.click("text=Play the proof");
  await page.waitForSelector("text=Play again");
  assert.ok(await gap() > 0, "no gap has opened");
  await changes(before, () => page.locator(".stage canvas").screenshot(), "nothing has moved");
  assert.match(await page.textContent(".reading"), /B moved .*a gap of .*; along the direction of bullet/);
}));

test("the proof of a reader who wants less motion is there at once, and that of bodies apart is a plane between them", async () => {
  await withPage({ reducedMotion: "reduce" }, async (page) => {
    await go(page, views.contact);
    await page.click("text=Play the proof");
    assert.ok(await page.$eval(".stage", (stage) => Number(stage.dataset.gap)) > 0);
    await go(page, `#/s/${encodeURIComponent(apart)}`);
    assert.match(await page.textContent(".reading"), /gap of 10 cm/);
  });
});

test("a shallow contact has a close-up in which the depth is seen", () => withPage({}, async (page) => {
  await go(page, views.shallow);
  assert.ok(await inkOf(page, ".close-up canvas") > 5000);
  await go(page, views.contact);
  assert.equal(await page.locator(".close-up").count(), 0);
}));

test("an engine's contacts are switched on and off", () => withPage({}, async (page) => {
  await go(page, views.contact);
  const shot = () => page.locator(".stage canvas").screenshot();
  const before = await shot();
  await page.keyboard.press("0");
  await changes(before, shot, "no contact appeared");
}));

test("an oracle that crashed is said to have crashed", () => withPage({}, async (page) => {
  const crashed = sample.report.questions.find((q) => q.contact?.answers.some((a) => a.status === "crashed"));
  const name = sample.report.oracles[crashed.contact.answers.findIndex((a) => a.status === "crashed")].name;
  await go(page, `#/s/${encodeURIComponent(crashed.id)}?o=${encodeURIComponent(name)}`);
  const row = await page.textContent(".verdicts tr.chosen");
  assert.match(row, /unusable.*it crashed.*crashed/s);
  assert.match(await page.textContent("#tab-panel"), /crashed on this question/);
  await go(page, "#/findings?band=crash");
  assert.match(await page.textContent(".count"), /^1 finding/);
  assert.equal(await page.textContent(".virtual .c-value"), "crashed");
}));

test("the normal of a variant is drawn and performed, and a common point is marked", () => withPage({}, async (page) => {
  const proofs = sample.report.findings.proof.map((t) => sample.report.texts[t] ?? "");
  const questionWith = (words) => sample.report.questions[sample.report.findings.question[proofs.findIndex((p, i) => p.includes(words) && sample.report.questions[sample.report.findings.question[i]].contact.truth.touching === "touching")]].id;
  const labels = () => page.$$eval(".stage .label:not([hidden])", (all) => all.map((l) => l.textContent));
  await go(page, `#/s/${encodeURIComponent(questionWith("for its variant"))}?o=bullet`);
  assert.ok((await labels()).includes("n of the variant"));
  assert.match(await page.textContent("#tab-panel"), /the larger of two changes/);
  await page.click("text=Play the proof");
  await page.waitForSelector("text=Play again");
  assert.match(await page.textContent(".reading"), /that of its variant “swap”/);
  await go(page, `#/s/${encodeURIComponent(questionWith("inside both"))}?o=bullet`);
  assert.ok((await labels()).includes("common point"));
  assert.ok(!(await labels()).includes("n of the variant"));
  assert.ok(await page.locator(".marks li").count() >= 6);
}));

test("an address that names an oracle shows it solid where it parts, and the camera follows", () => withPage({}, async (page) => {
  await go(page, `${views.world}?o=ode`);
  assert.ok(await page.isChecked("input[aria-label='Draw ode solid']"));
  assert.match(await page.textContent(".time-panel .reading"), /ode parts from cookbook .* at \d/);
  assert.ok(await page.$eval(".stage", (stage) => Number(stage.dataset.time)) > 0);
  assert.notEqual(await page.inputValue("select[aria-label='Camera follows']"), "-1");
  await go(page, `${views.world}?o=ode&t=1.5`);
  assert.equal(await page.$eval(".stage", (stage) => Number(stage.dataset.time)), 1.5);
}));

test("the variants of a world are plotted side by side", () => withPage({}, async (page) => {
  const { findings: f, names, questions } = sample.report;
  const world = questions[f.question[f.measure.findIndex((m, i) => names.measure[m].name === "stability" && f.verdict[i] === 0)]].id;
  await go(page, `#/s/${encodeURIComponent(world)}?tab=variants`);
  assert.match(await page.textContent("#tab-panel"), /start moved by a rounding/);
  assert.ok(await page.locator(".variant-strip circle, .variant-strip polygon").count() >= 2);
  const studied = questions[f.question[f.cause_because.findIndex((t) => /a half and a quarter/.test(sample.report.texts[t]))]].id;
  await go(page, `#/s/${encodeURIComponent(studied)}?tab=variants`);
  assert.ok(await page.locator(".study polyline").count() >= 1);
}));

test("the overview says who was never proved wrong, and how many faults each oracle has", () => withPage({}, async (page) => {
  const { oracles, clusters } = sample.report;
  const wrong = new Set(clusters.flatMap((c) => c.oracles));
  const right = await page.$$eval("p.engines:has-text('Never proved wrong') .engine", (all) => all.map((e) => e.textContent));
  assert.ok(right.length > 0 && right.every((name) => !wrong.has(oracles.findIndex((o) => o.name === name))));
  const bullet = oracles.findIndex((o) => o.name === "bullet");
  assert.equal(await page.textContent("table:has(th:text-is('Grave')) tr:has(.engine .name:text-is('bullet')) td:last-child"), String(clusters.filter((c) => c.oracles.includes(bullet)).length));
}));

test("entries of the ledger with one fault are one line, which opens to their reasons", () => withPage({}, async (page) => {
  await go(page, "#/ledger?q=two+entries");
  assert.equal(await page.locator(".ledger details").count(), 1);
  await page.click(".ledger summary");
  assert.equal(await page.locator(".ledger .entry").count(), 2);
  assert.match(await page.textContent(".ledger .entries"), /The edge test of case 1/);
}));

test("faults are put in the order that the reader chooses", () => withPage({}, async (page) => {
  const counts = () => page.$$eval(".card .extent", (all) => all.map((p) => Number(/in (\d+) scenario/.exec(p.textContent)[1])));
  await page.selectOption("select[aria-label='Order of the faults']", "questions");
  await page.waitForFunction(() => location.hash === "#/?sort=questions");
  await page.waitForTimeout(100);
  assert.deepEqual(await counts(), (await counts()).sort((a, b) => b - a));
  assert.ok(await page.locator(".card .proof-line").count() > 3);
}));

test("what is no longer judged is a kind of change", () => withPage({}, async (page) => {
  await go(page, "#/compare");
  await page.click(".chip:has-text('no longer judged')");
  await page.waitForFunction(() => location.hash.includes("kind="));
  assert.deepEqual(await page.$$eval(".virtual .badge", (all) => [...new Set(all.map((b) => b.textContent.trim()))]), ["? no longer judged"]);
}));

test("accuracy is put in the order that the reader chooses", () => withPage({}, async (page) => {
  await go(page, "#/accuracy?sort=name");
  const names = await page.$$eval(".accuracy tbody th", (cells) => cells.map((c) => c.textContent));
  assert.ok(names.length > 3);
  assert.deepEqual(names, [...names].sort());
  assert.match(await page.textContent(".marks"), /median.*90 %.*worst/);
}));

test("on a phone every screen is reached, and tables of answers keep within the window", () => withPage({ viewport: { width: 390, height: 800 } }, async (page) => {
  for (const name of ["Overview", "Findings", "Matrix", "Accuracy", "Oracles", "Ledger"]) {
    const box = await page.locator(`#bar nav a:text-is("${name}")`).boundingBox();
    assert.ok(box.x >= 0 && box.x + box.width <= 390, `${name} is off the screen`);
  }
  for (const hash of [views.contact, views.world]) {
    await go(page, hash);
    const over = await page.$eval(".side-panel > .scroll", (box) => box.scrollWidth - box.clientWidth);
    assert.ok(over <= 0, `the table of ${hash} is ${over} px too wide`);
  }
}));

test("names of oracles are whole in the tables of answers, and so are the tables", () => withPage({}, async (page) => {
  for (const hash of [views.contact, views.world]) {
    await go(page, hash);
    assert.deepEqual(await page.$$eval(".verdicts .engine", (all) => all.filter((e) => e.scrollWidth > e.clientWidth + 1).map((e) => e.textContent)), []);
    assert.ok(await page.$eval(".side-panel > .scroll", (box) => box.scrollHeight <= box.clientHeight + 1));
  }
}));

test("the slider moves the bodies, and the plots' cursor with them", () => withPage({}, async (page) => {
  await go(page, views.world);
  await page.waitForSelector(".u-over");
  const shot = (selector) => page.locator(selector).first().screenshot();
  const [bodies, plot] = [await shot(".stage canvas"), await shot(".plot canvas")];
  await page.$eval("input[aria-label=Time]", (slider) => { slider.value = "60"; slider.dispatchEvent(new Event("input")); });
  assert.ok(Math.abs(await page.$eval(".stage", (stage) => Number(stage.dataset.time)) - 1.2) < 1e-9);
  await changes(bodies, () => shot(".stage canvas"), "no body moved");
  await changes(plot, () => shot(".plot canvas"), "the cursor of the plot stayed");
  await page.keyboard.press("ArrowRight");
  assert.ok(Math.abs(await page.$eval(".stage", (stage) => Number(stage.dataset.time)) - 1.22) < 1e-9);
}));

test("playback runs and stops, one engine is shown alone, and the first difference is found", () => withPage({}, async (page) => {
  await go(page, views.world);
  await page.click("text=Play");
  await page.waitForFunction(() => Number(document.querySelector(".stage").dataset.time) > 0);
  await page.keyboard.press("u");
  await go(page, views.world);
  await page.click("text=First difference");
  assert.match(await page.textContent(".time-panel .reading"), /parts from cookbook .* at \d/);
  assert.ok(await page.$eval(".stage", (stage) => Number(stage.dataset.time)) > 0);
  await page.keyboard.press("1");
  await page.waitForTimeout(150);
  assert.equal(await page.locator(".verdicts input[type=checkbox]:checked").count(), 1);
}));

test("a crowd of bodies by all engines is drawn in a few calls", () => withPage({}, async (page) => {
  const { world, id } = sample.report.questions.find((q) => q.world?.bodies.length > 20);
  await go(page, `#/s/${encodeURIComponent(id)}`);
  const drawn = world.bodies.filter((b) => !b.fixed).length * world.motions.filter((m) => m.bodies.length).length;
  assert.ok(drawn > 150);
  const calls = await page.$eval(".stage", (stage) => Number(stage.dataset.calls));
  assert.ok(calls > 5 && calls < drawn / 4, `${calls} calls for ${drawn} bodies`);
}));

test("one WebGL context lives at a time", () => withPage({}, async (page) => {
  for (let i = 0; i < 20; ++i) {
    await page.evaluate((h) => { location.hash = h; }, i % 2 ? views.contact : views.world);
    await page.waitForTimeout(60);
  }
  assert.equal(await page.locator(".stage-note").count(), 0);
  assert.equal(await page.locator("canvas").evaluateAll((all) => all.filter((c) => c.getContext("webgl2")).length), 1);
}));

test("the overview says that the run passes, and how many faults are known", () => withPage({}, async (page) => {
  const known = sample.report.clusters.filter((c) => !c.is_new);
  const engines = new Set(known.flatMap((c) => c.oracles.map((o) => sample.report.oracles[o].library)));
  assert.match(await page.textContent(".conclusion .passes"), /^✓ The run passes/);
  assert.ok((await page.textContent(".conclusion .faulty")).startsWith(`${known.length} faults of ${engines.size} engines are proved and known`));
}));

test("overview, matrix and findings count the same things in the same words", () => withPage({}, async (page) => {
  const texts = [];
  for (const hash of ["#/", "#/matrix", "#/findings"]) { await go(page, hash); texts.push(await page.textContent(".counts")); }
  assert.equal(texts[0], texts[1]);
  assert.equal(texts[0], texts[2]);
  const shown = Number((await page.textContent(".count")).match(/[\d,]+/)[0].replace(",", ""));
  assert.equal(Number((await page.textContent(".counts div:last-child dt")).match(/[\d,]+/)[0].replace(",", "")), shown);
}));

test("a world opened from a finding is just before its fault, and says so", () => withPage({}, async (page) => {
  const { findings: f, questions, oracles } = sample.report;
  const finding = f.time.findIndex((t, i) => t > 0 && f.verdict[i] === 3);
  const question = questions[f.question[finding]];
  await go(page, `#/findings?question=${encodeURIComponent(question.id)}&oracle=${oracles[f.oracle[finding]].name}&sort=share`);
  const links = await page.$$eval(".virtual a.title", (all) => all.map((a) => a.getAttribute("href")));
  await go(page, links.find((l) => l.endsWith(`f=${finding}`)));
  const time = await page.$eval(".stage", (stage) => Number(stage.dataset.time));
  assert.equal(time, question.world.times.filter((t) => t < f.time[finding]).at(-1));
  assert.match(await page.textContent(".time-panel .reading"), /^Opened at .* just before .* is wrong in /);
}));

test("what is cut in the list of findings has an ellipsis and says all in a tooltip", async () => {
  for (const width of [1280, 1000]) await withPage({ viewport: { width, height: 800 } }, async (page) => {
    await go(page, "#/findings");
    const bad = await page.$$eval(".virtual .finding *", (all) => all.filter((e) => e.scrollWidth > e.clientWidth + 1 && getComputedStyle(e).overflowX === "hidden")
      .filter((e) => getComputedStyle(e).textOverflow !== "ellipsis" || !e.closest("[title]")).map((e) => `${e.className}: ${e.textContent}`));
    assert.deepEqual(bad, []);
  });
});

test("a fault has a legend, and no reason that repeats its heading", () => withPage({}, async (page) => {
  for (let c = 0; c < 8; ++c) {
    await go(page, `#/f/${c}`);
    assert.equal(await page.locator("section.cluster .marks").count(), 1);
    const [title, why] = await page.evaluate(() => [document.querySelector("h1").textContent, [...document.querySelectorAll("h2")].find((e) => e.textContent === "Why")?.nextElementSibling.textContent]);
    assert.ok(!why?.startsWith(title));
  }
}));

test("all oracles are offered only while one is hidden", () => withPage({}, async (page) => {
  await go(page, views.world);
  assert.equal(await page.isVisible("button:text-is('Show all')"), false);
  await page.locator(".verdicts input[type=checkbox]:checked").first().click();
  await page.waitForSelector("button:text-is('Show all')");
  await page.click("button:text-is('Show all')");
  assert.equal(await page.isVisible("button:text-is('Show all')"), false);
}));

test("texts that attack are shown as texts", () => withPage({}, async (page) => {
  for (const hash of Object.values(views)) await go(page, hash);
  await go(page, "#/findings?q=attacked&band=all");
  assert.ok((await page.textContent("main")).includes(hostile[0]));
  assert.equal(await page.locator("main img, main script, main iframe").count(), 0);
  await go(page, "#/ledger");
  assert.equal(await page.locator("a[href^='javascript']").count(), 0);
  await go(page, `#/s/${encodeURIComponent("<img src=x onerror=attacked=1>")}`);
  assert.match(await page.textContent("main"), /Not found.*<img src=x/);
}));

test("axe finds no fault in any view, light and dark", async () => {
  for (const colorScheme of ["light", "dark"]) {
    await withPage({ colorScheme, bypassCSP: true }, async (page) => {
      for (const [name, hash] of Object.entries(views)) {
        await go(page, hash);
        if (name === "ledger") await page.click("details summary");
        await page.evaluate(axe);
        const { violations } = await page.evaluate(() => window.axe.run(document, { resultTypes: ["violations"] }));
        assert.deepEqual(violations.map((v) => `${name} in ${colorScheme}: ${v.id}: ${v.nodes.slice(0, 3).map((n) => `${n.html.slice(0, 160)} ${n.any[0]?.message ?? ""}`).join(" | ")}`), []);
      }
    });
  }
});

test("pictures and tables are saved", () => withPage({}, async (page) => {
  const save = async (text) => {
    const [download] = await Promise.all([page.waitForEvent("download"), page.locator(`button:has-text("${text}"):visible`).first().click()]);
    return readFile(await download.path());
  };
  await go(page, views.contact);
  const picture = await save("PNG");
  assert.equal(picture.subarray(1, 4).toString(), "PNG");
  assert.ok(picture.length > 5000);
  await go(page, "#/findings?q=attacked&band=all");
  const table = (await save("CSV")).toString();
  assert.match(table, /^band,verdict,question/);
  assert.doesNotMatch(table, /(^|,)=cmd/m);
}));

test("a print has the rows and not the controls", () => withPage({}, async (page) => {
  await go(page, "#/findings");
  await page.emulateMedia({ media: "print" });
  assert.equal(await page.isVisible("#bar"), false);
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  assert.equal(await page.locator(".virtual [role=row]").count(), 200);
}));

test("a page without data, or of a newer version, says so", async () => {
  const empty = join(folder, "newer.html");
  await writeFile(empty, fillPage(await readFile(here("../../dist/viewer.html"), "utf8"), pack({}, new Blob(), 7)));
  await withPage({}, async (page) => assert.match(await page.textContent("main"), /version 1; these have version 7/), pathToFileURL(empty).href);
  await withPage({}, async (page) => assert.match(await page.textContent("main"), /holds no report/), pathToFileURL(here("../../dist/viewer.html")).href);
});

test("10,000 findings and 200 worlds stay small and quick", async () => {
  const large = makeSample({ contacts: 500, worlds: 200, findings: 10500 });
  assert.ok(large.report.findings.question.length >= 7000 && large.report.questions.length === 700);
  const many = { report: { ...large.report, findings: Object.fromEntries(Object.entries(large.report.findings).map(([key, column]) => [key, [...column, ...column]])) }, blob: large.blob };
  assert.ok(many.report.findings.question.length >= 10000);
  const address = await writePage(folder, "large.html", many);
  assert.ok((await stat(fileURLToPath(address))).size < 5e6, "the page is over 5 MB");
  await withPage({}, async (page) => {
    const counts = {};
    for (const [name, hash] of Object.entries(views)) {
      await go(page, hash);
      counts[name] = await nodes(page);
      assert.ok(counts[name] <= 5000, `${name} has ${counts[name]} nodes`);
    }
    await go(page, "#/findings?q=warm");
    const times = await page.evaluate(async () => {
      const result = [];
      for (const query of ["q=EPA", "q=bullet+known", "band=grave", "oracle=ode&band=all", "q=shallower+edge&group=world%2Fbounce"]) {
        const start = performance.now();
        location.hash = `#/findings?${query}`;
        await new Promise((done) => addEventListener("hashchange", done, { once: true }));
        result.push(Math.round(performance.now() - start));
      }
      return result;
    });
    console.log(`     nodes at most ${Math.max(...Object.values(counts))}; filters ${times.join(", ")} ms`);
    assert.ok(Math.max(...times) < 3000, `a filter took ${Math.max(...times)} ms`);
  }, address);
});

test("the built page is one file that asks for nothing, with one place for its data", async () => {
  const page = await readFile(here("../../dist/viewer.html"), "utf8");
  assert.equal(page.split('<script type="application/octet-stream" id="report-data"></script>').length, 2);
  assert.match(page, /Content-Security-Policy" content="default-src 'none'; script-src 'sha256-[^']+'; style-src 'sha256-[^']+'; img-src data: blob:; base-uri 'none'; form-action 'none'"/);
  assert.doesNotMatch(page, /<(?:script|link|img)[^>]+(?:src|href)="(?!#)/);
  assert.ok(page.length < 1.2e6);
});

const only = process.argv[2];
const waiting = tests.filter(({ name }) => !only || name.includes(only));
const count = waiting.length;
async function work() {
  for (let next = waiting.shift(); next; next = waiting.shift()) {
    const start = Date.now();
    try {
      await next.run();
      console.log(`ok   ${next.name} (${Date.now() - start} ms)`);
    } catch (error) {
      ++failures;
      console.log(`FAIL ${next.name}\n${error.stack ?? error}`);
    }
  }
}
await Promise.all([work(), work()]);
await browser.close();
await rm(folder, { recursive: true, force: true });
console.log(failures ? `${failures} of ${count} failed` : `all ${count} passed`);
process.exit(failures ? 1 : 0);
