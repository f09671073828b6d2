#include "reports/writers/json_writer.h"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "reports/worlds/study/judge_world.h"
#include "reports/worlds/study/universal_claims.h"
#include "reports/writers/describe.h"
#include "reports/writers/outcome.h"

namespace touchstone {
namespace {

using Json = nlohmann::ordered_json;

Json ToJson(double value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0 ? "Infinity" : "-Infinity";
  return value;
}

Json ToJson(const Eigen::Vector3d& v) {
  return Json::array({ToJson(v.x()), ToJson(v.y()), ToJson(v.z())});
}

template <typename T>
Json ToJson(const std::optional<T>& value) {
  return value ? ToJson(*value) : Json(nullptr);
}

Json ToJson(const std::vector<Eigen::Vector3d>& points) {
  Json json = Json::array();
  for (const Eigen::Vector3d& point : points) json.push_back(ToJson(point));
  return json;
}

Json ToJson(const Enclosure& enclosure) {
  return {{"lo", ToJson(enclosure.lo)}, {"hi", ToJson(enclosure.hi)}};
}

struct ShapeToJson {
  Json& json;

  void operator()(const Sphere& sphere) const { json["radius"] = ToJson(sphere.radius); }
  void operator()(const Box& box) const {
    json["half_extents"] = ToJson(box.half_extents);
  }
  void operator()(const Capsule& capsule) const {
    json["radius"] = ToJson(capsule.radius);
    json["half_length"] = ToJson(capsule.half_length);
  }
  void operator()(const Cylinder& cylinder) const {
    json["radius"] = ToJson(cylinder.radius);
    json["half_length"] = ToJson(cylinder.half_length);
  }
  void operator()(const Cone& cone) const {
    json["radius"] = ToJson(cone.radius);
    json["half_height"] = ToJson(cone.half_height);
  }
  void operator()(const ConvexHull& hull) const {
    json["vertices"] = ToJson(hull.vertices);
  }
  void operator()(const HalfSpace&) const {}
};

Json ToJson(const Body& body) {
  Json json;
  json["shape"] = NameOf(KindOf(body.shape));
  std::visit(ShapeToJson{json}, body.shape);
  json["position"] = ToJson(body.X_WB.p_WB);
  if (body.X_WB.q_WB) {
    const Eigen::Quaterniond& q = *body.X_WB.q_WB;
    json["quaternion_wxyz"] =
        Json::array({ToJson(q.w()), ToJson(q.x()), ToJson(q.y()), ToJson(q.z())});
  }
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row) {
    rows.push_back(ToJson(Eigen::Vector3d(body.X_WB.R_WB.row(row).transpose())));
  }
  json["rotation"] = rows;
  return json;
}

Json ToJson(const ContactExpectation& expect) {
  Json json = Json::object();
  if (expect.touching) json["touching"] = *expect.touching;
  if (expect.separation) json["separation"] = ToJson(*expect.separation);
  if (!expect.normals.empty()) json["normals"] = ToJson(expect.normals);
  if (expect.contacts) json["contacts"] = *expect.contacts;
  return json;
}

Json ToJson(const ContactTruth& truth) {
  Json json;
  json["touching"] = NameOf(truth.touching);
  json["separation"] = ToJson(truth.separation);
  json["input_rounding"] = ToJson(truth.input_rounding);
  json["method"] = truth.method;
  json["certificate"] = {{"normal", ToJson(truth.certificate.n_AB_W)},
                         {"point_A", ToJson(truth.certificate.p_WCa)},
                         {"point_B", ToJson(truth.certificate.p_WCb)}};
  return json;
}

const char* NameOfStatus(AnswerStatus status) {
  switch (status) {
    case AnswerStatus::kAnswered:
      return "answered";
    case AnswerStatus::kUnsupported:
      return "unsupported";
    case AnswerStatus::kCrashed:
      return "crashed";
    case AnswerStatus::kTimedOut:
      return "timed out";
  }
  return "crashed";
}

/** Adds the reason of an undecidable outcome, and the grade of a fault. */
void AddReasons(const Outcome& outcome, Json& json) {
  if (outcome.decisive == nullptr) return;
  if (outcome.verdict == Verdict::kUndecidable)
    json["undecided"] = NameOf(outcome.decisive->undecided);
  if (outcome.decisive->grade != Grade::kNone)
    json["grade"] = NameOf(outcome.decisive->grade);
}

Json ToJson(const OracleInfo& oracle, const ContactAnswer& answer,
            const Outcome& outcome) {
  Json json;
  json["oracle"] = oracle.name;
  json["verdict"] = NameOf(outcome.verdict);
  AddReasons(outcome, json);
  json["status"] = NameOfStatus(answer.status);
  if (answer.status != AnswerStatus::kAnswered) {
    json["reason"] = answer.reason;
    return json;
  }
  json["touching"] = answer.touching;
  json["normal"] = ToJson(answer.n_AB_W);
  json["separation"] = ToJson(answer.separation);
  json["points"] = Json::array();
  for (const ContactPoint& point : answer.points) {
    Json contact;
    contact["position"] = ToJson(point.p_WC);
    contact["separation"] = ToJson(point.separation);
    if (point.n_AB_W) contact["normal"] = ToJson(*point.n_AB_W);
    json["points"].push_back(contact);
  }
  if (answer.witnesses) {
    json["witnesses"] = {{"point_A", ToJson(answer.witnesses->p_WCa)},
                         {"point_B", ToJson(answer.witnesses->p_WCb)}};
  }
  return json;
}

Json ScenarioToJson(const RunReport& report, std::span<const Outcome> outcomes,
                    std::size_t index) {
  const ScenarioResult& result = report.scenarios[index];
  const Scenario& scenario = result.scenario;
  Json json;
  json["id"] = scenario.id;
  json["title"] = scenario.title;
  json["source"] = scenario.source;
  json["A"] = ToJson(scenario.contact.A);
  json["B"] = ToJson(scenario.contact.B);
  json["expect"] = ToJson(scenario.expect);
  if (scenario.tolerance) {
    json["tolerance"] = {{"separation", ToJson(scenario.tolerance->separation)},
                         {"because", scenario.tolerance->because}};
  }
  json["truth"] = ToJson(result.truth);
  json["answers"] = Json::array();
  for (std::size_t o = 0; o < report.oracles.size(); ++o) {
    json["answers"].push_back(ToJson(report.oracles[o], result.answers[o],
                                     outcomes[index * report.oracles.size() + o]));
  }
  return json;
}

Json ToJson(const OracleInfo& oracle) {
  Json json;
  json["name"] = oracle.name;
  json["library"] = oracle.library;
  json["version"] = oracle.version;
  json["unit_roundoff"] = ToJson(oracle.unit_roundoff);
  json["isolated"] = oracle.isolated;
  json["settings"] = Json::array();
  for (const Setting& setting : oracle.settings) {
    json["settings"].push_back(
        {{"name", setting.name}, {"value", setting.value}, {"why", setting.why}});
  }
  const std::vector<double> values = ValuesOf(oracle.parameters, oracle.setup);
  json["world_as_shipped"] = oracle.setup.as_shipped;
  json["world_parameters"] = Json::array();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const WorldParameter& parameter = oracle.parameters[i];
    json["world_parameters"].push_back({{"name", parameter.name},
                                        {"value", ToJson(values[i])},
                                        {"here", ToJson(parameter.here)},
                                        {"shipped", ToJson(parameter.shipped)},
                                        {"what", parameter.what},
                                        {"why", parameter.why}});
  }
  return json;
}

