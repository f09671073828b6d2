
#include <cstddef>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include <fcl/config.h>
#include <fcl/narrowphase/collision.h>

#include "oracles/answer_each.h"
#include "oracles/fcl/fcl_contact_point.h"
#include "oracles/fcl/fcl_geometry.h"
#include "oracles/fcl/fcl_solver.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

// More than needed: two boxes yield at most four, a hull on a half-space one.
constexpr std::size_t kMaxContacts = 8;

// FCL's own default for CollisionRequest::gjk_tolerance.
constexpr double kTolerance = 1e-6;

fcl::CollisionRequestd MakeRequest(FclSolver solver) {
  fcl::CollisionRequestd request;
  request.num_max_contacts = kMaxContacts;
  request.enable_contact = true;
  request.gjk_solver_type =
      solver == FclSolver::kLibccd ? fcl::GST_LIBCCD : fcl::GST_INDEP;
  request.gjk_tolerance = kTolerance;
  return request;
}

void Collide(const fcl::CollisionRequestd& request, const FclPair& pair,
             fcl::CollisionResultd& result) {
  fcl::collide(pair.A.geometry.get(), pair.A.X_WB, pair.B.geometry.get(), pair.B.X_WB,
               request, result);
}

std::string FamilyOf(FclSolver solver, ShapeKind a, ShapeKind b) {
  const auto either = [&](ShapeKind kind) { return a == kind || b == kind; };
  if (either(ShapeKind::kHalfSpace)) return "closed_form";
  if (a == ShapeKind::kBox && b == ShapeKind::kBox) return "box_box_sat";
  if (either(ShapeKind::kSphere) && !either(ShapeKind::kCone) &&
      !either(ShapeKind::kConvexHull)) {
    return "closed_form";
  }
  return solver == FclSolver::kLibccd ? "mpr" : "gjk_epa";
}

Capability CapabilityOf(FclSolver solver, ShapeKind a, ShapeKind b) {
  Capability capability;
  if (a == ShapeKind::kHalfSpace && b == ShapeKind::kHalfSpace) {
    capability.reason = "two half-spaces are not a valid question";
    return capability;
  }
  capability.supported = true;
  capability.family = FamilyOf(solver, a, b);
  capability.depth = true;
  capability.normal = true;
  // All other algorithms return one point: the deepest, or that of MPR or EPA.
  capability.manifold = capability.family == "box_box_sat";
  if (capability.family == "mpr") {
    capability.documented_error = kTolerance;
    capability.documented_by = "CollisionRequest::gjk_tolerance, ccd_t::mpr_tolerance";
  } else if (capability.family == "gjk_epa") {
    capability.documented_error = kTolerance;
    capability.documented_by =
        "CollisionRequest::gjk_tolerance, epa_tolerance of GST_INDEP";
  }
  return capability;
}

OracleInfo MakeInfo(FclSolver solver) {
  const bool libccd = solver == FclSolver::kLibccd;
  OracleInfo info;
  info.name = libccd ? "fcl/collide" : "fcl/collide_indep";
  info.library = "FCL";
  info.version = FCL_VERSION;
  info.settings = {
      {"entry point", "fcl::collide on geometries and transforms",
       "Collision objects would only add bounding boxes for culling."},
      {"gjk_solver_type",
       libccd ? "GST_LIBCCD: MPR of the library libccd"
              : "GST_INDEP: FCL's own GJK and EPA, without libccd",
       "Used where FCL has no closed form."},
      {"gjk_tolerance", "1e-6", "FCL's default."},
      {"contacts", std::to_string(kMaxContacts),
       "FCL's default is one, without its position."},
      {"normal", "A->B, unchanged",
       "Contact::normal; the direction is measured, FCL does not document it."},
      {"depth sign", "positive penetrating, negated", "Contact::penetration_depth."},
      {"contact position", "moved midway for two spheres, else unchanged",
       "FCL weights it by the radii of two spheres. Other closed forms return the "
       "middle; MPR, EPA and sphere-capsule return points on no surface."},
      {"answer's normal and separation", "of the deepest contact",
       "Contacts of one pair may differ in both."},
      {"sizes", "doubled", "Box, Capsule, Cylinder and Cone take full lengths."},
      {"convex hull", "faces computed here",
       "Convex requires polygons; its GJK and MPR use vertices and edges."},
  };
  info.capabilities = CapabilityTable(
      [=](ShapeKind a, ShapeKind b) { return CapabilityOf(solver, a, b); });
  return info;
}

ContactAnswer Translate(const ContactQuery& query, const fcl::CollisionResultd& result) {
  ContactAnswer answer;
  answer.status = AnswerStatus::kAnswered;
  answer.touching = result.isCollision();
  for (std::size_t i = 0; i < result.numContacts(); ++i) {
    const fcl::Contactd& contact = result.getContact(i);
    const Vector3d n_AB_W = contact.normal;
    const double depth = contact.penetration_depth;
    answer.points.push_back(
        {MidwayPoint(query, {contact.pos, n_AB_W, depth}), -depth, n_AB_W});
    if (i == 0 || -depth < *answer.separation) {
      answer.separation = -depth;
      answer.n_AB_W = n_AB_W;
    }
  }
  for (ContactPoint& point : answer.points) {
    if (point.n_AB_W == answer.n_AB_W) point.n_AB_W.reset();
  }
  return answer;
}

class FclCollideBatch final : public PreparedBatch {
 public:
  FclCollideBatch(FclSolver solver, std::span<const ContactQuery> queries)
      : request_(MakeRequest(solver)), separations_(queries.size()) {
    for (const ContactQuery& query : queries) pairs_.push_back(ToFcl(query));
  }

  void Run() override {
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      result_.clear();
      Collide(request_, pairs_[i], result_);
      double separation = std::numeric_limits<double>::quiet_NaN();
      for (std::size_t k = 0; k < result_.numContacts(); ++k) {
        const double depth = result_.getContact(k).penetration_depth;
        if (k == 0 || -depth < separation) separation = -depth;
      }
      separations_[i] = separation;
    }
  }

  std::span<const double> separations() const override { return separations_; }

 private:
  fcl::CollisionRequestd request_;
  fcl::CollisionResultd result_;
  std::vector<FclPair> pairs_;
  std::vector<double> separations_;
};

class FclCollide final : public Oracle {
 public:
  explicit FclCollide(FclSolver solver)
      : solver_(solver), request_(MakeRequest(solver)), info_(MakeInfo(solver)) {}

  const OracleInfo& info() const override { return info_; }

  using Oracle::Answer;
  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> answers) const override {
    AnswerEach(info_, queries, answers,
               [this](const ContactQuery& query) { return AnswerOne(query); });
  }

  std::unique_ptr<PreparedBatch> Prepare(
      std::span<const ContactQuery> queries) const override {
    return std::make_unique<FclCollideBatch>(solver_, queries);
  }

 private:
  ContactAnswer AnswerOne(const ContactQuery& query) const {
    const FclPair pair = ToFcl(query);
    if (!pair) return UnsupportedAnswer("FCL requires convex hulls with volume");
    fcl::CollisionResultd result;
    Collide(request_, pair, result);
    return Translate(query, result);
  }

  FclSolver solver_;
  fcl::CollisionRequestd request_;
  OracleInfo info_;
};

}  // namespace

std::unique_ptr<Oracle> MakeFclCollide(FclSolver solver) {
  return std::make_unique<FclCollide>(solver);
}

}  // namespace touchstone
