#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "reports/sweep/file_series.h"
#include "reports/sweep/question_series.h"
#include "reports/sweep/world_series.h"

namespace touchstone {

/** A series of questions of one kind. All of a sweep that knows kinds of question is
 here, in ask_block.h, and where a file keeps a series. */
using Series = std::variant<QuestionSeries, FileSeries, WorldSeries>;

/** The number of questions in a block: the unit that is computed, committed and shared
 out. Small enough that a thousand questions keep two threads busy, large enough that
 causes which need many contact questions are found, and that a child process which
 answers a block is worth its start. */
inline constexpr std::uint64_t kContactBlock = 256;
inline constexpr std::uint64_t kWorldBlock = 16;

/** The number of blocks at the start of a series of contact questions in which the cause
 of every failure is sought: a series of a thousand questions has all causes. */
inline constexpr std::uint64_t kExaminedBlocks = 4;

/** In each later block, the number of failed answers of each oracle whose cause is
 sought, of each verdict, measure and grade: the first ones. A cause takes a dozen more
 questions, and half of the answers of some oracles fail. A margin needs three that share
 it, a convention two (reports/contacts/causes/). The kind of an answer is that of its
 decisive finding, so that kinds which are rarely decisive are rarely examined. */
inline constexpr std::size_t kExaminedPerKind = 4;

/** Returns kContactBlock or kWorldBlock. */
std::uint64_t BlockSizeOf(const Series& series);

/** Returns whether it is a series of worlds. */
inline bool IsOfWorlds(const Series& series) {
  return std::holds_alternative<WorldSeries>(series);
}

/** Returns whether it is a series of questions from a file. */
inline bool IsOfFile(const Series& series) {
  return std::holds_alternative<FileSeries>(series);
}

/** Returns whether it is a worst-case search, which finds other questions for each
 * oracle.
 */
inline bool IsSearch(const Series& series) {
  const auto* const contacts = std::get_if<QuestionSeries>(&series);
  return contacts != nullptr && contacts->climb > 1;
}

/** Returns "contact" or "world". */
std::string_view KindNameOf(const Series& series);

/** Returns the name of the family, or the path of the file. */
std::string OriginOf(const Series& series);

/** Returns the shapes of A and B; empty for worlds. */
std::optional<std::pair<ShapeKind, ShapeKind>> PairOf(const Series& series);

/** Returns the number of questions of a series. */
std::uint64_t CountOf(const Series& series);

/** Returns the number of blocks of a series; the last one may be smaller. */
std::uint64_t BlockCount(const Series& series);

/** Returns block `block` of `series`, which is a series itself.
 @pre block < BlockCount(series). */
Series BlockOf(const Series& series, std::uint64_t block);

/** Returns the command line that repeats question `index`. */
std::string ReplayOf(const Series& series, std::uint64_t index);

}  // namespace touchstone
