#include "reports/worlds/study/judge_expectation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "reports/text/format_vector.h"
#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/overlap.h"
#include "reports/worlds/law_support/reach.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

template <typename Things>
std::optional<std::size_t> IndexOf(const Things& things, std::string_view name) {
  for (std::size_t i = 0; i < things.size(); ++i)
    if (things[i].name == name) return i;
  return std::nullopt;
}

/** A body or particle at one sample. */
struct At {
  Eigen::Vector3d p_W;
  Eigen::Vector3d v_W;
  Eigen::Vector3d w_W = Eigen::Vector3d::Zero();
  std::optional<Eigen::Quaterniond> q_WB = std::nullopt;
  double radius = 0;  ///< Radius of the bounding sphere. [m]
};

At StateNamed(const World& world, const WorldState& state, std::string_view name) {
  if (const auto body = IndexOf(world.bodies, name)) {
    const BodyState& at = state.bodies[*body];
    return {at.p_WB, at.v_WB, at.w_WB, at.q_WB.normalized(),
            BoundingRadius(world.bodies[*body].placed.shape)};
  }
  const PointState& at = state.particles[IndexOf(world.particles, name).value()];
  return {.p_W = at.p_W, .v_W = at.v_W};
}

/** Returns the angle by which `q` turns about the unit `axis`, in (−2π, 2π]. [rad] */
double TurnAbout(const Eigen::Quaterniond& q, const Eigen::Vector3d& axis) {
  return 2 * std::atan2(q.vec().dot(axis), q.w());
}

/** Returns e.g. "toppled at 0.3 s" or "never toppled". */
CitingProof EventInWords(std::string_view event, double time) {
  return std::isfinite(time) ? Citing("{} at {:.6g} s", event, time)
                             : Citing("never {}", event);
}

/** What a motion has of what is expected. */
class Seen {
 public:
  Seen(const Motion& motion, const MotionExpectation& expectation)
      : motion_(motion), world_(motion.world), expectation_(expectation) {}

 protected:
  std::size_t Count() const { return motion_.trajectory.samples.size(); }

  std::size_t SampleOf(double time) const {
    const double sample = std::round(time / SampleSpacing(world_));
    return std::min(static_cast<std::size_t>(sample), Count() - 1);
  }

  At AtSample(std::size_t s) const {
    return StateNamed(world_, motion_.trajectory.samples[s], expectation_.body);
  }

  At Now() const { return AtSample(SampleOf(expectation_.time)); }

  Eigen::Vector3d ValueOf(ExpectedVector::Of of) const {
    const At at = Now();
    return of == ExpectedVector::Of::kPosition   ? at.p_W
           : of == ExpectedVector::Of::kVelocity ? at.v_W
                                                 : at.w_W;
  }

  /** Returns the angle by which the body has turned about the unit `axis`. [rad] */
  double AngleAbout(const Eigen::Vector3d& axis) const {
    return TurnAbout(Now().q_WB.value() * AtSample(0).q_WB.value().conjugate(), axis);
  }

  /** Returns the first time at which the body's direction up has tilted by more than 45°.
   [s] */
  double FirstTopple() const {
    const Eigen::Vector3d up_W = world_.gravity_W.isZero(0)
                                     ? Eigen::Vector3d::UnitY()
                                     : Eigen::Vector3d(-world_.gravity_W.normalized());
    const Eigen::Vector3d up_B = AtSample(0).q_WB->conjugate() * up_W;
    for (std::size_t s = 0; s < Count(); ++s) {
      if (!(up_W.dot(*AtSample(s).q_WB * up_B) >= std::numbers::sqrt2 / 2))
        return motion_.trajectory.times[s];
    }
    return kNever;
  }

  /** Returns the first time at which the body touches `other`. [s] */
  double FirstTouch(std::string_view other) const {
    const auto A = static_cast<int>(IndexOf(world_.bodies, expectation_.body).value());
    const auto B = static_cast<int>(IndexOf(world_.bodies, other).value());
    double first = kNever;
    for (const ContactImpulse& contact : motion_.trajectory.impulses) {
      const bool is_theirs =
          (contact.A == A && contact.B == B) || (contact.A == B && contact.B == A);
      if (!is_theirs || contact.J_B_W.isZero(0)) continue;
      first = contact.step * world_.dt;
      break;
    }
    if (motion_.trajectory.gives_impulses) return first;
    for (std::size_t s = 0; s < Count() && motion_.trajectory.times[s] < first; ++s)
      first = std::min(first, MeetAfter(s, A, B));
    return first;
  }

