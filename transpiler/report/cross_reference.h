// Who reads, writes and steps what: every place and state instance that the program uses, with its occurrences.
//
// In: the program, and what the addresses of its documentation name. Out: signals in the order of memory, instances
// after them. Not its job: warnings (checks/), wording.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/report/program_input.h"

namespace plcxx::report {

enum class Use : uint8_t { kRead, kWrite, kStep };

struct Occurrence {
  ir::StatementId statement;  // none: the control's own
  ir::RoutineId routine;
  Use use{};
};

/// Places of the same bits are one signal; an instance is a signal of its own, and so is each field that is named.
struct Signal {
  std::string name;
  std::string address;           // empty when it is the name
  std::string type;              // "bit", "i16", "on_delay_timer"
  std::string words;             // the control's own name and the meanings that are known
  ir::SpaceId space;             // of memory
  ir::StateId state;             // of an instance or a field
  uint64_t first = 0, last = 0;  // bits of the space or the instance, half open
  ir::Direction direction = ir::Direction::kInternal;
  ir::Lifetime lifetime = ir::Lifetime::kVolatile;
  std::vector<Occurrence> occurrences;  // in program order
  std::vector<uint32_t> overlaps;       // other signals with bits in common, at most kMostOverlaps
  bool documented_only = false;         // a name of the source that nothing uses
  bool read = false, written = false;   // itself, or bits of it under another name
  bool is_local() const { return lifetime == ir::Lifetime::kRoutine; }
};
inline constexpr size_t kMostOverlaps = 12;
inline constexpr uint32_t kNoSignal = 0xFFFFFFFF;

struct CrossReference {
  std::vector<Signal> signals;
  std::vector<uint32_t> of_place;  // by PlaceId, index into `signals`; kNoSignal: nothing uses it
  std::vector<uint32_t> of_state;  // by StateId
  std::vector<std::string> parts;  // by RoutineId: the partitions in which it runs, "fast, slow"
  /// By SpaceId: stretches of bits that something reads or writes, ascending, merged.
  std::vector<std::vector<std::pair<uint64_t, uint64_t>>> used;
};

CrossReference MakeCrossReference(const ProgramInput& input);

/// The statements that write the signal itself, each once.
std::vector<ir::StatementId> Writers(const Signal& signal);

}  // namespace plcxx::report
