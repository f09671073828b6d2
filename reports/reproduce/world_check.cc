#include "reports/reproduce/world_check.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "reports/reproduce/cpp_text.h"
#include "reports/reproduce/drift_text.h"
#include "reports/reproduce/engine_code.h"
#include "reports/reproduce/overlap_text.h"
#include "reports/reproduce/passage_text.h"
#include "reports/worlds/law_support/overlap.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/laws/laws.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

/** Relative difference of a value and the same value by another order of operations: far
 more than roundings, far less than another sample or body makes. [-] */
constexpr double kSame = 1e-9;

constexpr const char* kState = R"(  const auto print = [&](int step, int i) {
    const State& s = states.at(step)[i];
    std::printf("%s after %.6g s: position (%.17g, %.17g, %.17g), velocity (%.17g, %.17g, "
                "%.17g), spin (%.17g, %.17g, %.17g)\n", kBodies[i].name, step * kStep,
                s.p[0], s.p[1], s.p[2], s.v[0], s.v[1], s.v[2], s.w[0], s.w[1], s.w[2]);
  };
)";

std::string Print(int step, int body) {
  return fmt::format("  print({}, {});\n", step, body);
}

/** Finds what a finding is about, and writes its check. */
class Search {
 public:
  Search(const Finding& finding, const WorldScenario& scenario,
         const Trajectory& trajectory)
      : finding_(finding),
        scenario_(scenario),
        world_(scenario.world),
        trajectory_(trajectory) {
    if (!finding.cited.time) return;
    const auto at = std::ranges::find(trajectory.times, *finding.cited.time);
    if (at != trajectory.times.end())
      sample_ = static_cast<std::size_t>(at - trajectory.times.begin());
  }

  std::optional<WorldCheck> Penetration() const {
    if (!sample_) return std::nullopt;
    const int count = static_cast<int>(world_.bodies.size());
    for (int A = 0; A < count; ++A) {
      for (int B = 0; B < A; ++B) {
        if (!MayTouch(A, B) || !IsValue(OverlapOf(world_, State(), A, B).depth)) continue;
        return WorldCheck{
            {OverlapText(world_, A, B),
             kState + Print(Step(), A) + Print(Step(), B) +
                 fmt::format(
                     "  const double error = Overlap(states.at({}));  // < 0: apart.\n"
                     "  std::printf(\"%s is %.17g m deep in %s; right: at most %.6g "
                     "m\\n\""
                     ",\n              kBodies[{}].name, error, kBodies[{}].name, "
                     "allowed);\n",
                     Step(), A, B)},
            {Step()}};
      }
    }
    return std::nullopt;
  }

  std::optional<WorldCheck> Passage() const {
    if (!sample_) return std::nullopt;
    const int count = static_cast<int>(world_.bodies.size());
    for (int A = 0; A < count; ++A) {
      for (int B = 0; B < count; ++B) {
        if (A == B || !MayTouch(A, B) || !HasPassage(world_, A, B)) continue;
        for (std::size_t from = 0; from < *sample_; ++from) {
          const WorldState& before = trajectory_.samples[from];
          if (!IsValue(PassageOf(world_, before, State(), A, B))) continue;
          return PassageCheck(A, B, from);
        }
      }
    }
    return std::nullopt;
  }

  std::optional<WorldCheck> Vector() const {
    for (const MotionExpectation& expectation : scenario_.expectations) {
      const auto* const expected = std::get_if<ExpectedVector>(&expectation.what);
      if (expected == nullptr || finding_.cited.time != expectation.time) continue;
      const std::optional<int> body = BodyNamed(expectation.body);
      const std::size_t sample = SampleNear(expectation.time);
      if (!body || !HasFieldOf(expected->of)) continue;
      const Eigen::Vector3d off = FieldOf(sample, *body) - expected->value;
      if (expected->along) {
        const Eigen::Vector3d along = expected->along->normalized();
        if (IsValue(std::abs(off.dot(along))))
          return Compared(sample, *body, expected->value, &along);
      } else if (IsValue(off.norm())) {
        return Compared(sample, *body, expected->value, nullptr);
      }
    }
    if (finding_.measure != MeasureKind::kPositionError || !sample_) return std::nullopt;
    const Law* const law = FindLaw(finding_.law);
    if (law == nullptr || law->places == nullptr) return std::nullopt;
    for (const Claim& claim : Claims()) {
      for (const int body : SubjectsOf(world_, claim).bodies) {
        Claim about = claim;
        about.about = {world_.bodies[static_cast<std::size_t>(body)].name};
        if (!law->faults(world_, about).empty()) continue;
        const std::vector<Eigen::Vector3d> truths =
            law->places(world_, about, {*finding_.cited.time});
        if (truths.empty()) continue;
        const Eigen::Vector3d& truth = truths.front();
        if (IsValue((FieldOf(*sample_, body) - truth).norm()))
          return Compared(*sample_, body, truth, nullptr);
      }
    }
    return std::nullopt;
  }

