#pragma once

#include <filesystem>

namespace touchstone {

/** Shows a file in the user's browser, with `xdg-open`, or `open` on macOS. Returns when
 that has returned. Throws InputError if it is missing or fails. */
void OpenPage(const std::filesystem::path& page);

}  // namespace touchstone
