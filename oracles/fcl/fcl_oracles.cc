#include "oracles/fcl/fcl_oracles.h"

#include "oracles/fcl/fcl_solver.h"

namespace touchstone {

std::vector<std::unique_ptr<Oracle>> FclOracles() {
  std::vector<std::unique_ptr<Oracle>> oracles;
  for (const FclSolver solver : {FclSolver::kLibccd, FclSolver::kIndep}) {
    oracles.push_back(MakeFclCollide(solver));
  }
  return oracles;
}

}  // namespace touchstone
