#include "scenarios/contact_table.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scenarios/csv_line.h"
#include "scenarios/schema/nearest_name.h"
#include "scenarios/schema/scenario_keys.h"
#include "scenarios/validate.h"

namespace touchstone {
namespace {

using Cells = std::vector<std::string_view>;

/** A program that writes one row wrongly writes all of them so. */
constexpr std::size_t kMostErrors = 5;

/** The column of a text that tells the row from the others. It may be left out. */
constexpr std::string_view kNameColumn = "name";

/** The columns of a body, without its name. A key of several numbers has a column for
 each, next to each other; only vertices share one. */
constexpr std::array<std::string_view, 15> kColumns = {
    "shape",       "radius",       "half_extents.x", "half_extents.y", "half_extents.z",
    "half_length", "half_height",  "vertices",       "position.x",     "position.y",
    "position.z",  "quaternion.w", "quaternion.x",   "quaternion.y",   "quaternion.z"};

constexpr std::array<char, 2> kBodies = {'A', 'B'};

/** Returns the key of a scenario file to which a column belongs. */
std::string_view KeyOf(std::string_view column) {
  return column.substr(0, column.find('.'));
}

/** Returns the first column of a key. @pre The key has a column. */
std::size_t FirstColumnOf(std::string_view key) {
  return static_cast<std::size_t>(std::ranges::find(kColumns, key, KeyOf) -
                                  kColumns.begin());
}

/** Returns the column at fault for the path of a Fault, e.g. "half_extents[1]". */
std::size_t ColumnAtFault(std::string_view path) {
  const std::string_view key = path.substr(0, path.find('['));
  const std::size_t first = FirstColumnOf(key);
  const bool is_whole = kColumns[first] == key || key.size() == path.size();
  return is_whole ? first : first + static_cast<std::size_t>(path[key.size() + 1] - '0');
}

bool IsSize(std::string_view column) {
  const std::string_view key = KeyOf(column);
  return key != "shape" && key != "position" && key != "quaternion";
}

bool HasKey(ShapeKind kind, std::string_view key) {
  return std::ranges::find(ShapeKeys(kind), key, &Key::name) != ShapeKeys(kind).end();
}

std::vector<std::string_view> ShapeNames() {
  std::vector<std::string_view> names;
  names.reserve(kShapeKinds);
  for (int kind = 0; kind < kShapeKinds; ++kind)
    names.push_back(NameOf(static_cast<ShapeKind>(kind)));
  return names;
}

/** Returns " (did you mean right?)", or nothing if no name is near. */
std::string Suggestion(std::string_view misspelt,
                       std::span<const std::string_view> names) {
  const std::string_view nearest = NearestName(misspelt, names);
  return nearest.empty() ? "" : fmt::format(" (did you mean {}?)", nearest);
}

/** The first error of a row, or of the header; it ends the reading of that. */
class TableError : public std::exception {
 public:
  explicit TableError(Diagnostic why) : why_(std::move(why)) {}
  const Diagnostic& why() const { return why_; }

 private:
  Diagnostic why_;
};

class Reader {
 public:
  Reader(std::string_view text, std::string_view file) : text_(text), file_(file) {}

  ContactTable operator()() try {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
    if (!NextLine())
      Fail("is empty", "a line that names the columns, e.g. A.shape,A.radius,…");
    ReadHeader();
    while (NextLine() && table_.errors.size() < kMostErrors) {
      if (!line_.empty() && line_ != "\r") TryRow();
    }
    if (!table_.errors.empty()) return Refused();
    if (table_.scenarios.empty())
      Fail("has no rows", "a question in each line below the names of the columns");
    if (normalised_ > 1)
      table_.note->what += fmt::format(", and so were {} more", normalised_ - 1);
    return std::move(table_);
  } catch (const TableError& error) {
    table_.errors.push_back(error.why());
    return Refused();
  }

 private:
  /** Returns the errors alone. */
  ContactTable Refused() {
    return {.scenarios = {}, .errors = std::move(table_.errors), .note = {}};
  }

