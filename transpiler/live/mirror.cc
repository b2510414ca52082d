#include "transpiler/live/mirror.h"

#include <optional>

#include "transpiler/live/fault_statement.h"
#include "transpiler/support/check.h"

namespace plcxx::live {
namespace {

using emit::layout::ByteStorage;
using emit::layout::Storage;

constexpr uint8_t kText = 0;  // of a TextInbox: the only field that is an array

std::optional<uint8_t> FieldNamed(ir::StateKind kind, std::string_view name) {
  const auto fields = ir::Info(kind).fields;
  for (size_t i = 0; i < fields.size(); ++i) {
    if (fields[i].name == name) return static_cast<uint8_t>(i);
  }
  return std::nullopt;
}

}  // namespace

Mirror::Mirror(const ir::Program& program, const emit::layout::Layout& layout, Machine& machine)
    : program_(program),
      machine_(machine),
      homes_(layout.size),
      state_(layout.size),
      saved_(machine.simulator().Save()) {
  for (uint32_t space = 0; space < layout.bytes.size(); ++space) {
    for (uint32_t at = 0; at < layout.bytes[space].size(); ++at) {
      const ByteStorage& stored = layout.bytes[space][at];
      if (stored.whole.storage != Storage::kNone) {
        homes_[stored.whole.offset] = {.kind = Kind::kByte, .owner = space, .at = at};
        continue;
      }
      for (uint8_t bit = 0; bit < 8; ++bit) {
        if (stored.bits[bit].storage == Storage::kNone) continue;
        homes_[stored.bits[bit].offset] = {.kind = Kind::kBit, .bit = bit, .owner = space, .at = at};
      }
    }
  }
  FindFields(program, layout);
}

void Mirror::FindFields(const ir::Program& program, const emit::layout::Layout& layout) {
  for (uint32_t i = 0; i < program.states.size(); ++i) {
    const ir::StateKind kind = program.states[ir::StateId(i)].kind;
    const auto fields = ir::Info(kind).fields;
    for (size_t number = 0; number < fields.size(); ++number) {
      const auto field = static_cast<uint8_t>(number);
      PLCXX_CHECK(fields[field].count == 1 || (kind == ir::StateKind::kTextInbox && field == kText));
      const auto bytes = static_cast<uint8_t>(ir::Bytes(fields[field].type));
      const uint32_t begin = layout.states[i].offset + emit::layout::FieldOffset(kind, field);
      for (uint32_t j = 0; j < uint32_t{bytes} * fields[field].count; ++j) {
        homes_[begin + j] = {.kind = Kind::kField,
                             .field = field,
                             .bytes = bytes,
                             .owner = i,
                             .at = j / bytes,
                             .first = begin + j / bytes * bytes};
      }
    }
  }
}

void Mirror::Put(const Home& home, uint32_t offset) {
  switch (home.kind) {
    case Kind::kNothing:
      return;
    case Kind::kByte:
      saved_.spaces[home.owner].Write(home.at, 0xFF, state_[offset]);
      return;
    case Kind::kBit: {
      const auto mask = static_cast<uint8_t>(1U << home.bit);
      saved_.spaces[home.owner].Write(home.at, mask, (state_[offset] & 1) != 0 ? mask : uint8_t{0});
      return;
    }
    case Kind::kField: {
      uint64_t value = 0;
      for (uint32_t i = 0; i < home.bytes; ++i) value |= uint64_t{state_[home.first + i]} << (8 * i);
      if (program_.states[ir::StateId(home.owner)].kind == ir::StateKind::kTextInbox && home.field == kText) {
        saved_.instances.Get<TextInbox>(home.owner).text[home.at] = static_cast<char>(value);
      } else {
        saved_.instances.Write(home.owner, home.field, value);
      }
      return;
    }
  }
}

void Mirror::Take(uint32_t offset, std::span<const uint8_t> bytes) {
  for (size_t i = 0; i < bytes.size() && offset + i < state_.size(); ++i) {
    const auto at = static_cast<uint32_t>(offset + i);
    state_[at] = bytes[i];
    Put(homes_[at], at);
  }
}

void Mirror::Show() { machine_.simulator().Restore(saved_); }

uint32_t Mirror::NowMs() const {
  const std::optional<uint8_t> last = FieldNamed(ir::StateKind::kOnDelayTimer, "last_ms");
  std::optional<uint32_t> now;
  for (uint32_t i = 0; i < program_.states.size(); ++i) {
    if (program_.states[ir::StateId(i)].kind != ir::StateKind::kOnDelayTimer) continue;
    const auto ms = static_cast<uint32_t>(saved_.instances.Read(i, *last));
    // The clock wraps: what is less than half a turn ahead is later.
    if (!now || static_cast<int32_t>(ms - *now) > 0) now = ms;
  }
  return now.value_or(0);
}

std::vector<sim::HostEvent> Mirror::ComputeAgain() {
  Show();
  machine_.ComputeAgain(NowMs());
  std::vector<sim::HostEvent> events = machine_.simulator().TakeEvents();
  Show();
  std::erase_if(events, [&](const sim::HostEvent& event) { return !FaultStatement(program_, event); });
  return events;
}

}  // namespace plcxx::live
