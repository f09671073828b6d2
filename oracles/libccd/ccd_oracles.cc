#include "oracles/libccd/ccd_oracles.h"

#include <chrono>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <ccd/ccd.h>

#include "oracles/answer_each.h"
#include "oracles/isolation/isolated_oracle.h"
#include "oracles/libccd/ccd_body.h"
#include "oracles/no_answer.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

enum class Algorithm { kEpa, kMpr };

constexpr double kTolerance = 1e-6;
constexpr unsigned long kMaxIterations = 500;
// The limit of support points per query. EPA searches all faces for each new one, so its
// time grows with the square of this: about 2 s. Queries of the catalogue that end by
// themselves need at most 6,000. A count instead of a time lets a slow machine draw the
// same line.
constexpr unsigned long kMostSupportPoints = 20'000;

Vector3d FromCcd(const ccd_vec3_t& v) {
  return {ccdVec3X(&v), ccdVec3Y(&v), ccdVec3Z(&v)};
}

// The object that libccd passes to the callbacks of a body.
struct Asked {
  const Body& body;
  unsigned long& support_points;  // Number of support points computed, for both bodies.
};

void Support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const Asked& asked = *static_cast<const Asked*>(object);
  // Beyond the limit both bodies return the same point. The difference is the origin,
  // which is not outside any face: this ends EPA.
  if (++asked.support_points > kMostSupportPoints) return ccdVec3Set(point, 0, 0, 0);
  const Vector3d p = CcdSupport(asked.body, FromCcd(*direction));
  ccdVec3Set(point, p.x(), p.y(), p.z());
}

void Centre(const void* object, ccd_vec3_t* point) {
  const Vector3d p = CcdCentre(static_cast<const Asked*>(object)->body);
  ccdVec3Set(point, p.x(), p.y(), p.z());
}

ccd_t MakeCcd() {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = Support;
  ccd.support2 = Support;
  ccd.center1 = Centre;
  ccd.center2 = Centre;
  ccd.max_iterations = kMaxIterations;
  ccd.epa_tolerance = kTolerance;
  ccd.mpr_tolerance = kTolerance;
  return ccd;
}

struct Penetration {
  int status;  // 0: touching, −1: apart, −2: out of memory.
  unsigned long support_points;
  double depth;
  Vector3d n_AB_W;
  Vector3d p_W;

  bool gave_up() const { return support_points > kMostSupportPoints; }
};

Penetration Penetrate(Algorithm algorithm, const ccd_t& ccd, const ContactQuery& query) {
  ccd_real_t depth = 0;
  ccd_vec3_t direction{};
  ccd_vec3_t position{};
  const auto penetrate =
      algorithm == Algorithm::kEpa ? ccdGJKPenetration : ccdMPRPenetration;
  unsigned long support_points = 0;
  const Asked A{query.A, support_points};
  const Asked B{query.B, support_points};
  const int status = penetrate(&A, &B, &ccd, &depth, &direction, &position);
  return {status, support_points, depth, FromCcd(direction), FromCcd(position)};
}

Capability CapabilityOf(Algorithm algorithm, ShapeKind a, ShapeKind b) {
  Capability capability;
  if (a == ShapeKind::kHalfSpace || b == ShapeKind::kHalfSpace) {
    capability.reason = "libccd takes bounded shapes only";
    return capability;
  }
  const bool epa = algorithm == Algorithm::kEpa;
  capability.supported = true;
  capability.family = epa ? "gjk_epa" : "mpr";
  capability.depth = true;
  capability.normal = true;
  capability.documented_error = kTolerance;
  capability.documented_by =
      epa ? "ccd_t::epa_tolerance, ccd/ccd.h" : "ccd_t::mpr_tolerance, ccd/ccd.h";
  return capability;
}

