#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include <Eigen/Core>
#include <fmt/format.h>

#include "reports/finding/cited.h"

namespace touchstone {

/** The proof of a law's finding: its sentence, and what the sentence cites. */
struct CitingProof {
  std::string sentence;
  Cited cited;
};

/** Arguments of Citing(). The sentence shows their value, and the proof cites it. */
struct CitedName {
  std::string_view name;  ///< Shown in quotation marks, if it is part of the world.
  bool is_part_of_world = true;  ///< Else it is shown and not cited.
};
struct CitedTime {
  double time;  ///< The moment of the proof; shown as a number. [s]
};
struct CitedPoint {
  const Eigen::Vector3d& p_W;  ///< A position; shown as "(0, 1, 2.5)". [m]
  int digits = 9;
};

/** Adds an argument of Citing() to what the proof cites. A proof within another adds all
 that it cites. The last of several moments stays. Other arguments add nothing. */
void Cite(const CitingProof& part, Cited& cited);
void Cite(const CitedName& name, Cited& cited);
void Cite(const CitedTime& time, Cited& cited);
void Cite(const CitedPoint& point, Cited& cited);
template <typename Other>
void Cite(const Other& /*other*/, Cited& /*cited*/) {}

/** Returns the value that a sentence shows for an argument of Citing(). */
std::string_view ShownOf(const CitingProof& part);
std::string ShownOf(const CitedName& name);
double ShownOf(const CitedTime& time);
std::string ShownOf(const CitedPoint& point);
template <typename Other>
const Other& ShownOf(const Other& other) {
  return other;
}

/** The type of the value that a sentence shows for an argument. */
template <typename Argument>
using Shown = std::remove_cvref_t<decltype(ShownOf(std::declval<const Argument&>()))>;

/** Returns a proof whose sentence is formatted as fmt::format() does, and which cites its
 arguments of the types above. So the data cannot differ from the sentence. */
template <typename... Arguments>
CitingProof Citing(fmt::format_string<Shown<Arguments>...> format,
                   const Arguments&... arguments) {
  CitingProof proof;
  (Cite(arguments, proof.cited), ...);
  const auto formatted = [&](const auto&... shown) {
    return fmt::vformat(format, fmt::make_format_args(shown...));
  };
  proof.sentence = formatted(ShownOf(arguments)...);
  return proof;
}

}  // namespace touchstone
