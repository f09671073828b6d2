#pragma once

#include <compare>

#include "reports/shrink/question.h"

namespace touchstone {

/** The size of a question: how much a person has to read and an engine has to do. Sizes
 are compared field by field, the first that differs decides, so that a body less is worth
 any number of digits. A reduction must make it smaller; sizes are bounded below, so
 shrinking ends. */
struct Size {
  int parts = 0;     ///< Bodies, particles, springs, joints, cloths and impulses.
  int claims = 0;    ///< Claims, expectations, and one for an ensemble or a horizon.
  int shapes = 0;    ///< Sum of the ranks of the shapes, from sphere to hull.
  int vertices = 0;  ///< Vertices of all hulls.
  int steps = 0;     ///< Steps of a world.
  int samples = 0;   ///< Samples of a world.
  /** Decades by which the sizes of shapes and their distances from the origin are beyond
   0.1 m to 10 m, in all: an ordinary question must not become one of kilometres because
   1000 has fewer digits than 1.25. */
  int decades = 0;
  /** Length of all rotations as text, in characters beyond those of the identity. */
  int rotations = 0;
  /** Length of all other numbers as text: 0 for zero, 1 for one, else one more than the
   characters of the shortest decimal that reads back. */
  int digits = 0;
  int different = 0;  ///< Number of different sizes and vertex coordinates.

  auto operator<=>(const Size&) const = default;
};

/** Returns the size of `question`. */
Size SizeOf(const Question& question);

}  // namespace touchstone