OracleInfo MakeInfo(Algorithm algorithm) {
  const bool epa = algorithm == Algorithm::kEpa;
  OracleInfo info;
  info.name = epa ? "libccd/epa" : "libccd/mpr";
  info.library = "libccd";
  info.version = TOUCHSTONE_CCD_VERSION;
  info.settings = {
      {"entry point", epa ? "ccdGJKPenetration" : "ccdMPRPenetration",
       "The calls that return a depth."},
      {epa ? "epa_tolerance" : "mpr_tolerance", "1e-6",
       "The value that ODE and FCL set; libccd's default is 1e-4."},
      {"max_iterations", std::to_string(kMaxIterations),
       "The default is 2^64 - 1. EPA ignores it."},
      {"most support points", std::to_string(kMostSupportPoints),
       "About 2 s of EPA; a count draws the same line on every machine."},
      {"support functions", "our own, after libccd's README",
       "libccd has none; a zero component of the direction selects the middle."},
      {"centres", "body origins; for a hull the mean of its vertices",
       "MPR starts from a point inside each body."},
      {"normal", "A->B, unchanged",
       "The direction in which B must be moved; may be NaN."},
      {"depth sign", "positive penetrating, negated", "ccd/ccd.h."},
      {"contact position", "unchanged", "Somewhere in the overlap, on no surface."},
      {"version", "from its pkg-config file",
       "The library states none; Debian calls it 2.1."},
  };
  info.capabilities = CapabilityTable(
      [=](ShapeKind a, ShapeKind b) { return CapabilityOf(algorithm, a, b); });
  return info;
}

ContactAnswer Translate(const Penetration& penetration) {
  if (penetration.status == -2) return CrashedAnswer("libccd ran out of memory");
  if (penetration.gave_up()) {
    return TimedOutAnswer("gave up at support point " +
                          std::to_string(kMostSupportPoints));
  }
  ContactAnswer answer;
  answer.status = AnswerStatus::kAnswered;
  answer.touching = penetration.status == 0;
  if (!answer.touching) return answer;
  answer.separation = -penetration.depth;
  answer.n_AB_W = penetration.n_AB_W;
  answer.points.push_back({penetration.p_W, -penetration.depth, std::nullopt});
  return answer;
}

class CcdBatch final : public PreparedBatch {
 public:
  CcdBatch(Algorithm algorithm, std::span<const ContactQuery> queries)
      : algorithm_(algorithm),
        queries_(queries.begin(), queries.end()),
        separations_(queries.size()) {}

  void Run() override {
    for (std::size_t i = 0; i < queries_.size(); ++i) {
      const Penetration penetration = Penetrate(algorithm_, ccd_, queries_[i]);
      separations_[i] = penetration.status == 0 && !penetration.gave_up()
                            ? -penetration.depth
                            : std::numeric_limits<double>::quiet_NaN();
    }
  }

  std::span<const double> separations() const override { return separations_; }

 private:
  Algorithm algorithm_;
  ccd_t ccd_ = MakeCcd();
  std::vector<ContactQuery> queries_;
  std::vector<double> separations_;
};

class CcdOracle final : public Oracle {
 public:
  explicit CcdOracle(Algorithm algorithm)
      : algorithm_(algorithm), info_(MakeInfo(algorithm)) {}

  const OracleInfo& info() const override { return info_; }

  using Oracle::Answer;
  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> answers) const override {
    const ccd_t ccd = MakeCcd();
    AnswerEach(info_, queries, answers, [&](const ContactQuery& query) {
      return Translate(Penetrate(algorithm_, ccd, query));
    });
  }

  std::unique_ptr<PreparedBatch> Prepare(
      std::span<const ContactQuery> queries) const override {
    return std::make_unique<CcdBatch>(algorithm_, queries);
  }

 private:
  Algorithm algorithm_;
  OracleInfo info_;
};

}  // namespace

std::vector<std::unique_ptr<Oracle>> CcdOracles() {
  std::vector<std::unique_ptr<Oracle>> oracles;
  IsolationLimits limits;
  // The count of support points stops EPA long before.
  limits.cpu = std::chrono::minutes(1);
  limits.wall = std::chrono::hours(1);
  oracles.push_back(Isolate(std::make_unique<CcdOracle>(Algorithm::kEpa), limits));
  oracles.push_back(std::make_unique<CcdOracle>(Algorithm::kMpr));
  return oracles;
}

}  // namespace touchstone
