#pragma once

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

namespace touchstone {

using DataJson = nlohmann::ordered_json;

/** Returns `value` rounded to that many decimal digits, which is shorter as text. A
 number that is not finite becomes the string "nan", "inf" or "-inf". */
DataJson ToData(double value, int digits);

/** Returns `value` as ToData(), but 1e9 for what is larger or not a number. */
DataJson ToShare(double value);

/** Returns the shortest text that reads back as `value`, see ToData(). */
DataJson ToData(double value);

DataJson ToData(const Eigen::Vector3d& v, int digits);

/** Returns w, x, y, z. */
DataJson ToData(const Eigen::Quaterniond& q, int digits);

}  // namespace touchstone
