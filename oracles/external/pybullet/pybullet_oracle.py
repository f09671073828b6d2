"""Bullet as pybullet brings it: closest points of GJK and EPA, and multibody worlds."""

import sys
import tempfile
from pathlib import Path

from touchstone_oracle import (
    BodyState, Capability, Contact, ContactImpulse, DocumentedError, Oracle, Parameter,
    Setting, Simulation, Unsupported, serve,
)

import numpy as np
import pybullet as p

sys.path.append(str(Path(__file__).parents[1] / "python"))
from conversions import product_restitutions, spin_change, wxyz, xyzw

FARTHEST = 1e10  # Closest points are asked up to this distance. [m]
CONVEX = ("sphere", "box", "capsule", "cylinder", "convex_hull")
STATIC, MOVING = 1, 2  # Groups of the collision filter: static bodies do not meet.


def bullet_version():
    """Returns btGetVersion() and the letter of the scalar, from the head of a saved world."""
    with tempfile.NamedTemporaryFile(suffix=".bullet") as file:
        p.saveBullet(file.name)
        head = Path(file.name).read_bytes()[:12].decode()  # "BULLETd-v326"
    return f"{head[-3]}.{head[-2:]}", head[6]


p.connect(p.DIRECT)
VERSION, SCALAR = bullet_version()


def to_bullet(shape):
    if shape.kind == "sphere":
        return p.createCollisionShape(p.GEOM_SPHERE, radius=shape.radius)
    if shape.kind == "box":
        return p.createCollisionShape(p.GEOM_BOX, halfExtents=list(shape.half_extents))
    if shape.kind == "capsule":
        return p.createCollisionShape(
            p.GEOM_CAPSULE, radius=shape.radius, height=2 * shape.half_length)
    if shape.kind == "cylinder":
        return p.createCollisionShape(
            p.GEOM_CYLINDER, radius=shape.radius, height=2 * shape.half_length)
    if shape.kind == "convex_hull":
        return p.createCollisionShape(p.GEOM_MESH, vertices=shape.vertices.tolist())
    if shape.kind == "half_space":
        return p.createCollisionShape(p.GEOM_PLANE, planeNormal=[0, 0, 1])
    raise Unsupported("pybullet has no cone")


def add(asked, mass, margin):
    """Adds a body at its place."""
    body = p.createMultiBody(mass, to_bullet(asked.shape), -1, list(asked.position),
                             list(xyzw(asked.quaternion)))
    if asked.shape.kind not in ("sphere", "capsule"):  # Their margin is their radius.
        p.changeDynamics(body, -1, collisionMargin=margin)
    return body


