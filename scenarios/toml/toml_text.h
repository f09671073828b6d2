#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace touchstone::toml_text {

/** Returns the shortest decimal that reads back as the same double, sign of zero
 included. */
std::string Number(double value);

/** Returns "[x, y, z]". */
std::string Vector(const Eigen::Vector3d& v);

/** Returns `text` in quotes, with escapes for what TOML does not take as it is. */
std::string Text(std::string_view text);

/** Returns "true" or "false". */
std::string Truth(bool value);

/** Returns the vectors in brackets, each in a line of its own. */
std::string List(const std::vector<Eigen::Vector3d>& vectors);

/** Returns "key = value" and a line break. */
std::string Line(std::string_view key, std::string_view value);

}  // namespace touchstone::toml_text
