/** crashcat, a physics engine in JavaScript, in doubles; its algorithms are those of Jolt.
 *
 * - contact(): collideShapeVsShape(), the closest or deepest points of two shapes.
 * - worlds: updateWorld().
 *
 * crashcat's capsule and cylinder have the axis y. */

import * as common from "../node/adapter.mjs";

const { parameter, setting } = common;
const cat = await common.load("crashcat/dist/index.js");
cat.registerAll();

// Cones are missing.
const SHAPES = common.ALL_SHAPES.filter((shape) => shape !== "cone");
const isPlane = (shape) => shape === "half_space";
const gives = ["depth", "distance", "normal", "witnesses", "penetrating_witnesses"];

const parameters = [
  parameter("velocity_iterations", 50, 10, 1, 1000, "iterations for velocities",
    "The engine's default leaves a residual that would hide its contact law.", true),
  parameter("position_iterations", 2, 2, 0, 1000, "iterations for positions",
    "The engine's default.", true),
  parameter("baumgarte", 0.2, 0.2, 0, 1, "fraction of an overlap that is pushed out in a step, "
    + "without a change of velocity; baumgarteFactor",
    "The engine's default. Without it rods drift, too."),
  parameter("slop", 0, 0.02, 0, 1, "overlap in m that is left; penetrationSlop",
    "The engine's default leaves bodies 2 cm deep in each other."),
  parameter("speculative_distance", 0.02, 0.02, 0, 1,
    "gap in m at which a contact is solved in advance; speculativeContactDistance",
    "The engine's default. With 0, contacts are lost between steps."),
  parameter("manifold_tolerance", 1e-3, 1e-3, 0, 1,
    "distance in m within which vertices count as one face; manifoldTolerance",
    "The engine's default."),
  parameter("restitution_threshold", 0, 1, 0, 1e3,
    "approach in m/s below which nothing bounces; minVelocityForRestitution",
    "The engine's default ends a bounce early."),
  parameter("convex_radius", 0, 0.05, 0, 1, "radius in m of edges and corners; convexRadius",
    "The engine's default rounds boxes, cylinders and hulls."),
  parameter("linear_damping", 0, 0.05, 0, 1e3, "damping of velocities per s",
    "The laws have none."),
  parameter("angular_damping", 0, 0.05, 0, 1e3, "damping of spins per s", "The laws have none."),
  parameter("gyroscopic", 1, 0, 0, 1, "whether motionProperties.applyGyroscopicForce() is called "
    + "before each step", "The engine never calls it: a body would keep its spin.", true),
  parameter("max_speed", 1e9, 500, 0, 1e30, "greatest speed in m/s; maxLinearVelocity",
    "The laws have none."),
  parameter("max_spin", 1e9, 0.25 * Math.PI * 60, 0, 1e30,
    "greatest spin in rad/s; maxAngularVelocity", "The laws have none."),
  parameter("linear_cast", 0, 0, 0, 1, "continuous collision of moving bodies; motionQuality",
    "The engine's default.", true),
  parameter("pair_cache", 1, 1, 0, 1,
    "whether contacts of bodies that hardly moved are reused; useBodyPairContactCache",
    "The engine's default.", true),
  parameter("sleeping", 0, 1, 0, 1, "whether slow bodies are stopped; allowSleeping",
    "A body that falls asleep loses its momentum.", true),
];

