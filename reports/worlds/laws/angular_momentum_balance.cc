#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "reports/text/told_apart.h"
#include "reports/worlds/law_support/allowed_motion.h"
#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/contact_history.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/overlap.h"
#include "reports/worlds/law_support/reported_impulses.h"
#include "reports/worlds/law_support/scheme_drift.h"
#include "reports/worlds/law_support/universal.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/laws/every_law.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

bool IsIsotropic(const RigidBody& body) {
  const Eigen::Vector3d inertia = InertiaOf(body);
  return inertia.maxCoeff() == inertia.minCoeff();
}

/** Returns the radius of gyration about the axis of the least moment. [m] */
double LeastGyration(const RigidBody& body) {
  return std::sqrt(InertiaOf(body).minCoeff() / body.mass);
}

/** The tolerance that contacts give to a body between two samples. */
struct ContactGrant {
  double moments = 0;    ///< Σ |p − c| |J|, no point off the body. [N m s]
  double impulses = 0;   ///< Σ |J|. [N s]
  double separated = 0;  ///< Σ |s| |J|. [N m s]
  double turned = 0;     ///< The largest turn by a correction of s. [rad]
};

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
    const double start = motion_.trajectory.times[s - 1];
    const double end = motion_.trajectory.times[s];
    const std::vector<const ContactImpulse*>& contacts = reported.on_body[Index()];
    const Eigen::Vector3d c_W = (At(s - 1).p_WB + At(s).p_WB) / 2;
    Eigen::Vector3d given_W = Eigen::Vector3d::Zero();
    for (const Push* push : PushesBetween(motion_.world, index_, start, end))
      given_W += PushLever(*push, s).cross(push->J_W);
    const Eigen::Vector3d gained_W = MomentumOf(At(s)) - MomentumOf(At(s - 1));
    given_W += NearestMoment(contacts, s, gained_W - given_W);
    const double error = (gained_W - given_W).norm();
    // Depths are measured only where they decide: that takes a referee.
    ContactGrant grant = GrantOf(contacts, s, c_W, [](const auto&) { return 0.0; });
    double tolerance = ToleranceOf(grant, reported, s);
    if (!(error <= tolerance)) {
      grant = GrantOf(contacts, s, c_W, [&](const ContactImpulse& contact) {
        return std::min(std::abs(contact.separation), MostSeparation(contact, s));
      });
      tolerance = ToleranceOf(grant, reported, s);
    }
    worst.Take(error, tolerance, [&] {
      const ToldApart told = TellApart(gained_W, given_W, 9);
      return Citing(
          "{} has {} gain an angular momentum of {} from {:.6g} to {:.6g} s; "
          "pushes and the reported contacts have a moment of {} about its centre",
          motion_.oracle.name, CitedName{body_.name}, told.a, start, CitedTime{end},
          told.b);
    });
  }

 private:
  /** Returns the moment of the contacts about a centre on the way of the body's, the
   moment nearest to `gained_W`: nobody tells where the centre was. It is on the straight
   way between the samples; or, if they are a step apart, on the way on from the first or
   back from the second. [N m s] */
  Eigen::Vector3d NearestMoment(const std::vector<const ContactImpulse*>& contacts,
                                std::size_t s, const Eigen::Vector3d& gained_W) const {
    const BodyState& from = At(s - 1);
    const BodyState& to = At(s);
    Eigen::Vector3d impulse_W = Eigen::Vector3d::Zero();
    Eigen::Vector3d moment_W = Eigen::Vector3d::Zero();
    for (const ContactImpulse* contact : contacts) {
      const Eigen::Vector3d J_W = ImpulseOn(*contact, index_);
      impulse_W += J_W;
      moment_W += (contact->p_WC - from.p_WB).cross(J_W);
    }
    Eigen::Vector3d nearest_W = moment_W;
    const auto take = [&](const Eigen::Vector3d& first_W, const Eigen::Vector3d& way_W) {
      const Eigen::Vector3d at_first_W =
          moment_W - (first_W - from.p_WB).cross(impulse_W);
      const Eigen::Vector3d change_W = way_W.cross(impulse_W);
      const double size = change_W.squaredNorm();
      const double share =
          size > 0 ? std::clamp(change_W.dot(at_first_W - gained_W) / size, 0.0, 1.0) : 0;
      const Eigen::Vector3d moved_W = at_first_W - share * change_W;
      if ((moved_W - gained_W).norm() < (nearest_W - gained_W).norm())
        nearest_W = moved_W;
    };
    take(from.p_WB, to.p_WB - from.p_WB);
    if (motion_.world.sample_every == 1) {
      take(from.p_WB, motion_.world.dt * from.v_WB);
      take(to.p_WB, -motion_.world.dt * to.v_WB);
    }
    return nearest_W;
  }

  /** Returns the sums over `contacts`, whose separations [m] `depth_of` returns. */
  template <typename DepthOf>
  ContactGrant GrantOf(const std::vector<const ContactImpulse*>& contacts, std::size_t s,
                       const Eigen::Vector3d& c_W, DepthOf&& depth_of) const {
    ContactGrant grant;
    for (const ContactImpulse* contact : contacts) {
      const double depth = depth_of(*contact);
      // A point off the body is the engine's, and grants no more than one on it.
      const double lever =
          std::min((contact->p_WC - c_W).norm(),
                   BoundingRadius(body_.placed.shape) + depth + LeverMotion(s));
      const double J = contact->J_B_W.norm();
      grant.moments += lever * J;
      grant.impulses += J;
      grant.separated += depth * J;
      if (depth > 0) {
        grant.turned = std::max(grant.turned, std::min(depth / lever, TurnBy(depth)));
      }
    }
    return grant;
  }

  /** Returns the most that an impulse at any lever turns the body if it moves the point
   by `depth`: with u = r × n, q = uᵀI⁻¹u it turns |I⁻¹u| depth/(1/m + q), and |I⁻¹u| is
   at most √(q/I_min). That is largest at q = 1/m. [rad] */
  double TurnBy(double depth) const { return depth / (2 * LeastGyration(body_)); }

  /** Returns how far the bodies of `contact` may be apart or inside each other there:
   their depth at either sample, and what they move in between. A contact with a gap acts
   in a step that closes the gap. [m] */
  double MostSeparation(const ContactImpulse& contact, std::size_t s) const {
    double most = 0;
    for (const std::size_t k : {s - 1, s}) {
      most = std::max(most, OverlapOf(motion_.world, motion_.trajectory.samples[k],
                                      contact.A, contact.B)
                                .depth);
    }
    return most + SurfaceMotion(contact.A, s) + SurfaceMotion(contact.B, s);
  }

  double ToleranceOf(const ContactGrant& grant, const ReportedImpulses& reported,
                     std::size_t s) const {
    const World& world = motion_.world;
    const BodyState& from = At(s - 1);
    const BodyState& to = At(s);
    const double time = motion_.trajectory.times[s] - motion_.trajectory.times[s - 1];
    double moments = grant.moments;
    double legal = grant.separated + grant.impulses * LeverMotion(s) + gyroscopic_[s] -
                   gyroscopic_[s - 1];
    for (const Push* push : PushesBetween(world, index_, motion_.trajectory.times[s - 1],
                                          motion_.trajectory.times[s])) {
      const double moment = push->p_BoP.norm() * push->J_W.norm();
      moments += moment;
      // The body turns between the sample and the push.
      const double turn =
          allowed_.At(s - 1).bodies[Index()].w_WB.norm() * (time - world.dt);
      legal += std::min(turn, 2.0) * moment;
    }
    double wobble = 0;
    if (!is_isotropic_) {
      const BodyState& before = allowed_.At(s - 1).bodies[Index()];
      const BodyState& after = allowed_.At(s).bodies[Index()];
      const double spin = std::max(before.w_WB.norm(), after.w_WB.norm());
      const double largest =
          std::max(MomentumOf(before).norm(), MomentumOf(after).norm());
      const double change = (after.w_WB - before.w_WB).norm();
      if (moments > 0) legal += time * (spin * moments + change * largest);
      legal += std::min(grant.turned, 1.0) * largest;
      // A step rounds the spin about the axis of the least moment like the torques of the
      // other axes, by I_max/I_min u |ω|. The spins at both ends turn L in between.
      const Eigen::Vector3d inertia = InertiaOf(body_);
      wobble = inertia.maxCoeff() / inertia.minCoeff() * spin * time * largest;
    }
    // A rounding of the orientation turns I, by the largest moment even about the axis of
    // the smallest.
    const double spins =
        InertiaOf(body_).maxCoeff() * (from.w_WB.norm() + to.w_WB.norm());
    // The points of contacts are rounded in the world frame.
    const double reach = from.p_WB.norm() + to.p_WB.norm() +
                         BoundingRadius(body_.placed.shape) + LeverMotion(s);
    // The two momenta are themselves measured with the rounding of a step each: a
    // quaternion is normalised (9) and made a matrix (10), which turns I (10) and meets
    // the spin (5).
    const double rounding =
        RoundingOf(motion_.oracle, world.sample_every + 2) * spins +
        RoundingOf(motion_.oracle, 1) * wobble +
        RoundingOf(motion_.oracle, world.sample_every) *
            (moments + reach * grant.impulses) +
        InertiaOf(body_).maxCoeff() * motion_.oracle.unit_roundoff / world.dt;
    const double solver =
        SolverRoundingOf(motion_.oracle) * reported.contacts_per_step * grant.moments;
    return kSafety * legal + rounding + solver +
           SleepLossBefore(motion_, reported, index_, s).angular;
  }

  std::size_t Index() const { return static_cast<std::size_t>(index_); }

  const BodyState& At(std::size_t s) const {
    return motion_.trajectory.samples[s].bodies[Index()];
  }

  Eigen::Vector3d MomentumOf(const BodyState& at) const {
    return InertiaInWorld(body_, at.q_WB.normalized()) * at.w_WB;
  }

  Eigen::Vector3d PushLever(const Push& push, std::size_t s) const {
    return At(s - 1).q_WB.normalized() * push.p_BoP;
  }

  /** The largest speeds of a body between two samples. */
  struct Speeds {
    double centre = 0;   ///< [m/s]
    double surface = 0;  ///< Of any point on it. [m/s]
  };

  Speeds SpeedsOf(int index, std::size_t s) const {
    const auto i = static_cast<std::size_t>(index);
    const RigidBody& body = motion_.world.bodies[i];
    if (body.mass == 0) return {};
    const double R = std::holds_alternative<Sphere>(body.placed.shape)
                         ? 0
                         : BoundingRadius(body.placed.shape);
    const double gained =
        AccelerationOf(motion_.world, body).norm() * SampleSpacing(motion_.world);
    Speeds speeds;
    for (const std::size_t k : {s - 1, s}) {
      const BodyState& at = allowed_.At(k).bodies[i];
      speeds.centre = std::max(speeds.centre, at.v_WB.norm() + gained);
      speeds.surface =
          std::max(speeds.surface, at.v_WB.norm() + at.w_WB.norm() * R + gained);
    }
    return speeds;
  }

  /** Returns how far the lever of a contact may be from that to NearestMoment()'s centre:
   the point by a step, and the centre by half of what samples are farther apart. [m] */
  double LeverMotion(std::size_t s) const {
    const Speeds speeds = SpeedsOf(index_, s);
    const double h = motion_.world.dt;
    return speeds.centre * (SampleSpacing(motion_.world) - h) / 2 + speeds.surface * h;
  }

  /** Returns how far the surface of a body may move between two samples. [m] */
  double SurfaceMotion(int index, std::size_t s) const {
    return SpeedsOf(index, s).surface * SampleSpacing(motion_.world);
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
      WithSleep(
          "1.5 × what a legal scheme differs by: levers that move by |v| (Δt − h)/2 + V "
          "h or "
          "lie a separation away, at most that of the bodies; h ∫ |ω × (ω × L)| and "
          "h (|ω| |ΔL| + |Δω| |L|) of the gyroscopic term, and |L| |s|/|p − c| of "
          "position correction, at most |L| |s|/2k with the least radius of gyration k; "
          "64 roundings per step and of I_max/I_min |ω| |L| Δt, and for each contact of "
          "a "
          "step the moments times the square root of the unit roundoff",
          motion.oracle));
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

