#include "tests/reference/reference_engine.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "transpiler/ir/slices.h"

namespace plcxx::reference {
namespace {

Choices ChoicesOf(const ir::Program& program) {
  Choices choices;
  for (const ir::Statement& statement : program.statements) {
    choices.statement_ids[statement.range.begin] = statement.id;
  }
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    const ir::RoutineId routine(i);
    if (!program.routines[routine].sliced) continue;
    choices.slice_count = program.routines[routine].slices;
    for (const ir::SlicePiece& piece : ir::SlicePieces(program, routine)) {
      for (const ir::InstId id : program.regions[piece.region].insts) {
        const ir::Inst& inst = program[id];
        if (inst.op != ir::OpKind::kStatement) continue;
        choices.slices[program.statements[ir::StatementId(inst.payload)].range.begin] =
            static_cast<uint32_t>(piece.slice);
      }
    }
  }
  return choices;
}

}  // namespace

ReferenceEngine::ReferenceEngine(const ir::Program& program, sim::Simulator& beside, const Make& make)
    : program_(program), beside_(beside) {
  reference_ = make(
      [this](std::string_view function, const std::vector<uint64_t>& arguments) { return Call(function, arguments); });
  reference_->Take(ChoicesOf(program));
  size_t at = 0;
  const std::vector<AddressSpace>& memories = reference_->memories();
  for (uint32_t i = 0; i < program.spaces.size(); ++i) {
    const ir::Space& space = program.spaces[ir::SpaceId(i)];
    const auto known = std::ranges::find(memories, space.name, &AddressSpace::name);
    memory_of_space_.push_back(known == memories.end() ? kNone : static_cast<uint32_t>(known - memories.begin()));
    space_at_.push_back(at);
    if (!space.host_visible) continue;
    at += space.bytes;
    if (known == memories.end() || known->size() != space.bytes) {
      mismatches_.push_back("space " + space.name + " of " + std::to_string(space.bytes) + " bytes");
      memory_of_space_.back() = kNone;
      continue;
    }
    compared_ += space.bytes;
  }
  for (uint32_t i = 0; i < program.states.size(); ++i) {
    const ir::StateInstance& instance = program.states[ir::StateId(i)];
    std::vector<KnownField>& fields = fields_.emplace_back();
    for (const ir::FieldInfo& field : ir::Info(instance.kind).fields) {
      KnownField& known = fields.emplace_back();
      known.at = at;
      known.bytes = ir::Bytes(field.type);
      at += size_t{known.bytes} * field.count;
      std::optional<Element> element = reference_->FindElement(instance.name, field.name);
      if (!element) continue;
      known.name = instance.name + "." + std::string(field.name);
      known.element = std::move(*element);
      ++compared_;
    }
  }
}

Answer ReferenceEngine::Call(std::string_view name, const std::vector<uint64_t>& arguments) {
  for (uint32_t i = 0; i < program_.host_functions.size(); ++i) {
    const ir::HostFunctionId id(i);
    const ir::HostFunction& function = program_.host_functions[id];
    if (function.name != name) continue;
    if (!function.routine_exchange) events_.push_back({id, arguments});
    const ir::Schedule& schedule = program_.schedule;
    if (id == schedule.retentive_load || id == schedule.retentive_store || !answers_) return {};
    const sim::HostAnswer answer = answers_(id, arguments);
    return {answer.result, answer.out};
  }
  const std::string missing = "host function " + std::string(name);
  if (std::ranges::find(mismatches_, missing) == mismatches_.end()) mismatches_.push_back(missing);
  return {};
}

AddressSpace* ReferenceEngine::MemoryOf(const ir::Place& place) {
  if (place.is_field() || !place.space.valid() || memory_of_space_[place.space.index] == kNone) return nullptr;
  AddressSpace& memory = reference_->memories()[memory_of_space_[place.space.index]];
  return place.offset + ir::Bytes(place.type) <= memory.size() ? &memory : nullptr;
}

