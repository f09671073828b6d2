"""Makes an engine that Python can call an oracle of Touchstone.

    from touchstone_oracle import Contact, Oracle, serve

    class Mine(Oracle):
        shapes = ["sphere", "box"]
        gives = ["depth", "normal"]

        def contact(self, A, B):
            ...
            return Contact(touching=True, separation=-0.1, normal=[1, 0, 0])

    serve(Mine())

Import this package before the engine. It points descriptor 1 at standard error, so that an
engine that prints when it is loaded or run does no harm.

Units are SI, frames are right-handed, quaternions are ordered w, x, y, z.
"""

# The first import: other modules may print when they are loaded.
from . import _standard_output as _standard_output  # isort: skip
from .contact import Contact, ContactPoint, Unsupported
from .motion import (
    BodyState,
    ContactImpulse,
    Motion,
    PointState,
    WorldState,
)
from .oracle import (
    Capability,
    Documented,
    DocumentedError,
    Oracle,
    Parameter,
    Setting,
)
from .serve import serve
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
from .simulation import Simulation, run_to_end
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

__all__ = [
    "Anchor",
    "Body",
    "BodyState",
    "Box",
    "Capability",
    "Capsule",
    "Cloth",
    "ClothSprings",
    "Cone",
    "Contact",
    "ContactImpulse",
    "ContactPoint",
    "ConvexHull",
    "Cylinder",
    "Documented",
    "DocumentedError",
    "HalfSpace",
    "Joint",
    "Motion",
    "Oracle",
    "Parameter",
    "Particle",
    "PointState",
    "Push",
    "RigidBody",
    "Setting",
    "Shape",
    "Simulation",
    "Sphere",
    "Spring",
    "Unsupported",
    "World",
    "WorldState",
    "run_to_end",
    "serve",
]