/** A body's angular momentum about its centre c changes by the moments of the pushes and
 of the contact impulses that the engine reports:

    Δ(R I Rᵀ ω) = Σ (p − c) × J.  [N m s]

 Gravity and the body's force act at c. The points p are those that the engine reports.
 Nobody tells where c was when the contacts acted. It is taken where it explains most on
 three ways: straight from sample to sample; and if these are a step h apart, on from the
 first at its velocity, and back from the second. The tolerance is what a legal scheme may
 differ by, × 1.5, at speeds that the truth allows:

 - levers: |v| (Δt − h)/2 |J|, since c may leave the straight way between distant samples;
   V h |J| and |s| |J|, since p may be a point on either body at the start or at the end
   of its step. V is |v| + |ω| R, for a sphere |v|, and s the separation;
 - the gyroscopic term: h ∫ |ω × (ω × L)| (law_support/scheme_drift.h), and h (|ω| |ΔL| +
   |Δω| |L|), since it acts on the spin before or after the impulses. Zero for bodies with
   equal moments of inertia;
 - position correction: it may turn the body by |s|/|p − c| and leave ω, which changes L
 by that share. Zero for the same bodies.

 Rounding is that of momentum_balance, with the levers; and 64 roundings of I |ω| for
 the momentum at either sample. An engine that takes spins from orientations knows them to
 u/h, so I u/h is granted at rest too, as NoiseOfPositions() (truth/mechanics.h) of
 places. Judges only engines that report contact impulses. About: bodies that no spring or
 joint holds. Numbers: none. */
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
