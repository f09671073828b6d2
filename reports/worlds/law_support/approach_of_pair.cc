#include "reports/worlds/law_support/approach_of_pair.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/pairs.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

/** Returns, for each body, whether it may touch more than one other body between samples
 `s` − 1 and `s`. */
std::vector<bool> MayTouchSeveral(const World& world, const AllowedMotion& slowed,
                                  std::size_t s) {
  const std::size_t count = world.bodies.size();
  std::vector<Body> placed;
  std::vector<double> travelled;
  const double time = SampleSpacing(world);
  for (std::size_t i = 0; i < count; ++i) {
    placed.push_back(PlacedAt(world, slowed.At(s - 1), static_cast<int>(i)));
    const double speed =
        slowed.At(s - 1).bodies[i].v_WB.norm() + slowed.At(s).bodies[i].v_WB.norm();
    travelled.push_back(
        world.bodies[i].mass > 0
            ? time * (speed + AccelerationOf(world, world.bodies[i]).norm() * time)
            : 0);
  }
  std::vector<int> near(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!Collide(world, static_cast<int>(i), static_cast<int>(j)) ||
          AreFarApart(placed[i], placed[j], travelled[i] + travelled[j]))
        continue;
      ++near[i];
      ++near[j];
    }
  }
  std::vector<bool> several;
  several.reserve(count);
  for (const int n : near) several.push_back(n > 1);
  return several;
}

/** The deepest point of one of two bodies that penetrate each other. */
class DeepestPoint {
 public:
  DeepestPoint(const World& world, int body, const BodyState& deep,
               const DeepestOverlap& overlap)
      : world_(world),
        body_(world.bodies[static_cast<std::size_t>(body)]),
        n_W_(overlap.n_W),
        r_B_(deep.q_WB.normalized().conjugate() * (overlap.p_W - deep.p_WB)) {}

  /** Returns how fast the point moves along the normal at a state of the body, and may
   come to move within a step as the body turns. [m/s] */
  double AlongNormal(const BodyState& at) const {
    const Eigen::Vector3d r_W = at.q_WB.normalized() * r_B_;
    const Eigen::Vector3d turning_W = at.w_WB.cross(r_W);
    return std::abs(n_W_.dot(at.v_WB + turning_W)) +
           world_.dt * std::abs(n_W_.dot(at.w_WB.cross(turning_W)));
  }

  /** Returns the same for a body that may have turned anywhere about the part of its spin
   along the normal. [m/s] */
  double Turned(const BodyState& at) const {
    return std::abs(n_W_.dot(at.v_WB)) + n_W_.cross(at.w_WB).norm() * Lever();
  }

  /** Returns how far along the normal the point is in a state of the body. The centre of
   a sphere stands for its points, which are not the same at two times. [m] */
  double PlaceAlongNormal(const BodyState& at) const {
    if (body_.mass == 0) return 0;
    if (std::holds_alternative<Sphere>(body_.placed.shape)) return n_W_.dot(at.p_WB);
    return n_W_.dot(at.p_WB + at.q_WB.normalized() * r_B_);
  }

 private:
  double Lever() const {
    return std::holds_alternative<Sphere>(body_.placed.shape) ? 0 : r_B_.norm();
  }

  const World& world_;
  const RigidBody& body_;
  Eigen::Vector3d n_W_;
  Eigen::Vector3d r_B_;
};

/** Returns the largest speed of any point of a body that moves and collides. [m/s] */
double FastestOf(const World& world, const WorldState& state) {
  double fastest = 0;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const RigidBody& body = world.bodies[i];
    if (body.mass == 0 || !body.collides) continue;
    const double lever = std::holds_alternative<Sphere>(body.placed.shape)
                             ? 0
                             : BoundingRadius(body.placed.shape);
    fastest = std::max(fastest,
                       state.bodies[i].v_WB.norm() + state.bodies[i].w_WB.norm() * lever);
  }
  return fastest;
}

}  // namespace

ApproachOfPair::ApproachOfPair(const Motion& motion) : motion_(motion), slowed_(motion) {
  if (motion.world.sample_every == 1) return;
  touches_several_.resize(motion.trajectory.samples.size());
  for (std::size_t s = 1; s < touches_several_.size(); ++s)
    touches_several_[s] = MayTouchSeveral(motion.world, slowed_, s);
}

double ApproachOfPair::SpeedOf(std::size_t s, int A, int B,
                               const DeepestOverlap& overlap) const {
  return SpeedOfBody(s, A, overlap) + SpeedOfBody(s, B, overlap);
}

double ApproachOfPair::SpeedOfBody(std::size_t s, int body,
                                   const DeepestOverlap& overlap) const {
  const auto i = static_cast<std::size_t>(body);
  if (motion_.world.bodies[i].mass == 0) return 0;
  const DeepestPoint point(motion_.world, body, slowed_.At(s).bodies[i], overlap);
  double fastest = 0;
  for (const std::size_t k : {s - 1, s}) {
    const BodyState& at = slowed_.At(k).bodies[i];
    fastest = std::max(fastest, touches_several_.empty() ? point.AlongNormal(at)
                                : touches_several_[s][i]
                                    ? FastestOf(motion_.world, slowed_.At(k))
                                    : point.Turned(at));
  }
  return fastest;
}

double ApproachOfPair::DeepenedBy(std::size_t s, int A, int B,
                                  const DeepestOverlap& overlap) const {
  const auto advance_of = [&](int body) {
    const auto i = static_cast<std::size_t>(body);
    const BodyState& now = motion_.trajectory.samples[s].bodies[i];
    const DeepestPoint point(motion_.world, body, now, overlap);
    return point.PlaceAlongNormal(now) -
           point.PlaceAlongNormal(motion_.trajectory.samples[s - 1].bodies[i]);
  };
  return advance_of(A) - advance_of(B);
}

bool ApproachOfPair::MayHaveTouchedThird(std::size_t s, int A, int B) const {
  return !touches_several_.empty() && (touches_several_[s][static_cast<std::size_t>(A)] ||
                                       touches_several_[s][static_cast<std::size_t>(B)]);
}

}  // namespace touchstone
