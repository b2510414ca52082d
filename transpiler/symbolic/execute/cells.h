// The state of a program as one row of cells: what symbolic execution reads and writes.
//
// Memory is one cell of width 1 for each bit, so that bits, bytes and words of any byte order share it; a field of an
// instance is one cell of its own width (arrays: one for each element); of each host function the calls so far are one
// cell of 64 bits, see execute.h; and so are the calls of all together, in their order, and those of them that the
// host's answers depend on. Cells are numbered in this order. In: a program. Not its job: values.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transpiler/ir/program.h"

namespace plcxx::execute {

/// Number of a cell.
using CellId = support::Id<struct CellTag>;

enum class CellKind : uint8_t { kBit, kField, kCalls };

/// What the host may make of a call beside answering it.
enum class HostRole : uint8_t {
  kExchange,  // part of the regular exchange: neither an event, nor does another function's answer depend on it
  kReport,    // a run-time fault: an event, but what the host answers later does not depend on it
  kAction,  // an event that may change all later answers: what is written through one function is read through another
};

/// Of calls of several functions together.
enum class CallChain : uint8_t {
  kEvents,   // all but the regular exchange
  kActions,  // that the answers of each of them depend on
};

struct Cell {
  CellKind kind{};
  ir::SpaceId space;        // of kBit
  uint32_t offset = 0;      // byte
  uint8_t bit = 0;          // 0 is the least significant
  ir::StateId state;        // of kField
  uint8_t field = 0;        // index of ir::Info(kind).fields
  uint8_t element = 0;      // of an array
  ir::HostFunctionId host;  // of kCalls; none: of those of a chain
  CallChain chain{};        // of kCalls without a host function
};

/// Calls of the regular exchange (ir::Call::exchange).
enum class ExchangeCalls : uint8_t {
  kAsOthers,  // in the order of all calls: C++ does not tell one from the other
  kApart      // no events
};

struct Cells {
  static constexpr uint32_t kChains = 2;

  std::vector<uint32_t> spaces;  // by SpaceId: cell of bit 0 of byte 0
  /// By SpaceId: bytes that have cells; of locals only those that the program names, a front end may reserve far more.
  std::vector<uint32_t> bytes;
  std::vector<uint32_t> states;  // by StateId: first cell
  uint32_t calls = 0;            // cell of host function 0
  uint32_t count = 0;
  std::vector<HostRole> roles;  // by HostFunctionId
  ExchangeCalls exchange_calls = ExchangeCalls::kAsOthers;

  CellId OfBit(ir::SpaceId space, uint32_t offset, uint8_t bit) const {
    return CellId(spaces[space.index] + 8 * offset + bit);
  }
  CellId OfCalls(ir::HostFunctionId host) const { return CellId(calls + host.index); }
  /// The calls of all functions but those of the regular exchange, in their order.
  CellId OfOrder() const { return CellId(count - kChains); }
  /// Of these, what the host's answers depend on.
  CellId OfActions() const { return CellId(count - 1); }
  /// What a call of the function goes on: its own calls, and those of the chains that it is in. What it answers, and
  /// what the host writes at it, depends on the last one.
  /// `exchange`: the call is part of the regular exchange.
  std::vector<CellId> ChainsOf(ir::HostFunctionId host, bool exchange) const;
  /// Cells of calls.
  uint32_t CallCells() const { return count - calls; }
};

Cells MakeCells(const ir::Program& program, ExchangeCalls exchange_calls = ExchangeCalls::kAsOthers);
Cell CellAt(const ir::Program& program, const Cells& cells, CellId id);
/// Bits of the cell's value.
uint8_t CellWidth(const ir::Program& program, const Cell& cell);
/// The same for the same cell of two versions of a program: "U.10.3", "T5.elapsed_ms", "calls of fault".
std::string CellName(const ir::Program& program, const Cell& cell);

/// Of a place that is not indexed and lies in memory: its cells from the least significant bit, whatever the space's
/// byte order.
std::vector<CellId> CellsOf(const ir::Program& program, const Cells& cells, const ir::Place& place);
/// Of an indexed place: the least index whose element does not begin below the low bound.
int64_t LeastIndex(const ir::Place& place);
/// All cells that an access to a place may touch, ascending: of an indexed one those of every element that lies wholly
/// inside its bounds, and not what is between elements.
std::vector<CellId> TouchedCells(const ir::Program& program, const Cells& cells, const ir::Place& place);
/// The cells of an instance.
std::vector<CellId> CellsOfInstance(const ir::Program& program, const Cells& cells, ir::StateId state);
/// Whether a place is a field, or is not indexed and lies wholly in its space.
bool IsInside(const ir::Program& program, const ir::Place& place);

}  // namespace plcxx::execute
