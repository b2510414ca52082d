#include "transpiler/support/module.h"
#include "transpiler/symbolic/solver/bit_solver.h"
#include "transpiler/symbolic/solver/solver.h"

namespace plcxx::solver {

LoadedSolver LoadSolver(const terms::Terms& terms) {
  const support::ModuleFunction function = support::LoadFunction(kSolverModule, kMakeSolver);
  if (function.address == nullptr) return {.solver = nullptr, .reason = function.reason};
  auto* const make = reinterpret_cast<MakeSolverFunction*>(function.address);
  return {.solver = std::unique_ptr<Solver>(make(terms)), .reason = {}};
}

std::unique_ptr<BitSolver> LoadBitSolver(const terms::Terms& terms) {
  const support::ModuleFunction function = support::LoadFunction(kSolverModule, kMakeBitSolver);
  if (function.address == nullptr) return nullptr;
  return std::unique_ptr<BitSolver>(reinterpret_cast<MakeBitSolverFunction*>(function.address)(terms));
}

}  // namespace plcxx::solver
