#include "reports/run.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "oracles/stopwatch.h"
#include "reports/contacts/causes/precision.h"
#include "reports/contacts/consensus.h"
#include "reports/contacts/explain.h"
#include "reports/contacts/grade.h"
#include "reports/contacts/judge_answer.h"
#include "reports/contacts/judge_variant.h"
#include "reports/contacts/tolerances.h"
#include "reports/finding/decisive.h"
#include "reports/ledger/apply_ledger.h"
#include "reports/ledger/check_catalogue.h"
#include "reports/measures/invalidity.h"
#include "reports/referee/referee.h"
#include "reports/threads/parallel_for.h"
#include "reports/worlds/study/check_claims.h"
#include "reports/worlds/study/doubt_expectations.h"
#include "reports/worlds/study/run_worlds.h"

namespace touchstone {
namespace {

/** The number of questions in one batch to one oracle. Small enough that threads share
 the work evenly, large enough that starting a batch costs next to nothing. */
constexpr std::size_t kBatch = 64;

/** The number of batches of an isolated oracle, which forks once for each, for several
 threads. One thread shares with nobody, but may be stopped between batches. */
constexpr std::size_t kIsolatedBatches = 8;

/** Some of the questions, put to one oracle at once: every `stride`-th from `first` on
 and before `end`. */
struct Batch {
  std::size_t oracle;
  std::size_t first;
  std::size_t end;
  std::size_t stride = 1;
};

/** Splits the questions to each oracle into batches. Those of an isolated oracle go first
 because it is the slowest. They are dealt out in turn: questions on which it hangs are
 next to each other, and threads then share the time. */
std::vector<Batch> BatchesOf(std::span<const Oracle* const> oracles,
                             const std::vector<std::size_t>& counts, int jobs) {
  std::vector<Batch> isolated;
  std::vector<Batch> others;
  for (std::size_t i = 0; i < oracles.size(); ++i) {
    if (oracles[i]->info().isolated) {
      const std::size_t most =
          jobs == 1 ? (counts[i] + kBatch - 1) / kBatch : kIsolatedBatches;
      for (std::size_t first = 0; first < std::min(counts[i], most); ++first)
        isolated.push_back({i, first, counts[i], most});
      continue;
    }
    for (std::size_t begin = 0; begin < counts[i]; begin += kBatch)
      others.push_back({i, begin, std::min(begin + kBatch, counts[i])});
  }
  isolated.insert(isolated.end(), others.begin(), others.end());
  return isolated;
}

/** The questions to each oracle, and its answers to them. */
struct Round {
  explicit Round(std::size_t oracles) : queries(oracles), answers(oracles) {}

  /** Asks all questions, until the run is stopped. Questions that an oracle does not
   support are not put to it. */
  void Ask(std::span<const Oracle* const> oracles, const RunOptions& options,
           const std::function<void(std::size_t)>& on_done);

