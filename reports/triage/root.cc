#include "reports/triage/root.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <iterator>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/clusters/measure_words.h"
#include "reports/finding/ending.h"
#include "reports/triage/kept_question.h"

namespace touchstone {
namespace {

constexpr const char* kDiffersInAnotherFrame = "answers differently in another frame";

/** The failure of an algorithm that IsOneFunction(), whatever goes wrong in it. */
constexpr const char* kIsWrong = "is wrong";

/** Returns what the oracle does wrong, in the words of a user. Measures that one fault of
 an algorithm shows by turns have the same. */
std::string FailureOf(const Specimen& specimen) {
  const Finding& finding = specimen.finding;
  if (std::holds_alternative<WorldScenario>(specimen.question)) {
    return fmt::format("{}{}", FaultInWords(finding.measure),
                       finding.law.empty() ? "" : fmt::format(" ({})", finding.law));
  }
  const bool touching =
      specimen.report.scenarios.front().truth.touching != Touching::kApart;
  switch (finding.measure) {
    case MeasureKind::kTouching:
      return touching ? "misses a contact" : "reports a contact where there is none";
    case MeasureKind::kConsistencyError:
      if (finding.evidence && finding.evidence->kind == ProofKind::kDeepest)
        return "gives wrong contact points";
      if (IsOfANormal(specimen.report, finding)) return "gives a wrong normal";
      [[fallthrough]];
    case MeasureKind::kSeparationError:
    case MeasureKind::kContactTooDeep:
    case MeasureKind::kContactSeparationError:
      return touching ? "states a wrong depth" : "states a wrong distance";
    case MeasureKind::kExcess:
    case MeasureKind::kMixedNormals:
      return "gives a wrong normal";
    case MeasureKind::kContactSurfaceError:
    case MeasureKind::kContactOffPatch:
    case MeasureKind::kPatchCoverage:
    case MeasureKind::kContactCount:
      // Bodies that are apart have no contacts: their nearest points are judged.
      return touching ? "gives wrong contact points" : "gives wrong nearest points";
    case MeasureKind::kDualityGap:
    case MeasureKind::kWitnessError:
      return "gives wrong nearest points";
    case MeasureKind::kSwap:
    case MeasureKind::kRigidMotion:
    case MeasureKind::kScaling:
    case MeasureKind::kRelabelling:
    case MeasureKind::kPerturbation:
      return kDiffersInAnotherFrame;
    default:
      return std::string(FaultInWords(finding.measure));
  }
}

/** Returns whether an algorithm is one function: a closed form of two shapes, or one that
 the oracle has for no other pair, such as boxes by their separating axes. */
bool IsOneFunction(const std::string& algorithm, const OracleInfo& oracle) {
  if (algorithm.empty()) return false;
  if (algorithm == "closed_form") return true;
  int pairs = 0;
  for (int a = 0; a < kShapeKinds; ++a) {
    for (int b = a; b < kShapeKinds; ++b) {
      const auto A = static_cast<ShapeKind>(a);
      const auto B = static_cast<ShapeKind>(b);
      const auto has = [&](const Capability& capability) {
        return capability.supported && capability.family == algorithm;
      };
      if (has(oracle.For(A, B)) || has(oracle.For(B, A))) ++pairs;
    }
  }
  return pairs == 1;
}

/** Returns whether the code that fails is likely to be of the shapes alone. */
bool IsOfItsShapes(const Specimen& specimen, const RootKey& key) {
  return IsOneFunction(key.algorithm, specimen.oracle->info()) ||
         key.place.starts_with("killed by ") ||
         std::holds_alternative<WorldScenario>(specimen.question);
}

/** Returns the kinds of the bodies, each once and sorted; both of a contact question. */
std::string ShapesOf(const Question& question) {
  if (const auto* const scenario = std::get_if<Scenario>(&question)) {
    const auto& [A, B] = scenario->contact;
    return PairName(KindOf(A.shape), KindOf(B.shape));
  }
  std::set<std::string_view> names;
  for (const Body* const body : BodiesOf(question))
    names.insert(NameOf(KindOf(body->shape)));
  return fmt::format("{}", fmt::join(names, " and "));
}

std::string AlgorithmOf(const Specimen& specimen) {
  const auto* const scenario = std::get_if<Scenario>(&specimen.question);
  if (scenario == nullptr) return "";
  const auto& [A, B] = scenario->contact;
  return specimen.oracle->info().For(KindOf(A.shape), KindOf(B.shape)).family;
}

/** Adds the words of `more` that are not there yet. */
void AddFailures(const std::vector<std::string>& more, std::vector<std::string>& to) {
  for (const std::string& failure : more) {
    if (std::ranges::find(to, failure) == to.end()) to.push_back(failure);
  }
}

/** Returns all that goes wrong in a specimen's symptoms, first what it shows itself. */
std::vector<std::string> FailuresOf(const Specimen& specimen) {
  std::vector<std::string> failures = {FailureOf(specimen)};
  AddFailures(specimen.failures, failures);
  return failures;
}

/** Returns the grade of the gravest symptom, which is the first. */
Grade GradeOf(const Specimen& specimen) {
  const std::map<Grade, std::uint64_t>& grades = specimen.symptoms.front().grades;
  return grades.empty() ? Grade::kNone : grades.rbegin()->first;
}

/** Makes `joined` stand for the symptoms of `other`, too, and takes the plainer question
 of those of the gravest grade. */
void Join(Specimen other, Specimen& joined) {
  const bool is_plainer = GradeOf(other) == GradeOf(joined) &&
                          PlainnessOf(other.question) < PlainnessOf(joined.question);
  std::vector<Symptom> symptoms = std::move(joined.symptoms);
  std::ranges::move(other.symptoms, std::back_inserter(symptoms));
  std::vector<std::string> failures = FailuresOf(joined);
  AddFailures(FailuresOf(other), failures);
  if (is_plainer) joined = std::move(other);
  joined.symptoms = std::move(symptoms);
  joined.failures = std::move(failures);
}

/** Completes a root from its specimens. */
void Sum(Root& root, std::span<const Asked> asked,
         std::span<const Oracle* const> oracles) {
  std::map<Grade, std::uint64_t> grades;  // Answers by the grade of their fault.
  std::ranges::stable_sort(root.specimens, std::less{}, [](const Specimen& specimen) {
    return PlainnessOf(specimen.question);
  });
  if (root.key.failure == kIsWrong) {
    for (const Specimen& specimen : root.specimens)
      AddFailures(FailuresOf(specimen), root.failures);
  } else {
    root.failures = {root.key.failure};
  }
  const bool only_differs =
      root.failures.size() == 1 && root.failures.front() == kDiffersInAnotherFrame;
  for (const Specimen& specimen : root.specimens) {
    for (const Symptom& symptom : specimen.symptoms) {
      // The fault is that of a variant: the answers themselves do not have it.
      const bool is_own = !IsOfAVariant(symptom.key.measure) || only_differs;
      for (const auto& [what, failed] : symptom.failed) {
        if (is_own) root.rates[{symptom.key.oracle, what}].failed += failed;
        if (!is_own) root.in_variants += failed;
      }
      if (!is_own) continue;
      for (const auto& [grade, failed] : symptom.grades) grades[grade] += failed;
    }
    // Where only variants show it, that of the question which is shown.
    grades.try_emplace(specimen.finding.grade, 0);
  }
  const std::vector<std::string> shown_by = OraclesOf(root);
  for (const Asked& row : asked) {
    if (!std::ranges::binary_search(shown_by, row.oracle)) continue;
    const auto oracle = std::ranges::find_if(oracles, [&](const Oracle* candidate) {
      return candidate->info().name == row.oracle;
    });
    if (root.rates.contains({row.oracle, row.what}) ||
        MayShow(root.key, row.pair, (*oracle)->info()))
      root.rates[{row.oracle, row.what}].asked += row.count;
  }
  for (const auto& [of, rate] : root.rates) root.rate += rate;
  root.grade = grades.rbegin()->first;
  root.gravest = {grades.rbegin()->second, root.rate.asked};
  const Rate least_seen{std::max<std::uint64_t>(root.gravest.failed, 1), root.rate.asked};
  root.rank = static_cast<int>(root.grade) + 0.5 * std::log10(ShareOf(least_seen));
}

}  // namespace

bool MayShow(const RootKey& root, const AskedPair& pair, const OracleInfo& oracle) {
  if (!pair) return root.algorithm.empty();
  const auto [A, B] = *pair;
  const Capability& capability = oracle.For(A, B);
  return capability.supported && capability.family == root.algorithm &&
         (root.shapes.empty() || root.shapes == PairName(A, B));
}

RootKey KeyOf(const Specimen& specimen) {
  RootKey key{.library = specimen.oracle->info().library,
              .version = specimen.oracle->info().version,
              .algorithm = AlgorithmOf(specimen),
              .failure = FailureOf(specimen),
              .place = EndingOf(specimen.finding),
              .shapes = {}};
  if (IsOfItsShapes(specimen, key)) key.shapes = ShapesOf(specimen.question);
  if (key.place.empty() && IsOneFunction(key.algorithm, specimen.oracle->info()))
    key.failure = kIsWrong;
  return key;
}

std::vector<Specimen> Joined(std::vector<Specimen> specimens) {
  std::vector<Specimen> joined;
  std::map<RootKey, std::size_t> places;  // In `joined`.
  for (Specimen& specimen : specimens) {
    if (specimen.is_repeatable) {
      const auto [place, is_new] = places.emplace(KeyOf(specimen), joined.size());
      if (!is_new) {
        Join(std::move(specimen), joined[place->second]);
        continue;
      }
    }
    joined.push_back(std::move(specimen));
  }
  return joined;
}

bool IsOfASetting(const Root& root) {
  const Finding& finding = root.smallest().finding;
  return finding.shipped == Shipped::kHereOnly || finding.cause == Cause::kSetting;
}

std::vector<Root> RootsOf(std::vector<Specimen> specimens, std::span<const Asked> asked,
                          std::span<const Oracle* const> oracles) {
  std::map<RootKey, Root> roots;
  for (Specimen& specimen : specimens) {
    if (!specimen.is_repeatable) continue;
    RootKey key = KeyOf(specimen);
    roots[std::move(key)].specimens.push_back(std::move(specimen));
  }
  std::vector<Root> sorted;
  for (auto& [key, root] : roots) {
    root.key = key;
    Sum(root, asked, oracles);
    sorted.push_back(std::move(root));
  }
  std::ranges::stable_sort(sorted, [](const Root& a, const Root& b) {
    return std::pair(!IsOfASetting(a), a.rank) > std::pair(!IsOfASetting(b), b.rank);
  });
  return sorted;
}

std::string TitleOf(const Root& root) {
  const RootKey& key = root.key;
  std::string title =
      fmt::format("{} {}{} {}", key.library, key.version,
                  key.algorithm.empty() ? "" : fmt::format(" ({})", key.algorithm),
                  fmt::join(root.failures, ", "));
  // The numbers of the case that is shown: a key has none.
  for (const std::string& part : {EndingInWords(root.smallest().finding), key.shapes}) {
    if (!part.empty()) title += ": " + part;
    if (title.ends_with('.')) title.pop_back();
  }
  return title;
}

std::vector<std::string> OraclesOf(const Root& root) {
  std::set<std::string> names;
  for (const Specimen& specimen : root.specimens) {
    for (const Symptom& symptom : specimen.symptoms) names.insert(symptom.key.oracle);
  }
  return {names.begin(), names.end()};
}

std::string FolderOf(const Root& root) {
  constexpr std::size_t kLongest = 80;
  const RootKey& key = root.key;
  std::string name;
  for (const std::string* const part :
       {&key.library, &key.algorithm, &key.failure, &key.place, &key.shapes}) {
    if (part->empty()) continue;
    if (!name.empty() && name.back() != '_') name += '_';
    for (const char letter : *part) {
      const auto c = static_cast<unsigned char>(letter);
      if (std::isalnum(c) != 0) {
        name += static_cast<char>(std::tolower(c));
      } else if (!name.empty() && name.back() != '_') {
        name += '_';
      }
    }
  }
  name.resize(std::min(name.size(), kLongest));
  while (name.ends_with('_')) name.pop_back();
  return name;
}

}  // namespace touchstone
