#pragma once

#include <string>
#include <string_view>

namespace touchstone {

/** Returns a quantity to two digits, three from 100 on, lengths with the prefix of their
 magnitude: "4.8 cm", "13 µm", "0.3 rad", "2e-16 m". "not a number" and "infinite" for
 those. */
std::string SiQuantity(double value, std::string_view unit);

/** Returns a share of `whole`, e.g. "the smaller body", in words: "5 % of the smaller
 body", "12 times the smaller body", "2e-5 of the smaller body". "" for a NaN and for
 infinity. */
std::string ShareInWords(double share, std::string_view whole);

}  // namespace touchstone
