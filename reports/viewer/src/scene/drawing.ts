import * as three from "three";
import { isInstanced } from "./instances";

interface Stroke { depth: number; order: number; draw(): void }

/** Draws a scene on a flat canvas without WebGL: the small pictures, and the views of a browser without it.
 * Solids are convex, so that each is the hull of its projected corners; whatever is farther away is drawn first. */
export function drawScene(canvas: HTMLCanvasElement, scene: three.Object3D, camera: three.PerspectiveCamera): void {
  const context = canvas.getContext("2d");
  if (!context) return;
  const { width, height } = canvas;
  context.clearRect(0, 0, width, height);
  scene.updateMatrixWorld(true);
  camera.updateMatrixWorld(true);
  const project = (v: three.Vector3): [number, number] => {
    const p = v.project(camera);
    return [(p.x + 1) * width / 2, (1 - p.y) * height / 2];
  };
  const strokes: Stroke[] = [];
  const centre = new three.Vector3();
  const outline = (part: three.Object3D, geometry: three.BufferGeometry, material: three.Material, toWorld: three.Matrix4): void => {
    const place = geometry.getAttribute("position");
    const count = Math.min(place.count, geometry.drawRange.count);
    const points: [number, number][] = [];
    const v = new three.Vector3();
    const behind: boolean[] = [];
    centre.set(0, 0, 0);
    for (let i = 0; i < count; ++i) {
      v.fromBufferAttribute(place, i).applyMatrix4(toWorld);
      centre.addScaledVector(v, 1 / count);
      const inView = v.clone().applyMatrix4(camera.matrixWorldInverse);
      behind.push(inView.z > -camera.near);
      points.push(project(v));
    }
    // The part of a solid that is before the camera is convex, too.
    if (behind.includes(true) && !(part instanceof three.Line)) {
      const index = geometry.getIndex();
      const corner = (k: number): number => index?.getX(k) ?? k;
      const [from, to] = [new three.Vector3(), new three.Vector3()];
      const kept = points.filter((_, i) => !behind[i]);
      for (let k = 0; k < (index?.count ?? place.count); ++k) {
        const [a, b] = [corner(k), corner(k % 3 === 2 ? k - 2 : k + 1)];
        if (a >= count || b >= count || behind[a] === behind[b]) continue;
        from.fromBufferAttribute(place, a).applyMatrix4(toWorld).applyMatrix4(camera.matrixWorldInverse);
        to.fromBufferAttribute(place, b).applyMatrix4(toWorld).applyMatrix4(camera.matrixWorldInverse);
        kept.push(project(from.lerp(to, (-2 * camera.near - from.z) / (to.z - from.z)).applyMatrix4(camera.matrixWorld)));
      }
      points.splice(0, points.length, ...kept);
      if (points.length < 3) return;
    }
    const colour = (material as three.MeshBasicMaterial).color.getStyle();
    const depth = -centre.applyMatrix4(camera.matrixWorldInverse).z;
    const line = part instanceof three.Line;
    strokes.push({
      depth, order: line ? part.renderOrder + 0.5 : part.renderOrder,
      draw() {
        context.globalAlpha = material.opacity;
        context.beginPath();
        if (part instanceof three.LineSegments) {
          for (let i = 0; i + 1 < points.length; i += 2) { if (behind[i] || behind[i + 1]) continue; context.moveTo(...points[i]); context.lineTo(...points[i + 1]); }
        } else if (line) {
          points.forEach((p, i) => (i ? context.lineTo(...p) : context.moveTo(...p)));
        } else {
          // Also a disc and a marker are convex.
          hull(points).forEach((p, i) => (i ? context.lineTo(...p) : context.moveTo(...p)));
          context.closePath();
          context.fillStyle = colour;
          context.fill();
          return;
        }
        context.strokeStyle = colour;
        context.lineWidth = Math.max(1, width / 500);
        context.stroke();
      },
    });
  };
  scene.traverseVisible((part) => {
    const { geometry, material } = part as Partial<three.Mesh>;
    if (!(geometry instanceof three.BufferGeometry) || !(material instanceof three.Material)) return;
    const place = geometry.getAttribute("position");
    if (!place || place.count === 0) return;
    if (!isInstanced(part)) { outline(part, geometry, material, part.matrixWorld); return; }
    for (let i = 0; i < part.count; ++i) outline(part, geometry, material, new three.Matrix4().fromArray(part.instanceMatrix.array, 16 * i).premultiply(part.matrixWorld));
  });
  strokes.sort((a, b) => a.order - b.order || b.depth - a.depth).forEach((s) => s.draw());
  context.globalAlpha = 1;
}

/** Convex hull in the plane, by Andrew's monotone chain. */
export function hull(points: [number, number][]): [number, number][] {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (list: [number, number][]): [number, number][] => {
    const chain: [number, number][] = [];
    for (const p of list) {
      while (chain.length > 1) {
        const [a, b] = [chain[chain.length - 2], chain[chain.length - 1]];
        if ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0) break;
        chain.pop();
      }
      chain.push(p);
    }
    chain.pop();
    return chain;
  };
  return sorted.length < 3 ? sorted : [...half(sorted), ...half(sorted.reverse())];
}
