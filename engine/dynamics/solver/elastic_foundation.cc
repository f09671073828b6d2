#include "engine/dynamics/solver/elastic_foundation.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace cookbook {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Vector = ElasticFoundation::Vector;
using Block = BlockCholesky::Block;

/** Steps of Newton's method after the first solution, in which all contacts stick. */
constexpr int kMaxSteps = 16;
/** Relative error of the impulses from which they are corrected themselves. */
constexpr double kNearlyBalanced = 1e-3;
/** Greatest change of a gap, relative to the greatest normal impulse, that is left: the
 normal impulses then are those of the springs to a thousandth, and balance all the same.
 */
constexpr double kGapTolerance = 1e-3;
/** Greatest number of corrections. One multiplies the error by about the regularization
 times the condition of the matrix. */
constexpr int kMaxCorrections = 6;
/** Relative error of impulses that balance: some ten roundings of their sum. */
constexpr double kBalanced = 1e-14;
/** Regularization, relative to the diagonal. The condition of a column of n bodies is
 about n⁴. */
constexpr double kLeastRegularization = 1e-12;
constexpr double kMostRegularization = 1e-3;
/** Stiffness of a pair that bears no load where all contacts stick, relative to the pair
 that bears most. */
constexpr double kLeastStiffness = 1e-6;
/** A step that is shortened to less than this fraction needs a greater regularization. */
constexpr double kShortened = 0.2;
/** A step is halved less often than this until it goes down. */
constexpr int kMaxHalvings = 10;
/** Displacements, relative to the sum of all loads, that no foundation in equilibrium
 has: the displacement of a column of n bodies is about n³ times its load. */
constexpr double kUnbounded = 1e6;

std::size_t At(int index) {
  return static_cast<std::size_t>(index);
}

/** Returns the matrix of the cross product, [u]× x = u × x. */
Matrix3d Cross(const Vector3d& u) {
  Matrix3d m;
  m << 0, -u[2], u[1], u[2], 0, -u[0], -u[1], u[0], 0;
  return m;
}

/** The nearest impulse in a friction cone, and its derivative D. */
struct ConeProjection {
  Vector3d impulse;
  Matrix3d derivative;
  double slip;  ///< Distance along the tangents.
};

/** Projects `z` onto the cone |λ_t| <= μ λ_n. The apex z = 0 counts as inside. */
ConeProjection ProjectOntoCone(const Vector3d& z, double friction) {
  const double held = z.tail<2>().norm();
  if (held <= friction * z[0]) return {z, Matrix3d::Identity(), 0};
  if (friction * held <= -z[0]) return {Vector3d::Zero(), Matrix3d::Zero(), held};
  const Vector2d direction = z.tail<2>() / held;
  const Vector3d along(1, friction * direction[0], friction * direction[1]);
  const Vector3d side(0, -direction[1], direction[0]);
  const double normal = (z[0] + friction * held) / (1 + friction * friction);
  return {normal * along,
          along * along.transpose() / (1 + friction * friction) +
              friction * normal / held * side * side.transpose(),
          held - friction * normal};
}

}  // namespace

void ElasticFoundation::Clear() {
  pairs_.clear();
  edges_.clear();
  contacts_.clear();
  required_.clear();
}

int ElasticFoundation::AddBody(const Vector& required) {
  required_.push_back(required);
  return static_cast<int>(required_.size()) - 1;
}

void ElasticFoundation::AddPair(int A, int B, const Vector3d& p_AB_W,
                                const Matrix3d& axes_W, double friction) {
  pairs_.push_back(
      {A, B, p_AB_W, axes_W, friction, 1, contacts_.size(), contacts_.size()});
  if (A >= 0 && B >= 0) edges_.push_back({A, B});
}

void ElasticFoundation::AddContact(const Vector3d& r_W) {
  Pair& pair = pairs_.back();
  pair.end = contacts_.size() + 1;
  contacts_.push_back({pair.axes_W.transpose() * r_W, Vector3d::Zero(), Vector3d::Zero(),
                       Matrix3d::Identity(), 0, 0});
}

