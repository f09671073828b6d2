"""A simulation that moves step by step, and its whole motion."""

from __future__ import annotations

import copy
from typing import Any, List, Optional

import numpy as np

from .arrays import Array, WrongAnswer
from .motion import ContactImpulse, Motion, State, impulse_row, row_of
from .world import World

MOST_REACHED = 1e12
"""A motion that reaches this position, speed or spin has diverged. [m, m/s, rad/s]"""


class Simulation:
    """A running simulation of one world. Derive yours from it."""

    def push(self, body: int, point: Array, impulse: Array) -> None:
        """Applies an impulse [N s] to a body at a point [m], both in the world frame.

        It is called between steps, and only if the oracle supports "push".
        """
        raise NotImplementedError(f"{type(self).__name__} has no push()")

    def step(self) -> None:
        """Advances the world by one step of World.dt."""
        raise NotImplementedError(f"{type(self).__name__} has no step()")

    def read(self) -> State:
        """Returns the state of each body in the order of World.bodies, static ones included.

        A world that has particles or cloths needs a WorldState.
        """
        raise NotImplementedError(f"{type(self).__name__} has no read()")

    def read_impulses(self) -> Optional[List[ContactImpulse]]:
        """Returns the impulses of the contacts of the last step; None if unknown."""
        return None


def run_to_end(simulation: Any, world: World) -> Motion:
    """Runs a simulation from start to end, with its pushes and samples.

    The motion ends before the first step whose numbers are not finite or are too large.
    """
    if not isinstance(simulation, Simulation):
        kind = type(simulation).__name__
        raise WrongAnswer(f"begin() returned {kind}; expected a Simulation")
    state = _read(simulation, world)
    times, samples = [0.0], [state]
    impulses: Optional[List[ContactImpulse]] = None
    diverged_at_step = None
    for step in range(1, world.steps + 1):
        _push(simulation, world, step - 1, state)
        simulation.step()
        new_impulses = simulation.read_impulses()
        state = _read(simulation, world)
        is_sane = _is_sane(state)
        if new_impulses is not None:
            impulses = [] if impulses is None else impulses
            for impulse in new_impulses:
                # An engine may return its own objects, which the next step changes.
                impulse = copy.deepcopy(impulse)
                impulse.step = step
                is_sane = is_sane and _is_finite(impulse)
                impulses.append(impulse)
        if not is_sane:
            diverged_at_step = step
            break
        if step % world.sample_every == 0:
            times.append(step * world.dt)
            samples.append(state)
    return Motion(times, samples, impulses, diverged_at_step)


def _read(simulation: Simulation, world: World) -> Array:
    row = row_of(simulation.read(), world, "read() returned ")
    # An engine may return its own array, which the next step changes.
    return row.copy()


def _push(simulation: Simulation, world: World, steps: int, state: Array) -> None:
    for push in world.pushes:
        if push.after_steps == steps:
            numbers = state[13 * push.body : 13 * push.body + 7]
            point = numbers[:3] + _rotated(numbers[3:], push.point)
            simulation.push(push.body, point, push.impulse)


def _rotated(quaternion: Array, v: Array) -> Array:
    w, u = quaternion[0], quaternion[1:]
    t = 2 * np.cross(u, v)
    return np.asarray(v + w * t + np.cross(u, t))


def _is_sane(state: Array) -> bool:
    # Written so that a NaN is not sane. The numbers of an orientation are small anyway.
    return bool((np.abs(state) < MOST_REACHED).all())


def _is_finite(impulse: ContactImpulse) -> bool:
    return bool(np.isfinite(impulse_row(impulse, "read_impulses() returned one")).all())
