#pragma once

#include <string>

namespace touchstone {

/** Opens the module `<name>.so` and returns its handle for dlsym(). The module stays open
 for the life of the process, and its symbols are invisible to other libraries.

 The function searches the folders of the environment variable TOUCHSTONE_PLUGIN_PATH
 (separated by colons). Then it searches the folders that the dynamic linker uses for the
 program or shared library that contains this function: its run path, LD_LIBRARY_PATH,
 system folders.

 @throws std::runtime_error if the module is in none of them, or does not load. */
void* OpenEngineModule(const std::string& name);

}  // namespace touchstone
