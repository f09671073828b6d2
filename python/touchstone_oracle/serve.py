"""The conversation with Touchstone."""

from __future__ import annotations

import sys
from typing import Any, BinaryIO, Dict, Optional, Tuple

from . import answers, frames
from ._standard_output import answer_stream
from .arrays import Array, WrongAnswer
from .hello import hello
from .messages import MalformedMessage, Message, read_message, write_message
from .motion import Motion
from .oracle import Oracle
from .questions import parameters_from, queries_from, world_from


def serve(
    oracle: Oracle,
    input: Optional[BinaryIO] = None,
    output: Optional[BinaryIO] = None,
) -> None:
    """Answers the questions of Touchstone until "bye" or the end of the input.

    The streams are standard input and output unless others are given. Import this package
    before the engine: from then on, all that is printed goes to standard error.
    """
    source = sys.stdin.buffer if input is None else input
    sink = answer_stream() if output is None else output
    while True:
        identity: Any = None
        frame: Optional[Array] = None
        try:
            message = read_message(source)
            if message is None or message.line.get("method") == "bye":
                return
            identity = message.line.get("id")
            line, frame = _answer(oracle, message)
        except MalformedMessage as malformed:
            line = {"error": str(malformed)}
        try:
            write_message(sink, {"id": identity, **line}, frame)
        except BrokenPipeError:
            return  # Touchstone has ended, and no one is left to answer.


def _answer(oracle: Oracle, message: Message) -> Tuple[Dict[str, Any], Optional[Array]]:
    methods = {"hello": _hello, "contact": _contact, "world": _world}
    method = message.line.get("method")
    if not isinstance(method, str) or method not in methods:
        expected = "hello, contact, world or bye"
        return {"error": f"unknown method {method!r}; expected {expected}"}, None
    try:
        return methods[method](oracle, message)
    except Exception as exception:
        refusal = answers.refusal(exception)
        return {refusal.status: refusal.reason}, None


def _hello(oracle: Oracle, message: Message) -> Tuple[Dict[str, Any], Optional[Array]]:
    return hello(oracle), None


def _contact(oracle: Oracle, message: Message) -> Tuple[Dict[str, Any], Optional[Array]]:
    # The answer has the form of the question.
    in_frame = "queries" not in message.line
    if in_frame:
        queries = frames.queries_from_frame(message.frame, message.line["count"])
    else:
        queries = queries_from(message.line["queries"])
    given = [answers.answer_contact(oracle, A, B) for A, B in queries]
    return frames.put_answers(given) if in_frame else (answers.put_answers(given), None)


def _world(oracle: Oracle, message: Message) -> Tuple[Dict[str, Any], Optional[Array]]:
    world = world_from(message.line["world"])
    parameters = parameters_from(message.line.get("parameters"))
    motion = oracle.simulate(world, parameters)
    if not isinstance(motion, Motion):
        kind = type(motion).__name__
        raise WrongAnswer(f"simulate() returned {kind}; expected a Motion")
    if message.line.get("in_frame"):
        return frames.put_motion(motion, world)
    return answers.put_motion(motion, world), None
