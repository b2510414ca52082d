// Operands as places of the memory map (specification sections 5 and 6.1).

#include <algorithm>
#include <limits>
#include <utility>

#include "transpiler/dialects/technol/lowering/internal.h"

namespace plcxx::technol {

using ir::OpKind;
using ir::Type;
using ir::ValueId;

namespace {

std::string_view PrefixOf(uint32_t width) { return width == 8 ? "BYTE" : width == 16 ? "WORD" : "DWRD"; }

constexpr uint32_t kFirstLocal = 256;  // bytes of the registers' space below are RLO, flags and registers

}  // namespace

const Symbol* Lowering::FindSymbol(std::string_view name) const {
  const auto found = std::find_if(tree_.symbols.begin(), tree_.symbols.end(),
                                  [name](const Symbol& symbol) { return symbol.name == name; });
  return found == tree_.symbols.end() ? nullptr : &*found;
}

ir::PlaceId Lowering::SystemPlace(std::string_view name) {
  const Symbol* symbol = FindSymbol(name);
  PLCXX_CHECK(symbol != nullptr);
  if (symbol->kind == SymbolKind::kBit) return BitPlace(symbol->area, symbol->offset, symbol->bit, std::string(name));
  return CellPlace(symbol->area, symbol->offset, TypeOf(symbol->width), std::string(name));
}

ir::PlaceId Lowering::BitPlace(Area area, uint32_t offset, uint8_t bit, std::string name) {
  const auto [found, is_new] = places_.try_emplace(std::tuple(area, offset, Type::kBit, bit));
  if (is_new) {
    found->second = program_.places.Add({.name = std::move(name),
                                         .address = BitAddress(area, offset, bit),
                                         .type = Type::kBit,
                                         .space = memory_[area],
                                         .offset = offset,
                                         .bit = bit});
  }
  return found->second;
}

ir::PlaceId Lowering::CellPlace(Area area, uint32_t offset, Type type, std::string name) {
  const auto [found, is_new] = places_.try_emplace(std::tuple(area, offset, type, ir::kNoBit));
  if (is_new) {
    found->second = program_.places.Add({.name = std::move(name),
                                         .address = CellAddress(area, offset, 8 * ir::Bytes(type)),
                                         .type = type,
                                         .space = memory_[area],
                                         .offset = offset});
  }
  return found->second;
}

/// "POCET", "TAB_TECHNOL_TCH_AKTIV", "LABEL_MEM_40": the names of the source; with its width where that is another one.
std::string Lowering::NameOf(const Operand& operand) const {
  const Address& address = operand.address;
  if (!address.base.valid()) {
    return CellAddress(address.area, static_cast<uint32_t>(address.offset), operand.width);
  }
  const Symbol& base = tree_.symbols[address.base];
  std::string name = base.name;
  int64_t rest = address.offset - base.offset;
  uint8_t width = base.width;
  if (address.field.valid()) {
    const Symbol& field = tree_.symbols[address.field];
    name += "_" + field.name;
    rest -= field.value;
    width = field.width;
  }
  if (rest != 0) name += (rest < 0 ? "_minus_" : "_") + std::to_string(rest < 0 ? -rest : rest);
  return width == operand.width || width == 0 ? name : std::string(PrefixOf(operand.width)) + "_" + name;
}

ir::PlaceId Lowering::PlaceAt(const Operand& operand) {
  if (operand.is_activation_bit()) return ActivationPlace(operand.mechanism);
  if (operand.kind == OperandKind::kAutomaticTimer) return TimerPlace(body_->unit, operand.timer);
  const Address& address = operand.address;
  const auto offset = static_cast<uint32_t>(address.offset);
  if (operand.kind == OperandKind::kBit) {
    return BitPlace(address.area, offset, operand.bit, tree_.symbols[operand.symbol].name);
  }
  PLCXX_CHECK(operand.kind == OperandKind::kMemory);
  return CellPlace(address.area, offset, TypeOf(operand.width), NameOf(operand));
}

ir::PlaceId Lowering::IndexedPlace(const Operand& operand, uint32_t offset) {
  const Area area = operand.address.area;
  const auto [found, is_new] = indexed_.try_emplace(std::tuple(area, offset, TypeOf(operand.width)));
  if (is_new) {
    found->second = program_.places.Add({.name = NameOf(operand) + "_indexed",
                                         .address = CellAddress(area, offset, operand.width) + "[]",
                                         .type = TypeOf(operand.width),
                                         .space = memory_[area],
                                         .offset = offset,
                                         .indexed = true,
                                         .stride = 1,
                                         .low = 0,
                                         .high = BytesOf(tree_, area)});
  }
  return found->second;
}

Lowering::Bounds32 Lowering::BoundsOf(ValueId value) const {
  const ir::Inst& inst = program_[value];
  const auto of = [&](uint32_t operand) { return BoundsOf(ValueId(operand)); };
  switch (inst.op) {
    case OpKind::kConst: {
      const auto bits = static_cast<int64_t>(ir::ConstantValue(inst));
      return bits > 0x7FFFFFFF ? Bounds32{bits - 0x100000000, bits - 0x100000000} : Bounds32{bits, bits};
    }
    case OpKind::kWiden8To16:
    case OpKind::kWiden8To32:
      return {0, 0xFF};
    case OpKind::kWiden16To32: {
      const Bounds32 narrow = of(inst.a);
      return narrow.high <= 0xFFFF ? narrow : Bounds32{0, 0xFFFF};
    }
    case OpKind::kSignExtend16To32: {
      const Bounds32 narrow = of(inst.a);
      return narrow.high <= 0x7FFF ? narrow : Bounds32{-0x8000, 0x7FFF};
    }
    case OpKind::kAnd16: {
      const Bounds32 right = of(inst.b);
      return right.low >= 0 ? Bounds32{0, right.high} : Bounds32{};
    }
    default:
      return {};
  }
}

/// What is not wholly inside the area reads 0 and is not written; the host learns of it (6.1).
Lowering::Reach Lowering::ReachOf(const Operand& operand) {
  const Address& address = operand.address;
  if (operand.kind != OperandKind::kMemory || address.index == Register::kNone) return {PlaceAt(operand), {}};
  const uint32_t size = BytesOf(tree_, address.area), bytes = operand.width / 8U;
  ValueId index = registers_.Read(address.index);
  if (Info(address.index).width == 16) {
    const auto known = builder_.KnownValue(index);
    index = known ? builder_.Number(*known > 0x7FFF ? *known | 0xFFFF0000U : *known)
                  : builder_.Pure(OpKind::kSignExtend16To32, {index});
  }
  const bool at_base = address.offset >= 0 && address.offset < size;
  const Bounds32 bounds = BoundsOf(index);
  const bool inside = bounds.low + address.offset >= 0 && bounds.high + address.offset + bytes <= size;
  if (!inside) {
    const auto offset = static_cast<uint64_t>(address.offset);
    const ValueId at = address.offset == 0 ? index : builder_.Pure(OpKind::kAdd32, {index, builder_.Number(offset)});
    // Without a sign: what is below 0 is above everything else.
    const ValueId outside =
        bytes > size ? builder_.Bit(1) : builder_.Pure(OpKind::kGreater32, {at, builder_.Number(size - bytes)});
    builder_.When(outside, [&] {
      CallFault(Fault::kBounds);
      if (settings_.bounds == Bounds::kTrap) LeaveAll();
    });
    if (!at_base) index = at;
  } else {
    if (facts_.on()) {
      const ValueId at = builder_.Pure(OpKind::kAdd32, {index, builder_.Number(static_cast<uint64_t>(address.offset))});
      facts_.Check(ir::FactKind::kIndex, builder_.Pure(OpKind::kLessEqual32, {at, builder_.Number(size - bytes)}), at);
    }
    if (!at_base)
      index = builder_.Pure(OpKind::kAdd32, {index, builder_.Number(static_cast<uint64_t>(address.offset))});
  }
  return {IndexedPlace(operand, at_base ? static_cast<uint32_t>(address.offset) : 0), index};
}

ValueId Lowering::Read(const Operand& operand) {
  switch (operand.kind) {
    case OperandKind::kRegister:
      return registers_.Read(operand.reg);
    case OperandKind::kConstant: {
      const std::string_view text = sources_.Text(operand.range);
      const bool hexadecimal = !text.empty() && (text.back() == 'h' || text.back() == 'H');
      return builder_.Constant(static_cast<uint64_t>(operand.value), operand.width, hexadecimal ? 16 : 10);
    }
    case OperandKind::kMemory: {
      const Reach reach = ReachOf(operand);
      return builder_.Load(reach.place, reach.index);
    }
    case OperandKind::kError:
    case OperandKind::kBit:
    case OperandKind::kLabel:
    case OperandKind::kMechanism:
    case OperandKind::kAutomaticTimer:
      break;
  }
  PLCXX_UNREACHABLE();
}

ValueId Lowering::ReadAs(const Operand& operand, uint32_t width) {
  if (operand.kind == OperandKind::kConstant) {
    Operand wide = operand;
    wide.width = static_cast<uint8_t>(width);
    return Read(wide);
  }
  return builder_.ToWidth(Read(operand), width);
}

void Lowering::Write(const Operand& operand, ValueId value) {
  if (operand.kind == OperandKind::kRegister) return registers_.Write(operand.reg, value);
  const Reach reach = ReachOf(operand);
  builder_.Store(reach.place, value, reach.index);
}

ValueId Lowering::ReadAt(const Operand& operand, const Reach& reach) {
  return reach.place.valid() ? builder_.Load(reach.place, reach.index) : registers_.Read(operand.reg);
}

void Lowering::WriteAt(const Operand& operand, const Reach& reach, ValueId value) {
  if (!reach.place.valid()) return registers_.Write(operand.reg, value);
  builder_.Store(reach.place, value, reach.index);
}

ir::PlaceId Lowering::AddLocal(std::string name, Type type) {
  const uint32_t offset = kFirstLocal + 4 * local_count_++;
  return program_.places.Add({.name = std::move(name),
                              .type = type,
                              .space = memory_[SpaceKey::kRegisters],
                              .offset = offset,
                              .bit = type == Type::kBit ? uint8_t{0} : ir::kNoBit});
}

ir::PlaceId Lowering::Local(std::string_view name, Type type) {
  const bool own = body_ != nullptr && body_->unit.valid() && !body_->calls;
  const auto [found, is_new] = (own ? own_locals_ : locals_).try_emplace(std::string(name));
  if (!is_new) return found->second;
  found->second = own ? OwnLocal(std::string(name), type) : AddLocal(std::string(name), type);
  return found->second;
}

ir::PlaceId Lowering::OwnLocal(std::string name, Type type) {
  ir::SpaceId& space = own_spaces_[body_->routine.index];
  if (!space.valid()) {
    space = program_.spaces.Add({.name = program_.routines[body_->routine].name + "_locals",
                                 .title = "",
                                 .bytes = 0,
                                 .lifetime = ir::Lifetime::kRoutine,
                                 .own = true});
  }
  const uint32_t offset = std::exchange(program_.spaces[space].bytes, program_.spaces[space].bytes + 4);
  return program_.places.Add({.name = std::move(name),
                              .type = type,
                              .space = space,
                              .offset = offset,
                              .bit = type == Type::kBit ? uint8_t{0} : ir::kNoBit});
}

}  // namespace plcxx::technol
