"""Coal, the successor of hpp-fcl: signed distances with witnesses, and contact patches."""

from touchstone_oracle import (
    Capability, Contact, ContactPoint, DocumentedError, Oracle, Setting, Unsupported,
    serve,
)

import coal
import numpy as np

SHAPES = ("sphere", "box", "capsule", "cylinder", "cone", "convex_hull", "half_space")
# Pairs without half-spaces that have a closed form: the files of src/distance/ in Coal.
CLOSED = [{"sphere"}, {"sphere", "box"}, {"sphere", "cylinder"}, {"sphere", "capsule"},
          {"capsule"}]
PATCH_TOLERANCE = 1e-6  # Coal's default is 1e-3. [m]
SAMPLES = 12  # Points on the rim of a curved face, Coal's default.


def to_coal(shape):
    if shape.kind == "sphere":
        return coal.Sphere(shape.radius)
    if shape.kind == "box":
        return coal.Box(*(2 * shape.half_extents))
    if shape.kind == "capsule":
        return coal.Capsule(shape.radius, 2 * shape.half_length)
    if shape.kind == "cylinder":
        return coal.Cylinder(shape.radius, 2 * shape.half_length)
    if shape.kind == "cone":
        return coal.Cone(shape.radius, 2 * shape.half_height)
    if shape.kind == "half_space":
        return coal.Halfspace(np.array([0.0, 0.0, 1.0]), 0.0)
    vertices = coal.StdVec_Vec3s()
    for vertex in shape.vertices:
        vertices.append(vertex)
    try:
        return coal.Convex.convexHull(vertices, True, None)
    except ValueError:
        raise Unsupported("Coal's Qhull makes no hull of fewer than four points or flat ones")


def place_of(body):
    return coal.Transform3s(np.array(body.rotation), np.array(body.position))


def capability(a, b):
    family = "gjk_epa"
    if "half_space" in (a, b) or {a, b} in CLOSED:
        family = "closed_form"
    error = None
    if family == "gjk_epa":
        error = DocumentedError(
            1e-6, 1e-6, "GJK_DEFAULT_TOLERANCE and EPA_DEFAULT_TOLERANCE, "
            "coal/narrowphase/narrowphase_defaults.h: precise up to the micrometre")
    gives = ["depth", "distance", "normal", "witnesses", "penetrating_witnesses"]
    if (a, b) != ("half_space", "half_space"):
        gives.append("manifold")
    return Capability([(a, b)], gives=gives, family=family, documented_error=error)


class Coal(Oracle):
    name = "coal"
    library = "Coal"
    version = coal.__version__
    capabilities = [capability(a, b) for a in SHAPES for b in SHAPES]
    settings = [
        Setting("entry point", "coal.distance, signed",
                "The separation, normal and witnesses; touching if it is not positive."),
        Setting("contacts", "coal.computeContactPatch on coal.collide, midway",
                "One patch, all of whose points have the depth of the patch."),
        Setting("patch tolerance", f"{PATCH_TOLERANCE:g} m",
                "Coal's default of 1e-3 adds points that do not touch."),
        Setting("patch samples of a curved face", str(SAMPLES), "Coal's default."),
        Setting("GJK, EPA", "tolerance 1e-6, 128 and 64 iterations, default guess",
                "Coal's defaults; it advises against less. No guess of an earlier question."),
        Setting("sizes", "doubled", "Coal takes full sizes."),
        Setting("half-space", "Halfspace(z, 0)", "n x <= d is solid."),
        Setting("convex hull", "Convex.convexHull", "Qhull finds the hull."),
        Setting("swept_sphere_radius, security_margin", "0", "Coal's defaults."),
        Setting("pose", "the rotation matrix itself", "A quaternion would round it."),
    ]

    def contact(self, A, B):
        shapes = to_coal(A.shape), to_coal(B.shape)
        asked = shapes[0], place_of(A), shapes[1], place_of(B)
        result = coal.DistanceResult()
        separation = coal.distance(*asked, coal.DistanceRequest(), result)
        witnesses = result.getNearestPoint1(), result.getNearestPoint2()
        touching = separation <= 0
        spaces = A.shape.kind == B.shape.kind == "half_space"
        points = patch(asked) if touching and not spaces else []
        return Contact(touching, separation, result.normal.copy(), points, witnesses)


def patch(asked):
    """Returns the corners of the contact patch."""
    collisions = coal.CollisionResult()
    request = coal.CollisionRequest(coal.CollisionRequestFlag.CONTACT, 1)
    coal.collide(*asked, request, collisions)
    patches = coal.ContactPatchResult()
    coal.computeContactPatch(
        *asked, collisions, coal.ContactPatchRequest(1, SAMPLES, PATCH_TOLERANCE), patches)
    points = []
    for i in range(patches.numContactPatches()):
        found = patches.getContactPatch(i)
        points += [ContactPoint(found.getPoint(j).copy(), found.penetration_depth,
                                found.getNormal().copy()) for j in range(found.size())]
    return points


if __name__ == "__main__":
    serve(Coal())
