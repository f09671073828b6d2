/** Loads the npm package of PhysX, which is built for web pages only. */

import { readFileSync } from "node:fs";
import { load, pathInPackage } from "../node/adapter.mjs";

export async function loadPhysX() {
  const { default: create } = await load("physx-js-webidl/physx-js-webidl.mjs");
  const wasmBinary = readFileSync(pathInPackage("physx-js-webidl/physx-js-webidl.wasm"));
  // The package refuses to start where it sees Node, and looks for a window.
  const { process } = globalThis;
  globalThis.process = undefined;
  globalThis.window = globalThis;
  try {
    return await create({ wasmBinary, print: console.error, printErr: console.error });
  } finally {
    globalThis.process = process;
    delete globalThis.window;
  }
}
