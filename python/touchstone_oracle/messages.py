"""Messages: a line of JSON, and the doubles that follow it if the line says so."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any, BinaryIO, Dict, Optional

import numpy as np

from .arrays import Array

_LITTLE_ENDIAN = np.dtype("<f8")


class MalformedMessage(Exception):
    """A line that is no message."""


@dataclass
class Message:
    """A message from Touchstone."""

    line: Dict[str, Any]
    frame: Array
    """The doubles after the line. It is read-only, and empty if there are none."""


def read_message(input: BinaryIO) -> Optional[Message]:
    """Returns the next message; None at the end of the input."""
    text = input.readline()
    if not text.endswith(b"\n"):
        return None  # The end, or a line that was cut off by it.
    try:
        line = json.loads(text)
    except ValueError as error:
        raise MalformedMessage(f"expected a line of JSON: {error}") from None
    if not isinstance(line, dict):
        raise MalformedMessage("expected an object in JSON")
    size = line.get("frame") or 0
    if not isinstance(size, int) or size < 0 or size % 8 != 0:
        raise MalformedMessage(f"frame of {size} bytes; expected a multiple of 8")
    frame = input.read(size) if size else b""
    if len(frame) < size:
        return None
    return Message(line, np.frombuffer(frame, dtype=_LITTLE_ENDIAN))


def write_message(output: BinaryIO, line: Dict[str, Any], frame: Optional[Array]) -> None:
    """Writes an answer and flushes it."""
    numbers = b"" if frame is None else frame.astype(_LITTLE_ENDIAN, copy=False).tobytes()
    if numbers:
        line = {**line, "frame": len(numbers)}
    # Escapes everything but ASCII, so that a name of a file that is not UTF-8 does no harm.
    text = json.dumps(line, allow_nan=False, separators=(",", ":"))
    output.write(text.encode("ascii") + b"\n" + numbers)
    output.flush()
