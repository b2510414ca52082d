#include "transpiler/dialects/prostep/lowering/refresh.h"

#include "transpiler/dialects/prostep/lowering/cells.h"

namespace plcxx::prostep {

using ir::OpKind;
using ir::ValueId;

void Refresh::Inputs() {
  const ValueId count = cells_.Load(Space::kD, kInputCountAddress, ir::Type::kI16);
  for (uint32_t port = 0; port < kMostInputBytes; ++port) {
    builder_.When(Pure(OpKind::kGreater16, {count, Word(port)}), [&] {
      const ValueId byte = builder_.AsExchange(host_(HostCall::kReadPort, {Number(port)}));
      cells_.Store(Space::kI, InputByteOfPort(port), ir::Type::kI8, byte);
    });
  }
}

void Refresh::Outputs() {
  const ValueId count = cells_.Load(Space::kD, kOutputCountAddress, ir::Type::kI16);
  for (uint32_t port = 0; port < kMostOutputBytes; ++port) {
    builder_.When(Pure(OpKind::kGreater16, {count, Word(port)}), [&] {
      const ValueId output_byte = cells_.Load(Space::kO, port, ir::Type::kI8);
      const ir::PlaceId latch = cells_.Latch(port);
      builder_.Store(latch, output_byte);
      builder_.AsExchange(host_(HostCall::kWritePort, {Number(port), builder_.Load(cells_.Latch(port))}));
    });
  }
}

}  // namespace plcxx::prostep
