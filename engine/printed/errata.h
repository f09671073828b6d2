#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace cookbook::printed {

/** A fault of the published recipes; FaultOf() describes it. The value is its number:
 kE01 is "E-01". */
enum class Erratum {
  kE01 = 1,
  kE02,
  kE03,
  kE04,
  kE05,
  kE06,
  kE07,
  kE08,
  kE09,
  kE10,
  kE11,
  kE12,
  kE13,
  kE14,
  kE15,
  kE16,
  kE17,
  kE18,
  kE19,
  kE20,
  kE21,
  kE22,
  kE23,
  kE24,
  kE25,
  kE26,
  kE27,
  kE28,
  kE29,
  kE30
};

/** Every erratum of the contact recipes, in order. */
inline constexpr std::initializer_list<Erratum> kContactErrata = {
    Erratum::kE01, Erratum::kE02, Erratum::kE03, Erratum::kE04, Erratum::kE05,
    Erratum::kE06, Erratum::kE07, Erratum::kE08, Erratum::kE09, Erratum::kE26,
    Erratum::kE27, Erratum::kE28, Erratum::kE29, Erratum::kE30};

/** Every erratum of the recipes of motion, in order. */
inline constexpr std::initializer_list<Erratum> kMotionErrata = {
    Erratum::kE10, Erratum::kE11, Erratum::kE12, Erratum::kE13,
    Erratum::kE14, Erratum::kE15, Erratum::kE16, Erratum::kE17,
    Erratum::kE18, Erratum::kE19, Erratum::kE20, Erratum::kE21,
    Erratum::kE22, Erratum::kE23, Erratum::kE24, Erratum::kE25};

/** The set of errata in force. */
class Errata {
 public:
  constexpr Errata() = default;
  constexpr Errata(std::initializer_list<Erratum> errata) {
    for (const Erratum erratum : errata) Add(erratum);
  }

  constexpr void Add(Erratum erratum) { bits_ |= Bit(erratum); }

  /** Returns all errata: the recipes as printed. */
  static constexpr Errata All() {
    Errata all(kContactErrata);
    for (const Erratum erratum : kMotionErrata) all.Add(erratum);
    return all;
  }
  /** Returns no errata: the corrected recipes. */
  static constexpr Errata None() { return {}; }

  constexpr bool Has(Erratum erratum) const { return (bits_ & Bit(erratum)) != 0; }
  constexpr bool operator==(const Errata&) const = default;

 private:
  static constexpr std::uint32_t Bit(Erratum erratum) {
    return std::uint32_t{1} << static_cast<int>(erratum);
  }
  std::uint32_t bits_ = 0;
};

/** Returns the name of an erratum, for example "E-04". */
std::string NameOf(Erratum erratum);

/** Returns a description of the fault, as a sentence without a full stop: "depths of
 spheres are halved". */
std::string_view FaultOf(Erratum erratum);

/** Returns the erratum called `name`, or nothing. */
std::optional<Erratum> ErratumNamed(std::string_view name);

}  // namespace cookbook::printed
