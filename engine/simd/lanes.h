#pragma once

#include <array>
#include <cstddef>

namespace cookbook {

/** Number of pairs of bodies that are solved at once. Four doubles are one register from
 AVX2 on, sixteen floats one register of AVX-512. */
template <class Real>
inline constexpr std::size_t kLanes = sizeof(Real) == 4 ? 16 : 4;

/** Alignment of lanes: a whole register. */
template <class Real>
inline constexpr std::size_t kAlignment = kLanes<Real> * sizeof(Real);

/** One number per pair. */
template <class Real>
using Lanes = std::array<Real, kLanes<Real>>;

/** One vector per pair, component by component. */
template <class Real>
using VectorLanes = std::array<Lanes<Real>, 3>;

/** One symmetric tensor per pair: xx, xy, xz, yy, yz, zz. */
template <class Real>
using TensorLanes = std::array<Lanes<Real>, 6>;

/** One body index per pair. */
template <class Real>
using BodyLanes = std::array<int, kLanes<Real>>;

}  // namespace cookbook
