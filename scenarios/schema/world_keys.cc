#include "scenarios/schema/world_keys.h"

namespace touchstone {
namespace {

constexpr Key kFileKeys[] = {
    {"id", ValueType::kId, true,
     "The scenario's name: its path in the catalogue, without .toml."},
    {"title", ValueType::kText, true, "One line that describes the scene."},
    {"source", ValueType::kText, true, "A citation or a derivation."},
    {"horizon", ValueType::kNotNegative, false,
     "Time from which the motion is chaotic and trajectories are not compared. [s]"},
    {"world", ValueType::kTable, true, "The simulation: gravity, time step and duration.",
     TableKind::kWorld},
    {"bodies", ValueType::kMovingBodies, false,
     "The rigid bodies, each under a unique name."},
    {"particles", ValueType::kNamedTables, false,
     "Point masses, each under a unique name.", TableKind::kParticle},
    {"springs", ValueType::kTables, false, "Springs with dampers.", TableKind::kSpring},
    {"joints", ValueType::kTables, false,
     "Massless rods that keep their ends at a fixed distance.", TableKind::kJoint},
    {"cloths", ValueType::kNamedTables, false,
     "Square nets of particles, each under a unique name.", TableKind::kCloth},
    {"pushes", ValueType::kTables, false, "Impulses applied between two steps.",
     TableKind::kPush},
    {"claims", ValueType::kTables, false,
     "Statements that are true of the motion; every engine is checked against them.",
     TableKind::kClaim},
    {"expect", ValueType::kTables, false,
     "Plain statements about the motion, each with its tolerance; every engine is "
     "checked "
     "against them.",
     TableKind::kMotionExpectation},
    {"ensemble", ValueType::kTable, false,
     "Many copies of the world, each perturbed a little.", TableKind::kEnsemble},
    {"indicts", ValueType::kTables, false,
     "Engine faults reported for this scenario; the suite checks each of them.",
     TableKind::kIndictment},
};

constexpr Key kWorldKeys[] = {
    {"gravity", ValueType::kPoint, false,
     "Gravity in the world frame; (0, -9.82, 0) by default. [m/s²]"},
    {"dt", ValueType::kPositive, true, "The time step. [s]"},
    {"steps", ValueType::kPositiveCount, false, "The number of steps."},
    {"duration", ValueType::kPositive, false,
     "The simulated time, a multiple of dt; instead of steps. [s]"},
    {"sample_every", ValueType::kPositiveCount, false,
     "Number of steps between samples, a divisor of steps; 1 by default."},
};

constexpr Key kMotionKeys[] = {
    {"mass", ValueType::kNotNegative, false, "Mass; 0: never moves; 1 by default. [kg]"},
    {"inertia", ValueType::kMoments, false,
     "Principal moments of inertia about the centre, along the body's axes; those of a "
     "solid of uniform density by default. [kg m²]"},
    {"velocity", ValueType::kPoint, false,
     "Velocity of the centre, in the world frame; 0 by default. [m/s]"},
    {"spin", ValueType::kPoint, false,
     "Angular velocity in the world frame; 0 by default. [rad/s]"},
    {"restitution", ValueType::kShare, false,
     "Coefficient of restitution; a contact uses the smaller of the two; 0.5 by "
     "default."},
    {"friction", ValueType::kNotNegative, false,
     "Coefficient of friction; a contact uses the geometric mean of the two; 0.6 by "
     "default."},
    {"force", ValueType::kPoint, false,
     "Constant force through the centre, in addition to gravity; 0 by default. [N]"},
    {"collides", ValueType::kBool, false,
     "False: passes through everything; true by default."},
};

constexpr Key kParticleKeys[] = {
    {"position", ValueType::kPoint, true, "Position in the world frame. [m]"},
    {"velocity", ValueType::kPoint, false,
     "Velocity in the world frame; 0 by default. [m/s]"},
    {"mass", ValueType::kNotNegative, false,
     "Mass; 0: does not move; 1 by default. [kg]"},
    {"damping", ValueType::kNotNegative, false,
     "Velocities decay as exp(-damping t); 0 by default. [1/s]"},
    {"bounce", ValueType::kShare, false,
     "Fraction of the normal velocity kept at an impact; 0.7 by default."},
};

constexpr Key kSpringKeys[] = {
    {"A", ValueType::kAnchor, true, "The anchor of one end."},
    {"B", ValueType::kAnchor, true, "The anchor of the other end."},
    {"stiffness", ValueType::kNotNegative, true, "Stiffness. [N/m]"},
    {"damping", ValueType::kNotNegative, false,
     "Damping constant; 0 by default. [N s/m]"},
    {"rest_length", ValueType::kNotNegative, false,
     "Length at which the spring force is zero; the initial distance by default. [m]"},
};

constexpr Key kJointKeys[] = {
    {"A", ValueType::kAnchor, true, "The anchor of one end."},
    {"B", ValueType::kAnchor, true, "The anchor of the other end."},
    {"length", ValueType::kLength, false,
     "Length of the rod; the initial distance by default. [m]"},
};

constexpr Key kAnchorKeys[] = {
    {"on", ValueType::kBodyName, true, "The body or the particle."},
    {"point", ValueType::kPoint, false,
     "Point in the frame of the body; its origin by default. [m]"},
};

constexpr Key kClothKeys[] = {
    {"n", ValueType::kPositiveCount, true, "Number of nodes along a side, 3 or more."},
    {"spacing", ValueType::kLength, true, "Distance between neighbouring nodes. [m]"},
    {"centre", ValueType::kPoint, false,
     "Centre in the world frame; the net is parallel to the x and z axes; the origin by "
     "default. [m]"},
    {"node_mass", ValueType::kPositive, false, "Mass of each node; 1 by default. [kg]"},
    {"damping", ValueType::kNotNegative, false,
     "Velocities decay as exp(-damping t); 0 by default. [1/s]"},
    {"bounce", ValueType::kShare, false,
     "Fraction of the normal velocity kept when a node hits; 0 by default."},
    {"structural", ValueType::kTable, false,
     "Springs between neighbours in a row or column.", TableKind::kClothSprings},
    {"shear", ValueType::kTable, false, "Springs between diagonal neighbours.",
     TableKind::kClothSprings},
    {"bend", ValueType::kTable, false,
     "Springs between every second node of a row or column.", TableKind::kClothSprings},
    {"pinned", ValueType::kNodes, false, "Nodes that never move, [row, column] from 0."},
};

constexpr Key kClothSpringKeys[] = {
    {"stiffness", ValueType::kNotNegative, true, "Stiffness. [N/m]"},
    {"damping", ValueType::kNotNegative, false,
     "Damping constant; 0 by default. [N s/m]"},
};

constexpr Key kPushKeys[] = {
    {"body", ValueType::kBodyName, true, "The body that receives the impulse."},
    {"time", ValueType::kNotNegative, false,
     "Time of the impulse, a multiple of dt before the end; 0 by default. [s]"},
    {"point", ValueType::kPoint, false,
     "Point in the frame of the body; its origin by default. [m]"},
    {"impulse", ValueType::kPoint, true, "Impulse in the world frame. [N s]"},
};

constexpr Key kClaimKeys[] = {
    {"law", ValueType::kWord, true, "The name of the law that holds."},
    {"about", ValueType::kNames, false,
     "Names of the bodies, particles and cloths concerned; everything that moves by "
     "default."},
    {"numbers", ValueType::kNumbers, false,
     "Numbers that the law reads; those that start with expected_ were derived by the "
     "author and are checked."},
    {"because", ValueType::kText, false, "The derivation or the citation."},
};

constexpr Key kEnsembleKeys[] = {
    {"members", ValueType::kPositiveCount, true, "Number of worlds, 2 or more."},
    {"jitter", ValueType::kLength, true,
     "Largest displacement of each coordinate of an initial position. [m]"},
    {"seed", ValueType::kSeed, false, "Seed of the random numbers; 1 by default."},
};

constexpr Key kMotionExpectationKeys[] = {
    {"body", ValueType::kBodyName, false,
     "The body or particle; only a trajectory does without."},
    {"at", ValueType::kNotNegative, false,
     "Time of a place, velocity, spin, orientation, angle or touch. [s]"},
    {"by", ValueType::kNotNegative, false,
     "Time by which it topples, or from which it rests. [s]"},
    {"position", ValueType::kPoint, false, "Place of the centre, world frame. [m]"},
    {"velocity", ValueType::kPoint, false, "Velocity of the centre, world frame. [m/s]"},
    {"spin", ValueType::kPoint, false, "Angular velocity, world frame. [rad/s]"},
    {"quaternion", ValueType::kQuaternion, false, "Orientation w x y z in the world."},
    {"angle", ValueType::kNumber, false,
     "Angle turned since the start about `along`, counter-clockwise seen from its tip, "
     "up "
     "to whole turns. [rad]"},
    {"along", ValueType::kPoint, false,
     "Direction of the axis of an angle; or the only direction in which a place, "
     "velocity "
     "or spin is expected, all three by default."},
    {"touches", ValueType::kBodyName, false, "The body that it first touches then."},
    {"topples", ValueType::kBool, false,
     "Whether the direction that was up at the start tilts by more than 45 degrees."},
    {"rests", ValueType::kBool, false,
     "true: from then to the end no point of it is faster than the tolerance."},
    {"trajectory", ValueType::kText, false,
     "CSV file of the columns of `touchstone simulate`, relative to this file: no point "
     "of "
     "a body is farther off than the tolerance."},
    {"tolerance", ValueType::kPositive, false,
     "In the unit of what is expected; m/s for rest, m for a trajectory; none for a "
     "topple. [m, m/s, rad, rad/s or s]"},
    {"because", ValueType::kText, false, "The derivation or the citation."},
};

}  // namespace

std::span<const Key> KeysOfWorldTable(TableKind table) {
  switch (table) {
    case TableKind::kWorldFile:
      return kFileKeys;
    case TableKind::kWorld:
      return kWorldKeys;
    case TableKind::kParticle:
      return kParticleKeys;
    case TableKind::kSpring:
      return kSpringKeys;
    case TableKind::kJoint:
      return kJointKeys;
    case TableKind::kAnchor:
      return kAnchorKeys;
    case TableKind::kCloth:
      return kClothKeys;
    case TableKind::kClothSprings:
      return kClothSpringKeys;
    case TableKind::kPush:
      return kPushKeys;
    case TableKind::kClaim:
      return kClaimKeys;
    case TableKind::kEnsemble:
      return kEnsembleKeys;
    case TableKind::kMotionExpectation:
      return kMotionExpectationKeys;
    default:
      return {};
  }
}

std::span<const Key> MotionKeys() {
  return kMotionKeys;
}

}  // namespace touchstone
