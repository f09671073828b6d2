"""Questions put to an oracle, and answers in JSON."""

from __future__ import annotations

import traceback
from dataclasses import dataclass
from typing import Any, Dict, List, Sequence, Union

from .arrays import WrongAnswer, list_to_json, to_json
from .contact import Contact, Unsupported, checked
from .motion import Motion, impulse_row, row_of
from .oracle import Oracle
from .shapes import Body
from .world import World


@dataclass(frozen=True)
class Refusal:
    """The reason why there is no answer."""

    status: str
    """"unsupported" or "error"."""
    reason: str


Answer = Union[Contact, Refusal]


def answer_contact(oracle: Oracle, A: Body, B: Body) -> Answer:
    """Asks `oracle`. No exception of its engine gets out, only one that ends the program."""
    try:
        return checked(oracle.contact(A, B))
    except Exception as exception:
        return refusal(exception)


def refusal(exception: Exception) -> Refusal:
    """Returns what an exception means. Where it was raised goes to standard error."""
    if isinstance(exception, Unsupported):
        return Refusal("unsupported", str(exception) or "it gave no reason")
    if isinstance(exception, WrongAnswer):
        return Refusal("error", str(exception))
    traceback.print_exception(type(exception), exception, exception.__traceback__)
    return Refusal("error", f"{type(exception).__name__}: {exception}")


def put_answers(answers: Sequence[Answer]) -> Dict[str, Any]:
    """Returns the line of the answers to contact questions."""
    return {"answers": [_answer(answer) for answer in answers]}


def _answer(answer: Answer) -> Dict[str, Any]:
    if isinstance(answer, Refusal):
        return {answer.status: answer.reason}
    json: Dict[str, Any] = {"touching": answer.touching}
    if answer.normal is not None:
        json["normal"] = list_to_json(answer.normal)
    if answer.separation is not None:
        json["separation"] = to_json(answer.separation)
    if answer.points:
        json["points"] = [_point(point) for point in answer.points]
    if answer.witnesses is not None:
        json["witnesses"] = [list_to_json(point) for point in answer.witnesses]
    return json


def _point(point: Any) -> Dict[str, Any]:
    json = {
        "position": list_to_json(point.position),
        "separation": to_json(point.separation),
    }
    if point.normal is not None:
        json["normal"] = list_to_json(point.normal)
    return json


def put_motion(motion: Motion, world: World) -> Dict[str, Any]:
    """Returns the line of the answer to a world."""
    samples: List[Any] = []
    for i, sample in enumerate(motion.samples):
        row = row_of(sample, world, f"simulate() returned samples[{i}].")
        samples.append(list_to_json(row))
    line: Dict[str, Any] = {
        "times": [to_json(float(time)) for time in motion.times],
        "samples": samples,
    }
    if motion.impulses is not None:
        line["impulses"] = [
            list_to_json(impulse_row(impulse, f"simulate() returned impulses[{i}]"))
            for i, impulse in enumerate(motion.impulses)
        ]
    if motion.diverged_at_step is not None:
        line["diverged_at_step"] = motion.diverged_at_step
    if motion.complaint:
        line["complaint"] = motion.complaint
    return line