template <class Visit>
void ElasticFoundation::ForEachDisplacement(std::span<const Vector> w,
                                            const Visit& visit) {
  for (const Pair& pair : pairs_) {
    Vector relative = pair.B >= 0 ? w[At(pair.B)] : Vector(-w[At(pair.A)]);
    if (pair.A >= 0 && pair.B >= 0) {
      const Vector& A = w[At(pair.A)];
      relative -= A;
      relative.head<3>() -= A.tail<3>().cross(pair.p_AB_W);
    }
    const Vector3d v = pair.axes_W.transpose() * relative.head<3>();
    const Vector3d omega = pair.axes_W.transpose() * relative.tail<3>();
    for (std::size_t k = pair.begin; k < pair.end; ++k) {
      Contact& contact = contacts_[k];
      visit(pair, Vector3d(v + omega.cross(contact.r)), contact);
    }
  }
}

bool ElasticFoundation::UpdateContacts() {
  bool is_same = true;
  ForEachDisplacement(w_, [&](const Pair& pair, const Vector3d& y, Contact& contact) {
    contact.y = y;
    const ConeProjection projection =
        ProjectOntoCone(y + contact.gap * Vector3d::UnitX(), pair.friction);
    const Matrix3d stiffness = pair.stiffness * projection.derivative;
    contact.impulse = pair.stiffness * projection.impulse;
    is_same = is_same && stiffness == contact.stiffness;
    contact.stiffness = stiffness;
    contact.slip = projection.slip;
  });
  return is_same;
}

bool ElasticFoundation::UpdateGaps() {
  double change = 0;
  double greatest = 0;
  for (const Pair& pair : pairs_) {
    for (std::size_t k = pair.begin; k < pair.end; ++k) {
      Contact& contact = contacts_[k];
      greatest = std::max(greatest, contact.impulse[0]);
      if (contact.impulse[0] == 0) continue;
      const double gap = -pair.friction * contact.slip;
      change = std::max(change, pair.stiffness * std::abs(gap - contact.gap));
      contact.gap = gap;
    }
  }
  return change <= kGapTolerance * greatest;
}

void ElasticFoundation::UpdateResidual() {
  residual_.assign(required_.begin(), required_.end());
  scale_.clear();
  for (const Vector& required : required_)
    scale_.emplace_back(required.head<3>().norm(), required.tail<3>().norm());
  for (const Pair& pair : pairs_) {
    Vector3d linear(0, 0, 0);
    Vector3d angular(0, 0, 0);
    Vector2d scale(0, 0);
    for (std::size_t k = pair.begin; k < pair.end; ++k) {
      const Contact& contact = contacts_[k];
      linear += contact.impulse;
      angular += contact.r.cross(contact.impulse);
      const double size = contact.impulse.norm();
      scale += size * Vector2d(1, contact.r.norm());
    }
    linear = pair.axes_W * linear;
    angular = pair.axes_W * angular;
    if (pair.B >= 0) {
      residual_[At(pair.B)].head<3>() -= linear;
      residual_[At(pair.B)].tail<3>() -= angular;
      scale_[At(pair.B)] += scale;
    }
    if (pair.A < 0) continue;
    if (pair.B >= 0) {
      angular += pair.p_AB_W.cross(linear);
      scale[1] += scale[0] * pair.p_AB_W.norm();
    }
    residual_[At(pair.A)].head<3>() += linear;
    residual_[At(pair.A)].tail<3>() += angular;
    scale_[At(pair.A)] += scale;
  }
  error_ = 0;
  for (std::size_t i = 0; i < residual_.size(); ++i) {
    const double linear = residual_[i].head<3>().norm();
    const double angular = residual_[i].tail<3>().norm();
    // Written so that a NaN is an error, too.
    if (!(linear <= 0)) error_ = std::max(linear / scale_[i][0], error_);
    if (!(angular <= 0)) error_ = std::max(angular / scale_[i][1], error_);
  }
}

