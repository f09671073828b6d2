"""Drake: signed distances of its scene graph, and worlds of its multibody plant."""

import importlib.metadata
import sys
from pathlib import Path

from touchstone_oracle import (
    BodyState, Capability, Contact, DocumentedError, Oracle,
    Parameter, Setting, Simulation, Unsupported, serve,
)

import numpy as np
import pydrake.geometry as geometry
from pydrake.common.eigen_geometry import Quaternion
from pydrake.math import RigidTransform
from pydrake.multibody.math import SpatialForce, SpatialVelocity
from pydrake.multibody.plant import (
    AddMultibodyPlant, CoulombFriction, ExternallyAppliedSpatialForce, MultibodyPlantConfig,
)
from pydrake.multibody.tree import LinearSpringDamper, RotationalInertia, SpatialInertia
from pydrake.systems.analysis import Simulator
from pydrake.systems.framework import DiagramBuilder

sys.path.append(str(Path(__file__).parents[1] / "python"))
from conversions import is_moving_anchor, pose_matrix, spin_change, start_of

SHAPES = ("sphere", "box", "capsule", "cylinder", "convex_hull")
APPROXIMATIONS = ("tamsi", "sap", "similar", "lagged")
# Worst errors that the documentation of QueryObject states for signed distances, with
# shapes of 20 cm that are 2 mm deep or apart. Pairs that it gives 1e-14 m or less are left
# out: that is rounding. [m]
ERRORS = {
    ("box", "capsule"): 3e-6, ("capsule", "capsule"): 2e-5, ("capsule", "convex_hull"): 2e-5,
    ("box", "cylinder"): 6e-6, ("capsule", "cylinder"): 1e-5,
    ("convex_hull", "cylinder"): 6e-6, ("cylinder", "cylinder"): 2e-5,
    ("convex_hull", "sphere"): 3e-6,
}
CLOSED = {"sphere", "box", "capsule", "cylinder", "half_space"}  # With a sphere.


def to_drake(shape):
    if shape.kind == "sphere":
        return geometry.Sphere(shape.radius)
    if shape.kind == "box":
        return geometry.Box(*(2 * shape.half_extents))
    if shape.kind == "capsule":
        return geometry.Capsule(shape.radius, 2 * shape.half_length)
    if shape.kind == "cylinder":
        return geometry.Cylinder(shape.radius, 2 * shape.half_length)
    if shape.kind == "convex_hull":
        if len(shape.vertices) < 3:
            raise Unsupported("Drake makes no hull of fewer than three vertices")
        return geometry.Convex(points=np.array(shape.vertices).T, label="hull")
    if shape.kind == "half_space":
        return geometry.HalfSpace()
    raise Unsupported("Drake has no cone")


def capability(a, b):
    pair = tuple(sorted((a, b)))
    if "sphere" in pair and set(pair) <= CLOSED:
        family, error = "closed_form", None
    elif "half_space" in pair:
        # Signed distances throw; the query of the simulation answers bodies that overlap.
        return Capability([(a, b)], gives=["depth", "normal", "penetrating_witnesses"],
                          family="closed_form")
    else:
        family = "gjk_epa"
        error = DocumentedError(
            ERRORS[pair], 0, "QueryObject, table 4: worst observed error of 2 mm for "
            "shapes of 20 cm") if pair in ERRORS else None
    gives = ["depth", "distance", "normal", "witnesses", "penetrating_witnesses"]
    return Capability([(a, b)], gives=gives, family=family, documented_error=error)


