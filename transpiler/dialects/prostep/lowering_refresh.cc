// The image refresh (specification 4.4): counts are read from memory each time, so they may change at run time.

#include "transpiler/dialects/prostep/lowering_internal.h"

namespace plcxx::prostep {

using ir::OpKind;
using ir::ValueId;

/// One comparison for each byte, at constant addresses: bits of the image stay apart, which an index would forbid.
void Lowering::RefreshInputs() {
  builder_.SetRegion(program_.routines[refresh_inputs_].body);
  const ValueId count = LoadAt(Space::kD, kInputCountAddress, ir::Type::kI16);
  for (uint32_t port = 0; port < kMostInputBytes; ++port) {
    builder_.When(builder_.Pure(OpKind::kGreater16, {count, Word(port)}), [&] {
      const ValueId byte = builder_.AsExchange(host_(HostCall::kReadPort, {Number(port)}));
      StoreAt(Space::kI, InputByteOfPort(port), ir::Type::kI8, byte);
    });
  }
}

void Lowering::RefreshOutputs() {
  builder_.SetRegion(program_.routines[refresh_outputs_].body);
  const ValueId count = LoadAt(Space::kD, kOutputCountAddress, ir::Type::kI16);
  for (uint32_t port = 0; port < kMostOutputBytes; ++port) {
    builder_.When(builder_.Pure(OpKind::kGreater16, {count, Word(port)}), [&] {
      builder_.Store(LatchPlace(port), LoadAt(Space::kO, port, ir::Type::kI8));
      builder_.AsExchange(host_(HostCall::kWritePort, {Number(port), builder_.Load(LatchPlace(port))}));
    });
  }
}

}  // namespace plcxx::prostep
