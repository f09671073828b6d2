#include "scenarios/measure_kind.h"

#include <array>

namespace touchstone {
namespace {

struct MeasureNames {
  std::string_view name;
  std::string_view unit;
};

// In the order of MeasureKind.
constexpr std::array<MeasureNames, kMeasureKinds> kMeasures = {{
    {"touching", ""},
    {"separation_error", "m"},
    {"consistency_error", "m"},
    {"excess", "m"},
    {"duality_gap", "m"},
    {"contact_surface_error", "m"},
    {"contact_off_patch", "m"},
    {"patch_coverage", ""},
    {"contact_count", ""},
    {"contact_too_deep", "m"},
    {"contact_separation_error", "m"},
    {"witness_error", "m"},
    {"mixed_normals", "rad"},
    {"swap", "m"},
    {"rigid_motion", "m"},
    {"scaling", "m"},
    {"relabelling", "m"},
    {"perturbation", "m"},
    {"answering", ""},
    {"position_error", "m"},
    {"orientation_error", "rad"},
    {"velocity_error", "m/s"},
    {"spin_error", "rad/s"},
    {"momentum_drift", "N s"},
    {"angular_momentum_drift", "N m s"},
    {"energy_drift", "J"},
    {"momentum_balance", "N s"},
    {"angular_momentum_balance", "N m s"},
    {"travel_error", "m"},
    {"turn_error", "rad"},
    {"contact_place", "m"},
    {"penetration", "m"},
    {"passage", "m"},
    {"rest_motion", "m"},
    {"restitution", ""},
    {"friction", ""},
    {"cone_violation", "N s"},
    {"joint_error", "m"},
    {"force_error", "N"},
    {"event_time", "s"},
    {"observed_order", ""},
    {"limit_error", "m"},
    {"determinism", ""},
    {"stability", "m"},
    {"heading", "m"},
    {"translation", "m"},
    {"mirror", "m"},
    {"permutation", "m"},
    {"mass_scaling", "m"},
}};
static_assert(!kMeasures.back().name.empty());

const MeasureNames& NamesOf(MeasureKind measure) {
  return kMeasures[static_cast<std::size_t>(measure)];
}

}  // namespace

std::string_view NameOf(MeasureKind measure) {
  return NamesOf(measure).name;
}

bool CountsContacts(MeasureKind measure) {
  return measure == MeasureKind::kContactCount || measure == MeasureKind::kPatchCoverage;
}

std::string_view UnitOf(MeasureKind measure) {
  return NamesOf(measure).unit;
}

std::optional<MeasureKind> MeasureNamed(std::string_view name) {
  for (const MeasureKind measure : AllMeasures()) {
    if (NameOf(measure) == name) return measure;
  }
  return std::nullopt;
}

std::vector<MeasureKind> AllMeasures() {
  std::vector<MeasureKind> measures;
  measures.reserve(kMeasureKinds);
  for (int i = 0; i < kMeasureKinds; ++i) {
    measures.push_back(static_cast<MeasureKind>(i));
  }
  return measures;
}

}  // namespace touchstone
