#pragma once

#include <filesystem>

namespace touchstone {

/** Returns the folder of the sources that holds catalogue/ and known_discrepancies.toml.

 Only its object knows the path, so that all others are the same in every checkout, and
 ccache finds them. */
std::filesystem::path DataFolderOfSources();

}  // namespace touchstone
