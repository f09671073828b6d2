#include "reports/worlds/law_support/allowed_depth.h"

#include <algorithm>

namespace touchstone {
namespace {

/** Steps after an arrival at whose end the bodies are stopped: the contact is found at
 the end of the first one, and may be missed there by a rounding. */
constexpr double kStepsToStop = 2;

}  // namespace

void AllowedDepth::Begin(double depth) {
  is_apart_ = false;
  kept_ = depth;
}

void AllowedDepth::Part() {
  is_apart_ = true;
  arrivals_.clear();
  fastest_creep_ = 0;
  kept_ = 0;
}

void AllowedDepth::Arrive(double time, double depth, double creep) {
  EndArrivals(time);
  if (is_apart_) together_since_ = time;
  is_apart_ = false;
  fastest_creep_ = std::max(fastest_creep_, creep);
  // A later arrival that explains more lasts longer than an earlier one.
  std::erase_if(arrivals_,
                [&](const Arrival& arrival) { return arrival.depth <= depth; });
  arrivals_.push_back({time, depth, 0});
}

double AllowedDepth::Later(double time) const {
  return kept_ + by_load_ + (creep_ + fastest_creep_) * (time - together_since_);
}

void AllowedDepth::EndArrivals(double time) {
  const auto ended = std::erase_if(arrivals_, [&](const Arrival& arrival) {
    // Half a step is for the rounding of sample times.
    return arrival.samples_after > 1 && time > arrival.time + (kStepsToStop + 0.5) * h_;
  });
  // It is as deep as the arrivals that are over have left it.
  if (ended > 0 && last_depth_ > Later(time)) kept_ = last_depth_;
}

double AllowedDepth::Next(double time, double depth) {
  EndArrivals(time);
  double allowed = Later(time);
  for (Arrival& arrival : arrivals_) {
    allowed = std::max(allowed, kept_ + arrival.depth);
    ++arrival.samples_after;
  }
  kept_ = std::min(kept_, depth);
  last_depth_ = depth;
  return allowed;
}

}  // namespace touchstone
