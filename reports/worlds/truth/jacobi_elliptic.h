#pragma once

namespace touchstone {

/** The values sn, cn and dn for one argument. */
struct JacobiElliptic {
  double sn;
  double cn;
  double dn;
};

/** Returns Jacobi's elliptic functions of `u` for the parameter m = k².

 Uses the descending Landen transformation, Abramowitz & Stegun, Handbook of Mathematical
 Functions, §16.4, and dn² = m1 + m cn², which loses no digits if m is near 1. `m1` = 1 −
 m is passed in addition to m, since it determines the result near a separatrix.

 @pre 0 <= m, m1 <= 1. */
JacobiElliptic Jacobi(double u, double m, double m1);

/** Returns the complete elliptic integral K of the first kind for the complementary
 parameter `m1` = 1 − m, by the arithmetic-geometric mean (§17.6); infinite for m1 = 0. */
double CompleteEllipticK(double m1);

/** Returns Carlson's symmetric integral R_F(x, y, z) = ½ ∫₀^∞ dt / √((t+x)(t+y)(t+z)), by
 duplication (Carlson, Numerische Mathematik 33 (1979), pp. 1–16). The incomplete integral
 of the first kind is F = sn R_F(cn², dn², 1) for |φ| <= π/2.

 @pre All >= 0, at most one of them 0. */
double CarlsonRF(double x, double y, double z);

}  // namespace touchstone
