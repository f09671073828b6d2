#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "oracles/oracle.h"
#include "scenarios/shape.h"

namespace touchstone {

/** What the answers about one ordered pair of shapes show. */
struct PairCheck {
  ShapeKind A = ShapeKind::kSphere;
  ShapeKind B = ShapeKind::kSphere;
  std::size_t asked = 0;
  std::size_t touching = 0;  ///< Questions in which the bodies certainly touch.
  /** Answers that are proved wrong by more than a thousandth of the smaller body, or are
   none. No mistake of an adapter changes less. */
  std::size_t wrong = 0;
  std::size_t inexact = 0;      ///< Answers that are proved wrong by less.
  std::size_t right = 0;        ///< Answers that are proved right.
  std::size_t unsupported = 0;  ///< Questions that it says it does not answer.
  /** The mistakes that explain nearly all wrong answers, each by itself; empty if none
   does. */
  std::vector<std::string> mistakes;
  std::string example;  ///< The first wrong answer in words; empty if none is wrong.
};

/** Puts random questions about every pair of shapes that `oracle` supports, and judges
 the answers against the certified truth. Where answers are wrong, finds the mistakes of
 ContactMistakes() that would make nearly all of them right. */
std::vector<PairCheck> CheckContacts(const Oracle& oracle);

/** Returns what is wrong with the answers when the same questions are asked again, in
 another order and one by one; empty if they are the same bit for bit. */
std::string CheckRepeatability(const Oracle& oracle);

}  // namespace touchstone
