/** Havok in single precision, from its npm package, which is binary only.
 *
 * - contact(): HP_World_ShapeProximityWithCollector(), the closest or deepest points of a shape
 *   and a body.
 * - worlds: HP_World_Step(). */

import { readFileSync } from "node:fs";
import * as common from "../node/adapter.mjs";

const { parameter, setting } = common;
const PACKAGE = "@babylonjs/havok";
const { default: create } = await common.load(`${PACKAGE}/lib/esm/HavokPhysics_es.js`);
const hk = await create({
  wasmBinary: readFileSync(common.pathInPackage(`${PACKAGE}/lib/esm/HavokPhysics.wasm`)),
  print: console.error,
  printErr: console.error,
});

const SHAPES = ["sphere", "box", "capsule", "cylinder", "convex_hull"];
const UNTURNED = [0, 0, 0, 1];

const parameters = [
  parameter("linear_damping", 0, 0, 0, 1e3, "damping of velocities per s", "The laws have none."),
  parameter("angular_damping", 0, 0.1, 0, 1e3, "damping of spins per s", "The laws have none."),
  parameter("max_speed", 1e9, 200, 0, 1e30, "greatest speed in m/s; HP_World_SetSpeedLimit",
    "The laws have none."),
  parameter("max_spin", 1e9, 100, 0, 1e30, "greatest spin in rad/s; HP_World_SetSpeedLimit",
    "The laws have none."),
  parameter("sleeping", 0, 1, 0, 1,
    "whether slow bodies are stopped; HP_Body_SetActivationControl",
    "A body that falls asleep loses its momentum.", true),
];

const about = {
  name: "havok",
  library: "Havok",
  version: common.versionOf(PACKAGE),
  precision: "float",
  settings: [
    setting("version", "that of the npm package", "Havok does not tell its own."),
    setting("pose", "quaternion and position, rounded to float", "Havok takes no matrix."),
    setting("convex radius", "Havok's, 0.015 m or the least half extent",
      "The package cannot set it: edges and corners of boxes, cylinders and hulls are round."),
    setting("algorithm", "shape A against a world of B alone, within a bound of the distance",
      "The package has no function of two shapes."),
    setting("normal", "that of B, negated", "Havok's normals point out of their shapes."),
    setting("contact position", "midway between the points of A and B",
      "They are on the surfaces."),
    setting("world: restitution", "MaterialCombine.MINIMUM", "Set for all bodies."),
    setting("world: friction", "static and dynamic alike, MaterialCombine.GEOMETRIC_MEAN",
      "Havok's default rule."),
    setting("world: inertia", "divided by the mass", "Havok takes it for a mass of 1 kg."),
    setting("world: force", "an impulse of force times step before each step",
      "The package has no forces."),
    setting("world: ideal step", "the step; HP_World_SetIdealStepTime", "Havok divides others."),
    setting("world: springs and rods", "a limit of LINEAR_DISTANCE, equal below and above",
      "A spring by its stiffness and damping, a rod rigid."),
  ],
  contact: [
    {
      pairs: common.pairsOf(SHAPES),
      family: "gjk_epa",
      gives: ["depth", "distance", "normal", "witnesses", "penetrating_witnesses"],
    },
    {
      pairs: common.pairsOf(common.ALL_SHAPES, (a, b) => [a, b].includes("half_space")),
      unsupported: "the package has no half-space",
    },
    {
      pairs: common.pairsOf(common.ALL_SHAPES,
        (a, b) => [a, b].includes("cone") && ![a, b].includes("half_space")),
      unsupported: "the package has no cone",
    },
  ],
  world: {
    supports: [
      "sphere", "box", "capsule", "cylinder", "convex hull", "static sphere", "static box",
      "static capsule", "static cylinder", "static convex hull", "stated inertia",
      "restitution", "friction", "unequal friction", "two moving bodies that may meet",
      "force", "spring", "distance joint", "push",
    ],
    unsupported: {
      cone: "the package has no cone",
      "static cone": "the package has no cone",
      "static half-space": "the package has no half-space",
      particle: "Havok has no point masses",
      cloth: "the package has no cloth",
    },
    parameters,
  },
};

