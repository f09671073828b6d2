#include "scenarios/schema/world_keys.h"

namespace touchstone {
namespace {

constexpr Key kFileKeys[] = {
    {"id", ValueType::kId, true,
     "The scenario's name: its path in the catalogue, without .toml."},
    {"title", ValueType::kText, true, "What is there, in one line."},
    {"source", ValueType::kText, true, "A citation or a derivation."},
    {"horizon", ValueType::kNotNegative, false,
     "From here on the motion is chaotic: trajectories are not compared. [s]"},
    {"world", ValueType::kTable, true, "The question: how does this move?",
     TableKind::kWorld},
    {"bodies", ValueType::kMovingBodies, false,
     "The rigid bodies, each under a name of its own."},
    {"particles", ValueType::kNamedTables, false,
     "Point masses without size, each under a name of its own.", TableKind::kParticle},
    {"springs", ValueType::kTables, false, "Springs with dampers.", TableKind::kSpring},
    {"joints", ValueType::kTables, false,
     "Massless rods, which keep their ends at one distance.", TableKind::kJoint},
    {"cloths", ValueType::kNamedTables, false,
     "Square nets of particles, each under a name of its own.", TableKind::kCloth},
    {"pushes", ValueType::kTables, false, "Blows given between two steps.",
     TableKind::kPush},
    {"claims", ValueType::kTables, false,
     "What is true of the motion; held against every engine.", TableKind::kClaim},
    {"ensemble", ValueType::kTable, false,
     "The same world many times, each a little different.", TableKind::kEnsemble},
    {"indicts", ValueType::kTables, false,
     "Faults of engines that show here, to be found again by the suite.",
     TableKind::kIndictment},
};

constexpr Key kWorldKeys[] = {
    {"gravity", ValueType::kPoint, false,
     "In the world frame; (0, -9.82, 0) where absent. [m/s²]"},
    {"dt", ValueType::kPositive, true, "The step. [s]"},
    {"steps", ValueType::kPositiveCount, false, "How many of them."},
    {"duration", ValueType::kPositive, false, "A multiple of dt; instead of steps. [s]"},
    {"sample_every", ValueType::kPositiveCount, false,
     "Steps from sample to sample, a divisor of steps; 1 where absent."},
};

constexpr Key kMotionKeys[] = {
    {"mass", ValueType::kNotNegative, false, "0: never moves; 1 where absent. [kg]"},
    {"inertia", ValueType::kMoments, false,
     "Principal moments about the centre, along the body's axes; those of the solid of "
     "even density where absent. [kg m²]"},
    {"velocity", ValueType::kPoint, false,
     "Of the centre, in the world frame; 0 where absent. [m/s]"},
    {"spin", ValueType::kPoint, false,
     "Angular velocity in the world frame; 0 where absent. [rad/s]"},
    {"restitution", ValueType::kShare, false,
     "Of two that meet, the smaller counts; 0.5 where absent."},
    {"friction", ValueType::kNotNegative, false,
     "Of two that meet, the root of the product counts; 0.6 where absent."},
    {"force", ValueType::kPoint, false,
     "Constant, through the centre, beside gravity; 0 where absent. [N]"},
    {"collides", ValueType::kBool, false,
     "False: passes through everything; true where absent."},
};

constexpr Key kParticleKeys[] = {
    {"position", ValueType::kPoint, true, "In the world frame. [m]"},
    {"velocity", ValueType::kPoint, false, "In the world frame; 0 where absent. [m/s]"},
    {"mass", ValueType::kNotNegative, false, "0: does not move; 1 where absent. [kg]"},
    {"damping", ValueType::kNotNegative, false,
     "Velocities decay as exp(-damping t); 0 where absent. [1/s]"},
    {"bounce", ValueType::kShare, false,
     "Share of the normal velocity kept where it hits; 0.7 where absent."},
};

constexpr Key kSpringKeys[] = {
    {"A", ValueType::kAnchor, true, "What one end is fixed to."},
    {"B", ValueType::kAnchor, true, "What the other end is fixed to."},
    {"stiffness", ValueType::kNotNegative, true, "[N/m]"},
    {"damping", ValueType::kNotNegative, false, "0 where absent. [N s/m]"},
    {"rest_length", ValueType::kNotNegative, false,
     "Where it pulls nothing; the distance at the start where absent. [m]"},
};

constexpr Key kJointKeys[] = {
    {"A", ValueType::kAnchor, true, "What one end is fixed to."},
    {"B", ValueType::kAnchor, true, "What the other end is fixed to."},
    {"length", ValueType::kLength, false,
     "Of the rod; the distance at the start where absent. [m]"},
};

constexpr Key kAnchorKeys[] = {
    {"on", ValueType::kBodyName, true, "The body or the particle."},
    {"point", ValueType::kPoint, false,
     "In the frame of the body; its origin where absent. [m]"},
};

constexpr Key kClothKeys[] = {
    {"n", ValueType::kPositiveCount, true, "Nodes along a side, 3 or more."},
    {"spacing", ValueType::kLength, true, "From node to node. [m]"},
    {"centre", ValueType::kPoint, false,
     "In the world frame, whose x and z axes the net spans; its origin where absent. "
     "[m]"},
    {"node_mass", ValueType::kPositive, false, "Of each node; 1 where absent. [kg]"},
    {"damping", ValueType::kNotNegative, false,
     "Velocities decay as exp(-damping t); 0 where absent. [1/s]"},
    {"bounce", ValueType::kShare, false,
     "Share of the normal velocity kept where a node hits; 0 where absent."},
    {"structural", ValueType::kTable, false,
     "Springs between neighbours in a row or column.", TableKind::kClothSprings},
    {"shear", ValueType::kTable, false, "Springs between diagonal neighbours.",
     TableKind::kClothSprings},
    {"bend", ValueType::kTable, false,
     "Springs between every second node of a row or column.", TableKind::kClothSprings},
    {"pinned", ValueType::kNodes, false, "Nodes that never move, [row, column] from 0."},
};

constexpr Key kClothSpringKeys[] = {
    {"stiffness", ValueType::kNotNegative, true, "[N/m]"},
    {"damping", ValueType::kNotNegative, false, "0 where absent. [N s/m]"},
};

constexpr Key kPushKeys[] = {
    {"body", ValueType::kBodyName, true, "The body that is struck."},
    {"time", ValueType::kNotNegative, false,
     "A multiple of dt, before the end; 0 where absent. [s]"},
    {"point", ValueType::kPoint, false,
     "In the frame of the body; its origin where absent. [m]"},
    {"impulse", ValueType::kPoint, true, "In the world frame. [N s]"},
};

constexpr Key kClaimKeys[] = {
    {"law", ValueType::kWord, true, "The name of the law that holds."},
    {"about", ValueType::kNames, false,
     "The bodies, particles and cloths it is about; everything that moves where absent."},
    {"numbers", ValueType::kNumbers, false,
     "Numbers that the law reads; those that start with expected_ its author derived, "
     "and are checked."},
    {"because", ValueType::kText, false, "The derivation or the citation."},
};

constexpr Key kEnsembleKeys[] = {
    {"members", ValueType::kPositiveCount, true, "How many worlds, 2 or more."},
    {"jitter", ValueType::kLength, true,
     "Every coordinate of a starting position is moved by up to this. [m]"},
    {"seed", ValueType::kSeed, false, "Of the random numbers; 1 where absent."},
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
    default:
      return {};
  }
}

std::span<const Key> MotionKeys() {
  return kMotionKeys;
}

}  // namespace touchstone
