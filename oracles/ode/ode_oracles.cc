#include "oracles/ode/ode_oracles.h"

#include <array>
#include <cstddef>
#include <limits>
#include <string>

#include <ode/ode.h>

#include "oracles/answer_each.h"
#include "oracles/isolation/isolated_oracle.h"
#include "oracles/no_answer.h"
#include "oracles/ode/ode_contact_point.h"
#include "oracles/ode/ode_geom.h"
#include "oracles/ode/ode_world.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

// The maximum number of points that ODE returns for a pair of boxes.
constexpr int kMaxContacts = 8;
using Contacts = std::array<dContactGeom, kMaxContacts>;

int Collide(const OdeGeom& a, const OdeGeom& b, Contacts& contacts) {
  if (!a || !b) return 0;
  return dCollide(a.get(), b.get(), kMaxContacts, contacts.data(), sizeof(dContactGeom));
}

// Initialises ODE, whose state is global. It is never closed, because oracles may be
// called until the process ends.
void Initialise() {
  static const int initialised = dInitODE2(0);
  (void)initialised;
}

std::string FamilyOf(ShapeKind a, ShapeKind b) {
  const auto either = [&](ShapeKind kind) { return a == kind || b == kind; };
  const auto both = [&](ShapeKind kind) { return a == kind && b == kind; };
  if (either(ShapeKind::kHalfSpace)) return "closed_form";
  if (either(ShapeKind::kConvexHull)) return "mpr";
  if (both(ShapeKind::kBox)) return "box_box_sat";
  if (either(ShapeKind::kCylinder)) {
    if (either(ShapeKind::kSphere)) return "closed_form";
    return either(ShapeKind::kBox) ? "cylinder_box_sat" : "mpr";
  }
  if (either(ShapeKind::kBox) && either(ShapeKind::kCapsule)) return "segment_box";
  return "closed_form";
}

Capability CapabilityOf(ShapeKind a, ShapeKind b) {
  Capability capability;
  if (a == ShapeKind::kCone || b == ShapeKind::kCone) {
    capability.reason = "ODE has no cone";
    return capability;
  }
  if (a == ShapeKind::kHalfSpace && b == ShapeKind::kHalfSpace) {
    capability.reason = "ODE does not collide planes";
    return capability;
  }
  capability.supported = true;
  capability.family = FamilyOf(a, b);
  capability.depth = true;
  capability.normal = true;
  // ODE passes on the one point that libccd returns.
  capability.manifold = capability.family != "mpr";
  if (capability.family == "mpr") {
    capability.documented_error = 1e-6;
    capability.documented_by =
        "ODE sets ccd_t::mpr_tolerance in ccdCollide(), "
        "ode/src/collision_libccd.cpp";
  }
  return capability;
}

OracleInfo MakeInfo() {
  OracleInfo info;
  info.name = "ode";
  info.library = "ODE";
  info.version = dODE_VERSION;
  info.settings = {
      {"build", dGetConfiguration(), "The result of dGetConfiguration()."},
      {"entry point", "dCollide, geoms created per question, no space",
       "Spaces would only add culling."},
      {"contacts", std::to_string(kMaxContacts), "The maximum for box on box."},
      {"normal", "B->A, negated", "dContactGeom::normal points into g1."},
      {"depth sign", "positive penetrating, negated", "dContactGeom::depth."},
      {"contact position", "moved along the normal to midway",
       "The distance follows from the pair and the depth: see the table in "
       "ode_contact_point.h."},
      {"contact position, sphere on box", "on the box, or the centre if that is inside",
       "It is moved by the distance from this place: one that is off stays off."},
      {"contact position, MPR pairs", "unchanged",
       "Somewhere in the overlap, on no surface."},
      {"answer's normal and separation", "of the deepest contact",
       "Contacts of one pair may differ in both."},
      {"sizes", "doubled", "dCreateBox, -Capsule and -Cylinder take full lengths."},
      {"half-space", "dCreatePlane(n, n·p)", "A plane geom has no pose."},
      {"convex hull", "faces computed here, origin moved inside if it is outside",
       "dCreateConvex takes planes and polygons; MPR starts from the origin."},
  };
  info.capabilities = CapabilityTable(CapabilityOf);
  DescribeOdeWorlds(OdeStepper::kStep, info);
  return info;
}

OracleInfo MakeQuickStepInfo() {
  OracleInfo info;
  info.name = "ode/quick";
  info.library = "ODE";
  info.version = dODE_VERSION;
  for (auto& row : info.capabilities) {
    for (Capability& capability : row)
      capability.reason =
          "QuickStep only steps worlds; the oracle \"ode\" answers contact queries";
  }
  DescribeOdeWorlds(OdeStepper::kQuickStep, info);
  return info;
}

