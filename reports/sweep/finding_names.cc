#include "reports/sweep/finding_names.h"

namespace touchstone {
namespace {

/** Returns the value with that name, from 0 to `last`. */
template <typename T>
std::optional<T> Named(std::string_view name, T last) {
  for (int i = 0; i <= static_cast<int>(last); ++i) {
    if (NameOf(static_cast<T>(i)) == name) return static_cast<T>(i);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Verdict> VerdictNamed(std::string_view name) {
  return Named(name, Verdict::kInvalid);
}

std::optional<Grade> GradeNamed(std::string_view name) {
  return Named(name, Grade::kUnusable);
}

std::optional<Cause> CauseNamed(std::string_view name) {
  return Named(name, Cause::kNotExamined);
}

std::optional<ShapeKind> ShapeKindNamed(std::string_view name) {
  return Named(name, static_cast<ShapeKind>(kShapeKinds - 1));
}

}  // namespace touchstone