/** Returns the numbers of a proof that apply to it. */
Json ToJson(const Proof& proof) {
  Json json;
  json["kind"] = NameOf(proof.kind);
  if (proof.claim != ProofClaim::kNone) json["claim"] = NameOf(proof.claim);
  const auto add_number = [&json](const char* name, double value) {
    if (!std::isnan(value)) json[name] = ToJson(value);
  };
  const auto add_direction = [&json](const char* name, const Eigen::Vector3d& n_W) {
    if (!n_W.isZero(0)) json[name] = ToJson(n_W);
  };
  add_number("said", proof.said);
  add_number("bound", proof.bound);
  add_number("rest", proof.rest);
  add_direction("n", proof.n_W);
  add_number("offset", proof.offset);
  add_direction("claimed", proof.claimed_W);
  if (!proof.points_W.empty()) json["points"] = ToJson(proof.points_W);
  if (proof.kind == ProofKind::kCount || proof.kind == ProofKind::kUnspanned)
    json["contacts"] = proof.contacts;
  if (!proof.change.empty()) json["change"] = proof.change;
  if (proof.kind == ProofKind::kVariantTouch) json["touching"] = proof.touching;
  if (proof.explained != 0) json["explained"] = ToJson(proof.explained);
  if (!proof.body.empty()) json["body"] = proof.body;
  add_number("time", proof.time);
  return json;
}

