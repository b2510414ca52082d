// The simulator's instructions: the function of each, and what it is given.

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
#include "transpiler/sim/evaluate.h"
#include "transpiler/sim/simulator.h"
#include "transpiler/support/check.h"

namespace plcxx::sim {

struct Simulator::Functions {
  static auto OperandsOf(const Simulator& simulator, const Decoded& inst) {
    return [values = simulator.values_.data(), &inst](size_t i) {
      return values[i == 0 ? inst.a : i == 1 ? inst.b : inst.c];
    };
  }

#define PLCXX_PURE(Kind, Text, Operands, Result, Spelling, Precedence, Function, Cost)                     \
  static Flow Kind(Simulator& simulator, const Decoded& inst) {                                            \
    using namespace operand_types;                                                                         \
    simulator.values_[inst.id] = Apply(std::type_identity<Result Operands>{}, OperandsOf(simulator, inst), \
                                       [](auto... value) { return plcxx::Function(value...); });           \
    return Flow::kOn;                                                                                      \
  }
#define PLCXX_STEP(Kind, Text, State, Operands, Result, Spelling, Function, Cost)                      \
  static Flow Kind(Simulator& simulator, const Decoded& inst) {                                        \
    using namespace operand_types;                                                                     \
    simulator.values_[inst.id] =                                                                       \
        Apply(std::type_identity<Result Operands>{}, OperandsOf(simulator, inst), [&](auto... value) { \
          return plcxx::Function(simulator.instances_.Get<plcxx::State>(inst.payload), value...);      \
        });                                                                                            \
    simulator.Stepped(inst.payload);                                                                   \
    return Flow::kOn;                                                                                  \
  }
#define PLCXX_CORE(Kind, ...)                                   \
  static Flow Kind(Simulator& simulator, const Decoded& inst) { \
    const ir::InstId id(inst.id);                               \
    return simulator.Execute##Kind(id, simulator.program_[id]); \
  }
#include "transpiler/ir/ops.def"
#undef PLCXX_PURE
#undef PLCXX_STEP
#undef PLCXX_CORE

  // Loads and stores of what does not move, in the forms that are frequent; Load and Store are for all others.

  static Flow LoadBit(Simulator& simulator, const Decoded& inst) {
    simulator.values_[inst.id] = simulator.spaces_[inst.space()][inst.byte()] >> inst.bit() & 1;
    return Flow::kOn;
  }
  static Flow LoadByte(Simulator& simulator, const Decoded& inst) {
    simulator.values_[inst.id] = simulator.spaces_[inst.space()][inst.byte()];
    return Flow::kOn;
  }
  template <class T>
  static Flow LoadField(Simulator& simulator, const Decoded& inst) {
    simulator.values_[inst.id] = simulator.instances_.FieldAt<T>(inst.byte());
    return Flow::kOn;
  }
  template <uint32_t kBytes, bool kBigEndian>
  static Flow LoadWide(Simulator& simulator, const Decoded& inst) {
    const uint8_t* const bytes = simulator.spaces_[inst.space()].bytes().data() + inst.byte();
    uint64_t value = 0;
    for (uint32_t i = 0; i < kBytes; ++i) value |= uint64_t{bytes[i]} << (8 * (kBigEndian ? kBytes - 1 - i : i));
    simulator.values_[inst.id] = value;
    return Flow::kOn;
  }
  static Flow StoreBit(Simulator& simulator, const Decoded& inst) {
    if (simulator.last_writes_) return Store(simulator, inst);
    const auto mask = static_cast<uint8_t>(1U << inst.bit());
    const bool one = (simulator.values_[inst.a] & 1) != 0;
    simulator.spaces_[inst.space()].Write(inst.byte(), mask, one ? mask : uint8_t{0});
    return Flow::kOn;
  }
  static Flow StoreByte(Simulator& simulator, const Decoded& inst) {
    if (simulator.last_writes_) return Store(simulator, inst);
    simulator.spaces_[inst.space()].Write(inst.byte(), 0xFF, static_cast<uint8_t>(simulator.values_[inst.a]));
    return Flow::kOn;
  }

