#include "transpiler/sim/instructions.h"

#include <bit>
#include <cstring>
#include <type_traits>

#include "plcxx/arith.h"
#include "plcxx/bcd.h"
#include "plcxx/c_integers.h"
#include "plcxx/doubles.h"
#include "plcxx/floats.h"
#include "plcxx/logic.h"
#include "plcxx/registers.h"
#include "plcxx/rings.h"
#include "transpiler/sim/core_operations.h"
#include "transpiler/sim/evaluate.h"
#include "transpiler/sim/execution.h"
#include "transpiler/support/check.h"

namespace plcxx::sim {
namespace {

struct Instructions {
  static auto OperandsOf(const Execution& execution, const Decoded& inst) {
    return [values = execution.values.data(), &inst](size_t i) {
      return values[i == 0 ? inst.a : i == 1 ? inst.b : inst.c];
    };
  }

#define PLCXX_PURE(Kind, Text, Operands, Result, Spelling, Precedence, Function, Cost)                    \
  static Flow Kind(Execution& execution, const Decoded& inst) {                                           \
    using namespace operand_types;                                                                        \
    execution.values[inst.id] = Apply(std::type_identity<Result Operands>{}, OperandsOf(execution, inst), \
                                      [](auto... value) { return plcxx::Function(value...); });           \
    return Flow::kOn;                                                                                     \
  }
#define PLCXX_STEP(Kind, Text, State, Operands, Result, Spelling, Function, Cost)                         \
  static Flow Kind(Execution& execution, const Decoded& inst) {                                           \
    using namespace operand_types;                                                                        \
    execution.values[inst.id] =                                                                           \
        Apply(std::type_identity<Result Operands>{}, OperandsOf(execution, inst), [&](auto... value) {    \
          return plcxx::Function(execution.memory.instances().Get<plcxx::State>(inst.payload), value...); \
        });                                                                                               \
    Stepped(execution, inst.payload);                                                                     \
    return Flow::kOn;                                                                                     \
  }
#define PLCXX_CORE(Kind, ...)                                   \
  static Flow Kind(Execution& execution, const Decoded& inst) { \
    const ir::InstId id(inst.id);                               \
    return core::Kind(execution, id, execution.program[id]);    \
  }
#include "transpiler/ir/ops.def"
#undef PLCXX_PURE
#undef PLCXX_STEP
#undef PLCXX_CORE

  // Loads and stores of what does not move, in the forms that are frequent; Load and Store are for all others.

  static Flow LoadBit(Execution& execution, const Decoded& inst) {
    execution.values[inst.id] = execution.memory.SpaceAt(inst.space())[inst.byte()] >> inst.bit() & 1;
    return Flow::kOn;
  }
  static Flow LoadByte(Execution& execution, const Decoded& inst) {
    execution.values[inst.id] = execution.memory.SpaceAt(inst.space())[inst.byte()];
    return Flow::kOn;
  }
  template <class T>
  static Flow LoadField(Execution& execution, const Decoded& inst) {
    execution.values[inst.id] = execution.memory.instances().FieldAt<T>(inst.byte());
    return Flow::kOn;
  }
  template <uint32_t kBytes, bool kBigEndian>
  static Flow LoadWide(Execution& execution, const Decoded& inst) {
    const uint8_t* const bytes = execution.memory.SpaceAt(inst.space()).bytes().data() + inst.byte();
    uint64_t value = 0;
    for (uint32_t i = 0; i < kBytes; ++i) value |= uint64_t{bytes[i]} << (8 * (kBigEndian ? kBytes - 1 - i : i));
    execution.values[inst.id] = value;
    return Flow::kOn;
  }
  static Flow StoreBit(Execution& execution, const Decoded& inst) {
    if (execution.recorder.is_on()) return Store(execution, inst);
    const auto mask = static_cast<uint8_t>(1U << inst.bit());
    const bool one = (execution.values[inst.a] & 1) != 0;
    execution.memory.SpaceAt(inst.space()).Write(inst.byte(), mask, one ? mask : uint8_t{0});
    return Flow::kOn;
  }
  static Flow StoreByte(Execution& execution, const Decoded& inst) {
    if (execution.recorder.is_on()) return Store(execution, inst);
    execution.memory.SpaceAt(inst.space()).Write(inst.byte(), 0xFF, static_cast<uint8_t>(execution.values[inst.a]));
    return Flow::kOn;
  }