double ElasticFoundation::EnergyAt(std::span<const Vector> w) {
  double energy = 0;
  for (std::size_t i = 0; i < w.size(); ++i) energy -= required_[i].dot(w[i]);
  ForEachDisplacement(w,
                      [&](const Pair& pair, const Vector3d& y, const Contact& contact) {
                        const Vector3d z = y + contact.gap * Vector3d::UnitX();
                        energy += 0.5 * pair.stiffness *
                                  ProjectOntoCone(z, pair.friction).impulse.squaredNorm();
                      });
  return energy;
}

double ElasticFoundation::TakeStep() {
  // A fraction of the decrease at the start of the step (Armijo), and roundings.
  constexpr double kDecrease = 1e-4;
  constexpr double kRounding = 1e-14;
  double slope = 0;
  for (std::size_t i = 0; i < w_.size(); ++i) slope -= residual_[i].dot(step_[i]);
  const double energy = EnergyAt(w_);
  double fraction = 1;
  for (int k = 0; k < kMaxHalvings; ++k, fraction *= 0.5) {
    trial_.assign(w_.begin(), w_.end());
    for (std::size_t i = 0; i < w_.size(); ++i) trial_[i] += fraction * step_[i];
    if (EnergyAt(trial_) >
        energy + kDecrease * fraction * slope + kRounding * std::abs(energy))
      continue;
    w_.swap(trial_);
    return fraction;
  }
  return 0;
}

bool ElasticFoundation::Factor(double regularization) {
  matrix_.SetZero();
  std::size_t edge = 0;
  for (const Pair& pair : pairs_) {
    // The stiffness about the centre of the body that contacts are measured from.
    Matrix3d linear = Matrix3d::Zero();
    Matrix3d mixed = Matrix3d::Zero();
    Matrix3d angular = Matrix3d::Zero();
    for (std::size_t k = pair.begin; k < pair.end; ++k) {
      const Contact& contact = contacts_[k];
      const Matrix3d arm = Cross(contact.r);
      const Matrix3d stiffness_arm = contact.stiffness * arm;
      linear += contact.stiffness;
      mixed -= stiffness_arm;
      angular -= arm * stiffness_arm;
    }
    Block stiffness;
    stiffness.topLeftCorner<3, 3>() = pair.axes_W * linear * pair.axes_W.transpose();
    stiffness.topRightCorner<3, 3>() = pair.axes_W * mixed * pair.axes_W.transpose();
    stiffness.bottomLeftCorner<3, 3>() = stiffness.topRightCorner<3, 3>().transpose();
    stiffness.bottomRightCorner<3, 3>() = pair.axes_W * angular * pair.axes_W.transpose();
    if (pair.B < 0) {
      matrix_.Diagonal(pair.A) += stiffness;
      continue;
    }
    matrix_.Diagonal(pair.B) += stiffness;
    if (pair.A < 0) continue;
    // A displacement of A moves its matter at the centre of B by v + ω × p_AB.
    Block at_B = Block::Identity();
    at_B.topRightCorner<3, 3>() = -Cross(pair.p_AB_W);
    const Block coupling = at_B.transpose() * stiffness;
    matrix_.Diagonal(pair.A) += coupling * at_B;
    matrix_.AddOffDiagonal(edge++, -coupling);
  }
  for (std::size_t i = 0; i < stiffness_.size(); ++i) {
    auto diagonal = matrix_.Diagonal(static_cast<int>(i)).diagonal();
    diagonal.head<3>().array() += regularization * stiffness_[i][0];
    diagonal.tail<3>().array() += regularization * stiffness_[i][1];
  }
  return matrix_.Factor();
}

void ElasticFoundation::FindStep() {
  step_.assign(residual_.begin(), residual_.end());
  matrix_.Solve(step_);
}

