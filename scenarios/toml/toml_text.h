#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace touchstone::toml_text {

/** Returns the shortest decimal that reads back as the same double, including the sign of
 zero. */
std::string Number(double value);

/** Returns "[x, y, z]". */
std::string Vector(const Eigen::Vector3d& v);

/** Returns `text` in quotes, with the escapes that TOML requires. */
std::string Text(std::string_view text);

/** Returns "true" or "false". */
std::string Truth(bool value);

/** Returns the vectors in brackets, each on its own line. */
std::string List(const std::vector<Eigen::Vector3d>& vectors);

/** Returns "key = value" and a line break. */
std::string Line(std::string_view key, std::string_view value);

}  // namespace touchstone::toml_text
