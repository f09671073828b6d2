#include "reports/writers/sketch.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "reports/writers/silhouette.h"

namespace touchstone {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kUnits = 100;  // Half width of the picture. [SVG units]

// Points closer than this to the last one drawn are not visible. [SVG units]
constexpr double kIndistinct = 0.2;

std::string Number(double value) {
  const std::string text = fmt::format("{:.2f}", value);
  return text == "-0.00" ? "0.00" : text;
}

std::string At(const Vector2d& p) {
  return fmt::format("{} {}", Number(kUnits * p.x()), Number(-kUnits * p.y()));
}

std::string PathData(const Polyline& line, bool closed) {
  std::string data;
  Vector2d last(1e300, 1e300);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool is_end = !closed && i + 1 == line.size();
    if (!is_end && kUnits * (line[i] - last).norm() < kIndistinct) continue;
    data += fmt::format("{}{}", data.empty() ? "M" : "L", At(line[i]));
    last = line[i];
  }
  return data.empty() || !closed ? data : data + "Z";
}

std::string Path(std::string_view css_class, const std::string& data) {
  return data.empty() ? "" : fmt::format(R"(<path class="{}" d="{}"/>)", css_class, data);
}

std::string DrawBody(const Body& body, const View& view, const Vector3d& n_W,
                     std::string_view css_class) {
  std::string svg =
      Path(css_class, PathData(ClipToPicture(OutlineOf(body, view, n_W)), true));
  std::string inner;
  for (const Polyline& line : InnerLinesOf(body, view)) {
    for (const Polyline& part : ClipLineToPicture(line)) inner += PathData(part, false);
  }
  return svg + Path("inner", inner);
}

bool IsInPicture(const Vector2d& p) {
  return p.cwiseAbs().maxCoeff() <= 1;
}

std::string Dot(const Vector2d& p, double radius, std::string_view css_class) {
  if (!IsInPicture(p)) return "";
  return fmt::format(R"(<circle class="{}" cx="{}" cy="{}" r="{}"/>)", css_class,
                     Number(kUnits * p.x()), Number(-kUnits * p.y()), radius);
}

std::string Label(const Vector2d& p, std::string_view text) {
  if (!IsInPicture(p)) return "";
  return fmt::format(R"(<text x="{}" y="{}">{}</text>)", Number(kUnits * p.x()),
                     Number(-kUnits * p.y()), text);
}

// The certified normal if it is valid, else the direction between the bodies, else z.
Vector3d ViewNormal(const ContactQuery& query, const ContactTruth& truth) {
  const Vector3d& n = truth.certificate.n_AB_W;
  if (n.allFinite() && n.norm() > 0.5) return n.normalized();
  const Vector3d between = query.B.X_WB.p_WB - query.A.X_WB.p_WB;
  return between.norm() > 0 ? between.normalized() : Vector3d::UnitZ();
}

View WholeView(const ContactQuery& query, const Vector3d& n_W) {
  Vector3d up_W = Vector3d::UnitZ();
  Vector3d right_W = n_W - n_W.z() * up_W;
  // Within eight degrees of the vertical, their common plane is ill-defined: up is then
  // n.
  if (std::abs(n_W.z()) > 0.99) {
    up_W = std::copysign(1.0, n_W.z()) * n_W;
    right_W = Vector3d::UnitX() - up_W.x() * up_W;
  }
  right_W.normalize();
  View view{right_W, up_W, Vector3d::Zero(), 1};
  Vector2d lo = Vector2d::Constant(1e300);
  Vector2d hi = -lo;
  for (const Body* body : {&query.A, &query.B}) {
    if (KindOf(body->shape) == ShapeKind::kHalfSpace) continue;
    for (const Vector2d& p : OutlineOf(*body, view, n_W)) {
      lo = lo.cwiseMin(p);
      hi = hi.cwiseMax(p);
    }
  }
  const Vector2d centre = (lo + hi) / 2;
  view.centre_W = centre.x() * right_W + centre.y() * up_W;
  constexpr double kMargin = 1.15;  // Space around the shapes.
  view.half_width = std::max(kMargin * (hi - lo).maxCoeff() / 2, 1e-300);
  return view;
}

