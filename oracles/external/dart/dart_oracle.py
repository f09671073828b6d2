"""DART: contacts of its native collision detector, and worlds."""

import sys
from pathlib import Path

from touchstone_oracle import (
    BodyState, Capability, Contact, ContactImpulse, ContactPoint, Oracle, Parameter, Setting,
    Simulation, Unsupported, serve,
)

import dartpy
import numpy as np
from dartpy import collision, dynamics

sys.path.append(str(Path(__file__).parents[1] / "python"))
from conversions import friction_of, pose_matrix, product_restitutions, spin_change

SHAPES = ("sphere", "box", "capsule", "cylinder", "cone", "half_space")
MOST_CONTACTS = 2**31 - 1  # DART's default is 1000.


def to_dart(shape):
    if shape.kind == "sphere":
        return dynamics.SphereShape(shape.radius)
    if shape.kind == "box":
        return dynamics.BoxShape(2 * shape.half_extents)
    if shape.kind == "capsule":
        return dynamics.CapsuleShape(shape.radius, 2 * shape.half_length)
    if shape.kind == "cylinder":
        return dynamics.CylinderShape(shape.radius, 2 * shape.half_length)
    if shape.kind == "cone":
        return dynamics.ConeShape(shape.radius, 2 * shape.half_height)
    if shape.kind == "half_space":
        return dynamics.PlaneShape(np.array([0.0, 0.0, 1.0]), 0.0)
    raise Unsupported("dartpy makes no hull of points: its meshes come from files")


def place_of(body):
    return dartpy.math.Isometry3(pose_matrix(body))


def shift_to_midway(A, B, depth):
    """Returns how far a contact must move along the normal to lie midway. [m]

    It follows from the place where DART puts contacts, so that a contact that is off stays
    off by as much.
    """
    if A.kind == "sphere" and B.kind in ("box", "half_space"):  # On the surface of B.
        return depth / 2
    if B.kind == "sphere" and A.kind in ("box", "half_space"):  # On the surface of A.
        return -depth / 2
    return 0.0


def frictions(world):
    """Returns a coefficient of each body whose smaller ones are the roots of the products."""
    moving = [b for b in world.bodies if b.collides and b.mass > 0]
    static = [b for b in world.bodies if b.collides and b.mass == 0]
    mu = moving[0] if moving else None
    if any(b.friction != mu.friction for b in moving) or len(moving) > 1 and any(
            b.friction > mu.friction for b in static):
        raise Unsupported(
            "DART takes the smaller friction of two bodies: all moving bodies must have the "
            "same, and static ones no more")
    of_moving = mu.friction if len(moving) > 1 else sys.float_info.max
    return [of_moving if b.mass > 0 else friction_of(b, mu) if mu else 0.0
            for b in world.bodies]


class World(Simulation):
    def __init__(self, world, values):
        self.asked = world
        e = product_restitutions(world, Unsupported(
            "DART multiplies the restitutions of two bodies: all moving bodies must have the "
            "same"))
        mu = frictions(world)
        self.world = dartpy.simulation.World()
        self.world.setTimeStep(world.dt)
        self.world.setGravity(np.array(world.gravity))
        rest = self.world.getDeactivationOptions()
        rest.mEnabled = values["sleeping"] != 0
        self.world.setDeactivationOptions(rest)
        solver = self.world.getConstraintSolver()
        solver.setCollisionDetector(collision.DARTCollisionDetector())
        solver.getCollisionOption().maxNumContacts = MOST_CONTACTS
        solver.setSplitImpulseEnabled(values["split_impulse"] != 0)
        self.joints, self.nodes = [], []
        for i, asked in enumerate(world.bodies):
            skeleton = dynamics.Skeleton(f"{i}")
            moves = asked.mass > 0
            make = (skeleton.createFreeJointAndBodyNodePair if moves
                    else skeleton.createWeldJointAndBodyNodePair)
            joint, node = make()
            # The joint's own coordinates start at zero, so that no angle is rounded.
            joint.setTransformFromParentBodyNode(place_of(asked))
            self.joints.append(joint)
            self.nodes.append(node)
            if moves:
                node.setInertia(
                    dynamics.Inertia(asked.mass, np.zeros(3), np.diag(asked.inertia)))
                self.set_velocity(joint, asked.velocity, asked.spin)
            if asked.collides:
                shape = node.createShapeNode(to_dart(asked.shape), f"{i}")
                shape.createCollisionAspect()
                aspect = shape.createDynamicsAspect()
                aspect.setFrictionCoeff(mu[i])
                aspect.setRestitutionCoeff(e[i])
            self.world.addSkeleton(skeleton)

    @staticmethod
    def set_velocity(joint, velocity, spin):
        world = dynamics.Frame.World()
        joint.setSpatialVelocity(np.concatenate([spin, velocity]), world, world)

    def push(self, body, point, impulse):
        # A force of one step would not take part in a bounce of that step.
        asked, node = self.asked.bodies[body], self.nodes[body]
        X_WB = node.getWorldTransform()
        spin = spin_change(asked, X_WB.rotation(), point - X_WB.translation(), impulse)
        self.set_velocity(self.joints[body],
                          node.getLinearVelocity() + impulse / asked.mass,
                          node.getAngularVelocity() + spin)

    def step(self):
        for asked, node in zip(self.asked.bodies, self.nodes):
            if asked.mass > 0:
                node.addExtForce(np.array(asked.force))
        self.world.step()

    def read(self):
        states = []
        for asked, node in zip(self.asked.bodies, self.nodes):
            if asked.mass == 0:
                states.append(BodyState(asked.position, asked.quaternion, [0.0] * 3, [0.0] * 3))
                continue
            X_WB = node.getWorldTransform()
            states.append(BodyState(
                X_WB.translation(), dartpy.math.Quaternion(X_WB.rotation()).wxyz(),
                node.getLinearVelocity(), node.getAngularVelocity()))
        return states

    def read_impulses(self):
        impulses = []
        for contact in self.world.getLastCollisionResult().getContacts():
            A, B = (int(one.getShapeFrame().getName())
                    for one in (contact.collisionObject1, contact.collisionObject2))
            if self.asked.bodies[A].mass > 0 or self.asked.bodies[B].mass > 0:
                impulses.append(ContactImpulse(
                    A, B, contact.point, -contact.normal, -self.asked.dt * contact.force,
                    -contact.penetrationDepth))
        return impulses


