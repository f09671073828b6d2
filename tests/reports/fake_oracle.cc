#include "tests/reports/fake_oracle.h"

#include <utility>

#include "oracles/no_answer.h"
#include "reports/contacts/checks/contact_surface_error.h"
#include "reports/referee/referee.h"

namespace touchstone {
namespace {

Capability Everything() {
  Capability capability;
  capability.supported = true;
  capability.family = "certified";
  capability.depth = true;
  capability.distance = true;
  capability.normal = true;
  capability.manifold = true;
  capability.witnesses = true;
  return capability;
}

}  // namespace

std::vector<Eigen::Vector3d> ReachedCorners(const ContactQuery& query,
                                            const ContactPatch& patch,
                                            const Eigen::Vector3d& n_W, double separation,
                                            double reached) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& corner : patch.vertices_W)
    middle += corner / static_cast<double>(patch.vertices_W.size());
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3d& corner : patch.vertices_W) {
    for (const double drawn : {1.0, 0.98, 0.96, 0.94, 0.92, 0.9}) {
      const Eigen::Vector3d p_W = middle + drawn * (corner - middle);
      const WitnessPoints on = SurfacePointsOf({p_W, separation, {}}, n_W);
      if (SurfaceError(query, on) > reached) continue;
      points.push_back(p_W);
      break;
    }
  }
  return points;
}

ContactAnswer RightAnswer(const ContactQuery& query) {
  const ContactTruth truth = ComputeContactTruth(query);
  const double separation =
      truth.separation.lo + (truth.separation.hi - truth.separation.lo) / 2;
  ContactAnswer answer;
  answer.status = AnswerStatus::kAnswered;
  answer.touching = separation <= 0;
  answer.separation = separation;
  answer.n_AB_W = truth.certificate.n_AB_W.normalized();
  if (!answer.touching) {
    answer.witnesses = {truth.certificate.p_WCa, truth.certificate.p_WCb};
    return answer;
  }
  const double e = 16 * 0x1p-53 * SceneSize(query);
  const ContactPatch patch = PatchAlong(query, *answer.n_AB_W, separation, e);
  for (const Eigen::Vector3d& p_WC : ReachedCorners(
           query, patch, *answer.n_AB_W, separation, 2 * e + truth.input_rounding))
    answer.points.push_back({p_WC, separation, {}});
  if (answer.points.empty())
    return UnsupportedAnswer("the place of the contact is not known well enough");
  return answer;
}

FakeOracle::FakeOracle(std::string name, Function function)
    : function_(std::move(function)) {
  info_.name = std::move(name);
  info_.library = "Fake";
  info_.version = "1.0";
  for (auto& row : info_.capabilities) row.fill(Everything());
}

FakeOracle FakeOracle::Wrong(
    std::string name, std::function<void(const ContactQuery&, ContactAnswer&)> plant) {
  return FakeOracle(std::move(name),
                    [plant = std::move(plant)](const ContactQuery& query) {
                      ContactAnswer answer = RightAnswer(query);
                      if (answer.status == AnswerStatus::kAnswered) plant(query, answer);
                      return answer;
                    });
}

void FakeOracle::Answer(std::span<const ContactQuery> queries,
                        std::span<ContactAnswer> answers) const {
  for (std::size_t i = 0; i < queries.size(); ++i) answers[i] = function_(queries[i]);
}

void FakeOracle::ForEachPair(const std::function<void(Capability&)>& change) {
  for (auto& row : info_.capabilities) {
    for (Capability& capability : row) change(capability);
  }
}

}  // namespace touchstone