class World(Simulation):
    def __init__(self, world, values):
        self.asked = world
        builder = DiagramBuilder()
        config = MultibodyPlantConfig(
            time_step=world.dt, contact_model="point",
            discrete_contact_approximation=APPROXIMATIONS[int(values["approximation"])],
            penetration_allowance=values["penetration_allowance"],
            stiction_tolerance=values["stiction_tolerance"],
            sap_near_rigid_threshold=values["near_rigid"])
        self.plant, _ = AddMultibodyPlant(config, builder)
        self.plant.mutable_gravity_field().set_gravity_vector(world.gravity)
        self.bodies = []
        forces = []
        for i, asked in enumerate(world.bodies):
            body, place = self.plant.world_body(), RigidTransform(pose_matrix(asked))
            if asked.mass > 0:
                inertia = SpatialInertia.MakeFromCentralInertia(
                    asked.mass, np.zeros(3), RotationalInertia(*asked.inertia))
                body, place = self.plant.AddRigidBody(f"b{i}", inertia), RigidTransform()
                if asked.force.any():
                    forces.append(ExternallyAppliedSpatialForce())
                    forces[-1].body_index = body.index()
                    forces[-1].F_Bq_W = SpatialForce(np.zeros(3), np.array(asked.force))
            self.bodies.append(body)
            if asked.collides:
                self.plant.RegisterCollisionGeometry(
                    body, place, to_drake(asked.shape), f"g{i}", material(asked, values))
        for spring in world.springs:
            (body_A, p_A), (body_B, p_B) = self.ends(spring)
            self.plant.AddForceElement(LinearSpringDamper(
                body_A, p_A, body_B, p_B, spring.rest_length, spring.stiffness,
                spring.damping))
        for joint in world.joints:
            (body_A, p_A), (body_B, p_B) = self.ends(joint)
            self.plant.AddDistanceConstraint(body_A, p_A, body_B, p_B, joint.length)
        self.plant.Finalize()
        diagram = builder.Build()
        self.simulator = Simulator(diagram)
        self.context = self.plant.GetMyMutableContextFromRoot(
            self.simulator.get_mutable_context())
        self.plant.get_applied_spatial_force_input_port().FixValue(self.context, forces)
        for asked, body in zip(world.bodies, self.bodies):
            if asked.mass > 0:
                q = asked.quaternion / np.linalg.norm(asked.quaternion)
                self.plant.SetFreeBodyPose(
                    self.context, body, RigidTransform(Quaternion(q), asked.position))
                self.set_velocity(body, asked.velocity, asked.spin)
        self.simulator.Initialize()
        self.indices = {
            int(body.index()): i for i, body in enumerate(self.bodies)
            if world.bodies[i].mass > 0}
        self.steps = 0

    def ends(self, tie):
        """Yields the body and the point of each end."""
        for end in (tie.A, tie.B):
            if is_moving_anchor(self.asked, end):
                yield self.bodies[end.index], np.array(end.point)
            else:
                yield self.plant.world_body(), np.array(start_of(self.asked, end))

    def set_velocity(self, body, velocity, spin):
        self.plant.SetFreeBodySpatialVelocity(
            body, SpatialVelocity(np.array(spin), np.array(velocity)), self.context)

    def push(self, body, point, impulse):
        asked, pushed = self.asked.bodies[body], self.bodies[body]
        place = self.plant.EvalBodyPoseInWorld(self.context, pushed)
        moves = self.plant.EvalBodySpatialVelocityInWorld(self.context, pushed)
        spin = spin_change(asked, place.rotation().matrix(), point - place.translation(),
                           impulse)
        self.set_velocity(pushed, moves.translational() + impulse / asked.mass,
                          moves.rotational() + spin)

    def step(self):
        self.steps += 1
        # Halfway to the next update, which rounding can then not bring forward.
        self.simulator.AdvanceTo((self.steps - 0.5) * self.asked.dt)

    def read(self):
        states = []
        for asked, body in zip(self.asked.bodies, self.bodies):
            if asked.mass == 0:
                states.append(BodyState(asked.position, asked.quaternion, [0.0] * 3, [0.0] * 3))
                continue
            place = self.plant.GetFreeBodyPose(self.context, body)
            moves = self.plant.EvalBodySpatialVelocityInWorld(self.context, body)
            q = place.rotation().ToQuaternion().wxyz()
            states.append(
                BodyState(place.translation(), q, moves.translational(), moves.rotational()))
        return states


def material(asked, values):
    properties = geometry.ProximityProperties()
    stiffness = values["stiffness"] or None  # 0: the plant estimates it.
    dissipation = values["dissipation"] if values["dissipation"] >= 0 else None
    geometry.AddContactMaterial(dissipation, stiffness,
                                CoulombFriction(asked.friction, asked.friction), properties)
    properties.AddProperty("material", "relaxation_time", values["relaxation_time"])
    return properties


def parameter(name, here, shipped, least, most, what, why, whole=False):
    return Parameter(name, here, shipped, least, most, what, why, whole)