Json ToJson(const StepStudy& study) {
  Json errors = Json::array();
  for (const double error : study.errors) errors.push_back(ToJson(error));
  return {{"errors", std::move(errors)}, {"unit", study.unit}};
}

Json ToJson(const Finding& finding) {
  Json json;
  json["scenario"] = finding.scenario;
  json["oracle"] = finding.oracle;
  json["reference"] = finding.reference;
  if (!finding.law.empty()) json["law"] = finding.law;
  if (finding.universal) json["universal"] = true;
  json["measure"] = NameOf(finding.measure);
  json["unit"] = UnitOf(finding.measure);
  json["value"] = ToJson(finding.value);
  json["tolerance"] = ToJson(finding.tolerance);
  json["tolerance_because"] = finding.tolerance_because;
  json["verdict"] = NameOf(finding.verdict);
  if (finding.verdict == Verdict::kUndecidable)
    json["undecided"] = NameOf(finding.undecided);
  if (finding.grade != Grade::kNone) json["grade"] = NameOf(finding.grade);
  if (IsWithinSafety(finding)) json["within_safety_factor"] = ToJson(finding.safety);
  if (finding.cause != Cause::kNone) {
    json["cause"] = NameOf(finding.cause);
    json["cause_because"] = finding.cause_because;
  }
  if (finding.shipped != Shipped::kNotAsked) {
    json["shipped"] = NameOf(finding.shipped);
    json["shipped_because"] = finding.shipped_because;
  }
  if (!finding.proof.empty()) json["proof"] = finding.proof;
  if (finding.evidence) json["evidence"] = ToJson(*finding.evidence);
  if (finding.study) json["study"] = ToJson(*finding.study);
  if (finding.cited.time) json["time"] = ToJson(*finding.cited.time);
  if (!finding.cited.names.empty() || !finding.cited.points_W.empty())
    json["cited"] = {{"names", finding.cited.names},
                     {"points", ToJson(finding.cited.points_W)}};
  if (finding.ledger_entry) json["ledger_entry"] = *finding.ledger_entry;
  return json;
}

Json ToJson(const Eigen::Quaterniond& q) {
  return Json::array({ToJson(q.w()), ToJson(q.x()), ToJson(q.y()), ToJson(q.z())});
}

Json ToJson(const PointState& point) {
  return {{"position", ToJson(point.p_W)}, {"velocity", ToJson(point.v_W)}};
}

Json ToJson(const WorldState& state) {
  Json json = {
      {"bodies", Json::array()}, {"particles", Json::array()}, {"nodes", Json::array()}};
  for (const BodyState& body : state.bodies) {
    json["bodies"].push_back({{"position", ToJson(body.p_WB)},
                              {"quaternion_wxyz", ToJson(body.q_WB)},
                              {"velocity", ToJson(body.v_WB)},
                              {"spin", ToJson(body.w_WB)}});
  }
  for (const PointState& particle : state.particles)
    json["particles"].push_back(ToJson(particle));
  for (const PointState& node : state.nodes) json["nodes"].push_back(ToJson(node));
  return json;
}

