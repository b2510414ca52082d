// Executes functions of LLVM IR on terms: the inner part of the module.
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

class Executor {
 public:
  Executor(const llvm::Module& module, FlowCache& flows, terms::Terms& terms, CodeEnvironment& environment,
           const CodeRun& run);

  CodeOutcome Run(const llvm::Function& function);

 private:
  using Values = llvm::DenseMap<const llvm::Value*, CodeValue>;
  friend class HostMemory;

  // The function that is asked for (entry.cc).
  bool Bind(const llvm::Function& function, std::vector<CodeValue>& values);
  bool BindOne(const llvm::Argument& parameter, const CodeArgument& argument, CodeValue& value);
  bool BindByName(const llvm::Argument& parameter, CodeValue& value);

  // Flow (execute_flow.cc).
  CodeValue Call(const llvm::Function& function, std::vector<CodeValue> arguments);
  void RunLevel(const FlowLevel& level, Passage entry, terms::TermId context, std::vector<Passage>& leaving);
  void RunBlock(const llvm::BasicBlock& block, Passage entry, std::vector<Passage>& leaving);
  void Leave(const llvm::BasicBlock& from, const llvm::BasicBlock* to, terms::TermId when,
             std::vector<Passage>& leaving);
  void LeaveBySwitch(const llvm::SwitchInst& choice, std::vector<Passage>& leaving);
  /// One passage for several; `conditions` of them are since one node, and one of them holds.
  Passage Join(std::vector<Passage> passages, const std::vector<terms::TermId>& conditions);
  CodeValue Choose(terms::TermId condition, const CodeValue& then, const CodeValue& otherwise);

  // Loops (execute_loops.cc).
  /// One that is not unrolled: what is at its heads.
  struct LoopState {
    std::vector<CodeLoop::Item> items;
    std::vector<const llvm::PHINode*> phis;  // of the items in front
    std::vector<uint32_t> objects;           // of phis that are pointers, else 0
    std::vector<std::pair<terms::TermId, Passage>> heads;
  };
  void RunLoop(const FlowLevel& level, Passage entry, terms::TermId context, std::vector<Passage>& leaving);
  /// Whether it is whole: nothing was left out.
  void UnrollLoop(const FlowLevel& level, Passage entry, terms::TermId context, std::vector<Passage>& leaving,
                  LoopState* state);
  void RunByHead(const FlowLevel& level, const Passage& entry, terms::TermId context, LoopState& state,
                 std::vector<Passage>& leaving);
  /// Those that go back to the head as one, the others to `leaving`; none goes back: no passage.
  std::optional<Passage> JoinRepeats(const llvm::BasicBlock* head, std::vector<Passage> passages, terms::TermId active,
                                     std::vector<Passage>& leaving);
  bool FindItems(const llvm::BasicBlock& head, LoopState& state);
  void AddSlots(const Slots& a, const Slots& b, LoopState& state);
  /// At a loop's head there is nothing but values: what is poison must not come there.
  void RequireAtHead(const LoopState& state, const Passage& passage, terms::TermId when);
  std::vector<terms::TermId> ItemsOf(const Passage& passage, const LoopState& state);

  // Values (values.cc).
  CodeValue ValueOf(const llvm::Value* value);
  CodeValue ConstantOf(const llvm::Constant& constant);
  CodeValue AnyOf(const llvm::Type& type);
  terms::TermId TermOf(const llvm::Value* value) { return ValueOf(value).term; }
  terms::TermId Undefined(uint8_t width);
  CodeValue PointerTo(uint32_t object, uint64_t offset = 0);
  uint32_t ObjectOf(const llvm::GlobalVariable& global);
  uint32_t PlacedObject(const CodeGlobal& global);
  uint8_t WidthOf(const llvm::Type& type) const;
  bool IsSupported(const llvm::Type& type) const;

  // Instructions (execute_instructions.cc, execute_intrinsics.cc).
  void ExecuteInst(const llvm::Instruction& inst);
  bool Check(const llvm::Instruction& inst);
  CodeValue Evaluate(const llvm::Instruction& inst);
  CodeValue Compute(const llvm::Instruction& inst);
  CodeValue Freeze(const llvm::FreezeInst& inst);
  void ExecuteStore(const llvm::StoreInst& store);
  CodeValue ExecuteLoad(const llvm::LoadInst& load);
  CodeValue LoadAddress(const CodeValue& pointer);
  void ExecuteAssume(const llvm::AssumeInst& assumption);
  terms::TermId EvaluateBinaryOperator(const llvm::BinaryOperator& inst);
  terms::TermId Divide(const llvm::BinaryOperator& inst, terms::TermId a, terms::TermId b);
  terms::TermId Compare(const llvm::ICmpInst& inst);
  terms::TermId ComparePointers(const llvm::ICmpInst& inst);
  terms::TermId CompareFloats(const llvm::FCmpInst& inst);
  terms::TermId Convert(const llvm::CastInst& inst);
  CodeValue ElementPointer(const llvm::GetElementPtrInst& inst);
  CodeValue ExecuteCall(const llvm::CallInst& call);
  CodeValue ExecuteHostCall(const llvm::CallInst& call, const llvm::Function& callee, const std::string& name);
  CodeValue ExecuteIntrinsic(const llvm::IntrinsicInst& call);
  terms::TermId IntegerIntrinsic(const llvm::IntrinsicInst& call);
  terms::TermId CountBits(const llvm::IntrinsicInst& call, terms::TermId a);
  terms::TermId FloatIntrinsic(const llvm::IntrinsicInst& call);
  CodeValue WithOverflow(const llvm::WithOverflowInst& call);
  terms::TermId Saturated(const llvm::SaturatingInst& call);
  void ExecuteMemoryTransfer(const llvm::MemIntrinsic& call);
  void Require(terms::TermId never, const char* text);

