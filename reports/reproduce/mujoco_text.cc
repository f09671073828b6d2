#include "reports/reproduce/mujoco_text.h"

namespace touchstone {

std::string MujocoIncludes() {
  return "#include <cstdlib>\n#include <string>\n\n#include <mujoco/mujoco.h>\n";
}

std::string LoadMujocoModel() {
  return R"(
// Compiles a model in MJCF.
mjModel* Load(const std::string& mjcf) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "model.xml", static_cast<int>(mjcf.size()));
  const int file = mj_findFileVFS(files.get(), "model.xml");
  mjcf.copy(static_cast<char*>(files->filedata[file]), mjcf.size());
  char error[500] = "";
  mjModel* const model = mj_loadXML("model.xml", files.get(), error, sizeof(error));
  mj_deleteVFS(files.get());
  if (model == nullptr) {
    std::fprintf(stderr, "%s\n", error);
    std::exit(2);
  }
  return model;
}
)";
}

std::string FindMujoco() {
  return "find_library(MUJOCO_LIBRARY mujoco REQUIRED)\n"
         "find_path(MUJOCO_INCLUDE mujoco/mujoco.h REQUIRED)\n"
         "add_library(engine INTERFACE)\n"
         "target_link_libraries(engine INTERFACE ${MUJOCO_LIBRARY})\n"
         "target_include_directories(engine INTERFACE ${MUJOCO_INCLUDE})\n";
}

}  // namespace touchstone
