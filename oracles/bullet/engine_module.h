#pragma once

#include <string>

namespace touchstone {

/** Opens the module `<name>.so` for the life of the process, its symbols visible to
 nobody else, and returns its handle for dlsym().

 Searched in this order: the folders of the environment variable TOUCHSTONE_PLUGIN_PATH
 (separated by colons), then where the dynamic linker would look on behalf of the program
 or shared library that contains this function (its run path, LD_LIBRARY_PATH, system
 folders).

 @throws std::runtime_error if it is in none of them, or does not load. */
void* OpenEngineModule(const std::string& name);

}  // namespace touchstone
