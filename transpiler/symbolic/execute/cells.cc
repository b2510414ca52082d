#include "transpiler/symbolic/execute/cells.h"

#include <algorithm>

#include "transpiler/ir/host_functions.h"
#include "transpiler/symbolic/meaning/meaning.h"

namespace plcxx::execute {
namespace {

/// By SpaceId: the bytes that places of the program reach.
std::vector<uint32_t> ReachedBytes(const ir::Program& program) {
  std::vector<uint32_t> reached(program.spaces.size());
  for (const ir::Place& place : program.places) {
    if (place.is_field() || !place.space.valid()) continue;
    const uint32_t end = place.indexed ? place.high : place.offset + ir::Bytes(place.type);
    uint32_t& bytes = reached[place.space.index];
    bytes = std::max(bytes, std::min(end, program.spaces[place.space].bytes));
  }
  return reached;
}

HostRole RoleOf(const ir::HostFunction& host) {
  if (host.routine_exchange) return HostRole::kExchange;
  return ir::ReportsFault(host) ? HostRole::kReport : HostRole::kAction;
}

}  // namespace

std::vector<CellId> Cells::ChainsOf(ir::HostFunctionId host, bool exchange) const {
  if (exchange && exchange_calls == ExchangeCalls::kApart) return {OfCalls(host)};
  switch (roles[host.index]) {
    case HostRole::kExchange:
      return {OfCalls(host)};
    case HostRole::kReport:
      return {OfCalls(host), OfOrder()};
    case HostRole::kAction:
      return {OfCalls(host), OfOrder(), OfActions()};
  }
  PLCXX_UNREACHABLE();
}

Cells MakeCells(const ir::Program& program, ExchangeCalls exchange_calls) {
  Cells cells;
  cells.exchange_calls = exchange_calls;
  const std::vector<uint32_t> reached = ReachedBytes(program);
  for (uint32_t i = 0; i < program.spaces.size(); ++i) {
    const ir::Space& space = program.spaces[ir::SpaceId(i)];
    cells.spaces.push_back(cells.count);
    cells.bytes.push_back(space.lifetime == ir::Lifetime::kRoutine ? reached[i] : space.bytes);
    cells.count += 8 * cells.bytes.back();
  }
  for (const ir::StateInstance& state : program.states) {
    cells.states.push_back(cells.count);
    cells.count += meaning::FieldTerms(state.kind);
  }
  cells.calls = cells.count;
  cells.count += program.host_functions.size() + Cells::kChains;
  for (const ir::HostFunction& host : program.host_functions) cells.roles.push_back(RoleOf(host));
  return cells;
}

Cell CellAt(const ir::Program& program, const Cells& cells, CellId id) {
  PLCXX_CHECK(id.index < cells.count);
  if (id.index >= cells.calls) {
    if (id == cells.OfOrder()) return {.kind = CellKind::kCalls, .chain = CallChain::kEvents};
    if (id == cells.OfActions()) return {.kind = CellKind::kCalls, .chain = CallChain::kActions};
    return {.kind = CellKind::kCalls, .host = ir::HostFunctionId(id.index - cells.calls)};
  }
  // The last owner that begins at or before the cell; owners without cells share their begin with the next one.
  const auto owner_of = [id](const std::vector<uint32_t>& begins) {
    return static_cast<uint32_t>(std::ranges::upper_bound(begins, id.index) - begins.begin() - 1);
  };
  if (!cells.states.empty() && id.index >= cells.states.front()) {
    const uint32_t state = owner_of(cells.states);
    uint32_t rest = id.index - cells.states[state];
    Cell cell{.kind = CellKind::kField, .state = ir::StateId(state)};
    for (const ir::FieldInfo& field : ir::Info(program.states[cell.state].kind).fields) {
      if (rest < field.count) break;
      rest -= field.count;
      ++cell.field;
    }
    cell.element = static_cast<uint8_t>(rest);
    return cell;
  }
  const uint32_t space = owner_of(cells.spaces);
  const uint32_t rest = id.index - cells.spaces[space];
  return {
      .kind = CellKind::kBit, .space = ir::SpaceId(space), .offset = rest / 8, .bit = static_cast<uint8_t>(rest % 8)};
}

uint8_t CellWidth(const ir::Program& program, const Cell& cell) {
  switch (cell.kind) {
    case CellKind::kBit:
      return 1;
    case CellKind::kField:
      return meaning::WidthOf(ir::Info(program.states[cell.state].kind).fields[cell.field].type);
    case CellKind::kCalls:
      return 64;
  }
  PLCXX_UNREACHABLE();
}

std::string CellName(const ir::Program& program, const Cell& cell) {
  switch (cell.kind) {
    case CellKind::kBit:
      return program.spaces[cell.space].name + "." + std::to_string(cell.offset) + "." + std::to_string(cell.bit);
    case CellKind::kField: {
      const ir::StateInstance& state = program.states[cell.state];
      const ir::FieldInfo& field = ir::Info(state.kind).fields[cell.field];
      std::string name = state.name + "." + std::string(field.name);
      if (field.count > 1) name += "[" + std::to_string(cell.element) + "]";
      return name;
    }
    case CellKind::kCalls:
      if (cell.host.valid()) return "calls of " + program.host_functions[cell.host].name;
      return cell.chain == CallChain::kEvents ? "order of calls" : "order of calls but faults";
  }
  PLCXX_UNREACHABLE();
}

std::vector<CellId> CellsOf(const ir::Program& program, const Cells& cells, const ir::Place& place) {
  if (place.is_field()) {
    const uint32_t field = meaning::FieldTermIndex(program.states[place.state].kind, place.field);
    return {CellId(cells.states[place.state.index] + field)};
  }
  if (place.type == ir::Type::kBit) return {cells.OfBit(place.space, place.offset, place.bit)};
  std::vector<CellId> bits;
  const uint32_t bytes = ir::Bytes(place.type);
  for (uint32_t i = 0; i < bytes; ++i) {
    const bool is_big = program.spaces[place.space].order == ir::ByteOrder::kBig;
    const uint32_t at = place.offset + (is_big ? bytes - 1 - i : i);
    for (uint8_t bit = 0; bit < 8; ++bit) bits.push_back(cells.OfBit(place.space, at, bit));
  }
  return bits;
}

int64_t LeastIndex(const ir::Place& place) {
  const int64_t stride = place.stride, below = int64_t{place.low} - place.offset;
  return below >= 0 ? (below + stride - 1) / stride : -(-below / stride);  // division rounds toward zero
}

std::vector<CellId> TouchedCells(const ir::Program& program, const Cells& cells, const ir::Place& place) {
  if (place.is_field()) return CellsOf(program, cells, place);
  std::vector<CellId> touched;
  const int64_t bytes = ir::Bytes(place.type), space_end = cells.bytes[place.space.index];
  int64_t next = 0;  // elements may overlap
  const auto touch = [&](int64_t begin) {
    for (next = std::max(next, begin); next < std::min(begin + bytes, space_end); ++next) {
      for (uint8_t bit = 0; bit < 8; ++bit) {
        if (place.type == ir::Type::kBit && bit != place.bit) continue;
        touched.push_back(cells.OfBit(place.space, static_cast<uint32_t>(next), bit));
      }
    }
  };
  if (!place.indexed) {
    touch(place.offset);
    return touched;
  }
  if (place.stride == 0) return touched;
  const int64_t high = std::min<int64_t>(place.high, program.spaces[place.space].bytes);
  for (int64_t at = place.offset + LeastIndex(place) * place.stride; at + bytes <= high; at += place.stride) touch(at);
  return touched;
}

std::vector<CellId> CellsOfInstance(const ir::Program& program, const Cells& cells, ir::StateId state) {
  std::vector<CellId> fields;
  for (uint32_t i = 0; i < meaning::FieldTerms(program.states[state].kind); ++i) {
    fields.emplace_back(cells.states[state.index] + i);
  }
  return fields;
}

bool IsInside(const ir::Program& program, const ir::Place& place) {
  if (place.is_field()) return true;
  return place.space.valid() && !place.indexed &&
         uint64_t{place.offset} + ir::Bytes(place.type) <= program.spaces[place.space].bytes;
}

}  // namespace plcxx::execute
