/** Makes an engine that JavaScript can call an oracle of Touchstone.
 *
 * An oracle is an object. Its `about` is its answer to hello, see docs/oracle_protocol.md; the
 * precision is double unless it says otherwise. Its functions answer the questions, and may be
 * asynchronous:
 *
 * - contact(A, B) returns {touching, separation, normal, points, witnesses}.
 * - begin(world, parameters) returns a simulation with the functions step(), read() and, if
 *   it supports them, push(body, point, impulse) and readImpulses(). read() returns the row
 *   of numbers of the protocol: position, quaternion, velocity and spin of each body, …
 *   end(), if it exists, is called last: there an engine frees what it does not collect.
 * - simulate(world, parameters) replaces begin() in an engine that does not move in steps. It
 *   returns {times, samples}, and may add {impulses, diverged_at_step}.
 *
 * Units are SI, vectors are lists of 3 numbers in the world frame, quaternions are w, x, y, z.
 *
 * Import this module before the engine: from then on, what JavaScript prints to standard
 * output goes to standard error. Native code that prints there cannot be redirected. */

import { createInterface } from "node:readline";

const PROTOCOL = 1;

/** A motion that reaches this position, speed or spin has diverged. [m, m/s, rad/s] */
const MOST_REACHED = 1e12;

const writeAnswer = process.stdout.write.bind(process.stdout);
process.stdout.write = process.stderr.write.bind(process.stderr);

/** Throw it with the reason if the engine cannot answer a question. It is no failure. */
export class Unsupported extends Error {}

/** Answers the questions of Touchstone until "bye" or the end of the input. */
export async function serve(oracle) {
  for await (const text of createInterface({ input: process.stdin, crlfDelay: Infinity })) {
    let answer = { id: null };
    try {
      const message = JSON.parse(text);
      if (message.method === "bye") break;
      answer.id = message.id;
      Object.assign(answer, await answerTo(oracle, message));
    } catch (error) {
      answer = { id: answer.id, ...refusal(error) };
    }
    writeAnswer(JSON.stringify(answer, finite) + "\n");
  }
  process.stdin.destroy();
}

async function answerTo(oracle, message) {
  if (message.method === "hello") {
    return { protocol: PROTOCOL, precision: "double", ...oracle.about };
  }
  if (message.method === "contact") {
    const answers = [];
    for (const { A, B } of message.queries) {
      answers.push(await Promise.resolve().then(() => oracle.contact(A, B)).catch(refusal));
    }
    return { answers };
  }
  if (message.method !== "world") throw new Error(`unknown method ${message.method}`);
  const parameters = message.parameters ?? {};
  return oracle.simulate
    ? await oracle.simulate(message.world, parameters)
    : await runToEnd(await oracle.begin(message.world, parameters), message.world);
}

/** Runs a simulation from start to end, with its pushes and samples. */
export async function runToEnd(simulation, world) {
  try {
    return await motionOf(simulation, world);
  } finally {
    await simulation.end?.();
  }
}

async function motionOf(simulation, world) {
  let state = [...(await simulation.read())];
  const motion = { times: [0], samples: [state] };
  for (let step = 1; step <= world.steps; ++step) {
    for (const push of world.pushes.filter((push) => push.after_steps === step - 1)) {
      const [x, y, z, ...q] = state.slice(13 * push.body, 13 * push.body + 7);
      const [dx, dy, dz] = rotated(q, push.point);
      await simulation.push(push.body, [x + dx, y + dy, z + dz], push.impulse);
    }
    await simulation.step();
    if (simulation.readImpulses) {
      motion.impulses ??= [];
      for (const row of await simulation.readImpulses()) motion.impulses.push([step, ...row]);
    }
    state = [...(await simulation.read())];
    // Written so that a NaN ends the motion.
    if (!state.every((number) => Math.abs(number) < MOST_REACHED)) {
      return { ...motion, diverged_at_step: step };
    }
    if (step % world.sample_every === 0) {
      motion.times.push(step * world.dt);
      motion.samples.push(state);
    }
  }
  return motion;
}

/** Turns a vector by a quaternion. */
export function rotated([w, x, y, z], v) {
  const cross = (a, b) => [
    a[1] * b[2] - a[2] * b[1],
    a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0],
  ];
  const t = cross([x, y, z], v).map((number) => 2 * number);
  const u = cross([x, y, z], t);
  return v.map((number, i) => number + w * t[i] + u[i]);
}

function refusal(error) {
  if (error instanceof Unsupported) return { unsupported: error.message };
  console.error(error);
  return { error: String(error) };
}

// JSON has no NaN and no infinity: they are strings.
function finite(key, value) {
  return typeof value === "number" && !Number.isFinite(value) ? String(value) : value;
}
