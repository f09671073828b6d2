#include "cli/command_examples.h"

#include <algorithm>
#include <array>

namespace touchstone {
namespace {

struct Examples {
  std::string_view command;
  std::string_view description;
  std::string_view lines;
  std::string_view exit_codes;
};

constexpr std::string_view kShown = "0 success, 2 bad input";

constexpr auto kExamples = std::to_array<Examples>({
    {"run", R"(

A scenario is a question: two shapes at poses, or a small world to simulate. Every oracle
answers it, and each answer is judged against the certified truth or the laws of the world.
The subject is the oracle under examination; the other oracles are its references. A failure
that the ledger of known discrepancies lists counts as known.

In worlds, adapters set up their engines for accuracy. A world that an engine fails is asked
again with the engine's shipped settings, and the finding says whether it fails both ways, as
set here only (and which default lets it pass), or as shipped only. --as-shipped judges the
shipped settings throughout, --set chooses single ones. The built-in ledger is about the
settings of the adapters: it hides no failure in a world of an oracle that is set up otherwise.
)",
     R"(
  touchstone run                                 run the whole catalogue on every engine
  touchstone run contact/box_box --subject ode   run one group with another subject
  touchstone run 'contact/zoo/fcl_*' --against fcl
  touchstone run mine.toml --out report          also write report/report.html
  touchstone run --open                          show the page in the browser
  touchstone run mine.toml --as-shipped --set ode:contact_erp=0.1
  touchstone run world --timings                 also print where the time went
)",
     "0 all pass or known; 1 failures of the subject, of a file, or of a reference by\n"
     "more than rounding (see --fail-on, --fail-above); 2 bad input, or nothing of the\n"
     "subject was verified, even if references fail"},
    {"report", R"(

The page of a run holds its data and the viewer of the program that wrote it. This command
puts the data of an earlier run, report.data, into the viewer of this program.
)",
     R"(
  touchstone report yesterday -o yesterday.html
  touchstone report yesterday/report.data -o yesterday.html
)",
     kShown},
    {"compare", R"(

Compares the findings of two runs, one by one: a measure (and law) of one oracle in one
scenario. It is worse if its verdict is, or if its error has more than doubled and is beyond
what rounding can cause. It is no longer judged if it passed and is now undecidable,
unsupported or not measured. New are faults that only NEW has, gone those that only OLD has.
Run both on the same machine, and let the exit code guard your own CI.

With --oracle and --with, compares two oracles of one run instead, for example two versions of an
engine: what the second does worse than the first.
)",
     R"(
  touchstone run --out yesterday                 run, keep the data
  touchstone compare yesterday today             print what changed
  touchstone compare yesterday today --html changes.html --junit changes.xml
  touchstone compare today --oracle mujoco --with mujoco@new
)",
     "0 nothing is worse; 1 something is worse or no longer judged; 2 bad input"},
    {"explain", R"(

For one scenario, prints the certified truth, the oracles that are right and wrong, all
answers side by side, and a proof against each wrong one. For several scenarios, prints one
line each.
)",
     R"(
  touchstone explain contact/zoo/fcl_395         show every answer, with proofs
  touchstone explain contact/zoo/fcl_395 --all   add the file, every contact and number
  touchstone explain contact/zoo                 print one line per scenario
  touchstone explain mine.toml --against fcl,ode
)",
     kShown},
    {"ask", R"(

Does the same as `touchstone explain`, for two shapes given on the command line.
)",
     R"(
  touchstone ask --A 'box 1 2 3' --B 'sphere 0.5 @ 1.2 0 0'
  touchstone ask --A 'capsule 0.2 1' --B 'half_space @ 0 0 -1.1' --against fcl
  touchstone ask --A 'box 1 2 3' --B 'sphere 0.5 @ 1.2 0 0' --toml > ask.toml
)",
     kShown},
    {"list", R"(

Prints the id and title of each scenario, then the number of scenarios per group.
)",
     R"(
  touchstone list                                list the whole catalogue
  touchstone list 'contact/**/*parallel*'        list ids that contain this word
  touchstone list my_scenarios/                  list your own files
)",
     kShown},
    {"oracles", R"(

Prints the library, version and precision of each oracle, the shape pairs that it supports
with algorithm and parts of the answer, and the world features that it simulates. Oracles
missing from this build come last, with instructions to install them.

With --settings, prints how each adapter sets up its engine. Lines that start with --set are
settings that may be chosen in worlds, with the value of the adapter and the shipped default.
)",
     R"(
  touchstone oracles                             list shape pairs and algorithms
  touchstone oracles --settings                  list the settings of each adapter
)",
     kShown},
    {"simulate", R"(

Simulates each selected world with each oracle. Writes one row per sample and moving object:
position, orientation, velocity and angular velocity, in SI units and the world frame.
)",
     R"(
  touchstone simulate mine.toml --oracle cookbook,bullet --csv motion.csv
  touchstone simulate mine.toml --oracle ode | head
  touchstone simulate mine.toml --oracle ode --set ode:contact_erp=0.2
)",
     "0 every motion is complete, 1 a motion crashed, hung or diverged, 2 bad\n"
     "input or nothing simulated"},
    {"sweep", R"(

Generates questions from a seed, or reads yours, and judges the answers of the subjects, without
a ledger. Contact questions are judged against the certified truth. Worlds are small simulations;
their motions are judged by the laws that the family claims and by those of every motion. Prints
one row per family, shape pair and subject: the fraction that touches or that was verified, the
failures, and the worst measures relative to their tolerances. Then prints the failures by
measure, law and cause, with commands that repeat them; for a single subject also proofs, next
to the answers of the references. Contact questions without --pair are of every shape pair that
a subject supports.

With --from, the questions are yours, e.g. poses of a simulation or a robot: a CSV table with one
question a row, whose first line names the columns,
    A.shape,A.radius,B.shape,B.radius,B.position.x,B.position.y,B.position.z
    sphere,0.5,sphere,0.4,0,0,0.89
in metres, with quaternions as A.quaternion.w, .x, .y and .z (docs/contact_table.md has all
columns), or scenario files, or the report.jsonl of a run. A changed table is another sweep: it
neither resumes nor merges.

With --out, the results are kept in DIR/sweep.unfinished.sqlite while they are computed. The same
command goes on after Ctrl-C, --time, or a kill, and ends with the same DIR/sweep.sqlite, whatever
--jobs. Shards have files of their own, which `touchstone merge` joins.

With --slurm, submits one task per shard to a cluster, and a merge that waits for all of them. DIR
must be shared by all machines. The same command with --status shows the progress. Without it, it
submits again the shards that failed, which go on from where they were.
)",
     R"(
  touchstone sweep contact --pair box box --count 20000
  touchstone sweep contact --family edge_edge,deep --subject ode,fcl --quiet
  touchstone sweep contact --subject all --pair box box --count 1000000 --time 8h --out night
  touchstone sweep contact --pair box box --count 1000000 --shard 2/8 --out shards
  touchstone sweep contact --count 1000000 --out big --slurm --tasks 64 --sbatch-args '--time=60'
  touchstone sweep contact --count 1000000 --out big --slurm --status
  touchstone sweep contact --pair box box --subject bullet/gjk --count 512 --climb 32
  touchstone sweep contact --from poses.csv --subject bullet/gjk --out night
  touchstone sweep contact --from poses.csv my_scenarios/ --pair box box --count 1000
  touchstone sweep world --count 1000
  touchstone sweep world --family slides,stacks --subject ode --set ode:contact_erp=0.2 --quiet
  touchstone sweep world --subject all --count 100000 --seed 7 --time 8h --out worlds
)",
     "0 no failures; 1 failures, only graver ones with --fail-above; 2 bad input or\n"
     "nothing verified; 130 after Ctrl-C; with --status, 1 until it is complete"},
    {"serve", R"(

Speaks the oracle protocol (docs/oracle_protocol.md) on standard input and output for one of the
oracles of this program, so that another harness, or another build of Touchstone, may ask it. That
is how two versions of a library stand side by side: each in a program of its own.
)",
     R"(
  touchstone serve fcl/distance
  touchstone run --oracle 'fcl@0.7=/opt/old/bin/touchstone serve fcl/distance' --subject fcl@0.7
)",
     "0 after the end of the input; 1 the output is closed; 2 bad input"},
    {"check-oracle", R"(

Puts questions to a program that speaks the oracle protocol (docs/oracle_protocol.md), and says in
sentences what is wrong with its answers: a normal that points the wrong way, half extents taken for
edges, another order of quaternions, degrees, a position that is that of a corner, answers that
depend on earlier questions. Where no such mistake explains the answers, it shows the proof
against the first of them: then it may be the engine.
)",
     R"(
  touchstone check-oracle -- python3 my_oracle.py
  touchstone check-oracle -- ./my_engine --precise
  touchstone check-oracle ode                    check an oracle of this program
)",
     "0 nothing is wrong; 1 something is; 2 bad input, or nothing could be asked"},
    {"triage", R"(

A sweep counts failures; this command finds what they have in common. It asks the gravest failure
of each oracle, pair of shapes, measure and ending again, shrinks it, and takes failures whose
smallest questions have the same library, algorithm, fault and shapes, or whose crashes have the
same place, for one root cause. Each gets a folder: the smallest question, a program against the
library's own API with its output, and a report for the library's tracker with the rate of the
fault. index.md lists them, the worst first. The failures of a run that the ledger does not know
have root causes, too.

With --baseline, root causes that an earlier triage has are listed last and do not count.
)",
     R"(
  touchstone triage night
  touchstone triage night --baseline yesterday/triage
  touchstone triage night --subject ode --out roots --time 1h --no-programs
  touchstone triage report                       the folder of touchstone run --out
)",
     "0 no failure, with --baseline no new root cause; 1 root causes, or kinds of "
     "failure "
     "that are not repeated or not examined; 2 bad input; 130 after Ctrl-C"},
    {"merge", R"(

Joins the files of all shards of one sweep. The result is, byte for byte, the file of the sweep
without --shard.
)",
     R"(
  touchstone merge shards/sweep.*-of-8.sqlite -o sweep.sqlite
)",
     kShown},
    {"shrink", R"(

Takes a scenario in which an oracle is wrong, known to the ledger or not, and makes it smaller
while the fault persists: simpler shapes, fewer bodies, vertices and steps, plain rotations,
short numbers. The oracle, its algorithm, measure, law, verdict, cause and kind of proof stay
the same, and the error stays as grave. Writes a scenario file that finds the fault again, with
what was tried. A crash or a hang is a fault, too.
)",
     R"(
  touchstone shrink contact/zoo/fcl_508y --oracle fcl/distance
  touchstone shrink mine.toml --oracle ode --measure excess --out small.toml
  touchstone shrink mine.toml --oracle ode --keep 'separation_error > 0.1'
  touchstone run small.toml --subject ode --against ode
)",
     kShown},
    {"reproduce", R"(

Takes a scenario that an engine answers wrongly, known to the ledger or not. Writes one C++
program against that engine's own API alone, a CMakeLists.txt that finds the engine, and a report
for its tracker. The program prints the engine's answer beside the truth. It exits 1 if the fault
is there and 0 if it is gone. The command does not build it.

Programs for worlds are written for ODE, Bullet, MuJoCo and DART, and for rigid bodies without
joints, springs and pushes. They check penetration, passage, position_error, velocity_error,
spin_error, energy_drift and momentum_drift.
)",
     R"(
  touchstone reproduce contact/zoo/fcl_508y --for fcl/distance --out fault
  touchstone reproduce mine.toml --for ode --measure excess --out fault
  touchstone reproduce world/bounce/ball_on_a_resting_box --for bullet --measure penetration
  cmake -S fault -B fault/build && cmake --build fault/build && fault/build/reproduce
)",
     "0 written; 2 bad input, nothing is wrong, or no program can be written for it"},
    {"bench", R"(

`bench contact` measures the time per query and the accuracy of the answers. Without --pair,
it measures sphere-sphere, sphere-box and box-box.

`bench worlds` measures the time per step and the quality of the final state: "deepest" is
the deepest penetration, "fastest" the largest speed, "sideways" the largest horizontal
displacement. Engines have their shipped settings, except for those that --set chooses, and
they do not sleep. Engines take turns. Times are medians over the turns, and "of best" is the
median of the ratios turn by turn; with --threads both are of the best turn.
)",
     R"(
  touchstone bench contact
  touchstone bench contact --pair box box --oracles cookbook,bullet --count 5000
  touchstone bench worlds --scene boxes1000 --oracles cookbook,bullet_float
  touchstone bench worlds --scene boxes1000,boxes10000 --threads 2
)",
     kShown},
    {"schema", R"(

Editors use the schema to complete and check scenario files.
)",
     R"(
  touchstone schema > scenario.schema.json
)",
     kShown},
    {"ledger", R"(

Runs scenarios, the whole catalogue or your own. --propose prints a ledger entry for each
failure that no entry covers; a person completes the reasons. --update then writes the
bounds of all cells to the file next to the ledger, with the extension .bounds.
)",
     R"(
  touchstone ledger --propose my_scenarios/ > my_ledger.toml
  touchstone ledger --update --ledger my_ledger.toml my_scenarios/
  touchstone ledger --audit
)",
     "0 success, 1 not in order, 2 bad input"},
    {"accuracy", R"(

Runs the whole catalogue. The tables state the worst error of each oracle on each pair of
shapes and on each world.
)",
     R"(
  touchstone accuracy > docs/accuracy.md
)",
     kShown},
});

const Examples* Find(std::string_view command) {
  const auto* const found =
      std::find_if(kExamples.begin(), kExamples.end(),
                   [&](const Examples& examples) { return examples.command == command; });
  return found == kExamples.end() ? nullptr : found;
}

}  // namespace

std::string DescriptionOf(std::string_view command) {
  const Examples* const found = Find(command);
  return found == nullptr ? "" : std::string(found->description);
}

std::string ExamplesOf(std::string_view command) {
  const Examples* const found = Find(command);
  if (found == nullptr) return "";
  return "Examples:" + std::string(found->lines) +
         "\nExit code: " + std::string(found->exit_codes) + ".";
}

}  // namespace touchstone
