#include "reports/worlds/law_support/prediction.h"

#include <fmt/format.h>

#include "reports/worlds/law_support/at_sample.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/slop.h"

namespace touchstone {

double ToleranceOf(const Allowed& allowed, const OracleInfo& oracle, double steps) {
  const double rounding = RoundingOf(oracle, steps);
  return kSafety * allowed.scheme + (kSolverResidual + rounding) * allowed.solved +
         rounding * allowed.computed + allowed.slop;
}

std::string AllowedWords::Because(const OracleInfo& oracle) const {
  std::string because;
  if (!scheme.empty()) because += fmt::format("1.5 × {}, ", scheme);
  if (!solved.empty()) because += fmt::format("1e-5 of {} for the solver, ", solved);
  because += because.empty() ? "64 roundings per step" : "and 64 roundings per step";
  return slop ? WithSlop(because, oracle) : because;
}

Grants AllowedWords::GrantsOf() const {
  if (!scheme.empty()) return Grants::kStep;
  return solved.empty() ? Grants::kRounding : Grants::kSolver;
}

std::function<BodyState(const WorldState&)> StateOfBody(int index) {
  return [i = static_cast<std::size_t>(index)](const WorldState& state) {
    return state.bodies[i];
  };
}

std::vector<Worst> JudgePredictions(const Motion& motion, const WordsOfPrediction& words,
                                    const std::vector<Prediction>& predictions) {
  const auto worst_of = [&](MeasureKind measure, const PredictionWords& of) {
    return Worst(measure, of.allowed.Because(motion.oracle), of.allowed.GrantsOf());
  };
  Worst position = worst_of(MeasureKind::kPositionError, words.position);
  Worst velocity = worst_of(MeasureKind::kVelocityError, words.velocity);
  Worst spin = worst_of(MeasureKind::kSpinError, words.spin);
  for (std::size_t s = 0; s < motion.trajectory.samples.size(); ++s) {
    const double steps = StepsBefore(motion, s);
    for (const Prediction& prediction : predictions) {
      const PredictedState predicted = prediction.at(s);
      const BodyState is = prediction.is(motion.trajectory.samples[s]);
      const AtSample at{motion, s, prediction.name};
      const auto compare = [&](Worst& worst, const std::optional<Predicted>& truth,
                               const Eigen::Vector3d& value,
                               const std::string& truth_is) {
        if (!truth) return;
        at.Compare(worst, value, truth->truth,
                   ToleranceOf(truth->allowed, motion.oracle, steps), truth_is);
      };
      compare(position, predicted.position, is.p_WB, words.position.truth_is);
      compare(velocity, predicted.velocity, is.v_WB, words.velocity.truth_is);
      compare(spin, predicted.spin, is.w_WB, words.spin.truth_is);
    }
  }
  std::vector<Worst> taken;
  for (const Worst& worst : {position, velocity, spin})
    if (worst.IsTaken()) taken.push_back(worst);
  return taken;
}

}  // namespace touchstone
