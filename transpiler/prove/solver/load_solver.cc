#include "transpiler/prove/solver/bit_solver.h"
#include "transpiler/prove/solver/solver.h"
#include "transpiler/support/module.h"

namespace plcxx::prove::solver {

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

}  // namespace plcxx::prove::solver
