/** cannon-es, a physics engine in JavaScript, in doubles.
 *
 * - contact(): the narrow phase of a world, on two bodies.
 * - worlds: World.step(). */

import * as common from "../node/adapter.mjs";

const { fromXyz, parameter, setting } = common;
const CANNON = await common.load("cannon-es/dist/cannon-es.js");

const SHAPES = ["sphere", "box", "half_space"];

const parameters = [
  parameter("iterations", 100, 10, 1, 10000, "iterations of the solver; GSSolver.iterations",
    "The engine's default leaves a residual that would hide its contact law.", true),
  parameter("tolerance", 1e-9, 1e-7, 0, 1,
    "change of the sum of all forces at which the solver stops; GSSolver.tolerance",
    "The solver then ends for its iterations or its convergence."),
  parameter("contact_stiffness", 1e7, 1e7, 0, 1e30,
    "stiffness of contacts in N/m; contactEquationStiffness", "The engine's default."),
  parameter("contact_relaxation", 3, 3, 0, 1e6,
    "steps in which overlap is pushed out; contactEquationRelaxation", "The engine's default."),
  parameter("friction_stiffness", 1e7, 1e7, 0, 1e30,
    "stiffness of friction in N/m; frictionEquationStiffness", "The engine's default."),
  parameter("friction_relaxation", 3, 3, 0, 1e6,
    "steps in which slip is stopped; frictionEquationRelaxation", "The engine's default."),
  parameter("linear_damping", 0, 0.01, 0, 1,
    "share of the velocity that is lost in 1 s; linearDamping", "The laws have none."),
  parameter("angular_damping", 0, 0.01, 0, 1,
    "share of the spin that is lost in 1 s; angularDamping", "The laws have none."),
  parameter("sleeping", 0, 0, 0, 1, "whether slow bodies are stopped; World.allowSleep",
    "A body that falls asleep loses its momentum.", true),
];

const gives = ["depth", "normal", "penetrating_witnesses"];

const about = {
  name: "cannon_es",
  library: "cannon-es",
  version: common.versionOf("cannon-es"),
  settings: [
    setting("version", "that of the npm package", "The engine does not tell its own."),
    setting("separation", "(p_j - p_i) . n of each contact equation", "The engine gives no depth."),
    setting("normal", "ni, negated if the engine exchanges the bodies", "It points from i to j."),
    setting("contact position", "midway between the points of both bodies", "They are given."),
    setting("half-space", "Plane", "Its normal is z, too."),
    setting("world: restitution", "a ContactMaterial for each pair of materials, min(e_A, e_B)",
      "The engine's default takes one value for all."),
    setting("world: friction", "in the same ContactMaterial, sqrt(mu_A mu_B)",
      "The engine's default takes one value for all."),
    setting("world: inertia", "Body.inertia and invInertia",
      "The engine computes that of the bounding box."),
    setting("world: springs", "Spring.applyForce() before each step", "The engine's way."),
  ],
  contact: [
    {
      pairs: common.pairsOf(SHAPES, (a, b) => [a, b].includes("sphere")),
      family: "closed_form",
      gives,
    },
    { pairs: [["box", "box"]], family: "sat", gives: [...gives, "manifold"] },
    {
      pairs: [["box", "half_space"], ["half_space", "box"]],
      family: "closed_form",
      gives: [...gives, "manifold"],
    },
    { pairs: [["half_space", "half_space"]], unsupported: "two planes have no contact" },
    {
      pairs: common.pairsOf(common.ALL_SHAPES,
        (a, b) => !SHAPES.includes(a) || !SHAPES.includes(b)),
      unsupported: "cannon-es has no capsules, its cylinders and cones are prisms and pyramids, "
        + "and it does not find the faces of a hull",
    },
  ],
  world: {
    supports: [
      "sphere", "box", "static sphere", "static box", "static half-space", "stated inertia",
      "restitution", "friction", "unequal friction", "two moving bodies that may meet", "force",
      "spring", "push",
    ],
    unsupported: {
      ...Object.fromEntries(["", "static "].flatMap((which) => [
        [`${which}capsule`, "cannon-es has no capsule"],
        [`${which}cylinder`, "the cylinders of cannon-es are prisms"],
        [`${which}cone`, "the cones of cannon-es are pyramids"],
        [`${which}convex hull`, "cannon-es does not find the faces of a hull"],
      ])),
      particle: "the particles of cannon-es have no bounce of their own",
      cloth: "cannon-es has no cloth",
      "distance joint": "the DistanceConstraint of cannon-es joins centres of mass only",
    },
    parameters,
  },
};

const toVec3 = (v) => new CANNON.Vec3(...v);
const toQuaternion = ([w, x, y, z]) => new CANNON.Quaternion(x, y, z, w);

function shapeOf(body) {
  switch (body.shape) {
    case "sphere":
      return new CANNON.Sphere(body.radius);
    case "box":
      return new CANNON.Box(toVec3(body.half_extents));
    case "half_space":
      return new CANNON.Plane();
    default:
      throw new common.Unsupported(`cannon-es has no ${body.shape}`);
  }
}

