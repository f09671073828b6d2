// Published benchmark tables, reproduced with the oracles of this project. Each value
// must agree to the printed digits, or its difference must be explained and stay the
// same.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <map>
#include <ostream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "oracles/oracle_registry.h"
#include "tests/acceptance/published_worlds.h"
#include "tests/source_tree.h"

namespace touchstone {
namespace {

const OracleRegistry& Registry() {
  static const OracleRegistry registry = OracleRegistry::BuiltIn();
  return registry;
}

/** A line of published.csv. */
struct Row {
  std::string benchmark;
  std::string oracle;
  double dt = 0;  ///< [s]
  std::string quantity;
  std::string published;  ///< Value as printed.
  std::string here;       ///< Value of this project if it differs; otherwise empty.
  std::string why;        ///< Reason of the difference.
  std::string source;
};

std::vector<Row> ReadTable() {
  std::ifstream file(InSourceTree("tests/acceptance/published.csv"));
  std::vector<Row> rows;
  std::string line;
  while (std::getline(file, line)) {
    if (line.empty() || line.front() == '#') continue;
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ';');) cells.push_back(cell);
    if (cells.size() != 8)
      throw std::runtime_error("published.csv: expected 8 cells in: " + line);
    rows.push_back({cells[0], cells[1], std::stod(cells[2]), cells[3], cells[4], cells[5],
                    cells[6], cells[7]});
  }
  return rows;
}

const std::vector<Row>& Table() {
  static const std::vector<Row> rows = ReadTable();
  return rows;
}

/** Returns half a unit of the last digit of `printed`, plus a margin for rounding. */
double HalfAUnit(const std::string& printed) {
  const std::size_t e = printed.find('e');
  const std::string mantissa = printed.substr(0, e);
  const std::size_t point = mantissa.find('.');
  const auto decimals =
      point == std::string::npos ? 0 : static_cast<int>(mantissa.size() - point - 1);
  const int exponent = e == std::string::npos ? 0 : std::stoi(printed.substr(e + 1));
  return 0.5 * std::pow(10, exponent - decimals) * (1 + 1e-9);
}

/** One run, which measures several quantities. */
struct Benchmark {
  std::string benchmark;
  std::string oracle;
  double dt = 0;

  bool operator<(const Benchmark& other) const {
    return std::tie(benchmark, oracle, dt) <
           std::tie(other.benchmark, other.oracle, other.dt);
  }
};

void PrintTo(const Benchmark& run, std::ostream* out) {
  *out << run.benchmark << ", " << run.oracle << ", " << run.dt << " s";
}

std::vector<Benchmark> Benchmarks() {
  std::set<Benchmark> runs;
  for (const Row& row : Table()) {
    if (Registry().Find(row.oracle) != nullptr)
      runs.insert({row.benchmark, row.oracle, row.dt});
  }
  return {runs.begin(), runs.end()};
}

class Published : public testing::TestWithParam<Benchmark> {};

TEST_P(Published, IsReproducedToThePrintedDigitsOrAsExplained) {
  const Benchmark& run = GetParam();
  const Oracle& oracle = *Registry().Find(run.oracle);
  const std::map<std::string, double> measured =
      RunPublished(run.benchmark, oracle, run.dt);
  for (const Row& row : Table()) {
    if (row.benchmark != run.benchmark || row.oracle != run.oracle || row.dt != run.dt)
      continue;
    const double value = measured.at(row.quantity);
    const std::string& expected = row.here.empty() ? row.published : row.here;
    EXPECT_NEAR(value, std::stod(expected), HalfAUnit(expected))
        << row.quantity << ", published by " << row.source;
    if (row.here.empty()) continue;
    EXPECT_GT(std::abs(value - std::stod(row.published)), HalfAUnit(row.published))
        << "improved: " << row.quantity
        << " is as published; remove \"here\" and \"why\" from its line";
  }
}

INSTANTIATE_TEST_SUITE_P(, Published, testing::ValuesIn(Benchmarks()),
                         [](const auto& instance) {
                           std::ostringstream out;
                           out << instance.param.benchmark << "_" << instance.param.oracle
                               << "_" << instance.param.dt;
                           std::string name = out.str();
                           std::replace_if(
                               name.begin(), name.end(),
                               [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
                           return name;
                         });

TEST(PublishedTable, ExplainsEveryDifferenceAndNamesEverySource) {
  EXPECT_GT(Table().size(), 40u);
  for (const Row& row : Table()) {
    EXPECT_EQ(row.here.empty(), row.why.empty()) << row.benchmark << ", " << row.oracle;
    EXPECT_FALSE(row.source.empty()) << row.benchmark << ", " << row.oracle;
  }
}

}  // namespace
}  // namespace touchstone
