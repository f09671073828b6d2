#include "reports/journal/examination_wire.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include "oracles/isolation/answer_wire.h"
#include "oracles/isolation/wire.h"

namespace touchstone {
namespace {

// The smallest encoding of a finding is larger than this. [bytes]
constexpr std::size_t kSmallestFinding = 64;
constexpr std::size_t kSmallestText = sizeof(std::uint32_t);  // Its length. [bytes]

void Put(WireWriter& to, const std::string& text) {
  to.Put(std::string_view(text));
}
void Put(WireWriter& to, double number) {
  to.Put(number);
}
void Put(WireWriter& to, bool flag) {
  to.Put(static_cast<std::uint8_t>(flag));
}
template <typename Enum>
requires std::is_enum_v<Enum>
void Put(WireWriter& to, Enum value) {
  to.Put(static_cast<std::int32_t>(value));
}
void Put(WireWriter& to, const std::optional<int>& number) {
  to.Put(static_cast<std::int32_t>(number.value_or(-1)));
}
void Put(WireWriter& to, const std::optional<double>& number) {
  Put(to, number.has_value());
  Put(to, number.value_or(0));
}
void Put(WireWriter& to, const std::optional<StepStudy>& study) {
  Put(to, study.has_value());
  if (!study) return;
  for (const double error : study->errors) Put(to, error);
  Put(to, study->unit);
}
void Put(WireWriter& to, const Cited& cited) {
  to.Put(static_cast<std::uint32_t>(cited.names.size()));
  for (const std::string& name : cited.names) Put(to, name);
  Put(to, cited.time);
  to.Put(static_cast<std::uint32_t>(cited.points_W.size()));
  for (const Eigen::Vector3d& p_W : cited.points_W) to.Put(p_W);
  Put(to, cited.first_time);
}

void Get(WireReader& from, std::string& text) {
  text = from.GetText();
}
void Get(WireReader& from, double& number) {
  number = from.Get<double>();
}
void Get(WireReader& from, bool& flag) {
  flag = from.Get<std::uint8_t>() != 0;
}
template <typename Enum>
requires std::is_enum_v<Enum>
void Get(WireReader& from, Enum& value) {
  value = static_cast<Enum>(from.Get<std::int32_t>());
}
void Get(WireReader& from, std::optional<int>& number) {
  const auto value = from.Get<std::int32_t>();
  number = value < 0 ? std::nullopt : std::optional<int>(value);
}
void Get(WireReader& from, std::optional<double>& number) {
  bool has = false;
  double value = 0;
  Get(from, has);
  Get(from, value);
  number = has ? std::optional(value) : std::nullopt;
}
void Get(WireReader& from, std::optional<StepStudy>& study) {
  bool has = false;
  Get(from, has);
  if (!has) return;
  study.emplace();
  for (double& error : study->errors) Get(from, error);
  Get(from, study->unit);
}

void Get(WireReader& from, Eigen::Vector3d& v) {
  for (double& x : v) Get(from, x);
}
void Get(WireReader& from, Cited& cited) {
  cited.names.resize(from.GetCount(kSmallestText));
  for (std::string& name : cited.names) Get(from, name);
  Get(from, cited.time);
  cited.points_W.resize(from.GetCount(sizeof(Eigen::Vector3d)));
  for (Eigen::Vector3d& p_W : cited.points_W) Get(from, p_W);
  Get(from, cited.first_time);
}

// The evidence of a world is that of a variant: the places of one body at one time.
void Put(WireWriter& to, const std::shared_ptr<const Proof>& evidence) {
  const bool has = evidence && evidence->kind == ProofKind::kPlaces;
  Put(to, has);
  if (!has) return;
  for (const Eigen::Vector3d& p_W : {evidence->points_W[0], evidence->points_W[1]})
    to.Put(p_W);
  Put(to, evidence->body);
  Put(to, evidence->time);
  Put(to, evidence->rest);
}
void Get(WireReader& from, std::shared_ptr<const Proof>& evidence) {
  bool has = false;
  Get(from, has);
  if (!has) return;
  Proof places{.kind = ProofKind::kPlaces};
  places.points_W.resize(2);
  for (Eigen::Vector3d& p_W : places.points_W) Get(from, p_W);
  Get(from, places.body);
  Get(from, places.time);
  Get(from, places.rest);
  evidence = std::make_shared<const Proof>(std::move(places));
}

/** Calls `each` with every field of a finding. The binding names all of them, so that a
 new field does not compile until it is added here. */
template <typename SomeFinding, typename Each>
void ForEachField(SomeFinding& finding, Each each) {
  auto& [scenario, oracle, reference, law, universal, measure, value, tolerance,
         tolerance_because, verdict, undecided, grade, safety, cause, cause_because,
         shipped, shipped_because, proof, evidence, study, cited, ledger_entry,
         outgrown_entry] = finding;
  each(scenario);
  each(oracle);
  each(reference);
  each(law);
  each(universal);
  each(measure);
  each(value);
  each(tolerance);
  each(tolerance_because);
  each(verdict);
  each(undecided);
  each(grade);
  each(safety);
  each(cause);
  each(cause_because);
  each(shipped);
  each(shipped_because);
  each(proof);
  each(evidence);
  each(study);
  each(cited);
  each(ledger_entry);
  each(outgrown_entry);
}

template <typename SomeDrifts, typename Each>
void ForEachDrift(SomeDrifts& drifts, Each each) {
  auto& [energy_gained, energy_lost, momentum, angular_momentum] = drifts;
  each(energy_gained);
  each(energy_lost);
  each(momentum);
  each(angular_momentum);
}

void Put(WireWriter& to, const SecondsByName& seconds) {
  to.Put(static_cast<std::uint32_t>(seconds.size()));
  for (const auto& [name, value] : seconds) {
    Put(to, name);
    Put(to, value);
  }
}
void Get(WireReader& from, SecondsByName& seconds) {
  const std::uint32_t count = from.GetCount(kSmallestText + sizeof(double));
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::string name = from.GetText();
    Get(from, seconds[name]);
  }
}

template <typename SomeSeconds, typename Each>
void ForEachSecond(SomeSeconds& seconds, Each each) {
  auto& [all, motions, laws] = seconds;
  each(all);
  each(motions);
  each(laws);
}

template <typename SomeStatistics, typename Each>
void ForEachStatistic(SomeStatistics& statistics, Each each) {
  auto& [members, kinetic_energy, height, width] = statistics;
  for (auto* statistic : {&kinetic_energy, &height, &width}) {
    each(statistic->mean);
    each(statistic->deviation);
  }
}

}  // namespace

