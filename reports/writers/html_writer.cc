#include "reports/writers/html_writer.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "oracles/stated_tolerance.h"
#include "reports/contacts/proof.h"
#include "reports/text/counted.h"
#include "reports/text/format_vector.h"
#include "reports/worlds/study/judge_world.h"
#include "reports/writers/describe.h"
#include "reports/writers/outcome.h"
#include "reports/writers/page_assets.h"
#include "reports/writers/plot.h"
#include "reports/writers/sketch.h"
#include "reports/writers/world_words.h"
#include "reports/writers/xml_text.h"

namespace touchstone {
namespace {

// Every colour has a sign next to it, for readers who cannot see the colour.
std::string_view SignOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPass:
      return "✓";
    case Verdict::kKnown:
      return "≈";
    case Verdict::kUndecidable:
      return "?";
    case Verdict::kUnsupported:
      return "·";
    case Verdict::kFail:
    case Verdict::kDisagree:
    case Verdict::kInvalid:
      return "✗";
    case Verdict::kCrashed:
    case Verdict::kTimedOut:
      return "!";
  }
  return "!";
}

std::string CssClassOf(Verdict verdict) {
  std::string name(NameOf(verdict));
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

std::string ToLower(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

std::string PrecisionOf(const OracleInfo& oracle) {
  std::string precision = oracle.unit_roundoff > 0x1p-40 ? "single" : "double";
  if (!oracle.tolerance.IsZero()) {
    precision += fmt::format("; granted {} beyond rounding, stated by {}",
                             ToString(oracle.tolerance), oracle.tolerance.by);
  }
  if (!oracle.setup.IsDefault()) {
    precision += fmt::format("; worlds {}", ToString(oracle.setup, oracle.parameters));
  }
  return precision;
}

std::string WorstOf(const Finding* worst) {
  if (worst == nullptr) return "";
  return fmt::format("{}: {}", NameOf(worst->measure), RelativeInWords(*worst));
}

/** A column of a table. */
struct Column {
  std::string_view heading;
  bool is_number = false;
};

constexpr auto kOracleColumns = std::to_array<Column>({{"oracle"},
                                                       {"pass", true},
                                                       {"known", true},
                                                       {"failed", true},
                                                       {"undecidable", true},
                                                       {"unsupported", true},
                                                       {"worst"},
                                                       {"library"},
                                                       {"precision"}});
constexpr auto kAnswerColumns = std::to_array<Column>({{"oracle"},
                                                       {"verdict"},
                                                       {"answer"},
                                                       {"separation [m]", true},
                                                       {"error [m]", true},
                                                       {"normal A to B"},
                                                       {"contacts", true},
                                                       {"worst"}});
constexpr auto kMotionColumns =
    std::to_array<Column>({{"oracle"}, {"verdict"}, {"worst"}, {"motion"}});
constexpr auto kLedgerColumns = std::to_array<Column>({{"oracle"},
                                                       {"scenarios"},
                                                       {"hides", true},
                                                       {"of", true},
                                                       {"worst accepted"},
                                                       {"cause"},
                                                       {"reason"},
                                                       {"upstream"},
                                                       {"expires"}});

/** Returns the start of a table, up to its first row. */
std::string TableHead(std::string_view css_class, std::span<const Column> columns) {
  std::string head =
      fmt::format("<div class=\"scroll\"><table class=\"{}\">\n<thead><tr>", css_class);
  for (const Column& column : columns) {
    head +=
        fmt::format("<th{}>{}", column.is_number ? " class=\"n\"" : "", column.heading);
  }
  return head + "</tr></thead>\n";
}

/** Returns the CSS rules that label the cells of each column but the first with its
 heading: on a phone, page.css shows each row as a card and hides the headings. */
std::string CardLabels(std::string_view css_class, std::span<const Column> columns) {
  std::string rules;
  for (std::size_t i = 1; i < columns.size(); ++i) {
    rules += fmt::format("  .{} td:nth-child({})::before {{ content: \"{} \"; }}\n",
                         css_class, i + 1, columns[i].heading);
  }
  return rules;
}

/** Returns a cell with the count, in the colour of its verdict unless it is zero. */
std::string CountCell(int count, std::string_view css_class) {
  return fmt::format("<td class=\"n {}\">{}", count == 0 ? "soft" : css_class, count);
}

/** Returns an id with optional line breaks after its levels and words. */
std::string Breakable(const std::string& id) {
  std::string text;
  for (const char c : id) {
    text += c;
    if (c == '/' || c == '_') text += "<wbr>";
  }
  return text;
}

class Page {
 public:
  Page(const RunReport& report, std::ostream& out)
      : report_(report), out_(out), outcomes_(OutcomesOf(report)) {}

  void Write() {
    out_ << "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
            "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
    out_ << fmt::format("<title>Touchstone: {}</title>\n", XmlText(report_.subject));
    out_ << "<style>\n"
         << kPageCss << "@media (max-width: 50rem) {\n"
         << CardLabels("oracles", kOracleColumns) << CardLabels("answers", kAnswerColumns)
         << CardLabels("motions", kMotionColumns) << CardLabels("ledger", kLedgerColumns)
         << "}\n</style>\n</head>\n<body>\n";
    WriteSummary();
    WriteOracles();
    WriteFaults();
    WriteRegressions();
    WriteScenarios();
    WriteLedger();
    out_ << "<script>\n" << kPageJs << "</script>\n</body>\n</html>\n";
  }

 private:
  void WriteSummary() {
    VerdictCounts counts;
    for (const Outcome& outcome : outcomes_) {
      Count(outcome, counts);
    }
    const VerdictCounts subject = TallyByOracle(report_, outcomes_).front().outcomes;
    const std::string scenarios = Counted(QuestionCount(report_), "scenario");
    out_ << fmt::format("<h1>Is {} right?</h1>\n", XmlText(report_.subject));
    const std::string unexamined = WhyNotExamined(report_, outcomes_);
    if (subject.failed() > 0) {
      out_ << fmt::format(
          "<p><b class=\"fail\">No</b>: wrong, or without an answer, in {} of "
          "{}.</p>\n",
          subject.failed(), scenarios);
    } else if (!unexamined.empty()) {
      out_ << fmt::format("<p><b class=\"fail\">Nothing was verified</b>: {}.</p>\n",
                          XmlText(unexamined));
    } else {
      out_ << fmt::format(
          "<p><b class=\"pass\">No error was found</b>: {} of {} "
          "passed, {} with known discrepancies, {} undecidable, {} unsupported.</p>\n",
          subject[Verdict::kPass], scenarios, subject[Verdict::kKnown],
          subject[Verdict::kUndecidable], subject[Verdict::kUnsupported]);
    }
    if (!report_.faults.empty()) {
      out_ << "<p><b class=\"fail\">The scenario files or the ledger have "
              "faults</b>, listed below.</p>\n";
    }
    const std::string failed = FailedReferences(report_, outcomes_);
    if (!failed.empty()) {
      out_ << fmt::format(
          "<p><b class=\"fail\">References are wrong</b>: {}. This fails the run too, "
          "except with <code>--fail-on subject</code>.</p>\n",
          XmlText(failed));
    }
    out_ << fmt::format("<p>{}, {}.", scenarios,
                        Counted(report_.oracles.size(), "oracle"));
    for (int i = 0; i < kVerdicts; ++i) {
      const Verdict verdict = static_cast<Verdict>(i);
      if (counts[verdict] == 0) continue;
      out_ << fmt::format(" <span class=\"v {}\">{} {} {}</span>", CssClassOf(verdict),
                          SignOf(verdict), counts[verdict], NameOf(verdict));
      if (verdict == Verdict::kUndecidable)
        out_ << fmt::format(" ({})", UndecidedInWords(counts));
    }
    out_ << "</p>\n";
  }

  void WriteOracles() {
    out_ << "<h2>Oracles</h2>\n" << TableHead("oracles", kOracleColumns);
    const std::vector<Tally> tallies = TallyByOracle(report_, outcomes_);
    for (std::size_t o = 0; o < tallies.size(); ++o) {
      const OracleInfo& oracle = report_.oracles[o];
      const VerdictCounts& counts = tallies[o].outcomes;
      out_ << fmt::format(
          "<tr><td>{}{}{}{}{}{}{}<td>{}<td>{} {}<td>{}</tr>\n", XmlText(oracle.name),
          o == 0 ? " <b>(subject)</b>" : "", CountCell(counts[Verdict::kPass], "pass"),
          CountCell(counts[Verdict::kKnown], "known"), CountCell(counts.failed(), "fail"),
          CountCell(counts[Verdict::kUndecidable], "undecidable"),
          CountCell(counts[Verdict::kUnsupported], "unsupported"),
          WorstOf(tallies[o].worst), XmlText(oracle.library), XmlText(oracle.version),
          XmlText(PrecisionOf(oracle)));
    }
    out_ << "</table></div>\n";
  }

  void WriteFaults() {
    if (report_.faults.empty()) return;
    out_ << "<h2>Faults in the scenario files and the ledger, not in an "
            "engine</h2>\n<ul>\n";
    for (const std::string& fault : report_.faults) {
      out_ << fmt::format("<li class=\"fail\">{}\n", XmlText(fault));
    }
    out_ << "</ul>\n";
  }

  void WriteRegressions() {
    if (report_.regressions.empty()) return;
    out_ << "<h2>Worse than in the baseline</h2>\n<ul>\n";
    for (const Regression& regression : report_.regressions)
      out_ << fmt::format("<li class=\"fail\">{}\n", XmlText(regression.what));
    out_ << "</ul>\n";
  }

  void WriteFilter() {
    out_ << "<form id=\"filter\"><input id=\"text\" type=\"search\" placeholder=\"filter "
            "by id "
            "or title\" aria-label=\"filter by id or title\">\n<select id=\"oracle\" "
            "aria-label=\"oracle\"><option value=\"\">any oracle</option>";
    for (std::size_t o = 0; o < report_.oracles.size(); ++o) {
      out_ << fmt::format("<option value=\"{}\">{}</option>", o,
                          XmlText(report_.oracles[o].name));
    }
    out_ << "</select>\n<select id=\"verdict\" aria-label=\"verdict\">"
            "<option value=\"\">any verdict</option>"
            "<option value=\"fail disagree crashed timed_out invalid\">failed</option>";
    for (const Verdict verdict : {Verdict::kKnown, Verdict::kUndecidable,
                                  Verdict::kUnsupported, Verdict::kPass}) {
      out_ << fmt::format("<option value=\"{}\">{}</option>", CssClassOf(verdict),
                          NameOf(verdict));
    }
    out_ << "</select>\n<output id=\"count\"></output></form>\n";
  }

  /** Lists the oracles in the order of the signs of a strip. */
  void WriteLegend() {
    out_ << "<details><summary>Order of the signs</summary>\n<ol class=\"legend\">\n";
    for (const OracleInfo& oracle : report_.oracles)
      out_ << fmt::format("<li>{}\n", XmlText(oracle.name));
    out_ << "</ol></details>\n";
  }

  void WriteScenarios() {
    out_
        << "<h2>Scenarios</h2>\n<p class=\"soft\">Each oracle has one sign, in the order "
           "of the table above: ✓ pass, ✗ proved wrong, ! no answer, ≈ known, "
           "? undecidable, · unsupported. Filled dots are the contacts of the subject, "
           "rings those of the other oracles, and dashed lines the planes of the "
           "certificate. In world plots the uncoloured dashed line is the truth and the "
           "shaded band its tolerance.</p>\n";
    WriteLegend();
    WriteFilter();
    for (std::size_t s = 0; s < report_.scenarios.size(); ++s) WriteScenario(s);
    for (std::size_t w = 0; w < report_.worlds.size(); ++w) WriteWorld(w);
  }

  std::span<const Outcome> OutcomesIn(std::size_t scenario) const {
    return std::span(outcomes_).subspan(scenario * report_.oracles.size(),
                                        report_.oracles.size());
  }

  /** Opens the section of question `index`, up to its first content. */
  void OpenSection(std::size_t index) {
    std::string verdicts;
    std::string chips;
    for (const Outcome& outcome : OutcomesIn(index)) {
      const std::string css_class = CssClassOf(outcome.verdict);
      verdicts += (verdicts.empty() ? "" : " ") + css_class;
      chips += fmt::format("<span class=\"{}\" title=\"{}: {}\">{}</span>", css_class,
                           XmlText(report_.oracles[outcome.oracle].name),
                           outcome.asked ? VerdictInWords(outcome) : "not queried",
                           SignOf(outcome.verdict));
    }
    const std::string id = XmlText(IdOf(report_, index));
    const std::string& title = TitleOf(report_, index);
    out_ << fmt::format(
        "<details class=\"scenario\" id=\"{0}\" data-outcomes=\"{1}\" data-text=\"{2}\">"
        "<summary><code>{5}</code><span>{3}</span><span "
        "class=\"chips\">{4}</span></summary>\n"
        "<div>",
        id, verdicts, XmlText(ToLower(IdOf(report_, index) + " " + title)),
        XmlText(title), chips, Breakable(id));
  }

  void WriteScenario(std::size_t index) {
    const ScenarioResult& result = report_.scenarios[index];
    const Scenario& scenario = result.scenario;
    const std::span<const Outcome> outcomes = OutcomesIn(index);
    OpenSection(index);
    out_ << "<div class=\"views\">"
         << Sketch(scenario.contact, result.truth, result.answers, SketchView::kWhole)
         << Sketch(scenario.contact, result.truth, result.answers, SketchView::kClose)
         << "</div>\n";
    out_ << fmt::format("<p>A: {}<br>B: {}</p>\n<p><b>Truth.</b> {}</p>\n",
                        Describe(scenario.contact.A), Describe(scenario.contact.B),
                        XmlText(Describe(result.scenario.contact, result.truth)));
    if (!scenario.source.empty()) {
      out_ << fmt::format("<p class=\"soft\">Source: {}</p>\n", XmlText(scenario.source));
    }
    WriteAnswers(result, outcomes);
    WriteFindings(outcomes);
    out_ << "</div></details>\n";
  }

  void WriteWorld(std::size_t w) {
    const WorldResult& world = report_.worlds[w];
    const WorldScenario& scenario = world.scenario;
    const std::size_t index = report_.scenarios.size() + w;
    const std::span<const Outcome> outcomes = OutcomesIn(index);
    OpenSection(index);
    out_ << "<div class=\"views\">";
    for (const CurveSet& set : CurvesOf(world)) out_ << Plot(set, BandOf(set, outcomes));
    out_ << fmt::format("</div>\n<p>{}<br><b>Laws.</b> {}</p>\n",
                        XmlText(Describe(scenario.world)), XmlText(ClaimsOf(scenario)));
    if (!scenario.source.empty()) {
      out_ << fmt::format("<p class=\"soft\">Source: {}</p>\n", XmlText(scenario.source));
    }
    out_ << TableHead("motions", kMotionColumns);
    for (std::size_t o = 0; o < report_.oracles.size(); ++o) {
      if (!outcomes[o].asked) continue;
      const Trajectory& trajectory = world.trajectories[o];
      const std::string_view model = RecognisedModelOf(outcomes[o]);
      out_ << fmt::format(
          "<tr><td><i class=\"swatch {}\"></i>{}<td class=\"v {}\">{} "
          "{}{}<td>{}<td>{}"
          "</tr>\n",
          LineClass(o), XmlText(report_.oracles[o].name), CssClassOf(outcomes[o].verdict),
          SignOf(outcomes[o].verdict), VerdictInWords(outcomes[o]),
          model.empty() ? "" : fmt::format(", recognised: {}", XmlText(model)),
          WorstOf(outcomes[o].worst),
          XmlText(trajectory.status == AnswerStatus::kAnswered
                      ? Strays(world, o, outcomes[o]) + PrintedBy(trajectory)
                      : trajectory.reason));
    }
    out_ << "</table></div>\n";
    WriteFindings(outcomes);
    out_ << "</div></details>\n";
  }

  /** Returns where a motion departs from the subject's, and its drifts. */
  std::string Strays(const WorldResult& world, std::size_t o,
                     const Outcome& outcome) const {
    const std::string parting = Parting(report_, world, o);
    return parting + (parting.empty() ? "" : "; ") +
           DriftsInWords(world, o, outcome.findings);
  }

  /** Returns the tolerance of the subject's finding for the measure of the curves; 0 if
   there is none. */
  static double BandOf(const CurveSet& set, std::span<const Outcome> outcomes) {
    for (const Finding& finding : outcomes.front().findings) {
      if (set.truth && finding.measure == set.measure) return finding.tolerance;
    }
    return 0;
  }

  void WriteAnswers(const ScenarioResult& result, std::span<const Outcome> outcomes) {
    out_ << TableHead("answers", kAnswerColumns);
    for (std::size_t o = 0; o < report_.oracles.size(); ++o) {
      const ContactAnswer& answer = result.answers[o];
      const Outcome& outcome = outcomes[o];
      out_ << fmt::format("<tr><td>{}<td class=\"v {}\">{} {}",
                          XmlText(report_.oracles[o].name), CssClassOf(outcome.verdict),
                          SignOf(outcome.verdict), VerdictInWords(outcome));
      if (answer.status != AnswerStatus::kAnswered) {
        out_ << fmt::format("<td colspan=\"6\" class=\"soft\">{}</tr>\n",
                            XmlText(answer.reason));
        continue;
      }
      out_ << fmt::format(
          "<td>{}<td class=\"n\">{}<td class=\"n\">{}<td>{}<td "
          "class=\"n\">{}<td>{}</tr>\n",
          answer.touching ? "touching" : "apart",
          answer.separation ? fmt::format("{:.9g}", *answer.separation) : "",
          answer.separation
              ? fmt::format("{:.2g}", LeastError(*answer.separation, result.truth))
              : "",
          answer.n_AB_W ? FormatVector(*answer.n_AB_W, 6) : "", answer.points.size(),
          WorstOf(outcome.worst));
    }
    out_ << "</table></div>\n";
  }

  void WriteFindings(std::span<const Outcome> outcomes) {
    std::string items;
    for (const Outcome& outcome : outcomes) {
      for (const Finding& finding : outcome.findings) {
        if (finding.verdict == Verdict::kUnsupported ||
            (finding.verdict == Verdict::kPass && RecognisedModelOf(finding).empty() &&
             finding.shipped != Shipped::kShippedOnly)) {
          continue;
        }
        items += fmt::format("<li><span class=\"{}\">{}</span> {}{}\n",
                             CssClassOf(finding.verdict), SignOf(finding.verdict),
                             XmlText(Sentence(finding)), LedgerReason(finding));
      }
    }
    if (!items.empty()) out_ << "<ul>\n" << items << "</ul>\n";
  }

  std::string LedgerReason(const Finding& finding) const {
    if (!finding.ledger_entry) return "";
    const int index = *finding.ledger_entry;
    return fmt::format(
        " <a href=\"#ledger-{}\">Ledger</a>: {}", index,
        XmlText(report_.ledger.entries[static_cast<std::size_t>(index)].reason));
  }

  static std::string WorstOfAccepted(const LedgerEntry& entry, const LedgerUse& use) {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < entry.measures.size(); ++i) {
      std::string line(NameOf(entry.measures[i]));
      const LedgerUse::Hidden& hidden = use.hidden[i];
      if (hidden.bound > 0)
        line += fmt::format(" {:.3g} of {:.3g}", hidden.worst, hidden.bound);
      lines.push_back(std::move(line));
    }
    return fmt::format("{}", fmt::join(lines, "<br>"));
  }

  void WriteLedger() {
    if (std::ranges::all_of(report_.ledger_use,
                            [](const LedgerUse& use) { return use.candidates == 0; })) {
      return;
    }
    out_ << "<h2>Ledger of known discrepancies</h2>\n"
         << TableHead("ledger", kLedgerColumns);
    int untested = 0;
    for (std::size_t i = 0; i < report_.ledger.entries.size(); ++i) {
      const LedgerEntry& entry = report_.ledger.entries[i];
      const LedgerUse& use = report_.ledger_use[i];
      if (use.candidates == 0) {
        ++untested;
        continue;
      }
      out_ << fmt::format(
          "<tr id=\"ledger-{}\"><td>{} {}<td>{}<td class=\"n\">{}<td class=\"n\">{}"
          "<td>{}<td>{}<td>{}<td>{}<td>{}</tr>\n",
          i, XmlText(entry.oracle), XmlText(entry.version),
          XmlText(fmt::format("{}", fmt::join(entry.scenarios, ", "))), use.findings(),
          use.candidates, WorstOfAccepted(entry, use), CausesOf(entry),
          XmlText(entry.reason), XmlText(entry.upstream), XmlText(entry.expires));
    }
    out_ << "</table></div>\n";
    if (untested > 0) {
      out_ << fmt::format(
          "<p class=\"soft\">{} not tested by this run.</p>\n",
          untested == 1 ? "1 entry was" : fmt::format("{} entries were", untested));
    }
  }

  const RunReport& report_;
  std::ostream& out_;
  std::vector<Outcome> outcomes_;
};

}  // namespace

void WriteHtml(const RunReport& report, std::ostream& out) {
  Page(report, out).Write();
}

}  // namespace touchstone