  std::vector<std::vector<ContactQuery>> queries;
  std::vector<std::vector<ContactAnswer>> answers;
};

const Capability& CapabilityFor(const Oracle& oracle, const ContactQuery& query) {
  return oracle.info().For(KindOf(query.A.shape), KindOf(query.B.shape));
}

/** Puts those questions of a batch to `oracle` that it supports, and returns the number
 of all of them. */
std::size_t AskSupported(const Oracle& oracle, const Batch& batch,
                         std::span<const ContactQuery> queries,
                         std::span<ContactAnswer> answers) {
  const auto together = queries.subspan(batch.first, batch.end - batch.first);
  if (batch.stride == 1 && std::ranges::all_of(together, [&](const ContactQuery& query) {
        return CapabilityFor(oracle, query).supported;
      })) {
    oracle.Answer(together, answers.subspan(batch.first, together.size()));
    return together.size();
  }
  std::size_t count = 0;
  std::vector<ContactQuery> supported;
  std::vector<std::size_t> places;
  for (std::size_t i = batch.first; i < batch.end; i += batch.stride) {
    ++count;
    const Capability& capability = CapabilityFor(oracle, queries[i]);
    if (capability.supported) {
      supported.push_back(queries[i]);
      places.push_back(i);
    } else {
      answers[i].status = AnswerStatus::kUnsupported;
      answers[i].reason = capability.reason;
    }
  }
  std::vector<ContactAnswer> given(supported.size());
  if (!supported.empty()) oracle.Answer(supported, given);
  for (std::size_t i = 0; i < places.size(); ++i)
    answers[places[i]] = std::move(given[i]);
  return count;
}

void Round::Ask(std::span<const Oracle* const> oracles, const RunOptions& options,
                const std::function<void(std::size_t)>& on_done) {
  std::vector<std::size_t> counts;
  for (std::size_t i = 0; i < oracles.size(); ++i) {
    counts.push_back(queries[i].size());
    answers[i].resize(queries[i].size());
  }
  const std::vector<Batch> batches = BatchesOf(oracles, counts, options.jobs);
  ParallelFor(batches.size(), options.jobs, [&](std::size_t b) {
    if (IsStopped(options.stop)) return;
    const std::size_t i = batches[b].oracle;
    const std::size_t asked =
        AskSupported(*oracles[i], batches[b], queries[i], answers[i]);
    if (on_done) on_done(asked);
  });
}

/** Returns whether an answer can be compared with the answer to a variant of its
 question. */
bool IsComparable(const ScenarioResult& result, const OracleInfo& oracle,
                  const ContactAnswer& answer) {
  return answer.status == AnswerStatus::kAnswered &&
         !InvalidityOf(
             answer, TolerancesOf(oracle, result.scenario, result.truth, answer.touching)
                         .unit_normal);
}

/** The work of asking and judging one contact query, roughly. [body-steps] */
constexpr double kContactWork = 100;

/** A run in progress. */
class Suite {
 public:
  Suite(std::span<const Scenario> scenarios, std::span<const WorldScenario> worlds,
        std::span<const Oracle* const> oracles, const RunOptions& options)
      : world_scenarios_(worlds.begin(), worlds.end()),
        oracles_(oracles),
        options_(options) {
    for (const Oracle* oracle : oracles) report_.oracles.push_back(oracle->info());
    if (!oracles.empty()) report_.subject = oracles.front()->info().name;
    for (std::size_t s = 0; s < scenarios.size(); ++s) {
      report_.scenarios.push_back(
          {scenarios[s],
           options.truths.empty() ? ContactTruth() : options.truths[s],
           {}});
    }
    std::stable_sort(report_.scenarios.begin(), report_.scenarios.end(),
                     [](const ScenarioResult& a, const ScenarioResult& b) {
                       return a.scenario.id < b.scenario.id;
                     });
    findings_.resize(report_.scenarios.size());
    std::stable_sort(
        world_scenarios_.begin(), world_scenarios_.end(),
        [](const WorldScenario& a, const WorldScenario& b) { return a.id < b.id; });
    const std::size_t contacts = oracles.size() * report_.scenarios.size();
    total_ = contacts + CountOfWorldRuns(world_scenarios_, oracles);
    total_work_ = kContactWork * static_cast<double>(contacts) +
                  WorkOfWorlds(world_scenarios_, oracles);
  }

  RunReport Report(const Ledger& ledger) && {
    Progress(0, 0);
    for (const auto stage :
         {&Suite::EstablishTruth, &Suite::AskQuestions, &Suite::Judge,
          &Suite::AskVariants, &Suite::SortFindings, &Suite::LimitExamination,
          &Suite::Explain, &Suite::Collect, &Suite::ExplainTheRest, &Suite::RunTheWorlds,
          &Suite::DoubtFiles}) {
      (this->*stage)();
      if (IsStopped(options_.stop)) return std::move(report_);
    }
    report_.ledger = ledger;
    ApplyLedger(report_, options_.today, options_.partial, options_.is_oracle);
    for (const WorldResult& result : report_.worlds) {
      for (const Diagnostic& error : ErrorsOfClaims(result.scenario))
        report_.faults.push_back(ToString(error) + '.');
    }
    CheckCatalogue(report_);
    return std::move(report_);
  }

