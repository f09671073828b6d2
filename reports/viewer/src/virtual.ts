import { h } from "./dom";

export interface VirtualList {
  element: HTMLElement;
  setCount(count: number): void;
  /** Draws the rows again. */
  refresh(): void;
  /** Scrolls a row into sight and focuses its first link. */
  reveal(index: number): void;
  dispose(): void;
}

const rowsInPrint = 200;

/** A list of rows of one height, of which only those in sight exist. It scrolls with the window.
 * @param rowHeight height of a row in pixels, asked again when the window changes */
export function virtualList(role: "list" | "rowgroup", rowHeight: () => number, row: (index: number) => HTMLElement): VirtualList {
  const element = h("div", { class: "virtual", role });
  let count = 0;
  let height = rowHeight();
  let shown: [number, number] = [0, 0];
  let waiting = 0;

  const draw = (force: boolean): void => {
    waiting = 0;
    const top = element.getBoundingClientRect().top;
    const first = Math.max(0, Math.floor(-top / height) - 6);
    const last = Math.min(count, Math.ceil((innerHeight - top) / height) + 6);
    if (!force && first === shown[0] && last === shown[1]) return;
    const kept = new Map<number, HTMLElement>();
    if (!force) for (const child of element.children) kept.set(Number((child as HTMLElement).dataset.index), child as HTMLElement);
    shown = [first, Math.max(first, last)];
    for (const [i, child] of kept) if (i < first || i >= last) child.remove();
    if (force) element.replaceChildren();
    let before: Element | null = element.firstElementChild;
    for (let i = first; i < last; ++i) {
      let child = kept.get(i);
      if (!child) {
        child = row(i);
        child.dataset.index = String(i);
        child.setAttribute(role === "rowgroup" ? "aria-rowindex" : "aria-posinset", String(i + (role === "rowgroup" ? 2 : 1)));
        if (role === "list") child.setAttribute("aria-setsize", String(count));
        child.style.setProperty("transform", `translateY(${i * height}px)`);
        child.style.setProperty("height", `${height}px`);
        element.insertBefore(child, before);
      }
      before = child.nextElementSibling;
    }
  };
  const soon = (): void => { if (!waiting) waiting = requestAnimationFrame(() => draw(false)); };
  const resize = (): void => {
    height = rowHeight();
    element.style.setProperty("height", `${count * height}px`);
    draw(true);
  };
  const print = (): void => {
    element.replaceChildren(...Array.from({ length: Math.min(count, rowsInPrint) }, (_, i) => row(i)));
    shown = [0, 0];
  };
  addEventListener("scroll", soon, { passive: true });
  addEventListener("resize", resize);
  addEventListener("beforeprint", print);
  addEventListener("afterprint", resize);
  return {
    element,
    setCount(next) { count = next; resize(); },
    refresh: () => draw(true),
    reveal(index) {
      const top = element.getBoundingClientRect().top + index * height;
      if (top < 120 || top + height > innerHeight - 20) scrollBy({ top: top - innerHeight / 3 });
      draw(false);
      element.querySelector<HTMLElement>(`[data-index="${index}"] a`)?.focus({ preventScroll: true });
    },
    dispose() {
      cancelAnimationFrame(waiting);
      removeEventListener("scroll", soon);
      removeEventListener("resize", resize);
      removeEventListener("beforeprint", print);
      removeEventListener("afterprint", resize);
    },
  };
}