/** Returns the value that a function of Havok gives in addition to its result. */
function valueOf([result, value]) {
  check(result);
  return value;
}

function check(result) {
  if (result !== hk.Result.RESULT_OK) throw new Error(`Havok: result ${result?.value ?? result}`);
}

function shapeOf(body) {
  const end = [0, 0, body.half_length];
  switch (body.shape) {
    case "sphere":
      return valueOf(hk.HP_Shape_CreateSphere([0, 0, 0], body.radius));
    case "box":
      return valueOf(
        hk.HP_Shape_CreateBox([0, 0, 0], UNTURNED, common.times(body.half_extents, 2)));
    case "capsule":
      return valueOf(hk.HP_Shape_CreateCapsule(common.times(end, -1), end, body.radius));
    case "cylinder":
      return valueOf(hk.HP_Shape_CreateCylinder(common.times(end, -1), end, body.radius));
    case "convex_hull":
      return hullOf(body.vertices);
    default:
      throw new common.Unsupported(`the package has no ${body.shape}`);
  }
}

function hullOf(vertices) {
  const memory = hk._malloc(12 * vertices.length);
  new Float32Array(hk.HEAPU8.buffer, memory, 3 * vertices.length).set(vertices.flat());
  try {
    return valueOf(hk.HP_Shape_CreateConvexHull(memory, vertices.length));
  } finally {
    hk._free(memory);
  }
}

const toXyzwList = ([w, x, y, z]) => [x, y, z, w];
const poseOf = (body) => [body.position, toXyzwList(body.quaternion)];

function contact(A, B) {
  const [shape_A, shape_B] = [shapeOf(A), shapeOf(B)];
  const world = valueOf(hk.HP_World_Create());
  const body = valueOf(hk.HP_Body_Create());
  const collector = valueOf(hk.HP_QueryCollector_Create(1));
  try {
    hk.HP_Body_SetShape(body, shape_B);
    hk.HP_Body_SetMotionType(body, hk.MotionType.STATIC);
    hk.HP_Body_SetQTransform(body, poseOf(B));
    hk.HP_World_AddBody(world, body, false);
    check(hk.HP_World_ShapeProximityWithCollector(
      world, collector, [shape_A, ...poseOf(A), common.farthestApart(A, B), false, [0n]]));
    if (valueOf(hk.HP_QueryCollector_GetNumHits(collector)) === 0) return { touching: false };
    const [distance, on_A, on_B] = valueOf(
      hk.HP_QueryCollector_GetShapeProximityResult(collector, 0));
    const p_A = common.plus(A.position, common.rotated(A.quaternion, on_A[3])); // In A's frame.
    return common.fromWitnesses(p_A, on_B[3], common.times(on_B[4], -1), distance);
  } finally {
    hk.HP_QueryCollector_Release(collector);
    hk.HP_World_RemoveBody(world, body);
    hk.HP_Body_Release(body);
    hk.HP_World_Release(world);
    hk.HP_Shape_Release(shape_A);
    hk.HP_Shape_Release(shape_B);
  }
}

function begin(question, values) {
  const world = valueOf(hk.HP_World_Create());
  hk.HP_World_SetGravity(world, question.gravity);
  hk.HP_World_SetIdealStepTime(world, question.dt);
  hk.HP_World_SetSpeedLimit(world, values.max_speed, values.max_spin);
  const shapes = [];
  const bodies = question.bodies.map((body) => addBody(world, body, values, shapes));
  const ground = valueOf(hk.HP_Body_Create());
  hk.HP_Body_SetMotionType(ground, hk.MotionType.STATIC);
  hk.HP_World_AddBody(world, ground, false);
  const connect = (link, length) => addDistanceLimit(bodies, ground, link, length);
  const constraints = [
    ...question.springs.map((spring) => connect(spring, spring.rest_length)),
    ...question.joints.map((joint) => connect(joint, joint.length)),
  ];
  const moving = bodies.map((body, i) => ({ body, ...question.bodies[i] }))
    .filter(({ mass }) => mass > 0);
  return {
    step() {
      for (const { body, force } of moving) {
        const centre = valueOf(hk.HP_Body_GetPosition(body));
        hk.HP_Body_ApplyImpulse(body, centre, common.times(force, question.dt));
      }
      check(hk.HP_World_Step(world, question.dt));
    },
    push: (i, point, impulse) => check(hk.HP_Body_ApplyImpulse(bodies[i], point, impulse)),
    read: () => bodies.flatMap((body) => {
      const [p, [x, y, z, w]] = valueOf(hk.HP_Body_GetQTransform(body));
      return [
        ...p, w, x, y, z,
        ...valueOf(hk.HP_Body_GetLinearVelocity(body)),
        ...valueOf(hk.HP_Body_GetAngularVelocity(body)),
      ];
    }),
    end() {
      constraints.forEach((constraint) => hk.HP_Constraint_Release(constraint));
      for (const body of [...bodies, ground]) {
        hk.HP_World_RemoveBody(world, body);
        hk.HP_Body_Release(body);
      }
      shapes.forEach((shape) => hk.HP_Shape_Release(shape));
      hk.HP_World_Release(world);
    },
  };
}

