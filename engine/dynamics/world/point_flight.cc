#include "engine/dynamics/world/point_flight.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/dynamics/body/time_of_fall.h"

namespace cookbook {
namespace {

/** Maximum number of bounces in a step. After that the point stays on the face. */
constexpr int kMaxBounces = 8;

/** Tolerance of points on a face, relative to the coordinates. */
constexpr double kOnFace = 16 * std::numeric_limits<double>::epsilon();

/** Returns (exp(−z) − 1 + z)/z². */
double SecondPhi(double z) {
  if (std::abs(z) > 0.5) return (std::expm1(-z) + z) / (z * z);
  // The power series Σ (−z)^k / (k + 2)! avoids the cancellation.
  double term = 0.5;
  double sum = 0;
  for (int k = 0; k < 15; ++k) {
    sum += term;
    term *= -z / (k + 3);
  }
  return sum;
}

/** A face of a solid, which is at n·p < offset. */
struct Face {
  Eigen::Vector3d n_W;
  double offset;  ///< [m]
};

/** The impact of a point on a face. */
struct Hit {
  double time;  ///< [s]
  Face face;
};

bool IsBelow(const Face& face, const Eigen::Vector3d& p) {
  const double rounding = kOnFace * (p.lpNorm<1>() + std::abs(face.offset));
  return face.n_W.dot(p) - face.offset < -rounding;
}

/** Returns n·u, or 0 if it is below the rounding error. */
double NormalComponent(const Face& face, const Eigen::Vector3d& u) {
  const double component = face.n_W.dot(u);
  return std::abs(component) <= kOnFace * u.lpNorm<1>() ? 0 : component;
}

/** Returns the time at which the point crosses the face from outside, up to `limit` [s].
 */
std::optional<double> TimeOfCrossing(const Face& face, const PointFlight& flight,
                                     double limit) {
  if (IsBelow(face, flight.p)) return std::nullopt;
  const double height = std::max(0.0, face.n_W.dot(flight.p) - face.offset);
  const double speed = NormalComponent(face, flight.v);
  const double acceleration = NormalComponent(face, flight.a);
  const std::optional<double> time = TimeOfFall(height, speed, acceleration);
  if (!time || *time > limit) return std::nullopt;
  return time;
}

template <class Visit>
void ForEachFace(const RigidBody& solid, const Visit& visit) {
  if (std::holds_alternative<HalfSpace>(solid.shape)) {
    const Eigen::Vector3d n = solid.R_WB.col(2);
    visit(Face{n, n.dot(solid.state.p_WB)});
    return;
  }
  const auto* box = std::get_if<Box>(&solid.shape);
  if (box == nullptr) return;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const Eigen::Vector3d n = side * solid.R_WB.col(axis);
      visit(Face{n, n.dot(solid.state.p_WB) + box->half_extents[axis]});
    }
  }
}

PointFlight FlightAfter(double t, const PointFlight& flight) {
  return {flight.p + t * (flight.v + 0.5 * t * flight.a), flight.v + t * flight.a,
          flight.a};
}

/** Returns the first hit up to `limit` [s]. A solid is the intersection of the
 half-spaces below its faces. The point hits it where it crosses one face while it is
 below all others. */
std::optional<Hit> FirstHit(const PointFlight& flight, double limit,
                            std::span<const RigidBody> bodies,
                            std::span<const int> solids) {
  std::optional<Hit> first;
  for (const int index : solids) {
    const RigidBody& solid = bodies[static_cast<std::size_t>(index)];
    ForEachFace(solid, [&](const Face& face) {
      const std::optional<double> time = TimeOfCrossing(face, flight, limit);
      if (!time || (first && *time >= first->time)) return;
      const Eigen::Vector3d p = FlightAfter(*time, flight).p;
      bool is_inside_others = true;
      ForEachFace(solid, [&](const Face& other) {
        if (other.n_W == face.n_W) return;
        is_inside_others = is_inside_others && other.n_W.dot(p) < other.offset;
      });
      if (is_inside_others) first = Hit{*time, face};
    });
  }
  return first;
}

/** Removes the component of `u` that points into the face. */
void RemoveInwardComponent(const Face& face, Eigen::Vector3d& u) {
  u -= std::min(0.0, face.n_W.dot(u)) * face.n_W;
}

}  // namespace

Drag::Drag(double c, double h) {
  const double z = c * h;
  decay = std::exp(-z);
  force_factor = z == 0 ? 1 : -std::expm1(-z) / z;
  travel_factor = SecondPhi(z) / force_factor;
}

PointFlightEnd FollowPoint(const PointFlight& flight, double h, double restitution,
                           double resting_speed, std::span<const RigidBody> bodies,
                           std::span<const int> solids) {
  PointFlight current = flight;
  PointFlightEnd end;
  double remaining = h;
  for (int bounces = 0;; ++bounces) {
    const std::optional<Hit> hit = FirstHit(current, remaining, bodies, solids);
    if (!hit) break;
    end.hit = true;
    current = FlightAfter(hit->time, current);
    remaining -= hit->time;
    const double normal_velocity = hit->face.n_W.dot(current.v);
    if (bounces < kMaxBounces && normal_velocity < -resting_speed) {
      current.v -= (1 + restitution) * normal_velocity * hit->face.n_W;
    } else {
      RemoveInwardComponent(hit->face, current.v);
      RemoveInwardComponent(hit->face, current.a);
    }
    // Exactly on the face, not below it by rounding.
    current.p += (hit->face.offset - hit->face.n_W.dot(current.p)) * hit->face.n_W;
    if (bounces == 2 * kMaxBounces) break;  // Trapped in a corner.
  }
  current = FlightAfter(remaining, current);
  end.p_W = current.p;
  end.v_W = current.v;
  return end;
}

}  // namespace cookbook
