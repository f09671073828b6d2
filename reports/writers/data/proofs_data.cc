#include "reports/writers/data/proofs_data.h"

#include <cstddef>
#include <utility>

#include "reports/finding/proof.h"

namespace touchstone {
namespace {

/** All of a double: the page performs a proof with the numbers of the program. */
constexpr int kDigits = 17;

/** Returns a direction; null for none. */
DataJson Direction(const Eigen::Vector3d& n_W) {
  return n_W.isZero(0) ? DataJson(nullptr) : ToData(n_W, kDigits);
}

/** Returns a number; null for none. */
DataJson Number(double value) {
  return value == value ? ToData(value, kDigits) : DataJson(nullptr);
}

}  // namespace

DataJson ProofsData(std::span<const Finding> findings, Texts& texts) {
  DataJson data;
  for (const char* column : {"finding", "kind", "claim", "said", "bound", "n", "offset",
                             "claimed", "points", "change", "body", "time", "angle"})
    data[column] = DataJson::array();
  for (std::size_t f = 0; f < findings.size(); ++f) {
    if (!findings[f].evidence) continue;
    const Proof& proof = *findings[f].evidence;
    data["finding"].push_back(f);
    data["kind"].push_back(static_cast<int>(proof.kind));
    data["claim"].push_back(static_cast<int>(proof.claim));
    data["said"].push_back(Number(proof.said));
    data["bound"].push_back(Number(proof.bound));
    data["n"].push_back(Direction(proof.n_W));
    data["offset"].push_back(Number(proof.offset));
    data["claimed"].push_back(Direction(proof.claimed_W));
    DataJson points = DataJson::array();
    for (const Eigen::Vector3d& p_W : proof.points_W)
      points.push_back(ToData(p_W, kDigits));
    data["points"].push_back(std::move(points));
    data["change"].push_back(texts.IndexOf(proof.change));
    data["body"].push_back(texts.IndexOf(proof.body));
    data["time"].push_back(Number(proof.time));
    data["angle"].push_back(proof.kind == ProofKind::kPlaces ? Number(proof.rest)
                                                             : DataJson(nullptr));
  }
  return data;
}

DataJson StudiesData(std::span<const Finding> findings) {
  DataJson data = {{"finding", DataJson::array()},
                   {"errors", DataJson::array()},
                   {"unit", DataJson::array()}};
  for (std::size_t f = 0; f < findings.size(); ++f) {
    if (!findings[f].study) continue;
    data["finding"].push_back(f);
    DataJson errors = DataJson::array();
    for (const double error : findings[f].study->errors)
      errors.push_back(ToData(error, 3));
    data["errors"].push_back(std::move(errors));
    data["unit"].push_back(findings[f].study->unit);
  }
  return data;
}

DataJson ProofNames() {
  return {{"proof", NamesUpTo(ProofKind::kPlaces)},
          {"claim", NamesUpTo(ProofClaim::kContact)}};
}

}  // namespace touchstone
