#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/dynamics/contact_pair.h"
#include "engine/dynamics/settings.h"

namespace cookbook {

/** Everything about the bodies that a solver sees, by body index. */
struct SolverBodies {
  std::span<const RigidBody> bodies;         ///< At the start of the step.
  std::span<const InverseInertia> inertias;  ///< At the start of the step.
  std::span<Velocity> velocities;            ///< In: without impulses; then solved.
};

/** What contacts did to a body in a step. */
struct Touch {
  bool bounced = false;  ///< Some contact sent it back.
  bool rested = false;   ///< Some contact held it.
  bool steady = true;    ///< Before the step, no contact that held it was approaching.
};

/** Sequential impulses: finds by sweeps the impulses that leave no contact approaching.

 With u the velocity of B against A at a contact, n the normal, h the step, u₀ and u_f
 the velocities before the step and at its end without impulses:

   u·n >= max(0, −e u₀·n + (u_f − u₀)·n)   where u₀·n < −(resting speed),
   u·n >= 0                                elsewhere, or −gap / h where there is a gap,

 with an impulse λ >= 0 that is zero where the inequality is strict. The first line sends
 back the velocity of the start of the step and then lets the forces of the step act, so
 that a bounce at e = 1 keeps the energy whatever the step. Friction: |λ_t| <= μ λ in the
 circular cone; λ_t is against the slip where it is at the bound, and there is no slip
 where it is inside. */
class ContactSolver {
 public:
  /** Sets up the rows of all touching pairs and applies the impulses to start from. */
  void Begin(std::span<ContactPair> pairs, const SolverBodies& world,
             const Settings& settings, double h);

  /** Sweeps once over all contacts and returns the greatest change of a relative
   velocity. [m/s] */
  double Sweep(std::span<Velocity> velocities);

  /** Writes the impulses to the pairs. */
  void End(std::span<ContactPair> pairs, std::span<Touch> touches) const;

  /** The greatest speed that a contact sees before it is solved. [m/s] */
  double scale() const { return scale_; }
  int row_count() const { return row_count_; }

  /** One contact point while it is solved. */
  struct Row {
    Eigen::Vector3d r_A;  ///< From the centre of A. [m]
    Eigen::Vector3d r_B;
    double target;          ///< Least u·n; −∞ where the contact is let be. [m/s]
    double effective_mass;  ///< 1 / k(n). [kg]
    double mass_scale;      ///< 1 for a hard contact; see Stabilisation::kSoft.
    double impulse_scale;   ///< 0 for a hard contact.
    double impulse;         ///< λ. [N s]
    Eigen::Matrix2d K_t;    ///< Response of the slip along t1, t2. [1/kg]
    Eigen::Matrix2d inverse_K_t;
    double slip_step;                  ///< 1 / the greatest eigenvalue of K_t. [kg]
    Eigen::Vector2d friction_impulse;  ///< λ_t. [N s]
    bool bounces;
    bool steady;  ///< Before the step it did not approach, but for rounding and noise.
  };

  /** The contacts of one pair. */
  struct Rows {
    std::size_t pair;
    int A;
    int B;
    Eigen::Vector3d n;
    Eigen::Vector3d t1;
    Eigen::Vector3d t2;
    double friction;
    int count;
    std::array<Row, 8> rows;
  };

  std::span<const Rows> rows() const { return rows_; }

 private:
  double Solve(const Rows& rows, Row& row, Velocity& A, Velocity& B) const;

  std::vector<Rows> rows_;
  std::span<const InverseInertia> inertias_;
  bool accumulated_ = true;
  double scale_ = 0;
  int row_count_ = 0;
};

}  // namespace cookbook
