#pragma once

#include <span>
#include <string>

#include "oracles/contact_answer.h"
#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** What a drawing shows. */
enum class SketchView {
  kWhole,  ///< Both shapes.
  kClose,  ///< Where they touch or come nearest, magnified.
};

/** Draws `query` as an SVG element: an orthographic view on the plane of the certified
 normal and the vertical (world z; x where the normal is vertical), with both silhouettes,
 the normal, the certificate's two points and planes, and the contact points of `answers`
 (the first is the subject's, drawn filled). Coordinates are in the drawing's own units; a
 label tells the width of the view. Colours are the classes of reports/writers/page.css.
 */
std::string Sketch(const ContactQuery& query, const ContactTruth& truth,
                   std::span<const ContactAnswer> answers, SketchView view);

}  // namespace touchstone
