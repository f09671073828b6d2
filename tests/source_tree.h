#pragma once

#include <filesystem>
#include <string_view>

namespace touchstone {

/** Returns the path of a file or folder of the sources. `path` is relative to their root.

 Only one object knows the root, so that all others are the same in every checkout, and
 ccache finds them. */
std::filesystem::path InSourceTree(std::string_view path);

}  // namespace touchstone
