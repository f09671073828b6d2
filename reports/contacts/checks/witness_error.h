#pragma once

#include <Eigen/Core>

#include "oracles/contact_answer.h"

namespace touchstone {

class JudgedAnswer;

/** The error of two witness points against the separation and the normal of the same
 answer: p_B − p_A should be s n. */
struct WitnessError {
  double along;   ///< |(p_B − p_A)·n − s|. [m]
  double across;  ///< |p_B − p_A| across the normal. [m]
};

/** Returns the error of `witnesses` for the separation [m] and the unit normal of the
 same answer. Points that are exchanged are off along the normal by twice the separation.
 Source: the convention of the separation, docs/conventions.md. */
WitnessError WitnessErrorOf(const WitnessPoints& witnesses, const Eigen::Vector3d& n_AB_W,
                            double separation);

/** Returns | |p_B − p_A| − |s| |, for an answer without a normal. [m] */
double WitnessLengthError(const WitnessPoints& witnesses, double separation);

/** Judges the witness points against the separation and the normal of the answer. */
void CheckWitnesses(JudgedAnswer& judged);

}  // namespace touchstone