  std::optional<WorldCheck> Energy() const {
    if (!sample_) return std::nullopt;
    const bool only_gains = finding_.law == "energy_never_rises";
    for (const Claim& claim : Claims()) {
      const Subjects subjects = SubjectsOf(world_, claim);
      const auto energy = [&](std::size_t sample) {
        return EnergyOf(world_,
                        sample == 0 ? StateAtStart(world_) : trajectory_.samples[sample],
                        subjects)
            .total();
      };
      const double now = energy(*sample_);
      for (std::size_t from = 0; from < *sample_; ++from) {
        const double gain = now - energy(from);
        if (!IsValue(only_gains ? gain : std::abs(gain))) continue;
        return WorldCheck{
            {EnergyText(subjects.bodies),
             fmt::format(
                 "  const double before = EnergyOf({});\n"
                 "  const double after = EnergyOf(states.at({}));\n"
                 "  std::printf(\"energy %.17g J after %.6g s, %.17g J after %.6g "
                 "s\\n\", before, {} * kStep, after, {} * kStep);\n"
                 "  const double error = {}(after - before);\n",
                 from == 0 ? "Start()" : fmt::format("states.at({})", StepOf(from)),
                 Step(), StepOf(from), Step(), only_gains ? "" : "std::abs")},
            {StepOf(from), Step()}};
      }
    }
    return std::nullopt;
  }

  std::optional<WorldCheck> Momentum() const {
    if (!sample_) return std::nullopt;
    for (const Claim& claim : Claims()) {
      const Subjects subjects = SubjectsOf(world_, claim);
      Eigen::Vector3d force_W = MassOf(world_, subjects) * world_.gravity_W;
      for (const int i : subjects.bodies)
        force_W += world_.bodies[static_cast<std::size_t>(i)].force_W;
      const Eigen::Vector3d truth = MomentumOf(world_, StateAtStart(world_), subjects) +
                                    force_W * *finding_.cited.time;
      if (!IsValue((MomentumOf(world_, State(), subjects) - truth).norm())) continue;
      return WorldCheck{
          {MomentumText(subjects.bodies),
           fmt::format(
               "  const Vector P = MomentumOf(states.at({}));\n"
               "  // The start, and gravity and forces since.\n"
               "  const Vector truth = {{{}}};\n"
               "  std::printf(\"momentum (%.17g, %.17g, %.17g) N s; right: (%.17g, "
               "%.17g, %.17g) N s\\n\", P[0], P[1], P[2], truth[0], truth[1], "
               "truth[2]);\n"
               "  const double error =\n"
               "      std::hypot(P[0] - truth[0], P[1] - truth[1], P[2] - "
               "truth[2]);\n",
               Step(), Literals(truth))},
          {Step()}};
    }
    return std::nullopt;
  }

 private:
  bool IsValue(double x) const {
    return std::abs(x - finding_.value) <= kSame * std::abs(finding_.value);
  }

  bool MayTouch(int A, int B) const {
    const RigidBody& a = world_.bodies[static_cast<std::size_t>(A)];
    const RigidBody& b = world_.bodies[static_cast<std::size_t>(B)];
    const bool are_half_spaces = std::holds_alternative<HalfSpace>(a.placed.shape) &&
                                 std::holds_alternative<HalfSpace>(b.placed.shape);
    return a.collides && b.collides && (a.mass > 0 || b.mass > 0) && !are_half_spaces;
  }

  const WorldState& State() const { return trajectory_.samples[*sample_]; }

  int StepOf(std::size_t sample) const {
    return static_cast<int>(sample) * world_.sample_every;
  }
  int Step() const { return StepOf(*sample_); }

  std::size_t SampleNear(double time) const {
    const double sample = std::round(time / (world_.dt * world_.sample_every));
    return std::min(static_cast<std::size_t>(sample), trajectory_.samples.size() - 1);
  }

  std::optional<int> BodyNamed(std::string_view name) const {
    for (std::size_t i = 0; i < world_.bodies.size(); ++i)
      if (world_.bodies[i].name == name) return static_cast<int>(i);
    return std::nullopt;
  }

  /** Returns the claims that the finding may be of; one about everything is universal. */
  std::vector<Claim> Claims() const {
    std::vector<Claim> claims;
    for (const Claim& claim : scenario_.claims)
      // A claim may have the older name of its law.
      if (const Law* law = FindLaw(claim.law); law && law->name == finding_.law)
        claims.push_back(claim);
    if (finding_.universal) claims.emplace_back().law = finding_.law;
    return claims;
  }

