/** A value that becomes a child of an element. Strings become text nodes, never markup. */
export type Child = Node | string | number | false | null | undefined | Child[];

type Listener = (event: never) => void;
export interface Properties {
  class?: string;
  /** Event listeners by name: `{ click: () => … }`. */
  on?: Record<string, Listener>;
  style?: Record<string, string>;
  [attribute: string]: string | number | boolean | undefined | Record<string, Listener> | Record<string, string>;
}

function append(parent: Element, child: Child): void {
  if (child === false || child === null || child === undefined) return;
  if (Array.isArray(child)) child.forEach((c) => append(parent, c));
  else parent.append(typeof child === "number" ? String(child) : child);
}

function setProperties(element: HTMLElement | SVGElement, properties: Properties): void {
  for (const [name, value] of Object.entries(properties)) {
    if (value === undefined || value === false) continue;
    if (name === "on") {
      for (const [event, listener] of Object.entries(value as Record<string, Listener>)) {
        element.addEventListener(event, listener as EventListener);
      }
    } else if (name === "style") {
      // Through the object model: an inline style attribute would need a laxer policy.
      for (const [key, text] of Object.entries(value as Record<string, string>)) element.style.setProperty(key, text);
    } else {
      element.setAttribute(name, value === true ? "" : String(value));
    }
  }
}

/** Makes an element: `h("a", { href: "#/" }, "Findings")`. */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K, properties: Properties = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  setProperties(element, properties);
  append(element, children);
  return element;
}

/** Makes an SVG element. */
export function svg(tag: string, properties: Properties = {}, ...children: Child[]): SVGElement {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  setProperties(element, properties);
  append(element, children);
  return element;
}

/** Replaces the children of an element. */
export function fill(element: Element, ...children: Child[]): void {
  element.replaceChildren();
  append(element, children);
}

/** Shows a passing message, also to screen readers. */
export function toast(message: string, shownFor = 2500): void {
  const place = document.getElementById("toast");
  if (!place) return;
  place.textContent = message;
  window.setTimeout(() => { if (place.textContent === message) place.textContent = ""; }, shownFor);
}

/** Whether the reader asked the system for less motion. */
export const prefersReducedMotion = (): boolean => matchMedia("(prefers-reduced-motion: reduce)").matches;
