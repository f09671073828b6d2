#include "oracles/oracle.h"

namespace touchstone {

std::unique_ptr<PreparedBatch> Oracle::Prepare(std::span<const ContactQuery>) const {
  return nullptr;
}

ContactAnswer Oracle::Answer(const ContactQuery& query) const {
  ContactAnswer answer;
  Answer(std::span(&query, 1), std::span(&answer, 1));
  return answer;
}

}  // namespace touchstone