  template <uint32_t kBytes, bool kBigEndian>
  static Flow StoreWide(Execution& execution, const Decoded& inst) {
    if (execution.recorder.is_on()) return Store(execution, inst);
    ForcedBytes& bytes = execution.memory.SpaceAt(inst.space());
    const uint64_t value = execution.values[inst.a];
    for (uint32_t i = 0; i < kBytes; ++i) {
      bytes.Write(inst.byte() + i, 0xFF, static_cast<uint8_t>(value >> (8 * (kBigEndian ? kBytes - 1 - i : i))));
    }
    return Flow::kOn;
  }
  static Function LoadWideOf(const PlaceAccess& access) {
    if (access.bytes == 2) return access.big_endian ? LoadWide<2, true> : LoadWide<2, false>;
    if (access.bytes == 4) return access.big_endian ? LoadWide<4, true> : LoadWide<4, false>;
    if (access.bytes == 8) return access.big_endian ? LoadWide<8, true> : LoadWide<8, false>;
    return Load;
  }
  static Function LoadFieldOf(uint32_t bytes) {
    if (bytes == 1) return LoadField<uint8_t>;
    if (bytes == 2) return LoadField<uint16_t>;
    if (bytes == 4) return LoadField<uint32_t>;
    if (bytes == 8) return LoadField<uint64_t>;
    return Load;
  }
  static Function StoreWideOf(const PlaceAccess& access) {
    if (access.bytes == 2) return access.big_endian ? StoreWide<2, true> : StoreWide<2, false>;
    if (access.bytes == 4) return access.big_endian ? StoreWide<4, true> : StoreWide<4, false>;
    return Store;
  }

  static Function LoadOf(const PlaceAccess& access, ir::Type type) {
    if (access.indexed) return Load;
    switch (access.kind) {
      case AccessKind::kAbsent:
        return Load;
      case AccessKind::kBit:
        return LoadBit;
      case AccessKind::kByte:
        return LoadByte;
      case AccessKind::kWide:
        return LoadWideOf(access);
      case AccessKind::kField:
        return LoadFieldOf(ir::Bytes(type));
    }
    PLCXX_UNREACHABLE();
  }
  static Function StoreOf(const PlaceAccess& access) {
    if (access.indexed) return Store;
    switch (access.kind) {
      case AccessKind::kBit:
        return StoreBit;
      case AccessKind::kByte:
        return StoreByte;
      case AccessKind::kWide:
        return StoreWideOf(access);
      case AccessKind::kAbsent:
      case AccessKind::kField:
        return Store;
    }
    PLCXX_UNREACHABLE();
  }
  static Flow Rung(Execution& execution, const Decoded& inst) {
    const Decoded* const first = execution.code.decoded.data() + inst.first();
    if (inst.has_statement()) execution.current = {.statement = ir::StatementId(first->payload)};
    const unsigned char* const* const bases = execution.bases.data();
    const LogicStep *const steps = execution.code.logic.data() + inst.first_step(), *const end =
                                                                                        steps + inst.step_count();
    uint64_t* const values = execution.values.data();
    const auto bit_of = [bases](const BitSource& source) {
      return bases[static_cast<size_t>(source.base)][source.byte] >> source.bit & 1;
    };
    for (const LogicStep* step = steps; step != end; ++step)
      values[step->id] = static_cast<uint64_t>(step->truth >> (bit_of(step->a) | bit_of(step->b) << 1) & 1);
    const uint32_t count = inst.step_count() + (inst.has_statement() ? 1 : 0) + (inst.has_coil() ? 1 : 0);
    if (inst.has_coil()) StoreBit(execution, first[count - 1]);
    if (!execution.given.empty()) {
      for (uint32_t i = 0; i < count; ++i) execution.NoteGiven(first[i].id);
    }
    return Flow::kOn;
  }
  static std::optional<LogicStep> StepOf(const ir::Inst& inst, const Decoded& decoded) {
    const auto value = [](uint32_t id) {
      constexpr uint32_t kLowest = std::endian::native == std::endian::little ? 0 : sizeof(uint64_t) - 1;
      return BitSource{.byte = id * static_cast<uint32_t>(sizeof(uint64_t)) + kLowest};
    };
    constexpr uint8_t kItself = TruthOf([](bool a, bool) { return a; });
    const auto of_two = [&](uint8_t truth) {
      return LogicStep{.a = value(inst.a), .b = value(inst.b), .id = decoded.id, .truth = truth};
    };
    const auto of_one = [&](BitSource source, uint8_t truth) {
      return LogicStep{.a = source, .b = source, .id = decoded.id, .truth = truth};
    };
    if (inst.type != ir::Type::kBit) return std::nullopt;
    if (decoded.execute == LoadBit) {
      if (decoded.space() > kLastSpaceOfRungs) return std::nullopt;
      const auto base = static_cast<BitBase>(static_cast<uint32_t>(BitBase::kSpaces) + decoded.space());
      return of_one({.byte = decoded.byte(), .base = base, .bit = static_cast<uint8_t>(decoded.bit())}, kItself);
    }
    if (decoded.execute == LoadField<uint8_t>)
      return of_one({.byte = decoded.byte(), .base = BitBase::kInstances}, kItself);
    if (decoded.execute == BitAnd) return of_two(TruthOf(plcxx::BitAnd));
    if (decoded.execute == BitOr) return of_two(TruthOf(plcxx::BitOr));
    if (decoded.execute == BitXor) return of_two(TruthOf(plcxx::BitXor));
    if (decoded.execute == BitNot) return of_one(value(inst.a), TruthOf([](bool a, bool) { return plcxx::BitNot(a); }));
    return std::nullopt;
  }

