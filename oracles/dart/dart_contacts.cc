#include "oracles/dart/dart_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include <dart/collision/CollisionGroup.hpp>
#include <dart/collision/dart/DARTCollisionDetector.hpp>
#include <dart/dynamics/SimpleFrame.hpp>

#include "oracles/dart/dart_shape.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

std::shared_ptr<dart::dynamics::SimpleFrame> FrameOf(const Body& body) {
  auto frame = std::make_shared<dart::dynamics::SimpleFrame>(
      dart::dynamics::Frame::World(), "", ToDart(body.X_WB));
  frame->setShape(ToDart(body.shape));
  return frame;
}

// The height of a point above the surface of a box; negative inside. [m]
double Height(const Body& box, const Vector3d& p_W) {
  const Vector3d p_B = box.X_WB.R_WB.transpose() * (p_W - box.X_WB.p_WB);
  return (p_B.cwiseAbs() - std::get<Box>(box.shape).half_extents).maxCoeff();
}

// The shift to midway for a sphere (the first body) and a box. DART's point is on the
// box, half the depth before midway, or at the sphere's centre if that is inside the box.
// [m]
double ShiftOfSphereAtBox(const Body& ball, const Body& box, double half) {
  const double radius = std::get<Sphere>(ball.shape).radius;
  return Height(box, ball.X_WB.p_WB) > 0 ? half : radius - half;
}

// The distance along the normal by which a contact must be moved to lie midway through
// its overlap. It is derived from the place where DARTCollide.cpp puts contacts, so that
// a contact that is off stays off by the same amount. [m]
double ShiftToMidway(const ContactQuery& query, const Vector3d& p, const Vector3d& n,
                     double depth) {
  const double half = depth / 2;
  const auto* const a = std::get_if<Sphere>(&query.A.shape);
  const auto* const b = std::get_if<Sphere>(&query.B.shape);
  if (a != nullptr && b != nullptr)  // At cA + (cB - cA) rA/(rA + rB).
    return depth * a->radius / (a->radius + b->radius) - half;
  if (a != nullptr) return ShiftOfSphereAtBox(query.A, query.B, half);
  if (b != nullptr) return -ShiftOfSphereAtBox(query.B, query.A, half);
  // For two boxes DART's point is midway if an edge meets an edge, otherwise on the
  // incident box. Take the place of {midway, on A, on B} that fits both surfaces best.
  // A's surface is half the depth further along n than midway, B's half the depth before
  // it.
  const std::array<double, 3> shifts = {0, -half, half};
  const auto misfit = [&](double shift) {
    const Vector3d midway = p + shift * n;
    return std::abs(Height(query.A, midway + half * n)) +
           std::abs(Height(query.B, midway - half * n));
  };
  return *std::ranges::min_element(shifts, {}, misfit);
}

Capability CapabilityOf(ShapeKind a, ShapeKind b) {
  const auto is_known = [](ShapeKind kind) {
    return kind == ShapeKind::kSphere || kind == ShapeKind::kBox;
  };
  Capability capability;
  if (!is_known(a) || !is_known(b)) {
    capability.reason =
        "DART's own detector handles spheres and boxes only; "
        "fcl makes polyhedra of spheres";
    return capability;
  }
  capability.supported = true;
  capability.family =
      a == ShapeKind::kBox && b == ShapeKind::kBox ? "box_box_sat" : "closed_form";
  capability.depth = true;
  capability.normal = true;
  capability.manifold = true;
  return capability;
}

}  // namespace

ContactAnswer AnswerByDart(const ContactQuery& query) {
  const auto detector = dart::collision::DARTCollisionDetector::create();
  const auto frame_A = FrameOf(query.A);
  const auto frame_B = FrameOf(query.B);
  const auto A = detector->createCollisionGroup(frame_A.get());
  const auto B = detector->createCollisionGroup(frame_B.get());
  const dart::collision::CollisionOption option(true, std::numeric_limits<int>::max());
  dart::collision::CollisionResult result;
  A->collide(B.get(), option, &result);

  ContactAnswer answer;
  answer.status = AnswerStatus::kAnswered;
  answer.touching = result.getNumContacts() > 0;
  for (const dart::collision::Contact& contact : result.getContacts()) {
    const Vector3d n_AB_W = -contact.normal;
    const double separation = -contact.penetrationDepth;
    const double shift =
        ShiftToMidway(query, contact.point, n_AB_W, contact.penetrationDepth);
    answer.points.push_back({contact.point + shift * n_AB_W, separation, n_AB_W});
    if (answer.points.size() == 1 || separation < *answer.separation) {
      answer.separation = separation;
      answer.n_AB_W = n_AB_W;
    }
  }
  for (ContactPoint& point : answer.points) {
    if (point.n_AB_W == answer.n_AB_W) point.n_AB_W.reset();
  }
  return answer;
}

void DescribeDartContacts(OracleInfo& info) {
  info.capabilities = CapabilityTable(CapabilityOf);
  const std::vector<Setting> settings = {
      {"entry point", "DARTCollisionDetector, two groups",
       "The default, fcl on meshes, makes polyhedra of spheres."},
      {"contacts", "any number", "All contacts that it finds."},
      {"normal", "B->A, negated", "Contact::normal points to the first object."},
      {"depth sign", "positive penetrating, negated", "Contact::penetrationDepth."},
      {"contact position", "moved along the normal to midway",
       "DART weights it by the radii between spheres, else puts it on a surface."},
      {"answer's normal and separation", "of the deepest contact",
       "Contacts of one pair may differ in both."},
      {"sizes", "doubled", "BoxShape takes full sizes."},
  };
  info.settings.insert(info.settings.end(), settings.begin(), settings.end());
}

}  // namespace touchstone
