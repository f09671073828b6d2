// Makes a picture of every view of a report: npm run screenshots -- REPORT.html DIR
import { mkdir } from "node:fs/promises";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { go, openBrowser } from "./browser.mjs";

const [file, folder] = process.argv.slice(2);
if (!file || !folder) {
  console.error("usage: npm run screenshots -- REPORT.html DIR");
  process.exit(2);
}
await mkdir(folder, { recursive: true });
const browser = await openBrowser();
const sizes = { wide: { width: 1280, height: 800 }, phone: { width: 390, height: 800 } };
for (const colorScheme of ["light", "dark"]) {
  for (const [size, viewport] of Object.entries(sizes)) {
    const page = await browser.newPage({ viewport, colorScheme });
    page.on("console", (message) => { if (message.type() === "error") console.error(message.text()); });
    page.on("pageerror", (error) => console.error(error.stack));
    await page.goto(pathToFileURL(resolve(file)).href);
    await page.waitForSelector("body[data-ready]");
    const snap = async (name, hash, act) => {
      await go(page, hash);
      if (act) await act();
      await page.waitForTimeout(400);
      await page.screenshot({ path: join(folder, `${name}-${size}-${colorScheme}.png`) });
    };
    await snap("front", "#/");
    const firstFault = await page.getAttribute(".card .extent a", "href").catch(() => "#/f/0");
    await snap("fault", firstFault);
    await snap("findings", "#/findings");
    const rows = await page.$$eval(".c-question a", (links) => links.map((a) => a.getAttribute("href")));
    await snap("matrix", "#/matrix");
    await snap("accuracy", "#/accuracy");
    await snap("oracles", "#/oracles");
    await snap("oracle", "#/oracles/bullet");
    await snap("ledger", "#/ledger", () => page.click("details summary").catch(() => {}));
    await go(page, "#/findings?q=contact");
    const contact = await page.$$eval(".c-question a", (links) => links.map((a) => a.getAttribute("href")).find((l) => l.includes("contact%2F")));
    await snap("contact", process.env.CONTACT ?? contact ?? rows[0]);
    await snap("contact-proof", process.env.CONTACT ?? contact ?? rows[0], async () => { await page.keyboard.press("p"); await page.waitForTimeout(2600); });
    await go(page, "#/findings?q=world");
    const world = await page.$$eval(".c-question a", (links) => links.map((a) => a.getAttribute("href")).find((l) => l.includes("world%2F")));
    await snap("world", process.env.WORLD ?? world ?? rows[0], async () => { if (!process.env.WORLD) await page.keyboard.press("d"); });
    await page.screenshot({ path: join(folder, `world-whole-${size}-${colorScheme}.png`), fullPage: true });
    await page.close();
  }
}
await browser.close();
