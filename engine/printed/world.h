#pragma once

#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Geometry>

#include "engine/collision/shape.h"
#include "engine/printed/errata.h"

namespace cookbook::printed {

/** A rigid body and its state. World frame unless another is named. */
struct Body {
  std::variant<Sphere, Box> shape;
  double mass = 1;  ///< [kg]; 0: static.
  /** Principal moments about the centre, along the body axes. Zero: those of the solid
   shape. [kg m²] */
  Eigen::Vector3d inertia = Eigen::Vector3d::Zero();
  double restitution = 0.5;
  double friction = 0.6;
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();  ///< Constant, added to gravity. [N]
  bool collides = true;
  Eigen::Vector3d p_WB = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Quaterniond q_WB = Eigen::Quaterniond::Identity();
  Eigen::Vector3d v_WB = Eigen::Vector3d::Zero();  ///< [m/s]
  Eigen::Vector3d w_WB = Eigen::Vector3d::Zero();  ///< [rad/s]
  /** The orientation under E-15: R = R_z(z) R_y(y) R_x(x). [rad] */
  Eigen::Vector3d angles = Eigen::Vector3d::Zero();
};

/** A point mass and its state. */
struct Particle {
  double mass = 1;     ///< [kg]; 0: fixed.
  double damping = 0;  ///< Velocities decay as exp(−damping t). [1/s]
  double bounce = 0.7;
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();         ///< [m]
  Eigen::Vector3d v_W = Eigen::Vector3d::Zero();         ///< [m/s]
  Eigen::Vector3d p_previous = Eigen::Vector3d::Zero();  ///< p_W a step ago. [m]
};

/** An end of a spring or a joint: a point of the world or of a body, or a particle. */
struct Anchor {
  enum class On { kWorld, kBody, kParticle } on = On::kWorld;
  int index = -1;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< World or body frame. [m]
};

struct Spring {
  Anchor A;
  Anchor B;
  double stiffness = 0;    ///< [N/m]
  double damping = 0;      ///< [N s/m]
  double rest_length = 0;  ///< [m]
};

struct DistanceJoint {
  Anchor A;
  Anchor B;
  double length = 0;  ///< [m]
};

/** The constants of one kind of a cloth's springs. */
struct ClothSprings {
  double stiffness = 0;  ///< [N/m]
  double damping = 0;    ///< [N s/m]
};

/** A cloth: a grid of n × n particles in the x–z plane around `centre`. */
struct Cloth {
  int n = 3;
  double spacing = 1;  ///< [m]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double node_mass = 1;  ///< [kg]
  double damping = 0;    ///< [1/s]
  double bounce = 0;
  ClothSprings structural;
  ClothSprings shear;
  ClothSprings bend;
  std::vector<std::pair<int, int>> pinned;  ///< (row, column)
};

/** The impulse of one contact in a step. */
struct ContactImpulse {
  int A;
  int B;
  Eigen::Vector3d p_WC;
  Eigen::Vector3d n_AB_W;
  Eigen::Vector3d J_B_W;  ///< Impulse on B; A received the opposite. [N s]
  double separation;      ///< Minus the depth of the pair. [m]
};

/** The parameters that the recipe leaves open, with its defaults. */
struct Settings {
  Eigen::Vector3d gravity_W{0, -9.82, 0};
  double position_correction_fraction = 0.45;
  double penetration_slop = 0.01;  ///< [m]
  int impulse_iterations = 5;
};

/** The published world with the given errata; with none, its recipes are corrected.

 A step, in the order of the recipe: find the touching pairs; apply the impulses of all
 contacts, in several iterations; integrate velocities, under the sum of forces, and
 poses; correct positions; apply springs; solve the constraints of particles and
 joints. */
class World {
 public:
  World(const Errata& errata, const Settings& settings)
      : errata_(errata), settings_(settings) {}

  /** Adds an object and returns its index.
   @throws std::invalid_argument if the object is not valid: a negative or non-finite
   number, a spring or joint from an end to itself, a cloth with n < 3. Under E-21 a cloth
   with n < 3 throws std::out_of_range: the fault is reported, not committed. */
  int Add(const Body& body);
  int Add(const Particle& particle);
  int Add(const Spring& spring);
  int Add(const DistanceJoint& joint);
  /** Returns the index of the particle at node (0, 0); the others follow row by row. */
  int Add(const Cloth& cloth);

  /** Applies an impulse `J_W` [N s] at the world point `p_W`. */
  void ApplyImpulse(int body, const Eigen::Vector3d& p_W, const Eigen::Vector3d& J_W);

  /** Advances by `dt` > 0. [s] */
  void Step(double dt);

  std::span<const Body> bodies() const { return bodies_; }
  std::span<const Particle> particles() const { return particles_; }
  /** Returns the impulse of each contact in the last step. */
  std::span<const ContactImpulse> impulses() const { return impulses_; }

 private:
  Errata errata_;
  Settings settings_;
  std::vector<Body> bodies_;
  std::vector<Particle> particles_;
  std::vector<Spring> springs_;
  std::vector<DistanceJoint> joints_;
  std::vector<ContactImpulse> impulses_;
};

}  // namespace cookbook::printed
