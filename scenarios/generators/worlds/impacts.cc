#include <algorithm>
#include <cmath>

#include "scenarios/generators/portable_math.h"
#include "scenarios/generators/worlds/world_builders.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

Vector3d AnySpin(Random& random) {
  const double spin = random.Uniform(0, 10);
  return spin * random.Direction();
}

/** Claims that energy is kept where nothing takes any. */
void ClaimEnergy(WorldScenario& scenario, const std::vector<std::string>& bodies) {
  const RigidBody& body = scenario.world.bodies.back();
  if (body.restitution == 1 && body.friction == 0)
    AddClaim(scenario, "conserves_energy", bodies, "e = 1 and no friction");
}

/** A box that is about to hit the ground, without gravity. */
struct FallingBox {
  Vector3d half;  ///< [m]
  Eigen::Quaterniond q_WB;
  Vector3d v_W;  ///< [m/s]
  double restitution;
  double friction;
  double lowest;  ///< Depth of its lowest corner below its centre. [m]
  double slowed;  ///< Factor by which its velocity was reduced. [-]
};

/** Returns a lower bound of the time from the impact until any corner is down again,
 however the box turns. [s]

 Without gravity, energy bounds all speeds after the impact. An impact with friction may
 gain energy by Newton's rule, at most e² σ² of it with σ² <= 6 (docs/laws.md), so a
 factor of 7 on the energy and of √7 < 2.7 on speeds is enough. The other corners have
 `clearance` [m] to go. The corner of the impact leaves at `parting` [m/s], and no
 rotation accelerates it by more than ω² r (1 + I_max / I_min). */
double LeastFlight(const Vector3d& half, double speed, double clearance, double parting) {
  const Vector3d squares = half.cwiseProduct(half);
  const double sum = squares.x() + squares.y() + squares.z();
  const double least = (sum - squares.maxCoeff()) / 3;  // I / m, [m²]
  const double most = (sum - squares.minCoeff()) / 3;
  const double radius = std::sqrt(sum);
  const double spin = 2.7 * speed / std::sqrt(least);
  const double turning = spin * spin * radius * (1 + most / least);
  return std::min(clearance / (2.7 * speed + spin * radius), 2 * parting / turning);
}

/** Returns the largest restitution at which an impact of the lower edge along the body's
 x axis gains no energy, whatever the friction. Newton's restitution may gain up to e² (1
 + σ²) − 1 of the energy of approach (docs/laws.md), with σ² = m d²/I for the distance d
 of the edge from the plumb line through the centre and I = m/3 (h_y² + h_z²). Engines
 that allow no such gain are right, too, so no law may claim it. [-] */
double MostRestitution(const Vector3d& half, const Eigen::Matrix3d& R_WB) {
  // The lower edge is at −sign of each height; d is its part along the plane.
  const double y = std::copysign(half.y(), R_WB(2, 1));
  const double z = std::copysign(half.z(), R_WB(2, 2));
  const double squares = half.y() * half.y() + half.z() * half.z();
  const double height = y * R_WB(2, 1) + z * R_WB(2, 2);
  const double d_squared = squares - height * height;
  return std::sqrt(1 / (1 + 3 * d_squared / squares));
}

/** Returns a box whose corner, or with `is_edge` an edge, comes down first, and so slow
 that no corner is down again within six steps: the law corner_impact wants three.
 Without gravity a slower motion is the same motion. */
FallingBox AnyFallingBox(WorldDraw& draw, bool is_edge) {
  Random& random = draw.random;
  FallingBox box;
  box.half = draw.HalfExtents();
  // The level edge is along the body's x axis, and the box moves across it.
  const Eigen::Vector2d tilt = random.PlaneDirection();
  const Eigen::Quaterniond turned = TurnedAboutZ(random);
  const Eigen::Quaterniond any = random.Rotation();
  box.q_WB =
      is_edge ? Product(turned, Eigen::Quaterniond(tilt.x(), tilt.y(), 0, 0)) : any;
  const Eigen::Matrix3d R = box.q_WB.toRotationMatrix();
  const double v_n = random.Uniform(0.5, 3);
  const double v_t = random.Uniform(-2, 2);
  const Eigen::Vector2d heading = random.PlaneDirection();
  const Vector3d along_W =
      is_edge ? Vector3d(-R(1, 0), R(0, 0), 0) : Vector3d(heading.x(), heading.y(), 0);
  box.v_W = v_t * along_W - Vector3d(0, 0, v_n);
  const double friction = draw.Coefficient();
  box.friction = is_edge ? friction : 0;
  const double most = box.friction > 0 ? MostRestitution(box.half, R) : 1;
  box.restitution = random.Below(5) == 0 ? most : random.Uniform(0.1, most);
  // A corner is higher than the lowest one by a sum of some of these.
  const Vector3d heights(2 * box.half.x() * std::abs(R(2, 0)),
                         2 * box.half.y() * std::abs(R(2, 1)),
                         2 * box.half.z() * std::abs(R(2, 2)));
  const double of_two = std::min(heights.y(), heights.z());
  const double clearance = is_edge ? of_two : std::min(heights.x(), of_two);
  box.lowest = 0.5 * (heights.x() + heights.y() + heights.z());
  const double flight =
      LeastFlight(box.half, Norm(box.v_W), clearance, box.restitution * v_n);
  box.slowed = std::min(1.0, flight / (6 * draw.dt));
  box.v_W *= box.slowed;
  return box;
}

}  // namespace

