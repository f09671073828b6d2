"""A world to simulate: the start of a motion, and what acts on it.

Units are SI and the world frame is right-handed. Every array is read-only: copy what a
simulation changes.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import List, Tuple

from .arrays import Array
from .shapes import Body


@dataclass(frozen=True, eq=False)
class RigidBody(Body):
    """A rigid body at the start of a motion. Its origin is its centre of mass."""

    name: str
    mass: float
    """0: it never moves. [kg]"""
    inertia: Array
    """Principal moments about the centre, along the body's axes. [kg m^2]"""
    velocity: Array
    """Velocity of the centre, world frame. [m/s]"""
    spin: Array
    """Angular velocity, world frame. [rad/s]"""
    restitution: float
    """From 0 to 1; the smaller value of the two bodies counts."""
    friction: float
    """The root of the product of the two bodies' values counts."""
    force: Array
    """Constant force through the centre in addition to gravity, world frame. [N]"""
    collides: bool
    """False: it passes through everything."""


@dataclass(frozen=True, eq=False)
class Particle:
    """A point mass without size."""

    name: str
    position: Array
    """World frame. [m]"""
    velocity: Array
    """World frame. [m/s]"""
    mass: float
    """0: it never moves. [kg]"""
    damping: float
    """Its velocity decays as exp(-damping t). [1/s]"""
    bounce: float
    """Fraction of the normal velocity that an impact keeps."""


@dataclass(frozen=True, eq=False)
class Anchor:
    """One end of a spring or of a joint."""

    on: str
    """"world", "body" or "particle"."""
    index: int
    """Index into World.bodies or World.particles; -1 if it is on the world."""
    point: Array
    """In the body frame; in the world frame if it is on the world. [m]"""


@dataclass(frozen=True, eq=False)
class Spring:
    """A spring with a damper between two points."""

    A: Anchor
    B: Anchor
    stiffness: float
    """[N/m]"""
    damping: float
    """[N s/m]"""
    rest_length: float
    """[m]"""


@dataclass(frozen=True, eq=False)
class Joint:
    """A massless rod that keeps its length."""

    A: Anchor
    B: Anchor
    length: float
    """[m]"""


@dataclass(frozen=True, eq=False)
class ClothSprings:
    """Springs between the nodes of a cloth."""

    stiffness: float
    """[N/m]"""
    damping: float
    """[N s/m]"""


@dataclass(frozen=True, eq=False)
class Cloth:
    """A square net of particles with springs, along the x and z axes of the world."""

    name: str
    n: int
    """Nodes along a side."""
    spacing: float
    """Distance between neighbouring nodes at the start. [m]"""
    centre: Array
    """World frame. [m]"""
    node_mass: float
    """[kg]"""
    damping: float
    """[1/s]"""
    bounce: float
    structural: ClothSprings
    """Between neighbours in a row or a column."""
    shear: ClothSprings
    """Between diagonal neighbours."""
    bend: ClothSprings
    """Between every second node of a row or a column."""
    pinned: List[Tuple[int, int]]
    """Row and column, from 0, of the nodes that never move."""


@dataclass(frozen=True, eq=False)
class Push:
    """An impulse on a body between two steps."""

    body: int
    """Index into World.bodies."""
    after_steps: int
    """Number of steps before it."""
    point: Array
    """Point of application, body frame. [m]"""
    impulse: Array
    """World frame. [N s]"""


@dataclass(frozen=True, eq=False)
class World:
    """What moves, what acts on it, and for how long."""

    gravity: Array
    """World frame. [m/s^2]"""
    dt: float
    """Length of a step. [s]"""
    steps: int
    sample_every: int
    """Steps between two samples."""
    bodies: List[RigidBody]
    particles: List[Particle]
    springs: List[Spring]
    joints: List[Joint]
    cloths: List[Cloth]
    pushes: List[Push]

    @property
    def nodes(self) -> int:
        """The number of nodes of all cloths."""
        return sum(cloth.n**2 for cloth in self.cloths)
