import * as three from "three";
import type { Form } from "./shapes";

/** Lines that are drawn many times in one call. three.js has instances of meshes only; its renderer asks for the four properties below. */
export class InstancedLines extends three.LineSegments<three.BufferGeometry, three.LineBasicMaterial> {
  readonly isInstancedMesh = true;
  readonly instanceMatrix: three.InstancedBufferAttribute;
  readonly instanceColor = null;
  readonly morphTexture = null;
  constructor(geometry: three.BufferGeometry, material: three.LineBasicMaterial, readonly count: number) {
    super(geometry, material);
    this.instanceMatrix = new three.InstancedBufferAttribute(new Float32Array(16 * count), 16);
  }
}

export type Instanced = three.InstancedMesh | InstancedLines;

/** Whether an object of a scene is drawn many times, each time in another place. */
export const isInstanced = (object: three.Object3D): object is Instanced => "isInstancedMesh" in object && object.isInstancedMesh === true;

/** Bodies of one shape and one colour, drawn in two calls: surfaces and edges. */
export interface Batch { surfaces: three.InstancedMesh; edges: InstancedLines; set(index: number, matrix: three.Matrix4): void; commit(): void }

export function makeBatch({ surface, edges }: Form, count: number, colour: string): Batch {
  const surfaces = new three.InstancedMesh(surface, new three.MeshLambertMaterial({ color: colour, vertexColors: surface.hasAttribute("color"), polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }), count);
  surfaces.userData.convex = true;
  const lines = new InstancedLines(edges, new three.LineBasicMaterial({ color: colour, transparent: true, opacity: 0.8 }), count);
  // The instances are where the matrices say, not where the shape is.
  surfaces.frustumCulled = lines.frustumCulled = false;
  return {
    surfaces, edges: lines,
    set(index, matrix) {
      matrix.toArray(surfaces.instanceMatrix.array, 16 * index);
      matrix.toArray(lines.instanceMatrix.array, 16 * index);
    },
    commit() { surfaces.instanceMatrix.needsUpdate = lines.instanceMatrix.needsUpdate = true; },
  };
}
