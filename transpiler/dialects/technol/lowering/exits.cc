#include "transpiler/dialects/technol/lowering/exits.h"

#include "transpiler/dialects/technol/lowering/locals.h"

namespace plcxx::technol {
namespace {

constexpr uint32_t kEndLabel = 0;  // the others are the number of their instruction and 1

}  // namespace

void Exits::ToEnd(ir::ValueId condition) {
  end_is_used_ = true;
  builder_.Jump(kEndLabel, condition);
}

/// A subprogram tells its caller, which then leaves as well.
void Exits::LeaveAll() {
  if (!frame_.routine->unit.valid()) builder_.Store(locals_("left", ir::Type::kBit), builder_.Bit(1));
  ToEnd();
}

void Exits::BindEnd() {
  if (end_is_used_) builder_.Label(kEndLabel);
}

}  // namespace plcxx::technol
