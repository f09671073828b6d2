#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <fcl/config.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include "oracles/answer_each.h"
#include "oracles/fcl/fcl_geometry.h"
#include "oracles/fcl/fcl_solver.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

// Unsigned GJK converged to 1e-12 without an abort for 136666 pairs of boxes. When EPA
// follows GJK, and for GST_INDEP, that tolerance makes FCL abort: these keep FCL's
// default.
double ToleranceOf(FclSolver solver, FclDistanceKind kind) {
  return solver == FclSolver::kLibccd && kind == FclDistanceKind::kUnsigned ? 1e-12
                                                                            : 1e-6;
}

fcl::DistanceRequestd MakeRequest(FclSolver solver, FclDistanceKind kind) {
  fcl::DistanceRequestd request;
  request.enable_nearest_points = true;
  request.enable_signed_distance = kind == FclDistanceKind::kSigned;
  request.gjk_solver_type =
      solver == FclSolver::kLibccd ? fcl::GST_LIBCCD : fcl::GST_INDEP;
  request.distance_tolerance = ToleranceOf(solver, kind);
  return request;
}

void Distance(const fcl::DistanceRequestd& request, const FclPair& pair,
              fcl::DistanceResultd& result) {
  // The return value is not used: with GST_INDEP it is -1 on overlap.
  fcl::distance(pair.A.geometry.get(), pair.A.X_WB, pair.B.geometry.get(), pair.B.X_WB,
                request, result);
}

// Whether FCL computes the distance of the pair, but not its depth, in closed form.
bool HasClosedDistance(ShapeKind a, ShapeKind b) {
  const auto closed_with_sphere = [](ShapeKind kind) {
    return kind == ShapeKind::kSphere || kind == ShapeKind::kBox ||
           kind == ShapeKind::kCapsule || kind == ShapeKind::kCylinder;
  };
  if (a == ShapeKind::kSphere) return closed_with_sphere(b);
  if (b == ShapeKind::kSphere) return closed_with_sphere(a);
  return a == ShapeKind::kCapsule && b == ShapeKind::kCapsule;
}

Capability CapabilityOf(FclSolver solver, FclDistanceKind kind, ShapeKind a,
                        ShapeKind b) {
  Capability capability;
  if (a == ShapeKind::kHalfSpace && b == ShapeKind::kHalfSpace) {
    capability.reason = "two half-spaces are not a valid question";
    return capability;
  }
  const bool is_signed = kind == FclDistanceKind::kSigned;
  const bool libccd = solver == FclSolver::kLibccd;
  capability.supported = true;
  capability.depth = is_signed;
  capability.distance = true;
  capability.normal = is_signed && libccd;
  capability.witnesses = true;
  capability.penetrating_witnesses = is_signed && libccd;
  // GST_LIBCCD uses no closed forms for the signed distance.
  if (HasClosedDistance(a, b) && !(is_signed && libccd)) {
    capability.family = "closed_form";
    return capability;
  }
  capability.family = is_signed ? "gjk_epa" : "gjk";
  capability.documented_error = ToleranceOf(solver, kind);
  if (libccd) {
    capability.documented_by =
        "DistanceRequest::distance_tolerance; gjk_libccd-inl.h: the "
        "difference from the real distance is below it";
  } else {
    capability.documented_relative_error = ToleranceOf(solver, kind);
    capability.documented_by =
        "DistanceRequest::distance_tolerance; gjk-inl.h: the gap of "
        "the bounds is below it times the distance";
  }
  return capability;
}

std::string NameOf(FclSolver solver, FclDistanceKind kind) {
  const std::string name =
      kind == FclDistanceKind::kSigned ? "fcl/signed_distance" : "fcl/distance";
  return solver == FclSolver::kLibccd ? name : name + "_indep";
}

OracleInfo MakeInfo(FclSolver solver, FclDistanceKind kind) {
  const bool libccd = solver == FclSolver::kLibccd;
  const bool is_signed = kind == FclDistanceKind::kSigned;
  OracleInfo info;
  info.name = NameOf(solver, kind);
  info.library = "FCL";
  info.version = FCL_VERSION;
  info.settings = {
      {"entry point", "fcl::distance on geometries and transforms",
       "Collision objects would only add bounding boxes for culling."},
      {"gjk_solver_type",
       libccd ? "GST_LIBCCD: FCL's GJK and EPA on top of the library libccd"
              : "GST_INDEP: FCL's own GJK and EPA, without libccd",
       "Used where FCL has no closed form."},
      {"enable_signed_distance", is_signed ? "true" : "false",
       is_signed ? "The distance of overlapping shapes is minus their depth."
                 : "The distance of overlapping shapes is -1, reported as touching."},
      {"distance_tolerance", ToleranceOf(solver, kind) < 1e-6 ? "1e-12" : "1e-6",
       ToleranceOf(solver, kind) < 1e-6 ? "Fine, and FCL still converges without aborts."
                                        : "FCL's default."},
      {"distance", "DistanceResult::min_distance",
       "The return value of fcl::distance is -1 on overlap with GST_INDEP."},
      {"normal", libccd && is_signed ? "from the nearest points" : "left out",
       "FCL returns none; points closer than 2^-33 of the scene define none either."},
      {"witness points",
       libccd && is_signed ? "nearest points, unchanged"
                           : "nearest points, unchanged, if apart",
       "Unsigned distance does not set them on overlap; GST_INDEP then returns a contact "
       "position twice."},
      {"sizes", "doubled", "Box, Capsule, Cylinder and Cone take full lengths."},
      {"convex hull", "faces computed here",
       "Convex requires polygons; its GJK uses vertices and edges."},
  };
  info.capabilities = CapabilityTable(
      [=](ShapeKind a, ShapeKind b) { return CapabilityOf(solver, kind, a, b); });
  return info;
}

