#include "transpiler/dialects/hnc/analysis/checks.h"

namespace plcxx::hnc {

void Check(const Unit& unit, const Objects& objects, const Facts& facts, const source::SourceManager& sources,
           diag::Engine& diagnostics) {
  const CheckContext context{unit, objects, facts, sources, diagnostics};
  CheckCalls(context);
  CheckUsage(context);
  CheckExpressions(context);
}

}  // namespace plcxx::hnc
