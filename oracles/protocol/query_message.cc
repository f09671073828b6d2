#include "oracles/protocol/query_message.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "scenarios/validate.h"

namespace touchstone {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr std::size_t kBodyHead = 18;  // Numbers of a body in a frame before its sizes.

// The orientation of `pose` as a quaternion: the stated one, else that of its matrix.
Quaterniond QuaternionOf(const Pose& pose) {
  return pose.q_WB ? *pose.q_WB : Quaterniond(pose.R_WB).normalized();
}

// The pose of a question. The matrix is the question; the quaternion is kept where it is
// the source of the matrix.
Pose PoseFrom(const Vector3d& p_WB, const Matrix3d& R_WB, const Quaterniond& q_WB) {
  const Pose turned = Pose::FromQuaternion(p_WB, q_WB);
  return turned.R_WB == R_WB ? turned : Pose::FromMatrix(p_WB, R_WB);
}

struct SizesToJson {
  Json& json;

  void operator()(const Sphere& sphere) const { json["radius"] = ToJson(sphere.radius); }
  void operator()(const Box& box) const {
    json["half_extents"] = ToJson(box.half_extents);
  }
  void operator()(const Capsule& capsule) const {
    json["radius"] = ToJson(capsule.radius);
    json["half_length"] = ToJson(capsule.half_length);
  }
  void operator()(const Cylinder& cylinder) const {
    json["radius"] = ToJson(cylinder.radius);
    json["half_length"] = ToJson(cylinder.half_length);
  }
  void operator()(const Cone& cone) const {
    json["radius"] = ToJson(cone.radius);
    json["half_height"] = ToJson(cone.half_height);
  }
  void operator()(const ConvexHull& hull) const {
    Json& vertices = json["vertices"] = Json::array();
    for (const Vector3d& vertex : hull.vertices) vertices.push_back(ToJson(vertex));
  }
  void operator()(const HalfSpace&) const {}
};

Shape ShapeFrom(const Received& json) {
  const std::string name = json["shape"].Text();
  if (name == NameOf(ShapeKind::kSphere)) return Sphere{json["radius"].Number()};
  if (name == NameOf(ShapeKind::kBox)) return Box{json["half_extents"].Vector()};
  if (name == NameOf(ShapeKind::kCapsule))
    return Capsule{json["radius"].Number(), json["half_length"].Number()};
  if (name == NameOf(ShapeKind::kCylinder))
    return Cylinder{json["radius"].Number(), json["half_length"].Number()};
  if (name == NameOf(ShapeKind::kCone))
    return Cone{json["radius"].Number(), json["half_height"].Number()};
  if (name == NameOf(ShapeKind::kHalfSpace)) return HalfSpace{};
  if (name != NameOf(ShapeKind::kConvexHull)) json["shape"].Fail("the name of a shape");
  ConvexHull hull;
  for (const Received& vertex : json["vertices"].Items())
    hull.vertices.push_back(vertex.Vector());
  return hull;
}

struct SizesToFrame {
  std::vector<double> operator()(const Sphere& sphere) const { return {sphere.radius}; }
  std::vector<double> operator()(const Box& box) const {
    return {box.half_extents.begin(), box.half_extents.end()};
  }
  std::vector<double> operator()(const Capsule& capsule) const {
    return {capsule.radius, capsule.half_length};
  }
  std::vector<double> operator()(const Cylinder& cylinder) const {
    return {cylinder.radius, cylinder.half_length};
  }
  std::vector<double> operator()(const Cone& cone) const {
    return {cone.radius, cone.half_height};
  }
  std::vector<double> operator()(const ConvexHull& hull) const {
    std::vector<double> sizes;
    for (const Vector3d& vertex : hull.vertices) Append(sizes, vertex);
    return sizes;
  }
  std::vector<double> operator()(const HalfSpace&) const { return {}; }
};

void AppendBody(std::vector<double>& frame, const Body& body) {
  frame.push_back(static_cast<double>(KindOf(body.shape)));
  Append(frame, body.X_WB.p_WB);
  for (int row = 0; row < 3; ++row) Append(frame, body.X_WB.R_WB.row(row).transpose());
  const Quaterniond q_WB = QuaternionOf(body.X_WB);
  frame.insert(frame.end(), {q_WB.w(), q_WB.x(), q_WB.y(), q_WB.z()});
  const std::vector<double> sizes = std::visit(SizesToFrame{}, body.shape);
  frame.push_back(static_cast<double>(sizes.size()));
  frame.insert(frame.end(), sizes.begin(), sizes.end());
}

Shape ShapeFrom(ShapeKind kind, std::span<const double> sizes) {
  const auto expect = [&](std::size_t count) {
    if (sizes.size() == count) return;
    throw ProtocolError(fmt::format("frame: {} sizes of a {}; expected {}", sizes.size(),
                                    NameOf(kind), count));
  };
  switch (kind) {
    case ShapeKind::kSphere:
      expect(1);
      return Sphere{sizes[0]};
    case ShapeKind::kBox:
      expect(3);
      return Box{{sizes[0], sizes[1], sizes[2]}};
    case ShapeKind::kCapsule:
      expect(2);
      return Capsule{sizes[0], sizes[1]};
    case ShapeKind::kCylinder:
      expect(2);
      return Cylinder{sizes[0], sizes[1]};
    case ShapeKind::kCone:
      expect(2);
      return Cone{sizes[0], sizes[1]};
    case ShapeKind::kHalfSpace:
      expect(0);
      return HalfSpace{};
    case ShapeKind::kConvexHull:
      break;
  }
  expect(sizes.size() / 3 * 3);
  ConvexHull hull;
  for (std::size_t i = 0; i < sizes.size(); i += 3)
    hull.vertices.emplace_back(sizes[i], sizes[i + 1], sizes[i + 2]);
  return hull;
}

Body BodyFrom(FrameReader& frame) {
  const double kind = frame.Number();
  if (!(kind >= 0 && kind < kShapeKinds)) {
    throw ProtocolError(
        fmt::format("frame: shape {}; expected 0 to {}", kind, kShapeKinds - 1));
  }
  const Vector3d p_WB = frame.Vector();
  Matrix3d R_WB;
  for (int row = 0; row < 3; ++row) R_WB.row(row) = frame.Vector().transpose();
  const std::span<const double> q = frame.Numbers(4);
  const std::span<const double> sizes = frame.Numbers(frame.Count(1));
  return {ShapeFrom(static_cast<ShapeKind>(static_cast<int>(kind)), sizes),
          PoseFrom(p_WB, R_WB, {q[0], q[1], q[2], q[3]})};
}

// Throws if a question is not valid: an engine must not see it.
void ExpectValid(const ContactQuery& query, std::size_t index) {
  const std::vector<Fault> faults = FaultsOf(query);
  if (faults.empty()) return;
  const Fault& fault = faults.front();
  throw ProtocolError(fmt::format("queries[{}].{} {}; expected {}", index, fault.where,
                                  fault.what, fault.expected));
}

}  // namespace

