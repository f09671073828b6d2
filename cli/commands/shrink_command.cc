#include "cli/commands/shrink_command.h"

#include <iostream>
#include <optional>

#include <fmt/format.h>

#include "cli/interrupt.h"
#include "cli/output_folder.h"
#include "cli/progress_bar.h"
#include "reports/shrink/shrunk_file.h"
#include "reports/text/counted.h"
#include "reports/writers/outcome.h"

namespace touchstone {

int ShrinkCommand(const Session& session, const ShrinkArguments& arguments) {
  std::optional<OutputFolder> folder;
  if (arguments.out) {
    folder.emplace(arguments.out->has_parent_path() ? arguments.out->parent_path() : ".");
    folder->Check(arguments.out->filename());
  }
  const ChosenFault fault = ChooseFault(session, arguments.fault);
  const Interrupt interrupt(WorkingEngines::kFinish);
  std::optional<ProgressBar> bar;
  bar.emplace(session.terminal, arguments.quiet);
  const auto tries = static_cast<std::size_t>(arguments.tries);
  const Shrunk shrunk = Shrink(fault.question, *fault.oracle, fault.finding,
                               {.tries = tries,
                                .over = fault.over,
                                .on_try = [&](std::size_t n) { bar->Show(n, tries); },
                                .stop = [] { return Interrupt::signal() != 0; }});
  bar.reset();
  const std::string file = FileOf(shrunk, fault.question);
  if (folder) {
    folder->Write(arguments.out->filename(), [&](std::ostream& out) { out << file; });
    if (!arguments.quiet) {
      std::cout << fmt::format("{} asked, {} kept{}\n{}\n",
                               Counted(shrunk.tried, "smaller question"), shrunk.accepted,
                               shrunk.is_smallest ? "" : "; it ended before the smallest",
                               Sentence(shrunk.finding));
    }
  } else {
    std::cout << file;
  }
  if (const int signal = Interrupt::signal()) {
    std::cout.flush();
    std::cerr << "touchstone: stopped; the file is the smallest question so far, and "
                 "`touchstone shrink` goes on from it\n";
    return 128 + signal;
  }
  return 0;
}

}  // namespace touchstone
