#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace touchstone {

/** Returns what is wrong with the line that `app` could not parse, in one sentence: the
 command or the option that is not there with the nearest that is, else what an option
 expected. `error` is what app.parse() threw. */
std::string LineError(const CLI::App& app, const CLI::ParseError& error);

}  // namespace touchstone
