#include "scenarios/toml/read_expectations.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scenarios/read_trajectory.h"
#include "scenarios/toml/values.h"
#include "scenarios/worlds/validate_world.h"

namespace touchstone {
namespace {

constexpr std::array<std::string_view, 9> kStatements = {
    "position", "velocity", "spin",  "quaternion", "angle",
    "touches",  "topples",  "rests", "trajectory"};

/** Reads one table of [[expect]]. */
class Expectation {
 public:
  Expectation(const toml::table& table, std::string path, const ExpectedOf& of,
              WorldNames& names, FileLog& log)
      : table_(table), path_(std::move(path)), of_(of), names_(names), log_(log) {}

  MotionExpectation operator()() {
    MotionExpectation read;
    const std::size_t before = log_.size();
    const std::string_view statement = Statement();
    if (statement.empty()) return read;
    read.body = TextFrom(table_, "body");
    read.because = TextFrom(table_, "because");
    read.tolerance = NumberFrom(table_.get("tolerance"), 0);
    SetWhat(statement, read);
    const std::string_view time = TimeKeyOf(read);
    if (!time.empty()) read.time = NumberFrom(table_.get(time), 0);
    CheckKeys(statement, time);
    CheckNames(statement);
    if (log_.size() == before) log_.Add(FaultsOf(read), table_, path_);
    if (log_.size() == before && of_.clock_is_good)
      log_.Add(FaultsIn(of_.world, read), table_, path_);
    if (log_.size() == before && of_.clock_is_good) ReadReference(read);
    return read;
  }

 private:
  /** Returns the key of what is stated; logs an error unless there is exactly one. */
  std::string_view Statement() {
    std::vector<std::string_view> stated;
    for (const std::string_view key : kStatements)
      if (table_.contains(key)) stated.push_back(key);
    if (stated.size() == 1) return stated.front();
    log_.Add(stated.empty() ? table_.source() : table_.get(stated[1])->source(),
             stated.empty()
                 ? fmt::format("{} states nothing", Name())
                 : fmt::format("{} states {}", Name(), fmt::join(stated, " and ")),
             fmt::format("one of {}", fmt::join(kStatements, ", ")));
    return {};
  }

  void SetWhat(std::string_view statement, MotionExpectation& read) {
    const toml::node* node = table_.get(statement);
    const Eigen::Vector3d along =
        VectorFrom(table_.get("along"), Eigen::Vector3d::UnitX());
    if (statement == "quaternion") {
      ExpectedOrientation expected;
      if (AreNumbers(node, 4)) {
        const toml::array& wxyz = *node->as_array();
        expected.q_WB = {NumberFrom(wxyz.get(0), 1), NumberFrom(wxyz.get(1), 0),
                         NumberFrom(wxyz.get(2), 0), NumberFrom(wxyz.get(3), 0)};
      }
      read.what = expected;
    } else if (statement == "angle") {
      read.what = ExpectedAngle{NumberFrom(node, 0), along};
    } else if (statement == "touches") {
      read.what = ExpectedTouch{TextFrom(table_, statement)};
    } else if (statement == "topples") {
      read.what = ExpectedTopple{node->value_or(true)};
    } else if (statement == "rests") {
      read.what = ExpectedRest{};
      if (!node->value_or(true))
        log_.Add(node->source(), fmt::format("{}rests is false", path_), "true");
    } else if (statement == "trajectory") {
      read.what = ExpectedTrajectory{TextFrom(table_, statement), {}};
    } else {
      using Of = ExpectedVector::Of;
      ExpectedVector expected;
      expected.of = statement == "position"   ? Of::kPosition
                    : statement == "velocity" ? Of::kVelocity
                                              : Of::kSpin;
      expected.value = VectorFrom(node, expected.value);
      if (table_.contains("along")) expected.along = along;
      read.what = expected;
    }
  }

  /** Logs the keys that this statement lacks, and those that it does not have. */
  void CheckKeys(std::string_view statement, std::string_view time) {
    const bool is_angle = statement == "angle";
    const bool is_vector =
        statement == "position" || statement == "velocity" || statement == "spin";
    const bool is_topple = statement == "topples";
    const bool is_trajectory = statement == "trajectory";
    Check("body", !is_trajectory, true, statement, "the name of a body");
    Check("at", time == "at", time == "at", statement, "a time in s");
    Check("by", time == "by", time == "by", statement, "a time in s");
    Check("along", is_angle, is_angle || is_vector, statement, "the axis of the angle");
    Check("tolerance", !is_topple, !is_topple, statement, "a number > 0");
  }

  void Check(std::string_view key, bool required, bool allowed,
             std::string_view statement, std::string_view expected) {
    const toml::node* node = table_.get(key);
    if (node && !allowed) {
      log_.Add(node->source(), fmt::format("{}{} is stated", path_, key),
               fmt::format("none: {} has no {}", statement, key));
    } else if (!node && required) {
      log_.Add(table_.source(), fmt::format("{}{} is missing", path_, key), expected);
    }
  }

  void CheckNames(std::string_view statement) {
    if (const toml::node* body = table_.get("body"))
      if (body->is_string()) names_.AnchorFrom(body, path_ + "body");
    if (statement == "touches") names_.BodyFrom(table_.get(statement), path_ + "touches");
  }

  void ReadReference(MotionExpectation& read) {
    auto* expected = std::get_if<ExpectedTrajectory>(&read.what);
    if (!expected) return;
    ReadTrajectory reference = ReadTrajectoryFile(of_.folder / expected->file, of_.world);
    for (Diagnostic& error : reference.errors) log_.Add(std::move(error));
    expected->states = std::move(reference.states);
    if (read.body.empty()) return;
    std::erase_if(expected->states,
                  [&](const ReferenceState& state) { return state.name != read.body; });
    if (!expected->states.empty() || !reference.errors.empty()) return;
    log_.Add(table_.get("trajectory")->source(),
             fmt::format("{}trajectory has no state of \"{}\"", path_, read.body),
             "rows with that name");
  }

  /** Returns the path without its dot. */
  std::string_view Name() const {
    return std::string_view(path_).substr(0, path_.size() - 1);
  }

  const toml::table& table_;
  std::string path_;  ///< E.g. "expect[2].".
  const ExpectedOf& of_;
  WorldNames& names_;
  FileLog& log_;
};

}  // namespace

std::vector<MotionExpectation> ExpectationsFrom(const toml::table& file,
                                                const ExpectedOf& of, WorldNames& names,
                                                FileLog& log) {
  std::vector<MotionExpectation> expectations;
  for (const toml::table* table : TablesFrom(file, "expect")) {
    const std::string path = fmt::format("expect[{}].", expectations.size());
    if (table) {
      expectations.push_back(Expectation(*table, path, of, names, log)());
    } else {
      expectations.emplace_back();
    }
  }
  return expectations;
}

}  // namespace touchstone
