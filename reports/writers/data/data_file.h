#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "reports/writers/data/json_values.h"

namespace touchstone {

/** The version of the format, see docs/report_data.md. */
inline constexpr int kReportDataVersion = 1;

/** The two parts of report data. */
struct DataFile {
  DataJson json;     ///< An object.
  std::string blob;  ///< The tracks that it refers to.
};

/** The parts of report data, or why they cannot be told apart. */
struct Unpacked {
  std::optional<DataFile> file;
  std::string fault;  ///< "is cut off"; empty if there is a file.
};

/** Returns the bytes of a file, deflated. Text that is not UTF-8 is replaced. */
std::string PackData(const DataFile& file);

/** Takes bytes apart. Whatever they are, it keeps at most `most` inflated bytes. */
Unpacked UnpackData(std::string_view bytes, std::size_t most);

}  // namespace touchstone
