#pragma once

#include <span>
#include <string_view>

#include "scenarios/shape.h"

namespace touchstone {

/** What a value of a scenario file is. Drives the reader and the schema alike. */
enum class ValueType {
  kText,         ///< A string that is not empty.
  kId,           ///< A string: levels of a-z, 0-9 and _ joined by slashes.
  kBodyName,     ///< A string that names a table of [bodies].
  kShape,        ///< A string: the name of a ShapeKind.
  kBool,         ///< true or false.
  kCount,        ///< An integer >= 0 that fits an int.
  kNumber,       ///< A finite number; an integer will do, here and below.
  kLength,       ///< A finite number > 0. [m]
  kPoint,        ///< Three finite numbers. [m]
  kLengths,      ///< Three finite numbers > 0. [m]
  kPoints,       ///< A list of at least one kPoint.
  kUnitVectors,  ///< A list of unit vectors.
  kQuaternion,   ///< Four numbers w, x, y, z of norm 1.
  kRotation,     ///< Three rows of three numbers: orthonormal, determinant +1.
  kTable,        ///< A table whose keys are those of Key::table.
  kBodies,       ///< A table of two tables, each a body.
  kTables,       ///< A list of tables whose keys are those of Key::table.
};

/** The tables of a scenario file, except bodies, whose keys depend on their shape. */
enum class TableKind { kFile, kContact, kExpect, kTolerance, kIndictment };

/** One key that a table may have. */
struct Key {
  std::string_view name;
  ValueType type;
  bool required;
  std::string_view documentation;      ///< One line, as editors show it.
  TableKind table = TableKind::kFile;  ///< Of kTable and kTables: what is in it.
};

/** Returns the keys of a table, in the order in which they are written. */
std::span<const Key> KeysOf(TableKind table);

/** Returns the keys that every body has, in the order in which they are written. */
std::span<const Key> BodyKeys();

/** Returns the keys of a body's shape, in the order in which they are written. */
std::span<const Key> ShapeKeys(ShapeKind kind);

/** Returns what a reader expects of a value of that type, e.g. "three numbers". */
std::string_view ExpectationOf(ValueType type);

}  // namespace touchstone
