import { address } from "./address";
import { bandTexts, type Band } from "./bands";
import { fill, h, toast, type Child } from "./dom";
import type { Oracle } from "./data";
import { marker } from "./engines";
import type { Run } from "./run";

/** A band as a glyph and a word. */
export function badge(band: Band, text = bandTexts[band].name): HTMLElement {
  return h("span", { class: `badge ${band}`, title: bandTexts[band].meaning }, h("span", { "aria-hidden": "true" }, bandTexts[band].glyph), " ", text);
}

/** The tooltip of an oracle: its library, and the settings of its adapter. */
const descriptionOf = ({ name, library, version, settings }: Oracle): string => [`${name}: ${library} ${version}`, ...settings.map((s) => `${s.name}: ${s.value}`)].join("\n");

/** An engine as its marker and name, which links to its page. */
export function engine(run: Run, oracle: number): HTMLElement {
  const info = run.report.oracles[oracle];
  return h("a", { class: "engine", title: descriptionOf(info), href: address(["oracles", info.name]) }, marker(run.looks[oracle]), h("span", { class: "name" }, info.name.split(/(?<=[/_])/).map((part, i) => [i > 0 && h("wbr"), part])));
}

/** A link to the web if it is one, also as "owner/repository#number"; whatever else an upstream says is shown as text. */
export function upstreamLink(upstream: string): HTMLElement | null {
  if (upstream === "") return null;
  const issue = /^([\w.-]+\/[\w.-]+)#(\d+)$/.exec(upstream);
  const href = issue ? `https://github.com/${issue[1]}/issues/${issue[2]}` : upstream;
  if (!/^https?:\/\//.test(href)) return h("span", { class: "quiet" }, upstream === "unreported" ? "not reported upstream" : upstream);
  return h("a", { href, rel: "noreferrer noopener", target: "_blank" }, issue ? upstream : "reported upstream", " ↗");
}

/** A command with a button that copies it. */
export function command(text: string): HTMLElement {
  return h("div", { class: "command" }, h("code", {}, text),
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
