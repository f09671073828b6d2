import type { Contact, Vec3 } from "./data";
import { h } from "./dom";
import { colourOf, prefersDark, type Look } from "./engines";
import { digits, length, precise } from "./format";
import { contactCentre, hasNormal, type ProofState } from "./scene/contact_scene";
import { makeCut } from "./scene/section";
import { across, add, dot, isFinite3, sub, times, unit } from "./vector";

/** A close-up of a contact: the section of both bodies along the normal, magnified so that the depth or the gap fills a third of it.
 * It is computed in doubles about the contact, because a graphics card has no digits left for a depth of a millionth of the size. */
export function closeUp(contact: Contact, looks: Look[]): { element: HTMLElement; draw(shown: number[], state: ProofState, explained: number): void } | null {
  const { truth } = contact;
  const size = Math.max(Math.abs(truth.lo), Math.abs(truth.hi));
  if (!hasNormal(truth.n) || !Number.isFinite(size) || size === 0) return null;
  // A section of fewer than some hundred roundings would show these, not the bodies.
  if (size < 1e-13 * contactSize(contact)) return null;
  const n = unit(truth.n);
  const centre = contactCentre(contact);
  const e = across(n);
  const [width, height] = [240, 180];
  const pixelsPerMetre = height / 3 / size;
  const canvas = h("canvas", { width: width * 2, height: height * 2, role: "img", "aria-label": `Section along the normal, close up: ${truth.touching}, ${length(size)}` });
  const cuts = [contact.A, contact.B].map((body) => makeCut(body, centre, n));
  /** Where lines along n, one a column, run within a body that has moved across n: the lower and the upper end. */
  const columnsOf = (cut: (typeof cuts)[0], moved: Vec3 = [0, 0, 0]): (ReturnType<(typeof cuts)[0]>)[] =>
    Array.from({ length: width }, (_, x) => cut(sub(times((x + 0.5 - width / 2) / pixelsPerMetre, e), moved)));
  const still = cuts.map((cut) => columnsOf(cut));

  const draw = (shown: number[], state: ProofState, explained: number): void => {
    const context = canvas.getContext("2d");
    if (!context) return;
    const dark = prefersDark();
    context.setTransform(2, 0, 0, 2, 0, 0);
    context.clearRect(0, 0, width, height);
    const y = (t: number): number => Math.max(-10, Math.min(height + 10, height / 2 - t * pixelsPerMetre));
    const fillColumns = (columns: (typeof still)[0], raised: number, colour: string, opacity: number): void => {
      context.fillStyle = colour;
      context.globalAlpha = opacity;
      columns.forEach((part, x) => { if (part) context.fillRect(x, y(part[1] + raised), 1, y(part[0] + raised) - y(part[1] + raised)); });
    };
    fillColumns(still[0], 0, dark ? "#7f93b8" : "#8fa3c9", 0.55);
    fillColumns(still[1], state.moved, dark ? "#b59a74" : "#cbb38c", 0.55);
    // The copies of B that are moved as the oracle says.
    for (const { moved, along } of state.paths) {
      if (moved === 0) continue;
      const way = times(moved, along);
      const raised = dot(way, n);
      fillColumns(columnsOf(cuts[1], sub(way, times(raised, n))), raised, colourOf(looks[explained]), 0.3);
    }
    context.globalAlpha = 1;
    const ink = dark ? "#f5f5f5" : "#111111";
    // The ruler of the certified separation.
    context.strokeStyle = context.fillStyle = ink;
    context.lineWidth = 1;
    const [top, bottom] = [y(size / 2), y(-size / 2)];
    context.beginPath();
    for (const level of [top, bottom]) { context.moveTo(12, level); context.lineTo(24, level); }
    context.moveTo(18, top);
    context.lineTo(18, bottom);
    context.stroke();
    context.font = "12px system-ui, sans-serif";
    context.fillText(state.moved > 0 ? `B moved ${precise(state.moved)}` : precise(size), 28, (top + bottom) / 2 + 4);
    for (const o of shown) {
      const answer = contact.answers[o];
      context.strokeStyle = context.fillStyle = colourOf(looks[o]);
      context.lineWidth = 2;
      for (const { p, s } of answer.points ?? []) {
        if (!isFinite3(p)) continue;
        const d: Vec3 = sub(p, centre);
        const x = width / 2 + dot(d, e) * pixelsPerMetre;
        const level = height / 2 - dot(d, n) * pixelsPerMetre;
        // Only points of this window: the others are in the view around it.
        if (x < -5 || x > width + 5 || level < -5 || level > height + 5) continue;
        const half = (Math.abs(s) / 2) * pixelsPerMetre;
        context.beginPath();
        context.moveTo(x, level - half);
        context.lineTo(x, level + half);
        context.stroke();
        context.beginPath();
        context.arc(x, level, 4, 0, 2 * Math.PI);
        context.fill();
      }
    }
    for (const p of [truth.pA, add(truth.pB, times(state.moved, n))]) {
      if (!isFinite3(p)) continue;
      const d = sub(p, centre);
      context.strokeStyle = ink;
      context.lineWidth = 1.5;
      context.strokeRect(width / 2 + dot(d, e) * pixelsPerMetre - 3, height / 2 - dot(d, n) * pixelsPerMetre - 3, 6, 6);
    }
  };
  const magnified = contactSize(contact) / size;
  return {
    element: h("figure", { class: "close-up" }, canvas, h("figcaption", {}, `Section along the normal, ${digits(magnified / 3, 1)} times closer`)),
    draw,
  };
}

/** Extent of the question along its normal, for the magnification. */
function contactSize(contact: Contact): number {
  const centre = contactCentre(contact);
  const n = unit(contact.truth.n);
  const spans = [contact.A, contact.B].map((body) => makeCut(body, centre, n)(add([0, 0, 0], [0, 0, 0]))).filter((c) => c !== null).map((c) => c[1] - c[0]).filter(Number.isFinite);
  return Math.max(...spans, Math.abs(contact.truth.lo), Math.abs(contact.truth.hi));
}
