#pragma once

#include <span>
#include <string>

#include "oracles/contact_answer.h"
#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** The region that a drawing shows. */
enum class SketchView {
  kWhole,  ///< Both shapes.
  kClose,  ///< The region where they touch or come nearest, magnified.
};

/** Draws `query` as an SVG element. The view is orthographic, onto the plane of the
 certified normal and the vertical (world z; x where the normal is vertical). It shows
 both silhouettes, the normal, and the contact points of `answers`, the first of which is
 the subject's and drawn filled. A close view also shows the two points and planes of the
 certificate. Coordinates are in SVG units; a label states the width of the view. Colours
 are classes of reports/writers/page.css. */
std::string Sketch(const ContactQuery& query, const ContactTruth& truth,
                   std::span<const ContactAnswer> answers, SketchView view);

}  // namespace touchstone