function bodyOf(asked, options = {}) {
  const body = new CANNON.Body({
    position: toVec3(asked.position), quaternion: toQuaternion(asked.quaternion), ...options,
  });
  body.addShape(shapeOf(asked));
  return body;
}

function contact(A, B) {
  const bodies = [A, B].map((body) => bodyOf(body, { mass: 1 }));
  const world = new CANNON.World();
  bodies.forEach((body) => world.addBody(body));
  const equations = [];
  world.narrowphase.getContacts([bodies[0]], [bodies[1]], world, equations, [], [], []);
  const contacts = equations.map((equation) => measured(equation, equation.bi === bodies[1]));
  if (contacts.length === 0) return { touching: false };
  const deepest = contacts.reduce((a, b) => (b.separation < a.separation ? b : a));
  const { normal, separation, witnesses } = deepest;
  const points = contacts.map(({ position, separation: own, normal: n }) =>
    ({ position, separation: own, normal: n }));
  return { touching: true, normal, separation, witnesses, points };
}

/** Returns a contact of A and B from that of bodies i and j, which may be B and A. */
function measured({ bi, bj, ri, rj, ni }, is_exchanged) {
  const [p_i, p_j] = [[bi, ri], [bj, rj]].map(([body, r]) => fromXyz(body.position.vadd(r)));
  const separation = common.dot(common.minus(p_j, p_i), fromXyz(ni));
  return {
    separation,
    position: common.times(common.plus(p_i, p_j), 0.5),
    normal: common.times(fromXyz(ni), is_exchanged ? -1 : 1),
    witnesses: is_exchanged ? [p_j, p_i] : [p_i, p_j],
  };
}

function begin(question, values) {
  const world = new CANNON.World({ gravity: toVec3(question.gravity) });
  world.allowSleep = values.sleeping !== 0;
  world.solver.iterations = values.iterations;
  world.solver.tolerance = values.tolerance;
  const materials = addMaterials(world, question.bodies, values);
  const bodies = question.bodies.map((body) => addBody(world, body, values, materials));
  const ground = new CANNON.Body();
  const springs = question.springs.map(({ A, B, ...constants }) => new CANNON.Spring(
    bodies[A.index] ?? ground, bodies[B.index] ?? ground, {
      localAnchorA: toVec3(A.point),
      localAnchorB: toVec3(B.point),
      restLength: constants.rest_length,
      stiffness: constants.stiffness,
      damping: constants.damping,
    }));
  return {
    step() {
      springs.forEach((spring) => spring.applyForce());
      // The engine clears forces after the step.
      bodies.forEach((body, i) => body.applyForce(toVec3(question.bodies[i].force)));
      world.step(question.dt);
    },
    push: (i, point, impulse) =>
      bodies[i].applyImpulse(toVec3(impulse), toVec3(point).vsub(bodies[i].position)),
    read: () => bodies.flatMap((body) => [
      ...fromXyz(body.position), ...common.fromXyzw(body.quaternion),
      ...fromXyz(body.velocity), ...fromXyz(body.angularVelocity),
    ]),
  };
}

const surfaceOf = ({ restitution, friction }) => `${restitution} ${friction}`;

/** Returns a material for each kind of surface, and gives each pair of them its coefficients. */
function addMaterials(world, bodies, values) {
  const kinds = [...new Map(bodies.map((body) => [surfaceOf(body), body])).values()];
  const materials = new Map(kinds.map((kind) => [surfaceOf(kind), new CANNON.Material()]));
  kinds.forEach((a, i) => kinds.slice(i).forEach((b) => world.addContactMaterial(
    new CANNON.ContactMaterial(materials.get(surfaceOf(a)), materials.get(surfaceOf(b)), {
      restitution: Math.min(a.restitution, b.restitution),
      friction: Math.sqrt(a.friction * b.friction),
      contactEquationStiffness: values.contact_stiffness,
      contactEquationRelaxation: values.contact_relaxation,
      frictionEquationStiffness: values.friction_stiffness,
      frictionEquationRelaxation: values.friction_relaxation,
    }))));
  return materials;
}

function addBody(world, asked, values, materials) {
  const body = bodyOf(asked, {
    mass: asked.mass,
    material: materials.get(surfaceOf(asked)),
    linearDamping: values.linear_damping,
    angularDamping: values.angular_damping,
    ...(asked.mass > 0 && {
      velocity: toVec3(asked.velocity),
      angularVelocity: toVec3(asked.spin),
    }),
    ...(!asked.collides && { collisionFilterGroup: 0, collisionFilterMask: 0 }),
  });
  if (asked.mass > 0) {
    body.inertia.copy(toVec3(asked.inertia));
    body.invInertia.copy(toVec3(asked.inertia.map((moment) => 1 / moment)));
    body.updateInertiaWorld(true);
  }
  world.addBody(body);
  return body;
}

common.serve({ about, contact, begin });
