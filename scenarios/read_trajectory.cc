#include "scenarios/read_trajectory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "scenarios/csv_line.h"
#include "scenarios/worlds/validate_world.h"

namespace touchstone {
namespace {

/** More errors of one file tell no more. */
constexpr std::size_t kMostErrors = 5;

/** The columns that are read; those before kOrientation are required. */
enum Column : std::size_t { kTime, kName, kPosition, kOrientation = 5, kOracle = 9 };
constexpr std::array<std::string_view, 10> kColumns = {
    "time", "name", "px", "py", "pz", "qw", "qx", "qy", "qz", "oracle"};

class Reader {
 public:
  Reader(const std::filesystem::path& file, const World& world)
      : file_(file), world_(world) {}

  ReadTrajectory operator()() {
    std::error_code error;
    // A device or a pipe might never end.
    if (!std::filesystem::is_regular_file(file_, error)) {
      Add(0, 0, "is not there", "a CSV file, relative to the scenario's");
      return std::move(read_);
    }
    std::ifstream in(file_);
    std::string line;
    std::getline(in, line);
    if (!ReadHeader(CellsOf(line))) return std::move(read_);
    for (line_ = 2; std::getline(in, line) && read_.errors.size() < kMostErrors; ++line_)
      if (!line.empty() && line != "\r") ReadRow(CellsOf(line));
    if (read_.errors.empty() && read_.states.empty())
      Add(0, 0, "has no states", "a row for each time and body");
    return std::move(read_);
  }

 private:
  void Add(int line, std::size_t cell, std::string what, std::string expected) {
    read_.errors.push_back({file_.string(), line, line > 0 ? static_cast<int>(cell) : 0,
                            std::move(what), std::move(expected)});
  }

  bool ReadHeader(const std::vector<std::string_view>& cells) {
    for (std::size_t column = 0; column < kColumns.size(); ++column) {
      const auto found = std::find(cells.begin(), cells.end(), kColumns[column]);
      if (found != cells.end()) {
        at_[column] = static_cast<std::size_t>(found - cells.begin());
      } else if (column < kOrientation) {
        Add(1, 1, fmt::format("has no column {}", kColumns[column]),
            "the columns time, name, px, py and pz");
        return false;
      }
    }
    columns_ = cells.size();
    return true;
  }

  void ReadRow(const std::vector<std::string_view>& cells) {
    if (cells.size() != columns_) {
      Add(line_, 1, fmt::format("has {} cells", cells.size()),
          fmt::format("{}, as the first line has columns", columns_));
      return;
    }
    ReferenceState state;
    state.line = line_;
    state.name = std::string(cells[*at_[kName]]);
    const std::optional<double> time = Number(cells, kTime);
    const std::optional<Eigen::Vector3d> p_W = Position(cells);
    if (!time || !p_W || !IsKnown(state.name, cells) || !IsSample(*time, cells) ||
        !IsOfOneOracle(cells))
      return;
    state.time = *time;
    state.p_W = *p_W;
    if (at_[kOrientation] && !cells[*at_[kOrientation]].empty()) {
      state.q_WB = Orientation(cells);
      if (!state.q_WB) return;
    }
    read_.states.push_back(std::move(state));
  }

  /** Returns where a cell starts, counted from 1. */
  std::size_t Place(const std::vector<std::string_view>& cells,
                    std::size_t column) const {
    return static_cast<std::size_t>(cells[*at_[column]].data() - cells[0].data()) + 1;
  }

  std::optional<double> Number(const std::vector<std::string_view>& cells,
                               std::size_t column) {
    if (!at_[column]) return std::nullopt;
    const std::string_view cell = cells[*at_[column]];
    const std::optional<double> number = FiniteNumberIn(cell);
    if (!number) {
      Add(line_, Place(cells, column),
          fmt::format("{} is \"{}\"", kColumns[column], cell), "a finite number");
    }
    return number;
  }

  std::optional<Eigen::Vector3d> Position(const std::vector<std::string_view>& cells) {
    Eigen::Vector3d p_W;
    for (int i = 0; i < 3; ++i) {
      const auto number = Number(cells, kPosition + static_cast<std::size_t>(i));
      if (!number) return std::nullopt;
      p_W[i] = *number;
    }
    return p_W;
  }

  std::optional<Eigen::Quaterniond> Orientation(
      const std::vector<std::string_view>& cells) {
    std::array<double, 4> wxyz{};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto number = Number(cells, kOrientation + i);
      if (!number) return std::nullopt;
      wxyz[i] = *number;
    }
    const Eigen::Quaterniond q_WB(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
    if (!(std::abs(q_WB.norm() - 1) <= kRotationSlack)) {
      Add(line_, Place(cells, kOrientation), fmt::format("has norm {}", q_WB.norm()),
          "a unit quaternion");
      return std::nullopt;
    }
    return q_WB;
  }

  bool IsKnown(const std::string& name, const std::vector<std::string_view>& cells) {
    const auto has_name = [&](const auto& part) { return part.name == name; };
    if (std::any_of(world_.bodies.begin(), world_.bodies.end(), has_name) ||
        std::any_of(world_.particles.begin(), world_.particles.end(), has_name))
      return true;
    Add(line_, Place(cells, kName),
        fmt::format("name is \"{}\", which the world does not have", name),
        "the name of a body or particle");
    return false;
  }

  bool IsSample(double time, const std::vector<std::string_view>& cells) {
    const double spacing = world_.dt * world_.sample_every;
    const double samples = time / spacing;
    if (time >= 0 && time <= world_.steps * world_.dt + kStepSlack * world_.dt &&
        std::abs(samples - std::round(samples)) <= kStepSlack)
      return true;
    Add(line_, Place(cells, kTime), fmt::format("time is {}", time),
        fmt::format("a time of a sample, a multiple of {} s up to the end", spacing));
    return false;
  }

  bool IsOfOneOracle(const std::vector<std::string_view>& cells) {
    if (!at_[kOracle]) return true;
    const std::string_view oracle = cells[*at_[kOracle]];
    if (oracle_.empty()) oracle_ = oracle;
    if (oracle == oracle_) return true;
    Add(line_, Place(cells, kOracle),
        fmt::format("oracle is \"{}\" after \"{}\"", oracle, oracle_),
        "the rows of one oracle");
    return false;
  }

  const std::filesystem::path& file_;
  const World& world_;
  ReadTrajectory read_;
  std::array<std::optional<std::size_t>, kColumns.size()> at_;
  std::size_t columns_ = 0;
  int line_ = 1;
  std::string oracle_;  ///< That of the first row.
};

}  // namespace

ReadTrajectory ReadTrajectoryFile(const std::filesystem::path& file, const World& world) {
  return Reader(file, world)();
}

}  // namespace touchstone