/** Status and final state of a motion. `touchstone simulate` writes all samples. */
Json MotionToJson(const RunReport& report, const Outcome& outcome,
                  const Trajectory& trajectory) {
  Json json;
  json["oracle"] = report.oracles[outcome.oracle].name;
  json["verdict"] = NameOf(outcome.verdict);
  AddReasons(outcome, json);
  json["status"] = NameOfStatus(trajectory.status);
  json["reason"] = trajectory.reason;
  json["complaint"] = trajectory.complaint;
  json["diverged_at_step"] = trajectory.diverged_at_step;
  json["end"] =
      trajectory.samples.empty() ? Json(nullptr) : ToJson(trajectory.samples.back());
  return json;
}

Json ToJson(const MotionDrifts& drifts) {
  Json json;
  json["energy_gained"] = ToJson(drifts.energy_gained);
  json["energy_lost"] = ToJson(drifts.energy_lost);
  json["momentum"] = ToJson(drifts.momentum);
  json["angular_momentum"] = ToJson(drifts.angular_momentum);
  return json;
}

Json ToJson(const Statistic& statistic) {
  Json json;
  json["mean"] = ToJson(statistic.mean);
  json["deviation"] = ToJson(statistic.deviation);
  return json;
}

Json ToJson(const EnsembleStatistics& ensemble) {
  if (ensemble.members == 0) return nullptr;
  Json json;
  json["members"] = ensemble.members;
  json["kinetic_energy"] = ToJson(ensemble.kinetic_energy);
  json["height"] = ToJson(ensemble.height);
  json["width"] = ToJson(ensemble.width);
  return json;
}

Json WorldToJson(const RunReport& report, const std::vector<Outcome>& outcomes,
                 std::size_t w) {
  const WorldResult& result = report.worlds[w];
  const WorldScenario& scenario = result.scenario;
  Json json;
  json["id"] = scenario.id;
  json["title"] = scenario.title;
  json["source"] = scenario.source;
  json["dt"] = ToJson(scenario.world.dt);
  json["steps"] = scenario.world.steps;
  json["laws"] = Json::array();
  for (const Claim& claim : scenario.claims) json["laws"].push_back(claim.law);
  json["universal_laws"] = Json::array();
  for (const Claim& claim : UniversalClaims(scenario))
    json["universal_laws"].push_back(claim.law);
  json["motions"] = Json::array();
  const std::size_t oracles = report.oracles.size();
  for (std::size_t o = 0; o < oracles; ++o) {
    const Outcome& outcome = outcomes[(report.scenarios.size() + w) * oracles + o];
    if (!outcome.asked) continue;
    Json motion = MotionToJson(report, outcome, result.trajectories[o]);
    motion["drifts"] =
        IsWhole(result.trajectories[o]) ? ToJson(result.drifts[o]) : nullptr;
    motion["ensemble"] = ToJson(result.ensembles[o]);
    json["motions"].push_back(std::move(motion));
  }
  return json;
}

Json LedgerEntryToJson(const RunReport& report, std::size_t index) {
  const LedgerEntry& entry = report.ledger.entries[index];
  Json json;
  json["scenarios"] = entry.scenarios;
  json["oracle"] = entry.oracle;
  json["version"] = entry.version;
  json["verdict"] = NameOf(entry.verdict);
  json["accepted"] = Json::array();
  const LedgerUse& use = report.ledger_use[index];
  for (std::size_t i = 0; i < entry.measures.size(); ++i) {
    Json accepted;
    accepted["measure"] = NameOf(entry.measures[i]);
    accepted["hidden"] = use.hidden[i].findings;
    accepted["worst"] = ToJson(use.hidden[i].worst);
    accepted["bound"] = ToJson(use.hidden[i].bound);
    json["accepted"].push_back(std::move(accepted));
  }
  json["causes"] = Json::array();
  for (const Cause cause : entry.causes) json["causes"].push_back(NameOf(cause));
  json["responsible"] = NameOf(entry.responsible);
  json["fault"] = FaultOf(entry);
  json["reason"] = entry.reason;
  json["upstream"] = entry.upstream;
  json["intermittent"] = entry.intermittent;
  json["beyond_scene"] = entry.beyond_scene;
  json["void"] = use.voided;
  json["expires"] = entry.expires;
  json["hidden"] = use.findings();
  json["candidates"] = use.candidates;
  return json;
}

