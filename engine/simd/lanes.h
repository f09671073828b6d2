#pragma once

#include <array>
#include <cstddef>

namespace cookbook {

/** How many pairs of bodies are solved at once: four by doubles, sixteen by floats. */
template <class Real>
inline constexpr std::size_t kLanes = sizeof(Real) == 4 ? 16 : 4;

/** Where lanes start: at a whole register. */
template <class Real>
inline constexpr std::size_t kAlignment = kLanes<Real> * sizeof(Real);

/** One number of each pair. */
template <class Real>
using Lanes = std::array<Real, kLanes<Real>>;

/** One vector of each pair, component by component. */
template <class Real>
using VectorLanes = std::array<Lanes<Real>, 3>;

/** One symmetric tensor of each pair: xx, xy, xz, yy, yz, zz. */
template <class Real>
using TensorLanes = std::array<Lanes<Real>, 6>;

/** One body of each pair. */
template <class Real>
using BodyLanes = std::array<int, kLanes<Real>>;

}  // namespace cookbook