  void TryRow() try { ReadRow(); } catch (const TableError& error) {
    table_.errors.push_back(error.why());
  }

  bool NextLine() {
    if (text_.empty()) return false;
    const std::size_t end = std::min(text_.find('\n'), text_.size());
    line_ = text_.substr(0, end);
    text_.remove_prefix(std::min(end + 1, text_.size()));
    ++number_;
    return true;
  }

  /** Throws an error of the whole file. */
  [[noreturn]] void Fail(std::string what, std::string expected) const {
    throw TableError({file_, 0, 0, std::move(what), std::move(expected)});
  }

  /** Throws an error in the line, at `part`, which is a view of it. */
  [[noreturn]] void Fail(std::string_view part, std::string what,
                         std::string expected) const {
    const std::string_view before =
        line_.substr(0, static_cast<std::size_t>(part.data() - line_.data()));
    // In UTF-8, a byte 10xxxxxx continues a code point.
    const auto column = std::ranges::count_if(
        before, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
    throw TableError({file_, number_, static_cast<int>(column) + 1, std::move(what),
                      std::move(expected)});
  }

  Cells CellsOfLine() const {
    const std::size_t quote = line_.find('"');
    if (quote != std::string_view::npos)
      Fail(line_.substr(quote), "there is a quotation mark", "cells without any");
    return CellsOf(line_);
  }

  void ReadHeader() {
    const Cells names = CellsOfLine();
    columns_ = names.size();
    std::vector<std::string> known;
    known.reserve(kBodies.size() * kColumns.size());
    for (const char body : kBodies) {
      for (const std::string_view column : kColumns)
        known.push_back(fmt::format("{}.{}", body, column));
    }
    known.emplace_back(kNameColumn);
    const std::vector<std::string_view> views(known.begin(), known.end());
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto at =
          static_cast<std::size_t>(std::ranges::find(views, names[i]) - views.begin());
      if (at == views.size()) {
        Fail(names[i],
             fmt::format("there is no column \"{}\"{}", names[i],
                         Suggestion(names[i], views)),
             "name, or columns of A and B: shape, sizes, position.x … z, quaternion.w … "
             "z");
      }
      std::optional<std::size_t>& cell =
          names[i] == kNameColumn ? name_
                                  : cells_[at / kColumns.size()][at % kColumns.size()];
      if (cell)
        Fail(names[i], fmt::format("{} is there twice", names[i]), "each column once");
      cell = i;
    }
    for (std::size_t body = 0; body < kBodies.size(); ++body) {
      Require(body, 0);
      for (std::size_t column = 0; column < kColumns.size(); ++column) {
        const std::size_t first = FirstColumnOf(KeyOf(kColumns[column]));
        if (cells_[body][column]) Require(body, first);
        if (cells_[body][first]) Require(body, column);
      }
    }
  }

  /** Requires the header to have a column. */
  void Require(std::size_t body, std::size_t column) const {
    if (!cells_[body][column])
      Fail(line_, fmt::format("there is no column {}", ColumnName(body, column)), "one");
  }

  static std::string ColumnName(std::size_t body, std::size_t column) {
    return fmt::format("{}.{}", kBodies[body], kColumns[column]);
  }

  void ReadRow() {
    row_ = CellsOfLine();
    if (row_.size() != columns_) {
      Fail(line_, fmt::format("has {} cells", row_.size()),
           fmt::format("{}, as the first line names columns", columns_));
    }
    Scenario scenario;
    scenario.contact = {BodyAt(0), BodyAt(1)};
    const std::vector<Fault> faults = FaultsOf(scenario.contact);
    if (!faults.empty()) FailOn(faults.front());
    scenario.id = fmt::format("line_{}", number_);
    scenario.title = fmt::format("{}Line {} of {}", NameAtRow(), number_,
                                 file_.substr(file_.rfind('/') + 1));
    scenario.source = fmt::format("{}:{}", file_, number_);
    scenario.name_A = kBodies[0];
    scenario.name_B = kBodies[1];
    table_.scenarios.push_back(std::move(scenario));
  }

