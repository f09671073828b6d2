#pragma once

#include <filesystem>
#include <string>

namespace touchstone {

/** Returns what a run wrote to report.jsonl, report.data or junit.xml, without the
 seconds that answers took: the rest is the same for the same questions. */
std::string WithoutSeconds(const std::filesystem::path& file);

}  // namespace touchstone
