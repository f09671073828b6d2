#include "reports/writers/report_data.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "reports/baseline/baseline.h"
#include "reports/clusters/clusters.h"
#include "reports/text/counted.h"
#include "reports/writers/conclusion.h"
#include "reports/writers/data/cited_data.h"
#include "reports/writers/data/contact_data.h"
#include "reports/writers/data/data_file.h"
#include "reports/writers/data/findings_data.h"
#include "reports/writers/data/json_values.h"
#include "reports/writers/data/proofs_data.h"
#include "reports/writers/data/texts.h"
#include "reports/writers/data/world_data.h"
#include "reports/writers/outcome.h"
#include "reports/writers/world_sums.h"
#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

DataJson OracleData(const OracleInfo& oracle) {
  DataJson data;
  data["name"] = oracle.name;
  data["library"] = oracle.library;
  data["version"] = oracle.version;
  data["unit_roundoff"] = ToData(oracle.unit_roundoff);
  data["isolated"] = oracle.isolated;
  data["contacts"] = oracle.AnswersContacts();
  data["worlds"] = oracle.simulates;
  data["settings"] = DataJson::array();
  for (const Setting& setting : oracle.settings) {
    data["settings"].push_back(
        {{"name", setting.name}, {"value", setting.value}, {"why", setting.why}});
  }
  data["parameters"] = DataJson::array();
  const std::vector<double> values = ValuesOf(oracle.parameters, oracle.setup);
  for (std::size_t i = 0; i < values.size(); ++i) {
    data["parameters"].push_back(
        {{"name", oracle.parameters[i].name},
         {"set", fmt::format("{:.6g}", values[i])},
         {"shipped", fmt::format("{:.6g}", oracle.parameters[i].shipped)}});
  }
  return data;
}

/** Returns what questions of either kind have in common. */
DataJson QuestionData(const RunReport& report, std::size_t i) {
  const std::size_t contacts = report.scenarios.size();
  DataJson data;
  data["id"] = IdOf(report, i);
  data["group"] = GroupOf(IdOf(report, i));
  data["title"] = TitleOf(report, i);
  data["kind"] = i < contacts ? "contact" : "world";
  data["toml"] = i < contacts ? WriteScenario(report.scenarios[i].scenario)
                              : WriteScenario(report.worlds[i - contacts].scenario);
  data["size"] = ToData(SizeOfQuestion(report, i), 6);
  data["rounding"] = DataJson::array();
  for (std::size_t o = 0; o < report.oracles.size(); ++o)
    data["rounding"].push_back(ToData(RoundingLength(report, i, o), 2));
  return data;
}

std::string PairOf(const ContactQuery& query) {
  std::string pair =
      fmt::format("{}–{}", NameOf(KindOf(query.A.shape)), NameOf(KindOf(query.B.shape)));
  for (char& c : pair) {
    if (c == '_') c = ' ';
  }
  return pair;
}

DataJson ClusterData(const RunReport& report, const Cluster& cluster,
                     const FailureRule& rule) {
  DataJson data;
  data["title"] = cluster.title;
  data["extent"] = ExtentOf(report, cluster);
  data["reason"] = cluster.reason;
  data["upstream"] = cluster.upstream;
  data["is_new"] = cluster.is_new;
  data["has_outgrown"] = cluster.has_outgrown;
  data["counts"] = std::ranges::any_of(cluster.findings, [&](std::size_t f) {
    return CountsAsFailure(report.findings[f], report, rule);
  });
  data["grade"] = static_cast<int>(cluster.grade);
  data["cause"] = static_cast<int>(cluster.cause);
  data["responsible"] = NameOf(cluster.responsible);
  data["oracles"] = cluster.oracles;
  data["questions"] = cluster.questions;
  data["worst"] = cluster.worst;
  data["error"] = ToData(cluster.error, 5);
  data["unit"] = cluster.unit;
  data["share"] = ToShare(cluster.share);
  data["ordinary"] = ToData(cluster.ordinary, 3);
  return data;
}

DataJson LedgerData(const LedgerEntry& entry, const LedgerUse& use) {
  DataJson data;
  data["scenarios"] = entry.scenarios;
  data["oracle"] = entry.oracle;
  data["version"] = entry.version;
  data["verdict"] = NameOf(entry.verdict);
  data["measures"] = DataJson::array();
  for (const MeasureKind measure : entry.measures)
    data["measures"].push_back(NameOf(measure));
  data["cause"] = CausesOf(entry);
  data["responsible"] = NameOf(entry.responsible);
  data["fault"] = FaultOf(entry);
  data["reason"] = entry.reason;
  data["upstream"] = entry.upstream;
  data["expires"] = entry.expires;
  data["uses"] = use.findings();
  return data;
}

/** The parts of the data that hold the scenes. */
class Scenes {
 public:
  Scenes(const RunReport& report, std::span<const Outcome> outcomes, std::string& blob)
      : report_(report), outcomes_(outcomes), blob_(blob) {}

