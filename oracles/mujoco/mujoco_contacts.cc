#include "oracles/mujoco/mujoco_contacts.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "oracles/answer_each.h"
#include "oracles/mujoco/mujoco_model.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;
using enum ShapeKind;

// A model of two geoms, for A and B. Their types and sizes are set for each question.
constexpr const char* kTwoGeoms =
    R"(<mujoco><worldbody><geom type="sphere" size="1"/>)"
    R"(<geom type="sphere" size="1"/></worldbody></mujoco>)";

/** A shape in MuJoCo's terms. */
struct Geom {
  int type;
  Vector3d size;
};

std::optional<Geom> ToMujoco(const Shape& shape) {
  if (const auto* sphere = std::get_if<Sphere>(&shape))
    return Geom{mjGEOM_SPHERE, {sphere->radius, 0, 0}};
  if (const auto* box = std::get_if<Box>(&shape))
    return Geom{mjGEOM_BOX, box->half_extents};
  if (const auto* capsule = std::get_if<Capsule>(&shape))
    return Geom{mjGEOM_CAPSULE, {capsule->radius, capsule->half_length, 0}};
  if (const auto* cylinder = std::get_if<Cylinder>(&shape))
    return Geom{mjGEOM_CYLINDER, {cylinder->radius, cylinder->half_length, 0}};
  if (std::holds_alternative<HalfSpace>(shape)) return Geom{mjGEOM_PLANE, {0, 0, 1}};
  return std::nullopt;
}

/** Two geoms that are resized and moved for each question. */
class Pair {
 public:
  Pair() : model_(mj_copyModel(nullptr, &Prototype())), data_(mj_makeData(&*model_)) {}

  ContactAnswer Ask(const ContactQuery& query) {
    int first = Place(query.A, 0);
    int second = Place(query.B, 1);
    const bool swapped = first > second;
    if (swapped) std::swap(first, second);
    std::array<mjContact, mjMAXCONPAIR> contacts;
    const int count = mjCOLLISIONFUNC[first][second](
        model_.get(), data_.get(), contacts.data(), swapped ? 1 : 0, swapped ? 0 : 1, 0);
    ContactAnswer answer;
    answer.status = AnswerStatus::kAnswered;
    answer.touching = count > 0;
    for (int i = 0; i < count; ++i) {
      const mjContact& contact = contacts[static_cast<std::size_t>(i)];
      const Vector3d n_W = Vector3d::Map(contact.frame);
      const Vector3d n_AB_W = swapped ? Vector3d(-n_W) : n_W;
      answer.points.push_back({Vector3d::Map(contact.pos), contact.dist, n_AB_W});
      if (i == 0 || contact.dist < *answer.separation) {
        answer.separation = contact.dist;
        answer.n_AB_W = n_AB_W;
      }
    }
    for (ContactPoint& point : answer.points) {
      if (point.n_AB_W == answer.n_AB_W) point.n_AB_W.reset();
    }
    return answer;
  }

 private:
  static const mjModel& Prototype() {
    static const MujocoModel model = Compile(kTwoGeoms);
    return *model;
  }

  /** Sets type, size and pose of the geom `index`. Returns its type. */
  int Place(const Body& body, std::ptrdiff_t index) {
    const Geom geom = *ToMujoco(body.shape);
    model_->geom_type[index] = geom.type;
    Vector3d::Map(model_->geom_size + 3 * index) = geom.size;
    Vector3d::Map(data_->geom_xpos + 3 * index) = body.X_WB.p_WB;
    Eigen::Matrix3d::Map(data_->geom_xmat + 9 * index) =
        body.X_WB.R_WB.transpose();  // MuJoCo stores matrices row by row.
    return geom.type;
  }

  MujocoModel model_;
  MujocoData data_;
};

std::string FamilyOf(ShapeKind a, ShapeKind b) {
  const auto either = [&](ShapeKind kind) { return a == kind || b == kind; };
  if (either(kHalfSpace)) return "closed_form";
  if (either(kCylinder)) return "mpr";
  if (either(kSphere)) return "closed_form";
  if (a == kBox && b == kBox) return "mujoco_box_box";
  return either(kBox) ? "mujoco_box_capsule" : "closed_form";
}

}  // namespace

Capability MujocoCapability(ShapeKind a, ShapeKind b) {
  Capability capability;
  const auto either = [&](ShapeKind kind) { return a == kind || b == kind; };
  if (either(kCone)) {
    capability.reason = "MuJoCo has no cone";
  } else if (either(kConvexHull)) {
    capability.reason =
        "MuJoCo stores vertices in single precision and moves them: a different hull";
  } else if (a == kHalfSpace && b == kHalfSpace) {
    capability.reason = "MuJoCo does not collide planes";
  }
  if (!capability.reason.empty()) return capability;
  capability.supported = true;
  capability.family = FamilyOf(a, b);
  capability.depth = true;
  capability.normal = true;
  // libccd returns one point.
  capability.manifold = capability.family != "mpr";
  if (capability.family == "mpr") {
    capability.documented_error = 1e-6;
    capability.documented_by = "mjOption::mpr_tolerance, mujoco/mjmodel.h";
  }
  return capability;
}

void AnswerByMujoco(const OracleInfo& info, std::span<const ContactQuery> queries,
                    std::span<ContactAnswer> answers) {
  // Kept for later batches: clearing the memory of mjData takes as long as a hundred
  // questions.
  static thread_local Pair pair;
  AnswerEach(info, queries, answers,
             [](const ContactQuery& query) { return pair.Ask(query); });
}

void DescribeMujocoContacts(OracleInfo& info) {
  info.capabilities = CapabilityTable(MujocoCapability);
  const std::vector<Setting> settings = {
      {"entry point", "mjCOLLISIONFUNC", "mj_collision() calls it for a pair."},
      {"margin", "0", "Only touching geoms have contacts."},
      {"contacts", std::to_string(mjMAXCONPAIR), "mjMAXCONPAIR."},
      {"normal", "first axis of mjContact::frame",
       "It points away from the geom of the lesser type: negated if that is B."},
      {"depth sign", "negative penetrating", "mjContact::dist, unchanged."},
      {"contact position", "midway", "mjContact::pos, unchanged."},
      {"answer's normal and separation", "of the deepest contact",
       "Contacts of one pair may differ in both."},
      {"half-space", "plane", "Its normal is the z axis of its geom."},
  };
  info.settings.insert(info.settings.end(), settings.begin(), settings.end());
}

}  // namespace touchstone
