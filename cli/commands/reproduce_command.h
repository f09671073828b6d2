#pragma once

#include <filesystem>

#include "cli/commands/choose_fault.h"

namespace touchstone {

/** The arguments of `touchstone reproduce`. */
struct ReproduceArguments {
  FaultSelection fault;
  std::filesystem::path out = "reproduction";
};

/** Writes reproduce.cc, CMakeLists.txt and REPORT.md for a fault. Returns 0. Throws
 InputError if there is no fault, or no program can be written for it. */
int ReproduceCommand(const Session& session, const ReproduceArguments& arguments);

}  // namespace touchstone
