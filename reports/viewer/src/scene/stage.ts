import * as three from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Vec3 } from "../data";
import { h } from "../dom";
import { digits, length } from "../format";
import { captionOf, composePicture, pictureWidth } from "../picture";
import { startingView } from "./view_direction";
import { across } from "../vector";
import { drawScene } from "./drawing";
import { overlap, separateLabels, type LabelBox } from "./label_places";
import { dispose } from "./parts";

/** A view of a scene with a camera to orbit, a scale bar and labels. It draws when something has changed, never in a loop. */
export interface Stage {
  element: HTMLElement;
  scene: three.Scene;
  camera: three.PerspectiveCamera;
  /** Draws soon. */
  invalidate(): void;
  /** Looks at the scene from a direction, at once. */
  lookFrom(direction: Vec3): void;
  /** Sees all of the ball around `centre`. */
  fit(centre: three.Vector3, radius: number): void;
  /** Sees all of some balls, as near as they allow from where the camera looks. */
  fitAll(balls: readonly Ball[]): void;
  /** Keeps the camera's offset to a point that moves. */
  follow(point: three.Vector3): void;
  /** A text that stays at a point of the scene, or beside it, while there is one. Names of bodies never cover one another. */
  label(text: string | (() => string), at: () => three.Vector3 | null, kind?: "body" | "beside"): void;
  /** Shows the scene in the middle of what an inset at the right leaves free [px]. */
  keepClear(width: () => number): void;
  /** The middle and the half height of what is in sight at the distance of the middle, and the direction that is up in the picture. */
  seen(): { centre: three.Vector3; radius: number; above: three.Vector3 };
  /** Whether the reader has turned or moved the camera. */
  isTouched(): boolean;
  /** A picture of the view as it is, with what the page says beside it. */
  picture(): Promise<Blob | null>;
  dispose(): void;
}

/** A part of a scene that shall be seen. */
export interface Ball { at: three.Vector3; radius: number }

const fieldOfView = 28;

export const cameraFor = (aspect: number): three.PerspectiveCamera => new three.PerspectiveCamera(fieldOfView, aspect, 0.02, 2000);

export function placeCamera(camera: three.PerspectiveCamera, centre: three.Vector3, radius: number, direction: three.Vector3): void {
  const narrow = Math.min(1, camera.aspect);
  const distance = (radius * 1.08) / Math.sin((fieldOfView * Math.PI) / 360) / narrow;
  camera.position.copy(centre).addScaledVector(direction.clone().normalize(), distance);
  camera.lookAt(centre);
}

/** The part of a view that is left free on either side of what is fitted. */
const margin = 1.12;

/** Places a camera so that it sees all of some balls from a direction, in the middle. Returns the point that it looks at. */
export function placeCameraAround(camera: three.PerspectiveCamera, balls: readonly Ball[], direction: three.Vector3): three.Vector3 {
  const towards = direction.clone().normalize();
  const right = camera.up.clone().cross(towards);
  if (right.lengthSq() < 1e-12) right.set(...across(towards.toArray() as Vec3));
  right.normalize();
  const above = towards.clone().cross(right);
  const slope = Math.tan((fieldOfView * Math.PI) / 360) / margin;
  // A ball is in sight if |x − x₀| + r √(1 + s²) ≤ s (D − z), with D the place of the camera along its direction: a bound for either side.
  const span = (axis: three.Vector3, s: number): { middle: number; distance: number } => {
    let [low, high] = [-Infinity, -Infinity];
    for (const { at, radius } of balls) {
      const [x, z] = [at.dot(axis), at.dot(towards)];
      const wide = radius * Math.hypot(1, s);
      high = Math.max(high, x + wide + s * z);
      low = Math.max(low, -x + wide + s * z);
    }
    return { middle: (high - low) / 2, distance: (high + low) / (2 * s) };
  };
  const [x, y] = [span(right, slope * camera.aspect), span(above, slope)];
  const depths = balls.map(({ at, radius }) => at.dot(towards) + radius);
  const nearest = depths.reduce((most, z) => Math.max(most, z), -Infinity);
  const centre = balls.reduce((sum, { at }) => sum + at.dot(towards) / balls.length, 0);
  const at = (along: number): three.Vector3 => right.clone().multiplyScalar(x.middle).addScaledVector(above, y.middle).addScaledVector(towards, along);
  const target = at(centre);
  camera.position.copy(at(Math.max(x.distance, y.distance, nearest + 0.05)));
  camera.lookAt(target);
  return target;
}

