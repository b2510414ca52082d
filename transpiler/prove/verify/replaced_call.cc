#include "transpiler/prove/verify/replaced_call.h"

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <ranges>

#include "transpiler/symbolic/meaning/meaning.h"
#include "transpiler/symbolic/terms/index_bits.h"
#include "transpiler/symbolic/terms/specialization.h"

namespace plcxx::prove::verify {
namespace {

constexpr uint8_t kHashWidth = 32;
constexpr const char* kNoBit = "a byte that holds a bit and is neither 0 nor 1 at a call";

uint8_t BytesFor(uint8_t width) { return static_cast<uint8_t>((width + 7) / 8); }

terms::TermId ReadBytes(terms::Terms& terms, CodeMemory& memory, uint32_t slot, uint8_t bytes) {
  terms::TermId value = memory.Read(slot);
  for (uint8_t i = 1; i < bytes; ++i) value = terms.Concat(memory.Read(slot + i), value);
  return value;
}

void WriteBytes(terms::Terms& terms, CodeMemory& memory, uint32_t slot, terms::TermId value) {
  const auto width = static_cast<uint8_t>(8 * BytesFor(terms.Width(value)));
  const terms::TermId wide = terms.Zext(value, width);
  for (uint8_t i = 0; i < width / 8; ++i) memory.Write(slot + i, terms.Extract(wide, static_cast<uint8_t>(8 * i), 8));
}

/// Whether a compiled function still gets a parameter, or what stands at it: one that it does not use has no name.
bool Gets(const std::vector<std::string>& parameters, const std::string& name) {
  return std::ranges::any_of(
      parameters, [&](const std::string& parameter) { return parameter == name || PromotedOffset(parameter, name); });
}

}  // namespace

std::vector<std::string> ParametersOf(const emit::Emittable& emittable, const Unit& unit, Passes passes) {
  std::vector<std::string> names;
  if (passes == Passes::kStateAndHost) names.emplace_back("m");
  for (const std::vector<ir::PlaceId>* places : {&unit.values, &unit.references}) {
    for (const ir::PlaceId place : *places) names.push_back(emittable.place_names[place.index]);
  }
  if (passes == Passes::kStateAndHost) names.emplace_back("host");
  return names;
}

terms::TermId CallLog::ByArguments(const ReplacedCall& call, std::span<const terms::TermId> arguments) {
  return terms_.Apply(terms_.Function("call of " + call.unit().name, 64), arguments);
}

std::vector<CallLog::Entry*> CallLog::EntriesOf(const ReplacedCall& call, terms::TermId when) {
  std::vector<Entry*> of_function;
  for (Entry& entry : entries_) {
    if (entry.call == &call) of_function.push_back(&entry);
  }
  const auto is_free = [](const Entry* entry) { return entry->taken.empty(); };
  if (of_function.size() == 1 && is_free(of_function.front())) return of_function;
  // The latest first that has been taken, where another branch may have made it; then those after it.
  const auto taken = std::find_if_not(of_function.rbegin(), of_function.rend(), is_free);
  std::vector<Entry*> open(taken == of_function.rend() ? of_function.begin() : std::prev(taken.base()),
                           of_function.end());
  open.insert(open.end(), of_function.begin(), of_function.end() - static_cast<std::ptrdiff_t>(open.size()));
  for (Entry* entry : open) {
    const bool fits =
        std::ranges::all_of(entry->taken, [&](terms::TermId other) { return never_(terms_.And(when, other)); }) &&
        never_(terms_.And(when, terms_.Not(entry->when)));
    if (fits) return {entry};
  }
  // After branches that end alike, one call of the code is now this, now that one of the program's.
  std::erase_if(open, [&](const Entry* entry) { return !is_free(entry) || never_(terms_.And(when, entry->when)); });
  return open;
}

terms::TermId CallLog::CalledByProgram(const ReplacedCall& call, std::vector<terms::TermId> arguments,
                                       terms::TermId when) {
  if (matching_ == Matching::kByArguments) return ByArguments(call, arguments);
  const std::string name = "call " + std::to_string(entries_.size() + 1) + ", of " + call.unit().name;
  entries_.push_back({.call = &call,
                      .arguments = std::move(arguments),
                      .known = terms_.Variable(name, 64),
                      .when = when,
                      .taken = {}});
  return entries_.back().known;
}

terms::TermId CallLog::CalledByCode(const ReplacedCall& call, std::vector<terms::TermId> arguments,
                                    terms::TermId when) {
  if (matching_ == Matching::kByArguments) return ByArguments(call, arguments);
  const std::vector<Entry*> entries = EntriesOf(call, when);
  if (entries.empty()) return {};
  terms::TermId known = entries.back()->known;
  std::vector<terms::TermId> expected = entries.back()->arguments;
  for (const Entry* entry : entries | std::views::take(entries.size() - 1) | std::views::reverse) {
    known = terms_.Ite(entry->when, entry->known, known);
    for (size_t i = 0; i < expected.size(); ++i)
      expected[i] = terms_.Ite(entry->when, entry->arguments[i], expected[i]);
  }
  for (Entry* entry : entries) entry->taken.push_back(when);
  const terms::KnownIndexBits there = terms::KnownWhere(terms_, when);
  for (size_t i = 0; i < arguments.size(); ++i) {
    if (expected[i] == arguments[i]) continue;
    // Where the code does not come here, its call is none.
    const terms::TermId code = terms::WhereKnown(terms_, arguments[i], there);
    const terms::TermId program = terms_.Ite(when, terms::WhereKnown(terms_, expected[i], there), code);
    if (program != code) claims_.push_back({.call = &call, .program = program, .code = code});
  }
  return known;
}

ReplacedCall::ReplacedCall(const emit::Emittable& emittable, const execute::Cells& cells, const StateImage& image,
                           const Unit& unit, Passes passes, const std::vector<std::string>& parameters,
                           std::optional<NumberRange> result)
    : program_(*emittable.program),
      cells_(cells),
      image_(image),
      unit_(unit),
      parameters_(ParametersOf(emittable, unit, passes)),
      passes_(passes),
      result_(result) {
  AddItems(passes);
  for (const ir::PlaceId place : unit.values) {
    if (Gets(parameters, emittable.place_names[place.index]))
      items_.push_back({.kind = Kind::kValue,
                        .cell = {},
                        .place = place,
                        .width = meaning::WidthOf(program_.places[place].type),
                        .name = emittable.place_names[place.index]});
  }
  for (const ir::PlaceId place : unit.references) {
    if (!Gets(parameters, emittable.place_names[place.index])) continue;
    const std::vector<execute::CellId> touched = execute::CellsOf(program_, cells_, program_.places[place]);
    const auto any = [&touched](const std::vector<bool>& cells) {
      return std::ranges::any_of(touched, [&cells](execute::CellId cell) { return bool{cells[cell.index]}; });
    };
    const bool written = any(unit.footprint.written);
    items_.push_back({.kind = Kind::kReference,
                      .cell = {},
                      .place = place,
                      .width = meaning::WidthOf(program_.places[place].type),
                      .written = written,
                      .read = !written || any(unit.footprint.read),
                      .name = emittable.place_names[place.index]});
  }
}

void ReplacedCall::AddItems(Passes passes) {
  const Footprint& footprint = unit_.footprint;
  const bool shows_state = footprint.shows_state || (footprint.lends_state && passes == Passes::kStateAndHost);
  std::vector<bool> placed(cells_.count);
  for (uint32_t at = 0; at < image_.size(); ++at) {
    const StateByte& byte = image_[at];
    const bool retentive = image_.retentive_begin() <= at && at < image_.retentive_end();
    const bool shown = shows_state || (footprint.shows_retentive && retentive);
    if (byte.kind == ByteKind::kNothing) continue;
    if (byte.kind == ByteKind::kLayout) {
      if (shown && byte.low == 0)
        items_.push_back(
            {.kind = Kind::kLayout, .offset = at, .cell = {}, .place = {}, .width = kHashWidth, .name = "layout"});
      continue;
    }
    const bool whole = byte.kind == ByteKind::kBits;
    if (!whole && byte.low != 0) continue;
    bool touched = shown, written = false, read = shown;
    for (uint32_t i = 0; i < (whole ? 8U : 1U); ++i) {
      const uint32_t cell = byte.cell.index + i;
      placed[cell] = true;
      touched = touched || footprint.touched[cell];
      written = written || footprint.written[cell];
      read = read || footprint.read[cell];
    }
    if (!touched) continue;
    items_.push_back(
        {.kind = whole ? Kind::kByte : Kind::kField,
         .offset = at,
         .cell = byte.cell,
         .place = {},
         .width = whole ? uint8_t{8} : execute::CellWidth(program_, execute::CellAt(program_, cells_, byte.cell)),
         .written = written,
         .read = !written || read,
         .name = image_.NameOf(at)});
  }
  for (uint32_t i = 0; i < cells_.count; ++i) {
    if (!footprint.touched[i] || placed[i]) continue;
    const execute::Cell cell = execute::CellAt(program_, cells_, execute::CellId(i));
    if (cell.kind == execute::CellKind::kCalls) {
      if (cell.host.valid() && cell.host == program_.schedule.now) continue;
      items_.push_back({.kind = Kind::kCalls,
                        .cell = execute::CellId(i),
                        .place = {},
                        .width = 64,
                        .written = true,
                        .name = execute::CellName(program_, cell)});
      continue;
    }
    const bool local =
        cell.kind == execute::CellKind::kBit && program_.spaces[cell.space].lifetime == ir::Lifetime::kRoutine;
    opaque_ = opaque_ || (!local && footprint.written[i]);
  }
}

terms::TermId ReplacedCall::After(terms::Terms& terms, terms::TermId known, terms::TermId found,
                                  const std::string& name, uint8_t width) const {
  // One call of the code may be one of several of the program's, which have results of their own.
  const terms::Term term = terms[known];
  if (term.kind == terms::TermKind::kIte) {
    const terms::TermId one = After(terms, terms::TermId(term.b), found, name, width);
    return terms.Ite(terms::TermId(term.a), one, After(terms, terms::TermId(term.c), found, name, width));
  }
  const std::array both = {known, found};
  return terms.Apply(terms.Function(name + " after " + unit_.name, width),
                     std::span(both).first(found.valid() ? 2 : 1));
}

std::vector<terms::TermId> ReplacedCall::ArgumentsAmong(std::span<const terms::TermId> found) const {
  std::vector<terms::TermId> arguments;
  for (size_t i = 0; i < items_.size(); ++i) {
    if (items_[i].read) arguments.push_back(found[i]);
  }
  return arguments;
}

terms::TermId ReplacedCall::ResultAfter(terms::Terms& terms, terms::TermId known) const {
  constexpr const char* kName = "the result";
  const uint8_t width = meaning::WidthOf(program_.places[unit_.result].type);
  if (!result_) return After(terms, known, {}, kName, width);
  if (result_->low == 0 && std::has_single_bit(result_->count) && result_->count > 1)
    return terms.Zext(After(terms, known, {}, kName, static_cast<uint8_t>(std::countr_zero(result_->count))), width);
  const terms::TermId any = After(terms, known, {}, kName, width), low = terms.Const(result_->low, width);
  return terms.Ite(terms.Ult(terms.Sub(any, low), terms.Const(result_->count, width)), any, low);
}

std::vector<execute::CellChange> ReplacedCall::OnCells(execute::Memory& memory, terms::TermId hash, terms::TermId when,
                                                       CallLog& log) const {
  terms::Terms& terms = memory.terms();
  std::vector<terms::TermId> found;  // by item
  for (const Item& item : items_) {
    switch (item.kind) {
      case Kind::kByte:
        found.push_back(
            image_.ByteFor(terms, item.offset, [&memory](execute::CellId cell) { return memory.Read(cell); }, hash));
        break;
      case Kind::kField:
      case Kind::kCalls:
        found.push_back(memory.Read(item.cell));
        break;
      case Kind::kLayout:
        found.push_back(hash);
        break;
      case Kind::kValue:
      case Kind::kReference:
        found.push_back(memory.ReadPlace(program_.places[item.place]));
        break;
    }
  }
  const terms::TermId known = log.CalledByProgram(*this, ArgumentsAmong(found), when);
  std::vector<execute::CellChange> changes;
  const auto spread = [&](const std::vector<execute::CellId>& cells, terms::TermId value) {
    uint8_t bit = 0;  // of 32
    for (const execute::CellId cell : cells) changes.push_back({cell, terms.Extract(value, bit++, 1)});
  };
  for (size_t i = 0; i < items_.size(); ++i) {
    const Item& item = items_[i];
    if (!item.written) continue;
    const terms::TermId value = AfterIn(item, terms, known, found[i]);
    if (item.kind == Kind::kByte) {
      for (uint8_t bit = 0; bit < 8; ++bit)
        changes.push_back({execute::CellId(item.cell.index + bit), terms.Extract(value, bit, 1)});
    } else if (item.kind == Kind::kReference) {
      spread(execute::CellsOf(program_, cells_, program_.places[item.place]), value);
    } else {
      changes.push_back({item.cell, value});
    }
  }
  if (unit_.result.valid()) {
    const ir::Place& place = program_.places[unit_.result];
    spread(execute::CellsOf(program_, cells_, place), ResultAfter(terms, known));
  }
  return changes;
}

std::optional<ReplacedCall::Bound> ReplacedCall::Bind(const HostRequest& request) const {
  bool in_order = request.arguments.size() == parameters_.size();
  for (size_t i = 0; in_order && i < parameters_.size(); ++i)
    in_order = request.arguments[i].name.empty() || request.arguments[i].name == parameters_[i];
  const auto find = [&](const std::string& name) -> const HostArgument* {
    for (size_t i = 0; i < request.arguments.size(); ++i) {
      if (in_order ? parameters_[i] == name : request.arguments[i].name == name) return &request.arguments[i];
    }
    return nullptr;
  };
  const auto promoted = [&](const std::string& name) -> const HostArgument* {
    const auto at = std::ranges::find_if(
        request.arguments, [&](const HostArgument& argument) { return PromotedOffset(argument.name, name) == 0U; });
    return at == request.arguments.end() ? nullptr : &*at;
  };
  // A value of State that is passed may be another one than what stands there.
  for (const HostArgument& argument : request.arguments) {
    if (PromotedOffset(argument.name, "m")) return std::nullopt;
  }
  if (passes_ == Passes::kStateAndHost) {
    const HostArgument *state = find("m"), *host = find("host");
    const auto is_state = [this](const HostArgument& argument) {
      return argument.kind == HostArgument::Kind::kMemory && argument.slot == 0 && argument.bytes >= image_.size();
    };
    if (state != nullptr && !state->is_unused && !is_state(*state)) return std::nullopt;
    if (host != nullptr && !host->is_unused && host->kind != HostArgument::Kind::kHost) return std::nullopt;
  }
  Bound bound{.values = std::vector<terms::TermId>(items_.size()), .slots = std::vector<uint32_t>(items_.size())};
  for (size_t i = 0; i < items_.size(); ++i) {
    const Item& item = items_[i];
    if (item.kind != Kind::kValue && item.kind != Kind::kReference) continue;
    const HostArgument* argument = find(item.name);
    const bool by_value = argument == nullptr && item.kind == Kind::kReference && !item.written;
    if (by_value) argument = promoted(item.name);
    if (argument == nullptr) return std::nullopt;
    const bool value = by_value || item.kind == Kind::kValue;
    if (argument->kind != (value ? HostArgument::Kind::kValue : HostArgument::Kind::kMemory)) return std::nullopt;
    if (!value && argument->bytes < BytesFor(item.width)) return std::nullopt;
    bound.values[i] = argument->value;
    bound.slots[i] = argument->slot;
  }
  if (!AreApart(bound)) return std::nullopt;
  return bound;
}

/// It was proved with an object of its own for each reference, none of them in State.
bool ReplacedCall::AreApart(const Bound& bound) const {
  const auto is_reference = [&](size_t i) { return items_[i].kind == Kind::kReference && !bound.values[i].valid(); };
  const auto overlap = [&](size_t i, size_t j) {
    return bound.slots[i] < bound.slots[j] + BytesFor(items_[j].width) &&
           bound.slots[j] < bound.slots[i] + BytesFor(items_[i].width);
  };
  for (size_t i = 0; i < items_.size(); ++i) {
    if (!is_reference(i)) continue;
    if (bound.slots[i] < image_.size() + cells_.CallCells()) return false;
    for (size_t j = 0; j < i; ++j) {
      if (is_reference(j) && (items_[i].written || items_[j].written) && overlap(i, j)) return false;
    }
  }
  return true;
}

/// What holds a bit must be 0 or 1 there.
terms::TermId ReplacedCall::CheckedBit(terms::Terms& terms, CodeMemory& memory, terms::TermId byte) const {
  const terms::TermId bit = terms.Extract(byte, 0, 1);
  if (terms.Zext(bit, terms.Width(byte)) != byte)
    memory.Require(terms.Ne(byte, terms.Zext(bit, terms.Width(byte))), kNoBit);
  return bit;
}

terms::TermId ReplacedCall::ReadCode(terms::Terms& terms, CodeMemory& memory, const Item& item, uint32_t slot) const {
  if (item.width == 1) return CheckedBit(terms, memory, memory.Read(slot));
  return ReadBytes(terms, memory, slot, BytesFor(item.width));
}

terms::TermId ReplacedCall::OnCode(terms::Terms& terms, CodeMemory& memory, const HostRequest& request, CallLog& log,
                                   std::string& refusal) const {
  const std::optional<Bound> bound = Bind(request);
  const auto misfit = [&] {
    refusal = "a call of " + unit_.name + " with other parameters than its declaration";
    return terms::TermId();
  };
  if (!bound) return misfit();
  for (uint32_t at = 0; at < image_.size(); ++at) {
    if (image_.IsBit(at)) CheckedBit(terms, memory, memory.Read(at));
  }
  const auto counter = [this](const Item& item) { return image_.size() + item.cell.index - cells_.calls; };
  std::vector<terms::TermId> found;  // by item
  for (size_t i = 0; i < items_.size(); ++i) {
    const Item& item = items_[i];
    terms::TermId value = bound->values[i];
    if (item.kind == Kind::kCalls) {
      value = memory.Read(counter(item));
    } else if (item.kind == Kind::kReference && !value.valid()) {
      value = ReadCode(terms, memory, item, bound->slots[i]);
    } else if (item.kind != Kind::kValue && item.kind != Kind::kReference) {
      value = ReadCode(terms, memory, item, item.offset);
    } else if (item.width == 1 && terms.Width(value) > 1) {
      value = CheckedBit(terms, memory, value);
    }
    if (terms.Width(value) != item.width) return misfit();
    found.push_back(value);
  }
  const terms::TermId known = log.CalledByCode(*this, ArgumentsAmong(found), memory.When());
  if (!known.valid()) {
    refusal = "calls in another order: " + unit_.name;
    return {};
  }
  for (size_t i = 0; i < items_.size(); ++i) {
    const Item& item = items_[i];
    if (!item.written) continue;
    const terms::TermId value = AfterIn(item, terms, known, found[i]);
    if (item.kind == Kind::kCalls) {
      memory.Write(counter(item), value);
    } else {
      WriteBytes(terms, memory, item.kind == Kind::kReference ? bound->slots[i] : item.offset, value);
    }
  }
  if (request.result_width == 0) return {};
  if (!unit_.result.valid()) return misfit();
  return ResultAfter(terms, known);
}

}  // namespace plcxx::prove::verify
