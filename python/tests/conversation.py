"""A conversation with an oracle, as Touchstone has it."""

from __future__ import annotations

import io
import json
from typing import Any, Dict, List, Optional, Sequence, Tuple

import numpy as np

from touchstone_oracle import Oracle, serve

IDENTITY = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
KINDS = ["sphere", "box", "capsule", "cylinder", "cone", "convex_hull", "half_space"]
SIZES = ["radius", "half_extents", "half_length", "half_height", "vertices"]

Json = Dict[str, Any]


def ball(x: float, radius: float = 1.0) -> Json:
    """Returns a sphere on the x axis."""
    return body("sphere", position=[x, 0.0, 0.0], radius=radius)


def body(shape: str, position: Sequence[float] = (0.0, 0.0, 0.0), **sizes: Any) -> Json:
    """Returns a body of a contact question."""
    return {
        "shape": shape,
        **sizes,
        "position": list(position),
        "rotation": IDENTITY,
        "quaternion": [1.0, 0.0, 0.0, 0.0],
    }


def frame_of(queries: Sequence[Tuple[Json, Json]]) -> bytes:
    """Returns the queries as doubles."""
    numbers: List[float] = []
    for query in queries:
        for one in query:
            sizes = np.concatenate([np.ravel(one[key]) for key in SIZES if key in one] or [[]])
            numbers += [KINDS.index(one["shape"]), *one["position"]]
            numbers += [*np.ravel(one["rotation"]), *one["quaternion"], len(sizes), *sizes]
    return np.array(numbers, dtype="<f8").tobytes()


def say(oracle: Oracle, sent: bytes) -> List[Tuple[Json, Any]]:
    """Returns the lines that `oracle` answers, each with the doubles after it."""
    output = io.BytesIO()
    serve(oracle, io.BytesIO(sent), output)
    output.seek(0)
    answers = []
    for text in iter(output.readline, b""):
        line = json.loads(text, parse_constant=lambda name: 1 / 0)
        answers.append((line, np.frombuffer(output.read(line.get("frame", 0)), dtype="<f8")))
    return answers


def line_of(message: Json, frame: bytes = b"") -> bytes:
    """Returns a message as Touchstone sends it."""
    if frame:
        message = {**message, "frame": len(frame)}
    return json.dumps(message).encode() + b"\n" + frame


def ask(oracle: Oracle, message: Json, frame: bytes = b"") -> Tuple[Json, Any]:
    """Returns the answer to one message."""
    (answer,) = say(oracle, line_of(message, frame))
    return answer


def contact(oracle: Oracle, A: Optional[Json] = None, B: Optional[Json] = None) -> Json:
    """Returns the answer to one contact question in JSON."""
    query = {"A": A or ball(0.0), "B": B or ball(1.5)}
    line, _ = ask(oracle, {"id": 1, "method": "contact", "queries": [query]})
    (answer,) = line["answers"]
    return answer


def contact_in_frame(oracle: Oracle, A: Json, B: Json) -> Tuple[Json, Any]:
    """Returns the line and the doubles of the answer to one contact question in a frame."""
    message = {"id": 1, "method": "contact", "count": 1}
    return ask(oracle, message, frame_of([(A, B)]))
