#include "reports/writers/data/contact_data.h"

#include <cmath>
#include <numeric>
#include <utility>
#include <variant>

#include "reports/referee/referee.h"
#include "reports/writers/describe.h"

namespace touchstone {
namespace {

/** All of a double: depths of 1e-12 m decide between answers at 1 m. */
constexpr int kDigits = 17;

struct ShapeToData {
  DataJson operator()(const Sphere& sphere) const {
    return {{"type", "sphere"}, {"radius", ToData(sphere.radius, kDigits)}};
  }
  DataJson operator()(const Box& box) const {
    return {{"type", "box"}, {"half", ToData(box.half_extents, kDigits)}};
  }
  DataJson operator()(const Capsule& capsule) const {
    return {{"type", "capsule"},
            {"radius", ToData(capsule.radius, kDigits)},
            {"length", ToData(2 * capsule.half_length, kDigits)}};
  }
  DataJson operator()(const Cylinder& cylinder) const {
    return {{"type", "cylinder"},
            {"radius", ToData(cylinder.radius, kDigits)},
            {"length", ToData(2 * cylinder.half_length, kDigits)}};
  }
  DataJson operator()(const Cone& cone) const {
    return {{"type", "cone"},
            {"radius", ToData(cone.radius, kDigits)},
            {"length", ToData(2 * cone.half_height, kDigits)}};
  }
  DataJson operator()(const ConvexHull& hull) const {
    DataJson vertices = DataJson::array();
    for (const Eigen::Vector3d& vertex : hull.vertices)
      vertices.push_back(ToData(vertex, kDigits));
    return {{"type", "hull"}, {"vertices", std::move(vertices)}};
  }
  DataJson operator()(const HalfSpace&) const { return {{"type", "half_space"}}; }
};

DataJson BodyData(const Body& body) {
  return {{"shape", ShapeData(body.shape)},
          {"p", ToData(body.X_WB.p_WB, kDigits)},
          {"q", ToData(Eigen::Quaterniond(body.X_WB.R_WB), kDigits)}};
}

DataJson TruthData(const ContactQuery& query, const ContactTruth& truth) {
  DataJson data;
  data["touching"] = NameOf(truth.touching);
  data["lo"] = ToData(truth.separation.lo, kDigits);
  data["hi"] = ToData(truth.separation.hi, kDigits);
  data["method"] = truth.method;
  data["n"] = ToData(truth.certificate.n_AB_W, kDigits);
  data["pA"] = ToData(truth.certificate.p_WCa, kDigits);
  data["pB"] = ToData(truth.certificate.p_WCb, kDigits);
  data["patch"] = DataJson::array();
  if (truth.touching == Touching::kApart || !truth.certificate.n_AB_W.allFinite() ||
      truth.certificate.n_AB_W.isZero(0)) {
    return data;
  }
  const double middle = std::midpoint(truth.separation.lo, truth.separation.hi);
  if (!std::isfinite(middle)) return data;
  const ContactPatch patch =
      PatchAlong(query, truth.certificate.n_AB_W, middle, truth.input_rounding);
  for (const Eigen::Vector3d& vertex : patch.vertices_W)
    data["patch"].push_back(ToData(vertex, kDigits));
  return data;
}

DataJson AnswerData(const ContactAnswer& answer, bool asked) {
  DataJson data;
  data["status"] = asked ? NameOf(answer.status) : std::string_view("not asked");
  data["reason"] = answer.reason;
  if (!asked || answer.status != AnswerStatus::kAnswered) return data;
  data["touching"] = answer.touching;
  if (answer.n_AB_W) data["n"] = ToData(*answer.n_AB_W, kDigits);
  if (answer.separation) data["separation"] = ToData(*answer.separation, kDigits);
  if (!answer.points.empty()) {
    DataJson points = DataJson::array();
    for (const ContactPoint& point : answer.points) {
      DataJson of_point = {{"p", ToData(point.p_WC, kDigits)},
                           {"s", ToData(point.separation, kDigits)}};
      if (point.n_AB_W) of_point["n"] = ToData(*point.n_AB_W, kDigits);
      points.push_back(std::move(of_point));
    }
    data["points"] = std::move(points);
  }
  if (answer.witnesses) {
    data["witnesses"] = DataJson::array({ToData(answer.witnesses->p_WCa, kDigits),
                                         ToData(answer.witnesses->p_WCb, kDigits)});
  }
  return data;
}

}  // namespace

DataJson ShapeData(const Shape& shape) {
  return std::visit(ShapeToData{}, shape);
}

DataJson ContactData(const ScenarioResult& result, const std::vector<bool>& asked) {
  const ContactQuery& query = result.scenario.contact;
  DataJson data;
  data["A"] = BodyData(query.A);
  data["B"] = BodyData(query.B);
  data["truth"] = TruthData(query, result.truth);
  data["answers"] = DataJson::array();
  for (std::size_t o = 0; o < result.answers.size(); ++o)
    data["answers"].push_back(AnswerData(result.answers[o], asked[o]));
  return data;
}

std::string_view NameOf(AnswerStatus status) {
  switch (status) {
    case AnswerStatus::kAnswered:
      return "answered";
    case AnswerStatus::kUnsupported:
      return "unsupported";
    case AnswerStatus::kCrashed:
      return "crashed";
    case AnswerStatus::kTimedOut:
      return "timed out";
  }
  return "crashed";
}

}  // namespace touchstone
