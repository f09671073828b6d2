#include "reports/writers/data/cited_data.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace touchstone {
namespace {

/** The digits that sentences have. */
constexpr int kDigits = 9;

/** Returns the indices of the bodies among `names`; particles are left out. */
DataJson BodiesOf(const World& world, const std::vector<std::string>& names) {
  DataJson bodies = DataJson::array();
  for (const std::string& name : names) {
    const auto body =
        std::find_if(world.bodies.begin(), world.bodies.end(),
                     [&](const RigidBody& each) { return each.name == name; });
    if (body != world.bodies.end()) bodies.push_back(body - world.bodies.begin());
  }
  return bodies;
}

}  // namespace

DataJson CitedData(const RunReport& report, const Clusters& clusters) {
  DataJson data = {{"finding", DataJson::array()},
                   {"bodies", DataJson::array()},
                   {"points", DataJson::array()}};
  for (std::size_t f = 0; f < report.findings.size(); ++f) {
    const Cited& cited = report.findings[f].cited;
    if (cited.names.empty() && cited.points_W.empty()) continue;
    const std::size_t world = clusters.places[f].question - report.scenarios.size();
    DataJson bodies = BodiesOf(report.worlds[world].scenario.world, cited.names);
    if (bodies.empty() && cited.points_W.empty()) continue;
    DataJson points = DataJson::array();
    for (const Eigen::Vector3d& p_W : cited.points_W)
      points.push_back(ToData(p_W, kDigits));
    data["finding"].push_back(f);
    data["bodies"].push_back(std::move(bodies));
    data["points"].push_back(std::move(points));
  }
  return data;
}

}  // namespace touchstone
