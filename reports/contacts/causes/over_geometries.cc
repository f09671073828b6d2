#include "reports/contacts/causes/over_geometries.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "reports/contacts/causes/convention.h"
#include "reports/contacts/causes/margin.h"
#include "reports/contacts/causes/unexplained.h"
#include "reports/contacts/checks/excess.h"
#include "reports/measures/outside.h"
#include "reports/measures/stated.h"

namespace touchstone {
namespace {

/** The scenarios and oracles of a run, by name. */
class Index {
 public:
  Index(std::span<const ScenarioResult> results, std::span<const OracleInfo> oracles)
      : results_(results), oracles_(oracles) {
    for (std::size_t s = 0; s < results.size(); ++s)
      scenarios_[results[s].scenario.id] = s;
    for (std::size_t i = 0; i < oracles.size(); ++i) places_[oracles[i].name] = i;
  }

  const ScenarioResult& Result(const Finding& finding) const {
    return results_[scenarios_.at(finding.scenario)];
  }
  const OracleInfo& Oracle(const Finding& finding) const {
    return oracles_[places_.at(finding.oracle)];
  }
  const ContactAnswer& Answer(const Finding& finding) const {
    return Result(finding).answers[places_.at(finding.oracle)];
  }

 private:
  std::span<const ScenarioResult> results_;
  std::span<const OracleInfo> oracles_;
  std::map<std::string_view, std::size_t> scenarios_;
  std::map<std::string_view, std::size_t> places_;
};

/** Questions that an algorithm may treat alike: oracle, kinds of A and B, penetrating. */
using Alike = std::tuple<std::string_view, ShapeKind, ShapeKind, bool>;

Alike AlikeOf(const Index& index, const Finding& finding) {
  const ScenarioResult& result = index.Result(finding);
  const ContactQuery& query = result.scenario.contact;
  return {finding.oracle, KindOf(query.A.shape), KindOf(query.B.shape),
          result.truth.separation.hi < 0};
}

struct SizesInWords {
  std::string operator()(const Sphere& s) const { return fmt::format("{}", s.radius); }
  std::string operator()(const Box& s) const {
    return fmt::format("{} {} {}", s.half_extents.x(), s.half_extents.y(),
                       s.half_extents.z());
  }
  std::string operator()(const Capsule& s) const {
    return fmt::format("{} {}", s.radius, s.half_length);
  }
  std::string operator()(const Cylinder& s) const {
    return fmt::format("{} {}", s.radius, s.half_length);
  }
  std::string operator()(const Cone& s) const {
    return fmt::format("{} {}", s.radius, s.half_height);
  }
  std::string operator()(const ConvexHull& s) const {
    std::string words;
    for (const Eigen::Vector3d& v : s.vertices)
      words += fmt::format("{} {} {},", v.x(), v.y(), v.z());
    return words;
  }
  std::string operator()(const HalfSpace&) const { return ""; }
};

/** Returns a text that two questions share if their shapes have the same sizes. */
std::string SizesOf(const ContactQuery& query) {
  return fmt::format("{}; {}", std::visit(SizesInWords{}, query.A.shape),
                     std::visit(SizesInWords{}, query.B.shape));
}

/** Returns a text that two questions share if one is a moved copy of the other: the sizes
 and the separation, to the digits that moving leaves. */
std::string GeometryOf(const ScenarioResult& result) {
  return fmt::format("{}; {:.6g}", SizesOf(result.scenario.contact),
                     result.truth.separation.lo);
}

/** Returns whether the direction of a passing answer is as good as its opposite, so that
 no convention could be read from it. */
bool IsTie(const Index& index, const Finding& finding) {
  if (finding.measure != MeasureKind::kExcess) return false;
  const ScenarioResult& result = index.Result(finding);
  const auto n_AB_W = NormalOf(index.Answer(finding));
  return n_AB_W &&
         Excess(result.scenario.contact, result.truth, -*n_AB_W) <= finding.tolerance;
}

/** Returns the signed error of a separation, with the sizes if it failed: passes are
 most of the findings, and nobody reads theirs. */
std::optional<SignedError> ErrorOf(const Index& index, Finding& finding) {
  const ScenarioResult& result = index.Result(finding);
  const Enclosure& truth = result.truth.separation;
  const std::optional<double> separation = SeparationOf(index.Answer(finding));
  if (!separation) return std::nullopt;
  const double nearest = std::clamp(*separation, truth.lo, truth.hi);
  return SignedError{
      &finding, *separation - nearest, nearest,
      finding.verdict == Verdict::kPass ? "" : SizesOf(result.scenario.contact)};
}

}  // namespace

void ExplainByMargins(std::span<const ScenarioResult> results,
                      std::span<const OracleInfo> oracles, std::span<Finding> findings) {
  if (std::none_of(findings.begin(), findings.end(), IsUnexplained)) return;
  const Index index(results, oracles);
  struct Group {
    std::vector<SignedError> failures;
    std::vector<SignedError> passes;
  };
  std::map<Alike, Group> groups;
  for (Finding& finding : findings) {
    if (finding.measure != MeasureKind::kSeparationError) continue;
    const bool failed = IsUnexplained(finding);
    if (!failed && finding.verdict != Verdict::kPass) continue;
    const std::optional<SignedError> error = ErrorOf(index, finding);
    if (!error) continue;
    Group& group = groups[AlikeOf(index, finding)];
    (failed ? group.failures : group.passes).push_back(*error);
  }
  for (auto& [alike, group] : groups) ExplainByMargin(group.failures, group.passes);
}

void RefuseConventions(std::span<const ScenarioResult> results,
                       std::span<const OracleInfo> oracles, std::span<Finding> findings) {
  const auto is_convention = [](const Finding& finding) {
    return IsProvedWrong(finding) && finding.cause == Cause::kConvention &&
           !IsMargin(finding);
  };
  if (std::none_of(findings.begin(), findings.end(), is_convention)) return;
  const Index index(results, oracles);
  std::map<std::tuple<Alike, std::string>, std::set<std::string>> geometries;
  std::set<std::tuple<Alike, MeasureKind>> questioned;
  for (const Finding& finding : findings) {
    if (finding.reference != "referee" || !is_convention(finding)) continue;
    const Alike alike = AlikeOf(index, finding);
    geometries[{alike, finding.cause_because}].insert(GeometryOf(index.Result(finding)));
    questioned.emplace(alike, finding.measure);
  }
  std::map<std::tuple<Alike, MeasureKind>, std::string_view> contradictions;
  std::set<std::tuple<Alike, MeasureKind>> unexamined;
  for (const Finding& finding : findings) {
    if (finding.reference != "referee") continue;
    if (finding.cause == Cause::kNotExamined)
      unexamined.emplace(AlikeOf(index, finding), finding.measure);
    if (finding.verdict != Verdict::kPass) continue;
    const std::tuple key(AlikeOf(index, finding), finding.measure);
    if (!questioned.contains(key) || contradictions.contains(key)) continue;
    // Near touching, the conventions of separations cannot be told apart.
    if (Outside(0, index.Result(finding).truth.separation) >
            kClearOfZero * finding.tolerance &&
        !IsTie(index, finding))
      contradictions.emplace(key, finding.scenario);
  }
  for (Finding& finding : findings) {
    if (!is_convention(finding)) continue;
    const Alike alike = AlikeOf(index, finding);
    const auto contradiction = contradictions.find({alike, finding.measure});
    const bool is_contradicted = contradiction != contradictions.end();
    if (!is_contradicted && geometries[{alike, finding.cause_because}].size() > 1)
      continue;
    if (!is_contradicted && unexamined.contains({alike, finding.measure})) {
      finding.cause = Cause::kNotExamined;
      finding.cause_because.clear();
      continue;
    }
    finding.cause = Cause::kDefect;
    finding.cause_because = fmt::format(
        "right if {}, but {}", finding.cause_because,
        is_contradicted
            ? fmt::format("{} contradicts such a convention", contradiction->second)
            : "one geometry shows no convention");
  }
}

}  // namespace touchstone
