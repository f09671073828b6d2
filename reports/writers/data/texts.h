#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "reports/writers/data/json_values.h"

namespace touchstone {

/** The strings of a report, each once. */
class Texts {
 public:
  /** Returns the index of `text`, in the order of first use; −1 for "". */
  int IndexOf(std::string_view text);

  /** Returns all strings in the order of their indices. */
  const DataJson& all() const { return all_; }

 private:
  std::map<std::string, int, std::less<>> indices_;
  DataJson all_ = DataJson::array();
};

}  // namespace touchstone
