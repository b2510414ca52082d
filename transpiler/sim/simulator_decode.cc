// The simulator's instructions: the function of each, and what it is given.

#include <bit>
#include <cstring>
#include <optional>
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
  /// A rung: its statement begins, its contacts are joined, its coil is written.
  static Flow ExecuteRung(Simulator& simulator, const Decoded& inst) {
    const Decoded* const first = simulator.decoded_.data() + inst.first();
    if (inst.has_statement()) simulator.current_ = {.statement = ir::StatementId(first->payload)};
    const unsigned char* const* const bases = simulator.bases_.data();
    const LogicStep *const steps = simulator.logic_.data() + inst.first_step(), *const end = steps + inst.step_count();
    uint64_t* const values = simulator.values_.data();
    const auto bit_of = [bases](const BitSource& source) {
      return bases[static_cast<size_t>(source.base)][source.byte] >> source.bit & 1;
    };
    for (const LogicStep* step = steps; step != end; ++step)
      values[step->id] = static_cast<uint64_t>(step->truth >> (bit_of(step->a) | bit_of(step->b) << 1) & 1);
    const uint32_t count = inst.step_count() + (inst.has_statement() ? 1 : 0) + (inst.has_coil() ? 1 : 0);
    if (inst.has_coil()) StoreBit(simulator, first[count - 1]);
    if (!simulator.given_.empty()) {
      for (uint32_t i = 0; i < count; ++i) simulator.Note(first[i].id);
    }
    return Flow::kOn;
  }
  /// The step that an instruction is in a rung; none: it is nothing for one.
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

bool Simulator::IsRung(const Decoded& inst) { return inst.execute == Functions::ExecuteRung; }

Flow Simulator::ExecuteAs(ir::InstId id, const ir::Inst& inst) {
  const Decoded decoded{.id = id.index, .a = inst.a, .b = inst.b, .c = inst.c, .payload = inst.payload};
  switch (inst.op) {
#define PLCXX_PURE(Kind, ...) \
  case ir::OpKind::k##Kind:   \
    return Functions::Kind(*this, decoded);
#define PLCXX_STEP(Kind, ...) PLCXX_PURE(Kind)
#define PLCXX_CORE(Kind, ...) \
  case ir::OpKind::k##Kind:   \
    return Execute##Kind(id, inst);
#include "transpiler/ir/ops.def"
#undef PLCXX_PURE
#undef PLCXX_STEP
#undef PLCXX_CORE
  }
  PLCXX_UNREACHABLE();
}

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
  for (DecodedRegion& region : decoded_regions_) FindRungs(region);
}

void Simulator::FindRungs(DecodedRegion& region) {
  constexpr uint32_t kLeast = 6;  // instructions; with fewer a rung is no faster than they are
  region.ready_begin = static_cast<uint32_t>(ready_.size());
  for (uint32_t at = region.begin; at < region.constants;) {
    const auto first_step = static_cast<uint32_t>(logic_.size());
    uint32_t end = at, flags = 0;
    if (program_[ir::InstId(decoded_[end].id)].op == ir::OpKind::kStatement) {
      flags |= Decoded::kHasStatement;
      ++end;
    }
    while (end < region.constants) {
      const Decoded& decoded = decoded_[end];
      const std::optional<LogicStep> step = Functions::StepOf(program_[ir::InstId(decoded.id)], decoded);
      if (!step) break;
      logic_.push_back(*step);
      ++end;
    }
    const uint32_t step_count = static_cast<uint32_t>(logic_.size()) - first_step;
    if (end < region.constants && decoded_[end].execute == Functions::StoreBit) {
      flags |= Decoded::kHasCoil;
      ++end;
    }
    if (end - at < kLeast) {
      logic_.resize(first_step);
      ready_.push_back(decoded_[at]);
      ++at;
      continue;
    }
    const Decoded& last = decoded_[end - 1];
    ready_.push_back({.execute = Functions::ExecuteRung,
                      .id = last.id,
                      .order = last.order,
                      .a = at,
                      .b = first_step,
                      .c = step_count,
                      .payload = flags});
    at = end;
  }
  region.ready_end = static_cast<uint32_t>(ready_.size());
}

void Simulator::FindBases() {
  bases_.clear();
  bases_.push_back(reinterpret_cast<const unsigned char*>(values_.data()));
  bases_.push_back(instances_.bytes());
  for (const ForcedBytes& space : spaces_) bases_.push_back(space.bytes().data());
}

}  // namespace plcxx::sim