 private:
  void EstablishTruth() {
    if (!options_.truths.empty()) return;
    ForEachScenario([this](ScenarioResult& result, std::vector<Finding>&) {
      const Stopwatch watch;
      result.truth = ComputeContactTruth(result.scenario.contact);
      AddSeconds("truth", watch.seconds());
    });
  }

  /** Adds time that contact queries took. May be called from any thread. */
  void AddSeconds(std::string_view kind, double seconds) {
    const std::scoped_lock lock(progress_);
    report_.seconds_of_contacts[std::string(kind)] += seconds;
  }

  void AskQuestions() {
    Round round(oracles_.size());
    for (auto& queries : round.queries) {
      for (const ScenarioResult& r : report_.scenarios)
        queries.push_back(r.scenario.contact);
    }
    round.Ask(oracles_, options_, [this](std::size_t more) {
      Progress(more, kContactWork * static_cast<double>(more));
    });
    for (std::size_t s = 0; s < report_.scenarios.size(); ++s) {
      for (auto& answers : round.answers) {
        AddSeconds("itself", answers[s].seconds);
        report_.scenarios[s].answers.push_back(std::move(answers[s]));
      }
    }
  }

  /** Counts `more` questions and their work [body-steps] as done. May be called from any
   thread. */
  void Progress(std::size_t more, double work) {
    const std::scoped_lock lock(progress_);
    done_ += more;
    work_ += work;
    if (options_.on_progress)
      options_.on_progress(done_, total_,
                           total_ == 0 ? 0 : std::min(1.0, work_ / total_work_));
  }

  void ExplainTheRest() {
    touchstone::ExplainTheRest(report_.scenarios, report_.oracles, report_.findings);
  }

  void RunTheWorlds() {
    WorldsOptions options = options_.worlds;
    options.stop = options_.stop;
    options.jobs = options_.jobs;
    options.on_done = [this](double body_steps) { Progress(1, body_steps); };
    WorldsReport worlds = RunWorlds(world_scenarios_, oracles_, options);
    report_.worlds = std::move(worlds.worlds);
    contact_findings_ = report_.findings.size();
    std::move(worlds.findings.begin(), worlds.findings.end(),
              std::back_inserter(report_.findings));
  }

  /** Withdraws what worlds' files expect against all engines. */
  void DoubtFiles() {
    std::span<Finding> rest = report_.findings;
    rest = rest.subspan(std::min(rest.size(), contact_findings_));
    for (const WorldResult& result : report_.worlds) {
      const auto end = std::ranges::find_if(rest, [&](const Finding& finding) {
        return finding.scenario != result.scenario.id;
      });
      const auto count = static_cast<std::size_t>(end - rest.begin());
      const std::vector<std::string> faults =
          DoubtExpectations(result, report_.oracles, rest.first(count));
      report_.faults.insert(report_.faults.end(), faults.begin(), faults.end());
      rest = rest.subspan(count);
    }
  }

  void Judge() {
    ForEachScenario([this](ScenarioResult& result, std::vector<Finding>& findings) {
      for (std::size_t i = 0; i < oracles_.size(); ++i) {
        if (!report_.oracles[i].AnswersContacts()) continue;
        std::vector<Finding> of_oracle =
            JudgeAnswer(result.scenario, result.truth, report_.oracles[i],
                        result.answers[i], options_.reasons);
        if (findings.empty())
          findings = std::move(of_oracle);
        else
          std::move(of_oracle.begin(), of_oracle.end(), std::back_inserter(findings));
      }
      SettleByConsensus(result, report_.oracles, findings);
    });
  }

