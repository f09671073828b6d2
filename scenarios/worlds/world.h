#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "scenarios/contact_query.h"

namespace touchstone {

/** A rigid body of a world, and its state at the start. */
struct RigidBody {
  std::string name;  ///< Unique among bodies, particles and cloths.
  Body placed;       ///< Its shape and pose; the body origin is the centre of mass.
  /** [kg]; 0: static, as heavy as can be, never moves. */
  double mass = 1;
  /** Principal moments of inertia about the centre of mass, along the body axes. Absent:
   those of the solid of even density. [kg m²] */
  std::optional<Eigen::Vector3d> inertia;
  Eigen::Vector3d v_WB = Eigen::Vector3d::Zero();  ///< Of the centre of mass. [m/s]
  Eigen::Vector3d w_WB = Eigen::Vector3d::Zero();  ///< World frame. [rad/s]
  double restitution = 0.5;                        ///< In [0, 1].
  double friction = 0.6;                           ///< >= 0
  /** A constant force through the centre of mass, beside gravity. [N] */
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();
  /** False: passes through everything. */
  bool collides = true;
};

/** A point mass without size. */
struct Particle {
  std::string name;
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d v_W = Eigen::Vector3d::Zero();  ///< [m/s]
  double mass = 1;                                ///< [kg]; 0: does not move.
  double damping = 0;   ///< Velocities decay as exp(−damping t). [1/s], >= 0
  double bounce = 0.7;  ///< Share of the normal velocity kept, in [0, 1].
};

/** What an end of a spring or a joint is fixed to. */
enum class AnchorKind { kWorld, kBody, kParticle };

/** An end of a spring or a joint. */
struct Anchor {
  AnchorKind on = AnchorKind::kWorld;
  int index = -1;  ///< Into World::bodies or World::particles; −1 for the world.
  /** In the frame of the body, or of the world; zero for a particle. [m] */
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
};

/** A spring with a damper: pulls its ends together by k (|p_AB| − L) + b d|p_AB|/dt. */
struct Spring {
  Anchor A;
  Anchor B;
  double stiffness = 0;    ///< k. [N/m], >= 0
  double damping = 0;      ///< b. [N s/m], >= 0
  double rest_length = 0;  ///< L. [m], >= 0
};

/** A massless rod: keeps its ends at one distance. */
struct DistanceJoint {
  Anchor A;
  Anchor B;
  double length = 0;  ///< [m], > 0
};

/** The constants of one family of a cloth's springs. */
struct ClothSprings {
  double stiffness = 0;  ///< [N/m], >= 0
  double damping = 0;    ///< [N s/m], >= 0
};

/** A square net of particles in its own x–z plane. Node (row, column) starts at centre +
 ((column − (n−1)/2) x̂ + (row − (n−1)/2) ẑ) spacing; rest lengths are the distances at the
 start. Structural springs join neighbours in rows and columns, shear springs diagonal
 neighbours, bend springs every second node of rows and columns. */
struct Cloth {
  std::string name;
  int n = 3;                                         ///< Nodes along a side, >= 3.
  double spacing = 1;                                ///< [m], > 0
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< World frame, [m].
  double node_mass = 1;                              ///< [kg], > 0
  double damping = 0;                                ///< As Particle::damping.
  double bounce = 0;                                 ///< As Particle::bounce.
  ClothSprings structural;
  ClothSprings shear;
  ClothSprings bend;
  std::vector<std::pair<int, int>> pinned;  ///< (row, column) of nodes that never move.
};

/** A blow: an impulse at a point of a body, given between two steps. */
struct Push {
  int body = 0;     ///< Into World::bodies.
  double time = 0;  ///< [s], a multiple of the step, before the end.
  Eigen::Vector3d p_BoP = Eigen::Vector3d::Zero();  ///< Body frame, from its origin. [m]
  Eigen::Vector3d J_W = Eigen::Vector3d::Zero();    ///< World frame. [N s]
};

/** The question: how does this move?

 Where two bodies touch, restitution is min(e_A, e_B) and friction √(μ_A μ_B), by
 Coulomb's law with a circular cone. Nothing damps what is not said to be damped, nothing
 sleeps. */
struct World {
  std::vector<RigidBody> bodies;
  std::vector<Particle> particles;
  std::vector<Spring> springs;
  std::vector<DistanceJoint> joints;
  std::vector<Cloth> cloths;
  std::vector<Push> pushes;
  Eigen::Vector3d gravity_W{0, -9.82, 0};  ///< [m/s²]
  double dt = 1.0 / 240;                   ///< The step. [s], > 0
  int steps = 240;                         ///< How many of them, > 0.
  int sample_every = 1;                    ///< Steps from sample to sample, > 0.
};

/** Returns the same world with a step `factor` times shorter: the same duration, samples
 at the same times. @pre factor > 0 */
World Refined(const World& world, int factor);

/** Returns the principal moments of `body` about its centre: as stated, else those of
 its shape at even density (sphere 2/5 m r²; box with full sizes X, Y, Z: m/12 (Y²+Z²,
 X²+Z², X²+Y²)). Zero for a static body. [kg m²]
 @pre The inertia is stated, or the shape is a sphere or a box. */
Eigen::Vector3d InertiaOf(const RigidBody& body);

/** Returns where `anchor` is at the start. World frame. [m]
 @pre It is on something that `world` has. */
Eigen::Vector3d StartOf(const World& world, const Anchor& anchor);

/** What a world may ask of an engine, beyond gravity and free motion. */
enum class WorldFeature {
  kSphere,      ///< A moving sphere that collides.
  kBox,         ///< A moving box that collides.
  kOtherShape,  ///< A moving body of any other shape that collides.
  kStaticSphere,
  kStaticBox,
  kStaticHalfSpace,
  kStaticOtherShape,
  kStatedInertia,    ///< A body whose inertia is not that of its shape.
  kRestitution,      ///< Two bodies that can meet with e > 0.
  kUnequalFriction,  ///< Bodies with different friction, so that the rule matters.
  kForce,
  kParticle,
  kSpring,  ///< Between bodies, particles or the world.
  kDistanceJoint,
  kCloth,
  kPush,
};

inline constexpr int kWorldFeatures = static_cast<int>(WorldFeature::kPush) + 1;

/** Returns the name used in tables: "sphere", "static box", "distance joint", … */
std::string_view NameOf(WorldFeature feature);

/** Returns what `world` asks of an engine, in the order of the enumeration. */
std::vector<WorldFeature> FeaturesOf(const World& world);

}  // namespace touchstone
