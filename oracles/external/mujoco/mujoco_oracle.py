"""MuJoCo 3.15 and 4.0.1: contacts of mj_collision or mj_geomDistance, and worlds.

    python mujoco_oracle.py             contacts of mj_collision, distances, worlds
    python mujoco_oracle.py --distance  mj_geomDistance alone, apart and overlapping
"""

import sys
from pathlib import Path

from touchstone_oracle import (
    BodyState, Capability, Contact, ContactImpulse, ContactPoint, DocumentedError, Oracle,
    Parameter, Setting, Simulation, Unsupported, serve,
)

import mujoco as mj
import numpy as np

sys.path.append(str(Path(__file__).parents[1] / "python"))
from conversions import can_touch, friction_of, is_moving_anchor, spin_change, start_of

if mj.mj_versionString() == "4.0.0":
    sys.exit("MuJoCo 4.0.0 computes wrong accelerations (google-deepmind/mujoco#3767): "
             "install mujoco-core 4.0.1")

# A first warning would otherwise write MUJOCO_LOG.TXT into the working folder.
mj.set_mju_user_warning(lambda what: print(what, file=sys.stderr))

SHAPES = ("sphere", "box", "capsule", "cylinder", "convex_hull", "half_space")
FARTHEST = 1e10  # Distances are searched up to here; MuJoCo returns it for more. [m]
MOST_IMPEDANCE = mj.mjMAXIMP


def add_geom(spec, body, shape, name, **members):
    """Adds the shape to a body of the model. The size of a plane is for drawing only."""
    kinds = mj.mjtGeom
    if shape.kind == "sphere":
        kind, size = kinds.mjGEOM_SPHERE, [shape.radius, 0, 0]
    elif shape.kind == "box":
        kind, size = kinds.mjGEOM_BOX, list(shape.half_extents)
    elif shape.kind in ("capsule", "cylinder"):
        is_capsule = shape.kind == "capsule"
        kind = kinds.mjGEOM_CAPSULE if is_capsule else kinds.mjGEOM_CYLINDER
        size = [shape.radius, shape.half_length, 0]
    elif shape.kind == "half_space":
        kind, size = kinds.mjGEOM_PLANE, [0, 0, 1]
    elif shape.kind == "convex_hull":
        spec.add_mesh(name=name, uservert=np.ravel(shape.vertices))
        kind, size = kinds.mjGEOM_MESH, [0, 0, 0]
        members["meshname"] = name
    else:
        raise Unsupported("MuJoCo has no cone")
    return body.add_geom(name=name, type=kind, size=size, **members)


def compiled(spec):
    try:
        return spec.compile()
    except ValueError as refusal:
        raise Unsupported(f"MuJoCo's compiler refuses it: {refusal}") from None


class Pair:
    """A model of two free bodies, A and B, at the poses of a question."""

    def __init__(self, A, B):
        spec = mj.MjSpec()
        spec.compiler.balanceinertia = True
        for name, asked in (("A", A), ("B", B)):
            body = spec.worldbody
            if asked.shape.kind != "half_space":  # MuJoCo allows planes in the world only.
                body = body.add_body(mass=1, inertia=[1, 1, 1], explicitinertial=True,
                                     ipos=[0, 0, 0], iquat=[1, 0, 0, 0])
                body.add_freejoint()
            add_geom(spec, body, asked.shape, name)
        self.model = compiled(spec)
        self.data = mj.MjData(self.model)
        mj.mj_kinematics(self.model, self.data)
        self.ids = [self.model.geom(name).id for name in "AB"]
        for geom, asked in zip(self.ids, (A, B)):
            # The compiler moves the vertices of a mesh to its principal axes.
            local = np.empty(9)
            mj.mju_quat2Mat(local, self.model.geom_quat[geom])
            self.data.geom_xpos[geom] = asked.to_world(self.model.geom_pos[geom])
            self.data.geom_xmat[geom] = (asked.rotation @ local.reshape(3, 3)).ravel()
            body = self.model.geom_bodyid[geom]
            self.data.xpos[body] = self.data.xipos[body] = asked.position
            self.data.xmat[body] = self.data.ximat[body] = asked.rotation.ravel()

    def distance(self):
        """Returns the signed distance and the witnesses."""
        ends = np.zeros((6, 1))
        distance = mj.mj_geomDistance(self.model, self.data, *self.ids, FARTHEST, ends)
        return distance, (ends[:3, 0], ends[3:, 0])

    def contacts(self):
        """Returns the contacts of a step at these poses."""
        mj.mj_collision(self.model, self.data)
        points = []
        for contact in self.data.contact:
            # MuJoCo orders the two geoms by type.
            n_AB = contact.frame[:3] * (1 if contact.geom[0] == self.ids[0] else -1)
            points.append(ContactPoint(contact.pos.copy(), float(contact.dist), n_AB.copy()))
        return points


