#include "cli/command_examples.h"

#include <algorithm>
#include <array>

namespace touchstone {
namespace {

struct Examples {
  std::string_view command;
  std::string_view lines;
  std::string_view exit_codes;
};

constexpr std::string_view kShown = "0 shown, 2 bad input";

constexpr auto kExamples = std::to_array<Examples>({
    {"run", R"(
  touchstone run                                 the whole catalogue, every engine
  touchstone run contact/box_box --subject ode   one group, another subject
  touchstone run 'contact/zoo/fcl_*' --against fcl
  touchstone run mine.toml --out report          a page in report/index.html
)",
     "0 all pass or known; 1 the subject fails, or a reference or a file does "
     "(references "
     "do not count with --fail-on subject); 2 bad input, or nothing of the subject was "
     "verified, whatever the references do"},
    {"explain", R"(
  touchstone explain contact/zoo/fcl_395         every answer, with the proofs
  touchstone explain contact/zoo/fcl_395 --all   the file, every contact, every number
  touchstone explain contact/zoo                 a line each
  touchstone explain mine.toml --against fcl,ode
)",
     kShown},
    {"ask", R"(
  touchstone ask --A 'box 1 2 3' --B 'sphere 0.5 @ 1.2 0 0'
  touchstone ask --A 'capsule 0.2 1' --B 'half_space @ 0 0 -1.1' --against fcl
  touchstone ask --A 'box 1 2 3' --B 'sphere 0.5 @ 1.2 0 0' --toml > ask.toml
)",
     kShown},
    {"list", R"(
  touchstone list                                the whole catalogue
  touchstone list 'contact/**/*parallel*'        ids with this word in them
  touchstone list my_scenarios/                  your own files
)",
     kShown},
    {"oracles", R"(
  touchstone oracles                             pairs of shapes, and by which method
  touchstone oracles --settings                  what each adapter sets and converts
)",
     kShown},
    {"simulate", R"(
  touchstone simulate mine.toml --oracle cookbook,bullet --csv motion.csv
  touchstone simulate mine.toml --oracle ode | head
)",
     "0 every motion whole, 1 one crashed, hung or diverged, 2 bad input or nothing "
     "simulated"},
    {"sweep", R"(
  touchstone sweep contact --pair box box --count 100000
  touchstone sweep contact --family edge_edge --subject ode --quiet
  touchstone sweep contact --family deep --seed 7 --out failures
)",
     "0 none failed, 1 failures, 2 bad input or nothing verified"},
    {"bench", R"(
  touchstone bench contact
  touchstone bench contact --pair box box --oracles cookbook,bullet --count 5000
  touchstone bench worlds --scene boxes1000 --oracles cookbook,bullet_float
  touchstone bench worlds --scene boxes1000,boxes10000 --threads 2

Of worlds, engines take turns: shown are medians, "of best" that of the ratios turn by turn,
with --threads the best turn. At the end, "deepest" is what overlaps most, "fastest" what moves
most, "sideways" the longest way across y.
)",
     kShown},
    {"schema", R"(
  touchstone schema > scenario.schema.json
)",
     kShown},
    {"ledger", R"(
  touchstone ledger --propose                    runs the whole catalogue
)",
     kShown},
    {"accuracy", R"(
  touchstone accuracy > docs/accuracy.md         runs the whole catalogue
)",
     kShown},
});

}  // namespace

std::string ExamplesOf(std::string_view command) {
  const auto* const found =
      std::find_if(kExamples.begin(), kExamples.end(),
                   [&](const Examples& examples) { return examples.command == command; });
  if (found == kExamples.end()) return "";
  return "Examples:" + std::string(found->lines) +
         "\nExit code: " + std::string(found->exit_codes) + ".";
}

}  // namespace touchstone
