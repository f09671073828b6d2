"""Questions in JSON."""

from __future__ import annotations

from dataclasses import fields
from typing import Any, Dict, List, Tuple

from .arrays import from_json, read_only
from .shapes import (
    Body,
    Box,
    Capsule,
    Cone,
    ConvexHull,
    Cylinder,
    HalfSpace,
    Shape,
    Sphere,
)
from .world import (
    Anchor,
    Cloth,
    ClothSprings,
    Joint,
    Particle,
    Push,
    RigidBody,
    Spring,
    World,
)

_SHAPES: Dict[str, Any] = {
    shape.kind: shape
    for shape in (Sphere, Box, Capsule, Cylinder, Cone, ConvexHull, HalfSpace)
}


def queries_from(json: Any) -> List[Tuple[Body, Body]]:
    """Returns the pairs of bodies of a contact message, A first."""
    return [(body_from(query["A"]), body_from(query["B"])) for query in json]


def body_from(json: Any) -> Body:
    """Returns a body of a contact question."""
    return Body(_shape(json), *_pose(json))


def world_from(json: Any) -> World:
    """Returns the world of a world message."""
    return World(
        gravity=read_only(json["gravity"]),
        dt=float(json["dt"]),
        steps=json["steps"],
        sample_every=json["sample_every"],
        bodies=[_rigid_body(body) for body in json["bodies"]],
        particles=[_plain(Particle, particle) for particle in json["particles"]],
        springs=[_plain(Spring, spring) for spring in json["springs"]],
        joints=[_plain(Joint, joint) for joint in json["joints"]],
        cloths=[_plain(Cloth, cloth) for cloth in json["cloths"]],
        pushes=[_plain(Push, push) for push in json["pushes"]],
    )


def parameters_from(json: Any) -> Dict[str, float]:
    """Returns the values in force of parameters, by name."""
    return {name: from_json(value) for name, value in (json or {}).items()}


def _shape(json: Any) -> Shape:
    kind = json["shape"]
    if kind not in _SHAPES:
        raise ValueError(f"unknown shape {kind!r}")
    shape: Shape = _plain(_SHAPES[kind], json)
    return shape


def _pose(json: Any) -> Tuple[Any, Any, Any]:
    return (
        read_only(json["position"]),
        read_only(json["rotation"]),
        read_only(json["quaternion"]),
    )


def _rigid_body(json: Any) -> RigidBody:
    position, rotation, quaternion = _pose(json)
    return RigidBody(
        shape=_shape(json),
        position=position,
        rotation=rotation,
        quaternion=quaternion,
        name=json["name"],
        mass=json["mass"],
        inertia=read_only(json["inertia"]),
        velocity=read_only(json["velocity"]),
        spin=read_only(json["spin"]),
        restitution=json["restitution"],
        friction=json["friction"],
        force=read_only(json["force"]),
        collides=json["collides"],
    )


# The members of these classes that are no plain numbers, strings or vectors.
_MEMBERS: Dict[str, Any] = {
    "A": lambda json: _anchor(json),
    "B": lambda json: _anchor(json),
    "structural": lambda json: _plain(ClothSprings, json),
    "shear": lambda json: _plain(ClothSprings, json),
    "bend": lambda json: _plain(ClothSprings, json),
    "pinned": lambda json: [(row, column) for row, column in json],
}


def _plain(kind: Any, json: Any) -> Any:
    # The members of the class have the names of the keys, and keys that it has not are
    # ignored, as the protocol asks.
    return kind(**{field.name: _member(field.name, json[field.name]) for field in fields(kind)})


def _member(name: str, json: Any) -> Any:
    if name in _MEMBERS:
        return _MEMBERS[name](json)
    return read_only(json) if isinstance(json, list) else json


def _anchor(json: Any) -> Anchor:
    return Anchor(on=json["on"], index=json.get("index", -1), point=read_only(json["point"]))
