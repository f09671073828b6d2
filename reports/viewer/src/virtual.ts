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

/** A list of rows, of which only those in sight exist. It scrolls with the window.
 * @param rowHeight height of every row in pixels, asked again when the window or the number of rows changes. Rows that `flow` are as high as their
 * texts need: that height is an estimate for those that were never in sight, so that nothing is measured before the first picture */
export function virtualList(role: "list" | "rowgroup", rowHeight: () => number, row: (index: number) => HTMLElement, flow = false): VirtualList {
  const element = h("div", { class: flow ? "virtual flow" : "virtual", role });
  let count = 0;
  /** The height of every row, and where each begins if they flow; the end of the list comes last [px]. */
  let height = 1;
  let starts: number[] | null = null;
  /** Heights of rows that were in sight; 0 for the others [px]. */
  let known: number[] = [];
  let shown: [number, number] = [0, 0];
  let waiting = 0;
  /** Where the list begins below the upper edge of the window, and the height of the window [px], as they were last measured. */
  let [top, room] = [NaN, 0];

  const placeRows = (): void => {
    if (!flow) return;
    starts = [0];
    for (let i = 0; i < count; ++i) starts.push(starts[i] + (known[i] || height));
  };
  const measure = (): void => {
    [top, room] = [element.getBoundingClientRect().top, innerHeight];
    if (!flow) return;
    for (const child of element.children) known[Number((child as HTMLElement).dataset.index)] = child.getBoundingClientRect().height;
    placeRows();
  };
  const startOf = (index: number): number => (starts ? starts[index] : index * height);
  const heightOf = (index: number): number => (starts ? starts[index + 1] - starts[index] : height);
  /** The row at a distance from the upper edge of the list. */
  const rowAt = (y: number): number => {
    if (!starts) return Math.floor(y / height);
    let [low, high] = [0, Math.max(0, count - 1)];
    while (low < high) {
      const mid = (low + high + 1) >> 1;
      if (starts[mid] <= y) low = mid;
      else high = mid - 1;
    }
    return low;
  };
  const draw = (force: boolean): void => {
    if (Number.isNaN(top)) measure();
    const first = Math.max(0, rowAt(-top) - 6);
    const last = Math.min(count, rowAt(room - top) + 7);
    if (!force && first === shown[0] && last === shown[1]) { pad(); return; }
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
        if (!flow) {
          child.style.setProperty("transform", `translateY(${startOf(i)}px)`);
          child.style.setProperty("height", `${heightOf(i)}px`);
        }
        element.insertBefore(child, before);
      }
      before = child.nextElementSibling;
    }
    pad();
  };
  /** Rows that flow are pushed to their place by the room of those before them. */
  const pad = (): void => {
    if (!flow) return;
    element.style.setProperty("padding-top", `${startOf(Math.min(shown[0], count))}px`);
    element.style.setProperty("padding-bottom", `${startOf(count) - startOf(Math.min(Math.max(...shown), count))}px`);
  };
  const soon = (): void => {
    if (!waiting) waiting = requestAnimationFrame(() => { waiting = 0; measure(); draw(false); });
  };
  // The height of the page above the list may have changed by a little: the rows beyond the window cover that until the next frame measures. A
  // measurement now would cost a layout of the whole page before the one that the frame needs anyway.
  const setCount = (next: number): void => {
    count = next;
    height = rowHeight();
    known = [];
    placeRows();
    if (!flow) element.style.setProperty("height", `${startOf(count)}px`);
    draw(true);
    soon();
  };
  const resize = (): void => {
    measure();
    setCount(count);
    // A row may be higher or lower in the new width than it is thought to be.
    if (flow) { measure(); draw(false); }
  };
  const print = (): void => {
    element.replaceChildren(...Array.from({ length: Math.min(count, rowsInPrint) }, (_, i) => row(i)));
    shown = [0, 0];
    element.style.setProperty("padding", "0");
  };
  addEventListener("scroll", soon, { passive: true });
  addEventListener("resize", resize);
  addEventListener("beforeprint", print);
  addEventListener("afterprint", resize);
  return {
    element,
    setCount,
    refresh: () => draw(true),
    reveal(index) {
      measure();
      const at = top + startOf(index);
      if (at < 120 || at + heightOf(index) > room - 20) scrollBy({ top: at - room / 3 });
      measure();
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
