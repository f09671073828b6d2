#pragma once

#include <filesystem>
#include <span>

#include "reports/sweep/sweep_file.h"

namespace touchstone {

/** Writes the results of `part` to `target` as WriteMerged() does, whatever blocks it
 * has.
 */
void WritePart(const SweepFile& part, const std::filesystem::path& target);

/** Writes the results of all blocks of `parts` to `target`, which replaces an older file
 only once it is complete. The bytes depend on the results alone, not on their division
 into parts: the rows are written in order into a new file. They are those of the SQLite
 library in use. Throws SweepFileError if the settings of the parts differ, if a block is
 in two of them, or if one is in none. @pre There is a part. */
void WriteMerged(std::span<const SweepFile> parts, const std::filesystem::path& target);

}  // namespace touchstone
