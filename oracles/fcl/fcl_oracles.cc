#include "oracles/fcl/fcl_oracles.h"

#include "oracles/fcl/fcl_solver.h"
#include "oracles/isolation/isolated_oracle.h"

namespace touchstone {

std::vector<std::unique_ptr<Oracle>> FclOracles() {
  std::vector<std::unique_ptr<Oracle>> oracles;
  for (const FclSolver solver : {FclSolver::kLibccd, FclSolver::kIndep}) {
    oracles.push_back(MakeFclCollide(solver));
    for (const FclDistanceKind kind :
         {FclDistanceKind::kUnsigned, FclDistanceKind::kSigned}) {
      oracles.push_back(Isolate(MakeFclDistance(solver, kind)));
    }
  }
  return oracles;
}

}  // namespace touchstone