class World(Simulation):
    def __init__(self, world, values):
        self.asked = world
        spec = mj.MjSpec()
        spec.compiler.balanceinertia = False
        spec.option.timestep = world.dt
        spec.option.gravity = world.gravity
        spec.option.disableflags |= mj.mjtDisableBit.mjDSBL_AUTORESET
        spec.option.iterations = int(values["iterations"])
        spec.option.tolerance = values["solver_tolerance"]
        spec.option.cone = int(values["elliptic_cone"])
        spec.option.integrator = int(values["integrator"])
        spec.option.ccd_tolerance = values["ccd_tolerance"]
        if values["multiccd"] == 0:
            spec.option.disableflags |= mj.mjtDisableBit.mjDSBL_MULTICCD
        d = values["impedance"]
        # With time 0, the stiffest damper that a step allows, with which an approach stops.
        softest = [values["least_impedance"], d, 0.001, 0.5, 2]
        at_contacts = solref(values["contact_time"], d, world.dt, 0)
        at_joints = solref(values["joint_time"], d, world.dt, 0.2)
        frictions = {body.friction for body in world.bodies if body.collides}
        bodies = []
        for i, asked in enumerate(world.bodies):
            body = spec.worldbody
            place = {"pos": asked.position, "quat": asked.quaternion}
            if asked.mass > 0:
                body = body.add_body(name=f"b{i}", mass=asked.mass, inertia=asked.inertia,
                                     explicitinertial=True, ipos=[0, 0, 0],
                                     iquat=[1, 0, 0, 0], **place)
                body.add_freejoint()
                place = {}
            bodies.append(body)
            if asked.collides:
                # With more than one dimension, friction is at least 1e-5 (mjMINMU).
                add_geom(spec, body, asked.shape, f"g{i}", solref=at_contacts[:2],
                         solimp=softest, friction=[asked.friction, 0, 0],
                         condim=3 if asked.friction > 0 else 1, **place)
        for i, A in enumerate(world.bodies if len(frictions) > 1 else ()):
            for j, B in enumerate(world.bodies[:i]):
                if can_touch(A, B):
                    mu = friction_of(A, B)
                    spec.add_pair(geomname1=f"g{j}", geomname2=f"g{i}",
                                  condim=3 if mu > 0 else 1, solref=at_contacts,
                                  solimp=softest, friction=[mu, mu, 0, 0, 0])
        lengths = []
        for i, (tie, is_joint) in enumerate(
                [(s, False) for s in world.springs] + [(j, True) for j in world.joints]):
            if not any(is_moving_anchor(world, end) for end in (tie.A, tie.B)):
                continue
            tendon = spec.add_tendon(name=f"t{i}")
            for end, name in ((tie.A, f"t{i}A"), (tie.B, f"t{i}B")):
                moves = is_moving_anchor(world, end)
                on = bodies[end.index] if moves else spec.worldbody
                on.add_site(name=name, pos=end.point if moves else start_of(world, end))
                tendon.wrap_site(name)
            if is_joint:
                spec.add_equality(name1=f"t{i}", type=mj.mjtEq.mjEQ_TENDON, solref=at_joints,
                                  objtype=mj.mjtObj.mjOBJ_TENDON, solimp=softest)
                lengths.append((f"t{i}", tie.length))
            else:
                set_spring(tendon, tie)
        self.model = compiled(spec)
        for i, (tendon, length) in enumerate(lengths):
            start = self.model.tendon_length0[self.model.tendon(tendon).id]
            self.model.eq_data[i, :5] = [length - start, 0, 0, 0, 0]
        self.data = mj.MjData(self.model)
        self.bodies = [self.model.body(f"b{i}").id if asked.mass > 0 else None
                       for i, asked in enumerate(world.bodies)]
        self.indices = [int(self.model.geom(g).name[1:]) for g in range(self.model.ngeom)]
        for i, body, position, velocity in self.moving():
            asked = world.bodies[i]
            self.data.xfrc_applied[body, :3] = asked.force
            self.data.qvel[velocity:velocity + 3] = asked.velocity
            self.data.qvel[velocity + 3:velocity + 6] = self.rotation(position).T @ asked.spin

    def moving(self):
        """Yields index, MuJoCo's body, and its first coordinate and velocity."""
        for i, body in enumerate(self.bodies):
            if body is not None:
                joint = self.model.body_jntadr[body]
                yield i, body, self.model.jnt_qposadr[joint], self.model.jnt_dofadr[joint]

    def rotation(self, position):
        R_WB = np.empty(9)
        mj.mju_quat2Mat(R_WB, self.data.qpos[position + 3:position + 7])
        return R_WB.reshape(3, 3)

    def push(self, body, point, impulse):
        for i, _, position, velocity in self.moving():
            if i == body:
                asked, R_WB = self.asked.bodies[i], self.rotation(position)
                lever = point - self.data.qpos[position:position + 3]
                self.data.qvel[velocity:velocity + 3] += impulse / asked.mass
                self.data.qvel[velocity + 3:velocity + 6] += R_WB.T @ spin_change(
                    asked, R_WB, lever, impulse)

    def step(self):
        mj.mj_step(self.model, self.data)
        for full in (mj.mjtWarning.mjWARN_CONTACTFULL, mj.mjtWarning.mjWARN_CNSTRFULL):
            if self.data.warning[full].number > 0:
                raise RuntimeError("MuJoCo has dropped contacts: its memory is full")

    def read(self):
        states = [BodyState(b.position, b.quaternion, [0.0] * 3, [0.0] * 3)
                  for b in self.asked.bodies]
        for i, _, position, velocity in self.moving():
            q, v = self.data.qpos[position:], self.data.qvel[velocity:]
            states[i] = BodyState(q[:3], q[3:7], v[:3], self.rotation(position) @ v[3:6])
        return states

    def read_impulses(self):
        if self.model.opt.integrator == mj.mjtIntegrator.mjINT_RK4:
            return None  # It leaves only the forces of its last stage.
        impulses, force = [], np.zeros(6)
        for i, contact in enumerate(self.data.contact):
            if contact.efc_address >= 0:
                mj.mj_contactForce(self.model, self.data, i, force)
                axes = contact.frame.reshape(3, 3)
                A, B = (self.indices[g] for g in contact.geom)
                impulses.append(ContactImpulse(
                    A, B, contact.pos.copy(), axes[0].copy(),
                    self.asked.dt * (axes.T @ force[:3]), float(contact.dist)))
        return impulses


