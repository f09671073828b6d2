#include "reports/worlds/law_support/citing.h"

#include <algorithm>

#include "reports/text/format_vector.h"
#include "reports/text/quoted_name.h"

namespace touchstone {

void Cite(const CitedName& name, Cited& cited) {
  const bool is_known =
      std::find(cited.names.begin(), cited.names.end(), name.name) != cited.names.end();
  if (name.is_part_of_world && !is_known) cited.names.emplace_back(name.name);
}

void Cite(const CitingProof& part, Cited& cited) {
  for (const std::string& name : part.cited.names) Cite(CitedName{name}, cited);
  for (const Eigen::Vector3d& p_W : part.cited.points_W) Cite(CitedPoint{p_W}, cited);
  if (part.cited.time) cited.time = part.cited.time;
}

void Cite(const CitedTime& time, Cited& cited) {
  cited.time = time.time;
}

void Cite(const CitedPoint& point, Cited& cited) {
  cited.points_W.push_back(point.p_W);
}

std::string_view ShownOf(const CitingProof& part) {
  return part.sentence;
}

std::string ShownOf(const CitedName& name) {
  return name.is_part_of_world ? QuotedName(name.name) : std::string(name.name);
}

double ShownOf(const CitedTime& time) {
  return time.time;
}

std::string ShownOf(const CitedPoint& point) {
  return FormatVector(point.p_W, point.digits);
}

}  // namespace touchstone
