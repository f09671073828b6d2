#include "scenarios/toml/values.h"

#include <algorithm>

namespace touchstone {

double NumberFrom(const toml::node* node, double otherwise) {
  if (const auto* number = node ? node->as_floating_point() : nullptr)
    return number->get();
  // node::value<double>() would refuse an integer beyond 2^53, although any decimal is
  // rounded to a double.
  if (const auto* integer = node ? node->as_integer() : nullptr) {
    return static_cast<double>(integer->get());
  }
  return otherwise;
}

bool AreNumbers(const toml::node* node, std::size_t size) {
  const toml::array* array = node ? node->as_array() : nullptr;
  return array && array->size() == size &&
         std::all_of(array->begin(), array->end(),
                     [](const toml::node& element) { return element.is_number(); });
}

std::string TextFrom(const toml::table& table, std::string_view key) {
  return table[key].value_or(std::string());
}

Eigen::Vector3d VectorFrom(const toml::node* node, const Eigen::Vector3d& otherwise) {
  const toml::array* array = node ? node->as_array() : nullptr;
  if (!array || array->size() != 3) return otherwise;
  return {NumberFrom(array->get(0), otherwise[0]),
          NumberFrom(array->get(1), otherwise[1]),
          NumberFrom(array->get(2), otherwise[2])};
}

std::vector<Eigen::Vector3d> PointsFrom(const toml::array& array) {
  std::vector<Eigen::Vector3d> points;
  for (const toml::node& element : array) {
    points.push_back(VectorFrom(&element, Eigen::Vector3d::Zero()));
  }
  return points;
}

std::vector<const toml::table*> TablesFrom(const toml::table& table,
                                           std::string_view key) {
  std::vector<const toml::table*> tables;
  if (const toml::array* array = table[key].as_array()) {
    for (const toml::node& element : *array) tables.push_back(element.as_table());
  }
  return tables;
}

namespace {

std::vector<MeasureKind> MeasuresFrom(const toml::table& table, std::string_view key) {
  std::vector<MeasureKind> measures;
  const toml::array* array = table[key].as_array();
  if (!array) return measures;
  for (const toml::node& element : *array) {
    const auto measure = MeasureNamed(element.value_or(std::string_view()));
    if (measure) measures.push_back(*measure);
  }
  return measures;
}

}  // namespace

std::vector<Indictment> IndictmentsFrom(const toml::table& file) {
  std::vector<Indictment> indictments;
  for (const toml::table* table : TablesFrom(file, "indicts")) {
    if (!table) continue;
    indictments.push_back({TextFrom(*table, "oracle"), MeasuresFrom(*table, "measures"),
                           TextFrom(*table, "anomaly"),
                           (*table)["reproduces"].value_or(false)});
  }
  return indictments;
}

}  // namespace touchstone
