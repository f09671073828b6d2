#include "reports/shrink/shrunk_file.h"

#include <string_view>

#include <fmt/format.h>

#include "reports/shrink/shifts.h"
#include "reports/text/commented.h"
#include "reports/text/counted.h"
#include "reports/writers/outcome.h"

namespace touchstone {
namespace {

std::string Comment(const std::string& text) {
  return Commented(text, "# ");
}

}  // namespace

Question ScenarioOf(const Shrunk& shrunk, const Question& original) {
  Question question = shrunk.question;
  const Finding& finding = shrunk.finding;
  std::visit(
      [&](auto& scenario) {
        scenario.id = IdOf(original) + "_shrunk";
        scenario.title =
            fmt::format("{} fails {}", finding.oracle, NameOf(finding.measure));
        scenario.source =
            fmt::format("Shrunk from {} by touchstone shrink", IdOf(original));
        scenario.indicts = {Indictment{.oracle = finding.oracle,
                                       .measures = {finding.measure},
                                       .anomaly = finding.proof,
                                       .reproduces = true}};
      },
      question);
  return question;
}

std::string FileOf(const Shrunk& shrunk, const Question& original) {
  const std::string_view measure = NameOf(shrunk.finding.measure);
  return Comment(fmt::format(
             "Shrunk by `touchstone shrink {} --oracle {} {}`: {} asked, {} kept{}.",
             IdOf(original), shrunk.finding.oracle,
             shrunk.over ? fmt::format("--keep '{} > {}'", measure, *shrunk.over)
                         : fmt::format("--measure {}", measure),
             Counted(shrunk.tried, "smaller question"), shrunk.accepted,
             shrunk.is_smallest ? "" : "; it ended before the smallest")) +
         Comment(Sentence(shrunk.finding)) +
         (shrunk.shifts ? Comment(fmt::format("B moved and turned by 1 %: {} of {} such "
                                              "questions have the same fault.",
                                              *shrunk.shifts, kShifts))
                        : "") +
         Comment(fmt::format("Ask again: touchstone run THIS_FILE --subject {0} "
                             "--against {0}",
                             shrunk.finding.oracle)) +
         TextOf(ScenarioOf(shrunk, original));
}

}  // namespace touchstone