  /** Returns the name of the row and ": ", nothing if it has none. */
  std::string NameAtRow() const {
    if (!name_ || row_[*name_].empty()) return "";
    const std::string_view name = row_[*name_];
    if (std::ranges::any_of(name, [](char c) { return c < ' ' || c > '~'; }))
      Fail(name, "name has a character that is not printable ASCII",
           "letters, digits, spaces and signs of ASCII");
    return fmt::format("{}: ", name);
  }

  [[noreturn]] void FailOn(const Fault& fault) const {
    const std::size_t body = fault.where.starts_with(kBodies[0]) ? 0 : 1;
    const std::string_view path = std::string_view(fault.where).substr(2);
    const std::size_t column = ColumnAtFault(path);
    // "A.half_extents[1]" has a column of its own, "A.quaternion" has four.
    const bool is_number = path.ends_with(']') && kColumns[column] != "vertices";
    Fail(row_[*cells_[body][column]],
         fmt::format("{} {}", is_number ? ColumnName(body, column) : fault.where,
                     fault.what),
         fault.expected);
  }

  Body BodyAt(std::size_t body) {
    const ShapeKind kind = KindAt(body);
    for (std::size_t column = 0; column < kColumns.size(); ++column) {
      if (!IsSize(kColumns[column])) continue;
      if (HasKey(kind, KeyOf(kColumns[column])))
        RequireSize(body, column, kind);
      else
        RefuseSize(body, column, kind);
    }
    return {ShapeAt(body, kind), PoseAt(body)};
  }

  ShapeKind KindAt(std::size_t body) const {
    const std::string_view cell = row_[*cells_[body][0]];
    const std::vector<std::string_view> names = ShapeNames();
    const auto found = std::ranges::find(names, cell);
    if (found == names.end()) {
      Fail(cell,
           fmt::format("{}.shape is \"{}\"{}", kBodies[body], cell,
                       Suggestion(cell, names)),
           fmt::format("one of {}", fmt::join(names, ", ")));
    }
    return static_cast<ShapeKind>(found - names.begin());
  }

  void RequireSize(std::size_t body, std::size_t column, ShapeKind kind) const {
    if (cells_[body][column]) return;
    Fail(row_[*cells_[body][0]],
         fmt::format("{}.shape is {}, and there is no column {}", kBodies[body],
                     NameOf(kind), ColumnName(body, column)),
         "one");
  }

  void RefuseSize(std::size_t body, std::size_t column, ShapeKind kind) const {
    if (!cells_[body][column]) return;
    const std::string_view cell = row_[*cells_[body][column]];
    if (cell.empty()) return;
    Fail(cell,
         fmt::format("{} is {}, but {}.shape is {}", ColumnName(body, column), cell,
                     kBodies[body], NameOf(kind)),
         "an empty cell");
  }

  double NumberAt(std::size_t body, std::size_t column) const {
    const std::string_view cell = row_[*cells_[body][column]];
    const std::optional<double> number = FiniteNumberIn(cell);
    if (!number) {
      Fail(cell, fmt::format("{} is \"{}\"", ColumnName(body, column), cell),
           "a finite number, without spaces");
    }
    return *number;
  }

  double NumberAt(std::size_t body, std::string_view key) const {
    return NumberAt(body, FirstColumnOf(key));
  }

  Eigen::Vector3d VectorAt(std::size_t body, std::string_view key) const {
    const std::size_t first = FirstColumnOf(key);
    return {NumberAt(body, first), NumberAt(body, first + 1), NumberAt(body, first + 2)};
  }

