#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "oracles/oracle.h"
#include "oracles/stated_tolerance.h"

namespace touchstone {

/** A user's collision routine. It answers one query in the project's conventions
 (contact_answer.h) and may be called from several threads at once. An exception becomes
 AnswerStatus::kCrashed. */
using ContactFunction = std::function<ContactAnswer(const ContactQuery&)>;

/** The kind of A and the kind of B, in that order. */
struct ShapePair {
  ShapeKind A;
  ShapeKind B;
};

/** Returns the capability of a routine that returns touching, and the normal and depth of
 penetrating pairs: the least that can be judged beyond touching. Other fields of an
 answer are judged too if present; a promised field that is absent is a fault. */
Capability DepthAndNormal();

/** The arithmetic of a routine. Its rounding is what the routine is granted. */
enum class Precision { kFloat, kDouble };

/** The promises of the author of a routine. */
struct Promises {
  /** The fields that it gives for each pair; set `gives.family` to take part in the
   * consensus. */
  Capability gives = DepthAndNormal();
  Precision precision = Precision::kDouble;
  /** The error that it is meant to have beyond rounding. Its `by` is `documented_by`. */
  StatedTolerance tolerance = {};
  /** Where the tolerance is documented, e.g. "the header of my_box_box.h". */
  std::string documented_by = {};
};

/** Returns an oracle that answers `pairs` by calling `function`. Every other pair is
 unsupported.
 @throws std::invalid_argument for a tolerance that is negative, not finite, or documented
 nowhere. */
std::unique_ptr<Oracle> MakeOracle(std::string name, const std::vector<ShapePair>& pairs,
                                   ContactFunction function,
                                   const Promises& promises = {});

/** Returns an oracle for one pair of shapes from `function(A, X_WA, B, X_WB) ->
 ContactAnswer`. A routine in float that is meant to be right to a tenth of a millimetre:
      MakeOracle<Box, Box>("mine", MyBoxBox,
                           {.precision = Precision::kFloat,
                            .tolerance = {.length = 1e-4},
                            .documented_by = "the header of my_box_box.h"}) */
template <typename ShapeA, typename ShapeB, typename Function>
std::unique_ptr<Oracle> MakeOracle(std::string name, Function function,
                                   const Promises& promises = {}) {
  const ShapePair pair{static_cast<ShapeKind>(Shape(std::in_place_type<ShapeA>).index()),
                       static_cast<ShapeKind>(Shape(std::in_place_type<ShapeB>).index())};
  const ContactFunction ask = [function =
                                   std::move(function)](const ContactQuery& query) {
    return function(std::get<ShapeA>(query.A.shape), query.A.X_WB,
                    std::get<ShapeB>(query.B.shape), query.B.X_WB);
  };
  return MakeOracle(std::move(name), {pair}, ask, promises);
}

}  // namespace touchstone
