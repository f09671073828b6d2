import { h, type Child } from "./dom";

/** Symbols that reasons and proofs use, in the notation of docs/conventions.md, in words. */
const symbols: Record<string, string> = {
  n_AB_W: "the contact normal: a unit vector from body A to body B, in world coordinates",
  n_W: "a unit normal, in world coordinates",
  p_WC: "a contact point, in world coordinates [m]",
  p_WCa: "the contact point on body A, in world coordinates [m]",
  p_WCb: "the contact point on body B, in world coordinates [m]",
  X_WA: "the pose of body A in the world",
  X_WB: "the pose of body B in the world",
};
const pattern = new RegExp(`\\b(${Object.keys(symbols).sort((a, b) => b.length - a.length).join("|")})\\b`);

/** A text whose symbols say in a tooltip what they are. */
export const prose = (text: string): Child[] =>
  text.split(pattern).map((part, i) => (i % 2 ? h("abbr", { title: symbols[part] }, part) : part));
