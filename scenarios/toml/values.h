#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "scenarios/scenario.h"
#include "scenarios/toml/parser.h"

namespace touchstone {

// Each of these takes what has the right type and a harmless value for all else, which
// CheckStructure() has reported already: so one error does not hide another.

/** Returns the number that `node` is; an integer will do. */
double NumberFrom(const toml::node* node, double otherwise);

/** Returns the integer that `node` is, where Type holds it. */
template <class Type>
Type IntegerFrom(const toml::node* node, Type otherwise) {
  const auto* integer = node ? node->as_integer() : nullptr;
  return integer && std::in_range<Type>(integer->get())
             ? static_cast<Type>(integer->get())
             : otherwise;
}

/** Returns the string that `table` has under `key`; empty where none. */
std::string TextFrom(const toml::table& table, std::string_view key);

/** Returns whether `node` is a list of `size` numbers. */
bool AreNumbers(const toml::node* node, std::size_t size);

/** Returns the three numbers that `node` is. */
Eigen::Vector3d VectorFrom(const toml::node* node, const Eigen::Vector3d& otherwise);

/** Returns the elements of `array`, each a vector. */
std::vector<Eigen::Vector3d> PointsFrom(const toml::array& array);

/** Returns the tables of the list that `table` has under `key`, null for what is none. */
std::vector<const toml::table*> TablesFrom(const toml::table& table,
                                           std::string_view key);

/** Returns the list "indicts" of a file. */
std::vector<Indictment> IndictmentsFrom(const toml::table& file);

}  // namespace touchstone
