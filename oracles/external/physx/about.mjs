/** What the adapter of PhysX answers and sets; the answer to hello, without the version. */

import * as common from "../node/adapter.mjs";

const { parameter, setting } = common;

/** Bits of PxPairFlag: eSOLVE_CONTACT, eDETECT_DISCRETE_CONTACT, and eDETECT_CCD_CONTACT. */
export const PAIR_FLAGS = { discrete: (1 << 0) | (1 << 10), with_ccd: (1 << 0) | (3 << 10) };

const CONVEX = common.ALL_SHAPES.filter((shape) => shape !== "half_space");

const settings = [
  setting("package", "physx-js-webidl", "The only package of this version; it has no doubles."),
  setting("pose", "quaternion and position, rounded to float", "PhysX takes no matrix."),
  setting("capsule, cylinder, cone, half-space", "turned from x to z", "PhysX's axis is x."),
  setting("cylinder, cone", "PxConvexCoreGeometry, margin 0", "They keep their sizes."),
  setting("convex hull", "PxCreateConvexMesh, eCOMPUTE_CONVEX, default cooking", "PhysX's hull."),
  setting("algorithm", "PxGjkQuery::proximityInfo() within a bound of the distance",
    "It gives depth, distance and both points. A failure is passed on as not touching."),
  setting("tolerance length", "1 m", "PhysX's default scale."),
  setting("normal", "separatingAxis, negated", "It points from B to A."),
  setting("contact position", "midway between pointA and pointB", "They are on the surfaces."),
  setting("world: restitution", "PxCombineMode::eMIN", "PhysX's default is the average."),
  setting("world: friction", "square roots, PxCombineMode::eMULTIPLY",
    "Their product is the geometric mean. PhysX's default is the average."),
  setting("world: inertia", "setMassSpaceInertiaTensor", "Mass and inertia are those asked."),
  setting("world: pushes", "PxRigidBodyExt::addForceAtPos, eIMPULSE", "They act in the next step."),
  setting("world: springs and rods", "PxDistanceJoint of equal least and greatest length",
    "A spring by its stiffness and damping, a rod without tolerance."),
];

const parameters = [
  parameter("position_iterations", 100, 4, 1, 255, "iterations with a correction of positions",
    "PhysX's default leaves a residual that would hide its contact law.", true),
  parameter("velocity_iterations", 50, 1, 0, 255, "iterations without a correction of positions",
    "PhysX's default lets the correction of positions add speed.", true),
  parameter("tgs", 0, 0, 0, 1, "TGS in place of the solver PGS; solverType",
    "The engine's default.", true),
  parameter("bounce_threshold", 0, 2, 0, 1e3,
    "approach in m/s below which nothing bounces; bounceThresholdVelocity",
    "PhysX's default ends a bounce early."),
  parameter("contact_offset", 1e-3, 0.02, 1e-9, 1,
    "gap in m at which a contact is solved in advance; contactOffset",
    "PhysX's default lets contacts act before bodies touch. It must be more than the rest offset."),
  parameter("rest_offset", 0, 0, -1, 1, "gap in m at which bodies rest; restOffset",
    "The engine's default."),
  parameter("friction_offset", 0.04, 0.04, 0, 1,
    "gap in m at which a contact has friction; frictionOffsetThreshold", "The engine's default."),
  parameter("friction_correlation", 0.025, 0.025, 0, 1,
    "distance in m within which contacts share their friction; frictionCorrelationDistance",
    "The engine's default."),
  parameter("friction_every_iteration", 1, 0, 0, 1,
    "friction in all iterations, not the last few; eENABLE_FRICTION_EVERY_ITERATION",
    "Friction then balances the other contacts.", true),
  parameter("pcm", 1, 1, 0, 1, "persistent contact manifolds; eENABLE_PCM",
    "The engine's default.", true),
  parameter("max_depenetration_speed", 1e16, 1e16, 0, 1e30,
    "greatest speed in m/s at which overlap is pushed out; maxDepenetrationVelocity",
    "The engine's default."),
  parameter("linear_damping", 0, 0, 0, 1e3, "damping of velocities per s", "The laws have none."),
  parameter("angular_damping", 0, 0.05, 0, 1e3, "damping of spins per s", "The laws have none."),
  parameter("gyroscopic", 1, 0, 0, 1, "the gyroscopic term; eENABLE_GYROSCOPIC_FORCES",
    "Without it the angular momentum turns with the body.", true),
  parameter("max_speed", 1e16, 1e16, 0, 1e30, "greatest speed in m/s; maxLinearVelocity",
    "The engine's default."),
  parameter("max_spin", 1e9, 100, 0, 1e30, "greatest spin in rad/s; maxAngularVelocity",
    "The laws have none."),
  parameter("ccd", 1, 0, 0, 1, "continuous collision by sweeps; eENABLE_CCD",
    "Without it fast bodies pass through others.", true),
  parameter("speculative_ccd", 0, 0, 0, 1,
    "contacts in advance, along the motion; eENABLE_SPECULATIVE_CCD",
    "The engine's default.", true),
  parameter("sleep_threshold", 0, 0.005, 0, 1e9,
    "kinetic energy by mass in J/kg below which bodies are stopped; sleepThreshold",
    "A body that falls asleep loses its momentum."),
];

export const about = {
  name: "physx",
  library: "PhysX",
  precision: "float",
  subtracts_first: true,
  settings,
  contact: [
    {
      pairs: common.pairsOf(CONVEX),
      family: "gjk_epa",
      gives: ["depth", "distance", "normal", "witnesses", "penetrating_witnesses"],
    },
    {
      pairs: common.pairsOf(common.ALL_SHAPES, (a, b) => a === "half_space" || b === "half_space"),
      unsupported: "PxGjkQuery takes convex shapes only; a plane is not one",
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
      particle: "PhysX has no point masses that bounce without a GPU",
      cloth: "PhysX has no cloth without a GPU",
    },
    parameters,
  },
};