export function lights(): three.Object3D[] {
  const sun = new three.DirectionalLight(0xffffff, 1.6);
  sun.position.set(2, -3, 5);
  const fill = new three.DirectionalLight(0xffffff, 0.5);
  fill.position.set(-3, 2, -2);
  return [new three.AmbientLight(0xffffff, 1.4), sun, fill];
}

let software: boolean | undefined;

/** Whether the processor does the work of a graphics card. Smooth edges would then cost two thirds of the frames. */
function isSoftware(): boolean {
  if (software !== undefined) return software;
  const probe = document.createElement("canvas").getContext("webgl2");
  const names = probe?.getExtension("WEBGL_debug_renderer_info");
  software = /swiftshader|llvmpipe|software/i.test(String(probe?.getParameter(names?.UNMASKED_RENDERER_WEBGL ?? probe.RENDERER)));
  probe?.getExtension("WEBGL_lose_context")?.loseContext();
  return software;
}

function makeRenderer(): three.WebGLRenderer | null {
  try {
    if (new URLSearchParams(location.search).has("flat")) return null;
    const renderer = new three.WebGLRenderer({ antialias: !isSoftware(), alpha: true, powerPreference: "low-power" });
    renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    return renderer;
  } catch {
    return null;
  }
}

/** @param metresPerUnit length of a unit of the scene, for the scale bar
 *  @param up the direction that is up */