def solref(time, impedance, dt, error_reduction):
    """MuJoCo's stiffness of a constraint: a critically damped time, or the stiffest."""
    if time > 0:
        return [time, 1]
    return [-error_reduction * impedance / dt**2, -impedance / dt]


def set_spring(tendon, spring):
    # Stiffness and damping are polynomials; those of first order are the plain numbers.
    tendon.stiffness = [spring.stiffness, 0, 0]
    tendon.damping = [spring.damping, 0, 0]
    tendon.springlength = [spring.rest_length] * 2


def capability(a, b, is_distance):
    pair = {a, b}
    if "cone" in pair:
        return Capability([(a, b)], unsupported="MuJoCo has no cone")
    if pair == {"half_space"}:
        return Capability([(a, b)], unsupported="MuJoCo does not collide planes")
    boxes = pair == {"box"}
    if "half_space" in pair or "sphere" in pair and "convex_hull" not in pair:
        family = "closed_form"
    elif pair == {"capsule"}:
        family = "closed_form"
    elif pair == {"box", "capsule"} or boxes:
        family = "mujoco_box_box" if boxes else "mujoco_box_capsule"
    else:
        family = "gjk_epa"
    if is_distance and boxes:
        family = "gjk_epa"  # mj_geomDistance uses no special case for them.
    gives = ["depth", "distance", "witnesses"]
    if is_distance:
        gives.append("penetrating_witnesses")
    elif family != "gjk_epa" or not pair & {"capsule", "cylinder"}:
        gives.append("manifold")
    error = None
    if family == "gjk_epa":
        error = DocumentedError(1e-6, 0, "ccd_tolerance, option in MuJoCo's XML reference")
    return Capability([(a, b)], gives=gives, family=family, documented_error=error)


def parameter(name, here, shipped, least, most, what, why, whole=False):
    return Parameter(name, here, shipped, least, most, what, why, whole)