  // What must not be used (poison.cc).
  /// Of conditions that may be none: of one that is never so, none.
  terms::TermId Either(terms::TermId a, terms::TermId b);
  terms::TermId OrNone(terms::TermId condition);
  terms::TermId SignOf(terms::TermId a);
  terms::TermId PoisonOfOperands(const llvm::User& inst);
  terms::TermId PoisonOfBinary(const llvm::BinaryOperator& inst, terms::TermId result);
  terms::TermId PoisonOfConversion(const llvm::CastInst& inst, terms::TermId result);
  terms::TermId PoisonOfIntrinsic(const llvm::IntrinsicInst& call);
  terms::TermId PoisonOfRange(const llvm::Instruction& inst, terms::TermId value);
  terms::TermId PoisonOfIndex(const llvm::GetElementPtrInst& inst, terms::TermId index, uint64_t scale);
  terms::TermId PoisonOfPointer(const llvm::GetElementPtrInst& inst, const CodeValue& base, const CodeValue& pointer);
  terms::TermId SumOverflows(terms::TermId a, terms::TermId b, terms::TermId sum, bool has_sign);
  terms::TermId DifferenceOverflows(terms::TermId a, terms::TermId b, terms::TermId difference, bool has_sign);
  terms::TermId ProductOverflows(terms::TermId a, terms::TermId b, bool has_sign);
  terms::TermId IsBeyondInteger(terms::TermId number, uint8_t width, bool has_sign);
  terms::TermId IsOutOf(const llvm::ConstantRange& range, terms::TermId value);
  void RequireValue(const CodeValue& value, const char* text);
  void RequireAligned(const std::vector<Target>& targets, uint64_t align);
  void RequireArgument(const llvm::CallInst& call, const llvm::Argument& parameter, const CodeValue& value);

  // Memory (execute_memory.cc).
  terms::TermId ReadSlot(uint32_t slot) { return ReadSlot(slots_, slot); }
  terms::TermId ReadSlot(const Slots& slots, uint32_t slot);
  terms::TermId Load(const std::vector<Target>& targets, uint64_t at, uint32_t bytes);
  terms::TermId LoadFrom(terms::TermId when, uint32_t object, terms::TermId offset, uint32_t bytes);
  terms::TermId LoadAt(const Object& object, uint64_t offset, uint32_t bytes);
  void Store(const std::vector<Target>& targets, uint64_t at, terms::TermId value);
  void StoreTo(terms::TermId when, uint32_t object, terms::TermId offset, terms::TermId value);
  void StoreAt(terms::TermId when, const Object& object, uint64_t offset, terms::TermId value);
  /// The offsets in an object at which an access of `bytes` bytes can be.
  struct Reach {
    uint64_t low = 0, high = 0, step = 1;
    bool none = false, beyond = false;  // beyond: it may be elsewhere, too
  };
  Reach ReachOf(const Object& object, terms::TermId offset, uint32_t bytes);
  terms::TermId IsBeyond(const Reach& reach, terms::TermId offset);
  uint32_t NewLocal(uint64_t bytes, uint64_t align);
  /// A local whose life begins or ends has no value.
  void ForgetLocals(const std::vector<Target>& targets);
  /// memcpy leaves open what it does with two places that overlap, unless they are one.
  void RequireApart(const std::vector<Target>& to, const std::vector<Target>& from, uint64_t bytes);

  // Pointers as numbers (addresses.cc).
  terms::TermId AddressOf(uint32_t object, uint8_t width);
  terms::TermId NumberOf(const CodeValue& pointer, uint8_t width);
  std::vector<Target> TargetsOf(terms::TermId number);
  CodeValue PointerAt(terms::TermId number);
  /// Of locals that the number leads into, all bytes below it.
  void ForgetBelow(terms::TermId number);

  void Refuse(std::string reason);
  bool refused() const { return !outcome_.refusal.empty(); }

  const llvm::Module& module_;
  const llvm::DataLayout& layout_;
  FlowCache& flows_;
  terms::Terms& terms_;
  CodeEnvironment& environment_;
  const CodeRun& run_;
  ValueRanges ranges_;
  CodeOutcome outcome_;
  uint32_t first_term_;

  std::vector<Object> objects_;
  std::unordered_map<const llvm::GlobalVariable*, uint32_t> globals_;  // looked up only
  std::unordered_map<uint32_t, terms::TermId> addresses_;              // by object; looked up only
  std::unordered_map<uint32_t, uint32_t> object_at_;                   // by term of an address; looked up only
  std::unordered_map<uint32_t, std::vector<Target>> targets_;          // by term; looked up only
  std::vector<terms::TermId> initial_;                                 // by slot
  uint32_t next_slot_;
  uint32_t depth_ = 0;

  // Of the function and block that executes.
  Values values_;
  Slots slots_;
  terms::TermId context_;  // when it comes here at all
  uint32_t sampling_ = 0;  // loops around this point whose first rounds are looked at
};

/// Of a constant as it lies in memory.
std::vector<int16_t> BytesOf(const llvm::Constant& constant, const llvm::DataLayout& layout);

}  // namespace plcxx::prove::verify::llvm_ir
