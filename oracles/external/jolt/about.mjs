/** What the adapter of Jolt answers and sets; the answer to hello, without the version. */

import * as common from "../node/adapter.mjs";

const { parameter, setting } = common;

const settings = [
  setting("package", "jolt-physics, single-threaded wasm",
    "The npm package. The version is that of the package: Jolt's own is not exported."),
  setting("pose", "quaternion and position, rounded to float", "The package has no doubles."),
  setting("capsule, cylinder, cone", "turned from y to z", "Jolt's axis is y."),
  setting("cone", "TaperedCylinderShape with a top radius of 0", "Jolt has no cone."),
  setting("convex radius", "0 in contact questions",
    "Jolt's default of 0.05 m rounds edges and corners."),
  setting("hull tolerance", "0", "Jolt's default of 1 mm leaves vertices out."),
  setting("algorithm", "CollideShape() within 0 m, and if it hits nothing, within a bound of "
    + "the distance", "Jolt's answers about overlap are worse if it also looks for distances."),
  setting("contact position", "midway between mContactPointOn1 and 2", "Jolt gives both surfaces."),
  setting("normal", "mPenetrationAxis, made a unit vector", "It points from A to B."),
  setting("world: restitution", "min(e_A, e_B)", "Set in OnContactAdded; Jolt's is the maximum."),
  setting("world: friction", "sqrt(mu_A mu_B)", "Jolt's default."),
  setting("world: inertia", "MassAndInertiaProvided", "Mass and inertia are those asked."),
  setting("world: half-space", "PlaneShape of 1 km half extent", "Jolt's default; it is bounded."),
  setting("world: springs and rods", "DistanceConstraint of equal least and greatest length",
    "A spring by its stiffness and damping, a rod rigid."),
];

const parameters = [
  parameter("velocity_steps", 50, 10, 1, 1000, "iterations for velocities; mNumVelocitySteps",
    "Jolt's default leaves a residual that would hide its contact law.", true),
  parameter("position_steps", 2, 2, 0, 1000, "iterations for positions; mNumPositionSteps",
    "The engine's default.", true),
  parameter("baumgarte", 0.2, 0.2, 0, 1, "fraction of an overlap that is pushed out in a step, "
    + "without a change of velocity; mBaumgarte",
    "The engine's default. Without it rods drift, too."),
  parameter("slop", 0, 0.02, 0, 1, "overlap in m that is left; mPenetrationSlop",
    "Jolt's default leaves bodies 2 cm deep in each other."),
  parameter("speculative_distance", 0.02, 0.02, 0, 1,
    "gap in m at which a contact is solved in advance; mSpeculativeContactDistance",
    "The engine's default. With 0, contacts are lost between steps."),
  parameter("manifold_tolerance", 1e-3, 1e-3, 0, 1,
    "distance in m within which vertices count as one face; mManifoldTolerance",
    "The engine's default."),
  parameter("restitution_threshold", 0, 1, 0, 1e3,
    "approach in m/s below which nothing bounces; mMinVelocityForRestitution",
    "Jolt's default ends a bounce early."),
  parameter("convex_radius", 0, 0.05, 0, 1,
    "radius in m of edges and corners; inConvexRadius, mMaxConvexRadius",
    "Jolt's default rounds boxes, cylinders and hulls. It is reduced to fit the shape."),
  parameter("linear_damping", 0, 0.05, 0, 1e3, "damping of velocities per s; mLinearDamping",
    "The laws have none."),
  parameter("angular_damping", 0, 0.05, 0, 1e3, "damping of spins per s; mAngularDamping",
    "The laws have none."),
  parameter("gyroscopic", 1, 0, 0, 1, "the gyroscopic term; mApplyGyroscopicForce",
    "Without it the angular momentum turns with the body.", true),
  parameter("max_speed", 1e9, 500, 0, 1e30, "greatest speed in m/s; mMaxLinearVelocity",
    "The laws have none."),
  parameter("max_spin", 1e9, 0.25 * Math.PI * 60, 0, 1e30,
    "greatest spin in rad/s; mMaxAngularVelocity", "The laws have none."),
  parameter("linear_cast", 1, 0, 0, 1, "continuous collision of moving bodies; mMotionQuality",
    "Without it fast bodies pass through others.", true),
  parameter("pair_cache", 1, 1, 0, 1,
    "whether contacts of bodies that hardly moved are reused; mUseBodyPairContactCache",
    "The engine's default.", true),
  parameter("sleeping", 0, 1, 0, 1, "whether slow bodies are stopped; mAllowSleeping",
    "A body that falls asleep loses its momentum.", true),
];

const gives = ["depth", "distance", "normal", "witnesses", "penetrating_witnesses"];
const isPlane = (shape) => shape === "half_space";

export const about = {
  name: "jolt",
  library: "Jolt",
  version: common.versionOf("jolt-physics"),
  precision: "float",
  subtracts_first: true,
  settings,
  contact: [
    {
      pairs: common.pairsOf(common.ALL_SHAPES, (a, b) => !isPlane(a) && !isPlane(b)),
      family: "gjk_epa",
      gives,
      documented_error: {
        length: 1e-4,
        share: 1e-4,
        by: "mCollisionTolerance and mPenetrationTolerance, Jolt/Physics/Collision/CollideShape.h",
      },
    },
    {
      pairs: common.pairsOf(common.ALL_SHAPES, (a, b) => isPlane(a) !== isPlane(b)),
      family: "closed_form",
      gives,
    },
    {
      pairs: [["half_space", "half_space"]],
      unsupported: "Jolt collides planes with convex shapes only",
    },
  ],
  world: {
    supports: [
      "sphere", "box", "capsule", "cylinder", "cone", "convex hull", "static sphere",
      "static box", "static half-space", "static capsule", "static cylinder", "static cone",
      "static convex hull", "stated inertia", "restitution", "friction", "unequal friction",
      "two moving bodies that may meet", "force", "spring", "distance joint", "push",
    ],
    unsupported: {
      particle: "Jolt has no point masses that bounce",
      cloth: "Jolt's soft bodies are not nets of point masses and springs",
    },
    parameters,
  },
};
