#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/dynamics/contact_batch.h"
#include "engine/dynamics/contact_pair.h"
#include "engine/dynamics/crew.h"
#include "engine/dynamics/settings.h"

namespace cookbook {

/** Everything about the bodies that a solver sees, by body index. The velocities have one
 more place at the end, zero, for lanes without a pair. */
struct SolverBodies {
  std::span<const RigidBody> bodies;         ///< At the start of the step.
  std::span<const InverseInertia> inertias;  ///< At the start of the step.
  std::span<const Velocity> before;          ///< At the start of the step.
  std::span<Velocity> velocities;            ///< In: without impulses; then solved.
};

/** What contacts did to a body in a step. */
struct Touch {
  bool bounced = false;  ///< Some contact sent it back.
  bool rested = false;   ///< Some contact held it.
  bool steady = true;    ///< Before the step, no contact that held it was approaching.
};

/** One contact as the solver has it. */
struct SolvedContact {
  int pair;
  int point;  ///< Of the pair's manifold.
  int A;
  int B;
  Eigen::Vector3d n;
  Eigen::Vector3d r_A;
  Eigen::Vector3d r_B;
  double separation;
  double effective_mass;
  bool bounces;
};

/** Sequential impulses: finds by sweeps the impulses that leave no contact approaching.

 With u the velocity of B against A at a contact, n the normal, h the step, u₀ and u_f
 the velocities before the step and at its end without impulses:

   u·n >= max(0, −e u₀·n + (u_f − u₀)·n)   where u₀·n < −(resting speed),
   u·n >= −e u₀·n + (u_f − u₀)·n           where e u₀·n > (resting speed),
   u·n >= min(0, −e u₀·n)                  elsewhere, or −gap / h where that is less,

 with an impulse λ >= 0 that is zero where the inequality is strict. The first line sends
 back the velocity of the start of the step and then lets the forces of the step act, so
 that a bounce at e = 1 keeps the energy whatever the step. The second and third let what
 a blow turns round in the step that it leaves in come back no faster than it left
 (Moreau's rule, under which impacts of one e together never gain energy: with u = −e u₀
 where λ > 0 and W the response, ½ λ·(u + u₀) = −½ (1 − e)/(1 + e) λ·W λ). Friction: |λ_t|
 <= μ λ in the circular cone; λ_t is against the slip where it is at the bound, and there
 is no slip where it is inside.

 Four pairs that share no moving body are solved at once. */
class ContactSolver {
 public:
  /** Sets up the rows of all pairs with contacts and applies the impulses to start from.
   */
  void Begin(std::span<const ContactPair> pairs, const SolverBodies& world,
             const Settings& settings, double h, Crew& crew);

  /** Sweeps once over all contacts at work, at first all there are, and returns the
   greatest change of a relative velocity. [m/s] */
  double Sweep(std::span<Velocity> velocities, Crew& crew);

  /** Leaves out of the next sweeps the contacts of every heap in which the last sweep
   changed no relative velocity by more than `solved` [m/s]. A heap is what contacts join,
   without what never moves: how well one is solved does not depend on the others. */
  void LeaveBe(double solved);

  /** Writes the impulses to the pairs, and what the contacts did to the bodies. */
  void End(std::span<ContactPair> pairs, std::span<Touch> touches) const;

  /** The greatest speed that a contact sees before it is solved. [m/s] */
  double scale() const { return scale_; }
  /** Contacts of the heaps that are not solved. */
  int row_count() const { return row_count_; }

  /** Calls `visit(SolvedContact)` for every contact whose separation is below `limit`. */
  template <class Visit>
  void ForEachBelow(double limit, const Visit& visit) const;

 private:
  void Colour(std::span<const ContactPair> pairs, std::span<const RigidBody> bodies);
  /** Joins the bodies of `pairs` to heaps. */
  void FindHeaps(std::span<const ContactPair> pairs, std::span<const RigidBody> bodies);
  int HeapOf(int body);
  void Fill(std::span<const ContactPair> pairs, const SolverBodies& world,
            bool warm_starting);
  /** Calls `work(rows)` for all rows: colour after colour, each shared out. */
  template <class Work>
  void ShareByColour(Crew& crew, const Work& work);

  std::vector<ContactBatch> batches_;
  std::vector<ContactLanes> contacts_;
  std::vector<std::size_t> firsts_;     ///< Batch of each colour in use, and the end.
  std::vector<std::uint64_t> colours_;  ///< Of each body: one bit for each in use.
  std::vector<int> key_;                ///< Of each pair: its colour and count, or −1.
  std::vector<int> order_;              ///< The pairs, by key.
  std::vector<int> starts_;             ///< Where in `order_` each key starts.
  /** Of each body another of its heap, or itself where it stands for the heap. */
  std::vector<int> heap_;
  /** Of each body that stands for a heap: what the last sweep changed there. [m/s] */
  std::vector<double> heap_changes_;
  bool accumulated_ = true;
  double scale_ = 0;
  double least_change_ = 0;  ///< Of a pair at work, in the last sweep. [m/s]
  int row_count_ = 0;
};

template <class Visit>
void ContactSolver::ForEachBelow(double limit, const Visit& visit) const {
  for (const ContactBatch& batch : batches_) {
    for (int k = 0; k < batch.count; ++k) {
      const ContactLanes& contact = contacts_[static_cast<std::size_t>(batch.first + k)];
      for (std::size_t lane = 0; lane < 4; ++lane) {
        if (contact.used[lane] == 0 || contact.separation[lane] >= limit) continue;
        const auto at = [&](const VectorLanes& v) {
          return Eigen::Vector3d(v[0][lane], v[1][lane], v[2][lane]);
        };
        visit(SolvedContact{batch.pair[lane], k, batch.A[lane], batch.B[lane],
                            at(batch.n), at(contact.r_A), at(contact.r_B),
                            contact.separation[lane], 1 / contact.response[lane],
                            contact.bounces[lane] != 0});
      }
    }
  }
}

}  // namespace cookbook
