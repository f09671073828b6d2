#include "oracles/cookbook/printed_oracle.h"

#include <optional>
#include <string>
#include <utility>

#include "engine/printed/collide.h"
#include "oracles/cookbook/printed_simulation.h"
#include "oracles/cookbook/translate.h"
#include "oracles/stopwatch.h"

namespace touchstone {
namespace {

namespace printed = cookbook::printed;

ContactAnswer ToAnswer(const printed::Manifold& manifold) {
  ContactAnswer answer;
  answer.status = AnswerStatus::kAnswered;
  answer.touching = manifold.touching;
  if (!manifold.touching) return answer;
  answer.n_AB_W = manifold.n_AB_W;
  answer.separation = -manifold.depth;
  for (const Eigen::Vector3d& p_WC : manifold.contacts_W) {
    answer.points.push_back({p_WC, -manifold.depth, std::nullopt});
  }
  return answer;
}

class PrintedOracle final : public Oracle {
 public:
  PrintedOracle(std::string name, printed::Errata errata) : errata_(errata) {
    info_.name = std::move(name);
    info_.library = "Touchstone";
    info_.version = "0.1.0";
    info_.capabilities = SphereAndBoxCapabilities();
    for (auto& row : info_.capabilities) {
      for (Capability& capability : row) capability.distance = false;
    }
    SetPrintedWorldCapabilities(info_);
    for (const auto& list : {printed::kContactErrata, printed::kMotionErrata}) {
      for (const printed::Erratum erratum : list) {
        if (!errata.Has(erratum)) continue;
        info_.settings.push_back({NameOf(erratum), std::string(FaultOf(erratum)),
                                  "an erratum of the published recipes"});
      }
    }
    if (info_.settings.empty()) {
      info_.settings.push_back(
          {"errata", "none", "the published recipes with every erratum corrected"});
    }
    info_.settings.push_back({"separation of a contact", "minus the depth",
                              "the recipes compute one depth for all contacts"});
  }

  const OracleInfo& info() const override { return info_; }

  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> answers) const override {
    for (std::size_t k = 0; k < queries.size(); ++k) {
      const Stopwatch watch;
      answers[k] = AnswerOne(queries[k]);
      answers[k].seconds = watch.seconds();
    }
  }

  std::unique_ptr<Simulation> Begin(const World& world) const override {
    return BeginPrinted(world, errata_);
  }

 private:
  ContactAnswer AnswerOne(const ContactQuery& query) const {
    return VisitKnown(
        query,
        [&](const auto& a, const auto& b) {
          return ToAnswer(printed::Collide(ToCookbook(a), ToCookbook(query.A.X_WB),
                                           ToCookbook(b), ToCookbook(query.B.X_WB),
                                           errata_));
        },
        NoRecipe);
  }

  OracleInfo info_;
  printed::Errata errata_;
};

/** Returns the errata named by `list`, which is "none" or names joined by "+"; nothing if
 a name is unknown. */
std::optional<printed::Errata> ErrataNamed(std::string_view list) {
  if (list == "none") return printed::Errata::None();
  printed::Errata errata;
  for (;;) {
    const std::size_t plus = list.find('+');
    const std::optional<printed::Erratum> erratum =
        printed::ErratumNamed(list.substr(0, plus));
    if (!erratum) return std::nullopt;
    errata.Add(*erratum);
    if (plus == std::string_view::npos) return errata;
    list.remove_prefix(plus + 1);
  }
}

}  // namespace

std::unique_ptr<Oracle> MakePrintedOracle(std::string_view name) {
  constexpr std::string_view kName = "printed";
  if (!name.starts_with(kName)) return nullptr;
  const std::string_view rest = name.substr(kName.size());
  std::optional<printed::Errata> errata;
  if (rest.empty()) {
    errata = printed::Errata::All();
  } else if (rest.starts_with(':')) {
    errata = ErrataNamed(rest.substr(1));
  }
  if (!errata) return nullptr;
  return std::make_unique<PrintedOracle>(std::string(name), *errata);
}

std::vector<std::string> PrintedOracleNames() {
  std::vector<std::string> names = {"printed", "printed:none"};
  for (const auto& list : {printed::kContactErrata, printed::kMotionErrata}) {
    for (const printed::Erratum erratum : list)
      names.push_back("printed:" + NameOf(erratum));
  }
  return names;
}

}  // namespace touchstone
