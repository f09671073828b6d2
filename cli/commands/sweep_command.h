#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/select_oracles.h"
#include "cli/session.h"
#include "reports/sweep/run_blocks.h"

namespace touchstone {

/** The arguments of a sweep on a cluster. */
struct SlurmArguments {
  bool submit = false;
  bool status = false;                 ///< Show the progress instead.
  std::optional<std::uint64_t> tasks;  ///< Number of shards.
  std::string sbatch_args;             ///< Further options of sbatch.
  std::vector<std::string> words;      ///< The command line without the program.
};

/** The arguments of `touchstone sweep`. */
struct SweepArguments {
  QuestionKind kind = QuestionKind::kContact;
  OracleSelection oracles;  ///< The subject is a list, see SubjectsNamed().
  std::vector<std::string> families = {"all"};  ///< Names of families, or "all".
  /** Files of questions that are asked instead of generated ones, see ReadFileSeries().
   Contact only. */
  std::vector<std::string> from;
  /** Names of shapes; empty: all pairs that a subject supports, or that a file has.
   Contact only. */
  std::vector<std::pair<std::string, std::string>> pairs;
  /** Questions per family or file, and pair of shapes; empty: 200 of a family, all of a
   file. */
  std::optional<std::uint64_t> count;
  std::uint64_t first = 0;
  std::optional<std::uint64_t> seed;  ///< Empty: 1. Generated questions only.
  std::uint64_t climb = 1;            ///< Same as QuestionSeries::climb. Contact only.
  Shard shard = {};
  std::optional<std::chrono::seconds> time;  ///< The time after which it stops.
  /** Folder for the file of results and for the failed questions, as TOML. */
  std::optional<std::filesystem::path> out;
  /** Failures that are not graver do not count for the exit code. */
  Grade fail_above = Grade::kNone;
  SlurmArguments slurm;
  int jobs = 0;
  bool quiet = false;
};

/** Asks the subjects questions, generated or from files. Prints, per family or file, pair
 and subject, the
 fraction that touches, the failures and the worst measures relative to their tolerances;
 then the failures by measure, law and cause, with the commands that repeat the worst.
 With a folder, the results are kept there while they are computed, and an interrupted
 sweep is resumed. Returns 1 on failures, 2 if no answer of a subject was verified (of
 generated contact questions, to one that touches), 128 plus the signal if it was
 interrupted, else 0. */
int SweepCommand(const Session& session, const SweepArguments& arguments);

/** Returns the name of the file of a shard, without its extension. */
std::string FileStemOf(const Shard& shard);

/** Returns the shape kinds of two names. Throws InputError for an unknown name, with the
 nearest, and for two half-spaces, which are not a valid question. */
std::pair<ShapeKind, ShapeKind> PairNamed(const std::vector<std::string>& names);

}  // namespace touchstone
