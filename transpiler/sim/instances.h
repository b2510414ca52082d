// The state instances of a program: the structs of runtime_support themselves, with fields that may be forced.
//
// The operations work on whole structs, so a forced field is put back after each of them. Not its job: what an
// operation does to an instance (runtime_support), or which statement did it.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "plcxx/axis_requests.h"
#include "plcxx/counters.h"
#include "plcxx/decade_counters.h"
#include "plcxx/edges.h"
#include "plcxx/one_shots.h"
#include "plcxx/position_counters.h"
#include "plcxx/texts.h"
#include "plcxx/time_word_timers.h"
#include "plcxx/timers.h"
#include "plcxx/unit_timers.h"
#include "transpiler/ir/program.h"

namespace plcxx::sim {

/// One alternative for each row of states.def, in its order.
using Instance = std::variant<std::monostate  // so that every row may begin with a comma
#define PLCXX_STATE(Kind, ...) , plcxx::Kind
#define PLCXX_FIELD(...)
#define PLCXX_HIDDEN(...)
#include "transpiler/ir/states.def"
#undef PLCXX_STATE
#undef PLCXX_FIELD
#undef PLCXX_HIDDEN
                              >;

class Instances {
 public:
  explicit Instances(const ir::Program& program);

  uint32_t size() const { return static_cast<uint32_t>(instances_.size()); }

  /// The struct itself. Whoever changes it calls Reforce afterwards.
  template <class State>
  State& Get(uint32_t instance) {
    return *std::get_if<State>(&instances_[instance]);
  }
  /// Puts the forced fields of an instance back.
  void Reforce(uint32_t instance) {
    if (!forced_[instance].empty()) WriteForced(instance);
  }

  /// Fields of one element only; the index is that of ir::Info(kind).fields.
  uint64_t Read(uint32_t instance, uint8_t field) const;
  void Write(uint32_t instance, uint8_t field, uint64_t value);
  void Force(uint32_t instance, uint8_t field, uint64_t value);
  void Release(uint32_t instance, uint8_t field);
  /// Everything 0, except forced fields.
  void Clear();
  /// Appends all fields of all instances, hidden ones included, least significant byte first.
  void AppendTo(std::vector<uint8_t>& bytes) const;
  ir::StateKind KindOf(uint32_t instance) const { return kinds_[instance]; }

 private:
  struct ForcedField {
    uint8_t field;
    uint64_t value;
  };

  void Set(uint32_t instance, uint8_t field, uint64_t value);
  void WriteForced(uint32_t instance);

  std::vector<ir::StateKind> kinds_;
  std::vector<Instance> instances_;
  std::vector<std::vector<ForcedField>> forced_;  // by instance
};

}  // namespace plcxx::sim
