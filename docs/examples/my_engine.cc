// The whole `touchstone` command line, with your own routine as the subject, and your own
// world engine beside it:
//   my_engine run contact/box_box --fail-on subject
//   my_engine sweep contact --pair box box --count 100000
//   my_engine ask --A 'box 1 2 3' --B 'box 1 1 1 @ 1.8 0 0 q 0.9 0.1 0.3 0.3'
//   my_engine run world --subject my_world --fail-on subject
#include <cli/command_line.h>

#include "my_oracle.h"
#include "my_world.h"

int main(int argc, char** argv) {
  auto oracles = touchstone::OracleRegistry::BuiltIn();
  oracles.Add(touchstone::MakeOracle<touchstone::Box, touchstone::Box>("my_box_box",
                                                                       AskMyBoxBox));
  oracles.Add(touchstone::MakeSimulator<MyWorld>("my_world", MyWorldSimulates()));
  touchstone::CommandLineDefaults defaults;
  defaults.subject = "my_box_box";
  return touchstone::RunCommandLine(argc, argv, std::move(oracles), defaults);
}
