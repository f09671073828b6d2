#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "scenarios/contact_query.h"

namespace touchstone {

/** A rigid body of a world, with its initial state. */
struct RigidBody {
  std::string name;  ///< Unique among bodies, particles and cloths.
  Body placed;       ///< Shape and pose; the body origin is the centre of mass.
  /** Mass; 0: static, with infinite mass. [kg] */
  double mass = 1;
  /** Principal moments of inertia about the centre of mass, along the body axes. Absent:
   those of a solid of uniform density. [kg m²] */
  std::optional<Eigen::Vector3d> inertia;
  Eigen::Vector3d v_WB =
      Eigen::Vector3d::Zero();  ///< Velocity of the centre of mass. [m/s]
  Eigen::Vector3d w_WB =
      Eigen::Vector3d::Zero();  ///< Angular velocity, world frame. [rad/s]
  double restitution = 0.5;     ///< Coefficient of restitution, in [0, 1].
  double friction = 0.6;        ///< Coefficient of friction, >= 0.
  /** A constant force through the centre of mass, in addition to gravity. [N] */
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();
  /** False: passes through everything. */
  bool collides = true;
};

/** A point mass. */
struct Particle {
  std::string name;
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d v_W = Eigen::Vector3d::Zero();  ///< [m/s]
  double mass = 1;                                ///< [kg]; 0: does not move.
  double damping = 0;   ///< Velocities decay as exp(−damping t). [1/s], >= 0
  double bounce = 0.7;  ///< Fraction of the normal velocity kept at an impact.
};

/** The kind of thing to which an end of a spring or a joint is attached. */
enum class AnchorKind { kWorld, kBody, kParticle };

/** An end of a spring or a joint. */
struct Anchor {
  AnchorKind on = AnchorKind::kWorld;
  int index = -1;  ///< Index into World::bodies or World::particles; −1: the world.
  /** Position in the frame of the body or the world; zero for a particle. [m] */
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
};

/** A spring with a damper. It pulls its ends together with the force k (|p_AB| − L) +
 b d|p_AB|/dt. */
struct Spring {
  Anchor A;
  Anchor B;
  double stiffness = 0;    ///< k. [N/m], >= 0
  double damping = 0;      ///< b. [N s/m], >= 0
  double rest_length = 0;  ///< L. [m], >= 0
};

/** A massless rod that keeps its ends at a fixed distance. */
struct DistanceJoint {
  Anchor A;
  Anchor B;
  double length = 0;  ///< [m], > 0
};

/** The constants of one family of springs in a cloth. */
struct ClothSprings {
  double stiffness = 0;  ///< [N/m], >= 0
  double damping = 0;    ///< [N s/m], >= 0
};

/** A square net of particles, initially parallel to the x–z plane. Node (row, column)
 starts at centre + ((column − (n−1)/2) x̂ + (row − (n−1)/2) ẑ) spacing. Rest lengths are
 the initial distances. Structural springs connect neighbours in rows and columns, shear
 springs diagonal neighbours, bend springs every second node of rows and columns. */
struct Cloth {
  std::string name;
  int n = 3;           ///< Number of nodes along a side, >= 3.
  double spacing = 1;  ///< Between neighbours. [m], > 0
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< World frame. [m]
  double node_mass = 1;                              ///< [kg], > 0
  double damping = 0;                                ///< See Particle::damping.
  double bounce = 0;                                 ///< See Particle::bounce.
  ClothSprings structural;
  ClothSprings shear;
  ClothSprings bend;
  std::vector<std::pair<int, int>> pinned;  ///< (row, column) of nodes that never move.
};

/** An impulse that the user applies at a point of a body, between two steps. */
struct Push {
  int body = 0;     ///< Index into World::bodies.
  double time = 0;  ///< A multiple of the step, before the end. [s]
  Eigen::Vector3d p_BoP =
      Eigen::Vector3d::Zero();  ///< Point of application. Body frame. [m]
  Eigen::Vector3d J_W = Eigen::Vector3d::Zero();  ///< Impulse. World frame. [N s]
};

/** A world to simulate: how does it move?

 A contact of two bodies has restitution min(e_A, e_B) and friction √(μ_A μ_B), under
 Coulomb's law with a circular cone. There is no damping except where stated, and no
 sleeping. */
struct World {
  std::vector<RigidBody> bodies;
  std::vector<Particle> particles;
  std::vector<Spring> springs;
  std::vector<DistanceJoint> joints;
  std::vector<Cloth> cloths;
  std::vector<Push> pushes;
  Eigen::Vector3d gravity_W{0, -9.82, 0};  ///< [m/s²]
  double dt = 1.0 / 240;                   ///< Time step. [s], > 0
  int steps = 240;                         ///< Number of steps, > 0.
  int sample_every = 1;                    ///< Steps between samples, > 0.
};

/** Returns the same world with a step shorter by `factor`, the same duration and samples
 at the same times. @pre factor > 0 */
World Refined(const World& world, int factor);

/** Returns the principal moments of inertia of `body` about its centre: the stated ones,
 else those of its shape at uniform density. Zero for a static body. [kg m²]
 @pre The inertia is stated, or the shape has UniformMoments(). */
Eigen::Vector3d InertiaOf(const RigidBody& body);

/** Returns the initial position of `anchor`. World frame. [m]
 @pre The anchor's body or particle exists in `world`. */
Eigen::Vector3d StartOf(const World& world, const Anchor& anchor);

/** A feature that a world may require of an engine, beyond gravity and free motion. */
enum class WorldFeature {
  kSphere,  ///< A moving sphere that collides; likewise up to kConvexHull.
  kBox,
  kCapsule,
  kCylinder,
  kCone,
  kConvexHull,
  kStaticSphere,
  kStaticBox,
  kStaticCapsule,
  kStaticCylinder,
  kStaticCone,
  kStaticConvexHull,
  kStaticHalfSpace,
  kStatedInertia,    ///< A moving body with an explicit inertia.
  kRestitution,      ///< At least two colliding bodies with e > 0.
  kFriction,         ///< At least two colliding bodies with μ > 0.
  kUnequalFriction,  ///< Different friction, so that the mixing rule matters.
  kMovingBodies,     ///< At least two moving bodies that collide, which may meet.
  kForce,
  kParticle,
  kSpring,  ///< A spring between bodies, particles or the world.
  kDistanceJoint,
  kCloth,
  kPush,
};

inline constexpr int kWorldFeatures = static_cast<int>(WorldFeature::kPush) + 1;

/** Returns the name used in tables: "sphere", "static box", "distance joint", … */
std::string_view NameOf(WorldFeature feature);

/** Returns the features that `world` requires, in the order of the enumeration. */
std::vector<WorldFeature> FeaturesOf(const World& world);

}  // namespace touchstone
