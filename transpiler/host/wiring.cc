// The pins of a program's places, host functions and messages.

#include "transpiler/host/wiring.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>

#include "transpiler/diagnostics/host_messages.h"
#include "transpiler/ir/accesses.h"
#include "transpiler/ir/place_names.h"
#include "transpiler/ir/zones.h"
#include "transpiler/support/check.h"

namespace plcxx::host {
namespace {

constexpr uint32_t Bits(const ir::Place& place) { return place.type == ir::Type::kBit ? 1 : 8 * ir::Bytes(place.type); }
/// Bits of the space, from its first byte's least significant one.
constexpr uint32_t FirstBit(const ir::Place& place) {
  return 8 * place.offset + (place.type == ir::Type::kBit ? place.bit : 0);
}
constexpr bool IsFloat(ir::Type type) { return type == ir::Type::kF32 || type == ir::Type::kF64; }

/// Who has each bit of a space: a pin's number, or nobody.
using Owners = std::vector<std::optional<uint32_t>>;

class Wirer {
 public:
  Wirer(const emit::Emittable& emittable, diag::Engine& diagnostics)
      : emittable_(emittable), program_(*emittable.program), diagnostics_(diagnostics) {}

  Wiring Run() {
    for (const ir::Documentation& row : program_.documentation) documentation_.emplace(row.address, &row);
    for (const ir::Symbol& symbol : program_.symbols) has_sign_[symbol.name] = symbol.has_sign;
    for (const ir::Space& space : program_.spaces) stored_.emplace_back(8 * size_t{space.bytes});
    ranges_.resize(program_.places.size());
    for (const ir::InstId id : emit::PrintedInsts(program_, emittable_.options)) NoteAccess(program_[id]);
    Inputs();
    Outputs();
    Messages();
    Calls();
    Schedule();
    NamePins(emittable_.options.name, wiring_.pins, diagnostics_);
    return std::move(wiring_);
  }

 private:
  void NoteAccess(const ir::Inst& inst) {
    ir::ForEachAccess(
        program_, inst,
        [&](ir::PlaceId id, ir::Access access) {
          if (ranges_[id.index] == source::Range{}) ranges_[id.index] = inst.range;
          const ir::Place& place = program_.places[id];
          if (access == ir::Access::kRead || place.is_field()) return;
          std::vector<bool>& bits = stored_[place.space.index];
          const uint32_t first = place.indexed ? 8 * place.low : FirstBit(place);
          const uint32_t end = place.indexed ? 8 * place.high : first + Bits(place);
          for (uint32_t i = first; i < end && i < bits.size(); ++i) bits[i] = true;
        },
        [](ir::StateId) {});
  }

  // --- places ---

  bool IsUsed(ir::PlaceId id) const {
    const emit::layout::Storage storage = emittable_.layout.places[id.index].storage;
    return !emittable_.place_names[id.index].empty() && storage != emit::layout::Storage::kNone &&
           storage != emit::layout::Storage::kLocal && !program_.places[id].indexed &&
           program_.places[id].type != ir::Type::kNone;
  }
  ir::Direction DirectionOf(const ir::Place& place) const {
    return ir::DirectionOf(program_.spaces[place.space], place.offset, place.bit == ir::kNoBit ? 0 : place.bit);
  }
  bool IsStored(const ir::Place& place) const {
    const std::vector<bool>& bits = stored_[place.space.index];
    for (uint32_t i = 0; i < Bits(place); ++i) {
      if (bits[FirstBit(place) + i]) return true;
    }
    return false;
  }
  /// The control's own counts and times are nobody's signals.
  bool IsOutside(const ir::Place& place) const { return program_.spaces[place.space].host_visible; }

  PinType TypeOf(ir::PlaceId id) {
    const ir::Place& place = program_.places[id];
    switch (place.type) {
      case ir::Type::kBit:
        return PinType::kBit;
      case ir::Type::kF32:
      case ir::Type::kF64:
        return PinType::kFloat;
      case ir::Type::kI8:
      case ir::Type::kI16:
      case ir::Type::kI32:
        return HasSign(place) ? PinType::kS32 : PinType::kU32;
      case ir::Type::kI64:
        diagnostics_.Report(ranges_[id.index], diag::HostPinTooWide, ir::SourceName(place));
        return PinType::kU32;
      case ir::Type::kNone:
        break;
    }
    PLCXX_CHECK(false);
  }
  bool HasSign(const ir::Place& place) const {
    const auto found = has_sign_.find(place.name);
    return found != has_sign_.end() && found->second;
  }

