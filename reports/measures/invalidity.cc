#include "reports/measures/invalidity.h"

#include <cmath>
#include <string_view>
#include <utility>

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

/** Returns the graver of two faults: one that leaves no direction or number, then the one
 of the larger size. */
std::optional<Invalidity> Graver(std::optional<Invalidity> a,
                                 std::optional<Invalidity> b) {
  if (!a || !b) return a ? a : b;
  if (!a->off_unit || !b->off_unit) return a->off_unit ? b : a;
  return *b->off_unit > *a->off_unit ? b : a;
}

std::optional<Invalidity> InvalidityOf(const ContactPoint& contact, bool has_normal,
                                       const std::string& name, double unit_slack) {
  if (!contact.p_WC.allFinite()) return Invalidity{name + ".p_WC is not finite"};
  if (!std::isfinite(contact.separation))
    return Invalidity{name + ".separation is not finite"};
  if (contact.n_AB_W) return NotUnit(name + ".n_AB_W", *contact.n_AB_W, unit_slack);
  return has_normal ? std::nullopt : std::optional(Invalidity{name + " has no normal"});
}

}  // namespace

std::optional<Invalidity> InvalidityOf(const ContactAnswer& answer, double unit_slack) {
  if (answer.separation && !std::isfinite(*answer.separation))
    return Invalidity{fmt::format("separation is {}", *answer.separation)};
  std::optional<Invalidity> worst;
  if (answer.n_AB_W) worst = NotUnit("n_AB_W", *answer.n_AB_W, unit_slack);
  for (std::size_t i = 0; i < answer.points.size(); ++i) {
    worst =
        Graver(std::move(worst), InvalidityOf(answer.points[i], answer.n_AB_W.has_value(),
                                              fmt::format("points[{}]", i), unit_slack));
  }
  if (answer.witnesses &&
      !(answer.witnesses->p_WCa.allFinite() && answer.witnesses->p_WCb.allFinite()))
    worst = Graver(std::move(worst), Invalidity{"a witness point is not finite"});
  return worst;
}

}  // namespace touchstone
