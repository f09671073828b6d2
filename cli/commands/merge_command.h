#pragma once

#include <filesystem>
#include <vector>

namespace touchstone {

/** The arguments of `touchstone merge`. */
struct MergeArguments {
  std::vector<std::filesystem::path> parts;  ///< The files of all shards of a sweep.
  std::filesystem::path out;
};

/** Joins the files of shards into the file of the whole sweep. Returns 0. Throws
 InputError if they are not all shards of one sweep. */
int MergeCommand(const MergeArguments& arguments);

}  // namespace touchstone
