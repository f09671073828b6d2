#pragma once

#include <stdexcept>
#include <string>

#include "oracles/oracle.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** A question that no program can be written for. what() says why, without a stop. */
class CannotReproduce : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/** A measure that no program can check. what() also names those that one can. */
class CannotCheck : public CannotReproduce {
 public:
  using CannotReproduce::CannotReproduce;
};

/** The parts of a program that depend on the engine. */
struct EngineCode {
  std::string includes;  ///< The engine's headers, as #include lines.
  /** Definitions that `ask` uses, at namespace scope. */
  std::string definitions;
  /** The body of `Answer Ask()`: puts the question to the engine with the settings of our
   adapter, prints the engine's own numbers, and returns them from A to B. Contacts lie
   where the adapter reads them. */
  std::string ask;
  std::string find;  ///< CMake lines that define the target `engine`.
  /** The call and its settings in the engine's terms, one sentence without a stop. */
  std::string call;
  std::string package;  ///< The Debian package.
};

/** Each function below returns the code that puts `query` to the engine as the oracle of
 that name does. They throw CannotReproduce. @pre The oracle supports the query. */
EngineCode BulletCode(const ContactQuery& query, const std::string& oracle);
EngineCode CcdCode(const ContactQuery& query, const std::string& oracle);
EngineCode DartCode(const ContactQuery& query, const std::string& oracle);
EngineCode FclCode(const ContactQuery& query, const std::string& oracle);
EngineCode MujocoCode(const ContactQuery& query, const std::string& oracle);
EngineCode OdeCode(const ContactQuery& query, const std::string& oracle);

/** Returns the code of the engine of `oracle`. Throws CannotReproduce if it is none of
 the six. */
EngineCode CodeOf(const ContactQuery& query, const OracleInfo& oracle);

}  // namespace touchstone
