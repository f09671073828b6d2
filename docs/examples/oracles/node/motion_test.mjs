// A simulation is run to its end with its pushes, its samples, and its divergence.

import assert from "node:assert";

import { runToEnd } from "./touchstone_oracle.mjs";

// The body's x axis is the y axis of the world.
const start = [1, 2, 3, Math.SQRT1_2, 0, 0, Math.SQRT1_2, 0, 0, 0, 0, 0, 0];

const world = {
  dt: 0.25,
  steps: 4,
  sample_every: 2,
  pushes: [{ body: 0, after_steps: 2, point: [1, 0, 0], impulse: [0, 4, 0] }],
};

/** One ball. Each step moves it by dt * velocity, and multiplies that by `growth`. */
function ball(growth) {
  const state = [...start];
  return {
    state,
    push(body, point, impulse) {
      state.splice(7, 3, ...impulse);
      state.splice(10, 3, ...point); // The test looks at it.
    },
    step() {
      for (let i = 0; i < 3; ++i) {
        state[i] += world.dt * state[7 + i];
        state[7 + i] *= growth;
      }
    },
    read: () => state,
  };
}

// A push after two steps moves the last two, at its point in the world frame.
const motion = await runToEnd(ball(1), world);
assert.deepEqual(motion.times, [0, 0.5, 1]);
assert.deepEqual(motion.samples.map((row) => row[1]), [2, 2, 4]);
[1, 3, 3].forEach((x, i) => assert(Math.abs(motion.samples[2][10 + i] - x) < 1e-15));
assert(!("diverged_at_step" in motion));

// A motion ends before it diverges.
const diverged = await runToEnd(ball(1e13), world);
assert.deepEqual(diverged.times, [0, 0.5]);
assert.equal(diverged.diverged_at_step, 3);