  static Function Of(ir::OpKind op) {
    switch (op) {
#define PLCXX_PURE(Kind, ...) \
  case ir::OpKind::k##Kind:   \
    return Kind;
#define PLCXX_STEP(Kind, ...) PLCXX_PURE(Kind)
#define PLCXX_CORE(Kind, ...) PLCXX_PURE(Kind)
#include "transpiler/ir/ops.def"
#undef PLCXX_PURE
#undef PLCXX_STEP
#undef PLCXX_CORE
    }
    PLCXX_UNREACHABLE();
  }
};

}  // namespace

Function FunctionOf(ir::OpKind op) { return Instructions::Of(op); }
Function LoadOf(const PlaceAccess& access, ir::Type type) { return Instructions::LoadOf(access, type); }
Function StoreOf(const PlaceAccess& access) { return Instructions::StoreOf(access); }

Flow ExecuteRung(Execution& execution, const Decoded& inst) { return Instructions::Rung(execution, inst); }
std::optional<LogicStep> StepOf(const ir::Inst& inst, const Decoded& decoded) {
  return Instructions::StepOf(inst, decoded);
}
bool WritesBit(const Decoded& decoded) { return decoded.execute == Instructions::StoreBit; }

Flow ExecuteAs(Execution& execution, ir::InstId id, const ir::Inst& inst) {
  const Decoded decoded{.id = id.index, .a = inst.a, .b = inst.b, .c = inst.c, .payload = inst.payload};
  switch (inst.op) {
#define PLCXX_PURE(Kind, ...) \
  case ir::OpKind::k##Kind:   \
    return Instructions::Kind(execution, decoded);
#define PLCXX_STEP(Kind, ...) PLCXX_PURE(Kind)
#define PLCXX_CORE(Kind, ...) \
  case ir::OpKind::k##Kind:   \
    return core::Kind(execution, id, inst);
#include "transpiler/ir/ops.def"
#undef PLCXX_PURE
#undef PLCXX_STEP
#undef PLCXX_CORE
  }
  PLCXX_UNREACHABLE();
}

}  // namespace plcxx::sim
