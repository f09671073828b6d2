#include "reports/contacts/causes/tie.h"

#include <fmt/format.h>

#include "reports/contacts/checks/mixed_normals.h"
#include "reports/text/format_vector.h"

namespace touchstone {

std::optional<std::string> TieOf(const ContactTruth& truth, const Eigen::Vector3d& n_W) {
  const double angle = AngleBetween(n_W, truth.certificate.n_AB_W);
  if (angle <= kOtherNormal) return std::nullopt;
  return fmt::format("{} is as short as {}, {:.3g} rad away", FormatVector(n_W),
                     FormatVector(truth.certificate.n_AB_W), angle);
}

}  // namespace touchstone