View CloseView(const ContactTruth& truth, const View& whole) {
  const Vector3d centre = (truth.certificate.p_WCa + truth.certificate.p_WCb) / 2;
  if (!centre.allFinite()) return whole;
  const double separation = std::abs((truth.separation.lo + truth.separation.hi) / 2);
  // The separation is an eighth of the picture. Where it is zero, or too small to resolve
  // in double, the region of contact is magnified a hundred times.
  const double smallest = 1e-9 * whole.half_width;
  const double wanted =
      4 * separation > smallest ? 4 * separation : whole.half_width / 100;
  View close = whole;
  close.centre_W = centre;
  close.half_width = std::min(wanted, whole.half_width / 4);
  return close;
}

std::string DrawNormal(const View& view, const Vector3d& n_W, const Vector3d& from_W) {
  constexpr double kLength = 0.4;
  constexpr double kHead = 0.07;
  const Vector2d tail = view * from_W;
  if (!tail.allFinite() || !IsInPicture(tail)) return "";
  const Vector2d n(view.right_W.dot(n_W), view.up_W.dot(n_W));
  const Vector2d t(-n.y(), n.x());
  const Vector2d head = tail + kLength * n;
  const Polyline arrow = {head, head - kHead * n + 0.4 * kHead * t,
                          head - kHead * n - 0.4 * kHead * t};
  return Path("normal", PathData({tail, head}, false)) +
         Path("normal head", PathData(arrow, true));
}

std::string DrawPlanes(const View& view, const Vector3d& n_W, const Certificate& proof) {
  const Vector2d n(view.right_W.dot(n_W), view.up_W.dot(n_W));
  const Vector2d t(-n.y(), n.x());
  std::string data;
  for (const Vector3d* p_W : {&proof.p_WCa, &proof.p_WCb}) {
    const Vector2d p = view * *p_W;
    if (!p.allFinite()) continue;
    for (const Polyline& part : ClipLineToPicture({p - 4 * t, p + 4 * t})) {
      data += PathData(part, false);
    }
  }
  return Path("plane", data);
}

std::string DrawContacts(const View& view, std::span<const ContactAnswer> answers) {
  std::string svg;
  // The subject's points are drawn last, on top of the others.
  for (std::size_t i = answers.size(); i-- > 0;) {
    for (const ContactPoint& point : answers[i].points) {
      const Vector2d p = view * point.p_WC;
      if (!p.allFinite()) continue;
      svg += i == 0 ? Dot(p, 2.6, "contact subject") : Dot(p, 4, "contact");
    }
  }
  return svg;
}

std::string DrawNames(const ContactQuery& query, const View& view, const Vector3d& n_W,
                      SketchView kind) {
  const Vector2d n(view.right_W.dot(n_W), view.up_W.dot(n_W));
  const auto place = [&](const Body& body, double side) -> Vector2d {
    const bool has_centre = KindOf(body.shape) != ShapeKind::kHalfSpace;
    if (kind == SketchView::kWhole && has_centre) return view * body.X_WB.p_WB;
    return side * 0.75 * n;
  };
  return Label(place(query.A, -1), "A") + Label(place(query.B, 1), "B");
}

}  // namespace

std::string Sketch(const ContactQuery& query, const ContactTruth& truth,
                   std::span<const ContactAnswer> answers, SketchView kind) {
  const Vector3d n_W = ViewNormal(query, truth);
  const View whole = WholeView(query, n_W);
  const bool is_close = kind == SketchView::kClose;
  const View view = is_close ? CloseView(truth, whole) : whole;
  const Certificate& proof = truth.certificate;

  std::string svg = fmt::format(
      R"(<svg class="sketch" viewBox="-100 -100 200 200" role="img"><title>{}</title>)",
      is_close ? "Closest region of A and B, viewed perpendicular to the normal"
               : "A and B, viewed perpendicular to the normal");
  svg += DrawBody(query.A, view, n_W, "A") + DrawBody(query.B, view, n_W, "B");
  if (is_close) svg += DrawPlanes(view, n_W, proof);
  svg += DrawContacts(view, answers);
  svg += DrawNormal(view, n_W, (proof.p_WCa + proof.p_WCb) / 2);
  if (is_close) {
    svg +=
        Dot(view * proof.p_WCa, 1.6, "witness") + Dot(view * proof.p_WCb, 1.6, "witness");
  }
  svg += DrawNames(query, view, n_W, kind);
  svg += fmt::format(R"(<text class="scale" x="-97" y="97">{:.3g} m wide</text></svg>)",
                     2 * view.half_width);
  return svg;
}

}  // namespace touchstone