class Mujoco(Oracle):
    name = "mujoco"
    library = "MuJoCo"
    version = mj.mj_versionString()
    settings = [
        Setting("margin", "0", "Only touching geoms have contacts."),
        Setting("distmax", f"{FARTHEST:g} m", "mj_geomDistance gives no distance beyond it."),
        Setting("convex solver", "ccd_tolerance 1e-6, 35 iterations, multiccd on",
                "MuJoCo's defaults."),
        Setting("normal of contacts", "first axis of frame, negated if A is geom 2",
                "MuJoCo orders geoms by type."),
        Setting("normal of distances", "none",
                "mj_geomDistance gives two points only. Near touching, their difference is "
                "rounding."),
        Setting("convex hull", "mesh with its hull",
                "MuJoCo rounds vertices to single precision and moves them to their "
                "principal axes."),
        Setting("half-space", "plane", "The z axis of its geom is its normal."),
        Setting("pose", "written to geom_xpos, geom_xmat", "A quaternion would round it."),
        Setting("world: contact law", "convex",
                "MuJoCo's relaxation of Coulomb's law: a sliding body also lifts off, at "
                "mu times its slip velocity."),
        Setting("world: friction", "sqrt(mu_A mu_B)",
                "Set by explicit pairs if bodies differ: MuJoCo takes the larger one."),
        Setting("world: friction of spin and roll", "none", "condim 3; 1 without friction."),
        Setting("world: spring, joint", "tendons between sites", "Explicit force; equality."),
        Setting("world: push", "velocities set", "MuJoCo has no impulses."),
        Setting("world: gyroscopic term", "on", "It cannot be switched off."),
        Setting("world: damping, sleeping, autoreset", "none",
                "A world that diverges shows its numbers: autoreset is MuJoCo's default."),
    ]
    supports = [
        "sphere", "box", "capsule", "cylinder", "convex hull", "static sphere",
        "static box", "static half-space", "static capsule", "static cylinder",
        "static convex hull", "stated inertia", "friction", "unequal friction",
        "two moving bodies that may meet", "force", "spring", "distance joint", "push",
    ]
    unsupported = {
        "cone": "MuJoCo has no cone",
        "static cone": "MuJoCo has no cone",
        "restitution": "MuJoCo has no coefficient of restitution: contacts are damped springs",
        "particle": "MuJoCo has no point masses that bounce",
        "cloth": "MuJoCo has no point masses that bounce",
    }
    parameters = [
        parameter("contact_time", 0, 0.02, 0, 1e3,
                  "time constant of contacts in s, critically damped, solref; 0: the "
                  "stiffest damper that a step allows",
                  "With 0 one step stops an approach except for 1e-4 of it, and nothing is "
                  "pushed out, which would add energy."),
        parameter("joint_time", 0, 0.02, 0, 1e3,
                  "time constant of distance joints in s; 0: a fifth of an error is "
                  "removed in a step", "As for contacts."),
        parameter("least_impedance", MOST_IMPEDANCE, 0.9, mj.mjMINIMP, MOST_IMPEDANCE,
                  "impedance of a constraint without error, solimp[0]",
                  "The highest that MuJoCo allows."),
        parameter("impedance", MOST_IMPEDANCE, 0.95, mj.mjMINIMP, MOST_IMPEDANCE,
                  "impedance of a constraint violated by 1 mm or more, solimp[1]",
                  "The highest that MuJoCo allows."),
        parameter("elliptic_cone", 1, 0, 0, 1, "friction cone: 1 elliptic, 0 pyramidal",
                  "Coulomb's circle. MuJoCo's default is a pyramid inside it.", True),
        parameter("integrator", 0, 0, 0, 4,
                  "0 Euler, 1 RK4, 2 implicit, 3 implicitfast, 4 discrete", "Default.", True),
        parameter("iterations", 1000, 100, 1, 1e6, "most iterations of the Newton solver",
                  "It iterates until nothing improves.", True),
        parameter("solver_tolerance", mj.mjMINVAL, 1e-8, 0, 1,
                  "improvement at which the solver stops",
                  "The residual of MuJoCo's default would hide its contact law."),
        parameter("ccd_tolerance", 1e-6, 1e-6, 0, 1,
                  "tolerance in m of the convex collision solver", "MuJoCo's default."),
        parameter("multiccd", 1, 1, 0, 1, "several contacts for two convex shapes",
                  "MuJoCo's default.", True),
    ]

    def __init__(self, is_distance):
        self.is_distance = is_distance
        kinds = SHAPES + ("cone",)
        self.capabilities = [capability(a, b, is_distance) for a in kinds for b in kinds]

    def contact(self, A, B):
        pair = Pair(A, B)
        points = [] if self.is_distance else pair.contacts()
        if points:
            deepest = min(points, key=lambda point: point.separation)
            return Contact(True, deepest.separation, deepest.normal, points)
        separation, witnesses = pair.distance()
        if separation >= FARTHEST:
            raise Unsupported("farther apart than the distmax of the adapter")
        touches = self.is_distance and separation <= 0
        return Contact(touches, separation, None, (), witnesses)

    def begin(self, world, parameters):
        return World(world, parameters)


if __name__ == "__main__":
    serve(Mujoco("--distance" in sys.argv[1:]))
