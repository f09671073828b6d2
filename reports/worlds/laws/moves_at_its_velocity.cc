#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "reports/text/format_vector.h"
#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/clusters.h"
#include "reports/worlds/law_support/contact_history.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/overlap.h"
#include "reports/worlds/law_support/pairs.h"
#include "reports/worlds/law_support/reported_impulses.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/universal.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/laws/every_law.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults =
      FaultsOfSubjects(world, claim, {.bodies = true, .particles = true, .cloths = true});
  if (!faults.empty()) return faults;
  return FaultsOfNumbers(claim, {});
}

/** The known changes of a velocity in a step. [m/s] or [rad/s] */
struct Causes {
  Vector3d sum = Vector3d::Zero();
  double size = 0;  ///< Sum of the magnitudes.

  void Add(const Vector3d& change) {
    sum += change;
    size += change.norm();
  }

  /** Returns the total variation of a velocity that changes by `gained` in all: one more
   change explains the rest. */
  double VariationOf(const Vector3d& gained) const {
    return size + (gained - sum).norm();
  }
};

/** Returns the rotation vector of the turn from `from` to `to` that is nearest to
 `expected`: a turn does not tell how many whole turns it contains. [rad] */
Vector3d TurnBetween(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to,
                     const Vector3d& expected) {
  Eigen::Quaterniond turn = to * from.conjugate();
  if (turn.w() < 0) turn.coeffs() *= -1;
  const double sine = turn.vec().norm();
  if (sine == 0) {
    const double size = expected.norm();
    const double whole = 2 * std::numbers::pi * std::round(size / (2 * std::numbers::pi));
    return whole == 0 ? Vector3d::Zero() : Vector3d(expected * (whole / size));
  }
  const Vector3d axis = turn.vec() / sine;
  const double angle = 2 * std::atan2(sine, turn.w());
  const double turns = std::round((axis.dot(expected) - angle) / (2 * std::numbers::pi));
  return axis * (angle + 2 * std::numbers::pi * turns);
}

/** Factor on the bounds of forces and contacts that are not reported: contacts can act
 twice in a corner, and both act at each of the four stages of a Runge–Kutta step. [-] */
constexpr double kUnreported = 4;

/** One step of a translation or of a rotation. */
struct StepOf {
  Vector3d moved;    ///< Displacement or rotation vector. [m] or [rad]
  Vector3d from;     ///< Velocity at the start. [m/s] or [rad/s]
  Vector3d to;       ///< Velocity at the end. [m/s] or [rad/s]
  double variation;  ///< Total variation of the velocity, at most. [m/s] or [rad/s]

  /** Returns how far `moved` is at least from all that steps of `h` [s] at velocities
   between the two make: half of what the way by `moved` is longer than the straight. */
  double Excess(double h) const {
    const double way = (moved - h * from).norm() + (moved - h * to).norm();
    return std::max(0.0, way - h * (to - from).norm()) / 2;
  }

  /** Returns the same of all that velocities make which vary by `variation`. */
  double Detour(double h) const {
    return std::max(0.0, h * (variation - (to - from).norm()) / 2);
  }
};

/** Upper bounds of the forces and impulses of all rods in a step. */
struct Linkage {
  double energy = 0;         ///< Kinetic energy of all that rods hold, at most. [J]
  double force = 0;          ///< Of a rod, at most. [N]
  bool has_contact = false;  ///< Whether anything touches what rods hold.
};

/** Returns the least radius of gyration. [m] */
double LeastGyration(const RigidBody& body) {
  return std::sqrt(InertiaOf(body).minCoeff() / body.mass);
}

/** Returns the largest spin by an impulse on the surface of a body that gives its centre
 the speed 1. [1/m] */
double LongestArm(const RigidBody& body) {
  return BoundingRadius(body.placed.shape) * body.mass / InertiaOf(body).minCoeff();
}

Body AtPoint(const Vector3d& p_W) {
  return {Sphere{0}, Pose::FromQuaternion(p_W, Eigen::Quaterniond::Identity())};
}

class Judgement {
 public:
  Judgement(const Motion& motion, const Claim& claim)
      : motion_(motion),
        world_(motion.world),
        subjects_(SubjectsOf(motion.world, claim)),
        h_(motion.world.dt),
        rounding_(RoundingOf(motion.oracle, 1)) {}

