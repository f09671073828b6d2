#include "reports/reproduce/reproduction.h"

#include <fmt/format.h>

#include "reports/reproduce/cpp_text.h"
#include "reports/reproduce/engine_code.h"
#include "reports/reproduce/fault_check.h"
#include "reports/reproduce/project_files.h"
#include "reports/text/commented.h"
#include "reports/writers/describe.h"

namespace touchstone {
namespace {

constexpr const char* kProgram = R"(//
// Exit code: 1 if the fault is there, 0 if it is gone.
// Lengths in metres; rotations are matrices, row by row.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <vector>

{includes}
namespace {{

using Vector = std::array<double, 3>;

// A contact with the separation s and the unit normal n out of A into B. Its position p is
// taken midway between its point on A, p - n s/2, and its point on B, p + n s/2. Ask() prints
// the engine's own position, and moves it along n where the engine puts it elsewhere.
struct Contact {{
  Vector p{{}};
  double s = 0;
  Vector n{{}};
}};

// The engine's answer: n is the unit normal out of A into B; the separation is negative
// where they overlap; a and b are nearest points.
struct Answer {{
  bool touching = false;
  double separation = std::numeric_limits<double>::quiet_NaN();
  Vector n{{}}, a{{}}, b{{}};
  std::vector<Contact> contacts;
}};

{definitions}
Answer Ask() {{
{ask}}}

void Print(const Answer& answer) {{
  std::printf("read as: %s, ", answer.touching ? "touching" : "apart");
  if (std::isnan(answer.separation))
    std::printf("no separation\n");
  else
    std::printf("separation %.17g\n", answer.separation);
  for (const Contact& c : answer.contacts)
    std::printf("  contact midway at (%.17g, %.17g, %.17g), separation %.17g\n", c.p[0],
                c.p[1], c.p[2], c.s);
}}
{check_definitions}
}}  // namespace

int main() {{
{check}  std::printf("%s\n", {proof});
  std::printf("%s\n", is_right ? "The fault is gone." : "The fault is there.");
  return is_right ? 0 : 1;
}}
)";

/** Compares the answer with what is right. */
std::string Compared(const FaultCheck& check, const Finding& finding) {
  const std::string applies =
      check.applies_to.empty()
          ? "  const bool is_right = error <= allowed;  // A NaN is wrong.\n"
          : fmt::format(
                "  // An answer that has changed may be right, or have another fault.\n"
                "  const bool applies = {};\n"
                "  if (!applies)\n"
                "    std::printf(\"That is not counted: the fault is one of an answer "
                "that "
                "says %s.\\n\", {});\n"
                "  const bool is_right = !applies || error <= allowed;  // A NaN is "
                "wrong.\n",
                check.applies, Quoted(check.applies_to));
  return fmt::format(
      "  const Answer answer = Ask();\n  Print(answer);\n{}"
      "  const double allowed = {};\n"
      "  std::printf(\"%s: error %.17g, allowed %.17g\\n\", {}, error, allowed);\n{}",
      check.statements,
      check.allowed.empty() ? Literal(finding.tolerance) : check.allowed,
      Quoted(NameOf(finding.measure)), applies);
}

/** Finds out whether the engine answers at all. {late} says whether the fault is that it
 does not answer in time; else it is a crash, by any signal: a library that was built
 without assertions may crash otherwise. */
constexpr const char* kAwaited = R"(  // The engine may end the process that asks it.
  constexpr int kAnswered = 42;
  const pid_t child = fork();
  if (child < 0) {{
    std::perror("fork");
    return 2;
  }}
  if (child == 0) {{
    const rlimit no_core_file{{0, 0}};
    setrlimit(RLIMIT_CORE, &no_core_file);
    const rlimit seconds{{2, 3}};
    setrlimit(RLIMIT_CPU, &seconds);
    alarm(60);  // It may wait without working.
    Print(Ask());
    std::fflush(stdout);
    _exit(kAnswered);
  }}
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {{
    if (errno == EINTR) continue;
    std::perror("waitpid");
    return 2;
  }}
  const bool is_answered = WIFEXITED(status) && WEXITSTATUS(status) == kAnswered;
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  const bool is_late = signal == SIGXCPU || signal == SIGALRM;
  if (!is_answered)
    std::printf("no answer%s: %s\n", is_late ? " in time" : "",
                signal == 0 ? "the engine exited" : strsignal(signal));
  if (signal == SIGKILL || signal == SIGTERM || signal == SIGINT) {{
    std::printf("Somebody else has ended it, which shows nothing.\n");
    return 2;
  }}
  const bool is_right = is_answered || is_late != {late};
  if (is_right && !is_answered)
    std::printf("That is not counted: the fault is {fault}.\n");
)";

constexpr const char* kAwaitedIncludes =
    "#include <cerrno>\n#include <csignal>\n#include <cstring>\n\n#include "
    "<sys/resource.h>\n"
    "#include <sys/wait.h>\n#include <unistd.h>\n\n";

/** The parts of a program that find the fault. */
struct Judge {
  std::string includes;
  std::string definitions;
  std::string statements;  ///< Ask, and set `is_right`.
};

Judge JudgeOf(const Finding& finding, const ScenarioResult& result,
              const OracleInfo& oracle) {
  if (IsWithoutAnswer(finding)) {
    const bool is_late = finding.verdict == Verdict::kTimedOut;
    return {kAwaitedIncludes, "",
            fmt::format(kAwaited, fmt::arg("late", is_late),
                        fmt::arg("fault", is_late ? "that it does not answer in time"
                                                  : "a crash"))};
  }
  const FaultCheck check = CheckOf(finding, result, oracle);
  return {"", check.definitions, Compared(check, finding)};
}

}  // namespace

Reproduction Reproduce(const ScenarioResult& result, const OracleInfo& oracle,
                       const Finding& finding) {
  const ContactQuery& query = result.scenario.contact;
  const Judge judge = JudgeOf(finding, result, oracle);
  const EngineCode engine = CodeOf(query, oracle);
  const std::string title =
      fmt::format("{} ({} and {})", TitleOf(oracle, finding),
                  NameOf(KindOf(query.A.shape)), NameOf(KindOf(query.B.shape)));
  const std::string bodies =
      fmt::format("A: {}. B: {}.", Describe(query.A), Describe(query.B));
  Reproduction files;
  files.program =
      Commented(title + ".", "// ") + "//\n" + Commented(bodies, "// ") +
      Commented(fmt::format("Asked: {}.", engine.call), "// ") + "//\n" +
      Commented(fmt::format("Proof: {}", finding.proof), "// ") +
      Commented(fmt::format("Truth: {}", Describe(query, result.truth)), "// ") +
      fmt::format(kProgram, fmt::arg("includes", judge.includes + engine.includes),
                  fmt::arg("definitions", engine.definitions),
                  fmt::arg("ask", engine.ask),
                  fmt::arg("check_definitions", judge.definitions),
                  fmt::arg("check", judge.statements),
                  fmt::arg("proof", Quoted("When written: " + finding.proof)));
  files.build = BuildFile(engine);
  files.title = title;
  files.report = ReportOf({.asked = bodies, .truth = Describe(query, result.truth)},
                          oracle, engine, finding);
  return files;
}

std::string ReportFile(const Reproduction& files) {
  return fmt::format(
      "# {}\n\n{}## Output\n\nPaste the output of the program here. It has not been run "
      "yet.\n",
      files.title, files.report);
}

}  // namespace touchstone
