import * as three from "three";
import type { Question } from "../data";
import type { Run } from "../run";
import { acrossMotion, isWide, regionOf, trustedOf, worldFault } from "../world_fault";
import { buildContact } from "./contact_scene";
import { drawScene } from "./drawing";
import { dispose } from "./parts";
import { cameraFor, placeCamera, placeCameraAround, type Ball } from "./stage";
import { startingView } from "./view_direction";
import { answered } from "./motion_extent";
import { buildWorld } from "./world_scene";

/** Draws the small picture of a question: with the answers of `oracles`, a world at the moment of `finding` and fitted to what it is about, or where it has moved. */
export function drawThumbnail(canvas: HTMLCanvasElement, run: Run, question: Question, oracles: number[], finding: number): void {
  const camera = cameraFor(canvas.width / canvas.height);
  const scene = new three.Scene();
  let up: [number, number, number] = [0, 0, 1];
  let radius = 1;
  let centre = new three.Vector3();
  let from = startingView(up);
  let whole: readonly Ball[] | null = null;
  if (question.contact) {
    const view = buildContact(question.contact, run.looks);
    for (const o of oracles.slice(0, 2)) view.show(o, true);
    scene.add(view.root);
  } else if (question.world) {
    const { world } = question;
    const shown = oracles.filter((o) => answered(world.motions[o])).slice(0, 2);
    const view = buildWorld(run, world, trustedOf(run, world, run.questionOf(question.id)));
    shown.forEach((o, i) => view.show(o, i === 0 ? "solid" : "ghost"));
    const fault = worldFault(run, world, finding);
    const at = fault.time >= 0 ? fault.inStep ?? fault.time : (world.times[world.times.length - 1] ?? 0) * 0.6;
    const region = shown.length > 0 && fault.time >= 0 && isWide(view, world, fault.bodies) ? regionOf(run, view, world, fault, shown, [at]) : null;
    view.setTime(at);
    scene.add(view.root);
    up = view.up;
    radius = region ? 1.2 * region.radius : 1.05;
    centre = region?.centre ?? centre;
    from = (region ? region.from : fault.passes && shown.length > 0 ? acrossMotion(run, view, world, fault, shown[0]) : null) ?? startingView(up);
    if (!region) whole = view.extent;
  }
  camera.up.set(...up);
  const direction = new three.Vector3(...from);
  if (whole) placeCameraAround(camera, whole, direction);
  else placeCamera(camera, centre, radius, direction);
  drawScene(canvas, scene, camera);
  dispose(scene);
}

const pending = new WeakMap<Element, () => void>();
/** Pictures in sight that wait until nothing else is to do: opening and scrolling do not wait for them. */
const queue: Element[] = [];
let isWaiting = false;

function drawNext(deadline: Pick<IdleDeadline, "timeRemaining">): void {
  do {
    const next = queue.shift();
    // One that has gone out of sight meanwhile, with its row, is not drawn.
    if (next?.isConnected) pending.get(next)?.();
  } while (queue.length > 0 && deadline.timeRemaining() > 8);
  isWaiting = queue.length > 0;
  if (isWaiting) whenIdle();
}

function whenIdle(): void {
  isWaiting = true;
  if ("requestIdleCallback" in window) requestIdleCallback(drawNext, { timeout: 1000 });
  else setTimeout(() => drawNext({ timeRemaining: () => 0 }), 16);
}
const observer = new IntersectionObserver((entries) => {
  for (const { isIntersecting, target } of entries) {
    if (!isIntersecting) continue;
    observer.unobserve(target);
    queue.push(target);
    if (!isWaiting) whenIdle();
  }
}, { rootMargin: "200px" });

/** A small picture that is drawn when it comes into sight. */
export function thumbnail(run: Run, question: Question, oracles: number[], finding: number, width = 160, height = 120): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  const scale = Math.min(2, devicePixelRatio);
  canvas.width = width * scale;
  canvas.height = height * scale;
  canvas.className = "thumbnail";
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", `Picture of ${question.title}`);
  pending.set(canvas, () => {
    try {
      drawThumbnail(canvas, run, question, oracles, finding);
    } catch {
      canvas.setAttribute("aria-label", "No picture: the data of this question are damaged");
    }
  });
  observer.observe(canvas);
  return canvas;
}
