import { address, parseAddress, withValue } from "./address";
import { DataError, readReportData } from "./decode";
import { fill, h, toast } from "./dom";
import { listenToKeys, showKeys } from "./keys";
import { makeRun, type Run } from "./run";
import { hasLedger } from "./status";
import "./style.css";
import type { Key, MakeView, View } from "./view";
import { accuracyView } from "./views/accuracy";
import { clusterView } from "./views/cluster";
import { compareView } from "./views/compare";
import { findingsView } from "./views/findings";
import { frontView } from "./views/front";
import { ledgerView } from "./views/ledger";
import { matrixView } from "./views/matrix";
import { notFound } from "./views/not_found";
import { oraclesView } from "./views/oracles";
import { questionView } from "./views/question";
import { secondsView } from "./views/seconds";
import { sweepView } from "./views/sweep";

const screens: Record<string, MakeView> = {
  "": frontView, findings: findingsView, f: clusterView, matrix: matrixView, s: questionView, accuracy: accuracyView, oracles: oraclesView, ledger: ledgerView, seconds: secondsView, compare: compareView, sweep: sweepView,
};

/** After so long without a letter, the next one begins another search [ms]. */
const searchPause = 2500;

function start(run: Run, main: HTMLElement, bar: HTMLElement): void {
  let current: View | null = null;
  let name = "";

  let isSearching = false;
  let searchEnds = 0;
  const search = h("input", {
    type: "search", placeholder: "Search findings  ( / or Ctrl+F )", "aria-label": "Search ids, titles, reasons, proofs and causes",
    on: {
      input: () => {
        const here = parseAddress(location.hash);
        const inFindings = here.path[0] === "findings";
        const next = address(["findings"], withValue(inFindings ? here.query : new URLSearchParams(), "q", search.value));
        // One step of the history for a search, not one for each letter.
        if (isSearching && inFindings) history.replaceState(null, "", next);
        else history.pushState(null, "", next);
        isSearching = true;
        clearTimeout(searchEnds);
        searchEnds = window.setTimeout(() => { isSearching = false; }, searchPause);
        show();
      },
      blur: () => { isSearching = false; },
      keydown: (event: KeyboardEvent) => {
        if (event.key === "Escape") search.blur();
        // Text that is typed after this is another search.
        if (event.key === "Enter") isSearching = false;
      },
    },
  });
  const links = [...(run.report.sweep ? [["sweep", "Sweep"], ["", "Kept failures"]] : [["", "Overview"]]), ["findings", "Findings"], ["matrix", "Matrix"], ["accuracy", "Accuracy"], ["oracles", "Oracles"], ...(hasLedger(run) ? [["ledger", "Ledger"]] : []), ...(run.report.seconds ? [["seconds", "Seconds"]] : []), ...(run.report.compare ? [["compare", "Compare"]] : [])]
    .map(([path, text]) => ({ path, link: h("a", { href: address(path ? [path] : []) }, text) }));
  fill(bar, h("a", { href: "#/", class: "brand", title: `${run.report.program}: ${run.report.command}` }, h("span", { class: "brand-mark", "aria-hidden": "true" }, "◭"), " Touchstone"),
    h("nav", { "aria-label": "Screens" }, links.map((l) => l.link)), search,
    h("button", { type: "button", class: "small", "aria-label": "Keys", title: "Keys (?)", on: { click: () => showKeys(keys()) } }, "?"));

  // A sweep is about its millions of answers; the failures that were asked again are examples.
  if (run.report.sweep && location.hash === "") history.replaceState(null, "", address(["sweep"]));

  const show = (): void => {
    const at = parseAddress(location.hash);
    const screen = at.path[0] ?? "";
    const words = screen === "findings" ? at.query.get("q") ?? "" : "";
    if (document.activeElement !== search || !isSearching) search.value = words;
    for (const { path, link } of links) {
      if (path === screen) link.setAttribute("aria-current", "page");
      else link.removeAttribute("aria-current");
    }
    const key = at.path.join("/");
    if (current && key === name && current.update?.(at)) return;
    current?.dispose?.();
    name = key;
    try {
      current = (screens[screen] ?? (() => notFound("There is no such screen")))(run, at);
    } catch (error) {
      if (!(error instanceof DataError)) throw error;
      current = notFound(`This cannot be shown: ${error.message};`);
    }
    document.title = `${current.title} – Touchstone`;
    fill(main, current.element);
    // An address that the reader comes back to has its place; a new one starts at the top, and a screen reader with it.
    const place: unknown = (history.state as { place?: unknown } | null)?.place;
    if (typeof place === "number") requestAnimationFrame(() => scrollTo(0, place));
    else scrollTo(0, 0);
    if (document.body.dataset.ready && document.activeElement !== search) main.focus({ preventScroll: true });
  };
  // The browser's own search sees only the rows that exist, which are those on screen.
  addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey || event.shiftKey || event.key.toLowerCase() !== "f" || document.querySelector("dialog[open]")) return;
    if (document.activeElement === search || document.querySelector(".virtual") === null) return;
    event.preventDefault();
    search.focus();
    search.select();
    toast("This searches all findings of the report. Press Ctrl+F again to search what is on screen.", 6000);
  });
  let settled = 0;
  addEventListener("scroll", () => {
    clearTimeout(settled);
    settled = window.setTimeout(() => history.replaceState({ place: scrollY }, ""), 100);
  }, { passive: true });
  const pageKeys: Key[] = [
    { keys: ["/"], does: "search", run: () => search.focus() },
    { keys: ["?"], does: "this list of keys", run: () => showKeys(keys()) },
    { keys: ["h"], does: "what the run found", run: () => { location.hash = "#/"; } },
    { keys: ["m"], does: "matrix", run: () => { location.hash = "#/matrix"; } },
    { keys: ["a"], does: "accuracy", run: () => { location.hash = "#/accuracy"; } },
    ...(hasLedger(run) ? [{ keys: ["l"], does: "ledger", run: () => { location.hash = "#/ledger"; } }] : []),
  ];
  const keys = (): Key[] => [...(current?.keys ?? []), ...pageKeys];
  listenToKeys(keys);
  addEventListener("hashchange", () => {
    clearTimeout(settled);
    isSearching = false;
    show();
  });
  // Canvases and plots have the colours of the theme in them.
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { name = "\0"; show(); });
  document.querySelector<HTMLAnchorElement>(".skip")?.addEventListener("click", (event) => { event.preventDefault(); main.focus(); });
  show();
  document.body.dataset.ready = "true";
}

async function open(): Promise<void> {
  const main = document.getElementById("main")!;
  const holder = document.getElementById("report-data");
  try {
    const data = await readReportData(holder?.textContent ?? "");
    // The text is megabytes that nobody needs again.
    holder?.remove();
    start(makeRun(data), main, document.getElementById("bar")!);
  } catch (error) {
    const message = error instanceof DataError ? error.message : `the data of this page cannot be read (${error instanceof Error ? error.message : String(error)})`;
    fill(main, h("h1", {}, "No report"), h("p", { class: "conclusion failed" }, message));
    document.body.dataset.ready = "failed";
    if (!(error instanceof DataError)) throw error;
  }
}

void open();
