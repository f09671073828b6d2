#pragma once

#include <compare>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "reports/clusters/clusters.h"
#include "reports/triage/examine.h"
#include "reports/triage/rate.h"

namespace touchstone {

/** The properties by which failures are taken to have one root cause in the code of a
 library. */
struct RootKey {
  std::string library;
  std::string version;
  std::string algorithm;  ///< Capability::family; empty for a world.
  std::string failure;    ///< "states a wrong depth"; of one function "is wrong".
  std::string place;      ///< EndingOf() the finding, of a missing answer.
  /** Those of the smallest question, if its code is likely to be of these shapes alone: a
   closed form, an algorithm of one pair, a world, or a signal that names no place. Empty
   otherwise: an iterative algorithm calls the same code for all shapes. */
  std::string shapes;

  auto operator<=>(const RootKey&) const = default;
};

/** Returns whether the answers of `oracle` to questions of `pair` may come from the code
 of a root. All worlds may: their bodies are not known before they are made. */
bool MayShow(const RootKey& root, const AskedPair& pair, const OracleInfo& oracle);

/** Returns the key of a specimen. @pre It is repeatable. */
RootKey KeyOf(const Specimen& specimen);

/** Returns specimens of the same key as one, which then stands for the symptoms of all:
 that of the plainest question in the grade of the gravest symptom. Its `failures` are the
 words of all. Keeps the order, and those that are not repeatable. */
std::vector<Specimen> Joined(std::vector<Specimen> specimens);

/** Failures with one root cause. */
struct Root {
  RootKey key;
  /** What goes wrong, in words: the failure of the key. For an algorithm that is one
   function, all failures found in it; the smallest question shows the first. */
  std::vector<std::string> failures;
  std::vector<Specimen> specimens;  ///< The one of the plainest question first.
  /** How often it was found, by oracle and Asked::what: in all questions whose answers by
   an oracle that shows it may come from the code that fails. */
  std::map<std::pair<std::string, std::string>, Rate> rates;
  Rate rate;  ///< Sum of `rates`: answers, since several oracles may be asked one
              ///< question.
  /** Answers with a variant that failed, at least one of them by this root, and that are
   not in `rate`. */
  std::uint64_t in_variants = 0;
  Grade grade = Grade::kNone;  ///< The gravest that was found.
  Rate gravest;                ///< That of `grade` alone.
  /** The number of the grade plus ½ log10 of the rate of that grade. A step of one grade
   counts as much as a rate a hundred times as high. [-] */
  double rank = 0;

  const Specimen& smallest() const { return specimens.front(); }
};

/** Returns whether the smallest question is answered rightly as the engine ships: then a
 setting of the adapter is at fault, or decides at least. */
bool IsOfASetting(const Root& root);

/** Returns the roots of the repeatable specimens, those of the highest rank first; those
 that are of a setting come last.
 @param asked Same as Failures::asked.
 @param oracles Include all of `asked`. */
std::vector<Root> RootsOf(std::vector<Specimen> specimens, std::span<const Asked> asked,
                          std::span<const Oracle* const> oracles);

/** Returns e.g. "FCL 0.7.0 (closed_form) states a wrong depth: box and sphere". */
std::string TitleOf(const Root& root);

/** Returns the oracles that show it, sorted. */
std::vector<std::string> OraclesOf(const Root& root);

/** Returns a name for its folder, made from the key without the version: lower-case
 letters, digits and
 '_'. Two roots may have the same. */
std::string FolderOf(const Root& root);

}  // namespace touchstone