  std::vector<LawFinding> Findings() {
    for (s_ = 1; s_ < motion_.trajectory.samples.size(); ++s_) {
      reported_ = ReportedBefore(motion_, s_);
      corrections_.reset();
      linkage_.reset();
      for (const int i : subjects_.bodies) JudgeBody(i);
      for (const int i : subjects_.particles)
        JudgePoint(world_.particles[static_cast<std::size_t>(i)].name,
                   &WorldState::particles, static_cast<std::size_t>(i),
                   IsHeld(world_, AnchorKind::kParticle, i));
      for (const int c : subjects_.cloths) {
        const Cloth& cloth = world_.cloths[static_cast<std::size_t>(c)];
        const auto first = static_cast<std::size_t>(FirstNodeOf(world_, c));
        for (int node = 0; node < cloth.n * cloth.n; ++node)
          JudgePoint(cloth.name, &WorldState::nodes,
                     first + static_cast<std::size_t>(node), true);
      }
    }
    return FindingsOf({travel_, turn_});
  }

 private:
  struct BodyCauses {
    Causes linear;
    Causes angular;
  };

  const WorldState& Before() const { return motion_.trajectory.samples[s_ - 1]; }
  const WorldState& After() const { return motion_.trajectory.samples[s_]; }

  /** Returns the changes of the velocity and the spin of a body by loads, contacts and
   pushes. */
  BodyCauses CausesOf(int index) const {
    const RigidBody& body = world_.bodies[static_cast<std::size_t>(index)];
    const BodyState& from = Before().bodies[static_cast<std::size_t>(index)];
    const Eigen::Matrix3d I_W = InertiaInWorld(body, from.q_WB);
    const Eigen::Matrix3d inverse_W = I_W.inverse();
    BodyCauses causes;
    causes.linear.Add(AccelerationOf(world_, body) * h_);
    causes.angular.Add(-inverse_W * from.w_WB.cross(I_W * from.w_WB) * h_);
    const auto add = [&](const Vector3d& J_W, const Vector3d& r_W) {
      causes.linear.Add(J_W / body.mass);
      causes.angular.Add(inverse_W * r_W.cross(J_W));
    };
    for (const ContactImpulse* contact :
         reported_.on_body[static_cast<std::size_t>(index)])
      add(ImpulseOn(*contact, index), contact->p_WC - from.p_WB);
    for (const Push* push : PushesBetween(world_, index, motion_.trajectory.times[s_ - 1],
                                          motion_.trajectory.times[s_]))
      add(push->J_W, from.q_WB * push->p_BoP);
    return causes;
  }

  void JudgeBody(int index) {
    const auto i = static_cast<std::size_t>(index);
    const RigidBody& body = world_.bodies[i];
    const BodyState& from = Before().bodies[i];
    const BodyState& to = After().bodies[i];
    const BodyCauses causes = CausesOf(index);
    StepOf travel{to.p_WB - from.p_WB, from.v_WB, to.v_WB,
                  causes.linear.VariationOf(to.v_WB - from.v_WB)};
    StepOf turn{TurnBetween(from.q_WB, to.q_WB, h_ / 2 * (from.w_WB + to.w_WB)),
                from.w_WB, to.w_WB, causes.angular.VariationOf(to.w_WB - from.w_WB)};
    const bool is_held = IsHeld(world_, AnchorKind::kBody, index);
    if (is_held) {
      travel.variation +=
          ChangesAround([&](const WorldState& state) { return state.bodies[i].v_WB; });
      turn.variation +=
          ChangesAround([&](const WorldState& state) { return state.bodies[i].w_WB; });
    }
    // Most steps pass without the bounds below, which take longer to compute.
    double corrected = 0;
    if (travel.Excess(h_) > GrantedTravel(from.p_WB, to.p_WB, travel) ||
        turn.Excess(h_) > GrantedTurn(turn)) {
      if (is_held) {
        const Linkage& linkage = LinkageInStep();
        const double least = InertiaOf(body).minCoeff();
        travel.variation += VariationBy(linkage, body.mass, 1);
        turn.variation += VariationBy(linkage, least, LongestLever(index));
      }
      if (!motion_.trajectory.gives_impulses &&
          MayTouch(PlacedAt(world_, Before(), index), index,
                   travel.from.norm() + travel.variation)) {
        turn.variation =
            kUnreported * (turn.variation + LongestArm(body) * travel.variation);
        travel.variation *= kUnreported;
      }
      corrected = CorrectionOf(index) + (is_held ? JointErrors() : 0);
    }
    travel_.Take(travel.Excess(h_), GrantedTravel(from.p_WB, to.p_WB, travel) + corrected,
                 [&] { return Proof(body.name, "move", travel); });
    turn_.Take(turn.Excess(h_), GrantedTurn(turn) + corrected / (2 * LeastGyration(body)),
               [&] { return Proof(body.name, "turn", turn); });
  }