class World(Simulation):
    def __init__(self, world, values):
        self.asked = world
        self.solved_up_to = values["processing_threshold"]
        e = product_restitutions(world, Unsupported(
            "Bullet multiplies the restitutions of two bodies: all moving bodies must have "
            "the same"))
        p.resetSimulation()
        p.setGravity(*world.gravity)
        p.setPhysicsEngineParameter(
            fixedTimeStep=world.dt, numSubSteps=0, deterministicOverlappingPairs=1,
            numSolverIterations=int(values["iterations"]),
            solverResidualThreshold=values["residual"], erp=values["erp"],
            contactERP=values["contact_erp"], frictionERP=values["friction_erp"],
            contactSlop=values["contact_slop"],
            enableConeFriction=int(values["cone_friction"]),
            restitutionVelocityThreshold=values["restitution_threshold"],
            contactBreakingThreshold=values["contact_breaking"])
        self.bodies = []
        for i, asked in enumerate(world.bodies):
            body = add(asked, asked.mass, values["margin"])
            self.bodies.append(body)
            p.changeDynamics(
                body, -1, restitution=e[i], lateralFriction=float(np.sqrt(asked.friction)),
                linearDamping=values["linear_damping"],
                angularDamping=values["angular_damping"],
                contactProcessingThreshold=values["processing_threshold"],
                maxJointVelocity=values["max_velocity"])
            group = 0 if not asked.collides else MOVING if asked.mass > 0 else STATIC
            meets = 0 if not asked.collides else MOVING | (STATIC if asked.mass > 0 else 0)
            p.setCollisionFilterGroupMask(body, -1, group, meets)
            if asked.mass > 0:
                p.changeDynamics(body, -1, localInertiaDiagonal=list(asked.inertia))
                p.resetBaseVelocity(body, list(asked.velocity), list(asked.spin))
        self.indices = {body: i for i, body in enumerate(self.bodies)}

    def push(self, body, point, impulse):
        asked, pushed = self.asked.bodies[body], self.bodies[body]
        place, turn = p.getBasePositionAndOrientation(pushed)
        velocity, spin = p.getBaseVelocity(pushed)
        R_WB = np.reshape(p.getMatrixFromQuaternion(turn), (3, 3))
        change = spin_change(asked, R_WB, point - np.array(place), impulse)
        p.resetBaseVelocity(pushed, list(velocity + impulse / asked.mass), list(spin + change))

    def step(self):
        for asked, body in zip(self.asked.bodies, self.bodies):
            if asked.mass > 0 and asked.force.any():
                place = p.getBasePositionAndOrientation(body)[0]
                p.applyExternalForce(body, -1, list(asked.force), place, p.WORLD_FRAME)
        p.stepSimulation()

    def read(self):
        states = []
        for asked, body in zip(self.asked.bodies, self.bodies):
            place, turn = p.getBasePositionAndOrientation(body)
            velocity, spin = p.getBaseVelocity(body)
            states.append(BodyState(place, wxyz(turn), velocity, spin))
        return states

    def read_impulses(self):
        impulses = []
        for contact in p.getContactPoints():
            normal_on_B, distance, force = np.array(contact[7]), contact[8], contact[9]
            if distance > self.solved_up_to:
                continue  # It was not solved: its friction is that of an earlier step.
            friction = sum(f * np.array(t) for f, t in (contact[10:12], contact[12:14]))
            # Forces act on the first body, along the normal that points into it.
            impulses.append(ContactImpulse(
                self.indices[contact[1]], self.indices[contact[2]],
                (np.array(contact[5]) + contact[6]) / 2, -normal_on_B,
                -self.asked.dt * (force * normal_on_B + friction), distance))
        return impulses


def parameter(name, here, shipped, most, what, why, least=0, whole=False):
    return Parameter(name, here, shipped, least, most, what, why, whole)


NO_PUSH_OUT = "Overlap is not pushed out, which would add energy."
NO_DAMPING = "Worlds have no damping."