ReferenceEngine::KnownField* ReferenceEngine::FieldOf(const ir::Place& place) {
  if (!place.is_field()) return nullptr;
  KnownField& field = fields_[place.state.index][place.field];
  return field.name.empty() ? nullptr : &field;
}

uint32_t ReferenceEngine::ByteAt(const ir::Place& place, uint32_t significance) const {
  const bool big_endian = program_.spaces[place.space].order == ir::ByteOrder::kBig;
  return place.offset + (big_endian ? ir::Bytes(place.type) - 1 - significance : significance);
}

uint64_t ReferenceEngine::Read(const ir::Place& place) {
  if (const KnownField* field = FieldOf(place)) return field->element.read();
  const AddressSpace* memory = MemoryOf(place);
  if (memory == nullptr) return beside_.Read(place);
  if (place.type == ir::Type::kBit) return (*memory)[place.offset] >> place.bit & 1;
  uint64_t value = 0;
  for (uint32_t i = 0; i < ir::Bytes(place.type); ++i) value |= uint64_t{(*memory)[ByteAt(place, i)]} << (8 * i);
  return value;
}

void ReferenceEngine::Write(const ir::Place& place, uint64_t value) {
  if (const KnownField* field = FieldOf(place)) {
    field->element.write(value);
    reference_->HostWrote();
    return;
  }
  AddressSpace* memory = MemoryOf(place);
  if (memory == nullptr) return;
  if (place.type == ir::Type::kBit) {
    memory->Write(place.offset, static_cast<uint8_t>(1u << place.bit), (value & 1) != 0 ? 0xFF : 0);
    return;
  }
  for (uint32_t i = 0; i < ir::Bytes(place.type); ++i) {
    memory->Write(ByteAt(place, i), 0xFF, static_cast<uint8_t>(value >> (8 * i)));
  }
}

void ReferenceEngine::Force(const ir::Place& place, uint64_t value) {
  if (const KnownField* field = FieldOf(place)) {
    reference_->ForceElement(field->name, field->element, value);
    return;
  }
  Release(place);
  Write(place, value);
  AddressSpace* memory = MemoryOf(place);
  if (memory == nullptr) return;
  const auto mask = place.type == ir::Type::kBit ? static_cast<uint8_t>(1u << place.bit) : uint8_t{0xFF};
  for (uint32_t i = 0; i < ir::Bytes(place.type); ++i) memory->Force(place.offset + i, mask);
}

void ReferenceEngine::Release(const ir::Place& place) {
  if (const KnownField* field = FieldOf(place)) reference_->ReleaseElement(field->name);
  AddressSpace* memory = MemoryOf(place);
  if (memory == nullptr) return;
  const auto mask = place.type == ir::Type::kBit ? static_cast<uint8_t>(1u << place.bit) : uint8_t{0xFF};
  for (uint32_t i = 0; i < ir::Bytes(place.type); ++i) memory->Release(place.offset + i, mask);
}

std::vector<sim::HostEvent> ReferenceEngine::TakeEvents() { return std::exchange(events_, {}); }

std::vector<uint8_t> ReferenceEngine::Snapshot() {
  std::vector<uint8_t> bytes = beside_.Snapshot();
  for (uint32_t i = 0; i < program_.spaces.size(); ++i) {
    if (!program_.spaces[ir::SpaceId(i)].host_visible || memory_of_space_[i] == kNone) continue;
    std::ranges::copy(reference_->memories()[memory_of_space_[i]].bytes(),
                      bytes.begin() + static_cast<std::ptrdiff_t>(space_at_[i]));
  }
  for (const std::vector<KnownField>& fields : fields_) {
    for (const KnownField& field : fields) {
      if (field.name.empty()) continue;
      const uint64_t value = field.element.read();
      for (uint32_t i = 0; i < field.bytes; ++i) bytes[field.at + i] = static_cast<uint8_t>(value >> (8 * i));
    }
  }
  return bytes;
}

}  // namespace plcxx::reference
