#include "reports/text/quoted_name.h"

namespace touchstone {

std::string QuotedName(std::string_view name) {
  return "“" + std::string(name) + "”";
}

}  // namespace touchstone
