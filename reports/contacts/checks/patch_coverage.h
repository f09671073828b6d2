#pragma once

#include <span>

#include "oracles/contact_answer.h"
#include "reports/referee/contact_truth.h"

namespace touchstone {

class JudgedAnswer;

/** Returns the fraction of the patch's extent that its contacts leave unspanned, in [0,
 1]. [-] The patch and the contacts are seen along `n_AB_W`. The patch is stretched to
 unit spread along its principal axes, so that a slab's width counts like its length. The
 value is the largest distance of a corner from the hull of the contacts, over the patch's
 diameter. One contact in the middle of a square face gives 1/2: a stack on it tips over.
 1 without a contact, 0 for a patch that is a point.
 @pre The patch has a vertex; `n_AB_W` is a unit vector. */
double PatchUnspanned(const ContactPatch& patch, const Eigen::Vector3d& n_AB_W,
                      std::span<const ContactPoint> contacts);

/** Returns the same for the point `p_W` of the patch alone: its distance from the hull of
 the contacts over the patch's diameter. [-]
 @pre As for PatchUnspanned(). */
double UnspannedAt(const Eigen::Vector3d& p_W, const ContactPatch& patch,
                   const Eigen::Vector3d& n_AB_W, std::span<const ContactPoint> contacts);

/** Returns a vector d across the normal that proves UnspannedAt(): every contact c has
 d·(p − c) of at least that fraction, and the nearest point of their hull has just that.
 Zero if the point is in the hull. [1/m]
 @pre As for UnspannedAt(), and there is a contact. */
Eigen::Vector3d ShortfallAt(const Eigen::Vector3d& p_W, const ContactPatch& patch,
                            const Eigen::Vector3d& n_AB_W,
                            std::span<const ContactPoint> contacts);

/** Returns the fraction of the patch's extent that a computation whose lengths are off by
 `e` [m] may leave unspanned. [-] When the sides of a convex set move inwards by e, the
 rest contains the set shrunk by e / r about the centre of its incircle. Its radius r is
 at least area / perimeter, or half the length of a segment. Shrinking is the same along
 stretched axes.
 @pre The patch has two vertices; `n_AB_W` is a unit vector. */
double PatchBlur(const ContactPatch& patch, const Eigen::Vector3d& n_AB_W, double e);

/** The fraction of the patch's extent that a manifold may leave unspanned although its
 contacts could lie at every corner. Sides and corners drawn in by a rounding are granted
 by PatchBlur(); this is for engines that merge or move contacts by a few hundredths. [-]
 */
inline constexpr double kLegalUnspanned = 0x1p-4;

/** The fraction of a disc's diameter that an inscribed triangle leaves unspanned: half
 the radius. A manifold that does better holds any face up. Two opposite corners of a
 square, or three of them, leave half its diagonal and do worse. [-] */
inline constexpr double kInscribedUnspanned = 0.25;

/** Returns the fraction of `patch` that `contacts` may leave unspanned. It is
 kLegalUnspanned if the patch has at most four corners: four contacts span it. A disc or a
 polygon of more corners may be spanned by an inscribed polygon, whose corners lie on the
 rim: with at least three contacts within kLegalUnspanned of the rim it is
 kInscribedUnspanned.

 A disc of radius r is given by a polygon of k corners around it, at r / cos(π/k). The
 side of the triangle is still r / 2 away from the centre. The unspanned fraction is (r /
 cos(π/k) − r / 2) of a diameter of 2 r / cos(π/k), which is ½ − ¼ cos(π/k). [-]
 @pre The patch has a vertex; `n_AB_W` is a unit vector. */
double LegalUnspanned(const ContactPatch& patch, const Eigen::Vector3d& n_AB_W,
                      std::span<const ContactPoint> contacts);

/** Returns the fraction of `patch` that three contacts or more may leave unspanned where
 they lie best; fewer may leave kLegalUnspanned.
 @pre As for LegalUnspanned(). */
double MostLegalUnspanned(const ContactPatch& patch);

/** Returns the number of missing or of repeated contacts of a manifold, whichever is
 larger. [-] Missing: `least`, the fewest contacts that span the patch, minus those there
 are; 0 if their hull holds the patch already.
 Repeated: contacts nearer than `same` [m] to an earlier one, which would apply two
 impulses where the bodies touch once. Source: the fewest contacts of the patch are 1 for
 a point, 2 for a segment, 3 or 4 for a face. */
int ContactCountError(int least, std::span<const ContactPoint> contacts, double same);

/** Judges whether the contacts hold up the whole patch, and their number. Applies as
 CheckContactsInPatch() does, to an oracle that promises a manifold, where the whole patch
 overlaps by more than rounding. */
void CheckCoverage(JudgedAnswer& judged);

}  // namespace touchstone