  /** Returns when A and B meet before the next sample; never if they do not. [s] */
  double MeetAfter(std::size_t s, int A, int B) const {
    const double spacing = SampleSpacing(world_);
    const WorldState& state = motion_.trajectory.samples[s];
    const double way =
        WayAfter(motion_, s, A) + WayAfter(motion_, s, B) + motion_.oracle.slop;
    if (AreFarApart(PlacedAt(world_, state, A), PlacedAt(world_, state, B), way))
      return kNever;
    const Gap gap = GapBetween(world_, state, A, B);
    const double now = motion_.trajectory.times[s];
    const double left = std::max(0.0, gap.length - motion_.oracle.slop);
    if (left == 0) return now;
    const double approach =
        gap.n_W.dot(VelocityAt(state, A, gap.p_WA) - VelocityAt(state, B, gap.p_WB));
    const double loads = (LoadOn(A) + LoadOn(B)) / 2;
    if (approach * spacing + loads * spacing * spacing < left) return kNever;
    // Two bodies that only the loads bring together meet by the next sample.
    return now + (approach > 0 ? std::min(left / approach, spacing) : spacing);
  }

  double LoadOn(int index) const {
    const RigidBody& body = world_.bodies[static_cast<std::size_t>(index)];
    return body.mass == 0 ? 0 : AccelerationOf(world_, body).norm();
  }

  Eigen::Vector3d VelocityAt(const WorldState& state, int index,
                             const Eigen::Vector3d& p_W) const {
    const auto i = static_cast<std::size_t>(index);
    if (world_.bodies[i].mass == 0) return Eigen::Vector3d::Zero();
    const BodyState& at = state.bodies[i];
    return at.v_WB + at.w_WB.cross(p_W - at.p_WB);
  }

  const Motion& motion_;
  const World& world_;
  const MotionExpectation& expectation_;
};

/** Judges one expectation; each function is one kind of statement. */
class Expected : private Seen {
 public:
  Expected(const Motion& motion, const MotionExpectation& expectation)
      : Seen(motion, expectation) {
    const std::string& because = expectation.because;
    finding_.tolerance = {expectation.tolerance,
                          because.empty() ? "stated with what is expected"
                                          : "stated with what is expected: " + because};
  }

  LawFinding operator()(const ExpectedVector& expected) {
    using Of = ExpectedVector::Of;
    const Eigen::Vector3d is = ValueOf(expected.of);
    finding_.measure = expected.of == Of::kPosition   ? MeasureKind::kPositionError
                       : expected.of == Of::kVelocity ? MeasureKind::kVelocityError
                                                      : MeasureKind::kSpinError;
    const std::string_view quantity = expected.of == Of::kPosition   ? "a position"
                                      : expected.of == Of::kVelocity ? "a velocity"
                                                                     : "a spin";
    const std::string_view unit = UnitOf(finding_.measure);
    if (expected.along) {
      const Eigen::Vector3d along = expected.along->normalized();
      return Done(std::abs((is - expected.value).dot(along)),
                  Citing("{} of {:.6g} {} along {}", quantity, expected.value.dot(along),
                         unit, FormatVector(along, 6)),
                  Citing("{:.6g} {}", is.dot(along), unit));
    }
    const double off = (is - expected.value).norm();
    if (expected.of == Of::kPosition) {
      return Done(off,
                  Citing("{} of {} {}", quantity, CitedPoint{expected.value, 6}, unit),
                  Citing("{} {}", CitedPoint{is}, unit));
    }
    return Done(off,
                Citing("{} of {} {}", quantity, FormatVector(expected.value, 6), unit),
                Citing("{} {}", FormatVector(is, 9), unit));
  }

  LawFinding operator()(const ExpectedOrientation& expected) {
    finding_.measure = MeasureKind::kOrientationError;
    const Eigen::Quaterniond is = Now().q_WB.value();
    const auto words = [](const Eigen::Quaterniond& q) {
      return fmt::format("({:.6g}, {:.6g}, {:.6g}, {:.6g})", q.w(), q.x(), q.y(), q.z());
    };
    return Done(is.angularDistance(expected.q_WB.normalized()),
                Citing("an orientation of {}", words(expected.q_WB)),
                Citing("{}", words(is)));
  }

  LawFinding operator()(const ExpectedAngle& expected) {
    finding_.measure = MeasureKind::kOrientationError;
    const Eigen::Vector3d axis = expected.axis.normalized();
    const double is = AngleAbout(axis);
    const double off = std::remainder(is - expected.angle, 2 * std::numbers::pi);
    return Done(
        std::abs(off),
        Citing("an angle of {:.6g} rad about {}", expected.angle, FormatVector(axis, 6)),
        Citing("{:.6g} rad", expected.angle + off));
  }

  LawFinding operator()(const ExpectedTouch& expected) {
    finding_.measure = MeasureKind::kEventTime;
    GrantSamples(SampleSpacing(world_) + world_.dt, "and a contact may act a step late");
    const double touch = FirstTouch(expected.other);
    // Also equal if neither ever touches.
    const double off =
        touch == expectation_.time ? 0 : std::abs(touch - expectation_.time);
    return Done(off, Citing("to touch {} first", CitedName{expected.other}),
                EventInWords("touched it", touch));
  }

  LawFinding operator()(const ExpectedTopple& expected) {
    finding_.measure = MeasureKind::kEventTime;
    finding_.tolerance = {0, "the attitude at the sample of that time decides"};
    const double topple = FirstTopple();
    const double spacing = SampleSpacing(world_);
    const bool has_toppled = topple <= expectation_.time + spacing / 2;
    // The first sample with another attitude is at most a spacing late.
    const double off = std::abs(topple - expectation_.time) + spacing;
    return Done(has_toppled == expected.topples ? 0 : off,
                Citing("{}", expected.topples ? "to topple" : "not to topple"),
                EventInWords("toppled", topple));
  }

