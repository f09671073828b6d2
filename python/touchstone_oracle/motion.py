"""A motion: the states of a world, sample by sample. World frame, SI units."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, List, Optional, Sequence, Union

import numpy as np

from .arrays import Array, WrongAnswer, number, vector
from .world import World


@dataclass
class BodyState:
    """The state of a rigid body."""

    position: Any
    """Of the centre of mass: 3 numbers. [m]"""
    quaternion: Any
    """Orientation: w, x, y, z."""
    velocity: Any
    """Of the centre of mass: 3 numbers. [m/s]"""
    spin: Any
    """Angular velocity: 3 numbers. [rad/s]"""


@dataclass
class PointState:
    """The state of a particle or of a node of a cloth."""

    position: Any
    """3 numbers. [m]"""
    velocity: Any
    """3 numbers. [m/s]"""


@dataclass
class WorldState:
    """The state of everything in a world."""

    bodies: Sequence[BodyState]
    """One for each body of the world, static ones included."""
    particles: Sequence[PointState] = ()
    nodes: Sequence[PointState] = ()
    """The nodes of all cloths, cloth by cloth, row by row."""


State = Union[Sequence[BodyState], WorldState, Array]
"""The states of the bodies suffice in a world without particles and cloths. An array is the
row of numbers of the protocol: 13 for each body, then 6 for each particle and node."""


@dataclass
class ContactImpulse:
    """The impulse of one contact in one step."""

    A: int
    """Index into World.bodies."""
    B: int
    """Index into World.bodies."""
    point: Any
    """Point of application: 3 numbers. [m]"""
    normal: Any
    """Unit vector from A to B."""
    impulse: Any
    """Impulse on B; A receives the opposite. [N s]"""
    separation: Any
    """Separation that the engine used in this step: < 0 penetrating. [m]"""
    friction_direction: Any = (0.0, 0.0, 0.0)
    """One of the two fixed directions along which the engine bounds friction, if it does."""
    step: int = 0
    """Number of the step, from 1. A Simulation leaves it out."""


@dataclass
class Motion:
    """A whole motion. It has the start, and the state after every `sample_every` steps."""

    times: Sequence[float]
    """From 0. [s]"""
    samples: Sequence[State]
    """One for each time."""
    impulses: Optional[List[ContactImpulse]] = None
    """None if the engine does not give them."""
    diverged_at_step: Optional[int] = None
    """First step that reached a number that is not finite. The samples end before it."""
    complaint: str = ""
    """A sign of an internal failure that the engine gives, such as a warning of its solver."""


def row_of(state: Any, world: World, said: str) -> Array:
    """Returns a state as the row of numbers of the protocol.

    `said` begins the message of the WrongAnswer that is raised if the state does not fit
    the world, e.g. "read() returned ".
    """
    points = len(world.particles) + world.nodes
    if isinstance(state, np.ndarray):
        return vector(state, 13 * len(world.bodies) + 6 * points, said + "numbers")
    if not isinstance(state, WorldState):
        state = WorldState(bodies=state)
    parts: List[Array] = []
    for i, body in enumerate(_items(state.bodies, len(world.bodies), said + "bodies")):
        what = f"{said}bodies[{i}]"
        if not isinstance(body, BodyState):
            raise WrongAnswer(f"{what} of type {type(body).__name__}; expected a BodyState")
        parts.append(vector(body.position, 3, what + ".position"))
        parts.append(vector(body.quaternion, 4, what + ".quaternion"))
        parts.append(vector(body.velocity, 3, what + ".velocity"))
        parts.append(vector(body.spin, 3, what + ".spin"))
    for name, states, count in (
        ("particles", state.particles, len(world.particles)),
        ("nodes", state.nodes, world.nodes),
    ):
        for i, point in enumerate(_items(states, count, said + name)):
            what = f"{said}{name}[{i}]"
            if not isinstance(point, PointState):
                kind = type(point).__name__
                raise WrongAnswer(f"{what} of type {kind}; expected a PointState")
            parts.append(vector(point.position, 3, what + ".position"))
            parts.append(vector(point.velocity, 3, what + ".velocity"))
    return np.concatenate(parts) if parts else np.empty(0)


def impulse_row(impulse: Any, said: str) -> Array:
    """Returns a ContactImpulse as the row of numbers of the protocol."""
    if not isinstance(impulse, ContactImpulse):
        kind = type(impulse).__name__
        raise WrongAnswer(f"{said} of type {kind}; expected a ContactImpulse")
    return np.concatenate(
        [
            [number(getattr(impulse, key), f"{said}.{key}") for key in ("step", "A", "B")],
            vector(impulse.point, 3, said + ".point"),
            vector(impulse.normal, 3, said + ".normal"),
            vector(impulse.impulse, 3, said + ".impulse"),
            [number(impulse.separation, said + ".separation")],
            vector(impulse.friction_direction, 3, said + ".friction_direction"),
        ]
    )


def _items(items: Any, count: int, what: str) -> Sequence[Any]:
    try:
        listed = list(items)
    except TypeError:
        kind = type(items).__name__
        raise WrongAnswer(f"{what} of type {kind}; expected a list") from None
    if len(listed) != count:
        raise WrongAnswer(f"{what}: {len(listed)} states; expected {count}")
    return listed
