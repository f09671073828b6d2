#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "engine/dynamics/solver/block_cholesky.h"

namespace cookbook {

/** Contact impulses that stop rigid bodies, as springs at all contacts would give them:
 rigid bodies on an elastic foundation (K. L. Johnson, Contact Mechanics, 1985, section
 4.3) with friction.

 The unknowns w are small displacements of the bodies, with the sign reversed. A contact
 with the stiffness k and the relative displacement y = J w of B against A has the impulse
 λ on B,

   λ_n = k max(0, y_n),   λ_t = k y_t, shortened to the length μ λ_n if it is longer,

 where n points out of A. The impulses on each body have the sum and the moment that it
 requires, Jᵀλ = b. No impulse pulls or leaves its friction cone K. Springs spread a load
 linearly over a face, and redundant contacts are no difficulty. The normal impulses come
 from what the loads press together: two walls do not hold a body between them by friction
 unless something presses it against them.

 First all springs are equal and all contacts stick, which is a linear equation. Only b
 has masses in it. If the impulses are in their cones, this is the solution. If not, the
 springs of a pair get a stiffness in proportion to the load that they bore: equal springs
 let a body tilt that rests on others with unequal loads, and contacts open that could
 stay closed. The rest is a sequence of convex problems (De Saxcé & Feng, Math. Comput.
 Modelling 28, 1998). The nearest point of the cone gives the impulse, λ = k P_K(y + g n),
 which is the derivative of ½ k |P_K(y + g n)|², so that w is the minimum of an energy.
 With g = 0 the normal impulse is that of a slope which the slip s = |y_t| − |λ_t|/k
 climbs, k (y_n + μ s). The gap g = −μ s takes that away.

 Newton's method finds the minimum. Its matrix is that of a truss, Jᵀ D J, with the
 derivatives D of λ as stiffnesses: k if a contact sticks, 0 if it is open. Steps are
 shortened to go down. A multiple of the diagonal that grows if they have to be keeps the
 matrix regular (Levenberg and Marquardt). Displacements that grow without bound mean that
 something falls or slips.

 The displacements of a high column are greater than its impulses by the square of its
 height, which loses digits of λ. So nearly right impulses are corrected themselves,
 λ + D J δw within the cones, until only roundings remain. */
class ElasticFoundation {
 public:
  using Vector = BlockCholesky::Vector;  ///< A linear vector and an angular one.

  /** Starts a problem without bodies. */
  void Clear();
  /** Adds a body. `required`: the impulse on it [N s], and its moment about the centre of
   the body [N m s]. Returns the index of the body. */
  int AddBody(const Vector& required);
  /** Adds a pair of bodies, of which one may be static: −1. `p_AB_W`: from the centre of
   A to that of B [m]; unused if one is static. The columns of `axes_W` are the normal n
   out of A, t1 and t2 = n × t1. `friction`: μ. */
  void AddPair(int A, int B, const Eigen::Vector3d& p_AB_W, const Eigen::Matrix3d& axes_W,
               double friction);
  /** Adds a contact of the last pair at `r_W` from the centre of B, or from that of A if
   B is static. [m] */
  void AddContact(const Eigen::Vector3d& r_W);

  /** Finds the impulses. Returns false if there is no equilibrium, or none was found. */
  [[nodiscard]] bool Solve();

  /** The impulse of a contact on B along n, t1 and t2, in the order of AddContact().
   [N s]
   @pre Solve() has returned true. */
  const Eigen::Vector3d& impulse(std::size_t contact) const {
    return contacts_[contact].impulse;
  }

 private:
  struct Pair {
    int A;
    int B;
    Eigen::Vector3d p_AB_W;
    Eigen::Matrix3d axes_W;
    double friction;
    double stiffness;   ///< Of the spring of each contact.
    std::size_t begin;  ///< Its first contact.
    std::size_t end;    ///< Past its last one.
  };
  /** Vectors are along n, t1 and t2. */
  struct Contact {
    Eigen::Vector3d r;  ///< From the body of AddContact(). [m]
    Eigen::Vector3d y;
    Eigen::Vector3d impulse;    ///< λ [N s]
    Eigen::Matrix3d stiffness;  ///< D, the derivative of λ
    double gap;                 ///< g
    double slip;                ///< s
  };

  /** Calls `visit(pair, y, contact)` for all contacts, with their displacement y = J w.
   */
  template <class Visit>
  void ForEachDisplacement(std::span<const Vector> w, const Visit& visit);
  /** Gives the springs of a pair a stiffness in proportion to the load of the pair. */
  void StiffenByLoad();
  /** Sets w_ to the solution if all contacts stick. Returns false if there is none. */
  bool FindSticking();
  /** Whether displacements are such that there may be an equilibrium. */
  bool IsBounded() const;
  /** Sets y, impulses, slip and stiffness of the contacts to those at w_. Returns whether
   a factorization of the old stiffness is one of the new, too. */
  bool UpdateContacts();
  /** Sets the gaps to those of the slips. Returns whether none has changed by much. */
  bool UpdateGaps();
  /** Computes residual_ and error_. */
  void UpdateResidual();
  /** The energy ½ Σ k |P_K(y + g n)|² − b·w. */
  double EnergyAt(std::span<const Vector> w);
  /** Adds the greatest fraction of step_ to w_ that lowers the energy. Returns it, or 0
   if it is too small. */
  double TakeStep();
  /** Factors JᵀDJ + `regularization` × its diagonal where all contacts stick. Returns
   false if that fails. */
  bool Factor(double regularization);
  /** Sets step_ to the step for residual_. */
  void FindStep();
  /** Corrects the impulses until only roundings remain. Returns whether that succeeds.
   `is_factored`: whether matrix_ is factored with the stiffness that contacts have. */
  bool Refine(bool is_factored);

  std::vector<Pair> pairs_;
  std::vector<BlockCholesky::Edge> edges_;  ///< The pairs of two bodies that move.
  std::vector<Contact> contacts_;
  std::vector<Vector> required_;  ///< b
  std::vector<Vector> w_;
  std::vector<Vector> trial_;  ///< Scratch of TakeStep().
  std::vector<Vector> step_;
  std::vector<Vector> residual_;  ///< b − Jᵀλ
  /** Per body: Σ k and Σ k |r|² over its contacts. They approximate its diagonal of
   JᵀJ. */
  std::vector<Eigen::Vector2d> stiffness_;
  /** Sums of the magnitudes of which residual_ is the difference: linear and angular. */
  std::vector<Eigen::Vector2d> scale_;
  double error_ = 0;  ///< Greatest residual of a body, relative to its scale.
  BlockCholesky matrix_;
};

}  // namespace cookbook