  LawFinding operator()(const ExpectedRest&) {
    finding_.measure = MeasureKind::kVelocityError;
    double fastest = 0;
    double when = expectation_.time;
    for (std::size_t s = SampleOf(expectation_.time); s < Count(); ++s) {
      const At at = AtSample(s);
      const double speed = at.v_W.norm() + at.w_W.norm() * at.radius;
      // Written so that a NaN is the fastest of all.
      if (speed <= fastest || std::isnan(fastest)) continue;
      fastest = speed;
      when = motion_.trajectory.times[s];
    }
    return Done(fastest, Citing("to rest from then on"),
                Citing("a speed of {:.6g} m/s at {:.6g} s", fastest, CitedTime{when}));
  }

  LawFinding operator()(const ExpectedTrajectory& expected) {
    finding_.measure = MeasureKind::kPositionError;
    double farthest = -1;
    const ReferenceState* worst = nullptr;
    for (const ReferenceState& state : expected.states) {
      const std::size_t s = SampleOf(state.time);
      const At at = StateNamed(world_, motion_.trajectory.samples[s], state.name);
      double apart = (at.p_W - state.p_W).norm();
      if (at.q_WB && state.q_WB)
        apart += at.radius * at.q_WB->angularDistance(state.q_WB->normalized());
      if (apart <= farthest || std::isnan(farthest)) continue;
      farthest = apart;
      worst = &state;
    }
    return Found(
        farthest,
        Citing("{}:{} expects {} at {} after {:.6g} s; {} has it elsewhere, each point "
               "of it at most {:.6g} m off",
               expected.file, worst->line, CitedName{worst->name}, CitedPoint{worst->p_W},
               CitedTime{worst->time}, motion_.oracle.name, farthest));
  }

 private:
  void GrantSamples(double time, std::string_view also) {
    finding_.tolerance.value += time;
    finding_.tolerance.because +=
        fmt::format("; an event is seen to a sample{}{}", also.empty() ? "" : ", ", also);
  }

  LawFinding Done(double value, const CitingProof& expected, const CitingProof& is) {
    return Found(value, Citing("{} is expected {} {} {:.6g} s; {} has {}",
                               CitedName{expectation_.body}, expected, WhenWord(),
                               CitedTime{expectation_.time}, motion_.oracle.name, is));
  }

  LawFinding Found(double value, CitingProof proof) {
    finding_.value = value;
    finding_.proof = std::move(proof.sentence);
    finding_.cited = std::move(proof.cited);
    // An expectation is about one moment.
    finding_.cited.first_time = finding_.cited.time;
    return finding_;
  }

  std::string_view WhenWord() const {
    if (std::holds_alternative<ExpectedTopple>(expectation_.what)) return "by";
    return std::holds_alternative<ExpectedRest>(expectation_.what) ? "after" : "at";
  }

  LawFinding finding_;
};

/** Replaces what is stated by what the motion has. */
class Met : private Seen {
 public:
  using Seen::Seen;

  std::optional<MotionExpectation> operator()(ExpectedVector met) {
    met.value = ValueOf(met.of);
    return With(met, expectation_.time);
  }
  std::optional<MotionExpectation> operator()(const ExpectedOrientation&) {
    return With(ExpectedOrientation{Now().q_WB.value()}, expectation_.time);
  }
  std::optional<MotionExpectation> operator()(ExpectedAngle met) {
    met.angle = AngleAbout(met.axis.normalized());
    return With(met, expectation_.time);
  }
  std::optional<MotionExpectation> operator()(const ExpectedTouch& met) {
    return With(met, FirstTouch(met.other));
  }
  std::optional<MotionExpectation> operator()(const ExpectedTopple& met) {
    return With(ExpectedTopple{!met.topples}, expectation_.time);
  }
  std::optional<MotionExpectation> operator()(const ExpectedRest&) {
    return std::nullopt;
  }
  std::optional<MotionExpectation> operator()(ExpectedTrajectory met) {
    for (ReferenceState& state : met.states) {
      const std::size_t s = SampleOf(state.time);
      const At at = StateNamed(world_, motion_.trajectory.samples[s], state.name);
      state.p_W = at.p_W;
      if (state.q_WB) state.q_WB = at.q_WB;
    }
    return With(std::move(met), expectation_.time);
  }

 private:
  template <typename What>
  MotionExpectation With(What what, double time) const {
    MotionExpectation met = expectation_;
    met.what = std::move(what);
    met.time = time;
    return met;
  }
};

}  // namespace

LawFinding JudgeExpectation(const Motion& motion, const MotionExpectation& expectation) {
  return std::visit(Expected(motion, expectation), expectation.what);
}

std::optional<MotionExpectation> MetBy(const Motion& motion,
                                       const MotionExpectation& expectation) {
  return std::visit(Met(motion, expectation), expectation.what);
}

}  // namespace touchstone
