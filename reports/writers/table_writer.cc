#include "reports/writers/table_writer.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "reports/text/counted.h"
#include "reports/writers/conclusion.h"
#include "reports/writers/outcome.h"
#include "reports/writers/world_words.h"

namespace touchstone {
namespace {

enum class Colour { kPlain, kGood, kBad, kKnown, kDim, kBold };

class Painter {
 public:
  explicit Painter(bool colours) : colours_(colours) {}

  std::string operator()(Colour colour, std::string text) const {
    if (!colours_ || colour == Colour::kPlain) return text;
    return fmt::format("\x1b[{}m{}\x1b[0m", Code(colour), text);
  }

 private:
  static std::string_view Code(Colour colour) {
    switch (colour) {
      case Colour::kPlain:
        return "0";
      case Colour::kGood:
        return "32";
      case Colour::kBad:
        return "1;31";
      case Colour::kKnown:
        return "33";
      case Colour::kDim:
        return "2";
      case Colour::kBold:
        return "1";
    }
    return "0";
  }

  bool colours_;
};

// Returns a count for a column; zero is a dim dot.
std::string Count(const Painter& paint, Colour colour, int count, int width) {
  const std::string text = count == 0 ? "." : fmt::format("{}", count);
  return paint(count == 0 ? Colour::kDim : colour, fmt::format("{:>{}}", text, width));
}

std::string Worst(const Tally& tally) {
  if (tally.worst == nullptr) return "";
  const Finding& worst = *tally.worst;
  const double relative = RelativeToTolerance(worst);
  // A value has no multiple of a zero tolerance.
  const std::string text =
      std::isfinite(relative)
          ? fmt::format("{:.2g}", relative)
          : fmt::format("{:.3g} > {:.3g}", worst.value, worst.tolerance);
  return fmt::format("{:>9}  {}", text, NameOf(worst.measure));
}

std::string Row(const Painter& paint, std::string_view name, const Tally& tally) {
  const VerdictCounts& counts = tally.outcomes;
  return fmt::format("  {:<28}{}{}{}{}{} {}\n", name,
                     Count(paint, Colour::kGood, counts[Verdict::kPass], 7),
                     Count(paint, Colour::kKnown, counts[Verdict::kKnown], 7),
                     Count(paint, Colour::kBad, counts.failed(), 8),
                     Count(paint, Colour::kPlain, counts[Verdict::kUndecidable], 12),
                     Count(paint, Colour::kPlain, counts[Verdict::kUnsupported], 13),
                     Worst(tally));
}

std::string Heading(const Painter& paint, std::string_view title) {
  return paint(Colour::kBold, fmt::format("{:<30}{:>7}{:>7}{:>8}{:>12}{:>13} {:>9}  {}\n",
                                          title, "pass", "known", "failed", "undecidable",
                                          "unsupported", "worst/tol", "measure"));
}

// References without failures and known discrepancies share one row.
bool IsWorthARow(std::size_t oracle, const Tally& tally) {
  return oracle == 0 || tally.outcomes.failed() > 0 ||
         tally.outcomes[Verdict::kKnown] > 0;
}

void WriteGroup(const RunReport& report, const GroupTally& group, const Painter& paint,
                std::ostream& out) {
  out << Heading(paint, fmt::format("{} ({})", group.group, group.scenarios));
  Tally folded;
  int others = 0;
  for (std::size_t o = 0; o < group.oracles.size(); ++o) {
    if (IsWorthARow(o, group.oracles[o])) {
      out << Row(paint, report.oracles[o].name, group.oracles[o]);
    } else {
      folded.Add(group.oracles[o]);
      ++others;
    }
  }
  if (others > 0) out << Row(paint, Counted(others, "other"), folded);
}

void WriteTallies(const RunReport& report, std::span<const Outcome> outcomes,
                  const Painter& paint, std::ostream& out) {
  const std::vector<GroupTally> groups = TallyByGroup(report, outcomes);
  // The table of a single group is also the table of all scenarios.
  std::string all = fmt::format("all scenarios ({})", QuestionCount(report));
  if (groups.size() == 1) {
    all = fmt::format("{} ({})", groups.front().group, groups.front().scenarios);
  } else {
    for (const GroupTally& group : groups) WriteGroup(report, group, paint, out);
    out << '\n';
  }
  out << Heading(paint, all);
  const std::vector<Tally> tallies = TallyByOracle(report, outcomes);
  for (std::size_t o = 0; o < tallies.size(); ++o) {
    out << Row(paint, report.oracles[o].name, tallies[o]);
  }
}

// Returns the other measures that fail next to the decisive one, so that one wrong answer
// is one entry.
std::string AlsoFailing(const Outcome& outcome) {
  std::string names;
  for (const Finding& finding : outcome.findings) {
    if (&finding == outcome.decisive || !IsFailure(finding.verdict)) continue;
    names += fmt::format("{}{} {}", names.empty() ? "" : ", ", NameOf(finding.measure),
                         RelativeInWords(finding));
  }
  return names.empty() ? "" : fmt::format("      also: {}\n", names);
}

void WriteFailures(const RunReport& report, std::span<const Outcome> outcomes,
                   const TableStyle& style, const Painter& paint, std::ostream& out) {
  const bool only_subject = style.quiet && style.fail_on == FailOn::kSubject;
  std::size_t last = QuestionCount(report);
  for (const Outcome& outcome : outcomes) {
    if (!IsFailure(outcome.verdict)) continue;
    if (only_subject && report.oracles[outcome.oracle].name != report.subject) continue;
    if (outcome.scenario != last) {
      last = outcome.scenario;
      out << '\n'
          << paint(Colour::kBold, IdOf(report, last))
          << fmt::format(": {}\n", TitleOf(report, last));
    }
    out << "  " << paint(Colour::kBad, "✗") << ' ' << Sentence(*outcome.decisive) << '\n'
        << AlsoFailing(outcome);
  }
}

void WriteFaults(const RunReport& report, const Painter& paint, std::ostream& out) {
  if (report.faults.empty()) return;
  out << '\n'
      << paint(Colour::kBold,
               "Faults in the scenario files and the ledger, not in an engine")
      << '\n';
  for (const std::string& fault : report.faults) {
    out << "  " << paint(Colour::kBad, "✗") << ' ' << fault << '\n';
  }
}

/** Writes what got worse; in a quiet table only what counts. */
void WriteRegressions(const RunReport& report, const TableStyle& style,
                      const Painter& paint, std::ostream& out) {
  bool first = true;
  for (const Regression& regression : report.regressions) {
    if (style.fail_on == FailOn::kSubject && regression.oracle != report.subject)
      continue;
    if (first) out << '\n' << paint(Colour::kBold, "Worse than in the baseline") << '\n';
    first = false;
    out << "  " << paint(Colour::kBad, "✗") << ' ' << regression.what << '\n';
  }
}

/** Writes the entries that excuse nothing because they are for another version of their
 library, one line per oracle and version. */
void WriteVoidEntries(const RunReport& report, const Painter& paint, std::ostream& out) {
  std::map<std::pair<std::string_view, std::string_view>, std::size_t> voided;
  for (std::size_t i = 0; i < report.ledger.entries.size(); ++i) {
    const LedgerEntry& entry = report.ledger.entries[i];
    if (report.ledger_use[i].voided) ++voided[{entry.oracle, entry.version}];
  }
  for (const auto& [which, count] : voided) {
    const auto& [oracle, version] = which;
    const auto info = std::ranges::find(report.oracles, oracle, &OracleInfo::name);
    out << '\n'
        << paint(Colour::kBold, "Ledger")
        << fmt::format(": {} for {} {} excuse{} nothing: its version here is {}\n",
                       Counted(count, "entry", "entries"), oracle, version,
                       count == 1 ? "s" : "", info->version);
  }
}

void WriteLedger(const RunReport& report, const Painter& paint, std::ostream& out) {
  WriteVoidEntries(report, paint, out);
  int hidden = 0;
  std::size_t hiding = 0;
  std::size_t untested = 0;
  for (const LedgerUse& use : report.ledger_use) {
    hidden += use.findings();
    if (use.findings() > 0) ++hiding;
    if (use.candidates == 0) ++untested;
  }
  // No entry applies to the questions of this run.
  const std::size_t entries = report.ledger.entries.size();
  if (untested == entries) return;
  out << '\n'
      << paint(Colour::kBold, "Ledger")
      << fmt::format(": {} of {} hide{} {}; {} tested by this run\n", hiding,
                     Counted(entries, "entry", "entries"), hiding == 1 ? "s" : "",
                     Counted(hidden, "finding"),
                     untested == 1 ? "1 was not" : fmt::format("{} were not", untested));
  if (hidden == 0) return;
  // One line per reason: an entry covers one pair of shapes, a reason often several.
  struct Hidden {
    const LedgerEntry* entry;
    int findings = 0;
  };
  std::vector<Hidden> reasons;
  for (std::size_t i = 0; i < report.ledger.entries.size(); ++i) {
    const LedgerEntry& entry = report.ledger.entries[i];
    const int hidden_by_it = report.ledger_use[i].findings();
    if (hidden_by_it == 0) continue;
    auto same = std::find_if(reasons.begin(), reasons.end(), [&](const Hidden& other) {
      return other.entry->oracle == entry.oracle && other.entry->reason == entry.reason;
    });
    if (same == reasons.end()) same = reasons.insert(same, {&entry});
    same->findings += hidden_by_it;
  }
  for (const auto& [entry, findings] : reasons) {
    out << fmt::format("  {:>5}  {} {}: {} ({})\n", findings, entry->oracle,
                       entry->version, entry->reason, entry->upstream);
  }
  out << "  For the proof of each: touchstone explain ID, or the page of --out DIR.\n";
}

/** Writes a line for each pair of oracle and text, with its count. */
void WriteCounted(const std::map<std::pair<std::string_view, std::string_view>, int>& of,
                  std::ostream& out) {
  for (const auto& [what, times] : of)
    out << fmt::format("  {:>5}  {}: {}\n", times, what.first, what.second);
}

/** Writes the claims that could not be verified although the oracle simulated the world.
 */
void WriteUnverified(std::span<const Outcome> outcomes, const Painter& paint,
                     std::ostream& out) {
  std::map<std::pair<std::string_view, std::string_view>, int> claims;
  int all = 0;
  for (const Outcome& outcome : outcomes) {
    const auto answered = [](const Finding& finding) {
      return finding.verdict == Verdict::kPass;
    };
    if (std::none_of(outcome.findings.begin(), outcome.findings.end(), answered))
      continue;
    for (const Finding& finding : outcome.findings) {
      if (finding.verdict != Verdict::kUnsupported || finding.reference != "law")
        continue;
      ++claims[{finding.oracle, finding.proof}];
      ++all;
    }
  }
  if (all == 0) return;
  out << '\n'
      << paint(Colour::kBold, "Unverified")
      << fmt::format(": {} of worlds\n", Counted(all, "claim"));
  WriteCounted(claims, out);
}

/** Writes the drifts and depths of a run that asks about a single world. */
void WriteDrifts(const RunReport& report, std::span<const Outcome> outcomes,
                 const Painter& paint, std::ostream& out) {
  if (report.worlds.size() != 1 || QuestionCount(report) != 1) return;
  out << '\n'
      << paint(Colour::kBold, "Measured")
      << ": drifts and depths of everything that moves, with what a law allows\n";
  for (const Outcome& outcome : outcomes) {
    if (!outcome.asked) continue;
    const std::string drifts =
        DriftsInWords(report.worlds.front(), outcome.oracle, outcome.findings);
    if (!drifts.empty())
      out << fmt::format("  {:<26} {}\n", report.oracles[outcome.oracle].name, drifts);
  }
}

/** Writes the motions that follow another legal model than the truth's. This is not a
 failure. */
void WriteRecognised(const RunReport& report, std::span<const Outcome> outcomes,
                     const Painter& paint, std::ostream& out) {
  std::map<std::pair<std::string_view, std::string_view>, int> models;
  for (const Outcome& outcome : outcomes) {
    const std::string_view model = RecognisedModelOf(outcome);
    if (!model.empty()) ++models[{report.oracles[outcome.oracle].name, model}];
  }
  if (models.empty()) return;
  out << '\n'
      << paint(Colour::kBold, "Recognised")
      << ": motions beyond the tolerance of the truth that follow another legal model\n";
  WriteCounted(models, out);
}

/** Writes the reasons of unsupported outcomes. */
void WriteUnsupported(const RunReport& report, std::span<const Outcome> outcomes,
                      const Painter& paint, std::ostream& out) {
  std::map<std::pair<std::string_view, std::string_view>, int> reasons;
  for (const Outcome& outcome : outcomes) {
    const std::string_view reason = ReasonOf(report, outcome);
    if (!reason.empty()) ++reasons[{report.oracles[outcome.oracle].name, reason}];
  }
  if (reasons.empty()) return;
  out << '\n' << paint(Colour::kBold, "Unsupported") << '\n';
  WriteCounted(reasons, out);
}

void WriteCounts(const RunReport& report, std::span<const Outcome> outcomes,
                 const TableStyle& style, const Painter& paint, std::ostream& out) {
  VerdictCounts counts;
  VerdictCounts of_subject;
  for (const Outcome& outcome : outcomes) {
    touchstone::Count(outcome, counts);
    if (outcome.oracle == 0) ++of_subject[outcome.verdict];
  }
  std::string list;
  for (int i = 0; i < kVerdicts; ++i) {
    const Verdict verdict = static_cast<Verdict>(i);
    list += fmt::format("{}{} {}", i == 0 ? "" : ", ", counts[verdict], NameOf(verdict));
    if (verdict == Verdict::kUndecidable && counts[verdict] > 0)
      list += fmt::format(" ({})", UndecidedInWords(counts));
  }
  out << fmt::format("\n{} × {}: {}\n", Counted(QuestionCount(report), "scenario"),
                     Counted(report.oracles.size(), "oracle"), list);
  const int code = ExitCode(report, style.fail_on);
  out << paint(code == 0 ? Colour::kGood : Colour::kBad,
               ConclusionOf(report, outcomes, style.fail_on))
      << '\n';
  if (counts[Verdict::kKnown] > 0) {
    out << paint(Colour::kKnown,
                 fmt::format(
                     "also wrong, but known to the ledger: {} in {}, references in {}",
                     report.subject, Counted(of_subject[Verdict::kKnown], "scenario"),
                     Counted(counts[Verdict::kKnown] - of_subject[Verdict::kKnown],
                             "answer")))
        << '\n';
  }
  if (code == 2) {
    out << WhyNotExamined(report, outcomes) << "; --subject selects another oracle\n";
  } else if (code == 1 && ExitCode(report, FailOn::kSubject) == 0) {
    out << fmt::format("--fail-on subject counts only the failures of {}\n",
                       report.subject);
  }
}

}  // namespace

void WriteTable(const RunReport& report, const TableStyle& style, std::ostream& out) {
  const Painter paint(style.colours);
  const std::vector<Outcome> outcomes = OutcomesOf(report);
  if (!style.quiet) WriteTallies(report, outcomes, paint, out);
  WriteFailures(report, outcomes, style, paint, out);
  WriteFaults(report, paint, out);
  WriteRegressions(report, style, paint, out);
  const std::string stated = StatedTolerances(report) + WorldSetups(report);
  if (!stated.empty()) out << '\n' << stated;
  if (!style.quiet) {
    WriteDrifts(report, outcomes, paint, out);
    WriteRecognised(report, outcomes, paint, out);
    WriteUnverified(outcomes, paint, out);
    WriteUnsupported(report, outcomes, paint, out);
    WriteLedger(report, paint, out);
  }
  WriteCounts(report, outcomes, style, paint, out);
}

}  // namespace touchstone
