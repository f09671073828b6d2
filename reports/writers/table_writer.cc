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
#include <fmt/ranges.h>

#include "reports/clusters/clusters.h"
#include "reports/text/counted.h"
#include "reports/text/wrapped.h"
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

void WriteTallies(const RunReport& report, std::span<const Outcome> outcomes,
                  const Painter& paint, std::ostream& out) {
  const std::vector<GroupTally> groups = TallyByGroup(report, outcomes);
  out << Heading(
      paint, groups.size() == 1
                 ? fmt::format("{} ({})", groups.front().group, groups.front().scenarios)
                 : fmt::format("all scenarios ({})", QuestionCount(report)));
  const std::vector<Tally> tallies = TallyByOracle(report, outcomes);
  for (std::size_t o = 0; o < tallies.size(); ++o)
    out << Row(paint, report.oracles[o].name, tallies[o]);
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

/** Returns the width of a text that starts in column 4; 0 wraps nothing. */
std::size_t WidthWithin(const TableStyle& style) {
  return style.width > 4 ? style.width - 4 : 0;
}

void WriteFailures(const RunReport& report, std::span<const Outcome> outcomes,
                   const TableStyle& style, const Painter& paint, std::ostream& out) {
  std::size_t last = QuestionCount(report);
  for (const Outcome& outcome : outcomes) {
    if (!IsFailure(outcome.verdict)) continue;
    if (style.quiet && !CountsAsFailure(outcome, report, style.rule)) continue;
    if (outcome.scenario != last) {
      last = outcome.scenario;
      out << '\n'
          << paint(Colour::kBold, IdOf(report, last))
          << fmt::format(": {}\n", TitleOf(report, last));
    }
    out << "  " << paint(Colour::kBad, "✗") << ' '
        << Wrapped(Sentence(*outcome.decisive), WidthWithin(style), 4) << '\n'
        << AlsoFailing(outcome);
  }
}

void WriteFaults(const RunReport& report, const TableStyle& style, const Painter& paint,
                 std::ostream& out) {
  if (report.faults.empty()) return;
  out << '\n'
      << paint(Colour::kBold,
               ImprovedCount(report) == report.faults.size()
                   ? "Entries of the ledger that hide less than they allow"
                   : "Faults in the scenario files and the ledger, not in an engine")
      << '\n';
  for (const std::string& fault : report.faults) {
    out << "  " << paint(Colour::kBad, "✗") << ' '
        << Wrapped(fault, WidthWithin(style), 4) << '\n';
  }
}

/** Writes what got worse; in a quiet table only what counts. */
void WriteRegressions(const RunReport& report, const TableStyle& style,
                      const Painter& paint, std::ostream& out) {
  bool first = true;
  for (const Regression& regression : report.regressions) {
    if (style.rule.whose == FailOn::kSubject && regression.oracle != report.subject)
      continue;
    if (first) out << '\n' << paint(Colour::kBold, "Worse than in the baseline") << '\n';
    first = false;
    out << "  " << paint(Colour::kBad, "✗") << ' '
        << Wrapped(regression.what, WidthWithin(style), 4) << '\n';
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

/** Returns the colour of a grade. */
Colour ColourOf(Grade grade) {
  if (grade >= Grade::kGross) return Colour::kBad;
  return grade >= Grade::kSmall ? Colour::kKnown : Colour::kDim;
}

/** Writes the gravest clusters, and who was never wrong. */
void WriteClusters(const RunReport& report, std::span<const Outcome> outcomes,
                   const TableStyle& style, const Painter& paint, std::ostream& out) {
  constexpr std::size_t kMost = 10;
  constexpr std::size_t kIndent = 20;
  const std::vector<Cluster> clusters = ClustersOf(report).ranked;
  if (clusters.empty()) return;
  const auto is_new = std::ranges::count(clusters, true, &Cluster::is_new);
  const auto outgrown = std::ranges::count(clusters, true, &Cluster::has_outgrown);
  const std::size_t known = clusters.size() - static_cast<std::size_t>(is_new + outgrown);
  out << '\n'
      << paint(Colour::kBold, "Faults")
      << fmt::format(": {}, {} new, {}{} in the ledger\n", clusters.size(), is_new,
                     outgrown > 0 ? fmt::format("{} larger than known, ", outgrown) : "",
                     known);
  for (std::size_t c = 0; c < std::min(kMost, clusters.size()); ++c) {
    const Cluster& cluster = clusters[c];
    const std::string_view status = cluster.is_new         ? "New: "
                                    : cluster.has_outgrown ? "Larger than known: "
                                                           : "";
    const std::string sentence =
        fmt::format("{}{} {}", status, cluster.title, ExtentOf(report, cluster));
    out << "  "
        << paint(ColourOf(cluster.grade), fmt::format("{:<18}", NameOf(cluster.grade)))
        << Wrapped(std::string(kIndent, ' ') + sentence, style.width, kIndent)
               .substr(kIndent)
        << '\n';
  }
  if (clusters.size() > kMost) {
    out << fmt::format("  and {} more, in the page of --out DIR or --open\n",
                       clusters.size() - kMost);
  }
  std::vector<std::string_view> right;
  const std::vector<Tally> tallies = TallyByOracle(report, outcomes);
  for (std::size_t o = 0; o < tallies.size(); ++o) {
    const VerdictCounts& counts = tallies[o].outcomes;
    if (counts[Verdict::kPass] > 0 && counts.failed() + counts[Verdict::kKnown] == 0)
      right.push_back(report.oracles[o].name);
  }
  if (!right.empty())
    out << fmt::format("Never proved wrong: {}\n", fmt::join(right, ", "));
}

/** Writes a title and a line for each pair of oracle and text, with its count; the sum
 alone in a run of many questions. */
void WriteCounted(const RunReport& report, const Painter& paint, std::string_view title,
                  const std::string& meaning,
                  const std::map<std::pair<std::string_view, std::string_view>, int>& of,
                  std::ostream& out) {
  if (of.empty()) return;
  out << '\n' << paint(Colour::kBold, std::string(title)) << meaning;
  constexpr std::size_t kFew = 20;
  if (QuestionCount(report) > kFew) {
    int all = 0;
    for (const auto& [what, times] : of) all += times;
    out << fmt::format(" {} times, for {}\n", all, Counted(of.size(), "reason"));
    return;
  }
  out << '\n';
  for (const auto& [what, times] : of)
    out << fmt::format("  {:>5}  {}: {}\n", times, what.first, what.second);
}

/** Writes the claims that could not be verified although the oracle simulated the world,
 and the variants that could not be compared with it. */
void WriteUnverified(const RunReport& report, std::span<const Outcome> outcomes,
                     const Painter& paint, std::ostream& out) {
  std::map<std::pair<std::string_view, std::string_view>, int> claims;
  int all = 0;
  for (const Outcome& outcome : outcomes) {
    const auto answered = [](const Finding& finding) {
      return finding.verdict == Verdict::kPass;
    };
    if (std::none_of(outcome.findings.begin(), outcome.findings.end(), answered))
      continue;
    for (const Finding& finding : outcome.findings) {
      if (finding.verdict != Verdict::kUnsupported) continue;
      ++claims[{finding.oracle, finding.proof}];
      ++all;
    }
  }
  WriteCounted(report, paint, "Unverified",
               fmt::format(": {} of worlds",
                           Counted(all, "claim or variant", "claims or variants")),
               claims, out);
}

/** Writes the answers that are right with the settings of the adapter and wrong with the
 engine's own. This is not a failure. */
void WriteShippedOnly(const RunReport& report, std::span<const Outcome> outcomes,
                      const TableStyle& style, const Painter& paint, std::ostream& out) {
  constexpr int kMost = 10;
  int count = 0;
  for (const Outcome& outcome : outcomes) {
    const Finding* finding = FailureAsShippedOnly(outcome);
    if (finding == nullptr || ++count > kMost) continue;
    if (count == 1)
      out << '\n'
          << paint(Colour::kBold, "As shipped only")
          << ": right as set here, wrong with the engine's own settings\n";
    out << "  "
        << Wrapped(fmt::format("{}, {}: {}, {}.", finding->oracle,
                               IdOf(report, outcome.scenario), NameOf(finding->measure),
                               finding->shipped_because),
                   WidthWithin(style), 4)
        << '\n';
  }
  if (count > kMost)
    out << fmt::format(
        "  and {} more, on the pages of the oracles of --out DIR or --open\n",
        count - kMost);
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
  WriteCounted(
      report, paint, "Recognised",
      ": motions beyond the tolerance of the truth that follow another legal model",
      models, out);
}

/** Writes the reasons of unsupported outcomes. */
void WriteUnsupported(const RunReport& report, std::span<const Outcome> outcomes,
                      const Painter& paint, std::ostream& out) {
  std::map<std::pair<std::string_view, std::string_view>, int> reasons;
  for (const Outcome& outcome : outcomes) {
    const std::string_view reason = ReasonOf(report, outcome);
    if (!reason.empty()) ++reasons[{report.oracles[outcome.oracle].name, reason}];
  }
  WriteCounted(report, paint, "Unsupported", "", reasons, out);
}

bool IsTooCoarse(const Outcome& outcome) {
  return outcome.verdict == Verdict::kUndecidable && outcome.decisive != nullptr &&
         outcome.decisive->undecided == Undecided::kCoarse;
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
  const std::size_t contacts = report.scenarios.size();
  if (std::ranges::any_of(outcomes, [&](const Outcome& outcome) {
        return outcome.scenario >= contacts && IsTooCoarse(outcome);
      }))
    out << "tolerance too coarse: at the step of the world a law must allow more than "
           "1 % of the size; a smaller dt allows less\n";
  const auto shipped_only = std::ranges::count_if(outcomes, [](const Outcome& outcome) {
    return FailureAsShippedOnly(outcome) != nullptr;
  });
  if (shipped_only > 0)
    out << fmt::format(
        "as shipped only: {} of the passes fail with the engine's own "
        "settings; --as-shipped judges those\n",
        shipped_only);
  const int code = ExitCode(report, style.rule);
  out << paint(code == 0 ? Colour::kGood : Colour::kBad,
               ConclusionOf(report, outcomes, style.rule))
      << '\n';
  if (code == 2) {
    out << WhyNotExamined(report, outcomes) << "; --subject selects another oracle\n";
  } else if (code == 1 && ExitCode(report, {FailOn::kSubject, style.rule.above}) == 0) {
    out << fmt::format("--fail-on subject counts only the failures of {}\n",
                       report.subject);
  } else if (code == 0 && style.rule.whose == FailOn::kFaults &&
             ExitCode(report, {FailOn::kAnything, style.rule.above}) == 1) {
    out << "failures of references that are rounding, up to 1e-6 of the size, do not "
           "count; --fail-on anything counts them\n";
  } else if (code == 0 && ExitCode(report, {style.rule.whose}) == 1) {
    out << fmt::format("--fail-above: no failure that counts is graver than '{}'\n",
                       NameOf(style.rule.above));
  }
}

}  // namespace

void WriteTable(const RunReport& report, const TableStyle& style, std::ostream& out) {
  const Painter paint(style.colours);
  const std::vector<Outcome> outcomes = OutcomesOf(report);
  if (!style.quiet) WriteTallies(report, outcomes, paint, out);
  WriteFailures(report, outcomes, style, paint, out);
  WriteFaults(report, style, paint, out);
  WriteRegressions(report, style, paint, out);
  const std::string stated = StatedTolerances(report) + WorldSetups(report);
  if (!stated.empty()) out << '\n' << stated;
  if (!style.quiet) {
    WriteDrifts(report, outcomes, paint, out);
    WriteRecognised(report, outcomes, paint, out);
    WriteShippedOnly(report, outcomes, style, paint, out);
    WriteUnverified(report, outcomes, paint, out);
    WriteUnsupported(report, outcomes, paint, out);
    WriteVoidEntries(report, paint, out);
    WriteClusters(report, outcomes, style, paint, out);
  }
  WriteCounts(report, outcomes, style, paint, out);
}

}  // namespace touchstone