ContactAnswer Translate(const ContactQuery& query, const Contacts& contacts, int count) {
  ContactAnswer answer;
  answer.status = AnswerStatus::kAnswered;
  answer.touching = count > 0;
  for (int i = 0; i < count; ++i) {
    const dContactGeom& contact = contacts[static_cast<std::size_t>(i)];
    const Vector3d n_AB_W = -Eigen::Map<const Vector3d>(contact.normal);
    const Vector3d p_W = Eigen::Map<const Vector3d>(contact.pos);
    answer.points.push_back(
        {MidwayPoint(query, {p_W, n_AB_W, contact.depth}), -contact.depth, n_AB_W});
    if (i == 0 || -contact.depth < *answer.separation) {
      answer.separation = -contact.depth;
      answer.n_AB_W = n_AB_W;
    }
  }
  for (ContactPoint& point : answer.points) {
    if (point.n_AB_W == answer.n_AB_W) point.n_AB_W.reset();
  }
  return answer;
}

class OdeBatch final : public PreparedBatch {
 public:
  explicit OdeBatch(std::span<const ContactQuery> queries)
      : separations_(queries.size()) {
    for (const ContactQuery& query : queries) {
      pairs_.push_back({OdeGeom(query.A), OdeGeom(query.B)});
    }
  }

  void Run() override {
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      Contacts contacts;
      const int count = Collide(pairs_[i].a, pairs_[i].b, contacts);
      double separation = std::numeric_limits<double>::quiet_NaN();
      for (int k = 0; k < count; ++k) {
        const double depth = contacts[static_cast<std::size_t>(k)].depth;
        if (k == 0 || -depth < separation) separation = -depth;
      }
      separations_[i] = separation;
    }
  }

  std::span<const double> separations() const override { return separations_; }

 private:
  struct Pair {
    OdeGeom a;
    OdeGeom b;
  };
  std::vector<Pair> pairs_;
  std::vector<double> separations_;
};

class OdeOracle final : public Oracle {
 public:
  OdeOracle() : info_((Initialise(), MakeInfo())) {}

  const OracleInfo& info() const override { return info_; }

  using Oracle::Answer;
  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> answers) const override {
    AnswerEach(info_, queries, answers, AnswerOne);
  }

  std::unique_ptr<PreparedBatch> Prepare(
      std::span<const ContactQuery> queries) const override {
    return std::make_unique<OdeBatch>(queries);
  }

  std::string CannotSimulate(const World& world) const override {
    const std::string reason = Oracle::CannotSimulate(world);
    return reason.empty() ? WhyNoOdeWorld(world) : reason;
  }

  std::unique_ptr<Simulation> BeginWith(const World& world,
                                        std::span<const double> values) const override {
    return OdeWorld(world, OdeStepper::kStep, values);
  }

 private:
  static ContactAnswer AnswerOne(const ContactQuery& query) {
    const OdeGeom a(query.A);
    const OdeGeom b(query.B);
    if (!a || !b) return UnsupportedAnswer(kNoFlatHull);
    Contacts contacts;
    const int count = Collide(a, b, contacts);
    return Translate(query, contacts, count);
  }

  OracleInfo info_;
};

class QuickStepOracle final : public Oracle {
 public:
  QuickStepOracle() : info_((Initialise(), MakeQuickStepInfo())) {}

  const OracleInfo& info() const override { return info_; }

  using Oracle::Answer;
  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> answers) const override {
    for (std::size_t i = 0; i < queries.size(); ++i)
      answers[i] = UnsupportedAnswer(info_.capabilities[0][0].reason);
  }

  std::string CannotSimulate(const World& world) const override {
    const std::string reason = Oracle::CannotSimulate(world);
    return reason.empty() ? WhyNoOdeWorld(world) : reason;
  }

  std::unique_ptr<Simulation> BeginWith(const World& world,
                                        std::span<const double> values) const override {
    return OdeWorld(world, OdeStepper::kQuickStep, values);
  }

 private:
  OracleInfo info_;
};

}  // namespace

std::vector<std::unique_ptr<Oracle>> OdeOracles() {
  std::vector<std::unique_ptr<Oracle>> oracles;
  oracles.push_back(std::make_unique<OdeOracle>());
  oracles.push_back(std::make_unique<QuickStepOracle>());
  // ODE aborts on a diverging world, and its direct solver takes minutes for a pile.
  for (std::unique_ptr<Oracle>& oracle : oracles)
    oracle = Isolate(std::move(oracle), {}, IsolationScope::kWorlds);
  return oracles;
}

}  // namespace touchstone
