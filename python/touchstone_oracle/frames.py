"""Questions and answers as doubles after a line, which cost less than JSON."""

from __future__ import annotations

from typing import Any, Dict, List, Sequence, Tuple

import numpy as np

from .answers import Answer, Refusal
from .arrays import Array, WrongAnswer, vector
from .contact import Contact
from .motion import Motion, impulse_row, row_of
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
from .world import World

_HEAD = 18  # Numbers of a body before its sizes: kind, 3, 9, 4, and the number of sizes.
_ZERO = [0.0, 0.0, 0.0]


def queries_from_frame(frame: Array, count: int) -> List[Tuple[Body, Body]]:
    """Returns the pairs of bodies in the frame of a contact message, A first."""
    # Python is much faster with its own numbers than with single elements of an array.
    numbers = frame.tolist()
    bodies: List[Body] = []
    at = 0
    for _ in range(2 * count):
        sizes_at = at + _HEAD
        if sizes_at > len(numbers):
            raise ValueError(f"a frame of {len(numbers)} numbers ends in a body")
        end = sizes_at + int(numbers[sizes_at - 1])
        bodies.append(
            Body(
                _shape(int(numbers[at]), frame[sizes_at:end], numbers[sizes_at:end]),
                frame[at + 1 : at + 4],
                frame[at + 4 : at + 13].reshape(3, 3),
                frame[at + 13 : at + 17],
            )
        )
        at = end
    if at != len(numbers):
        raise ValueError(f"a frame of {len(numbers)} numbers; expected {at}")
    return list(zip(bodies[::2], bodies[1::2]))


def _shape(kind: int, sizes: Array, numbers: List[float]) -> Shape:
    if kind == 0:
        return Sphere(*numbers)
    if kind == 1:
        return Box(vector(sizes, 3, "half extents"))
    if kind == 2:
        return Capsule(*numbers)
    if kind == 3:
        return Cylinder(*numbers)
    if kind == 4:
        return Cone(*numbers)
    if kind == 5:
        return ConvexHull(sizes.reshape(-1, 3))
    if kind == 6:
        return HalfSpace()
    raise ValueError(f"unknown shape {kind} in a frame")


def put_answers(answers: Sequence[Answer]) -> Tuple[Dict[str, Any], Array]:
    """Returns the line and the frame of the answers to contact questions."""
    line: Dict[str, Any] = {"count": len(answers)}
    reasons: Dict[str, str] = {}
    numbers: List[float] = []
    for i, answer in enumerate(answers):
        if isinstance(answer, Refusal):
            reasons[str(i)] = answer.reason
            status = 1.0 if answer.status == "unsupported" else 2.0
            numbers += [status] + 13 * [0.0]
        else:
            _append(answer, numbers)
    if reasons:
        line["reasons"] = reasons
    return line, np.array(numbers, dtype=np.float64)


def _append(contact: Contact, numbers: List[float]) -> None:
    witnesses = contact.witnesses
    given = (
        (contact.normal is not None)
        + 2 * (contact.separation is not None)
        + 4 * (witnesses is not None)
    )
    numbers += [0.0, float(contact.touching), float(given)]
    numbers += _ZERO if contact.normal is None else contact.normal.tolist()
    numbers.append(0.0 if contact.separation is None else contact.separation)
    for i in range(2):
        numbers += _ZERO if witnesses is None else witnesses[i].tolist()
    numbers.append(float(len(contact.points)))
    for point in contact.points:
        numbers += point.position.tolist()
        numbers += [point.separation, float(point.normal is not None)]
        numbers += _ZERO if point.normal is None else point.normal.tolist()


def put_motion(motion: Motion, world: World) -> Tuple[Dict[str, Any], Array]:
    """Returns the line and the frame of the answer to a world."""
    line: Dict[str, Any] = {"sample_count": len(motion.samples)}
    if motion.diverged_at_step is not None:
        line["diverged_at_step"] = motion.diverged_at_step
    if motion.complaint:
        line["complaint"] = motion.complaint
    if len(motion.times) != len(motion.samples):
        count = f"{len(motion.times)} times of {len(motion.samples)} samples"
        raise WrongAnswer(f"simulate() returned {count}; expected one each")
    rows: List[Array] = []
    for i, (time, sample) in enumerate(zip(motion.times, motion.samples)):
        rows.append(np.array([time], dtype=np.float64))
        rows.append(row_of(sample, world, f"simulate() returned samples[{i}]."))
    if motion.impulses is not None:
        line["impulse_count"] = len(motion.impulses)
        for i, impulse in enumerate(motion.impulses):
            rows.append(impulse_row(impulse, f"simulate() returned impulses[{i}]"))
    return line, np.concatenate(rows) if rows else np.empty(0)
