import { h } from "./dom";
import type { Key } from "./view";

/** Whether a key press is meant for a field or a control, not for the page. */
function isTyping(event: KeyboardEvent): boolean {
  const target = event.target;
  if (!(target instanceof HTMLElement)) return false;
  if (target instanceof HTMLInputElement) return target.type !== "checkbox" && target.type !== "radio" ? true : event.key === " " || event.key.startsWith("Arrow");
  if (target instanceof HTMLSelectElement || target instanceof HTMLTextAreaElement || target.isContentEditable) return true;
  return event.key === " " && (target instanceof HTMLButtonElement || target.tagName === "SUMMARY");
}

const keyNames: Record<string, string> = { " ": "space", ArrowLeft: "←", ArrowRight: "→" };

/** Calls what the keys of the screen, or those of the page, do. */
export function listenToKeys(keys: () => Key[]): void {
  addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || isTyping(event) || document.querySelector("dialog[open]")) return;
    const key = keys().find((k) => k.keys.includes(event.key));
    if (!key) return;
    event.preventDefault();
    key.run(event.key);
  });
}

/** Shows the list of keys. */
export function showKeys(keys: Key[]): void {
  const close = (): void => { dialog.close(); dialog.remove(); };
  const dialog = h("dialog", { "aria-labelledby": "keys-title", on: { click: (e: MouseEvent) => { if (e.target === dialog) close(); }, cancel: close } },
    h("h2", { id: "keys-title" }, "Keys"),
    h("dl", { class: "keys" }, keys.map(({ keys: list, does }) => [
      h("dt", {}, list.length > 3 ? [h("kbd", {}, list[0]), " … ", h("kbd", {}, list[list.length - 1])] : list.map((k) => [h("kbd", {}, keyNames[k] ?? k), " "])), h("dd", {}, does)])),
    h("button", { type: "button", on: { click: close } }, "Close"));
  document.body.append(dialog);
  dialog.showModal();
}