Json ToJson(const VerdictCounts& counts) {
  Json json;
  for (int i = 0; i < kVerdicts; ++i) {
    const Verdict verdict = static_cast<Verdict>(i);
    json[std::string(NameOf(verdict))] = counts[verdict];
  }
  Json undecided;
  for (int i = 0; i < kUndecided; ++i) {
    const auto reason = static_cast<Undecided>(i);
    undecided[std::string(NameOf(reason))] = counts[reason];
  }
  json["undecided"] = undecided;
  return json;
}

Json ToJson(const SecondsByName& seconds) {
  Json json = Json::object();
  for (const auto& [name, value] : seconds) json[name] = ToJson(value);
  return json;
}

/** Returns the time of one answer or world. */
Json SecondsToJson(const RunReport& report, std::size_t question, std::size_t oracle) {
  Json json;
  json["scenario"] = IdOf(report, question);
  json["oracle"] = report.oracles[oracle].name;
  json["seconds"] = ToJson(SecondsOf(report, oracle, question));
  const std::size_t contacts = report.scenarios.size();
  if (question < contacts) return json;
  const std::vector<WorldSeconds>& of_world = report.worlds[question - contacts].seconds;
  if (oracle >= of_world.size()) return json;
  json["motions"] = ToJson(of_world[oracle].motions);
  json["laws"] = ToJson(of_world[oracle].laws);
  return json;
}

// Writes an object as one line that names its kind first.
void WriteLine(std::string_view kind, const Json& object, std::ostream& out) {
  Json line = {{"kind", kind}};
  line.update(object);
  // Text from a third-party engine may not be valid UTF-8.
  out << line.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace

void WriteJson(const RunReport& report, std::ostream& out) {
  const std::vector<Outcome> outcomes = OutcomesOf(report);
  VerdictCounts counts;
  for (const Outcome& outcome : outcomes) {
    if (outcome.asked) Count(outcome, counts);
  }
  WriteLine("run",
            {{"format", "touchstone report"},
             {"version", 2},
             {"subject", report.subject},
             {"outcomes", ToJson(counts)}},
            out);
  for (const OracleInfo& oracle : report.oracles)
    WriteLine("oracle", ToJson(oracle), out);
  for (std::size_t i = 0; i < report.scenarios.size(); ++i)
    WriteLine("scenario", ScenarioToJson(report, outcomes, i), out);
  for (std::size_t i = 0; i < report.worlds.size(); ++i)
    WriteLine("world", WorldToJson(report, outcomes, i), out);
  for (const Finding& finding : report.findings)
    WriteLine("finding", ToJson(finding), out);
  for (const Outcome& outcome : outcomes) {
    if (outcome.asked)
      WriteLine("seconds", SecondsToJson(report, outcome.scenario, outcome.oracle), out);
  }
  for (std::size_t i = 0; i < report.ledger.entries.size(); ++i)
    WriteLine("ledger", LedgerEntryToJson(report, i), out);
  for (const std::string& fault : report.faults)
    WriteLine("fault", {{"what", fault}}, out);
  for (const Regression& regression : report.regressions) {
    WriteLine("regression", {{"oracle", regression.oracle}, {"what", regression.what}},
              out);
  }
}

}  // namespace touchstone