class Drake(Oracle):
    name = "drake"
    library = "Drake"
    version = importlib.metadata.version("drake")
    capabilities = [
        capability(a, b) for a in SHAPES + ("half_space",) for b in SHAPES + ("half_space",)
        if (a, b) != ("half_space", "half_space")
    ] + [
        Capability([("half_space", "half_space")],
                   unsupported="the penetration of two half-spaces has no meaning for Drake"),
        Capability([pair for a in SHAPES + ("half_space",)
                    for pair in ((a, "cone"), ("cone", a))] + [("cone", "cone")],
                   unsupported="Drake has no cone"),
    ]
    settings = [
        Setting("entry point", "QueryObject.ComputeSignedDistancePairClosestPoints",
                "For half-spaces with other shapes than spheres, where it throws, "
                "ComputePointPairPenetration, the query of the simulation."),
        Setting("normal", "B->A, negated and normalised",
                "nhat_BA_W points out of B. It is the difference of the witnesses over the "
                "distance: its length is off by 1e-14 at a millimetre and 1e-7 at a nanometre."),
        Setting("witnesses", "placed in the world", "Drake gives them in the geometries' "
                "frames."),
        Setting("sizes", "doubled", "Box, Capsule, Cylinder take full lengths."),
        Setting("convex hull", "Convex of the vertices", "Drake finds the hull."),
        Setting("pose", "RigidTransform of the matrix", "A quaternion would round it."),
        Setting("world: contact model", "point", "One contact of two bodies, the deepest."),
        Setting("world: plant", "discrete, with the step of the world",
                "Semi-implicit Euler; the quaternion is integrated by its derivative."),
        Setting("world: spring, joint", "LinearSpringDamper, AddDistanceConstraint",
                "Between two points."),
        Setting("world: push", "velocities set", "Drake has no impulses."),
        Setting("world: gyroscopic term", "on", "It cannot be switched off."),
        Setting("world: damping, sleeping", "none", "Drake's default."),
    ]
    supports = [
        "sphere", "box", "capsule", "cylinder", "convex hull", "static sphere",
        "static box", "static half-space", "static capsule", "static cylinder",
        "static convex hull", "stated inertia", "friction",
        "two moving bodies that may meet", "force", "spring", "distance joint", "push",
    ]
    unsupported = {
        "cone": "Drake has no cone",
        "static cone": "Drake has no cone",
        "restitution": "Drake has no coefficient of restitution: contacts are damped springs",
        "unequal friction": "Drake takes 2 a b / (a + b) of two coefficients, not the root "
                            "of a b",
        "particle": "Drake has no point masses that bounce",
        "cloth": "Drake has no point masses that bounce",
    }
    parameters = [
        parameter("approximation", 3, 3, 0, 3,
                  "discrete contact: 0 TAMSI, 1 SAP, 2 similar, 3 lagged",
                  "Drake's default.", True),
        parameter("stiffness", 1e9, 0, 0, 1e15,
                  "stiffness of a body's contacts in N/m; 0: estimated from "
                  "penetration_allowance", "Bodies are rigid."),
        parameter("dissipation", 30, -1, -1, 1e9,
                  "Hunt-Crossley dissipation in s/m; -1: estimated",
                  "Contacts separate no faster than its inverse, so that they hardly bounce. "
                  "With 1000, the solver often fails to converge."),
        parameter("relaxation_time", 0.1, 0.1, 0, 1e6, "dissipation of SAP in s",
                  "Drake's default."),
        parameter("penetration_allowance", 1e-3, 1e-3, 1e-9, 1,
                  "depth in m from which the plant estimates stiffness", "Drake's default."),
        parameter("stiction_tolerance", 1e-6, 1e-4, 1e-9, 1,
                  "slip in m/s at which friction is full", "Sticking bodies creep with it."),
        parameter("near_rigid", 1.0, 1.0, 0, 10, "SAP's threshold of stiff contacts",
                  "Drake's default."),
    ]

    def contact(self, A, B):
        graph = geometry.SceneGraph()
        source = graph.RegisterSource("question")
        poses = geometry.FramePoseVector()
        ids, places = [], []
        for name, body in (("A", A), ("B", B)):
            frame = graph.RegisterFrame(source, geometry.GeometryFrame(name))
            one = geometry.GeometryInstance(RigidTransform(), to_drake(body.shape), name)
            one.set_proximity_properties(geometry.ProximityProperties())
            ids.append(graph.RegisterGeometry(source, frame, one))
            places.append(RigidTransform(pose_matrix(body)))
            poses.set_value(frame, places[-1])
        context = graph.CreateDefaultContext()
        graph.get_source_pose_port(source).FixValue(context, poses)
        query = graph.get_query_output_port().Eval(context)
        kinds = {A.shape.kind, B.shape.kind}
        if "half_space" in kinds and "sphere" not in kinds:
            return penetration(query, ids)
        found = query.ComputeSignedDistancePairClosestPoints(*ids)
        witnesses = places[0] @ found.p_ACa, places[1] @ found.p_BCb
        n_AB = -found.nhat_BA_W / np.linalg.norm(found.nhat_BA_W)
        return Contact(found.distance <= 0, found.distance, n_AB, (), witnesses)

    def begin(self, world, parameters):
        return World(world, parameters)


def penetration(query, ids):
    for found in query.ComputePointPairPenetration():
        sign = -1 if found.id_A == ids[0] else 1
        witnesses = (found.p_WCa, found.p_WCb)[::-sign]
        return Contact(True, -found.depth, sign * found.nhat_BA_W, (), witnesses)
    return Contact(False)


if __name__ == "__main__":
    serve(Drake())
