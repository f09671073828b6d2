#include "reports/clusters/ordinary.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/contacts/body_size.h"

namespace touchstone {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/** Returns the decades by which `value` is above `limit`; 0 below it and for a NaN. */
double DecadesAbove(double value, double limit) {
  return value > limit ? std::log10(value / limit) : 0;
}

double DecadesOutside(double value, double lo, double hi) {
  return DecadesAbove(value, hi) + DecadesAbove(lo, value);
}

/** Returns the decades of an extent outside what engines are used for. */
double DecadesOfExtent(double extent) {
  return DecadesOutside(extent, 0.01, 10);
}

/** Returns the smallest |separation| that the truth allows. [m] */
double LeastSeparation(const Enclosure& separation) {
  if (separation.lo <= 0 && separation.hi >= 0) return 0;
  return std::min(std::abs(separation.lo), std::abs(separation.hi));
}

}  // namespace

double OrdinaryOf(const ContactQuery& query, const ContactTruth& truth) {
  constexpr double kNearestDecades = 1;
  const double extent = SmallerExtent(query);
  const double thickness = 2 * SmallestFeature(query);
  const double nearness = std::min(
      kNearestDecades, DecadesAbove(extent / 1000, LeastSeparation(truth.separation)));
  return 1 / (1 + DecadesOfExtent(extent) + DecadesAbove(extent / thickness, 10) +
              DecadesAbove(SceneSize(query) / extent, 100) + nearness);
}

double OrdinaryOf(const World& world) {
  double extent = kInfinity;
  double lightest = kInfinity;
  double heaviest = 0;
  double farthest = 0;
  double fastest = 0;
  const auto weigh = [&](double mass) {
    if (mass == 0) return;
    lightest = std::min(lightest, mass);
    heaviest = std::max(heaviest, mass);
  };
  for (const RigidBody& body : world.bodies) {
    if (body.mass == 0) continue;
    weigh(body.mass);
    extent = std::min(extent, 2 * BoundingRadius(body.placed.shape));
    farthest = std::max(farthest, body.placed.X_WB.p_WB.cwiseAbs().maxCoeff());
    fastest = std::max(fastest, body.v_WB.norm());
  }
  for (const Particle& particle : world.particles) weigh(particle.mass);
  double decades =
      DecadesAbove(heaviest / lightest, 100) + DecadesAbove(world.dt, 1.0 / 30);
  if (extent < kInfinity) {
    decades += DecadesOfExtent(extent) + DecadesAbove(farthest / extent, 1000) +
               DecadesAbove(fastest * world.dt / extent, 1);
  }
  return 1 / (1 + decades);
}

}  // namespace touchstone
