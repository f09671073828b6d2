#include "reports/worlds/laws/particle_bounce.h"

#include "reports/worlds/law_support/each_subject.h"
#include "reports/worlds/law_support/falls.h"
#include "reports/worlds/law_support/landing.h"
#include "reports/worlds/law_support/subjects.h"

namespace touchstone {
namespace {

Fall FallOf(const World& world, int index) {
  const Particle& particle = world.particles[static_cast<std::size_t>(index)];
  const Landing landing = *LandingOfPoint(world, particle.p_W);
  const double v = landing.n_W.dot(particle.v_W);
  return {particle.name,
          landing.n_W,
          {landing.gap, v},
          -landing.n_W.dot(world.gravity_W),
          particle.bounce,
          particle.p_W,
          particle.v_W - v * landing.n_W,
          0,
          [index](const WorldState& state) {
            return state.particles[static_cast<std::size_t>(index)];
          }};
}

std::string WhyNot(const World& world, int index) {
  const Particle& particle = world.particles[static_cast<std::size_t>(index)];
  if (particle.damping > 0) return "is damped";
  if (IsHeld(world, AnchorKind::kParticle, index)) return "is held";
  const std::optional<Landing> landing = LandingOfPoint(world, particle.p_W);
  if (!landing) return "is not above a static half-space or box";
  const Fall fall = FallOf(world, index);
  if (fall.gravity <= 0 || !IsAlong(world.gravity_W, landing->n_W))
    return "does not fall along the normal of the ground";
  const std::optional<Landing> last =
      LandingOfPoint(world, particle.p_W + world.steps * world.dt * fall.v_along_W);
  if (!last || last->ground != landing->ground)
    return "leaves the ground that it bounces on";
  return "";
}

ExpectedNumbers NumbersOfParticle(const World& world, int index) {
  return NumbersOf(FallOf(world, index));
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  return FaultsOfEachParticle(
      world, claim,
      {.why_not = WhyNot,
       .expected = "a free particle above a static half-space or box",
       .numbers = NumbersOfParticle});
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  return JudgeFalls(motion, SubjectsOf(motion.world, claim).particles, FallOf);
}

Eigen::Vector3d Place(const World& world, const Claim& claim, double t) {
  return FallOf(world, SubjectsOf(world, claim).particles.front()).PlaceAt(t);
}

}  // namespace

constinit const Law kParticleBounce = {
    .name = "particle_bounce",
    .documentation =
        "A particle that falls onto a static plane leaves "
        "with `bounce` times its normal speed.",
    .numbers = kNumbersOfFalls,
    .faults = Faults,
    .judge = Judge,
    .place = Place,
    .has_impacts = true,
};

}  // namespace touchstone