export function makeStage(metresPerUnit: number, up: Vec3, name: string): Stage {
  const renderer = makeRenderer();
  const canvas = renderer ? renderer.domElement : document.createElement("canvas");
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", name);
  const bar = h("div", { class: "scale-bar" }, h("span"));
  const overlay = h("div", { class: "labels", "aria-hidden": "true" });
  const element = h("div", { class: "stage" }, canvas, overlay, bar,
    !renderer && h("p", { class: "stage-note" }, "Drawn without WebGL, which this browser does not offer: hidden lines may show."));

  const scene = new three.Scene();
  scene.add(...lights());
  const camera = cameraFor(1);
  camera.up.set(...up);
  camera.position.set(...startingView(up));
  const controls = new OrbitControls(camera, canvas);
  controls.enableDamping = false;
  controls.zoomToCursor = true;

  let seen: { centre: three.Vector3; radius: number } | { balls: readonly Ball[] } = { centre: new three.Vector3(), radius: 1 };
  let waiting = 0;
  interface Label { element: HTMLElement; words: string | (() => string); at: () => three.Vector3 | null; kind: "body" | "beside" }
  const labels: Label[] = [];
  let covered = (): number => 0;

  const drawBar = (): void => {
    const distance = camera.position.distanceTo(controls.target);
    const pixels = element.clientHeight || 1;
    const metresPerPixel = (2 * distance * Math.tan((fieldOfView * Math.PI) / 360) * metresPerUnit) / pixels;
    const wanted = metresPerPixel * 110;
    const power = 10 ** Math.floor(Math.log10(wanted));
    const size = power * ([5, 2, 1].find((m) => m * power <= wanted) ?? 1);
    bar.style.setProperty("width", `${size / metresPerPixel}px`);
    bar.firstElementChild!.textContent = size < 1e-9 ? `${digits(size)} m` : length(size);
  };
  const drawLabels = (): void => {
    const { clientWidth: width, clientHeight: height } = overlay;
    const seen: { text: HTMLElement; x: number; y: number; kind: Label["kind"] }[] = [];
    for (const { element: text, words, at, kind } of labels) {
      const p = at()?.clone().project(camera);
      if (typeof words !== "string" && text.textContent !== words()) text.textContent = words();
      // A point behind the camera has a place in the picture, too.
      text.hidden = p === undefined || Math.abs(p.z) > 1;
      if (p && !text.hidden) seen.push({ text, x: ((p.x + 1) * width) / 2, y: ((1 - p.y) * height) / 2, kind });
    }
    // Names side by side keep a gap, or they would be read as one.
    const boxOf = ({ text, x, y }: { text: HTMLElement; x: number; y: number }): LabelBox => ({ x: x + text.offsetLeft, y: y + text.offsetTop, width: text.offsetWidth + (element.classList.contains("of-world") ? 12 : 4), height: text.offsetHeight });
    // Points close together that have the same name are labelled once.
    seen.forEach((label, i) => { label.text.hidden = seen.slice(0, i).some((other) => !other.text.hidden && other.text.textContent === label.text.textContent && other.kind === label.kind && other.kind === "beside" && overlap(boxOf(other), boxOf(label))); });
    // Names of points keep their places, and those of bodies give way to them.
    const named = (["beside", "body"] as const).flatMap((kind) => seen.filter((label) => label.kind === kind && !label.text.hidden));
    const shifts = separateLabels(named.map(boxOf));
    named.forEach((label, i) => { label.x += shifts[i][0]; label.y += shifts[i][1]; });
    for (const { text, x, y } of seen) text.style.setProperty("transform", `translate(${x}px, ${y}px)`);
  };
  const draw = (): void => {
    waiting = 0;
    if (renderer) {
      renderer.render(scene, camera);
      element.dataset.calls = String(renderer.info.render.calls);
    } else drawScene(canvas, scene, camera);
    drawLabels();
    drawBar();
  };
  const invalidate = (): void => { if (!waiting) waiting = requestAnimationFrame(draw); };
  controls.addEventListener("change", invalidate);
  let touched = false;
  controls.addEventListener("start", () => { touched = true; });

  const resize = (): void => {
    const { clientWidth: width, clientHeight: height } = element;
    if (!width || !height) return;
    const before = camera.aspect;
    // Half of what is covered: the middle of the scene is then in the middle of the rest.
    const cover = Math.min(covered(), width / 2);
    camera.aspect = width / height;
    if (cover > 0) camera.setViewOffset(width, height, cover / 2, 0, width, height);
    else camera.clearViewOffset();
    camera.updateProjectionMatrix();
    if (renderer) renderer.setSize(width, height, false);
    else { canvas.width = width * devicePixelRatio; canvas.height = height * devicePixelRatio; }
    if ("balls" in seen ? before !== camera.aspect && !touched : Math.min(1, before) !== Math.min(1, camera.aspect)) refit();
    draw();
  };
  const observer = new ResizeObserver(resize);
  observer.observe(element);

  const refit = (): void => {
    const direction = camera.position.clone().sub(controls.target);
    if (direction.lengthSq() === 0) direction.set(1, 1, 1);
    if ("balls" in seen) controls.target.copy(placeCameraAround(camera, seen.balls, direction));
    else {
      placeCamera(camera, seen.centre, seen.radius, direction);
      controls.target.copy(seen.centre);
    }
    controls.update();
    invalidate();
  };

  return {
    element, scene, camera, invalidate,
    lookFrom(direction) {
      const d = new three.Vector3(...direction).normalize();
      // Straight from above the camera has no up; a tilt too small to see gives it one.
      if (Math.abs(d.dot(camera.up)) > 0.9999) d.addScaledVector(new three.Vector3(...across(up)), 2e-3).normalize();
      const distance = camera.position.distanceTo(controls.target);
      camera.position.copy(controls.target).addScaledVector(d, distance);
      // Long motions are wider from one side than from another.
      if ("balls" in seen && !touched) refit();
      controls.update();
      invalidate();
    },
    fit(centre, radius) {
      seen = { centre: centre.clone(), radius };
      touched = false;
      refit();
    },
    fitAll(balls) {
      seen = { balls };
      touched = false;
      refit();
    },
    follow(point) {
      if ("balls" in seen) seen = { centre: point.clone(), radius: (camera.position.distanceTo(controls.target) * Math.sin((fieldOfView * Math.PI) / 360) * Math.min(1, camera.aspect)) / 1.08 };
      const shift = point.clone().sub(controls.target);
      controls.target.add(shift);
      camera.position.add(shift);
      controls.update();
      invalidate();
    },
    label(text, at, kind = "body") {
      const place = h("span", { class: kind === "beside" ? "label beside" : "label" }, typeof text === "string" ? text : text());
      overlay.append(place);
      labels.push({ element: place, words: text, at, kind });
    },
    keepClear(width) { covered = width; },
    seen: () => ({ centre: controls.target.clone(), radius: camera.position.distanceTo(controls.target) * Math.tan((fieldOfView * Math.PI) / 360), above: new three.Vector3(0, 1, 0).applyQuaternion(camera.quaternion) }),
    isTouched: () => touched,
    async picture() {
      // The picture is drawn anew at the width of a slide: an enlarged one would be blurred.
      const { clientWidth: width, clientHeight: height } = element;
      const copy = h("canvas", { width: pictureWidth, height: Math.round((pictureWidth * height) / width) });
      renderer?.setPixelRatio(pictureWidth / width);
      renderer?.setSize(width, height, false);
      draw();
      copy.getContext("2d")?.drawImage(canvas, 0, 0, copy.width, copy.height);
      renderer?.setPixelRatio(Math.min(devicePixelRatio, 2));
      resize();
      return composePicture(copy, element, captionOf(element));
    },
    dispose() {
      cancelAnimationFrame(waiting);
      observer.disconnect();
      controls.dispose();
      dispose(scene);
      // Browsers keep few contexts: this one goes now, not when its memory is collected.
      renderer?.dispose();
      renderer?.forceContextLoss();
    },
  };
}
