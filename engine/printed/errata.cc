#include "engine/printed/errata.h"

namespace cookbook::printed {

std::string NameOf(Erratum erratum) {
  const int number = static_cast<int>(erratum);
  return (number < 10 ? "E-0" : "E-") + std::to_string(number);
}

std::optional<Erratum> ErratumNamed(std::string_view name) {
  for (const auto& errata : {kContactErrata, kMotionErrata}) {
    for (const Erratum erratum : errata) {
      if (NameOf(erratum) == name) return erratum;
    }
  }
  return std::nullopt;
}

}  // namespace cookbook::printed
