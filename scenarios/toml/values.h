#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "scenarios/scenario.h"
#include "scenarios/toml/parser.h"

namespace touchstone {

// These functions return the value if it has the right type, and a harmless default
// otherwise. CheckStructure() has already reported the wrong type, so that one error does
// not hide another.

/** Returns the number in `node`; integers are accepted. */
double NumberFrom(const toml::node* node, double otherwise);

/** Returns the integer in `node` if it fits Type. */
template <class Type>
Type IntegerFrom(const toml::node* node, Type otherwise) {
  const auto* integer = node ? node->as_integer() : nullptr;
  return integer && std::in_range<Type>(integer->get())
             ? static_cast<Type>(integer->get())
             : otherwise;
}

/** Returns the string under `key` in `table`; empty if there is none. */
std::string TextFrom(const toml::table& table, std::string_view key);

/** Returns whether `node` is a list of `size` numbers. */
bool AreNumbers(const toml::node* node, std::size_t size);

/** Returns the list of three numbers in `node`. */
Eigen::Vector3d VectorFrom(const toml::node* node, const Eigen::Vector3d& otherwise);

/** Returns the elements of `array` as vectors. */
std::vector<Eigen::Vector3d> PointsFrom(const toml::array& array);

/** Returns the elements of the list under `key` in `table`; null for each that is not a
 table. */
std::vector<const toml::table*> TablesFrom(const toml::table& table,
                                           std::string_view key);

/** Returns the list "indicts" of a file. */
std::vector<Indictment> IndictmentsFrom(const toml::table& file);

}  // namespace touchstone
