#include "reports/worlds/laws/angular_momentum_balance.h"

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "reports/text/format_vector.h"
#include "reports/worlds/law_support/allowed_motion.h"
#include "reports/worlds/law_support/contact_history.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/reported_impulses.h"
#include "reports/worlds/law_support/scheme_drift.h"
#include "reports/worlds/law_support/universal.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

bool IsIsotropic(const RigidBody& body) {
  const Eigen::Vector3d inertia = InertiaOf(body);
  return inertia.maxCoeff() == inertia.minCoeff();
}

/** Judges one body from sample to sample. */
class Balance {
 public:
  Balance(const Motion& motion, const AllowedMotion& allowed, int index)
      : motion_(motion),
        allowed_(allowed),
        index_(index),
        body_(motion.world.bodies[static_cast<std::size_t>(index)]),
        is_isotropic_(IsIsotropic(body_)),
        gyroscopic_(GyroscopicMomentumDrift(motion, allowed, Subjects{{index}, {}, {}})) {
  }

  void Take(const ReportedImpulses& reported, std::size_t s, Worst& worst) const {
    const World& world = motion_.world;
    const BodyState& from = At(s - 1);
    const BodyState& to = At(s);
    const double start = motion_.trajectory.times[s - 1];
    const double end = motion_.trajectory.times[s];
    const Eigen::Vector3d c_W = (from.p_WB + to.p_WB) / 2;
    Eigen::Vector3d given_W = Eigen::Vector3d::Zero();
    double moments = 0;    // Σ |p − c| |J|. [N m s]
    double impulses = 0;   // Σ |J|. [N s]
    double separated = 0;  // Σ |s| |J|. [N m s]
    double corrected = 0;  // The largest |s|/|p − c|. [rad]
    double reach = from.p_WB.norm() + to.p_WB.norm();
    for (const ContactImpulse* contact : reported.on_body[Index()]) {
      const Eigen::Vector3d lever_W = contact->p_WC - c_W;
      const Eigen::Vector3d J_W = ImpulseOn(*contact, index_);
      const double depth = std::abs(contact->separation);
      given_W += lever_W.cross(J_W);
      moments += lever_W.norm() * J_W.norm();
      impulses += J_W.norm();
      separated += depth * J_W.norm();
      if (depth > 0) corrected = std::max(corrected, depth / lever_W.norm());
      reach = std::max(reach, contact->p_WC.norm());
    }
    const double solver = kRoundingsOfSolver * motion_.oracle.unit_roundoff *
                          reported.contacts_per_step * moments;
    for (const Push* push : PushesBetween(world, index_, start, end)) {
      const Eigen::Vector3d lever_W = from.q_WB.normalized() * push->p_BoP;
      given_W += lever_W.cross(push->J_W);
      moments += lever_W.norm() * push->J_W.norm();
      // The body turns between the sample and the push.
      const double turn =
          allowed_.At(s - 1).bodies[Index()].w_WB.norm() * (end - start - world.dt);
      separated += std::min(turn, 2.0) * lever_W.norm() * push->J_W.norm();
    }
    const Eigen::Vector3d L_from = MomentumOf(from);
    const Eigen::Vector3d L_to = MomentumOf(to);
    double legal =
        separated + impulses * LeverMotion(s) + gyroscopic_[s] - gyroscopic_[s - 1];
    if (!is_isotropic_) {
      const BodyState& before = allowed_.At(s - 1).bodies[Index()];
      const BodyState& after = allowed_.At(s).bodies[Index()];
      const double spin = std::max(before.w_WB.norm(), after.w_WB.norm());
      const double largest =
          std::max(MomentumOf(before).norm(), MomentumOf(after).norm());
      const double change = (after.w_WB - before.w_WB).norm();
      if (moments > 0) legal += (end - start) * (spin * moments + change * largest);
      legal += std::min(corrected, 1.0) * largest;
    }
    // A rounding of the orientation turns I, by the largest moment even about the axis of
    // the smallest.
    const double spins =
        InertiaOf(body_).maxCoeff() * (from.w_WB.norm() + to.w_WB.norm());
    // The two momenta are themselves measured with the rounding of a step each: a
    // quaternion is normalised (9) and made a matrix (10), which turns I (10) and meets
    // the spin (5).
    const double rounding =
        RoundingOf(motion_.oracle, world.sample_every + 2) * spins +
        RoundingOf(motion_.oracle, world.sample_every) * (moments + reach * impulses) +
        InertiaOf(body_).maxCoeff() * motion_.oracle.unit_roundoff / world.dt;
    worst.Take((L_to - L_from - given_W).norm(), kSafety * legal + rounding + solver,
               [&] {
                 return fmt::format(
                     "{} has {} gain an angular momentum of {} from {:.6g} to {:.6g} s; "
                     "pushes and "
                     "the reported contacts have a moment of {} about its centre",
                     motion_.oracle.name, body_.name, FormatVector(L_to - L_from, 9),
                     start, end, FormatVector(given_W, 9));
               });
  }

