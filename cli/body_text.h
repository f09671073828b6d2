#pragma once

#include <string_view>

#include "scenarios/contact_query.h"

namespace touchstone {

/** How a body is written on the command line, for --help. */
inline constexpr std::string_view kBodySyntax =
    "SHAPE SIZES [@ X Y Z] [q W X Y Z | R nine numbers by rows], metres:\n"
    "  sphere RADIUS | box HX HY HZ (half extents) | capsule RADIUS HALF_LENGTH |\n"
    "  cylinder RADIUS HALF_LENGTH | cone RADIUS HALF_HEIGHT | half_space |\n"
    "  convex_hull X Y Z X Y Z ...\n"
    "Without @ it is at the origin, without q or R it is not turned; q is normalised.\n"
    "Example: 'box 1 2 3 @ 0 0 0.5 q 0.9 0.1 0.3 0.3'";

/** Reads a body from `text`, in kBodySyntax. Throws InputError, naming the word that is
 wrong. Sizes and rotations are not judged here (scenarios/validate.h does). */
Body ParseBody(std::string_view text);

}  // namespace touchstone