Json ToJson(const Body& body) {
  Json json;
  json["shape"] = NameOf(KindOf(body.shape));
  std::visit(SizesToJson{json}, body.shape);
  json["position"] = ToJson(body.X_WB.p_WB);
  Json& rotation = json["rotation"] = Json::array();
  for (int row = 0; row < 3; ++row)
    rotation.push_back(ToJson(Vector3d(body.X_WB.R_WB.row(row).transpose())));
  const Quaterniond q_WB = QuaternionOf(body.X_WB);
  json["quaternion"] = Json::array(
      {ToJson(q_WB.w()), ToJson(q_WB.x()), ToJson(q_WB.y()), ToJson(q_WB.z())});
  return json;
}

Body BodyFrom(const Received& json) {
  Matrix3d R_WB;
  const std::vector<Received> rows = json["rotation"].Items(3);
  for (int row = 0; row < 3; ++row)
    R_WB.row(row) = rows[static_cast<std::size_t>(row)].Vector().transpose();
  const std::vector<Received> q = json["quaternion"].Items(4);
  return {ShapeFrom(json),
          PoseFrom(json["position"].Vector(), R_WB,
                   {q[0].Number(), q[1].Number(), q[2].Number(), q[3].Number()})};
}

void PutQueries(std::span<const ContactQuery> queries, bool in_frame, Message& message) {
  if (in_frame) {
    message.line["count"] = queries.size();
    for (const ContactQuery& query : queries) {
      AppendBody(message.frame, query.A);
      AppendBody(message.frame, query.B);
    }
    return;
  }
  Json& list = message.line["queries"] = Json::array();
  for (const ContactQuery& query : queries)
    list.push_back({{"A", ToJson(query.A)}, {"B", ToJson(query.B)}});
}

std::vector<ContactQuery> QueriesFrom(const Message& message) {
  std::vector<ContactQuery> queries;
  const Received line(message.line, "contact");
  if (const std::optional<Received> list = line.Find("queries")) {
    for (const Received& query : list->Items())
      queries.push_back({BodyFrom(query["A"]), BodyFrom(query["B"])});
  } else {
    const std::size_t most = message.frame.size() / (2 * kBodyHead);
    const int count = line["count"].Whole(0, static_cast<int>(most));
    FrameReader frame(message.frame);
    for (int i = 0; i < count; ++i) {
      const Body A = BodyFrom(frame);
      queries.push_back({A, BodyFrom(frame)});
    }
    frame.ExpectEnd();
  }
  for (std::size_t i = 0; i < queries.size(); ++i) ExpectValid(queries[i], i);
  return queries;
}

}  // namespace touchstone