  uint32_t AddPin(WiredPin pin) {
    wiring_.pins.push_back(std::move(pin));
    return static_cast<uint32_t>(wiring_.pins.size() - 1);
  }
  WiredPin PinOf(ir::PlaceId id, PinDirection direction, PinRole role) {
    const ir::Place& place = program_.places[id];
    const std::string& number = emittable_.place_names[id.index];
    WiredPin pin{PinName(number), number, TypeOf(id), direction, role, ir::SourceName(place), {}, ranges_[id.index]};
    if (const auto row = documentation_.find(pin.address); row != documentation_.end())
      pin.comment = row->second->help.empty() ? row->second->meaning : row->second->help;
    return pin;
  }

  void Inputs() {
    std::vector<ir::PlaceId> places;
    for (uint32_t i = 0; i < program_.places.size(); ++i) {
      const ir::Place& place = program_.places[ir::PlaceId(i)];
      if (!IsUsed(ir::PlaceId(i)) || place.is_field() || !IsOutside(place)) continue;
      if (DirectionOf(place) == ir::Direction::kInput && !IsStored(place)) places.push_back(ir::PlaceId(i));
    }
    const auto bits_of = [&](ir::PlaceId id) { return Bits(program_.places[id]); };
    // The smallest first: a word that has terminals in it gets pins for the rest of its bits alone.
    std::vector<ir::PlaceId> ascending = places;
    std::ranges::stable_sort(ascending, {}, bits_of);
    std::vector<Owners> owners;
    for (const ir::Space& space : program_.spaces) owners.emplace_back(8 * size_t{space.bytes});
    for (const ir::PlaceId id : ascending) GivePins(id, owners[program_.places[id].space.index]);

    std::vector<std::vector<bool>> written;
    for (const ir::Space& space : program_.spaces) written.emplace_back(8 * size_t{space.bytes});
    std::ranges::stable_sort(places, std::ranges::greater{}, bits_of);
    for (const ir::PlaceId id : places) {
      const ir::Place& place = program_.places[id];
      std::vector<bool>& bits = written[place.space.index];
      bool inside = true;  // of greater places that are written
      for (uint32_t i = 0; i < Bits(place); ++i) inside = inside && bits[FirstBit(place) + i];
      if (inside) continue;
      for (uint32_t i = 0; i < Bits(place); ++i) bits[FirstBit(place) + i] = true;
      wiring_.inputs.push_back({id, PartsOf(place, owners[place.space.index])});
    }
  }

  void GivePins(ir::PlaceId id, Owners& owners) {
    const ir::Place& place = program_.places[id];
    const uint32_t first = FirstBit(place), bits = Bits(place);
    const auto is_free = [&](uint32_t begin, uint32_t count) {
      for (uint32_t i = begin; i < begin + count; ++i) {
        if (owners[i]) return false;
      }
      return true;
    };
    const auto take = [&](uint32_t begin, uint32_t count, WiredPin pin) {
      const uint32_t number = AddPin(std::move(pin));
      for (uint32_t i = begin; i < begin + count; ++i) owners[i] = number;
    };
    if (is_free(first, bits) || IsFloat(place.type)) {
      take(first, bits, PinOf(id, PinDirection::kIn, PinRole::kTerminal));
      return;
    }
    for (uint32_t byte = 0; 8 * byte < bits; ++byte) {
      const bool whole = bits > 8 && is_free(first + 8 * byte, 8);
      for (uint32_t bit = 0; bit < (whole ? 1U : 8U); ++bit) {
        const uint32_t at = first + 8 * byte + bit;
        if (owners[at]) continue;
        const std::string suffix = whole ? "_byte_" + std::to_string(byte) : "_" + std::to_string(8 * byte + bit);
        WiredPin pin = PinOf(id, PinDirection::kIn, PinRole::kTerminal);
        pin.number += suffix;
        pin.name = PinName(pin.number);
        pin.address += (whole ? " byte " : " bit ") + std::to_string(whole ? byte : 8 * byte + bit);
        pin.type = whole ? PinType::kU32 : PinType::kBit;
        take(at, whole ? 8 : 1, std::move(pin));
      }
    }
  }

