#include "transpiler/dialects/common/builder.h"

namespace plcxx::dialects {

ir::RoutineId Builder::AddRoutine(std::string name, ir::RoutineKind kind, std::string comment) {
  ir::Routine routine{.name = std::move(name), .kind = kind, .comment = std::move(comment)};
  routine.body = NewRegion();
  return program().routines.Add(std::move(routine));
}

void Builder::Increment(ir::PlaceId place) {
  const ir::ValueId count = Load(place), one = Constant(ir::Type::kI32, 1);
  Store(place, Pure(ir::OpKind::kAdd32, {count, one}));
}

ir::ValueId Builder::AsExchange(ir::ValueId call) {
  program().calls[ir::CallId(program()[call].payload)].exchange = true;
  return call;
}

}  // namespace plcxx::dialects
