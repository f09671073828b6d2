#include "reports/measures/invalidity.h"

#include <cmath>
#include <string_view>

#include <fmt/format.h>

namespace touchstone {
namespace {

std::optional<Invalidity> NotUnit(std::string_view name, const Eigen::Vector3d& n,
                                  double slack) {
  if (!n.allFinite()) return Invalidity{fmt::format("{} is not finite", name)};
  const double length = n.norm();
  const double off = std::abs(length - 1);
  if (off <= slack) return std::nullopt;
  // A float has seven digits: nine would hide what is wrong with an undeclared one.
  return Invalidity{
      fmt::format("{} has length {:.17g}, not 1 to within {:.2g}", name, length, slack),
      off < 0.5 ? std::optional(off) : std::nullopt};
}

}  // namespace

std::optional<Invalidity> InvalidityOf(const ContactAnswer& answer, double unit_slack) {
  if (answer.separation && !std::isfinite(*answer.separation)) {
    return Invalidity{fmt::format("separation is {}", *answer.separation)};
  }
  if (answer.n_AB_W) {
    if (auto fault = NotUnit("n_AB_W", *answer.n_AB_W, unit_slack)) return fault;
  }
  for (std::size_t i = 0; i < answer.points.size(); ++i) {
    const ContactPoint& contact = answer.points[i];
    const std::string name = fmt::format("points[{}]", i);
    if (!contact.p_WC.allFinite()) return Invalidity{name + ".p_WC is not finite"};
    if (!std::isfinite(contact.separation))
      return Invalidity{name + ".separation is not finite"};
    if (!contact.n_AB_W && !answer.n_AB_W) return Invalidity{name + " has no normal"};
    if (!contact.n_AB_W) continue;
    if (auto fault = NotUnit(name + ".n_AB_W", *contact.n_AB_W, unit_slack)) return fault;
  }
  if (answer.witnesses &&
      !(answer.witnesses->p_WCa.allFinite() && answer.witnesses->p_WCb.allFinite())) {
    return Invalidity{"a witness point is not finite"};
  }
  return std::nullopt;
}

}  // namespace touchstone
