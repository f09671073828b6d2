import type { Address } from "./address";
import type { Run } from "./run";

/** A key that a screen answers to, and what it does, for the list of keys. */
export interface Key { keys: string[]; does: string; run(key: string): void }

/** A screen. It is made for an address and disposed of when the reader goes elsewhere. */
export interface View {
  title: string;
  element: HTMLElement;
  keys?: Key[];
  /** Takes a new address of the same screen, so that focus and scroll stay; returns false to be made anew. */
  update?(address: Address): boolean;
  dispose?(): void;
}

export type MakeView = (run: Run, address: Address) => View;
