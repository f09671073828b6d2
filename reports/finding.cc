#include "reports/finding.h"

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
    {"penetration", "m"},
    {"rest_motion", "m"},
    {"restitution", ""},
    {"friction", ""},
    {"cone_violation", "N s"},
    {"joint_error", "m"},
    {"force_error", "N"},
    {"observed_order", ""},
    {"limit_error", "m"},
    {"determinism", ""},
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

std::string_view UnitOf(MeasureKind measure) {
  return NamesOf(measure).unit;
}

std::string_view NameOf(Verdict verdict) {
  constexpr std::array<std::string_view, 9> kNames = {
      "pass",        "fail",    "disagree",  "known",  "undecidable",
      "unsupported", "crashed", "timed out", "invalid"};
  return kNames[static_cast<std::size_t>(verdict)];
}

std::string_view NameOf(Cause cause) {
  constexpr std::array<std::string_view, 7> kNames = {
      "", "convention", "tie", "precision", "discretisation", "model", "defect"};
  return kNames[static_cast<std::size_t>(cause)];
}

}  // namespace touchstone
