"""The base class of oracles, and what one says about itself."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Dict, Mapping, Optional, Sequence, Tuple

from .contact import Contact
from .motion import Motion
from .shapes import Body
from .simulation import Simulation, run_to_end
from .world import World


@dataclass(frozen=True)
class DocumentedError:
    """An error of separations beyond rounding that the engine's documentation states."""

    length: float
    """[m]"""
    share: float
    """A fraction of the separation."""
    by: str
    """Where it is documented."""


@dataclass(frozen=True)
class Documented:
    """A number that the engine's documentation states."""

    value: float
    by: str
    """Where it is documented."""


@dataclass(frozen=True)
class Setting:
    """One value that the oracle sets or converts, for `touchstone oracles --settings`."""

    name: str
    value: str
    why: str


@dataclass(frozen=True)
class Parameter:
    """A number that `touchstone --set` may choose for worlds."""

    name: str
    here: float
    """The value that the oracle sets."""
    shipped: float
    """The default of the engine."""
    least: float
    most: float
    what: str
    """What it is, with its unit."""
    why: str
    """Why the oracle sets it."""
    whole: bool = False


@dataclass(frozen=True)
class Capability:
    """What an oracle promises for some pairs of shapes. See Oracle for its members."""

    pairs: Sequence[Tuple[str, str]] = ()
    shapes: Sequence[str] = ()
    gives: Sequence[str] = ()
    family: str = ""
    documented_error: Optional[DocumentedError] = None
    unsupported: str = ""
    """The reason, if the pairs are not answered."""


class Oracle:
    """An engine that Touchstone asks. Derive yours from it and pass it to serve().

    Define contact() to answer contact questions, with `pairs` or `shapes` and `gives`.
    Define begin() or simulate() to move worlds, with `supports`. The class attributes
    describe the oracle; docs/oracle_protocol.md defines them.
    """

    name: str = ""
    """The default is the name of the class in lower case."""
    library: str = ""
    """The engine. The default is `name`."""
    version: str = "unversioned"
    """The version that the library itself reports."""
    precision: str = "double"
    """"double" or "float": the arithmetic of the engine, whose rounding it is granted."""
    subtracts_first: bool = False
    """Whether contacts are computed from the difference of the two positions."""
    settings: Sequence[Setting] = ()
    frames: bool = True
    """False: all messages are JSON, which a person can read."""

    pairs: Sequence[Tuple[str, str]] = ()
    """Pairs of shapes, that of A first, e.g. [("sphere", "box"), ("box", "sphere")]."""
    shapes: Sequence[str] = ()
    """Instead of `pairs`: all pairs of these shapes."""
    gives: Sequence[str] = ()
    """The fields that it promises: "depth" (the separation of bodies that overlap),
    "distance" (that of bodies apart), "normal", "manifold", "witnesses",
    "penetrating_witnesses"."""
    family: str = ""
    """The algorithm, e.g. "gjk_epa". Oracles of one family have one vote where engines vote.
    The default is `name`."""
    documented_error: Optional[DocumentedError] = None
    capabilities: Sequence[Capability] = ()
    """Instead of the attributes above, if pairs differ in what they promise."""

    supports: Sequence[str] = ()
    """The features of worlds that it simulates beyond gravity and free motion: "sphere",
    "box", "capsule", "cylinder", "cone", "convex hull", "static sphere", "static box",
    "static capsule", "static cylinder", "static cone", "static convex hull",
    "static half-space", "stated inertia", "restitution", "friction", "unequal friction",
    "two moving bodies that may meet", "force", "particle", "spring", "distance joint",
    "cloth", "push"."""
    unsupported: Mapping[str, str] = {}
    """The reason for each feature that is missing."""
    parameters: Sequence[Parameter] = ()
    softness: str = ""
    """The name of the parameter that is the speed at which contacts yield, per force, in
    m/(N s). Leave it out if they are rigid."""
    slop: Optional[Documented] = None
    """The depth at which bodies are left in contact. [m]"""
    sleep_speed: Optional[Documented] = None
    """The speed below which a body is put to sleep. [m/s]"""
    order: Optional[Documented] = None
    """The order of its scheme in the step, if it is not 1."""
    rotation_error: Optional[Documented] = None
    """The documented relative error of energy and angular momentum in a step of free
    rotation."""

    def contact(self, A: Body, B: Body) -> Contact:
        """Answers one contact question. Normals point from A to B, in the world frame.

        Raise Unsupported if the engine cannot answer it. Any other exception is a failure
        of this question only. The answer must depend on A and B alone.
        """
        raise NotImplementedError(f"{type(self).__name__} has no contact()")

    def begin(self, world: World, parameters: Dict[str, float]) -> Simulation:
        """Returns a simulation at the start of `world`, which the package runs to its end.

        `parameters` has the value in force of each of the oracle's parameters.
        """
        raise NotImplementedError(f"{type(self).__name__} has no begin()")

    def simulate(self, world: World, parameters: Dict[str, float]) -> Motion:
        """Returns the whole motion of `world`. The default runs begin() to the end.

        Define it instead of begin() if the engine does not move step by step.
        """
        return run_to_end(self.begin(world, parameters), world)
