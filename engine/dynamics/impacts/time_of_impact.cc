#include "engine/dynamics/impacts/time_of_impact.h"

#include <algorithm>
#include <cmath>

#include "engine/dynamics/body/time_of_fall.h"
#include "engine/dynamics/contacts/collide_bodies.h"

namespace cookbook {
namespace {

/** Looks at two bodies in a step. Some three will do, some eight where they turn. */
constexpr int kMostLooks = 32;

/** Bodies apart by less than this share of the smaller touch: what is left costs a impact
 as much of its place. */
constexpr double kTouch = 1e-10;

/** What touches so near the end of the step, as a share of it, touches at the start of
 the next. */
constexpr double kNext = 1e-9;

/** Where bodies touch and no contact strikes, another may do so soon: looks are then this
 share of a step apart. */
constexpr double kIterationBudget = 1.0 / 4;

Eigen::Vector3d PointVelocity(const RigidBody& body, const Eigen::Vector3d& p_W) {
  return body.state.v_WB + body.state.w_WB.cross(p_W - body.state.p_WB);
}

bool Strikes(const Manifold& manifold, const RigidBody& A, const RigidBody& B,
             const Eigen::Vector3d& a_AB_W, const ImpactRules& rules) {
  const auto points = manifold.points();
  const double load = LoadBetween(A, B);
  return std::any_of(points.begin(), points.end(), [&](const ContactPoint& contact) {
    const ContactPhase meeting =
        PhaseAt(contact.p_WC, manifold.n_AB_W, A, B, a_AB_W, load, rules);
    if (meeting != ContactPhase::kResting) return meeting == ContactPhase::kImpacting;
    // The next step would hold it, had it not come too far by then.
    const double approach = manifold.n_AB_W.dot(PointVelocity(A, contact.p_WC) -
                                                PointVelocity(B, contact.p_WC));
    return MayGoThrough(A, B, rules.h * approach);
  });
}

/** A time at which two bodies are apart and a later one at which they are inside each
 other. */
struct Bracket {
  double apart = 0;   ///< [s]
  double inside = 0;  ///< [s]
  double apart_gap = 0;
  double inside_gap = 0;
  bool is_open = false;    ///< Whether `apart` is known.
  bool is_closed = false;  ///< Whether both are.
  int same_side = 0;

  void SetApart(double t, double gap) {
    apart = t;
    apart_gap = gap;
    if (is_closed) Weigh(1, inside_gap);
    is_open = true;
  }

  void SetInside(double t, double gap) {
    inside = t;
    inside_gap = gap;
    if (is_closed) Weigh(-1, apart_gap);
    is_closed = true;
  }

  /** Halves the gap of the end that stays twice, so that both ends close in: the Illinois
   rule (Dowell & Jarratt, BIT 11, 1971). */
  void Weigh(int side, double& other_gap) {
    if (same_side == side) other_gap /= 2;
    same_side = side;
  }