  /// From the least significant bit on.
  std::vector<InputPart> PartsOf(const ir::Place& place, const Owners& owners) const {
    std::vector<InputPart> parts;
    const bool big = program_.spaces[place.space].order == ir::ByteOrder::kBig;
    const uint32_t bytes = ir::Bytes(place.type), width = Bits(place);
    for (uint32_t i = 0; i < width; ++i) {
      const uint32_t byte = big ? bytes - 1 - i / 8 : i / 8;
      const std::optional<uint32_t> pin = owners[width == 1 ? FirstBit(place) : 8 * (place.offset + byte) + i % 8];
      PLCXX_CHECK(pin.has_value());
      if (parts.empty() || parts.back().pin != *pin) parts.push_back({*pin, i, 0});
      ++parts.back().bits;
    }
    return parts;
  }

  void Outputs() {
    for (uint32_t i = 0; i < program_.places.size(); ++i) {
      const ir::PlaceId id(i);
      const ir::Place& place = program_.places[id];
      if (!IsUsed(id)) continue;
      const bool named = !place.address.empty() && place.address != place.name;
      if (place.is_field()) {
        if (named) AddOutput(id, PinRole::kSignal);
        continue;
      }
      if (!IsOutside(place)) continue;
      const ir::Direction direction = DirectionOf(place);
      const bool kept = program_.spaces[place.space].lifetime == ir::Lifetime::kRetentive;
      if (kept && !IsStored(place)) {
        wiring_.parameters.push_back({id, AddPin(PinOf(id, PinDirection::kBoth, PinRole::kParameter))});
      } else if (direction == ir::Direction::kOutput) {
        AddOutput(id, PinRole::kTerminal);
      } else if (named && (direction == ir::Direction::kInternal || IsStored(place))) {
        AddOutput(id, PinRole::kSignal);
      }
    }
  }
  void AddOutput(ir::PlaceId id, PinRole role) {
    wiring_.outputs.push_back({id, AddPin(PinOf(id, PinDirection::kOut, role))});
  }

  // --- messages ---

  void Messages() {
    std::map<uint32_t, WiredMessage> messages;
    for (const ir::MessageBits& bits : program_.message_bits) {
      for (uint32_t i = 0; i < program_.places.size(); ++i) {
        const ir::Place& place = program_.places[ir::PlaceId(i)];
        if (!IsUsed(ir::PlaceId(i)) || place.is_field() || place.space != bits.space) continue;
        if (place.type != ir::Type::kBit || place.offset < bits.offset) continue;
        const uint32_t index = 8 * (place.offset - bits.offset) + place.bit;
        if (index < bits.count) messages[bits.first_number + index].bit = ir::PlaceId(i);
      }
    }
    for (const ir::MessageWord& word : program_.message_words) {
      if (IsUsed(word.place)) wiring_.message_words.push_back(word.place);
    }
    for (const ir::MessageText& text : program_.messages) {
      const auto known = messages.find(text.number);
      if (known != messages.end()) {
        known->second.text = text.text;
      } else if (!text.text.empty() && !wiring_.message_words.empty()) {
        messages[text.number].text = text.text;
      }
    }
    for (auto& [number, message] : messages) {
      message.number = number;
      wiring_.messages.push_back(std::move(message));
    }
    if (wiring_.messages.empty()) return;
    wiring_.message_pin = AddPin({"message.number",
                                  "message_number",
                                  PinType::kU32,
                                  PinDirection::kOut,
                                  PinRole::kEvent,
                                  "message.number",
                                  "the lowest number of those that are shown; 0: none",
                                  {}});
  }

  // --- host functions ---

  void Calls() {
    for (uint32_t i = 0; i < program_.host_functions.size(); ++i) {
      if (emittable_.host_used[i]) wiring_.calls.push_back(CallOf(ir::HostFunctionId(i)));
    }
  }

  WiredCall CallOf(ir::HostFunctionId id) {
    const ir::HostFunction& function = program_.host_functions[id];
    WiredCall call{id, CallRole::kEvent, 0, {}};
    const bool plain = function.parameters.empty() && function.result == ir::Type::kNone;
    if (id == program_.schedule.now) {
      call.role = CallRole::kClock;
    } else if (id == program_.schedule.retentive_store) {
      call.role = CallRole::kStore;
    } else if (function.access == ir::HostAccess::kWritesRetentive) {
      call.role = CallRole::kLoad;
    } else if (plain && function.access == ir::HostAccess::kWritesState) {
      call.role = CallRole::kTakeInputs;
    } else if (plain && function.access == ir::HostAccess::kReadsState) {
      call.role = CallRole::kGiveOutputs;
    } else if (std::optional<std::vector<uint64_t>> ports = PortsOf(id)) {
      call.role = CallRole::kPort;
      for (const uint64_t port : *ports) call.ports.push_back({port, AddPort(function, port)});
    } else {
      AddEvent(function, call);
    }
    return call;
  }

