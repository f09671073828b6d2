"""The answer to a contact question."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional, Sequence

import numpy as np

from .arrays import WrongAnswer, number, vector


class Unsupported(Exception):
    """Raise it with the reason if the engine cannot answer a question.

    The question is then counted as unsupported, and is no failure.
    """


@dataclass
class ContactPoint:
    """One contact point, midway between the two surfaces."""

    position: Any
    """3 numbers, world frame. [m]"""
    separation: Any
    """Signed gap there: < 0 penetrating, > 0 apart. [m]"""
    normal: Any = None
    """Unit vector from A to B, if it is not that of the Contact."""


@dataclass
class Contact:
    """What an engine says about two bodies. Only `touching` is required.

    Lists, tuples, arrays and scalars of numpy in any precision are accepted. NaN is passed
    on, and Touchstone reports it.
    """

    touching: Any
    """Whether A and B share a point."""
    separation: Any = None
    """Signed: < 0 penetrating, 0 touching, > 0 apart. [m]"""
    normal: Any = None
    """Unit vector that points from A into B, world frame."""
    points: Sequence[ContactPoint] = ()
    """The contact points, in any order."""
    witnesses: Any = None
    """The point of A and the point of B that are nearest to each other, or deepest: two
    times 3 numbers, world frame. [m]"""


def checked(contact: Any) -> Contact:
    """Returns a Contact whose numbers are doubles. Raises WrongAnswer if it is none."""
    said = "contact() returned "
    if not isinstance(contact, Contact):
        raise WrongAnswer(f"{said}{type(contact).__name__}; expected a Contact")
    if not isinstance(contact.touching, (bool, np.bool_)):
        kind = type(contact.touching).__name__
        raise WrongAnswer(f"{said}touching of type {kind}; expected True or False")
    return Contact(
        touching=bool(contact.touching),
        separation=_optional_number(contact.separation, said + "separation"),
        normal=_optional_vector(contact.normal, said + "normal"),
        points=_points(contact.points, said),
        witnesses=_witnesses(contact.witnesses, said),
    )


def _optional_number(value: Any, what: str) -> Optional[float]:
    return None if value is None else number(value, what)


def _optional_vector(value: Any, what: str) -> Any:
    return None if value is None else vector(value, 3, what)


def _points(points: Any, said: str) -> Sequence[ContactPoint]:
    try:
        listed = list(points)
    except TypeError:
        kind = type(points).__name__
        raise WrongAnswer(f"{said}points of type {kind}; expected a list") from None
    return [_point(point, f"{said}points[{i}]") for i, point in enumerate(listed)]


def _point(point: Any, what: str) -> ContactPoint:
    if not isinstance(point, ContactPoint):
        kind = type(point).__name__
        raise WrongAnswer(f"{what} of type {kind}; expected a ContactPoint")
    return ContactPoint(
        position=vector(point.position, 3, what + ".position"),
        separation=number(point.separation, what + ".separation"),
        normal=_optional_vector(point.normal, what + ".normal"),
    )


def _witnesses(witnesses: Any, said: str) -> Any:
    if witnesses is None:
        return None
    try:
        of_A, of_B = witnesses
    except (TypeError, ValueError):
        raise WrongAnswer(f"{said}witnesses that are not two points") from None
    return (
        vector(of_A, 3, said + "witnesses[0]"),
        vector(of_B, 3, said + "witnesses[1]"),
    )