  /** Asks the variants of every answered question, all in one round, so that an isolated
   oracle forks only a few times more. */
  void AskVariants() {
    VariantsOfAll own;
    VariantsOfAll& variants = options_.variants ? *options_.variants : own;
    if (variants.empty()) {
      variants.resize(report_.scenarios.size());
      ForEach(variants.size(), [&](std::size_t s) {
        variants[s] = VariantsOf(report_.scenarios[s].scenario);
      });
    }
    Round round(oracles_.size());
    struct Asked {
      std::size_t oracle;
      std::size_t variant;
      std::size_t place;  ///< Index into the queries of the round.
    };
    std::vector<std::vector<Asked>> asked(report_.scenarios.size());
    for (std::size_t i = 0; i < oracles_.size(); ++i) {
      for (std::size_t s = 0; s < report_.scenarios.size(); ++s) {
        const ScenarioResult& result = report_.scenarios[s];
        if (!IsComparable(result, report_.oracles[i], result.answers[i])) continue;
        for (std::size_t v = 0; v < variants[s].size(); ++v) {
          asked[s].push_back({i, v, round.queries[i].size()});
          round.queries[i].push_back(variants[s][v].query);
        }
      }
    }
    round.Ask(oracles_, options_, nullptr);
    ForEach(asked.size(), [&](std::size_t s) {
      const ScenarioResult& result = report_.scenarios[s];
      std::optional<std::size_t> last;
      Tolerances tolerances;  // Those of oracle `last`.
      for (const auto& [i, v, place] : asked[s]) {
        if (last != i) {
          tolerances = TolerancesOf(report_.oracles[i], result.scenario, result.truth,
                                    result.answers[i].touching);
          last = i;
        }
        AddSeconds(NameOf(variants[s][v].measure), round.answers[i][place].seconds);
        auto finding = JudgeVariant(
            result.scenario, result.truth, report_.oracles[i], result.answers[i],
            variants[s][v], round.answers[i][place], tolerances, options_.reasons);
        if (finding) findings_[s].push_back(std::move(*finding));
      }
    });
  }

  /** Sorts findings by oracle, in the order of the report, then by measure. */
  void SortFindings() {
    std::map<std::string_view, std::size_t> places;
    for (std::size_t i = 0; i < oracles_.size(); ++i) places[report_.oracles[i].name] = i;
    ForEachScenario([&](const ScenarioResult&, std::vector<Finding>& findings) {
      // A finding is large: each is moved once.
      std::vector<std::tuple<std::size_t, MeasureKind, std::size_t>> keys;
      keys.reserve(findings.size());
      for (std::size_t f = 0; f < findings.size(); ++f)
        keys.emplace_back(places.at(findings[f].oracle), findings[f].measure, f);
      if (std::is_sorted(keys.begin(), keys.end())) return;
      std::sort(keys.begin(), keys.end());
      std::vector<Finding> sorted;
      sorted.reserve(findings.size());
      for (const auto& key : keys)
        sorted.push_back(std::move(findings[std::get<2>(key)]));
      findings = std::move(sorted);
    });
  }

  /** Marks the failures as kNotExamined that are beyond the limit of the options. */
  void LimitExamination() {
    if (!options_.examined_per_kind) return;
    const std::set<std::size_t> examined = Gravest(*options_.examined_per_kind);
    for (std::size_t s = 0; s < findings_.size(); ++s) {
      if (examined.contains(s)) continue;
      for (Finding& finding : findings_[s]) {
        if (!IsProvedWrong(finding)) continue;
        finding.cause = Cause::kNotExamined;
        finding.cause_because.clear();
      }
    }
  }

  /** Returns the contact queries whose answer by the subject fails, the `most` gravest of
   each kind, see RunOptions::examined_per_kind. */
  std::set<std::size_t> Gravest(std::size_t most) {
    // By −share, such that the gravest comes first, then by the query.
    std::map<std::tuple<Verdict, MeasureKind, Grade>,
             std::set<std::pair<double, std::size_t>>>
        kinds;
    for (std::size_t s = 0; s < findings_.size(); ++s) {
      const ScenarioResult& result = report_.scenarios[s];
      ForEachOracle(findings_[s], [&](std::size_t i, std::span<Finding> of_oracle) {
        if (i != 0) return;
        const Finding& decisive = *DecisiveOf(of_oracle);
        if (!IsFailure(decisive.verdict)) return;
        const double share = ShareOf(decisive, result.scenario.contact, result.truth);
        // A share without a number has no order; the answer is as wrong as can be.
        const double order =
            std::isnan(share) ? -std::numeric_limits<double>::infinity() : -share;
        auto& gravest = kinds[{decisive.verdict, decisive.measure, decisive.grade}];
        gravest.emplace(order, s);
        if (gravest.size() > most) gravest.erase(std::prev(gravest.end()));
      });
    }
    std::set<std::size_t> examined;
    for (const auto& [kind, gravest] : kinds) {
      for (const auto& [order, s] : gravest) examined.insert(s);
    }
    return examined;
  }