  DataJson Questions() {
    DataJson questions = DataJson::array();
    for (std::size_t i = 0; i < QuestionCount(report_); ++i) {
      DataJson data = QuestionData(report_, i);
      if (i < report_.scenarios.size()) {
        const ScenarioResult& result = report_.scenarios[i];
        data["pair"] = PairOf(result.scenario.contact);
        data["contact"] = ContactData(result, Asked(i));
      } else {
        data["world"] = DataOf(WorldAt(i), moments_, blob_);
      }
      questions.push_back(std::move(data));
    }
    return questions;
  }

  const std::vector<Moment>& moments() const { return moments_; }

 private:
  std::vector<bool> Asked(std::size_t question) const {
    std::vector<bool> asked;
    for (std::size_t o = 0; o < report_.oracles.size(); ++o)
      asked.push_back(Answers(report_, o, question));
    return asked;
  }

  WorldDataInput WorldAt(std::size_t question) const {
    WorldDataInput world{.result = report_.worlds[question - report_.scenarios.size()],
                         .size = SizeOfQuestion(report_, question),
                         .simulates = Asked(question),
                         .findings = {},
                         .first_finding = {}};
    for (std::size_t o = 0; o < report_.oracles.size(); ++o) {
      const std::span<const Finding> of_oracle =
          outcomes_[question * report_.oracles.size() + o].findings;
      world.findings.push_back(of_oracle);
      world.first_finding.push_back(
          static_cast<std::size_t>(of_oracle.data() - report_.findings.data()));
    }
    return world;
  }

  const RunReport& report_;
  std::span<const Outcome> outcomes_;
  std::string& blob_;
  std::vector<Moment> moments_;
};

/** Returns the time of each question by each oracle, null where it is not asked. [s] */
DataJson SecondsData(const RunReport& report) {
  DataJson data = DataJson::array();
  for (std::size_t i = 0; i < QuestionCount(report); ++i) {
    DataJson& of_question = data.emplace_back(DataJson::array());
    for (std::size_t o = 0; o < report.oracles.size(); ++o) {
      of_question.push_back(Answers(report, o, i) ? ToData(SecondsOf(report, o, i), 3)
                                                  : DataJson(nullptr));
    }
  }
  return data;
}

DataJson SumsData(const SecondsByName& sums) {
  DataJson data = DataJson::object();
  for (const auto& [name, seconds] : sums) data[name] = ToData(seconds, 3);
  return data;
}

}  // namespace

std::string ReportData(const RunReport& report, const RunFacts& facts) {
  const std::vector<Outcome> outcomes = OutcomesOf(report);
  const Clusters clusters = ClustersOf(report);
  Texts texts;
  std::string blob;
  DataJson data;
  data["format"] = "touchstone report data";
  data["version"] = kReportDataVersion;
  data["program"] = facts.program;
  data["command"] = facts.command;
  data["sentence"] = AnswersInWords(report);
  data["conclusion"] = ConclusionOf(report, outcomes, facts.rule);
  data["exit_code"] = ExitCode(report, facts.rule);
  data["failed"] = data["exit_code"] != 0;
  data["subject"] = 0;
  data["oracles"] = DataJson::array();
  for (const OracleInfo& oracle : report.oracles)
    data["oracles"].push_back(OracleData(oracle));
  Scenes scenes(report, outcomes, blob);
  data["questions"] = scenes.Questions();
  for (DataJson& question : data["questions"]) {
    if (facts.own.contains(question["id"].get<std::string>())) question["own"] = true;
  }
  data["names"] = NamesData();
  data["findings"] = FindingsData(report, clusters, scenes.moments(), texts);
  data["names"].update(ProofNames());
  data["proofs"] = ProofsData(report.findings, texts);
  data["cited"] = CitedData(report, clusters);
  data["studies"] = StudiesData(report.findings);
  data["clusters"] = DataJson::array();
  for (const Cluster& cluster : clusters.ranked)
    data["clusters"].push_back(ClusterData(report, cluster, facts.rule));
  data["ledger"] = DataJson::array();
  for (std::size_t i = 0; i < report.ledger.entries.size(); ++i)
    data["ledger"].push_back(LedgerData(report.ledger.entries[i], report.ledger_use[i]));
  data["faults"] = report.faults;
  data["regressions"] = DataJson::array();
  for (const Regression& regression : report.regressions) {
    data["regressions"].push_back(
        {{"oracle", regression.oracle}, {"what", regression.what}});
  }
  data["seconds"] = SecondsData(report);
  data["spent"] = {{"motions", SumsData(SecondsOfMotions(report))},
                   {"laws", SumsData(SecondsOfLaws(report))},
                   {"contacts", SumsData(report.seconds_of_contacts)}};
  data["texts"] = texts.all();
  return PackData({std::move(data), std::move(blob)});
}

}  // namespace touchstone
