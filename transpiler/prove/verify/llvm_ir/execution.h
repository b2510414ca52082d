// What all parts of an execution of LLVM IR on terms share: the code, the memory, and the point of it that executes.
//
// A passage is an edge of the flow graph as it was taken: with the memory there and the values that the phis of its
// target receive. Where passages meet, memories and values are joined by the conditions since the nearest node that
// all of them have passed, so that what comes out has the shape of the source's branches.
#pragma once

#include <llvm/ADT/APInt.h>
#include <llvm/ADT/DenseMap.h>
#include <llvm/Analysis/LoopInfo.h>
#include <llvm/IR/ConstantRange.h>
#include <llvm/IR/DataLayout.h>
#include <llvm/IR/Dominators.h>
#include <llvm/IR/Instructions.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/IR/Module.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "transpiler/prove/verify/compiled_code.h"
#include "transpiler/prove/verify/llvm_ir/flow_graph.h"
#include "transpiler/prove/verify/llvm_ir/slots.h"
#include "transpiler/prove/verify/llvm_ir/value_range.h"

namespace plcxx::prove::verify::llvm_ir {

/// One of the places that a pointer may point to; the conditions of all exclude each other.
struct Target {
  terms::TermId when;
  uint32_t object = 0;
  terms::TermId offset;  // 64 bits, two's complement
};

inline constexpr const char* kAddressUndefined = "an address that C++ leaves undefined";

struct CodeValue {
  terms::TermId term;            // of integers and floats; these as their bits
  terms::TermId poison;          // width 1: when it is no value at all (poison.cc); none: never
  std::vector<Target> targets;   // of pointers
  std::vector<CodeValue> parts;  // of structs
};

enum class ObjectKind : uint8_t {
  kNull,
  kState,
  kHost,
  kConstant,
  kLocal,
  kGlobal,  // a variable that CodeRun::globals places
  kTable    // one of addresses there
};

struct Object {
  ObjectKind kind{};
  uint32_t first_slot = 0;      // kState, kLocal, kGlobal
  uint32_t elements = 0;        // kTable: the object that its addresses lead into
  uint64_t bytes = 0;           // but of kHost
  uint64_t align = 1;           // of its first byte; but of kHost
  std::vector<int16_t> values;  // kConstant: its bytes; -1: none that is a number
};

struct Passage {
  const llvm::BasicBlock* from = nullptr;
  const llvm::BasicBlock* to = nullptr;  // none: the function returns
  uint32_t node = 0;                     // of the level, from which it comes
  terms::TermId when;                    // since that node, or since the level's head where it leaves the level
  Slots slots;
  std::vector<CodeValue> values;  // for the phis of `to`, or the result
};

/// Blocks of a function and their nesting, found once.
struct FunctionFlow {
  llvm::DominatorTree dominators;
  llvm::LoopInfo loops;
  std::unique_ptr<FlowLevel> level;
};

class FlowCache {
 public:
  const FlowLevel* Of(const llvm::Function& function);
  /// As the source calls it: "lathe::fault" of "lathe::fault(lathe::Host&, unsigned int)".
  const std::string& NameOf(const llvm::Function& function);

 private:
  std::unordered_map<const llvm::Function*, std::unique_ptr<FunctionFlow>> flows_;  // looked up only
  std::unordered_map<const llvm::Function*, std::string> names_;                    // looked up only
};

struct Execution {
  using Values = llvm::DenseMap<const llvm::Value*, CodeValue>;

  Execution(const llvm::DataLayout& of_module, FlowCache& cache, terms::Terms& all_terms,
            CodeEnvironment& code_environment, const CodeRun& code_run);

  const llvm::DataLayout& layout;
  FlowCache& flows;
  terms::Terms& terms;
  CodeEnvironment& environment;
  const CodeRun& run;
  ValueRanges ranges;
  CodeOutcome outcome;
  uint32_t first_term;
  std::vector<Object> objects;

  // Of the function and block that executes.
  Values values;
  Slots slots;
  uint32_t next_slot;     // of its locals
  terms::TermId context;  // when it comes here at all
};

/// What a part of the execution sees. Refers to it.
class ExecutionPart {
 public:
  explicit ExecutionPart(Execution& execution)
      : now_(execution),
        layout_(execution.layout),
        terms_(execution.terms),
        environment_(execution.environment),
        run_(execution.run),
        ranges_(execution.ranges),
        outcome_(execution.outcome),
        objects_(execution.objects),
        slots_(execution.slots),
        context_(execution.context) {}

 protected:
  void Refuse(std::string reason);
  bool refused() const { return !outcome_.refusal.empty(); }
  /// What must not be, where the execution is.
  void Require(terms::TermId never, const char* text);
  terms::TermId Undefined(uint8_t width);
  uint8_t WidthOf(const llvm::Type& type) const;
  bool IsSupported(const llvm::Type& type) const;
  /// Of conditions that may be none: of one that is never so, none.
  terms::TermId Either(terms::TermId a, terms::TermId b);
  terms::TermId OrNone(terms::TermId condition);
  /// Locals that the execution makes, beyond the memory that it is given.
  bool IsOwnLocal(const Object& object) const {
    return object.kind == ObjectKind::kLocal && object.first_slot >= run_.state_bytes + run_.further_slots;
  }

  Execution& now_;
  const llvm::DataLayout& layout_;
  terms::Terms& terms_;
  CodeEnvironment& environment_;
  const CodeRun& run_;
  ValueRanges& ranges_;
  CodeOutcome& outcome_;
  std::vector<Object>& objects_;
  Slots& slots_;
  terms::TermId& context_;
};

}  // namespace plcxx::prove::verify::llvm_ir
