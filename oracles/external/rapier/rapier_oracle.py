"""Rapier in single precision: the manifolds of its narrow phase, and worlds."""

from touchstone_oracle import (
    BodyState, Capability, Contact, ContactPoint, Oracle, Parameter, Setting, Simulation,
    Unsupported, serve,
)

import numpy as np
import rapier3d as rapier

SHAPES = ("sphere", "box", "capsule", "cylinder", "cone", "convex_hull", "half_space")
# Rapier's cylinders and cones are along y; this turns y to z.
Y_TO_Z = rapier.Rotation3.from_axis_angle(rapier.Vec3(1.0, 0.0, 0.0), np.pi / 2)


def vec(v):
    return rapier.Vec3(*(float(x) for x in v))


def pose(body):
    w, x, y, z = (float(q) for q in body.quaternion)
    return rapier.Isometry3(vec(body.position), rapier.Rotation3(w, x, y, z))


def to_rapier(shape):
    shapes = rapier.SharedShape
    if shape.kind == "sphere":
        return shapes.ball(shape.radius)
    if shape.kind == "box":
        return shapes.cuboid(*shape.half_extents)
    if shape.kind == "capsule":
        return shapes.capsule_z(shape.half_length, shape.radius)
    if shape.kind == "cylinder":
        return shapes.cylinder(shape.half_length, shape.radius)
    if shape.kind == "cone":
        return shapes.cone(shape.half_height, shape.radius)
    if shape.kind == "half_space":
        return shapes.halfspace(rapier.Vec3(0.0, 0.0, 1.0))
    try:
        return shapes.convex_hull(np.array(shape.vertices, dtype=np.float32))
    except rapier.MeshConversionError as refusal:
        raise Unsupported(f"Rapier refuses the hull: {refusal}") from None


def collider(shape):
    one = rapier.Collider.new(to_rapier(shape)).density(0.0)
    if shape.kind in ("cylinder", "cone"):
        one = one.position(rapier.Isometry3(rapier.Vec3(0.0, 0.0, 0.0), Y_TO_Z))
    return one


def array(v):
    return np.array([v.x, v.y, v.z])


class World(Simulation):
    def __init__(self, world, values):
        self.asked = world
        self.world = rapier.PhysicsWorld(vec(world.gravity))
        settings = self.world.integration_parameters
        settings.dt = world.dt
        settings.num_solver_iterations = int(values["iterations"])
        settings.num_internal_pgs_iterations = int(values["pgs_iterations"])
        settings.normalized_allowed_linear_error = values["allowed_error"]
        settings.normalized_max_corrective_velocity = values["max_corrective_velocity"]
        settings.normalized_max_linear_velocity = values["max_velocity"]
        settings.normalized_prediction_distance = values["prediction"]
        settings.contact_recycling = values["contact_recycling"] != 0
        settings.contact_clustering = values["contact_clustering"] != 0
        settings.max_ccd_substeps = int(values["ccd_substeps"])
        model = rapier.FrictionModel
        settings.friction_model = model.COULOMB if values["coulomb"] else model.SIMPLIFIED
        damping = values["contact_damping"]
        settings.contact_softness = rapier.SpringCoefficients(
            values["contact_frequency"], damping)
        settings.static_contact_softness = rapier.SpringCoefficients(
            values["static_contact_frequency"], damping)
        rules = rapier.CoefficientCombineRule
        self.handles = []
        for asked in world.bodies:
            moves = asked.mass > 0
            body = rapier.RigidBody.dynamic() if moves else rapier.RigidBody.fixed()
            body = body.position(pose(asked)).can_sleep(values["sleeping"] != 0)
            if moves:
                body = body.linvel(vec(asked.velocity)).angvel(vec(asked.spin))
                body = body.gyroscopic_forces(values["gyroscopic"] != 0)
                body = body.ccd_enabled(values["ccd"] != 0)
                body = body.allow_fast_rotation(values["fast_rotation"] != 0)
                body = body.additional_mass_properties(rapier.MassProperties(
                    rapier.Point3(0.0, 0.0, 0.0), asked.mass, vec(asked.inertia)))
            shapes = []
            if asked.collides:
                shapes = [collider(asked.shape).restitution(asked.restitution)
                          .friction(asked.friction)
                          .restitution_combine_rule(rules.MIN)
                          .friction_combine_rule(rules.GEOMETRIC_MEAN)]
            self.handles.append(self.world.add_body(body, shapes))
            if moves and asked.force.any():
                self.body(-1).add_force(vec(asked.force), True)

    def body(self, index):
        return self.world.rigid_bodies[self.handles[index]]

    def push(self, body, point, impulse):
        self.body(body).apply_impulse_at_point(
            vec(impulse), rapier.Point3(*(float(x) for x in point)), True)

    def step(self):
        self.world.step()

    def read(self):
        states = []
        for i in range(len(self.handles)):
            body = self.body(i)
            q = body.rotation
            states.append(BodyState(array(body.translation), [q.w, q.i, q.j, q.k],
                                    array(body.linvel), array(body.angvel)))
        return states


def parameter(name, here, shipped, least, most, what, why="Rapier's default.", whole=False):
    return Parameter(name, here, shipped, least, most, what, why, whole)