function addBody(world, asked, values, shapes) {
  const { GEOMETRIC_MEAN, MINIMUM } = hk.MaterialCombine;
  const moves = asked.mass > 0;
  const shape = shapeOf(asked);
  shapes.push(shape);
  hk.HP_Shape_SetMaterial(
    shape, [asked.friction, asked.friction, asked.restitution, GEOMETRIC_MEAN, MINIMUM]);
  if (!asked.collides) hk.HP_Shape_SetFilterInfo(shape, [0, 0]);
  const body = valueOf(hk.HP_Body_Create());
  hk.HP_Body_SetShape(body, shape);
  hk.HP_Body_SetMotionType(body, moves ? hk.MotionType.DYNAMIC : hk.MotionType.STATIC);
  hk.HP_Body_SetQTransform(body, poseOf(asked));
  if (moves) {
    check(hk.HP_Body_SetMassProperties(
      body, [[0, 0, 0], asked.mass, common.times(asked.inertia, 1 / asked.mass), UNTURNED]));
    hk.HP_Body_SetLinearDamping(body, values.linear_damping);
    hk.HP_Body_SetAngularDamping(body, values.angular_damping);
    const { ALWAYS_ACTIVE, SIMULATION_CONTROLLED } = hk.ActivationControl;
    hk.HP_Body_SetActivationControl(body, values.sleeping ? SIMULATION_CONTROLLED : ALWAYS_ACTIVE);
    hk.HP_Body_SetLinearVelocity(body, asked.velocity);
    hk.HP_Body_SetAngularVelocity(body, asked.spin);
  }
  hk.HP_World_AddBody(world, body, false);
  return body;
}

/** Keeps two ends at a length, stiffly, or softly if the link has a stiffness. [m] */
function addDistanceLimit(bodies, ground, link, length) {
  const constraint = valueOf(hk.HP_Constraint_Create());
  const { LINEAR_DISTANCE } = hk.ConstraintAxis;
  hk.HP_Constraint_SetParentBody(constraint, bodies[link.A.index] ?? ground);
  hk.HP_Constraint_SetChildBody(constraint, bodies[link.B.index] ?? ground);
  hk.HP_Constraint_SetAnchorInParent(constraint, link.A.point, [1, 0, 0], [0, 1, 0]);
  hk.HP_Constraint_SetAnchorInChild(constraint, link.B.point, [1, 0, 0], [0, 1, 0]);
  hk.HP_Constraint_SetCollisionsEnabled(constraint, 1);
  hk.HP_Constraint_SetAxisMode(
    constraint, LINEAR_DISTANCE, hk.ConstraintAxisLimitMode.LIMITED);
  hk.HP_Constraint_SetAxisMinLimit(constraint, LINEAR_DISTANCE, length);
  hk.HP_Constraint_SetAxisMaxLimit(constraint, LINEAR_DISTANCE, length);
  if (link.stiffness !== undefined) {
    hk.HP_Constraint_SetAxisStiffness(constraint, LINEAR_DISTANCE, link.stiffness);
    hk.HP_Constraint_SetAxisDamping(constraint, LINEAR_DISTANCE, link.damping);
  }
  check(hk.HP_Constraint_SetEnabled(constraint, 1));
  return constraint;
}

common.serve({ about, contact, begin });