class PyBullet(Oracle):
    name = "pybullet"
    library = "Bullet"
    version = VERSION
    precision = "double" if SCALAR == "d" else "float"
    subtracts_first = True
    capabilities = [
        Capability(
            [(a, b) for a in CONVEX for b in CONVEX if (a, b) != ("sphere", "sphere")],
            gives=["depth", "distance", "normal", "witnesses", "penetrating_witnesses"],
            family="gjk_epa", documented_error=DocumentedError(
                1e-12, 1e-12, "EPA_ACCURACY, btGjkEpa2.cpp; REL_ERROR2, btGjkPairDetector.cpp")),
        Capability(
            [("sphere", "sphere")] + [pair for a in CONVEX
                                      for pair in ((a, "half_space"), ("half_space", a))],
            gives=["depth", "distance", "normal", "witnesses", "penetrating_witnesses"],
            family="closed_form"),
        Capability([("half_space", "half_space")],
                   unsupported="two planes have no contact algorithm"),
        Capability([pair for a in CONVEX + ("half_space",)
                    for pair in ((a, "cone"), ("cone", a))] + [("cone", "cone")],
                   unsupported="pybullet has no cone"),
    ]
    settings = [
        Setting("entry point", "getClosestPoints", "Of several points the nearest or deepest."),
        Setting("distance", f"{FARTHEST:g} m", "pybullet finds no points beyond it."),
        Setting("margin", "0", "pybullet's default of 1 mm enlarges hulls and rounds the "
                "edges of boxes and cylinders within their size."),
        Setting("normal", "B->A, negated", "contactNormalOnB points into A."),
        Setting("sizes", "full heights", "pybullet takes heights without caps."),
        Setting("pose", "quaternion", "pybullet takes nothing else."),
        Setting("convex hull", "GEOM_MESH of its vertices",
                "pybullet builds another hull from them: vertices move by some 1e-5 of the "
                "size."),
        Setting("half-space", "GEOM_PLANE, normal z", "Solid below its origin."),
        Setting("world: bodies", "createMultiBody, numSubSteps 0",
                "A btMultiBody without links in a btMultiBodyDynamicsWorld: pybullet's "
                "default."),
        Setting("world: restitution", "product of coefficients that yield min(e_A, e_B)",
                "Possible if all moving bodies have one e; other worlds are unsupported."),
        Setting("world: friction", "square roots", "Bullet multiplies them."),
        Setting("world: deterministicOverlappingPairs", "1",
                "Otherwise an answer may depend on earlier questions."),
        Setting("world: gyroscopic term", "on", "btMultiBody's default."),
        Setting("world: sleeping", "off", "pybullet's default."),
        Setting("world: push", "velocities set", "pybullet has no impulses."),
    ]
    supports = [
        "sphere", "box", "capsule", "cylinder", "convex hull", "static sphere",
        "static box", "static half-space", "static capsule", "static cylinder",
        "static convex hull", "stated inertia", "restitution", "friction",
        "unequal friction", "two moving bodies that may meet", "force", "push",
    ]
    unsupported = {
        "cone": "pybullet has no cone",
        "static cone": "pybullet has no cone",
        "particle": "pybullet has no point masses",
        "spring": "pybullet has no spring between two points",
        "distance joint": "pybullet has no joint that keeps two points at a distance",
        "cloth": "Bullet's soft bodies are another engine",
    }
    parameters = [
        parameter("iterations", 1000, 50, 1e6, "most iterations of the solver",
                  "pybullet's default leaves a residual.", 1, True),
        parameter("residual", 0, 1e-7, 1, "squared change of velocity at which the solver "
                  "stops; solverResidualThreshold", "It iterates until nothing changes."),
        parameter("erp", 0, 0.2, 1, "fraction of a joint's error removed in a step",
                  NO_PUSH_OUT),
        parameter("contact_erp", 0, 0.08, 1, "fraction of an overlap removed in a step",
                  NO_PUSH_OUT),
        parameter("friction_erp", 0, 0.2, 1, "the same of friction anchors", NO_PUSH_OUT),
        parameter("contact_slop", 0, 1e-5, 1, "overlap in m that is left", NO_PUSH_OUT),
        parameter("cone_friction", 1, 1, 1, "1: a cone, 0: two directions; "
                  "enableConeFriction", "Coulomb's circle.", 0, True),
        parameter("restitution_threshold", 0, 0.2, 1e3,
                  "approach in m/s below which nothing bounces",
                  "The default ends a bounce early."),
        parameter("contact_breaking", 0.02, 0.02, 1e3,
                  "distance in m at which contacts are kept", "pybullet's default."),
        parameter("processing_threshold", 0, 1e18, 1e18,
                  "separation in m up to which a contact is solved",
                  "Contacts that are solved early lose their restitution."),
        parameter("margin", 0, 1e-3, 1e3, "collision margin in m",
                  "The default lets hulls float 1 mm above what they rest on."),
        parameter("linear_damping", 0, 0.04, 1e3, "damping of velocities in 1/s", NO_DAMPING),
        parameter("angular_damping", 0, 0.04, 1e3, "damping of spins in 1/s", NO_DAMPING),
        parameter("max_velocity", 1e12, 100, 1e12,
                  "greatest speed in m/s and spin in rad/s; maxJointVelocity",
                  "Worlds have no limit of speed."),
    ]

    def contact(self, A, B):
        p.resetSimulation()
        found = p.getClosestPoints(add(A, 1, 0), add(B, 1, 0), FARTHEST)
        if not found:
            return Contact(False)  # A promised distance is then missing.
        point = min(found, key=lambda one: one[8])
        return Contact(point[8] <= 0, point[8], -np.array(point[7]), (),
                       (point[5], point[6]))

    def begin(self, world, parameters):
        return World(world, parameters)


if __name__ == "__main__":
    serve(PyBullet())
