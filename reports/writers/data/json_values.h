#pragma once

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

namespace touchstone {

using DataJson = nlohmann::ordered_json;

/** Returns `value` rounded to that many decimal digits, which is shorter as text. A
 number that is not finite becomes the string "nan", "inf" or "-inf". */
DataJson ToData(double value, int digits);

/** Returns `value` with five digits, so that a page that rounds it again to two rounds as
 a sentence does; 1e9 for what is larger or not a number. */
DataJson ToShare(double value);

/** Returns the shortest text that reads back as `value`, see ToData(). */
DataJson ToData(double value);

DataJson ToData(const Eigen::Vector3d& v, int digits);

/** Returns w, x, y, z. */
DataJson ToData(const Eigen::Quaterniond& q, int digits);

/** Returns NameOf() all values of an enumeration up to `last`. */
template <typename Enum>
DataJson NamesUpTo(Enum last) {
  DataJson names = DataJson::array();
  for (int i = 0; i <= static_cast<int>(last); ++i)
    names.push_back(NameOf(static_cast<Enum>(i)));
  return names;
}

}  // namespace touchstone
