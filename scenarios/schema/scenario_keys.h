#pragma once

#include <span>
#include <string_view>

#include "scenarios/shape.h"

namespace touchstone {

/** The type of a value in a scenario file. The reader and the schema both use it. */
enum class ValueType {
  kText,           ///< A non-empty string.
  kMeasures,       ///< A non-empty list of names of MeasureKinds.
  kId,             ///< A string: levels of a-z, 0-9 and _ joined by slashes.
  kWord,           ///< A string of a-z, 0-9 and _.
  kBodyName,       ///< A string that names a table of [bodies].
  kNames,          ///< A list of strings that name bodies, particles or cloths.
  kShape,          ///< A string: the name of a ShapeKind.
  kBool,           ///< true or false.
  kCount,          ///< An integer >= 0 that fits an int.
  kPositiveCount,  ///< An integer > 0 that fits an int.
  kSeed,           ///< An integer >= 0 that fits 32 bits.
  kNumber,         ///< A finite number; integers are accepted, here and below.
  kNotNegative,    ///< A finite number >= 0.
  kPositive,       ///< A finite number > 0.
  kLength,         ///< A finite number > 0. [m]
  kShare,          ///< A number in [0, 1].
  kPoint,          ///< Three finite numbers.
  kLengths,        ///< Three finite numbers > 0. [m]
  kMoments,        ///< Three finite numbers > 0. [kg m²]
  kPoints,         ///< A list of at least one kPoint.
  kUnitVectors,    ///< A list of unit vectors.
  kNodes,          ///< A list of pairs of kCount: row, column.
  kQuaternion,     ///< Four numbers w, x, y, z of norm 1.
  kRotation,       ///< Three rows of three numbers: orthonormal, determinant +1.
  kAnchor,         ///< A name, a kPoint of the world, or a table of TableKind::kAnchor.
  kNumbers,        ///< A table of numbers under any names.
  kTable,          ///< A table whose keys are those of Key::table.
  kBodies,         ///< A table of two tables, each a body.
  kMovingBodies,   ///< A table of tables, each a body that may move.
  kNamedTables,    ///< A table of tables whose keys are those of Key::table.
  kTables,         ///< A list of tables whose keys are those of Key::table.
};

/** The tables of a scenario file. Bodies are not included: their keys depend on the
 * shape.
 */
enum class TableKind {
  kContactFile,
  kWorldFile,
  kIndictment,
  // Tables of contact queries:
  kContact,
  kExpect,
  kTolerance,
  // Tables of worlds:
  kWorld,
  kParticle,
  kSpring,
  kJoint,
  kAnchor,
  kCloth,
  kClothSprings,
  kPush,
  kClaim,
  kEnsemble,
  kMotionExpectation,
};

/** One key that a table may have. */
struct Key {
  std::string_view name;
  ValueType type;
  bool required;
  std::string_view documentation;  ///< One line, shown by editors.
  /** The kind of table for kTable, kNamedTables and kTables; unused otherwise. */
  TableKind table = TableKind::kContactFile;
};

/** Returns the keys of a table, in the order in which they are written. */
std::span<const Key> KeysOf(TableKind table);

/** Returns the keys by which a file that has neither [world] nor [contact] is recognised
 as one about a world. */
std::span<const std::string_view> KeysOfWorldsOnly();

/** Returns the keys that every body has, in the order in which they are written. */
std::span<const Key> BodyKeys();

/** Returns the additional keys of a body in a world, in the order in which they are
 written. */
std::span<const Key> MotionKeys();

/** Returns the keys of a body's shape, in the order in which they are written. */
std::span<const Key> ShapeKeys(ShapeKind kind);

/** Returns a description of valid values of `type`, e.g. "three finite numbers". */
std::string_view ExpectationOf(ValueType type);

}  // namespace touchstone
