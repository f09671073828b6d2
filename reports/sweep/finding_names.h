#pragma once

#include <optional>
#include <string_view>

#include "reports/finding/finding.h"
#include "scenarios/shape.h"

namespace touchstone {

// The inverses of NameOf(). Each is empty for an unknown name.

std::optional<Verdict> VerdictNamed(std::string_view name);
std::optional<Grade> GradeNamed(std::string_view name);
std::optional<Cause> CauseNamed(std::string_view name);
std::optional<ShapeKind> ShapeKindNamed(std::string_view name);

}  // namespace touchstone
