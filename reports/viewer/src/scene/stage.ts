import * as three from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Vec3 } from "../data";
import { h } from "../dom";
import { digits, length } from "../format";
import { across } from "../vector";
import { drawScene } from "./drawing";
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
  /** Keeps the camera's offset to a point that moves. */
  follow(point: three.Vector3): void;
  /** A text that stays at a point of the scene, or beside it, while there is one. */
  label(text: string, at: () => three.Vector3 | null, beside?: boolean): void;
  /** A picture of the view as it is. */
  picture(): Promise<Blob | null>;
  dispose(): void;
}

const fieldOfView = 28;

export const cameraFor = (aspect: number): three.PerspectiveCamera => new three.PerspectiveCamera(fieldOfView, aspect, 0.02, 2000);

export function placeCamera(camera: three.PerspectiveCamera, centre: three.Vector3, radius: number, direction: three.Vector3): void {
  const narrow = Math.min(1, camera.aspect);
  const distance = (radius * 1.08) / Math.sin((fieldOfView * Math.PI) / 360) / narrow;
  camera.position.copy(centre).addScaledVector(direction.clone().normalize(), distance);
  camera.lookAt(centre);
}

export function lights(): three.Object3D[] {
  const sun = new three.DirectionalLight(0xffffff, 1.6);
  sun.position.set(2, -3, 5);
  const fill = new three.DirectionalLight(0xffffff, 0.5);
  fill.position.set(-3, 2, -2);
  return [new three.AmbientLight(0xffffff, 1.4), sun, fill];
}

/** The direction from which a scene is seen at first. */
export function startingView(up: Vec3): Vec3 {
  const side = across(up);
  const other = new three.Vector3(...up).cross(new three.Vector3(...side));
  return new three.Vector3(...side).multiplyScalar(0.55).addScaledVector(other, 0.75).addScaledVector(new three.Vector3(...up), 0.45).toArray() as Vec3;
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

  let seen = { centre: new three.Vector3(), radius: 1 };
  let waiting = 0;
  const labels: { element: HTMLElement; at: () => three.Vector3 | null }[] = [];

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
  const draw = (): void => {
    waiting = 0;
    if (renderer) {
      renderer.render(scene, camera);
      element.dataset.calls = String(renderer.info.render.calls);
    } else drawScene(canvas, scene, camera);
    for (const { element: text, at } of labels) {
      const place = at();
      text.hidden = place === null;
      if (!place) continue;
      const p = place.clone().project(camera);
      text.style.setProperty("transform", `translate(${(p.x + 1) * overlay.clientWidth / 2}px, ${(1 - p.y) * overlay.clientHeight / 2}px)`);
    }
    drawBar();
  };
  const invalidate = (): void => { if (!waiting) waiting = requestAnimationFrame(draw); };
  controls.addEventListener("change", invalidate);

  const resize = (): void => {
    const { clientWidth: width, clientHeight: height } = element;
    if (!width || !height) return;
    const before = camera.aspect;
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    if (renderer) renderer.setSize(width, height, false);
    else { canvas.width = width * devicePixelRatio; canvas.height = height * devicePixelRatio; }
    if (Math.min(1, before) !== Math.min(1, camera.aspect)) refit();
    draw();
  };
  const observer = new ResizeObserver(resize);
  observer.observe(element);

  const refit = (): void => {
    const direction = camera.position.clone().sub(controls.target);
    placeCamera(camera, seen.centre, seen.radius, direction.lengthSq() > 0 ? direction : new three.Vector3(1, 1, 1));
    controls.target.copy(seen.centre);
    controls.update();
    invalidate();
  };

  return {
    element, scene, camera, invalidate,
    lookFrom(direction) {
      const d = new three.Vector3(...direction).normalize();
      // Straight from above the camera has no up; a tilt too small to see gives it one.
      if (Math.abs(d.dot(camera.up)) > 0.9999) d.addScaledVector(new three.Vector3(...across(up)), 2e-3).normalize();
      camera.position.copy(controls.target).addScaledVector(d, camera.position.distanceTo(controls.target));
      controls.update();
      invalidate();
    },
    fit(centre, radius) {
      seen = { centre: centre.clone(), radius };
      refit();
    },
    follow(point) {
      const shift = point.clone().sub(controls.target);
      controls.target.add(shift);
      camera.position.add(shift);
      controls.update();
      invalidate();
    },
    label(text, at, beside = false) {
      const place = h("span", { class: beside ? "label beside" : "label" }, text);
      overlay.append(place);
      labels.push({ element: place, at });
    },
    picture() {
      draw();
      return new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
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
