#include "transpiler/dialects/host50/lowering/faults.h"

namespace plcxx::host50 {

using ir::ValueId;

void Faults::Call(Fault fault) {
  const Section& section = tree_.sections[now_.section];
  constexpr uint32_t kFastNumber = 0xFFFFFFFE, kSlowNumber = 0xFFFFFFFF;  // -2 and -1
  const uint32_t number = section.kind == SectionKind::kFast   ? kFastNumber
                          : section.kind == SectionKind::kSlow ? kSlowNumber
                                                               : section.number;
  const ValueId code = builder_.Constant(ir::Type::kI8, static_cast<uint64_t>(fault));
  const ValueId where = builder_.Constant(ir::Type::kI32, number);
  host_(HostCall::kFault, {code, where, builder_.Constant(ir::Type::kI32, tree_.networks[now_.network].number)});
}

}  // namespace plcxx::host50
