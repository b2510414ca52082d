#include "transpiler/dialects/technol/lowering/faults.h"

namespace plcxx::technol {

void Faults::Report(Fault fault) {
  const ir::ValueId kind = builder_.Byte(static_cast<uint64_t>(fault));
  host_(HostCall::kFault, {kind, builder_.Number(program_.statements[frame_.statement].id)});
}

void Faults::ReportWhen(ir::ValueId condition, Fault fault) {
  builder_.When(condition, [&] { Report(fault); });
}

}  // namespace plcxx::technol
