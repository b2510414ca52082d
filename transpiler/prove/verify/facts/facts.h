// Whether the facts that decisions rest on (ir/facts.h) hold for every state and every input.
//
// In: a program in its checked flavour, legalized. Out: of each fact a proof, or a state from which a routine comes to
// it and it does not hold, or why neither was found. Functions are looked at one by one, from any state, with any
// arguments and any locals: first with their calls as anything that these may write, then with calls followed. What
// does not follow from a function alone may follow from how it is called: then all routines that the control calls are
// executed from any state, with every call followed, and the fact has to hold in each of them.
// Assumed: nothing of the state, the inputs, the answers of the host. So a state that is reported need not be one that
// is reached. Not its job: that the violation shows when it is executed (the caller's), which statement it is.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "transpiler/emit/emittable.h"
#include "transpiler/symbolic/execute/cells.h"

namespace plcxx::prove::verify::facts {

enum class FactResult : uint8_t { kProved, kViolated, kNotDecided };

/// A state from which a fact does not hold.
struct Violation {
  ir::RoutineId routine;  // that is called, with these arguments
  std::vector<uint64_t> arguments;
  uint32_t now_ms = 0;
  struct CellValue {
    execute::CellId cell;
    uint64_t value = 0;
  };
  std::vector<CellValue> state;  // of the cells that are read; others do not matter
};

struct FactProof {
  ir::InstId call;  // of false_fact
  FactResult result = FactResult::kNotDecided;
  std::string reason;   // of kNotDecided
  uint64_t value = 0;   // of kViolated: what it says it of
  Violation violation;  // of kViolated
};

struct FactLimits {
  uint32_t question_ms = 5'000;
  uint64_t routine_ms = 60'000;                           // for one function, of the processor
  std::function<void(const std::string& text)> progress;  // may be empty
};

/// Of all facts that these routines, which the control calls, may come to; in the program's order.
std::vector<FactProof> ProveFacts(const emit::Emittable& checked, std::span<const ir::RoutineId> routines,
                                  const FactLimits& limits);

}  // namespace plcxx::prove::verify::facts
