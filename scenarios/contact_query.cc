#include "scenarios/contact_query.h"

#include <algorithm>

namespace touchstone {
namespace {

double Extent(const Body& body) {
  return body.X_WB.p_WB.cwiseAbs().maxCoeff() + BoundingRadius(body.shape);
}

}  // namespace

double SceneSize(const ContactQuery& query) {
  return std::max(Extent(query.A), Extent(query.B));
}

}  // namespace touchstone
