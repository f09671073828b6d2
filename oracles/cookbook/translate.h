#pragma once

#include <type_traits>
#include <variant>

#include "engine/collision/manifold.h"
#include "engine/collision/shape.h"
#include "oracles/contact_answer.h"
#include "oracles/oracle.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns `pose` in the engine's type. The matrix is passed on bit for bit. */
inline cookbook::Pose ToCookbook(const Pose& pose) {
  return {pose.R_WB, pose.p_WB};
}
inline cookbook::Sphere ToCookbook(const Sphere& sphere) {
  return {sphere.radius};
}
inline cookbook::Box ToCookbook(const Box& box) {
  return {box.half_extents};
}

/** Whether the engines know shapes of type T. */
template <class T>
inline constexpr bool kHasRecipe = std::is_same_v<T, Sphere> || std::is_same_v<T, Box>;

/** Calls `visit` with the two shapes where the engines know both, else `otherwise()`. */
template <class Visit, class Otherwise>
auto VisitKnown(const ContactQuery& query, const Visit& visit,
                const Otherwise& otherwise) {
  return std::visit(
      [&]<class A, class B>(const A& a, const B& b) {
        if constexpr (kHasRecipe<A> && kHasRecipe<B>) {
          return visit(a, b);
        } else {
          return otherwise();
        }
      },
      query.A.shape, query.B.shape);
}

/** Returns the answer that says that the engine has no recipe for the pair. */
ContactAnswer NoRecipe();

/** Returns the table of an engine that knows spheres and boxes. */
decltype(OracleInfo::capabilities) SphereAndBoxCapabilities();

/** Returns what `manifold` says, as an answer. The separation is left out where it is
 only a bound: `exact_when_apart` tells whether it is the distance of shapes apart. */
ContactAnswer ToAnswer(const cookbook::Manifold& manifold, bool exact_when_apart);

}  // namespace touchstone