std::string ToWire(const Examination& examination) {
  WireWriter to;
  to.Put(std::string_view(ToWire(examination.trajectory)));
  const auto put = [&to](const auto& field) { Put(to, field); };
  ForEachDrift(examination.drifts, put);
  to.Put(static_cast<std::int32_t>(examination.ensemble.members));
  ForEachStatistic(examination.ensemble, put);
  to.Put(static_cast<std::uint32_t>(examination.findings.size()));
  for (const Finding& finding : examination.findings) ForEachField(finding, put);
  ForEachSecond(examination.seconds, put);
  return to.Take();
}

std::optional<Examination> ExaminationFromWire(std::string_view bytes) {
  WireReader from(bytes);
  Examination examination;
  std::optional<Trajectory> trajectory = TrajectoryFromWire(from.GetText());
  if (!trajectory) return std::nullopt;
  examination.trajectory = std::move(*trajectory);
  const auto get = [&from](auto& field) { Get(from, field); };
  ForEachDrift(examination.drifts, get);
  examination.ensemble.members = from.Get<std::int32_t>();
  ForEachStatistic(examination.ensemble, get);
  const std::uint32_t count = from.GetCount(kSmallestFinding);
  examination.findings.resize(count);
  for (Finding& finding : examination.findings) ForEachField(finding, get);
  ForEachSecond(examination.seconds, get);
  if (!from.AtEndWithoutFailure()) return std::nullopt;
  return examination;
}

}  // namespace touchstone