  void JudgePoint(const std::string& name, std::vector<PointState> WorldState::*points,
                  std::size_t i, bool is_held) {
    const PointState& from = (Before().*points)[i];
    const PointState& to = (After().*points)[i];
    Causes causes;
    causes.Add(world_.gravity_W * h_);
    StepOf travel{to.p_W - from.p_W, from.v_W, to.v_W,
                  causes.VariationOf(to.v_W - from.v_W)};
    if (is_held) {
      travel.variation +=
          ChangesAround([&](const WorldState& state) { return (state.*points)[i].v_W; });
    }
    double corrected = 0;
    if (travel.Excess(h_) > GrantedTravel(from.p_W, to.p_W, travel)) {
      if (is_held && points == &WorldState::particles)
        travel.variation += VariationBy(LinkageInStep(), world_.particles[i].mass, 1);
      if (MayTouch(AtPoint(from.p_W), -1, travel.from.norm() + travel.variation))
        travel.variation *= kUnreported;
      corrected = DepthOf(from.p_W) + (is_held ? JointErrors() : 0);
    }
    travel_.Take(travel.Excess(h_), GrantedTravel(from.p_W, to.p_W, travel) + corrected,
                 [&] { return Proof(name, "move", travel); });
  }

  double GrantedTravel(const Vector3d& from, const Vector3d& to,
                       const StepOf& travel) const {
    const double size = from.norm() + to.norm() +
                        h_ * (travel.from.norm() + travel.to.norm() + travel.variation);
    return travel.Detour(h_) + rounding_ * size;
  }

  double GrantedTurn(const StepOf& turn) const {
    const double angle = h_ * std::max(turn.from.norm(), turn.to.norm());
    const double varied = h_ * turn.variation;
    return turn.Detour(h_) + rounding_ * (1 + angle + varied) + angle - std::atan(angle) +
           angle * varied;
  }

  /** Returns the changes of a velocity in the steps before and after. */
  template <typename VelocityIn>
  double ChangesAround(VelocityIn&& velocity_in) const {
    const std::vector<WorldState>& samples = motion_.trajectory.samples;
    double sum = 0;
    if (s_ > 1) sum += (velocity_in(Before()) - velocity_in(samples[s_ - 2])).norm();
    if (s_ + 1 < samples.size())
      sum += (velocity_in(samples[s_ + 1]) - velocity_in(After())).norm();
    return sum;
  }

  /** Returns whether `thing` may touch another body in the step. `index`: its own index,
   −1 for a point; `speed`: its largest speed. [m/s] */
  bool MayTouch(const Body& thing, int index, double speed) const {
    for (int other = 0; other < static_cast<int>(world_.bodies.size()); ++other) {
      const auto o = static_cast<std::size_t>(other);
      if (other == index || !world_.bodies[o].collides) continue;
      const double way =
          h_ * speed + (After().bodies[o].p_WB - Before().bodies[o].p_WB).norm();
      if (!AreFarApart(thing, PlacedAt(world_, Before(), other), way)) return true;
    }
    return false;
  }

  /** Returns the sum of all overlaps that are linked to a body: the depths at the start
   of the step, and what the velocities there add to them at the reported contacts. [m] */
  double CorrectionOf(int index) {
    if (!corrections_) {
      corrections_.emplace(world_.bodies.size());
      const auto add = [&](int A, int B, double depth) {
        if (!(depth > 0)) return;
        const bool A_moves = world_.bodies[static_cast<std::size_t>(A)].mass > 0;
        const bool B_moves = world_.bodies[static_cast<std::size_t>(B)].mass > 0;
        if (A_moves && B_moves) corrections_->Join(A, B);
        corrections_->Add(A_moves ? A : B, depth);
      };
      for (const auto& [A, B] : CollidingPairs(world_, SubjectsOf(world_, Claim{})))
        add(A, B, OverlapOf(world_, Before(), A, B).depth);
      for (const ContactImpulse* contact : ImpulsesBetween(motion_, s_ - 1, s_)) {
        const Vector3d gained_W = h_ * (VelocityAt(contact->A, contact->p_WC) -
                                        VelocityAt(contact->B, contact->p_WC));
        add(contact->A, contact->B, gained_W.dot(contact->n_AB_W));
      }
    }
    return corrections_->SumAt(index);
  }

