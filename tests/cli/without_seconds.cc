#include "without_seconds.h"

#include <fstream>
#include <regex>
#include <sstream>

#include "reports/writers/data/data_file.h"
#include "reports/writers/read_report_data.h"

namespace touchstone {

std::string WithoutSeconds(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream kept;
  if (file.extension() == ".data") {
    kept << in.rdbuf();
    DataFile data = UnpackData(kept.str(), kMostReportData).file.value();
    data.json.erase("seconds");
    data.json.erase("spent");
    return data.json.dump() + data.blob;
  }
  static const std::regex kTime(R"( time="[0-9.]+")");
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(R"({"kind":"seconds")"))
      kept << std::regex_replace(line, kTime, "") << '\n';
  }
  return kept.str();
}

}  // namespace touchstone