  template <uint32_t kBytes, bool kBigEndian>
  static Flow StoreWide(Simulator& simulator, const Decoded& inst) {
    if (simulator.last_writes_) return Store(simulator, inst);
    ForcedBytes& bytes = simulator.spaces_[inst.space()];
    const uint64_t value = simulator.values_[inst.a];
    for (uint32_t i = 0; i < kBytes; ++i) {
      bytes.Write(inst.byte() + i, 0xFF, static_cast<uint8_t>(value >> (8 * (kBigEndian ? kBytes - 1 - i : i))));
    }
    return Flow::kOn;
  }
  using Function = decltype(Decoded::execute);

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
        switch (access.bytes) {
          case 2:
            return access.big_endian ? LoadWide<2, true> : LoadWide<2, false>;
          case 4:
            return access.big_endian ? LoadWide<4, true> : LoadWide<4, false>;
          case 8:
            return access.big_endian ? LoadWide<8, true> : LoadWide<8, false>;
          default:
            return Load;
        }
      case AccessKind::kField:
        switch (ir::Bytes(type)) {
          case 1:
            return LoadField<uint8_t>;
          case 2:
            return LoadField<uint16_t>;
          case 4:
            return LoadField<uint32_t>;
          case 8:
            return LoadField<uint64_t>;
          default:
            return Load;
        }
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
        switch (access.bytes) {
          case 2:
            return access.big_endian ? StoreWide<2, true> : StoreWide<2, false>;
          case 4:
            return access.big_endian ? StoreWide<4, true> : StoreWide<4, false>;
          default:
            return Store;
        }
      case AccessKind::kAbsent:
      case AccessKind::kField:
        return Store;
    }
    PLCXX_UNREACHABLE();
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

Decoded Simulator::DecodedOf(ir::InstId id) const {
  const ir::Inst& inst = program_[id];
  Decoded decoded{.execute = Functions::Of(inst.op),
                  .id = id.index,
                  .a = inst.a,
                  .b = inst.b,
                  .c = inst.c,
                  .payload = inst.payload};
  const ir::Shape shape = ir::Info(inst.op).shape;
  if (shape != ir::Shape::kLoad && shape != ir::Shape::kStore) return decoded;
  const PlaceAccess& access = places_[inst.payload];
  const Functions::Function fast = shape == ir::Shape::kLoad
                                       ? Functions::LoadOf(access, program_.places[ir::PlaceId(inst.payload)].type)
                                       : Functions::StoreOf(access);
  if (fast == decoded.execute) return decoded;
  decoded.execute = fast;
  decoded.b = access.kind == AccessKind::kField ? instances_.PlaceOf(access.owner, access.field) : access.offset;
  decoded.c = access.owner;
  decoded.payload = access.bit;
  return decoded;
}

void Simulator::Decode() {
  const auto gives_itself = [](const ir::Inst& inst) { return ir::Info(inst.op).shape == ir::Shape::kConst; };
  decoded_at_.resize(program_.insts.size());
  decoded_regions_.resize(program_.regions.size());
  decoded_.reserve(program_.insts.size());
  for (uint32_t i = 0; i < program_.regions.size(); ++i) {
    DecodedRegion& region = decoded_regions_[i];
    region.begin = static_cast<uint32_t>(decoded_.size());
    for (const bool constants : {false, true}) {
      if (constants) region.constants = static_cast<uint32_t>(decoded_.size());
      uint32_t order = 0;
      for (const ir::InstId id : program_.regions[ir::RegionId(i)].insts) {
        const uint32_t here = order++;
        if (gives_itself(program_[id]) != constants) continue;
        decoded_at_[id.index] = static_cast<uint32_t>(decoded_.size());
        decoded_.push_back(DecodedOf(id));
        decoded_.back().order = here;
      }
    }
    region.end = static_cast<uint32_t>(decoded_.size());
  }
}

}  // namespace plcxx::sim