  /** Returns the velocity at a point of a body that only loads act on in the step. [m/s]
   */
  Vector3d VelocityAt(int index, const Vector3d& p_W) const {
    const RigidBody& body = world_.bodies[static_cast<std::size_t>(index)];
    if (body.mass == 0) return Vector3d::Zero();
    const BodyState& from = Before().bodies[static_cast<std::size_t>(index)];
    return from.v_WB + AccelerationOf(world_, body) * h_ +
           from.w_WB.cross(p_W - from.p_WB);
  }

  /** Returns the bounds for this step. The force of a rod is the centripetal force of all
   the energy on the circle with the least radius. */
  const Linkage& LinkageInStep() {
    if (linkage_) return *linkage_;
    linkage_.emplace();
    Subjects held;
    double shortest = HUGE_VAL;
    const auto hold = [&](const Anchor& end) {
      if (!Moves(world_, end) || Has(held, end)) return;
      (end.on == AnchorKind::kBody ? held.bodies : held.particles).push_back(end.index);
    };
    for (const DistanceJoint& joint : world_.joints) {
      for (const Anchor* end : {&joint.A, &joint.B}) {
        hold(*end);
        if (end->on == AnchorKind::kBody && !end->point.isZero(0))
          shortest = std::min(shortest, end->point.norm());
      }
      if (joint.length > 0) shortest = std::min(shortest, joint.length);
    }
    const double energy = std::max(EnergyOf(world_, Before(), held).kinetic,
                                   EnergyOf(world_, After(), held).kinetic);
    const double speeds =
        std::sqrt(2 * energy) + h_ * std::sqrt(SquaredLoadsOf(world_, held));
    linkage_->energy = speeds * speeds / 2;
    linkage_->force = 2 * linkage_->energy / shortest;
    linkage_->has_contact =
        std::ranges::any_of(held.bodies,
                            [&](int b) {
                              const auto i = static_cast<std::size_t>(b);
                              return motion_.trajectory.gives_impulses
                                         ? !reported_.on_body[i].empty()
                                         : MayTouch(PlacedAt(world_, Before(), b), b,
                                                    Before().bodies[i].v_WB.norm());
                            }) ||
        std::ranges::any_of(held.particles, [&](int p) {
          const PointState& point = Before().particles[static_cast<std::size_t>(p)];
          return MayTouch(AtPoint(point.p_W), -1, point.v_W.norm());
        });
    return *linkage_;
  }

  /** Returns the variation by rods of the velocity of a mass `inertia` [kg] with `lever`
   1, or of the spin of a moment of inertia [kg m²] with a lever arm [m]. Rods exert
   forces, and transmit the impulses of contacts. [m/s] or [rad/s] */
  double VariationBy(const Linkage& linkage, double inertia, double lever) const {
    return kUnreported *
           (h_ * linkage.force * lever / inertia +
            (linkage.has_contact ? std::sqrt(2 * linkage.energy / inertia) : 0));
  }

  /** Returns the longest distance of a rod on a body from its centre. [m] */
  double LongestLever(int index) const {
    double longest = 0;
    for (const DistanceJoint& joint : world_.joints)
      for (const Anchor* end : {&joint.A, &joint.B})
        if (end->on == AnchorKind::kBody && end->index == index)
          longest = std::max(longest, end->point.norm());
    return longest;
  }

  /** Returns how deep a point is in bodies at the start of the step, in all. [m] */
  double DepthOf(const Vector3d& p_W) const {
    double sum = 0;
    for (int i = 0; i < static_cast<int>(world_.bodies.size()); ++i) {
      if (!world_.bodies[static_cast<std::size_t>(i)].collides) continue;
      sum += DepthOfPoint(world_, Before(), i, p_W);
    }
    return sum;
  }

  /** Returns the sum over all rods of the length error at the start of the step and the
   stretch by a step along the tangent. [m] */
  double JointErrors() const {
    const auto centripetal = [&](const WorldState& state, const Anchor& end) {
      if (end.on != AnchorKind::kBody) return 0.0;
      const BodyState& body = state.bodies[static_cast<std::size_t>(end.index)];
      return body.w_WB.squaredNorm() * end.point.norm();
    };
    double sum = 0;
    for (const DistanceJoint& joint : world_.joints) {
      double stretch = 0;
      for (const WorldState* state : {&Before(), &After()}) {
        const PointState A = StateOf(world_, *state, joint.A);
        const PointState B = StateOf(world_, *state, joint.B);
        stretch = std::max(stretch, (B.v_W - A.v_W).squaredNorm() / joint.length +
                                        centripetal(*state, joint.A) +
                                        centripetal(*state, joint.B));
        if (state == &Before()) sum += std::abs((B.p_W - A.p_W).norm() - joint.length);
      }
      sum += kSafety * h_ * h_ / 2 * stretch;
    }
    return sum;
  }

