import * as three from "three";
import type { Question } from "../data";
import type { Run } from "../run";
import { buildContact } from "./contact_scene";
import { drawScene } from "./drawing";
import { dispose } from "./parts";
import { cameraFor, placeCamera, startingView } from "./stage";
import { answered, buildWorld } from "./world_scene";

/** Draws the small picture of a question: with the answers of `oracles`, a world at `time` [s] or where it has moved. */
export function drawThumbnail(canvas: HTMLCanvasElement, run: Run, question: Question, oracles: number[], time = -1): void {
  const camera = cameraFor(canvas.width / canvas.height);
  const scene = new three.Scene();
  let up: [number, number, number] = [0, 0, 1];
  let radius = 1;
  if (question.contact) {
    const view = buildContact(question.contact, run.looks);
    for (const o of oracles.slice(0, 2)) view.show(o, true);
    scene.add(view.root);
  } else if (question.world) {
    const { world } = question;
    const shown = oracles.filter((o) => answered(world.motions[o])).slice(0, 2);
    const view = buildWorld(run, world, [run.report.subject, ...shown]);
    shown.forEach((o, i) => view.show(o, i === 0 ? "solid" : "ghost"));
    view.setTime(time >= 0 ? time : (world.times[world.times.length - 1] ?? 0) * 0.6);
    scene.add(view.root);
    up = view.up;
    radius = 1.05;
  }
  camera.up.set(...up);
  placeCamera(camera, new three.Vector3(), radius, new three.Vector3(...startingView(up)));
  drawScene(canvas, scene, camera);
  dispose(scene);
}

const pending = new WeakMap<Element, () => void>();
const observer = new IntersectionObserver((entries) => {
  for (const { isIntersecting, target } of entries) {
    if (!isIntersecting) continue;
    observer.unobserve(target);
    pending.get(target)?.();
  }
}, { rootMargin: "200px" });

/** A small picture that is drawn when it comes into sight. */
export function thumbnail(run: Run, question: Question, oracles: number[], time = -1, width = 160, height = 120): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  const scale = Math.min(2, devicePixelRatio);
  canvas.width = width * scale;
  canvas.height = height * scale;
  canvas.className = "thumbnail";
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", `Picture of ${question.title}`);
  pending.set(canvas, () => {
    try {
      drawThumbnail(canvas, run, question, oracles, time);
    } catch {
      canvas.setAttribute("aria-label", "No picture: the data of this question are damaged");
    }
  });
  observer.observe(canvas);
  return canvas;
}
