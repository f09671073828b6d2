#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "oracles/trajectory.h"
#include "reports/worlds/law_support/law.h"
#include "reports/worlds/law_support/worst.h"

namespace touchstone {

/** How far a right engine may be from a number that a law predicts. JudgePredictions()
 grants no more than ToleranceOf() this. [unit of the number] */
struct Allowed {
  /** The error of legal schemes of first order, or of an event at an unknown phase of its
   step. */
  double scheme = 0;
  double solved = 0;    ///< Size of what a solver has made by iteration.
  double computed = 0;  ///< Size of the terms of which the number is the sum.
  double slop = 0;      ///< The slop that the oracle documents, if it adds as it is.
};

/** Returns 1.5 × `scheme` + 1e-5 `solved` + ε (`solved` + `computed`) + `slop`, with ε
 the 64 roundings of each of `steps` (error_laws.h). */
double ToleranceOf(const Allowed& allowed, const OracleInfo& oracle, double steps);

/** The words for what the numbers of an Allowed are; empty: the number is always 0. */
struct AllowedWords {
  std::string scheme = {};  ///< "the error ½ a h t of semi-implicit Euler"
  std::string solved = {};  ///< "the velocity"
  /** Whether the slop that the oracle documents is granted, by itself or in `scheme`. */
  bool slop = false;

  /** Returns the origin of the tolerance, as ToleranceOf() has it. */
  std::string Because(const OracleInfo& oracle) const;
  Grants GrantsOf() const;
};

/** A number that a law predicts at one moment, World frame. */
struct Predicted {
  Eigen::Vector3d truth;
  Allowed allowed;
};

/** What a law predicts of a body or particle at one moment. What is absent is not judged
 then. */
struct PredictedState {
  std::optional<Predicted> position = {};  ///< [m]
  std::optional<Predicted> velocity = {};  ///< [m/s]
  std::optional<Predicted> spin = {};      ///< [rad/s]
};

/** The words of the findings about one of these numbers. */
struct PredictionWords {
  AllowedWords allowed = {};
  std::string truth_is = {};  ///< "x₀ + v₀ t + ½ a t² is", before the true value.
};

/** What a law predicts of one body or particle. */
struct Prediction {
  std::string name;  ///< Of the body or particle.
  /** Returns its state; a particle has no spin. */
  std::function<BodyState(const WorldState&)> is;
  /** Returns what is predicted at sample `s` of the motion. */
  std::function<PredictedState(std::size_t s)> at;
};

/** Returns the state of body `index`, as Prediction::is does. */
std::function<BodyState(const WorldState&)> StateOfBody(int index);

/** The words of all numbers of a prediction. */
struct WordsOfPrediction {
  PredictionWords position = {};
  PredictionWords velocity = {};
  PredictionWords spin = {};
};

/** Judges the motion by what a law predicts, sample by sample. Returns the worst of
 positions, of velocities and of spins, in this order, as far as anything was predicted of
 them. @pre The motion has samples. */
std::vector<Worst> JudgePredictions(const Motion& motion, const WordsOfPrediction& words,
                                    const std::vector<Prediction>& predictions);

}  // namespace touchstone
