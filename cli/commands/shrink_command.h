#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "cli/commands/choose_fault.h"

namespace touchstone {

/** The arguments of `touchstone shrink`. */
struct ShrinkArguments {
  FaultSelection fault;
  std::uint64_t tries = 5000;                ///< Most smaller questions that are asked.
  std::optional<std::filesystem::path> out;  ///< Absent: standard output.
  bool quiet = false;
};

/** Searches for the smallest question with the fault, and writes it as a scenario file.
 Returns 0. */
int ShrinkCommand(const Session& session, const ShrinkArguments& arguments);

}  // namespace touchstone
