#include "cli/data_folder.h"

namespace touchstone {

std::filesystem::path DataFolderOfSources() {
  return TOUCHSTONE_SOURCE_DATA_DIR;
}

}  // namespace touchstone