  CitingProof Proof(const std::string& name, std::string_view verb,
                    const StepOf& step) const {
    const Vector3d first = h_ * step.from;
    const Vector3d last = h_ * step.to;
    return Citing(
        "{} has {} {} by {} in the step to {:.6g} s; its velocities before and after {} "
        "it by {} and {}",
        motion_.oracle.name, CitedName{name}, verb, FormatVector(step.moved, 9),
        CitedTime{motion_.trajectory.times[s_]}, verb, FormatVector(first, 9),
        FormatVector(last, 9));
  }

  const Motion& motion_;
  const World& world_;
  Subjects subjects_;
  double h_;
  double rounding_;
  std::size_t s_ = 1;
  ReportedImpulses reported_;
  /** The depths of the overlaps at the start of the step, summed over bodies that they
   link; empty: nobody asked yet. */
  std::optional<Clusters> corrections_;
  std::optional<Linkage> linkage_;  ///< In this step; empty: nobody asked yet.
  Worst travel_{MeasureKind::kTravelError,
                "64 roundings; and the depths of overlaps and the errors of rods that a "
                "correction of positions may undo",
                Grants::kRounding};
  Worst turn_{
      MeasureKind::kTurnError,
      "64 roundings; θ − atan θ + θ δ of a turn by θ that varies by δ; and the depths "
      "of overlaps and the errors of rods that a correction of positions may "
      "undo, over twice the radius of gyration",
      Grants::kRounding};
};

}  // namespace

/** In each step, a body, particle or node moves and turns at its own velocities:
 Δx = ∫ v dt and ΔR = exp ∫ ω dt, for any integrator. [m], [rad]

 A scheme moves a body by the mean of the velocities that the body has during the step.
 They start at v₀, end at v₁, and their total variation is V. So their mean Δx/h lies in
 the ellipsoid |v − v₀| + |v − v₁| ≤ V. The value is half the amount by which
 |Δx − h v₀| + |Δx − h v₁| exceeds h |v₁ − v₀|, which is 0 for velocities between v₀ and
 v₁. The tolerance is h (V − |v₁ − v₀|)/2, and what follows.

 V is the sum of the changes by loads, pushes and reported contacts, and of the part of
 v₁ − v₀ that these do not explain. Unreported causes are bounded, and the bounds are
 multiplied by four:
 - contacts of an engine that reports none, and contacts of particles. They can act twice
   in a corner, and at each of the four stages of a Runge–Kutta step;
 - the force of a rod, at most 2 E/L. E is the kinetic energy of all bodies on rods, L
   the shortest length of a rod or of its lever arm;
 - the impulse that a rod transmits if a body on a rod has a contact, at most √(2 E m).
 The forces of springs and joints are smooth, so the changes of velocity in the steps
 before and after are added to V, too.

 The tolerance contains 64 roundings. A turn by θ whose spin varies by δ/h is also granted
 θ − atan θ + θ δ: the matrix R (I + h [ω]) made orthonormal turns by atan θ; turns about
 different axes do not commute, by θ δ/4 (Magnus, 1954); and the lever arms of impulses
 and the moments of inertia turn with the body.

 Position correction changes no velocity. It moves a body by at most the sum of all
 overlaps that are linked to the body, at the start of the step or made in it. If the
 body has a joint or spring, the length errors of all rods are added. It turns a body by
 at most that sum over twice the least radius of gyration k: an impulse at the lever arm
 a that moves its own point by d turns the body by d a/(k² + a²).

 Judges only motions with a sample at every step. About: bodies, particles and cloths.
 Numbers: none. */
constinit const Law kMovesAtItsVelocity = {
    .name = "moves_at_its_velocity",
    .documentation =
        "Bodies, particles and cloths move and turn at their own velocities.",
    .faults = Faults,
    .judge = [](const Motion& motion, const Claim& claim) -> std::vector<LawFinding> {
      // Between samples a velocity may vary by any amount.
      if (motion.world.sample_every > 1) return {};
      return Judgement(motion, claim).Findings();
    },
    .universal =
        [](const World& world) { return ClaimAboutEach(kMovesAtItsVelocity, world); },
    .of_steps = true,
};

}  // namespace touchstone
