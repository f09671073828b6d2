#pragma once

#include <string_view>

#include "scenarios/contact_query.h"

namespace touchstone {

/** Syntax of a body on the command line, for --help. */
inline constexpr std::string_view kBodySyntax =
    "SHAPE SIZES [@ X Y Z] [q W X Y Z | R (nine numbers, row by row)], in metres:\n"
    "  sphere RADIUS | box HX HY HZ (half extents) | capsule RADIUS HALF_LENGTH |\n"
    "  cylinder RADIUS HALF_LENGTH | cone RADIUS HALF_HEIGHT | half_space |\n"
    "  convex_hull X Y Z X Y Z ...\n"
    "The default position is the origin, the default orientation is no rotation. q is\n"
    "normalised.\n"
    "Example: 'box 1 2 3 @ 0 0 0.5 q 0.9 0.1 0.3 0.3'";

/** Reads a body from `text`, in kBodySyntax. Throws InputError that names the wrong word.
 Does not validate sizes and rotations (scenarios/validate_scenario.h does). */
Body ParseBody(std::string_view text);

}  // namespace touchstone
