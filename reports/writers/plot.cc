#include "reports/writers/plot.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "reports/writers/xml_text.h"

namespace touchstone {
namespace {

// Size and borders of the drawing. [drawing units]
constexpr double kWidth = 320;
constexpr double kHeight = 190;
constexpr double kLeft = 8;
constexpr double kTop = 24;
constexpr double kBottom = 22;

/** Number of points that a line of kWidth can resolve. */
constexpr std::size_t kPoints = 160;

struct Range {
  double lo = HUGE_VAL;
  double hi = -HUGE_VAL;

  void Take(double value) {
    if (!std::isfinite(value)) return;
    lo = std::min(lo, value);
    hi = std::max(hi, value);
  }
};

/** Returns the label of the lower end. Where both ends print alike, it is "high - range":
 otherwise a line that varies by rounding only would seem to fall across the plot. */
std::string LowLabel(const Range& range) {
  const std::string low = fmt::format("{:.4g}", range.lo);
  const std::string high = fmt::format("{:.4g}", range.hi);
  return low != high ? low : fmt::format("{} − {:.2g}", high, range.hi - range.lo);
}

class Drawing {
 public:
  Drawing(const CurveSet& set, double band) : set_(set), band_(band) {
    for (const Curve& curve : set.of_oracle) Fit(curve, 0);
    if (set.truth) Fit(*set.truth, band);
    // A constant value is drawn in the middle, and variation by rounding is not visible.
    const double least = 1e-9 * std::max(std::abs(y_.lo), std::abs(y_.hi));
    if (y_.hi - y_.lo <= least) {
      const double margin = std::max(least, 1e-300);
      y_ = {y_.lo - margin, y_.hi + margin};
    }
  }

  std::string Svg() const {
    std::string svg = fmt::format(
        "<svg class=\"plot\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">"
        "<text x=\"{}\" y=\"11\">{} [{}]</text>",
        kWidth, kHeight, XmlText(set_.title + " over time"), kLeft, XmlText(set_.title),
        XmlText(set_.unit));
    svg += fmt::format(
        "<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>", kLeft,
        kTop, kWidth - 2 * kLeft, kHeight - kTop - kBottom);
    if (set_.truth) svg += Band(*set_.truth);
    // The subject's line is drawn after the others, so that none hides it. The dashed
    // truth is on top: lines that follow it show through its gaps.
    for (std::size_t o = set_.of_oracle.size(); o-- > 0;)
      svg += Line(set_.of_oracle[o], LineClass(o));
    if (set_.truth) svg += Line(*set_.truth, "truth");
    svg += fmt::format(
        "<text class=\"tick\" x=\"{}\" y=\"{}\">{:.4g}</text>"
        "<text class=\"tick\" x=\"{}\" y=\"{}\">{}</text>"
        "<text class=\"tick\" x=\"{}\" y=\"{}\">{:.4g} s</text>"
        "<text class=\"tick end\" x=\"{}\" y=\"{}\">{:.4g} s</text></svg>\n",
        kLeft + 3, kTop + 9, y_.hi, kLeft + 3, kHeight - kBottom - 3, LowLabel(y_), kLeft,
        kHeight - kBottom + 12, x_.lo, kWidth - kLeft, kHeight - kBottom + 12, x_.hi);
    return svg;
  }

 private:
  void Fit(const Curve& curve, double band) {
    for (const double t : curve.times) x_.Take(t);
    for (const double value : curve.values) {
      y_.Take(value - band);
      y_.Take(value + band);
    }
  }

  std::string Point(double t, double value) const {
    const double width = x_.hi > x_.lo ? x_.hi - x_.lo : 1;
    const double x = kLeft + (t - x_.lo) / width * (kWidth - 2 * kLeft);
    const double y = kHeight - kBottom -
                     (value - y_.lo) / (y_.hi - y_.lo) * (kHeight - kTop - kBottom);
    return fmt::format("{:.1f},{:.1f} ", x, y);
  }

  static std::size_t Stride(const Curve& curve) {
    return std::max<std::size_t>(1, curve.times.size() / kPoints);
  }

  std::string Line(const Curve& curve, std::string_view css_class) const {
    std::string points;
    for (std::size_t i = 0; i < curve.times.size(); i += Stride(curve)) {
      if (std::isfinite(curve.values[i]))
        points += Point(curve.times[i], curve.values[i]);
    }
    if (points.empty()) return "";
    return fmt::format("<polyline class=\"{}\" points=\"{}\"/>", css_class, points);
  }

  std::string Band(const Curve& truth) const {
    if (!(band_ > 0)) return "";
    std::string there;
    std::string back;
    for (std::size_t i = 0; i < truth.times.size(); i += Stride(truth)) {
      there += Point(truth.times[i], truth.values[i] + band_);
      back.insert(0, Point(truth.times[i], truth.values[i] - band_));
    }
    return fmt::format("<polygon class=\"band\" points=\"{}{}\"/>", there, back);
  }

  const CurveSet& set_;
  double band_;
  Range x_;
  Range y_;
};

}  // namespace

std::string LineClass(std::size_t oracle) {
  constexpr std::size_t kColours = 8;
  if (oracle == 0) return "line0";
  return fmt::format("line{}{}", 1 + (oracle - 1) % kColours,
                     oracle > kColours ? " again" : "");
}

std::string Plot(const CurveSet& set, double band) {
  const bool any = std::any_of(set.of_oracle.begin(), set.of_oracle.end(),
                               [](const Curve& curve) { return !curve.values.empty(); });
  return any ? Drawing(set, band).Svg() : "";
}

}  // namespace touchstone
