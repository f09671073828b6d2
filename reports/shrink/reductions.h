#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "reports/shrink/question.h"

namespace touchstone {

/** Takes the candidates for a smaller question, one after the other, the best first. They
 need not be valid, nor smaller: it checks both. */
using Candidates = std::function<void(Question)>;

/** One way to make a question smaller. */
struct Reduction {
  std::string_view name;  ///< E.g. "fewer parts".
  void (*propose)(const Question& question, const Candidates& take);
};

// Each of these is a file of that name.

/** Leaves out bodies, first half of them, then a quarter, …; then one particle, spring,
 joint, cloth, impulse, claim, expectation, the ensemble or the horizon; each with
 whatever refers to it. */
void FewerParts(const Question& question, const Candidates& take);

/** Ends a world earlier, and samples it less often. */
void FewerSteps(const Question& question, const Candidates& take);

/** Replaces a shape by a sphere, a box or a cylinder of a similar size, or by the shape
 of another body. */
void SimplerShapes(const Question& question, const Candidates& take);

/** Leaves out vertices of a hull: half of them, a quarter, …, one. */
void FewerVertices(const Question& question, const Candidates& take);

/** Moves and turns both bodies of a contact query so that one is at the origin, and moves
 all bodies of a world so that one is. */
void CommonFrame(const Question& question, const Candidates& take);

/** Replaces a rotation by the identity, a rotation that maps axes to axes, and
 quaternions of few digits nearby. */
void PlainRotations(const Question& question, const Candidates& take);

/** Makes sizes of a shape equal, and sizes of two shapes. */
void EqualSizes(const Question& question, const Candidates& take);

/** Scales a contact query by a power of ten so that its largest or its smallest size is
 between 1 m and 10 m, or between 0.1 m and 1 m. */
void UnitScale(const Question& question, const Candidates& take);

/** Replaces a number by 0, by 1, by its magnitude, and by its nearest numbers of 1, 2, 3,
 … digits; first all numbers at once, then one after the other. */
void ShortNumbers(const Question& question, const Candidates& take);

/** Returns all of them, in the order in which they are tried: those first that save most.
 */
std::span<const Reduction> Reductions();

}  // namespace touchstone
