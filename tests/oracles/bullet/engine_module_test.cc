#include "oracles/bullet/engine_module.h"

#include <cstdlib>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace touchstone {
namespace {

TEST(EngineModule, ErrorNamesTheMissingModuleAndTheFoldersSearched) {
  ASSERT_EQ(setenv("TOUCHSTONE_PLUGIN_PATH", "/first/place:/second/place", 1), 0);
  try {
    OpenEngineModule("touchstone_no_such_engine");
    FAIL() << "opened a module that does not exist";
  } catch (const std::runtime_error& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("touchstone_no_such_engine.so"), std::string::npos) << what;
    EXPECT_NE(what.find("/first/place, /second/place"), std::string::npos) << what;
    EXPECT_NE(what.find("TOUCHSTONE_PLUGIN_PATH"), std::string::npos) << what;
  }
  ASSERT_EQ(unsetenv("TOUCHSTONE_PLUGIN_PATH"), 0);
}

}  // namespace
}  // namespace touchstone