const about = {
  name: "crashcat",
  library: "crashcat",
  version: common.versionOf("crashcat"),
  settings: [
    setting("version", "that of the npm package", "The engine does not tell its own."),
    setting("capsule, cylinder", "turned from y to z", "The engine's axis is y."),
    setting("convex radius", "0 in contact questions",
      "The engine's default of 0.05 m rounds edges and corners."),
    setting("hull tolerance", "0", "The engine's default of 1 mm leaves vertices out."),
    setting("algorithm", "collideShapeVsShape() within 0 m, and if it hits nothing, within a "
      + "bound of the distance", "Answers about overlap are worse if it also looks for distances."),
    setting("contact position", "midway between pointA and pointB", "They are on the surfaces."),
    setting("normal", "penetrationAxis, made a unit vector", "It points from A to B."),
    setting("world: restitution", "MaterialCombineMode.MIN", "The engine's default is MAX."),
    setting("world: friction", "sqrt(mu_A mu_B)", "The engine's default, GEOMETRIC_MEAN."),
    setting("world: inertia", "massPropertiesOverride", "Mass and inertia are those asked."),
    setting("world: half-space", "plane of 1 km half extent", "The default; it is bounded."),
    setting("world: springs and rods", "distanceConstraint of equal least and greatest length",
      "A spring by its stiffness and damping, a rod rigid."),
  ],
  contact: [
    {
      pairs: [["sphere", "sphere"]],
      family: "closed_form",
      gives: ["depth", "normal", "penetrating_witnesses"],
    },
    {
      pairs: common.pairsOf(SHAPES, (a, b) => !isPlane(a) && !isPlane(b)
        && !(a === "sphere" && b === "sphere")),
      family: "gjk_epa",
      gives,
      documented_error: {
        length: 1e-4,
        share: 1e-4,
        by: "collisionTolerance and penetrationTolerance, world-settings.d.ts",
      },
    },
    {
      pairs: common.pairsOf(SHAPES, (a, b) => isPlane(a) !== isPlane(b)),
      family: "closed_form",
      gives,
    },
    {
      pairs: [["half_space", "half_space"]],
      unsupported: "planes collide with convex shapes only",
    },
    {
      pairs: common.pairsOf(common.ALL_SHAPES, (a, b) => a === "cone" || b === "cone"),
      unsupported: "crashcat has no cone",
    },
  ],
  world: {
    supports: [
      "sphere", "box", "capsule", "cylinder", "convex hull", "static sphere", "static box",
      "static half-space", "static capsule", "static cylinder", "static convex hull",
      "stated inertia", "restitution", "friction", "unequal friction",
      "two moving bodies that may meet", "force", "spring", "distance joint", "push",
    ],
    unsupported: {
      cone: "crashcat has no cone",
      "static cone": "crashcat has no cone",
      particle: "crashcat has no point masses",
      cloth: "crashcat has no cloth",
    },
    parameters,
  },
};

function shapeOf(body, convexRadius) {
  switch (body.shape) {
    case "sphere":
      return cat.sphere.create({ radius: body.radius });
    case "box":
      return cat.box.create({ halfExtents: body.half_extents, convexRadius });
    case "capsule":
      return cat.capsule.create({ halfHeightOfCylinder: body.half_length, radius: body.radius });
    case "cylinder":
      return cat.cylinder.create(
        { halfHeight: body.half_length, radius: body.radius, convexRadius });
    case "convex_hull":
      common.requireVertices(body, 3);
      return cat.convexHull.create(
        { positions: body.vertices.flat(), convexRadius, hullTolerance: 0 });
    case "half_space":
      return cat.plane.create({ plane: { normal: [0, 0, 1], constant: 0 } });
    default:
      throw new common.Unsupported(`crashcat has no ${body.shape}`);
  }
}

const toXyzwList = ([w, x, y, z]) => [x, y, z, w];
const fromXyzwList = ([x, y, z, w]) => [w, x, y, z];

/** Returns the inputs by which collideShapeVsShape() takes a body of scale 1. */
function placed(body) {
  const q = common.turnedToAxis(body, common.Y_TO_Z);
  return [shapeOf(body, 0), cat.EMPTY_SUB_SHAPE_ID, 0, ...body.position, ...toXyzwList(q), 1, 1, 1];
}

/** Returns the deepest hit within a distance, or undefined. [m] */
function collide(A, B, distance) {
  const settings = cat.createDefaultCollideShapeSettings();
  settings.maxSeparationDistance = distance;
  const collector = cat.createAllCollideShapeCollector();
  cat.collideShapeVsShape(collector, settings, ...A, ...B);
  return collector.hits.sort((a, b) => b.penetration - a.penetration)[0];
}

function contact(A, B) {
  const [placed_A, placed_B] = [placed(A), placed(B)];
  const hit = collide(placed_A, placed_B, 0)
    ?? collide(placed_A, placed_B, common.farthestApart(A, B));
  if (!hit) return { touching: false };
  return common.fromWitnesses(
    [...hit.pointA], [...hit.pointB], common.unit(hit.penetrationAxis), -hit.penetration);
}