WorldScenario SpherePair(WorldDraw& draw) {
  Random& random = draw.random;
  WorldScenario scenario = EmptyWorld(draw, "Two spheres hit each other", 0.6);
  scenario.world.gravity_W.setZero();
  const double r_A = random.Uniform(0.1, 0.4);
  const double r_B = random.Uniform(0.1, 0.4);
  const double m_A = random.Decades(-1, 1);
  const double m_B = m_A * draw.Ratio();
  // B moves along u and misses the centre of A by a share of both radii. It touches after
  // at most 0.4 of the 0.6 s.
  const Vector3d u_W = random.Direction();
  const Vector3d any_W = random.Direction();
  const Vector3d across = Cross(u_W, any_W);
  const Vector3d w_W = Norm(across) > 0.1 ? Unit(across) : Vector3d::Zero();
  const double reach = r_A + r_B;
  const double miss = random.Uniform(0, 0.9) * reach;
  const double speed = random.Uniform(0.5, 5);
  const double before = speed * random.Uniform(0.05, 0.4);
  const double along = std::sqrt(reach * reach - miss * miss) + before;
  const Vector3d start_W = random.Direction();
  RigidBody& A = AddBody(scenario, "A", Sphere{r_A}, m_A,
                         Pose::FromQuaternion(start_W, random.Rotation()));
  const double common = random.Uniform(0, 2);
  const Vector3d v_W = common * random.Direction();
  A.v_WB = v_W;
  A.w_WB = AnySpin(random);
  RigidBody& B = AddBody(
      scenario, "B", Sphere{r_B}, m_B,
      Pose::FromQuaternion(start_W - along * u_W + miss * w_W, random.Rotation()));
  B.v_WB = v_W + speed * u_W;
  B.w_WB = AnySpin(random);
  // Either may be the heavy one.
  if (random.Coin()) std::swap(scenario.world.bodies[0].mass, B.mass);
  const double restitution = draw.Coefficient();
  SetContacts(scenario, restitution, draw.Coefficient());
  AddClaim(scenario, "sphere_impact", {"A", "B"}, "they fly towards each other");
  ClaimEnergy(scenario, {"A", "B"});
  return scenario;
}

WorldScenario SphereOnPlane(WorldDraw& draw) {
  Random& random = draw.random;
  WorldScenario scenario = EmptyWorld(draw, "A sphere hits the ground at an angle", 0.6);
  AddGround(scenario, draw, 20);
  const double r = random.Uniform(0.05, 0.4);
  const double v_n = random.Uniform(1, 5);
  const double v_t = random.Uniform(0, 5);
  const Eigen::Vector2d heading = random.PlaneDirection();
  const double gap = v_n * random.Uniform(0.05, 0.3);
  const Pose X_WB = Pose::FromQuaternion({0, 0, r + gap}, random.Rotation());
  RigidBody& ball = AddBody(scenario, "ball", Sphere{r}, random.Decades(-1, 1), X_WB);
  ball.v_WB = {v_t * heading.x(), v_t * heading.y(), -v_n};
  ball.w_WB = AnySpin(random);
  const double restitution = draw.Coefficient();
  SetContacts(scenario, restitution, draw.Coefficient());
  // The law wants three steps of flight after the impact, which last 2 e v_n / g at
  // least; here it is six. Without gravity the sphere never comes back.
  if (2 * restitution * v_n < 6 * draw.dt * kGravity) scenario.world.gravity_W.setZero();
  AddClaim(scenario, "sphere_impact", {"ball"}, "it flies against the ground");
  ClaimEnergy(scenario, {"ball"});
  return scenario;
}

WorldScenario BoxOnPlane(WorldDraw& draw) {
  Random& random = draw.random;
  const bool is_edge = random.Coin();
  WorldScenario scenario = EmptyWorld(draw,
                                      is_edge ? "A box hits the ground with an edge"
                                              : "A box hits the ground with a corner",
                                      0.4);
  scenario.world.gravity_W.setZero();
  AddGround(scenario, draw, 20);
  // A box that lands almost flat would be slowed down to nothing.
  FallingBox falling = AnyFallingBox(draw, is_edge);
  while (falling.slowed < 0.01) falling = AnyFallingBox(draw, is_edge);
  const double gap = -falling.v_W.z() * random.Uniform(0.05, 0.2);
  RigidBody& box =
      AddBody(scenario, "box", Box{falling.half}, random.Decades(-1, 1),
              Pose::FromQuaternion({0, 0, falling.lowest + gap}, falling.q_WB));
  box.v_WB = falling.v_W;
  SetContacts(scenario, falling.restitution, falling.friction);
  AddClaim(scenario, "corner_impact", {"box"},
           "it flies against the ground without spin");
  ClaimEnergy(scenario, {"box"});
  return scenario;
}

}  // namespace touchstone
