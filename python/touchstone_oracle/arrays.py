"""Numbers from messages and from engines."""

from __future__ import annotations

import math
import numbers
from typing import Any, List, Union

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]
"""Doubles; a vector has 3, a quaternion has 4 in the order w, x, y, z."""


class WrongAnswer(Exception):
    """A method has returned something that is not an answer."""


def read_only(values: Any) -> Array:
    """Returns nested lists of numbers as an array that cannot be changed."""
    array = np.array(values, dtype=np.float64)
    # One question must leave the next as it is, and a world its own start.
    array.flags.writeable = False
    return array


def vector(value: Any, size: int, what: str) -> Array:
    """Returns `value` as an array of `size` doubles.

    `what` names it in the WrongAnswer that is raised if it is something else.
    """
    try:
        array = np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError):
        raise WrongAnswer(
            f"{what} of type {type(value).__name__}; expected {size} numbers"
        ) from None
    if array.shape != (size,):
        raise WrongAnswer(f"{what} of shape {array.shape}; expected {size} numbers")
    return array


def number(value: Any, what: str) -> float:
    """Returns `value` as a double. Raises WrongAnswer if it is not one number."""
    if isinstance(value, numbers.Real):  # Includes the scalars of numpy.
        return float(value)
    if isinstance(value, np.ndarray):
        if value.shape == () and value.dtype.kind in "fiu":
            return float(value)
        raise WrongAnswer(f"{what} of shape {value.shape}; expected a number")
    raise WrongAnswer(f"{what} of type {type(value).__name__}; expected a number")


def to_json(value: float) -> Union[float, str]:
    """Returns a double as it is written in JSON, which has no NaN and no infinity."""
    if math.isfinite(value):
        return value
    if math.isnan(value):
        return "NaN"
    return "Infinity" if value > 0 else "-Infinity"


def list_to_json(values: Array) -> List[Union[float, str]]:
    """Returns the doubles of an array as they are written in JSON."""
    if np.isfinite(values).all():
        return list(values.tolist())
    return [to_json(value) for value in values.tolist()]


def from_json(value: Any) -> float:
    """Returns a double from JSON. It may be "NaN", "Infinity", "-Infinity", or null."""
    return math.nan if value is None else float(value)
