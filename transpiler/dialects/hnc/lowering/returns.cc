#include "transpiler/dialects/hnc/lowering/returns.h"

#include "transpiler/dialects/hnc/lowering/addresses.h"
#include "transpiler/dialects/hnc/lowering/conversions.h"
#include "transpiler/dialects/hnc/lowering/expressions.h"
#include "transpiler/dialects/hnc/lowering/live_path.h"
#include "transpiler/dialects/hnc/lowering/pointers.h"
#include "transpiler/dialects/hnc/lowering/records.h"

namespace plcxx::hnc {

void Returns::StoreNoResult() {
  switch (TypeAt(frame_.function->result).kind) {
    case TypeKind::kPointer: {
      const PointerPlaces& places = placement_.results[frame_.id.index];
      builder_.Store(places.offset, builder_.Constant(ir::Type::kI32, kNullOffset, 16));
      if (places.object.valid()) builder_.Store(places.object, Word(0));
      break;
    }
    case TypeKind::kRecord:
      records_.Clear(objects_.OfResult(frame_.id));
      break;
    case TypeKind::kVoid:
    case TypeKind::kInteger:
    case TypeKind::kReal:
    case TypeKind::kArray:
    case TypeKind::kFunction:
      if (frame_.result.valid())
        builder_.Store(frame_.result, builder_.Constant(program_.places[frame_.result].type, 0));
      break;
  }
}

void Returns::Leave() {
  if (flow_.reachable && flow_.critical) diagnostics_.Report(*flow_.critical, diag::HncCliWithoutSti);
  flow_.critical.reset();
}

void Returns::Lower(const Statement& statement, Tail tail) {
  const Type& result = TypeAt(frame_.function->result);
  if (statement.expression.valid() && result.kind == TypeKind::kPointer) {
    const Address address = addresses_.EvaluatePointer(statement.expression);
    for (const ObjectId object : address.targets.objects) {
      const Object& target = objects_[object];
      if (target.kind != ObjectKind::kVariable) continue;
      const Variable& pointee = unit_.variables[VariableId(target.index)];
      const bool local = pointee.storage == Storage::kAutomatic || pointee.storage == Storage::kParameter;
      if (local && pointee.function == frame_.id) {
        diagnostics_.Report(statement.range, diag::HncLocalAddress, pointee.name);
      }
    }
    const PointerPlaces& places = placement_.results[frame_.id.index];
    if (places.object.valid()) builder_.Store(places.object, pointers_.ObjectOf(address));
    builder_.Store(frame_.result, pointers_.OffsetOf(address));
  } else if (statement.expression.valid() && result.kind == TypeKind::kRecord) {
    Address to;
    to.targets.Add(objects_.OfResult(frame_.id));
    records_.Assign(to, addresses_.RecordAddress(statement.expression), frame_.function->result);
  } else if (statement.expression.valid() && frame_.result.valid()) {
    const Value value = conversions_.Convert(expressions_.Evaluate(statement.expression), frame_.function->result);
    builder_.Store(frame_.result, value.id);
    if (IsInteger(result)) {
      frame_.bounds = frame_.bounds ? Join(*frame_.bounds, value.bounds) : value.bounds;
    }
  } else if (statement.expression.valid()) {
    expressions_.Execute(statement.expression);
  } else {
    StoreNoResult();
    if (frame_.result.valid()) frame_.bounds = frame_.bounds ? Join(*frame_.bounds, {0, 0}) : Bounds{0, 0};
  }
  Leave();
  const bool entry = frame_.id == unit_.init || frame_.id == unit_.plc1 || frame_.id == unit_.plc2;
  if (!statement.expression.valid() && result.kind != TypeKind::kVoid && !entry) {
    diagnostics_.Report(statement.range, diag::HncNoReturnValue, frame_.function->name);
  }
  if (tail == Tail::kFunction) {
    flow_.reachable = false;
  } else {
    path_.JumpTo(LivePath::kEndOfFunction);
  }
}

}  // namespace plcxx::hnc