  /** Finds the causes that an answer and roundings of its question show. */
  void Explain() {
    TruthsOfNeighbours own;
    TruthsOfNeighbours& truths =
        options_.truths_of_neighbours ? *options_.truths_of_neighbours : own;
    truths.resize(findings_.size());
    ForEach(findings_.size(), [&](std::size_t s) {
      const ScenarioResult& result = report_.scenarios[s];
      ForEachOracle(findings_[s], [&](std::size_t i, std::span<Finding> of_oracle) {
        const OracleInfo& oracle = report_.oracles[i];
        ExplainByAnswer(result, oracle, result.answers[i], of_oracle);
        const ContactQuery& query = result.scenario.contact;
        const double u = oracle.unit_roundoff;
        const auto may_be_rounding = [&](const Finding& finding) {
          return RoundingMayExplain(finding, query, result.truth, u);
        };
        if (std::ranges::none_of(of_oracle, may_be_rounding)) return;
        const std::vector<ContactQuery> neighbours = NeighboursOf(query, u);
        std::vector<ContactTruth>& of_neighbours = truths[s][u];
        if (of_neighbours.empty()) {
          for (const ContactQuery& neighbour : neighbours)
            of_neighbours.push_back(ComputeContactTruth(neighbour));
        }
        ExplainByRounding(result.scenario, oracle, result.answers[i], neighbours,
                          of_neighbours, of_oracle);
      });
    });
  }

  void Collect() {
    std::size_t count = 0;
    for (const std::vector<Finding>& findings : findings_) count += findings.size();
    report_.findings.reserve(count);
    for (std::vector<Finding>& findings : findings_) {
      std::move(findings.begin(), findings.end(), std::back_inserter(report_.findings));
    }
  }

  /** Calls `work(i, findings)` with the sorted findings of each oracle i that has any. */
  template <typename Work>
  void ForEachOracle(std::vector<Finding>& findings, Work work) {
    auto begin = findings.begin();
    for (std::size_t i = 0; i < oracles_.size() && begin != findings.end(); ++i) {
      const auto end = std::find_if(begin, findings.end(), [&](const Finding& finding) {
        return finding.oracle != report_.oracles[i].name;
      });
      if (begin != end) work(i, std::span(begin, end));
      begin = end;
    }
  }

  template <typename Work>
  void ForEachScenario(Work work) {
    ForEach(report_.scenarios.size(),
            [&](std::size_t s) { work(report_.scenarios[s], findings_[s]); });
  }

  /** Calls `work(i)` for every i < count, unless the run is stopped. */
  template <typename Work>
  void ForEach(std::size_t count, Work work) {
    ParallelFor(count, options_.jobs, [&](std::size_t i) {
      if (!IsStopped(options_.stop)) work(i);
    });
  }

  std::vector<WorldScenario> world_scenarios_;
  const std::span<const Oracle* const> oracles_;
  const RunOptions& options_;
  std::mutex progress_;
  std::size_t done_ = 0;
  std::size_t total_ = 0;
  double work_ = 0;        ///< [body-steps]
  double total_work_ = 0;  ///< [body-steps]
  RunReport report_;
  std::vector<std::vector<Finding>> findings_;  ///< Indexed by scenario.
  std::size_t contact_findings_ = 0;            ///< Those before the findings of worlds.
};

}  // namespace

RunReport Run(const Questions& questions, std::span<const Oracle* const> oracles,
              const Ledger& ledger, const RunOptions& options) {
  return Suite(questions.contacts, questions.worlds, oracles, options).Report(ledger);
}

RunReport Run(std::span<const Scenario> scenarios, std::span<const Oracle* const> oracles,
              const Ledger& ledger, const RunOptions& options) {
  return Suite(scenarios, {}, oracles, options).Report(ledger);
}

}  // namespace touchstone
