#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace touchstone {

/** The statement that a proof refutes. Unnamed fields are those of Proof. */
enum class ProofClaim {
  kNone,        ///< It is part of the refutation.
  kTouching,    ///< The bodies touch.
  kApart,       ///< The bodies are apart.
  kSeparation,  ///< Their separation is `said`.
  kNormal,      ///< Along `claimed_W`, the separation is `said`.
  kContact,     ///< A contact at the first point has the separation `said`.
};

/** The refutation. The first five are certificates, which stand for themselves; the
 others compare an answer with the bodies or with another answer. */
enum class ProofKind {
  kNone,
  kPlane,          ///< The plane n·x = offset separates the bodies by `bound`.
  kTranslation,    ///< Moving B by −bound along n separates the bodies.
  kNoTranslation,  ///< No translation shorter than −bound does; along `claimed_W`, if it
                   ///< is not zero, `rest` of the overlap is left after −said.
  kCommonPoint,    ///< The point lies −bound inside both bodies.
  kNearestPoints,  ///< A point of A and a point of B have the distance `bound`.
  kOverlap,        ///< Along `claimed_W` the depth is `bound`, not `said`.
  kOpposite,       ///< Along `claimed_W` they overlap by `bound`, against it by `said`.
  kDeepest,  ///< The deepest contact, the point, has the separation `bound`, not `said`.
  kWitnesses,      ///< Points of A and B, `bound` apart along `claimed_W` (or at all, if
                   ///< it is zero) and `rest` across, not `said`.
  kDuality,        ///< Points of A and B are `said` apart, the gap along them is `bound`.
  kOffSurfaces,    ///< Points of A and B, `said` and `bound` from the surfaces.
  kTooShallow,     ///< Between points of A and B the bodies overlap by `bound` more.
  kSurplus,        ///< Points of A and B are `bound` apart.
  kOffPatch,       ///< The contact at the point, of separation `said`, is `bound` off.
  kUnspanned,      ///< The contacts[0] given leave out the point, and the share `rest`.
  kCount,          ///< contacts[0] are given, contacts[1] are needed.
  kMixedNormals,   ///< Normals of one answer are `rest` [rad] apart.
  kVariantNormal,  ///< Along `claimed_W` the overlap is `said`; the answer to a variant,
                   ///< mapped back, has the normal n, along which it is `bound`.
  kVariantSeparation,  ///< A variant, mapped back, has the separation `bound`.
  kVariantTouch,       ///< A variant differs in touching, `bound` from touching.
  kPlaces,  ///< At `time` a body is at the first point, in a variant at the second.
};

/** The numbers of a proof, which a person can check by hand, and which a page draws.
 Lengths that do not apply are NaN, directions zero. World frame. */
struct Proof {
  ProofKind kind = ProofKind::kNone;
  ProofClaim claim = ProofClaim::kNone;
  double said = std::numeric_limits<double>::quiet_NaN();   ///< Of the answer. [m]
  double bound = std::numeric_limits<double>::quiet_NaN();  ///< What refutes it. [m]
  double rest = std::numeric_limits<double>::quiet_NaN();   ///< See ProofKind. [m]
  Eigen::Vector3d n_W = Eigen::Vector3d::Zero();  ///< Unit direction, from A to B.
  double offset = std::numeric_limits<double>::quiet_NaN();  ///< n·x of the plane. [m]
  Eigen::Vector3d claimed_W = Eigen::Vector3d::Zero();  ///< Unit normal of the answer.
  std::vector<Eigen::Vector3d> points_W = {};           ///< [m]
  std::array<std::uint64_t, 2> contacts{};
  std::string change = {};  ///< How a variant differs: "swap: A and B exchanged".
  bool touching = false;    ///< Of the answer to the question itself, for kVariantTouch.
  /** The part of the difference that the variant itself explains, 0 for none. [m] */
  double explained = 0;
  std::string body = {};  ///< The body, particle or node of kPlaces.
  double time = std::numeric_limits<double>::quiet_NaN();  ///< Of kPlaces. [s]
};

/** Returns a proof as one sentence, e.g. "fcl/collide says 0.0135 m deep; moving B by
 0.01341 m along (0, 0, 1) separates them, 9e-05 m less.". Lengths have nine digits, or as
 many more as distinguish two of them. Points, directions and planes have all digits: they
 read back as the exact doubles. kPlaces, which is part of a longer sentence, is "at 0.32
 s “lid” is at (0, 1, 0) and (0, 1.5, 0)", with nine digits. "" for kNone. */
std::string InWords(const Proof& proof, std::string_view oracle);

/** Returns "plane", "translation", …; "" for kNone. */
std::string_view NameOf(ProofKind kind);
/** Returns "touching", "apart", …; "" for kNone. */
std::string_view NameOf(ProofClaim claim);

}  // namespace touchstone