 private:
  std::size_t Index() const { return static_cast<std::size_t>(index_); }

  const BodyState& At(std::size_t s) const {
    return motion_.trajectory.samples[s].bodies[Index()];
  }

  Eigen::Vector3d MomentumOf(const BodyState& at) const {
    return InertiaInWorld(body_, at.q_WB.normalized()) * at.w_WB;
  }

  /** Returns how far the levers of contacts may move between two samples. [m] */
  double LeverMotion(std::size_t s) const {
    const double R = std::holds_alternative<Sphere>(body_.placed.shape)
                         ? 0
                         : BoundingRadius(body_.placed.shape);
    double centre = 0;
    double surface = 0;
    for (const std::size_t k : {s - 1, s}) {
      const BodyState& at = allowed_.At(k).bodies[Index()];
      centre = std::max(centre, at.v_WB.norm());
      surface = std::max(surface, at.v_WB.norm() + at.w_WB.norm() * R);
    }
    const double spacing = SampleSpacing(motion_.world);
    const double gained = AccelerationOf(motion_.world, body_).norm() * spacing;
    return (centre + gained) * spacing / 2 + (surface + gained) * motion_.world.dt;
  }

  const Motion& motion_;
  const AllowedMotion& allowed_;
  int index_;
  const RigidBody& body_;
  bool is_isotropic_;
  std::vector<double> gyroscopic_;
};

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  if (!motion.trajectory.gives_impulses) return {};
  Worst worst(
      MeasureKind::kAngularMomentumBalance,
      "1.5 × what a legal scheme differs by: levers that move by |v| Δt/2 + V h or "
      "lie a separation away, h ∫ |ω × (ω × L)| and h (|ω| |ΔL| + |Δω| |L|) of the "
      "gyroscopic term, and |L| |s|/|p − c| of position correction; 64 roundings "
      "per step, and 3000 of the moments for each contact of a step");
  const AllowedMotion allowed(motion);
  std::vector<Balance> balances;
  for (const int i : SubjectsOf(motion.world, claim).bodies)
    balances.emplace_back(motion, allowed, i);
  for (std::size_t s = 1; s < motion.trajectory.samples.size(); ++s) {
    const ReportedImpulses reported = ReportedBefore(motion, s);
    for (const Balance& balance : balances) balance.Take(reported, s, worst);
  }
  return FindingsOf({worst});
}

}  // namespace

constinit const Law kAngularMomentumBalance = {
    .name = "angular_momentum_balance",
    .documentation =
        "A body's angular momentum changes by the moments of pushes and reported "
        "contacts.",
    .faults = FaultsOfReported,
    .judge = Judge,
    .universal =
        [](const World& world) { return ClaimAboutEach(kAngularMomentumBalance, world); },
};

}  // namespace touchstone
