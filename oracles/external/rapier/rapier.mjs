/** Rapier and its collision library Parry, in single precision, from their npm package.
 *
 * - contact(): Shape.contactShape(), the closest or deepest points of two shapes.
 * - worlds: World.step(), rigid bodies with one collider each.
 *
 * Parry's capsule, cylinder and cone have the axis y. */

import * as common from "../node/adapter.mjs";

const { fromXyz, parameter, setting, toXyz, toXyzw } = common;
const RAPIER = await common.load("@dimforge/rapier3d-compat/dist/rapier.mjs");
await RAPIER.init();

const SHAPES = common.ALL_SHAPES;
const ROUND = ["sphere", "half_space"];

const parameters = [
  parameter("iterations", 4, 4, 1, 1000, "sub-steps of a step; numSolverIterations",
    "The engine's default. Bodies move once per sub-step.", true),
  parameter("pgs_iterations", 50, 1, 1, 1000,
    "iterations of the solver in a sub-step; numInternalPgsIterations",
    "Rapier's default leaves a residual that would hide its contact law.", true),
  parameter("contact_frequency", 30, 30, 0, 1e6,
    "natural frequency in Hz of the spring that pushes overlap out; contact_natural_frequency",
    "The engine's default. A contact is this spring; it has no rigid one."),
  parameter("allowed_error", 0, 0.005, 0, 1,
    "overlap in m that is not pushed out; normalizedAllowedLinearError",
    "Rapier's default leaves bodies 5 mm deep in each other."),
  parameter("prediction", 0.002, 0.02, 0, 1,
    "gap in m at which a contact is solved in advance; normalizedPredictionDistance",
    "Rapier's default lets bodies of 1 cm meet before they touch."),
  parameter("ccd_substeps", 1, 1, 0, 100,
    "most sub-steps of continuous collision; maxCcdSubsteps", "The engine's default.", true),
  parameter("ccd", 0, 0, 0, 1, "continuous collision of moving bodies; setCcdEnabled",
    "The engine's default.", true),
  parameter("contact_skin", 0, 0, 0, 1, "thickness in m added to every shape; contactSkin",
    "Shapes have the sizes that are asked."),
  parameter("linear_damping", 0, 0, 0, 1e3, "damping of velocities per s; linearDamping",
    "The laws have none."),
  parameter("angular_damping", 0, 0, 0, 1e3, "damping of spins per s; angularDamping",
    "The laws have none."),
  parameter("sleeping", 0, 1, 0, 1, "whether slow bodies are stopped; setCanSleep",
    "A body that falls asleep loses its momentum.", true),
];

const unsupported = {
  particle: "Rapier has no point masses that bounce",
  cloth: "Rapier's soft bodies are not nets of point masses and springs",
  "distance joint": "Rapier's rope joint keeps two points within a distance, not at it",
};

const about = {
  name: "rapier",
  library: "Rapier",
  version: RAPIER.version(),
  precision: "float",
  subtracts_first: true,
  settings: [
    setting("package", "@dimforge/rapier3d-compat", "The npm package; it has no build in doubles."),
    setting("pose", "quaternion and position, rounded to float", "The engine has no other form."),
    setting("capsule, cylinder, cone", "turned from y to z", "Parry's axis is y."),
    setting("convex hull", "ColliderDesc.convexHull() of all vertices", "Parry's hull."),
    setting("prediction", "a bound of the distance",
      "Parry searches for contacts within it. No contact is passed on as not touching."),
    setting("contact position", "midway between point1 and point2", "Parry gives both surfaces."),
    setting("normal", "normal1", "It points from A to B."),
    setting("world: restitution", "CoefficientCombineRule.Min", "Rapier's default is the average."),
    setting("world: friction", "square roots, CoefficientCombineRule.Multiply",
      "Their product is the geometric mean. Rapier's default is the average."),
    setting("world: inertia", "setAdditionalMassProperties, colliders of density 0",
      "Mass and inertia are those that are asked."),
    setting("world: gyroscopic term", "on", "Rapier's default; the npm package cannot change it."),
    setting("world: greatest speed", "400 m/s",
      "Rapier's limit; the npm package cannot change it."),
  ],
  contact: [
    {
      pairs: common.pairsOf(SHAPES, (a, b) => ROUND.includes(a) !== ROUND.includes(b) ||
        (a !== b && ROUND.includes(a)) || (a === "sphere" && b === "sphere")),
      family: "closed_form",
      gives: ["depth", "distance", "normal", "witnesses", "penetrating_witnesses"],
    },
    {
      pairs: common.pairsOf(SHAPES, (a, b) => !ROUND.includes(a) && !ROUND.includes(b)),
      family: "gjk_epa",
      gives: ["depth", "distance", "normal", "witnesses", "penetrating_witnesses"],
    },
    {
      pairs: [["half_space", "half_space"]],
      unsupported: "Parry has no contact of two half-spaces",
    },
  ],
  world: {
    supports: [
      "sphere", "box", "capsule", "cylinder", "cone", "convex hull", "static sphere",
      "static box", "static half-space", "static capsule", "static cylinder", "static cone",
      "static convex hull", "stated inertia", "restitution", "friction", "unequal friction",
      "two moving bodies that may meet", "force", "spring", "push",
    ],
    unsupported,
    parameters,
  },
};

