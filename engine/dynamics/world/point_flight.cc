#include "engine/dynamics/world/point_flight.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/dynamics/body/time_of_fall.h"

namespace cookbook {
namespace {

/** Bounces in a step after which a point stays where it bounces. */
constexpr int kMostBounces = 8;

/** A point nearer to a face than this, relative to the coordinates, is on it. */
constexpr double kOnFace = 16 * std::numeric_limits<double>::epsilon();

/** Returns (exp(−z) − 1 + z)/z². */
double SecondPhi(double z) {
  if (std::abs(z) > 0.5) return (std::expm1(-z) + z) / (z * z);
  // Its power series, without the cancellation: Σ (−z)^k / (k + 2)!.
  double term = 0.5;
  double sum = 0;
  for (int k = 0; k < 15; ++k) {
    sum += term;
    term *= -z / (k + 3);
  }
  return sum;
}

/** One face of a solid: what is at n·p < offset is below it. */
struct Face {
  Eigen::Vector3d n_W;
  double offset;  ///< [m]
};

struct Hit {
  double time;  ///< [s]
  Face face;
};

bool IsBelow(const Face& face, const Eigen::Vector3d& p) {
  const double rounding = kOnFace * (p.lpNorm<1>() + std::abs(face.offset));
  return face.n_W.dot(p) - face.offset < -rounding;
}

/** Returns n·u, or 0 where that is what rounding leaves of zero. */
double AcrossUnlessRounding(const Face& face, const Eigen::Vector3d& u) {
  const double across = face.n_W.dot(u);
  return std::abs(across) <= kOnFace * u.lpNorm<1>() ? 0 : across;
}

/** Returns when the point falls through the face, if it does within `limit` [s]. */
std::optional<double> TimeThrough(const Face& face, const Flight& flight, double limit) {
  if (IsBelow(face, flight.p)) return std::nullopt;
  const double height = std::max(0.0, face.n_W.dot(flight.p) - face.offset);
  const double speed = AcrossUnlessRounding(face, flight.v);
  const double load = AcrossUnlessRounding(face, flight.a);
  const std::optional<double> time = TimeOfFall(height, speed, load);
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

Flight After(double t, const Flight& flight) {
  return {flight.p + t * (flight.v + 0.5 * t * flight.a), flight.v + t * flight.a,
          flight.a};
}

/** Returns the first hit within `limit` [s]. A solid is the common part of what is below
 its faces: its surface is met where the way falls through one face while it is below the
 others. */
std::optional<Hit> FirstHit(const Flight& flight, double limit,
                            std::span<const RigidBody> bodies,
                            std::span<const int> solids) {
  std::optional<Hit> first;
  for (const int index : solids) {
    const RigidBody& solid = bodies[static_cast<std::size_t>(index)];
    ForEachFace(solid, [&](const Face& face) {
      const std::optional<double> time = TimeThrough(face, flight, limit);
      if (!time || (first && *time >= first->time)) return;
      const Eigen::Vector3d p = After(*time, flight).p;
      bool within = true;
      ForEachFace(solid, [&](const Face& other) {
        if (other.n_W == face.n_W) return;
        within = within && other.n_W.dot(p) < other.offset;
      });
      if (within) first = Hit{*time, face};
    });
  }
  return first;
}

/** Takes out of `u` what goes into the face. */
void StopInto(const Face& face, Eigen::Vector3d& u) {
  u -= std::min(0.0, face.n_W.dot(u)) * face.n_W;
}

}  // namespace

Drag::Drag(double c, double h) {
  const double z = c * h;
  kept = std::exp(-z);
  gain = z == 0 ? 1 : -std::expm1(-z) / z;
  share = SecondPhi(z) / gain;
}

Landing Follow(const Flight& flight, double h, double bounce, double resting_speed,
               std::span<const RigidBody> bodies, std::span<const int> solids) {
  Flight now = flight;
  Landing landing;
  double left = h;
  for (int bounces = 0;; ++bounces) {
    const std::optional<Hit> hit = FirstHit(now, left, bodies, solids);
    if (!hit) break;
    landing.hit = true;
    now = After(hit->time, now);
    left -= hit->time;
    const double approach = hit->face.n_W.dot(now.v);
    if (bounces < kMostBounces && approach < -resting_speed) {
      now.v -= (1 + bounce) * approach * hit->face.n_W;
    } else {
      StopInto(hit->face, now.v);
      StopInto(hit->face, now.a);
    }
    // On the face, not a rounding below it.
    now.p += (hit->face.offset - hit->face.n_W.dot(now.p)) * hit->face.n_W;
    if (bounces == 2 * kMostBounces) break;  // Held in a corner.
  }
  now = After(left, now);
  landing.p_W = now.p;
  landing.v_W = now.v;
  return landing;
}

}  // namespace cookbook
