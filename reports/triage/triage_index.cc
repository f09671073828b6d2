#include "reports/triage/triage_index.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/text/counted.h"

namespace touchstone {
namespace {

/** Returns text for a cell of a table and for a link in Markdown. */
std::string Escaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|' || c == '[' || c == ']' || c == '*' || c == '`' || c == '\\')
      escaped += '\\';
    escaped += c;
  }
  return escaped;
}

/** Returns why it fails, if that is known, and with which settings. */
std::string CauseOf(const Finding& finding) {
  std::string text(finding.cause == Cause::kDefect || finding.cause == Cause::kNotExamined
                       ? ""
                       : NameOf(finding.cause));
  if (finding.shipped != Shipped::kNotAsked && finding.shipped != Shipped::kBoth) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", NameOf(finding.shipped));
  }
  return text;
}

/** Returns the share of the answers that are as wrong as that, and of all that are wrong.
 */
std::string SharesOf(const Root& root) {
  if (root.rate.failed == 0) return "in variants only";
  const double all = 100 * ShareOf(root.rate);
  // A smaller question may be answered worse than any that was asked.
  if (root.gravest.failed == 0) return fmt::format("{:.3g} %, all milder", all);
  const double gravest = 100 * ShareOf(root.gravest);
  if (root.gravest.failed == root.rate.failed) return fmt::format("{:.3g} %", gravest);
  return fmt::format("{:.3g} %, {:.3g} % with milder ones", gravest, all);
}

std::string RowOf(std::size_t number, const IndexedRoot& entry) {
  const Root& root = *entry.root;
  return fmt::format("| {} | [{}]({}/REPORT.md) | {} | {} | {} | {} | {}{} | {} |\n",
                     number, Escaped(TitleOf(root)), entry.folder, NameOf(root.grade),
                     SharesOf(root), fmt::join(OraclesOf(root), ", "),
                     CauseOf(root.smallest().finding),
                     entry.is_fresh ? "**new since the baseline**, " : "",
                     entry.is_new ? "not in the ledger" : "maybe known", entry.program);
}

std::string UnrepeatablePart(const TriageIndex& index) {
  if (index.unrepeatable.empty()) return "";
  std::string list;
  for (const Specimen& specimen : index.unrepeatable) {
    const Symptom& symptom = specimen.symptoms.front();
    list +=
        fmt::format("- {}: {} ({}), {}\n", symptom.key.oracle,
                    NameOf(symptom.key.measure), symptom.key.of, IdOf(specimen.original));
  }
  return fmt::format(
      "## Not repeated\n\n{} did not occur again, in up to four questions of the gravest "
      "grade: the answer depends on more than the question.\n\n{}\n",
      Counted(index.unrepeatable.size(), "kind of failure", "kinds of failure"), list);
}

/** Returns the roots, those that are fresh first. */
std::vector<IndexedRoot> FreshFirst(const TriageIndex& index) {
  std::vector<IndexedRoot> sorted = index.roots;
  std::stable_partition(sorted.begin(), sorted.end(),
                        [](const IndexedRoot& entry) { return entry.is_fresh; });
  return sorted;
}

/** Returns how many roots there are, and what there was no time for, as sentences. */
std::string CountOf(const TriageIndex& index) {
  std::string text = Counted(index.roots.size(), "root cause");
  if (index.has_baseline) {
    text += fmt::format(", {} of them new since the baseline",
                        std::ranges::count_if(index.roots, &IndexedRoot::is_fresh));
  }
  text += '.';
  std::uint64_t covered = 0;
  for (const IndexedRoot& entry : index.roots)
    covered += entry.root->rate.failed + entry.root->in_variants;
  if (index.failed > 0)
    text += fmt::format(" They have {} of {} failures.", covered, index.failed);
  if (index.unproved > 0) {
    text += fmt::format(
        " {} from those of other oracles and {} not proved wrong: no root cause is "
        "sought.",
        Counted(index.unproved, "answer differs", "answers differ"),
        index.unproved == 1 ? "is" : "are");
  }
  if (index.vanished > 0) {
    text += fmt::format(" {} not repeated when asked for again, alone.",
                        Counted(index.vanished, "failed answer of the run was",
                                "failed answers of the run were"));
  }
  if (index.unasked > 0) {
    text += fmt::format(" {} not asked for again: the time was over.",
                        Counted(index.unasked, "failed answer of the run was",
                                "failed answers of the run were"));
  }
  if (index.left_out > 0) {
    text += fmt::format(
        " {} not examined: the time was over.",
        Counted(index.left_out, "kind of failure was", "kinds of failure were"));
  }
  const auto early = std::ranges::count_if(index.roots, [](const IndexedRoot& entry) {
    return !entry.root->smallest().is_smallest;
  });
  if (early > 0) {
    text += fmt::format(
        " Of {} the case may not be the smallest: the search ended early.", early);
  }
  if (index.is_search) {
    text +=
        " The rates say nothing: the questions of a worst-case search depend on the "
        "answers.";
  }
  return text;
}

}  // namespace

std::string SummaryOf(const TriageIndex& index) {
  std::string text = CountOf(index) + "\n";
  for (const IndexedRoot& entry : FreshFirst(index)) {
    text += fmt::format("{:>34}  {:<19}{}{}\n", SharesOf(*entry.root),
                        NameOf(entry.root->grade), entry.is_fresh ? "new: " : "",
                        TitleOf(*entry.root));
  }
  return text;
}

std::string IndexPage(const TriageIndex& index) {
  const std::vector<IndexedRoot> sorted = FreshFirst(index);
  std::string rows;
  for (std::size_t i = 0; i < sorted.size(); ++i) rows += RowOf(i + 1, sorted[i]);
  return fmt::format(
      "# Root causes of {}\n\nTouchstone {} asked {}.\n\n{} The worst come first: one "
      "grade weighs as much as a hundred times the frequency. Those of a setting of the "
      "adapter come last.\n\n"
      "| | root cause | gravest | of the answers | oracles | cause | known | program |\n"
      "|---|---|---|---|---|---|---|---|\n{}\n"
      "Each folder has `case.toml`, the smallest question that shows it; "
      "`original.toml`, "
      "one that was asked; `REPORT.md`, a text for the library's tracker; and, "
      "where "
      "one can be written, a program against the library's own API.\n\n{}",
      index.source, TOUCHSTONE_VERSION, index.asked, CountOf(index), rows,
      UnrepeatablePart(index));
}

std::vector<std::string> KeyLinesOf(const Root& root) {
  std::vector<std::string> lines;
  lines.reserve(root.failures.size());
  const RootKey& key = root.key;
  for (const std::string& failure : root.failures) {
    std::string line = fmt::format("{} | {} | {} | {} | {}", key.library, key.algorithm,
                                   failure, key.place, key.shapes);
    std::ranges::replace(line, '\n', ' ');
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string KeysFile(const std::vector<Root>& roots) {
  std::vector<std::string> lines;
  lines.reserve(roots.size());
  for (const Root& root : roots) {
    for (const std::string& line : KeyLinesOf(root)) lines.push_back(line + "\n");
  }
  std::ranges::sort(lines);
  return fmt::format("{}", fmt::join(lines, ""));
}

}  // namespace touchstone