class Rapier(Oracle):
    name = "rapier"
    library = "Rapier"
    version = rapier.__version__
    precision = "float"
    subtracts_first = True
    capabilities = [
        Capability([(a, b)], gives=["depth", "normal", "manifold"],
                   family="box_box_sat" if (a, b) == ("box", "box") else
                   "closed_form" if "half_space" in (a, b) or {a, b} <= {"sphere", "capsule"}
                   else "gjk_epa")
        for a in SHAPES for b in SHAPES if (a, b) != ("half_space", "half_space")
    ] + [Capability([("half_space", "half_space")],
                    unsupported="Rapier does not collide half-spaces")]
    settings = [
        Setting("entry point", "PhysicsWorld.detect_collisions, NarrowPhase.contact_pair",
                "The package gives no queries of two shapes."),
        Setting("contacts", "those of the manifold that are not apart",
                "A manifold also has points up to the prediction distance."),
        Setting("contact position", "midway between the points on A and on B", "Rapier has "
                "both."),
        Setting("normal", "local_n1 of the manifold, negated if A is its second body",
                "It points out of the first body."),
        Setting("cylinder, cone", "turned from y to z", "Rapier's are along y."),
        Setting("pose, sizes", "rounded to single precision", "The package has no other."),
        Setting("world: restitution, friction", "combine rules MIN, GEOMETRIC_MEAN",
                "Rapier's default is the average."),
        Setting("world: damping", "0", "Rapier's default."),
    ]
    supports = [
        "sphere", "box", "capsule", "cylinder", "cone", "convex hull", "static sphere",
        "static box", "static half-space", "static capsule", "static cylinder",
        "static cone", "static convex hull", "stated inertia", "restitution", "friction",
        "unequal friction", "two moving bodies that may meet", "force", "push",
    ]
    unsupported = {
        "particle": "Rapier's particles are those of soft bodies",
        "spring": "Rapier has a spring joint, which this adapter does not use",
        "distance joint": "Rapier has ropes, which only limit a distance",
        "cloth": "Rapier's soft bodies are another engine",
    }
    parameters = [
        parameter("iterations", 4, 4, 1, 1000, "sub-steps of a step; num_solver_iterations",
                  whole=True),
        parameter("pgs_iterations", 50, 1, 1, 1e6, "solver iterations of a sub-step",
                  "Rapier's default leaves a residual.", True),
        parameter("allowed_error", 0, 0.005, 0, 1, "overlap in m that is not corrected",
                  "Overlap is not pushed out."),
        parameter("max_corrective_velocity", 0, 3, 0, 1e6,
                  "greatest speed in m/s at which overlap is pushed out",
                  "Overlap is not pushed out, which would add energy."),
        parameter("max_velocity", 1e12, 400, 0, 1e12, "greatest speed in m/s",
                  "Worlds have no limit of speed."),
        parameter("prediction", 0.02, 0.02, 0, 10, "distance in m at which contacts begin"),
        parameter("contact_recycling", 0, 1, 0, 1, "reuse contacts of an earlier step",
                  "Reused contacts are out of date.", True),
        parameter("contact_clustering", 0, 1, 0, 1, "merge contacts of a manifold",
                  "Every contact counts.", True),
        parameter("ccd_substeps", 1, 1, 0, 100, "steps of continuous collision; 0: none",
                  "Fast bodies would pass through static ones.", True),
        parameter("ccd", 1, 0, 0, 1, "continuous collision of moving bodies; ccd_enabled",
                  "Fast bodies would pass through others.", True),
        parameter("coulomb", 1, 0, 0, 1, "friction: 1 Coulomb's, 0 simplified",
                  "Coulomb's law.", True),
        parameter("contact_frequency", 30, 30, 1e-3, 1e9, "softness of contacts in Hz"),
        parameter("static_contact_frequency", 60, 60, 1e-3, 1e9,
                  "softness of contacts with static bodies in Hz"),
        parameter("contact_damping", 10, 10, 0, 1e6, "damping ratio of contacts"),
        parameter("sleeping", 0, 1, 0, 1, "whether slow bodies are put to sleep",
                  "A body that falls asleep loses its momentum.", True),
        parameter("gyroscopic", 1, 1, 0, 1, "gyroscopic forces", whole=True),
        parameter("fast_rotation", 1, 0, 0, 1, "whether spin is unlimited",
                  "Worlds have no limit of spin.", True),
    ]

    def contact(self, A, B):
        world = rapier.PhysicsWorld(rapier.Vec3(0.0, 0.0, 0.0))
        handles = []
        for body in (A, B):
            moves = body.shape.kind != "half_space"  # Of two fixed bodies none are found.
            one = rapier.RigidBody.dynamic() if moves else rapier.RigidBody.fixed()
            parent = world.add_body(one.position(pose(body)))
            handles.append(world.add_collider(collider(body.shape), parent))
        world.detect_collisions()
        pair = world.narrow_phase.contact_pair(*handles)
        points = []
        for manifold in pair.manifolds if pair is not None else ():
            first, second = (world.colliders[one].position
                             for one in (pair.collider1, pair.collider2))
            sign = 1 if pair.collider1 == handles[0] else -1
            n_AB = sign * array(first.transform_vector(manifold.local_n1))
            for point in manifold.points:
                ends = first.transform_point(point.local_p1), second.transform_point(
                    point.local_p2)
                if point.dist <= 0:
                    points.append(ContactPoint((array(ends[0]) + array(ends[1])) / 2,
                                               point.dist, n_AB))
        if not points:
            return Contact(False)
        deepest = min(points, key=lambda point: point.separation)
        return Contact(True, deepest.separation, deepest.normal, points)

    def begin(self, world, parameters):
        return World(world, parameters)


if __name__ == "__main__":
    serve(Rapier())
