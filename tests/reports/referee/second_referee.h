#pragma once

#include <Eigen/Core>
#include <boost/multiprecision/mpfr.hpp>

#include "scenarios/contact_query.h"

namespace touchstone {

/** A real number of 700 bits. */
using Wide = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<211, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

/** An enclosure of a separation. [m] */
struct WideEnclosure {
  Wide lo;
  Wide hi;
};

/** Returns an enclosure of the signed separation of `query`, by a computation that shares
 nothing with the referee: no code, no algorithm and no arithmetic.

 The separation is max over unit n of min_B n·x − max_A n·x, for bodies that are apart and
 for bodies that penetrate. All directions are searched by branch and bound. In a cone of
 directions between three of them, n·p of any point p of A − B is linear, and at most the
 support function: the least value at the three corners of the best mixture of their
 support points bounds the cone from below. The search is made in 64 bits, of which 58 are
 trusted. The result is evaluated again in 700 bits: the best direction, the normals of
 the planes through the last support points, and the nearest points of their triangles.

 Its width is about 2^-57 of the scene. It is wider, and still an enclosure, where the
 maximum is attained along a curve of directions, which no finite tiling covers. */
WideEnclosure SeparationBySearch(const ContactQuery& query);

/** Returns min_B n·x − max_A n·x for the unit vector that `n_W` normalises to. [m]
 @pre Neither body is a half-space. */
Wide GapAlong(const ContactQuery& query, const Eigen::Vector3d& n_W);

}  // namespace touchstone