function begin(question, values) {
  const settings = cat.createWorldSettings();
  const layer = () => cat.addObjectLayer(settings, cat.addBroadphaseLayer(settings));
  const layers = { still: layer(), moving: layer(), ghost: layer() };
  cat.enableCollision(settings, layers.moving, layers.moving);
  cat.enableCollision(settings, layers.moving, layers.still);
  settings.gravity = question.gravity;
  settings.narrowphase.speculativeContactDistance = values.speculative_distance;
  settings.narrowphase.manifoldTolerance = values.manifold_tolerance;
  settings.narrowphase.useBodyPairContactCache = values.pair_cache !== 0;
  settings.solver.velocityIterations = values.velocity_iterations;
  settings.solver.positionIterations = values.position_iterations;
  settings.solver.baumgarteFactor = values.baumgarte;
  settings.solver.penetrationSlop = values.slop;
  settings.solver.minVelocityForRestitution = values.restitution_threshold;
  settings.ccd.minVelocityForRestitution = values.restitution_threshold;
  settings.sleeping.allowSleeping = values.sleeping !== 0;
  const world = cat.createWorld(settings);
  const bodies = question.bodies.map((body) => addBody(world, layers, body, values));
  const ground = cat.rigidBody.create(world,
    { shape: null, objectLayer: layers.ghost, motionType: cat.MotionType.STATIC });
  question.springs.forEach((spring) => connect(world, bodies, ground, spring, spring.rest_length));
  question.joints.forEach((joint) => connect(world, bodies, ground, joint, joint.length));
  return {
    step() {
      bodies.forEach((body, i) => {
        if (!(question.bodies[i].mass > 0)) return;
        cat.rigidBody.addForce(world, body, question.bodies[i].force, false);
        if (values.gyroscopic) cat.motionProperties.applyGyroscopicForce(
          body.motionProperties, body.quaternion, question.dt);
      });
      cat.updateWorld(world, undefined, question.dt);
    },
    push: (i, point, impulse) =>
      cat.rigidBody.addImpulseAtPosition(world, bodies[i], impulse, point),
    read: () => bodies.flatMap((body) => [
      ...body.centerOfMassPosition, ...fromXyzwList(body.quaternion),
      ...body.motionProperties.linearVelocity, ...body.motionProperties.angularVelocity,
    ]),
  };
}

function addBody(world, layers, asked, values) {
  const moves = asked.mass > 0;
  let shape = shapeOf(asked, values.convex_radius);
  if (common.isRoundAboutZ(asked)) {
    shape = cat.transformed.create(
      { shape, position: [0, 0, 0], quaternion: toXyzwList(common.Y_TO_Z) });
  }
  if (Math.hypot(...shape.centerOfMass) > 0) {
    shape = cat.offsetCenterOfMass.create({ shape, offset: common.times(shape.centerOfMass, -1) });
  }
  const massPropertiesOverride = cat.massProperties.create();
  massPropertiesOverride.mass = asked.mass;
  const [x, y, z] = asked.inertia;
  massPropertiesOverride.inertia = [x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1];
  const body = cat.rigidBody.create(world, {
    shape,
    objectLayer: !asked.collides ? layers.ghost : moves ? layers.moving : layers.still,
    motionType: moves ? cat.MotionType.DYNAMIC : cat.MotionType.STATIC,
    position: asked.position,
    quaternion: toXyzwList(asked.quaternion),
    friction: asked.friction,
    restitution: asked.restitution,
    restitutionCombineMode: cat.MaterialCombineMode.MIN,
    ...(moves && {
      massPropertiesOverride,
      motionQuality: cat.MotionQuality[values.linear_cast ? "LINEAR_CAST" : "DISCRETE"],
      linearDamping: values.linear_damping,
      angularDamping: values.angular_damping,
      maxLinearVelocity: values.max_speed,
      maxAngularVelocity: values.max_spin,
    }),
  });
  if (moves) {
    cat.rigidBody.setLinearVelocity(world, body, asked.velocity);
    cat.rigidBody.setAngularVelocity(world, body, asked.spin);
  }
  return body;
}

function connect(world, bodies, ground, link, length) {
  const [A, B] = [link.A, link.B].map((end) => bodies[end.index] ?? ground);
  const springSettings = cat.springSettings.create();
  if (link.stiffness !== undefined) {
    if (link.stiffness === 0) {
      throw new common.Unsupported("crashcat takes a spring of stiffness 0 for a rigid rod");
    }
    springSettings.mode = cat.SpringMode.STIFFNESS_AND_DAMPING;
    springSettings.frequencyOrStiffness = link.stiffness;
    springSettings.damping = link.damping;
  }
  cat.distanceConstraint.create(world, {
    bodyIdA: A.id,
    bodyIdB: B.id,
    pointA: link.A.point,
    pointB: link.B.point,
    minDistance: length,
    maxDistance: length,
    space: cat.ConstraintSpace.LOCAL,
    springSettings,
  });
}

common.serve({ about, contact, begin });
