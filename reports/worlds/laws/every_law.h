#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

// One file each, which has the derivation above the law.
extern const Law kAngularMomentumBalance;
extern const Law kBallistic;
extern const Law kBounceSeries;
extern const Law kConservesAngularMomentum;
extern const Law kConservesEnergy;
extern const Law kConservesMomentum;
extern const Law kContactsOnBodies;
extern const Law kCornerImpact;
extern const Law kCoulombCone;
extern const Law kEnergyNeverRises;
extern const Law kHangsAsCatenary;
extern const Law kIncline;
extern const Law kJointLength;
extern const Law kMinimumEnergy;
extern const Law kMomentumBalance;
extern const Law kMovesAtItsVelocity;
extern const Law kNeverPassesThrough;
extern const Law kNeverPenetrates;
extern const Law kPendulum;
extern const Law kPenetrationScore;
extern const Law kPushed;
extern const Law kRests;
extern const Law kRollingBox;
extern const Law kRolls;
extern const Law kRowImpact;
extern const Law kSlideToStop;
extern const Law kSlipToRoll;
extern const Law kSphereImpact;
extern const Law kSpinsOnPlane;
extern const Law kSpringOscillation;
extern const Law kStackSupport;
extern const Law kTorqueFree;

}  // namespace touchstone