  /// The values of the first parameter, where all that the function does is one byte of the exchange.
  std::optional<std::vector<uint64_t>> PortsOf(ir::HostFunctionId id) const {
    const ir::HostFunction& function = program_.host_functions[id];
    const size_t parameters = function.parameters.size();
    const bool reads = parameters == 1 && function.result == ir::Type::kI8;
    const bool writes =
        parameters == 2 && function.result == ir::Type::kNone && function.parameters[1].type == ir::Type::kI8;
    if ((!reads && !writes) || function.access != ir::HostAccess::kNone || !function.out.name.empty())
      return std::nullopt;
    std::set<uint64_t> ports;
    bool exchanges = false;
    for (const ir::InstId inst : emit::PrintedInsts(program_, emittable_.options)) {
      if (program_[inst].op != ir::OpKind::kHostCall) continue;
      const ir::Call& call = program_.calls[ir::CallId(program_[inst].payload)];
      if (call.host != id) continue;
      const ir::Inst& port = program_[call.arguments[0]];
      if (port.op != ir::OpKind::kConst) return std::nullopt;
      exchanges = exchanges || call.exchange;
      ports.insert(ir::ConstantValue(port));
    }
    if (!exchanges) return std::nullopt;
    return std::vector<uint64_t>(ports.begin(), ports.end());
  }
  uint32_t AddPort(const ir::HostFunction& function, uint64_t port) {
    const PinDirection direction = function.result == ir::Type::kNone ? PinDirection::kOut : PinDirection::kIn;
    uint32_t first = 0;
    for (uint32_t bit = 0; bit < 8; ++bit) {
      const std::string number = function.name + "_" + std::to_string(port) + "_" + std::to_string(bit);
      const uint32_t pin = AddPin({PinName(number),
                                   number,
                                   PinType::kBit,
                                   direction,
                                   PinRole::kTerminal,
                                   std::to_string(port) + "." + std::to_string(bit),
                                   function.comment,
                                   {}});
      if (bit == 0) first = pin;
    }
    return first;
  }

  static PinType TypeOf(const ir::Parameter& parameter) {
    return parameter.type == ir::Type::kBit ? PinType::kBit : IsFloat(parameter.type) ? PinType::kFloat : PinType::kU32;
  }
  void AddEvent(const ir::HostFunction& function, WiredCall& call) {
    const auto add = [&](const std::string& what, PinType type, PinDirection direction, const std::string& comment) {
      const std::string name = PinName(function.name) + "." + PinName(what);
      return AddPin({name, function.name + "_" + what, type, direction, PinRole::kEvent, name, comment, {}});
    };
    call.first_pin = add("calls", PinType::kU32, PinDirection::kOut, function.comment);
    for (const ir::Parameter& parameter : function.parameters) {
      std::string words;
      for (const std::string& word : parameter.enumerators) words += (words.empty() ? "" : ", ") + word;
      add(parameter.name, TypeOf(parameter), PinDirection::kOut,
          words.empty() ? "of the last call" : "of the last call: " + words);
    }
    if (function.result != ir::Type::kNone)
      add("result", TypeOf({"result", function.result, {}}), PinDirection::kIn, "what the function answers");
    if (!function.out.name.empty())
      add(function.out.name, TypeOf(function.out), PinDirection::kIn, "what the function answers");
  }

  void Schedule() {
    const ir::Schedule& schedule = program_.schedule;
    wiring_.base_ms = std::max(1U, schedule.period_ms);
    if (schedule.fast_ms != 0) wiring_.base_ms = std::gcd(schedule.fast_ms, schedule.period_ms);
    if (schedule.elapses_every_ms) wiring_.base_ms = 1;
    const bool program_stores =
        std::ranges::any_of(wiring_.calls, [](const WiredCall& call) { return call.role == CallRole::kStore; });
    wiring_.stores_by_itself = emittable_.layout.retentive_bytes > 0 && !program_stores;
  }

  const emit::Emittable& emittable_;
  const ir::Program& program_;
  diag::Engine& diagnostics_;
  Wiring wiring_;
  std::map<std::string_view, const ir::Documentation*> documentation_;
  std::map<std::string, bool> has_sign_;
  std::vector<std::vector<bool>> stored_;  // by SpaceId: bits that a statement stores
  std::vector<source::Range> ranges_;      // by PlaceId: of the first statement that uses it
};

}  // namespace

Wiring Wire(const emit::Emittable& emittable, diag::Engine& diagnostics) { return Wirer(emittable, diagnostics).Run(); }

}  // namespace plcxx::host
