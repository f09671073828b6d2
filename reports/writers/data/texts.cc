#include "reports/writers/data/texts.h"

namespace touchstone {

int Texts::IndexOf(std::string_view text) {
  if (text.empty()) return -1;
  const auto found = indices_.find(text);
  if (found != indices_.end()) return found->second;
  const int index = static_cast<int>(all_.size());
  indices_.emplace(text, index);
  all_.push_back(std::string(text));
  return index;
}

}  // namespace touchstone
