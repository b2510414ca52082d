#include "transpiler/dialects/hnc/lowering/initialisers.h"

#include "transpiler/dialects/hnc/lowering/accesses.h"
#include "transpiler/dialects/hnc/lowering/addresses.h"
#include "transpiler/dialects/hnc/lowering/conversions.h"
#include "transpiler/dialects/hnc/lowering/expressions.h"
#include "transpiler/dialects/hnc/lowering/pointers.h"
#include "transpiler/dialects/hnc/lowering/records.h"
#include "transpiler/dialects/hnc/lowering/statement_writer.h"

namespace plcxx::hnc {

void Initialisers::Initialise(VariableId id) {
  const Variable& variable = unit_.variables[id];
  flow_.unassigned.erase(id);
  const Type& type = TypeAt(variable.type);
  if (type.kind == TypeKind::kPointer) {
    if (!variable.initial.empty())
      pointers_.StorePointer(id, addresses_.EvaluatePointer(variable.initial.front().value));
    return;
  }
  if (placement_.locals[id.index].valid()) {
    if (variable.initial.empty()) return;
    Lvalue target;
    target.local = id;
    target.type = variable.type;
    accesses_.Store(target, conversions_.Convert(expressions_.Evaluate(variable.initial.front().value), variable.type));
    return;
  }
  uint32_t filled = 0;
  for (const InitialValue& initial : variable.initial) {
    filled += initial.is_bit_field ? initial.bit_width : NamedBits(initial.type);
  }
  if (filled < NamedBits(variable.type)) records_.Clear(objects_.OfVariable(id));
  for (const InitialValue& initial : variable.initial) {
    Lvalue target;
    target.address.targets.Add(objects_.OfVariable(id));
    target.address.base = initial.offset;
    target.type = initial.type;
    const Type& part = TypeAt(initial.type);
    if (part.kind == TypeKind::kArray) {
      if (ExprAt(initial.value).kind != ExprKind::kString) continue;
      const std::string& bytes = unit_.strings[ExprAt(initial.value).string];
      for (uint32_t i = 0; i < part.size; ++i) {
        Address at = target.address;
        at.base += i;
        const uint8_t byte = i < bytes.size() ? static_cast<uint8_t>(bytes[i]) : uint8_t{0};
        accesses_.StoreAt(at, ir::Type::kI8, builder_.Constant(ir::Type::kI8, byte), {});
      }
    } else if (part.kind == TypeKind::kRecord) {
      records_.Assign(target.address, addresses_.RecordAddress(initial.value), initial.type);
    } else if (part.kind == TypeKind::kPointer) {
      if (const auto pointee = facts_.PointeeOf(initial.value)) {
        accesses_.StoreAt(target.address, ir::Type::kI16, Word(NumberOf(pointee->object)), {});
      }
    } else {
      Member field;
      if (initial.is_bit_field) {
        field = {.name = "",
                 .type = initial.type,
                 .offset = 0,
                 .is_bit_field = true,
                 .bit_offset = initial.bit_offset,
                 .bit_width = initial.bit_width,
                 .range = {}};
        target.bit_field = &field;
      }
      accesses_.Store(target, conversions_.Convert(expressions_.Evaluate(initial.value), initial.type));
    }
  }
  flow_.Forget(objects_.OfVariable(id));
}

uint32_t Initialisers::NamedBits(TypeId id) const {
  const Type& type = TypeAt(id);
  if (type.kind == TypeKind::kArray) return type.count * NamedBits(type.element);
  if (type.kind != TypeKind::kRecord || unit_.records[type.record].is_union) return 8 * type.size;
  uint32_t bits = 0;
  for (const Member& member : unit_.records[type.record].members) {
    if (!member.is_bit_field) {
      bits += NamedBits(member.type);
    } else if (!member.name.empty()) {
      bits += member.bit_width;
    }
  }
  return bits;
}

void Initialisers::Lower(const Statement& statement) {
  bool marked = false;
  for (const VariableId id : statement.variables) {
    const Variable& variable = unit_.variables[id];
    if (variable.storage != Storage::kAutomatic || !variable.initialised) continue;
    if (!flow_.reachable) continue;
    if (!marked) writer_.MarkText(statement.range, variable.name, false);
    marked = true;
    Initialise(id);
  }
}

}  // namespace plcxx::hnc