  bool HasFieldOf(ExpectedVector::Of of) const {
    using Of = ExpectedVector::Of;
    return of == (finding_.measure == MeasureKind::kPositionError   ? Of::kPosition
                  : finding_.measure == MeasureKind::kVelocityError ? Of::kVelocity
                                                                    : Of::kSpin);
  }

  Eigen::Vector3d FieldOf(std::size_t sample, int body) const {
    const BodyState& at =
        trajectory_.samples[sample].bodies[static_cast<std::size_t>(body)];
    if (finding_.measure == MeasureKind::kPositionError) return at.p_WB;
    return finding_.measure == MeasureKind::kVelocityError ? at.v_WB : at.w_WB;
  }

  WorldCheck Compared(std::size_t sample, int body, const Eigen::Vector3d& truth,
                      const Eigen::Vector3d* along) const {
    const char field = finding_.measure == MeasureKind::kPositionError   ? 'p'
                       : finding_.measure == MeasureKind::kVelocityError ? 'v'
                                                                         : 'w';
    const std::string error =
        along == nullptr
            ? "std::hypot(off[0], off[1], off[2])"
            : fmt::format("std::abs({} * off[0] + {} * off[1] + {} * off[2])",
                          Literal(along->x()), Literal(along->y()), Literal(along->z()));
    const int step = StepOf(sample);
    return {{"", kState + Print(step, body) +
                     fmt::format("  const Vector& is = states.at({})[{}].{};\n"
                                 "  const Vector truth = {{{}}};\n"
                                 "  std::printf(\"right: (%.17g, %.17g, %.17g)\\n\", "
                                 "truth[0], truth[1], truth[2]);\n"
                                 "  const Vector off = {{is[0] - truth[0], is[1] - "
                                 "truth[1], is[2] - truth[2]}};\n"
                                 "  const double error = {};\n",
                                 step, body, field, Literals(truth), error)},
            {step}};
  }

  WorldCheck PassageCheck(int A, int B, std::size_t from) const {
    return {{PassageText(world_, A, B),
             kState + Print(StepOf(from), A) + Print(Step(), A) +
                 fmt::format(
                     "  const double error = Passage(states.at({}), states.at({}));\n"
                     "  std::printf(\"the straight way of %s between leads through %s, "
                     "%.17g m from the nearest way around; right: at most %.6g m\\n\", "
                     "kBodies[{}].name, kBodies[{}].name, error, allowed);\n",
                     StepOf(from), Step(), A, B)},
            {StepOf(from), Step()}};
  }

  const Finding& finding_;
  const WorldScenario& scenario_;
  const World& world_;
  const Trajectory& trajectory_;
  std::optional<std::size_t> sample_;  ///< That of the finding's time.
};

/** Returns what would have to hold for a number of that measure to be computed. */
std::string_view Expected(MeasureKind measure) {
  if (measure == MeasureKind::kPassage)
    return "expected a sphere that passes through a fixed sphere or box";
  if (measure == MeasureKind::kPositionError || measure == MeasureKind::kVelocityError ||
      measure == MeasureKind::kSpinError) {
    return "expected a position of a law with a closed form, or a number that an "
           "[[expect]] of the file gives";
  }
  return "expected a number of the world as the file states it, at its own step";
}

}  // namespace

WorldCheck CheckOf(const Finding& finding, const WorldScenario& scenario,
                   const Trajectory& trajectory) {
  if (finding.verdict != Verdict::kFail) {
    throw CannotReproduce(fmt::format(
        "the verdict is '{}'; expected a wrong motion: a program for a world without an "
        "answer is not supported",
        NameOf(finding.verdict)));
  }
  const Search search(finding, scenario, trajectory);
  std::optional<WorldCheck> check;
  switch (finding.measure) {
    case MeasureKind::kPenetration:
      check = search.Penetration();
      break;
    case MeasureKind::kPassage:
      check = search.Passage();
      break;
    case MeasureKind::kPositionError:
    case MeasureKind::kVelocityError:
    case MeasureKind::kSpinError:
      check = search.Vector();
      break;
    case MeasureKind::kEnergyDrift:
      check = search.Energy();
      break;
    case MeasureKind::kMomentumDrift:
      check = search.Momentum();
      break;
    default:
      throw CannotCheck(fmt::format(
          "a program cannot check {} of a world; it can check penetration, passage, "
          "position_error, velocity_error, spin_error, energy_drift and momentum_drift",
          NameOf(finding.measure)));
  }
  if (check) return *check;
  throw CannotReproduce(
      fmt::format("a program cannot compute {} of the law '{}' here; {}",
                  NameOf(finding.measure), finding.law, Expected(finding.measure)));
}

}  // namespace touchstone
