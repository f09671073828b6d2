#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace touchstone {

/** Returns, in one sentence, the error in the line that `app` could not parse. The
 sentence names an unknown command or option with the nearest known one, else the value
 that an option expects. `error` is the exception that app.parse() threw. */
std::string LineError(const CLI::App& app, const CLI::ParseError& error);

}  // namespace touchstone
