#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "reports/ledger/bounds_file.h"
#include "reports/writers/data/deflate.h"
#include "reports/writers/read_report_data.h"
#include "scenarios/contact_table.h"
#include "scenarios/scenario_file.h"
#include "tests/fuzz/bounds_file_property.h"
#include "tests/fuzz/contact_table_property.h"
#include "tests/fuzz/protocol_property.h"
#include "tests/fuzz/report_data_property.h"
#include "tests/fuzz/scenario_file_property.h"
#include "tests/source_tree.h"

namespace touchstone {
namespace {

// The corpus consists of the fuzzer's seeds and every input that has revealed a fault.
TEST(ScenarioFileCorpus, IsReadWithoutFault) {
  int files = 0;
  int accepted = 0;
  for (const auto& entry : std::filesystem::directory_iterator(
           InSourceTree("tests/fuzz/corpus/scenario_file"))) {
    std::ostringstream text;
    text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    EXPECT_EQ(FaultOfReading(text.str()), "") << entry.path();
    // The name states the result: good_*.toml is accepted, bad_*.toml refused.
    const std::string name = entry.path().filename().string();
    const bool reads = ReadScenario(text.str(), name).diagnostics.empty();
    EXPECT_EQ(reads, name.starts_with("good_")) << name;
    ++files;
    if (reads) ++accepted;
  }
  EXPECT_GE(accepted, 5);
  EXPECT_GE(files - accepted, 5);
}

TEST(BoundsFileCorpus, IsReadWithoutFault) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(
           InSourceTree("tests/fuzz/corpus/bounds_file"))) {
    std::ostringstream text;
    text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    EXPECT_EQ(FaultOfReadingBounds(text.str()), "") << entry.path();
    const std::string name = entry.path().filename().string();
    EXPECT_EQ(ReadBounds(text.str(), name).diagnostics.empty(), name.starts_with("good_"))
        << name;
    ++files;
  }
  EXPECT_GE(files, 7);
}

TEST(ContactTableCorpus, IsReadWithoutFault) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(
           InSourceTree("tests/fuzz/corpus/contact_table"))) {
    std::ostringstream text;
    text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    EXPECT_EQ(FaultOfReadingTable(text.str()), "") << entry.path();
    const std::string name = entry.path().filename().string();
    EXPECT_EQ(ReadContactTable(text.str(), name).errors.empty(),
              name.starts_with("good_"))
        << name;
    ++files;
  }
  EXPECT_GE(files, 12);
}

TEST(ProtocolCorpus, IsReadWithoutFault) {
  int files = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(InSourceTree("tests/fuzz/corpus/protocol"))) {
    std::ostringstream bytes;
    bytes << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    EXPECT_EQ(FaultOfReadingProtocol(bytes.str()), "") << entry.path();
    ++files;
  }
  EXPECT_GE(files, 20);
}

TEST(ReportDataCorpus, IsReadWithoutFault) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(
           InSourceTree("tests/fuzz/corpus/report_data"))) {
    std::ostringstream bytes;
    bytes << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    EXPECT_EQ(FaultOfReadingReportData(bytes.str()), "") << entry.path();
    // *.bin are the contents of a file before they are deflated.
    const std::string name = entry.path().filename().string();
    const bool is_deflated = name.ends_with(".data");
    const std::string file = is_deflated ? bytes.str() : Deflated(bytes.str());
    EXPECT_EQ(ReadReport(file, name, 1 << 20).data.has_value(), name.starts_with("good_"))
        << name;
    ++files;
  }
  EXPECT_GE(files, 12);
}

}  // namespace
}  // namespace touchstone