  double Between() const {
    return apart + (inside - apart) * apart_gap / (apart_gap - inside_gap);
  }
};

/** Returns the point of `body` that is farthest along `n_W`, a ball's centre. */
Eigen::Vector3d FarthestAlong(const Eigen::Vector3d& n_W, const RigidBody& body) {
  const auto* box = std::get_if<Box>(&body.shape);
  if (box == nullptr || body.is_static()) return body.state.p_WB;
  const Eigen::Vector3d n_B = body.R_WB.transpose() * n_W;
  const Eigen::Array3d sides = (n_B.array() < 0).select(-Eigen::Array3d::Ones(), 1.0);
  return body.state.p_WB + body.R_WB * (sides * box->half_extents.array()).matrix();
}

/** Returns in which time two bodies may have met that are apart: when the points that
 face each other meet, but not less than is safe whatever turns; and, where those points
 do not meet, no less than it pays to look at. [s] */
double TimeToMeet(const Manifold& manifold, const RigidBody& A, const RigidBody& B,
                  const Eigen::Vector3d& a_AB_W, double h) {
  const Eigen::Vector3d& n = manifold.n_AB_W;
  const double gap = manifold.separation;
  const double load = n.dot(a_AB_W);
  const double turning = RotationalSpeed(A, n) + RotationalSpeed(B, n);
  const double parting = n.dot(B.state.v_WB - A.state.v_WB);
  const std::optional<double> safe = TimeOfFall(gap, parting - turning, load);
  if (!safe) return h;
  if (turning == 0) return *safe;
  const double facing = n.dot(PointVelocity(B, FarthestAlong(-n, B)) -
                              PointVelocity(A, FarthestAlong(n, A)));
  const std::optional<double> meet = TimeOfFall(gap, facing, load);
  return std::max(*safe, meet.value_or(kIterationBudget * h));
}

}  // namespace

double TouchOf(const RigidBody& A, const RigidBody& B) {
  return kTouch * (A.is_static()   ? B.radius
                   : B.is_static() ? A.radius
                                   : std::min(A.radius, B.radius));
}

Manifold CollideAtImpact(const RigidBody& A, const RigidBody& B) {
  Manifold manifold;
  CollideSpeculative(SpeculativeMarginBetween(A, B) + TouchOf(A, B), A, B,
                     Eigen::Vector3d::Zero(), manifold);
  return manifold;
}

bool MayGoThrough(const RigidBody& A, const RigidBody& B, double way) {
  return way > 0.5 * (InnerRadius(A) + InnerRadius(B));
}

ContactPhase PhaseAt(const Eigen::Vector3d& p_W, const Eigen::Vector3d& n_AB_W,
                     const RigidBody& A, const RigidBody& B,
                     const Eigen::Vector3d& a_AB_W, double load,
                     const ImpactRules& rules) {
  const Eigen::Vector3d v_A = PointVelocity(A, p_W);
  const Eigen::Vector3d v_B = PointVelocity(B, p_W);
  const double approach = n_AB_W.dot(v_B - v_A);
  const double gain = rules.h * n_AB_W.dot(a_AB_W);
  const double fast = rules.resting_speed * (rules.h * load + std::abs(gain));
  if (approach > fast) return ContactPhase::kSeparating;
  // Most contacts rest: known without a root.
  const double least = std::min(approach, gain);
  const double together_at_most = kTogether * (v_A.lpNorm<1>() + v_B.lpNorm<1>());
  if (least < -together_at_most && approach >= -fast) return ContactPhase::kResting;
  if (least >= 0) return ContactPhase::kSeparating;
  const double together = kTogether * (v_A.norm() + v_B.norm());
  if (approach >= -together && gain >= -together) return ContactPhase::kSeparating;
  return approach < -std::max(fast, together) ? ContactPhase::kImpacting
                                              : ContactPhase::kResting;
}

std::optional<double> TimeOfImpact(const FreeFlight& A, const FreeFlight& B, double from,
                                   const ImpactRules& rules) {
  const Eigen::Vector3d a_AB_W = B.a_W - A.a_W;
  const Eigen::Vector3d load_AB_W = B.load_W - A.load_W;
  const double touch = TouchOf(A.start, B.start);
  const double h = rules.h;
  double t = from;
  Bracket bracket;
  for (int look = 0; look < kMostLooks; ++look) {
    const RigidBody a = A.ShapeAt(t, rules.gyroscopic);
    const RigidBody b = B.ShapeAt(t, rules.gyroscopic);
    const Manifold manifold = CollideAtImpact(a, b);
    const double gap = manifold.separation;
    if (gap > touch) {
      if (t >= h) return std::nullopt;
      bracket.SetApart(t, gap);
      t = bracket.is_closed ? bracket.Between()
                            : std::min(h, t + TimeToMeet(manifold, a, b, a_AB_W, h));
    } else if (gap < -touch && bracket.is_open) {
      bracket.SetInside(t, gap);
      t = bracket.Between();
    } else {
      if (t >= (1 - kNext) * h) return std::nullopt;
      if (Strikes(manifold, a, b, load_AB_W, rules)) return t;
      bracket = {};
      t = std::min(h, t + kIterationBudget * h);
    }
  }
  return std::nullopt;
}

}  // namespace cookbook
