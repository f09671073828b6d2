import { readFile, writeFile } from "node:fs/promises";
import { mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { chromium } from "playwright-core";
import { fillPage, pack } from "../sample/encode.mjs";

export const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const flags = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];

/** A browser with a fresh profile. */
export const openBrowser = () => chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: flags });

export const temporaryFolder = () => mkdtempSync(join(tmpdir(), "touchstone-viewer-"));

/** Writes the built page with the data of a report into a folder; returns its address. */
export async function writePage(folder, name, { report, blob }) {
  const page = await readFile(here("../../dist/viewer.html"), "utf8");
  const path = join(folder, name);
  await writeFile(path, fillPage(page, pack(report, blob)));
  return pathToFileURL(path).href;
}

/** Waits until a page has drawn what it was asked to draw before. */
export const redrawn = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

/** Goes to an address of an open page, and waits until it is drawn. */
export async function go(page, hash) {
  await page.evaluate((h) => { location.hash = h; }, hash);
  await page.waitForTimeout(120);
  await redrawn(page);
}

/** Makes every act of a user on a page end when the page has drawn its answer: on a busy machine, what is read at once is the picture before. */
export function drawAfterActs(page) {
  const acts = [[page, ["check", "click", "fill", "goBack", "goForward", "selectOption", "uncheck"]], [page.keyboard, ["press", "type"]], [page.mouse, ["click", "move", "up", "wheel"]]];
  for (const [owner, names] of acts) {
    for (const name of names) {
      const act = owner[name].bind(owner);
      owner[name] = async (...given) => { await act(...given); await redrawn(page); };
    }
  }
}
