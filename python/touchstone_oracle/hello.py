"""The answer to hello: what an oracle says about itself."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any, Dict, List

from .arrays import to_json
from .oracle import Capability, DocumentedError, Oracle, Parameter

PROTOCOL = 1
"""The version of the protocol that this package speaks."""


def hello(oracle: Oracle) -> Dict[str, Any]:
    """Returns the description of `oracle` in the words of the protocol."""
    kind = type(oracle)
    name = oracle.name or kind.__name__.lower()
    line: Dict[str, Any] = {
        "protocol": PROTOCOL,
        "name": name,
        "library": oracle.library or name,
        "version": oracle.version,
        "precision": oracle.precision,
        "subtracts_first": oracle.subtracts_first,
        "frames": oracle.frames,
        "settings": [asdict(setting) for setting in oracle.settings],
    }
    if kind.contact is not Oracle.contact:
        line["contact"] = [_capability(c, name) for c in _capabilities(oracle)]
    if kind.begin is not Oracle.begin or kind.simulate is not Oracle.simulate:
        line["world"] = _world(oracle)
    if "contact" not in line and "world" not in line:
        raise TypeError(f"{kind.__name__} defines none of contact(), begin(), simulate()")
    return line


def _capabilities(oracle: Oracle) -> List[Capability]:
    if oracle.capabilities:
        return list(oracle.capabilities)
    if not oracle.pairs and not oracle.shapes:
        kind = type(oracle).__name__
        raise TypeError(f"{kind} has contact() but no pairs, shapes or capabilities")
    return [
        Capability(
            pairs=oracle.pairs,
            shapes=oracle.shapes,
            gives=oracle.gives,
            family=oracle.family,
            documented_error=oracle.documented_error,
        )
    ]


def _capability(capability: Capability, name: str) -> Dict[str, Any]:
    json: Dict[str, Any] = {}
    if capability.shapes:
        json["shapes"] = list(capability.shapes)
    else:
        json["pairs"] = [list(pair) for pair in capability.pairs]
    if capability.unsupported:
        json["unsupported"] = capability.unsupported
        return json
    json["family"] = capability.family or name
    json["gives"] = list(capability.gives)
    if capability.documented_error is not None:
        json["documented_error"] = _documented_error(capability.documented_error)
    return json


def _documented_error(error: DocumentedError) -> Dict[str, Any]:
    return {
        "length": to_json(float(error.length)),
        "share": to_json(float(error.share)),
        "by": error.by,
    }


def _world(oracle: Oracle) -> Dict[str, Any]:
    json: Dict[str, Any] = {
        "supports": list(oracle.supports),
        "unsupported": dict(oracle.unsupported),
        "parameters": [_parameter(parameter) for parameter in oracle.parameters],
    }
    if oracle.softness:
        json["softness"] = oracle.softness
    for key, number_key in (
        ("slop", "length"),
        ("sleep_speed", "speed"),
        ("order", "order"),
        ("rotation_error", "error"),
    ):
        documented = getattr(oracle, key)
        if documented is not None:
            value = to_json(float(documented.value))
            json[key] = {number_key: value, "by": documented.by}
    return json


def _parameter(parameter: Parameter) -> Dict[str, Any]:
    json = asdict(parameter)
    for key in ("here", "shipped", "least", "most"):
        json[key] = to_json(float(json[key]))
    return json