bool ElasticFoundation::Refine(bool is_factored) {
  if (!is_factored && !Factor(kLeastRegularization)) return false;
  for (int k = 0; k < kMaxCorrections && error_ > 0; ++k) {
    const double error = error_;
    FindStep();
    ForEachDisplacement(step_, [&](const Pair& pair, const Vector3d& y,
                                   Contact& contact) {
      contact.impulse =
          ProjectOntoCone(contact.impulse + contact.stiffness * y, pair.friction).impulse;
    });
    UpdateResidual();
    if (!(error_ < 0.5 * error)) break;
  }
  return error_ <= kBalanced;
}

void ElasticFoundation::StiffenByLoad() {
  double greatest = 0;
  for (Pair& pair : pairs_) {
    pair.stiffness = 0;
    for (std::size_t k = pair.begin; k < pair.end; ++k)
      pair.stiffness += contacts_[k].y[0];
    greatest = std::max(greatest, pair.stiffness);
  }
  for (Pair& pair : pairs_)
    pair.stiffness = std::max(pair.stiffness / greatest, kLeastStiffness);
}

bool ElasticFoundation::FindSticking() {
  stiffness_.assign(required_.size(), Vector2d::Zero());
  for (const Pair& pair : pairs_) {
    for (std::size_t k = pair.begin; k < pair.end; ++k) {
      Contact& contact = contacts_[k];
      contact.stiffness = pair.stiffness * Matrix3d::Identity();
      contact.impulse.setZero();
      const auto stiffen = [&](int body, const Vector3d& r) {
        stiffness_[At(body)] += pair.stiffness * Vector2d(1, r.squaredNorm());
      };
      if (pair.B >= 0) stiffen(pair.B, contact.r);
      if (pair.A < 0) continue;
      const Vector3d r_BA = pair.B < 0 ? Vector3d::Zero().eval()
                                       : (pair.axes_W.transpose() * pair.p_AB_W).eval();
      stiffen(pair.A, contact.r + r_BA);
    }
  }
  const auto has_arm = [](const Vector2d& stiffness) { return stiffness[1] > 0; };
  if (!std::all_of(stiffness_.begin(), stiffness_.end(), has_arm)) return false;
  UpdateResidual();
  if (!Factor(kLeastRegularization)) return false;
  FindStep();
  w_.swap(step_);
  return true;
}

bool ElasticFoundation::IsBounded() const {
  double greatest = 0;
  for (const Pair& pair : pairs_) {
    for (std::size_t k = pair.begin; k < pair.end; ++k) {
      greatest =
          std::max(greatest, pair.stiffness * contacts_[k].y.lpNorm<Eigen::Infinity>());
    }
  }
  double load = 0;
  for (std::size_t i = 0; i < required_.size(); ++i) {
    const double mean_arm = std::sqrt(stiffness_[i][1] / stiffness_[i][0]);
    load += required_[i].head<3>().norm() + required_[i].tail<3>().norm() / mean_arm;
  }
  return greatest < kUnbounded * load;
}

bool ElasticFoundation::Solve() {
  matrix_.Analyze(static_cast<int>(required_.size()), edges_);
  if (!FindSticking()) return false;
  bool is_regular = true;
  bool is_factored = UpdateContacts();
  UpdateResidual();
  if (error_ < kNearlyBalanced && Refine(is_factored)) return true;
  StiffenByLoad();
  if (!FindSticking()) return false;
  double regularization = kLeastRegularization;
  for (int k = 0; k < kMaxSteps; ++k) {
    if (k > 0) {
      if (!Factor(regularization)) return false;
      FindStep();
      const double fraction = TakeStep();
      if (fraction == 0 && regularization == kMostRegularization) return false;
      is_regular = regularization == kLeastRegularization;
      if (fraction < kShortened)
        regularization = std::min(1e3 * regularization, kMostRegularization);
      if (fraction == 1)
        regularization = std::max(0.1 * regularization, kLeastRegularization);
      if (fraction == 0) continue;
    }
    is_factored = UpdateContacts() && is_regular;
    UpdateResidual();
    if (error_ < kNearlyBalanced) {
      if (UpdateGaps() && Refine(is_factored)) return true;
      UpdateContacts();
      UpdateResidual();
    }
    if (!IsBounded()) return false;
  }
  return false;
}

}  // namespace cookbook
