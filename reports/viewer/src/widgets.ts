import { address } from "./address";
import { bands, bandTexts, type Band } from "./bands";
import { fill, h, toast, type Child } from "./dom";
import type { Oracle, Question } from "./data";
import { downloadText, fileName } from "./download";
import { marker } from "./engines";
import { marked } from "./matched";
import { numberOf } from "./format";
import type { Run } from "./run";

/** The documented model that a passed measurement follows, although it is beyond the tolerance of the truth; "" for any other. */
export function modelOf({ report: { findings: f, names }, band, text }: Run, finding: number): string {
  const value = numberOf(f.value[finding] ?? NaN);
  return bands[band[finding]] === "passed" && names.cause[f.cause[finding]] === "model" && !(value <= numberOf(f.tolerance[finding])) ? text(f.cause_because[finding]) || "another law than the one of the question" : "";
}

/** A band as a glyph and a word. */
export function badge(band: Band, text = bandTexts[band].name): HTMLElement {
  return h("span", { class: `badge ${band}`, title: bandTexts[band].meaning }, h("span", { "aria-hidden": "true" }, bandTexts[band].glyph), " ", text);
}

/** The band of a finding. A pass beyond the tolerance is one of a documented model, and says so. */
export function badgeOf(run: Run, finding: number): HTMLElement {
  const model = modelOf(run, finding);
  const whole = badge(bands[run.band[finding]], model === "" ? undefined : "follows its model");
  if (model !== "") whole.title = `Follows its documented model: ${model}`;
  return whole;
}

export const newBadge = (meaning: string): HTMLElement => h("span", { class: "new", title: meaning }, "new");

/** The tooltip of an oracle: its library, and the settings of its adapter. */
const descriptionOf = ({ name, library, version, settings }: Oracle): string => [`${name}: ${library} ${version}`, ...settings.map((s) => `${s.name}: ${s.value}`)].join("\n");

/** An engine as its marker and name, which links to its page.
 * @param words words that were searched for, which the name marks */
export function engine(run: Run, oracle: number, words = ""): HTMLElement {
  const info = run.report.oracles[oracle];
  return h("a", { class: "engine", title: descriptionOf(info), href: address(["oracles", info.name]) }, marker(run.looks[oracle]), h("span", { class: "name" }, info.name.split(/(?<=[/_])/).map((part, i) => [i > 0 && h("wbr"), marked(part, words)])));
}

/** The version of the library of an oracle; the library too where the oracle's name does not say it. */
export function versionOf({ report }: Run, oracle: number): HTMLElement {
  const { name, library, version } = report.oracles[oracle];
  return h("span", { class: "version" }, name.toLowerCase().startsWith(library.toLowerCase()) || version === "" ? version : `${library} ${version}`);
}

/** A link to the web if it is one, also as "owner/repository#number"; whatever else an upstream says is shown as text. */
export function upstreamLink(upstream: string): HTMLElement | null {
  if (upstream === "") return null;
  const issue = /^([\w.-]+\/[\w.-]+)#(\d+)$/.exec(upstream);
  const href = issue ? `https://github.com/${issue[1]}/issues/${issue[2]}` : upstream;
  if (!/^https?:\/\//.test(href)) return h("span", { class: "quiet" }, upstream === "unreported" ? "not reported upstream" : upstream);
  return h("a", { href, rel: "noreferrer noopener", target: "_blank" }, issue ? upstream : "reported upstream", " ↗");
}

/** A text as one word of a shell. Ids come from files. */
const shellWord = (text: string): string => (/^[\w./:@+-]+$/.test(text) && !text.startsWith("-") ? text : `'${text.replaceAll("'", "'\\''")}'`);

/** Commands about a question, with its id at "ID" and an oracle at "ORACLE", which run as they are when copied: a question that only its file asks
 * is named by that file, which can be saved here. */
export function commands(question: Question, oracle: string, list: ([what: string, text: string] | false)[]): Child {
  const file = fileName(question.id, "toml");
  const named: Record<string, string> = { ID: shellWord(question.own ? file : question.id), ORACLE: shellWord(oracle) };
  return [
    question.own && h("p", {}, "The program finds this question in its file only. ", button(`Save ${file}`, () => downloadText(file, question.toml), { class: "small" }), " The commands run in the folder of that file."),
    list.filter((item) => item !== false).map(([what, text]) => [what && h("p", {}, what), command(text.replace(/\b(ID|ORACLE)\b/g, (name) => named[name]))])];
}

/** A command with a button that copies it. */
function command(text: string): HTMLElement {
  return h("div", { class: "command" }, h("code", {}, text.split(" ").map((word, i) => [i > 0 && " ", h("span", { class: "word" }, word)])),
    h("button", { type: "button", class: "small", on: { click: () => { void copy(text); } } }, "Copy"));
}

async function copy(text: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
    toast("Copied");
  } catch {
    toast("This browser does not let a file copy; select the text instead");
  }
}

export const button = (text: Child, click: () => void, properties: Record<string, string | boolean> = {}): HTMLButtonElement =>
  h("button", { type: "button", ...properties, on: { click } }, text);

/** Tabs. The panel of the chosen one is made when it is first shown. */
export function tabs(list: { key: string; name: string; make(): Child }[], chosen: string, choose: (key: string) => void): { element: HTMLElement; select(key: string): void } {
  const panel = h("div", { class: "panel", role: "tabpanel", tabindex: "0", id: "tab-panel" });
  const buttons = list.map(({ key, name }) => h("button", {
    type: "button", role: "tab", id: `tab-${key}`, "aria-controls": "tab-panel",
    on: {
      click: () => { select(key); choose(key); },
      keydown: (event: KeyboardEvent) => {
        const step = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
        if (!step) return;
        event.preventDefault();
        event.stopPropagation();
        const next = list[(list.findIndex((t) => t.key === key) + step + list.length) % list.length];
        select(next.key);
        choose(next.key);
        document.getElementById(`tab-${next.key}`)?.focus();
      },
    },
  }, name));
  const select = (key: string): void => {
    const tab = list.find((t) => t.key === key) ?? list[0];
    buttons.forEach((b, i) => {
      const on = list[i] === tab;
      b.setAttribute("aria-selected", String(on));
      b.setAttribute("tabindex", on ? "0" : "-1");
    });
    panel.setAttribute("aria-labelledby", `tab-${tab.key}`);
    fill(panel, tab.make());
  };
  select(chosen);
  return { element: h("div", { class: "tabs" }, h("div", { role: "tablist" }, buttons), panel), select };
}
