#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "oracles/oracle.h"

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

/** Returns an oracle that answers `pairs` by calling `function`, which computes in
 double. Every other pair is unsupported. `gives` is what the function promises for each
 pair; set `gives.family` to take part in the consensus. */
std::unique_ptr<Oracle> MakeOracle(std::string name, const std::vector<ShapePair>& pairs,
                                   ContactFunction function,
                                   const Capability& gives = DepthAndNormal());

/** Returns an oracle for one pair of shapes from `function(A, X_WA, B, X_WB) ->
 ContactAnswer`, e.g. MakeOracle<Box, Box>("mine", MyBoxBox). */
template <typename ShapeA, typename ShapeB, typename Function>
std::unique_ptr<Oracle> MakeOracle(std::string name, Function function,
                                   const Capability& gives = DepthAndNormal()) {
  const ShapePair pair{static_cast<ShapeKind>(Shape(std::in_place_type<ShapeA>).index()),
                       static_cast<ShapeKind>(Shape(std::in_place_type<ShapeB>).index())};
  const ContactFunction ask = [function =
                                   std::move(function)](const ContactQuery& query) {
    return function(std::get<ShapeA>(query.A.shape), query.A.X_WB,
                    std::get<ShapeB>(query.B.shape), query.B.X_WB);
  };
  return MakeOracle(std::move(name), {pair}, ask, gives);
}

}  // namespace touchstone