  Shape ShapeAt(std::size_t body, ShapeKind kind) const {
    switch (kind) {
      case ShapeKind::kSphere:
        return Sphere{NumberAt(body, "radius")};
      case ShapeKind::kBox:
        return Box{VectorAt(body, "half_extents")};
      case ShapeKind::kCapsule:
        return Capsule{NumberAt(body, "radius"), NumberAt(body, "half_length")};
      case ShapeKind::kCylinder:
        return Cylinder{NumberAt(body, "radius"), NumberAt(body, "half_length")};
      case ShapeKind::kCone:
        return Cone{NumberAt(body, "radius"), NumberAt(body, "half_height")};
      case ShapeKind::kConvexHull:
        return ConvexHull{VerticesAt(body)};
      case ShapeKind::kHalfSpace:
        return HalfSpace{};
    }
    return HalfSpace{};
  }

  /** Reads "x y z x y z …". */
  std::vector<Eigen::Vector3d> VerticesAt(std::size_t body) const {
    const std::string_view cell = row_[*cells_[body][FirstColumnOf("vertices")]];
    std::vector<double> numbers;
    for (std::size_t at = 0; at < cell.size();) {
      const std::size_t end = std::min(cell.find(' ', at), cell.size());
      const std::string_view word = cell.substr(at, end - at);
      const std::optional<double> number = FiniteNumberIn(word);
      if (!number) {
        Fail(cell.substr(at), fmt::format("{}.vertices has \"{}\"", kBodies[body], word),
             "finite numbers, one space between two");
      }
      numbers.push_back(*number);
      at = end + 1;
    }
    if (numbers.empty() || numbers.size() % 3 != 0) {
      Fail(cell, fmt::format("{}.vertices has {} numbers", kBodies[body], numbers.size()),
           "three for each vertex");
    }
    std::vector<Eigen::Vector3d> vertices;
    vertices.reserve(numbers.size() / 3);
    for (std::size_t i = 0; i < numbers.size(); i += 3)
      vertices.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    return vertices;
  }

  Pose PoseAt(std::size_t body) {
    const Eigen::Vector3d p_WB = cells_[body][FirstColumnOf("position")]
                                     ? VectorAt(body, "position")
                                     : Eigen::Vector3d::Zero();
    const std::size_t w = FirstColumnOf("quaternion");
    if (!cells_[body][w])
      return Pose::FromQuaternion(p_WB, Eigen::Quaterniond::Identity());
    const Eigen::Quaterniond q(NumberAt(body, w), NumberAt(body, w + 1),
                               NumberAt(body, w + 2), NumberAt(body, w + 3));
    const std::optional<double> norm = NormToDivideBy(q);
    if (!norm) return Pose::FromQuaternion(p_WB, q);
    if (normalised_++ == 0) {
      table_.note =
          Diagnostic{file_, number_, 1,
                     fmt::format("{}.quaternion has norm {}; it was divided by it",
                                 kBodies[body], *norm),
                     ""};
    }
    return Pose::FromQuaternion(p_WB,
                                Eigen::Quaterniond(Eigen::Vector4d(q.coeffs() / *norm)));
  }

  std::string_view text_;  ///< That was not read yet.
  std::string file_;
  std::string_view line_;
  int number_ = 0;  ///< Of the line.
  std::size_t columns_ = 0;
  /** The cell of each body and column in a row; empty for a column that is not there. */
  std::array<std::array<std::optional<std::size_t>, kColumns.size()>, kBodies.size()>
      cells_{};
  std::optional<std::size_t> name_;  ///< The cell of the row's name.
  Cells row_;
  std::size_t normalised_ = 0;
  ContactTable table_;
};

}  // namespace

ContactTable ReadContactTable(std::string_view text, std::string_view file_name) {
  return Reader(text, file_name)();
}

ContactTable ReadContactTableFile(const std::filesystem::path& file) {
  const std::string name = file.generic_string();
  std::error_code error;
  std::ifstream in;
  if (std::filesystem::is_regular_file(file, error)) in.open(file, std::ios::binary);
  if (!in.is_open()) {
    return {.scenarios = {},
            .errors = {{name, 0, 0, "cannot be read", "a CSV file"}},
            .note = {}};
  }
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return ReadContactTable(text, name);
}

}  // namespace touchstone