def capability(a, b):
    pair = {a, b}
    if pair == {"half_space"}:
        return Capability([(a, b)], unsupported="DART does not collide planes")
    gives = ["depth", "normal"]
    if "sphere" in pair or pair == {"box"}:
        gives.append("manifold")
    family = "dart_native"
    if pair == {"box"}:
        family = "box_box_sat"
    elif "half_space" in pair or pair <= {"sphere", "box", "capsule"} and pair != {
            "box", "capsule"}:
        family = "closed_form"
    return Capability([(a, b)], gives=gives, family=family)


class Dart(Oracle):
    name = "dart"
    library = "DART"
    version = dartpy.__version__
    capabilities = [capability(a, b) for a in SHAPES for b in SHAPES] + [
        Capability([pair for a in SHAPES for pair in ((a, "convex_hull"), ("convex_hull", a))]
                   + [("convex_hull", "convex_hull")],
                   unsupported="dartpy makes no hull of points: its meshes come from files")]
    settings = [
        Setting("entry point", "DARTCollisionDetector, two groups",
                "DART's own detector. Its default is fcl."),
        Setting("contacts", "any number", "All contacts that it finds."),
        Setting("normal", "B->A, negated", "Contact.normal points to the first object."),
        Setting("depth sign", "positive penetrating, negated", "Contact.penetrationDepth."),
        Setting("contact position", "moved by half the depth for a sphere on a box or plane",
                "DART puts these on the box or the plane, all others midway."),
        Setting("answer's normal and separation", "of the deepest contact",
                "Contacts of one pair may differ in both."),
        Setting("sizes", "doubled", "DART takes full sizes."),
        Setting("world: bounce rule", "the velocity after gravity is reflected",
                "DART integrates velocities before it solves contacts."),
        Setting("world: restitution", "product of coefficients that yield min(e_A, e_B)",
                "Possible if all moving bodies have one e; other worlds are unsupported."),
        Setting("world: friction", "smaller of coefficients that yield sqrt(mu_A mu_B)",
                "Possible if all moving bodies have one mu and no static body has more, or "
                "if one body moves; other worlds are unsupported."),
        Setting("world: error reduction", "0.01 of an overlap a step, at most 1 mm/s",
                "DART's default, which dartpy cannot change."),
        Setting("world: friction cone", "box", "Two fixed directions: a square."),
        Setting("world: push", "velocities set", "DART has no impulses."),
        Setting("world: gyroscopic term", "on", "BodyNode's default."),
        Setting("world: damping", "none", "DART's default."),
    ]
    supports = [
        "sphere", "box", "capsule", "cylinder", "cone", "static sphere", "static box",
        "static half-space", "static capsule", "static cylinder", "static cone",
        "stated inertia", "restitution", "friction", "unequal friction",
        "two moving bodies that may meet", "force", "push",
    ]
    unsupported = {
        "convex hull": "dartpy makes no hull of points: its meshes come from files",
        "static convex hull": "dartpy makes no hull of points: its meshes come from files",
        "particle": "DART has no point masses that bounce",
        "cloth": "DART has no point masses that bounce",
        "spring": "DART has springs along its joints but none between two points",
        "distance joint": "DART has no distance joint between two points",
    }
    parameters = [
        Parameter("sleeping", 0, 1, 0, 1, "whether slow bodies are stopped; "
                  "DeactivationOptions", "A body that falls asleep loses its momentum.", True),
        Parameter("split_impulse", 0, 0, 0, 1, "whether overlap is removed without a change "
                  "of velocity; setSplitImpulseEnabled", "DART's default.", True),
    ]

    def contact(self, A, B):
        detector = collision.DARTCollisionDetector()
        groups, frames = [], []
        for body in (A, B):
            frames.append(dynamics.SimpleFrame())
            frames[-1].setRelativeTransform(place_of(body))
            frames[-1].setShape(to_dart(body.shape))
            groups.append(detector.createCollisionGroup())
            groups[-1].addShapeFrame(frames[-1])
        result = collision.CollisionResult()
        groups[0].collide(groups[1], collision.CollisionOption(True, MOST_CONTACTS), result)
        points = []
        for contact in result.getContacts():
            n_AB, depth = -contact.normal, contact.penetrationDepth
            midway = contact.point + shift_to_midway(A.shape, B.shape, depth) * n_AB
            points.append(ContactPoint(midway, -depth, n_AB))
        if not points:
            return Contact(False)
        deepest = min(points, key=lambda point: point.separation)
        return Contact(True, deepest.separation, deepest.normal, points)

    def begin(self, world, parameters):
        return World(world, parameters)


if __name__ == "__main__":
    serve(Dart())