// The shortest distance of two points, as a fraction of the scene, that defines a
// direction to about 1e-6 rad: each point is off by a few roundings of its coordinates.
constexpr double kShortestDirection = 0x1p-33;

class FclDistanceBatch final : public PreparedBatch {
 public:
  FclDistanceBatch(const fcl::DistanceRequestd& request,
                   std::span<const ContactQuery> queries)
      : request_(request), separations_(queries.size()) {
    for (const ContactQuery& query : queries) pairs_.push_back(ToFcl(query));
  }

  void Run() override {
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      result_.clear();
      Distance(request_, pairs_[i], result_);
      const bool says_only_overlap =
          !request_.enable_signed_distance && result_.min_distance < 0;
      separations_[i] = says_only_overlap ? std::numeric_limits<double>::quiet_NaN()
                                          : result_.min_distance;
    }
  }

  std::span<const double> separations() const override { return separations_; }

 private:
  fcl::DistanceRequestd request_;
  fcl::DistanceResultd result_;
  std::vector<FclPair> pairs_;
  std::vector<double> separations_;
};

class FclDistance final : public Oracle {
 public:
  FclDistance(FclSolver solver, FclDistanceKind kind)
      : request_(MakeRequest(solver, kind)), info_(MakeInfo(solver, kind)) {
    // FCL builds its tables of functions in the first call. A child forked while another
    // thread builds them would wait for that thread for ever (isolated_oracle.h).
    const Body sphere{Sphere{1}, {}};
    const Body other{Sphere{1}, Pose::FromQuaternion({3, 0.1, 0.2}, {1, 0, 0, 0})};
    const FclPair pair = ToFcl(ContactQuery{sphere, other});
    fcl::DistanceResultd distance;
    Distance(request_, pair, distance);
    fcl::CollisionRequestd collision_request;
    collision_request.gjk_solver_type = request_.gjk_solver_type;
    fcl::CollisionResultd collision;
    fcl::collide(pair.A.geometry.get(), pair.A.X_WB, pair.B.geometry.get(), pair.B.X_WB,
                 collision_request, collision);
  }

  const OracleInfo& info() const override { return info_; }

  using Oracle::Answer;
  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> answers) const override {
    AnswerEach(info_, queries, answers,
               [this](const ContactQuery& query) { return AnswerOne(query); });
  }

  std::unique_ptr<PreparedBatch> Prepare(
      std::span<const ContactQuery> queries) const override {
    return std::make_unique<FclDistanceBatch>(request_, queries);
  }

 private:
  ContactAnswer AnswerOne(const ContactQuery& query) const {
    const FclPair pair = ToFcl(query);
    if (!pair) return UnsupportedAnswer("FCL requires convex hulls with volume");
    fcl::DistanceResultd result;
    Distance(request_, pair, result);
    return Translate(query, info_.For(KindOf(query.A.shape), KindOf(query.B.shape)),
                     result);
  }

  static ContactAnswer Translate(const ContactQuery& query, const Capability& capability,
                                 const fcl::DistanceResultd& result) {
    ContactAnswer answer;
    answer.status = AnswerStatus::kAnswered;
    const double separation = result.min_distance;
    answer.touching = separation <= 0;
    if (separation < 0 && !capability.depth) return answer;
    answer.separation = separation;
    // Only signed GST_LIBCCD returns points on the surfaces of overlapping shapes. It is
    // also the only one with normals.
    if (separation <= 0 && !capability.normal) return answer;
    const Vector3d& p_WCa = result.nearest_points[0];
    const Vector3d& p_WCb = result.nearest_points[1];
    answer.witnesses = WitnessPoints{p_WCa, p_WCb};
    const Vector3d outward_W = separation > 0 ? p_WCb - p_WCa : p_WCa - p_WCb;
    if (capability.normal && outward_W.norm() > kShortestDirection * SceneSize(query)) {
      answer.n_AB_W = outward_W.normalized();
    }
    return answer;
  }

  fcl::DistanceRequestd request_;
  OracleInfo info_;
};

}  // namespace

std::unique_ptr<Oracle> MakeFclDistance(FclSolver solver, FclDistanceKind kind) {
  return std::make_unique<FclDistance>(solver, kind);
}

}  // namespace touchstone
