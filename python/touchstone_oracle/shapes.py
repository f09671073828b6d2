"""The shapes of bodies.

Each shape is centred on the origin of its body, and its axis is the z axis of the body.
Sizes are in metres.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Union

import numpy as np

from .arrays import Array


@dataclass(frozen=True, eq=False)
class Sphere:
    """A sphere."""

    kind: ClassVar[str] = "sphere"
    radius: float
    """[m]"""


@dataclass(frozen=True, eq=False)
class Box:
    """A box."""

    kind: ClassVar[str] = "box"
    half_extents: Array
    """Half of each side, along x, y and z of the body. [m]"""


@dataclass(frozen=True, eq=False)
class Capsule:
    """All points within `radius` of a segment on the z axis."""

    kind: ClassVar[str] = "capsule"
    radius: float
    """[m]"""
    half_length: float
    """Half of the segment, without the caps. [m]"""


@dataclass(frozen=True, eq=False)
class Cylinder:
    """A cylinder with flat ends, along the z axis."""

    kind: ClassVar[str] = "cylinder"
    radius: float
    """[m]"""
    half_length: float
    """Half of its length. [m]"""


@dataclass(frozen=True, eq=False)
class Cone:
    """A cone with its apex at z = +half_height and its base at z = -half_height."""

    kind: ClassVar[str] = "cone"
    radius: float
    """Radius of the base. [m]"""
    half_height: float
    """[m]"""


@dataclass(frozen=True, eq=False)
class ConvexHull:
    """The convex hull of points. Some of them may lie inside it or on its faces."""

    kind: ClassVar[str] = "convex_hull"
    vertices: Array
    """One row of 3 coordinates in the body frame for each point. [m]"""


@dataclass(frozen=True, eq=False)
class HalfSpace:
    """The solid z <= 0 of the body frame."""

    kind: ClassVar[str] = "half_space"


Shape = Union[Sphere, Box, Capsule, Cylinder, Cone, ConvexHull, HalfSpace]


@dataclass(frozen=True, eq=False)
class Body:
    """A shape at a place in the world. Its arrays are read-only: copy what you change."""

    shape: Shape
    position: Array
    """Position of the body's origin in the world frame. [m]"""
    rotation: Array
    """3 x 3 matrix that takes coordinates of the body frame to those of the world frame.
    These nine numbers are the question."""
    quaternion: Array
    """The same rotation as w, x, y, z, for engines that take one."""

    def to_world(self, point: Array) -> Array:
        """Returns a point of the body frame in the world frame. [m]"""
        return np.asarray(self.position + self.rotation @ point)
