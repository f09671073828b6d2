#include "oracles/bullet/engine_module.h"

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <dlfcn.h>
#include <link.h>

namespace touchstone {
namespace {

std::vector<std::string> PluginPath() {
  std::vector<std::string> folders;
  const char* variable = std::getenv("TOUCHSTONE_PLUGIN_PATH");
  std::istringstream list(variable != nullptr ? variable : "");
  for (std::string folder; std::getline(list, folder, ':');) {
    if (!folder.empty()) folders.push_back(folder);
  }
  return folders;
}

/* Returns the folders that the dynamic linker searches. The search is not left to
 dlopen(): the address sanitizer intercepts dlopen(), which then searches the run path of
 the sanitizer's library instead of ours. */
std::vector<std::string> RunPath() {
  Dl_info where;
  void* self = nullptr;
  Dl_serinfo size;
  if (dladdr1(reinterpret_cast<void*>(&OpenEngineModule), &where, &self,
              RTLD_DL_LINKMAP) == 0 ||
      dlinfo(self, RTLD_DI_SERINFOSIZE, &size) != 0) {
    return {};
  }
  std::vector<std::max_align_t> storage(size.dls_size / sizeof(std::max_align_t) + 1);
  auto* path = new (storage.data()) Dl_serinfo;
  if (dlinfo(self, RTLD_DI_SERINFOSIZE, path) != 0 ||
      dlinfo(self, RTLD_DI_SERINFO, path) != 0) {
    return {};
  }
  std::vector<std::string> folders;
  const Dl_serpath* entries = path->dls_serpath;
  for (unsigned i = 0; i < path->dls_cnt; ++i) {
    if (*entries[i].dls_name != '\0') folders.emplace_back(entries[i].dls_name);
  }
  return folders;
}

}  // namespace

void* OpenEngineModule(const std::string& name) {
  std::vector<std::string> folders = PluginPath();
  for (std::string& folder : RunPath()) folders.push_back(std::move(folder));
  std::string searched;
  for (const std::string& folder : folders) {
    const std::filesystem::path file = std::filesystem::path(folder) / (name + ".so");
    std::error_code unreadable;
    if (std::filesystem::exists(file, unreadable)) {
      if (void* module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL)) return module;
      throw std::runtime_error(file.string() + " does not load: " + dlerror());
    }
    searched += (searched.empty() ? "" : ", ") + folder;
  }
  throw std::runtime_error(name + ".so was not found in " + searched +
                           "; set TOUCHSTONE_PLUGIN_PATH to the folder that holds it");
}

}  // namespace touchstone