function shapeOf(body) {
  switch (body.shape) {
    case "sphere":
      return new RAPIER.Ball(body.radius);
    case "box":
      return new RAPIER.Cuboid(...body.half_extents);
    case "capsule":
      return new RAPIER.Capsule(body.half_length, body.radius);
    case "cylinder":
      return new RAPIER.Cylinder(body.half_length, body.radius);
    case "cone":
      return new RAPIER.Cone(body.half_height, body.radius);
    case "convex_hull": {
      common.requireVertices(body, 3);
      const hull = RAPIER.ColliderDesc.convexHull(new Float32Array(body.vertices.flat()));
      if (!hull) throw new Error("Parry built no hull");
      return hull.shape;
    }
    default:
      return new RAPIER.HalfSpace({ x: 0, y: 0, z: 1 });
  }
}

const rotationOf = (body) => toXyzw(common.turnedToAxis(body, common.Y_TO_Z));

function contact(A, B) {
  const [shape_A, shape_B] = [shapeOf(A), shapeOf(B)];
  const found = shape_A.contactShape(toXyz(A.position), rotationOf(A), shape_B,
    toXyz(B.position), rotationOf(B), common.farthestApart(A, B));
  if (!found) return { touching: false };
  return common.fromWitnesses(
    fromXyz(found.point1), fromXyz(found.point2), fromXyz(found.normal1), found.distance);
}

function begin(question, values) {
  const world = new RAPIER.World(toXyz(question.gravity));
  const settings = world.integrationParameters;
  settings.dt = question.dt;
  settings.numSolverIterations = values.iterations;
  settings.numInternalPgsIterations = values.pgs_iterations;
  settings.contact_natural_frequency = values.contact_frequency;
  settings.normalizedAllowedLinearError = values.allowed_error;
  settings.normalizedPredictionDistance = values.prediction;
  settings.maxCcdSubsteps = values.ccd_substeps;
  const bodies = question.bodies.map((body) => addBody(world, body, values));
  const ground = world.createRigidBody(RAPIER.RigidBodyDesc.fixed());
  for (const spring of question.springs) {
    const [A, B] = [spring.A, spring.B].map((end) => bodies[end.index] ?? ground);
    const joint = RAPIER.JointData.spring(spring.rest_length, spring.stiffness, spring.damping,
      toXyz(spring.A.point), toXyz(spring.B.point));
    world.createImpulseJoint(joint, A, B, true);
  }
  return {
    step: () => world.step(),
    push: (i, point, impulse) => bodies[i].applyImpulseAtPoint(toXyz(impulse), toXyz(point), true),
    read: () => bodies.flatMap((body) => [
      ...fromXyz(body.translation()), ...common.fromXyzw(body.rotation()),
      ...fromXyz(body.linvel()), ...fromXyz(body.angvel()),
    ]),
    end: () => world.free(),
  };
}

function addBody(world, asked, values) {
  const { RigidBodyDesc } = RAPIER;
  const description = asked.mass > 0 ? RigidBodyDesc.dynamic() : RigidBodyDesc.fixed();
  description.setTranslation(...asked.position).setRotation(toXyzw(asked.quaternion))
    .setLinearDamping(values.linear_damping).setAngularDamping(values.angular_damping)
    .setCanSleep(values.sleeping !== 0).setCcdEnabled(values.ccd !== 0);
  if (asked.mass > 0) {
    description.setLinvel(...asked.velocity).setAngvel(toXyz(asked.spin))
      .setAdditionalMassProperties(asked.mass, toXyz([0, 0, 0]), toXyz(asked.inertia),
        toXyzw([1, 0, 0, 0]));
  }
  const body = world.createRigidBody(description);
  if (asked.collides) world.createCollider(colliderOf(asked, values), body);
  body.addForce(toXyz(asked.force), true); // Rapier keeps it for all steps.
  return body;
}

function colliderOf(asked, values) {
  const collider = new RAPIER.ColliderDesc(shapeOf(asked)).setDensity(0)
    .setRestitution(asked.restitution).setFriction(Math.sqrt(asked.friction))
    .setRestitutionCombineRule(RAPIER.CoefficientCombineRule.Min)
    .setFrictionCombineRule(RAPIER.CoefficientCombineRule.Multiply)
    .setContactSkin(values.contact_skin);
  if (common.isRoundAboutZ(asked)) collider.setRotation(toXyzw(common.Y_TO_Z));
  return collider;
}

common.serve({ about, contact, begin });
