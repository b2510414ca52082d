// The lowering's state and its functions, split over lowering_*.cc by family. Only those files include it.
#pragma once

#include <array>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "transpiler/dialects/common/builder.h"
#include "transpiler/dialects/common/host_calls.h"
#include "transpiler/dialects/common/statement_ids.h"
#include "transpiler/dialects/nc110/lowering.h"
#include "transpiler/dialects/nc110/places.h"
#include "transpiler/ir/facts.h"

namespace plcxx::nc110 {

enum class Part : uint8_t { kFast, kSlow };

/// The scheduler's own memory, in space `system`.
enum class SystemPlace : uint8_t {
  kNow,
  kSlowCycle,
  kSlowDone,
  kFastCount,
  kSlice,
  kSlowOpen,
  kPowerWas,  // U10K0 at the end of the last period
  kSaveWas,   // U10N4
  kCount
};

enum class HostCall : uint8_t { kNow, kReadInputs, kWriteOutputs, kRetentiveLoad, kRetentiveStore, kFault, kCount };
enum class Fault : uint8_t { kParamRange, kLoopLimit };

class Lowering {
 public:
  Lowering(const Program& tree, const Settings& settings, const source::SourceManager& sources);
  ir::Program Run();

 private:
  // --- parts and items (lowering.cc) ---
  void Reserve();
  void Items();
  void Assign(const Item& item);
  /// Opens the source's next statement: everything up to the next call is its.
  ir::StatementId Begin(ItemId id);
  void CollectFileComments(ItemId next);
  source::Range TextOf(const Comment& comment) const;
  void AddComments(const Item& item);
  void EnterPart(Part part);

  // --- blocks (lowering_blocks.cc) ---
  void Head(ItemId id);
  void End(ItemId id);
  void Loop(const Block& block, ir::StatementId statement);
  /// What still waits for the next member of a chain, or is open, is over.
  void LeaveChain();
  void CloseAll();

  // --- assignments (lowering_assignments.cc) ---
  void AssignMemory(const Operand& target, ir::ValueId value);
  void AssignMux(const Operand& target, const Mux& mux);
  void StepTimer(const Assignment& assignment, ir::ValueId input);
  void StepCounter(const Assignment& assignment, ir::ValueId input);
  void StepOneShot(const Operand& target, ir::ValueId input);
  /// Both bytes of a parametric delay or modulus.
  ir::ValueId Pair(const Operand& low);
  void CallFault(Fault kind, ir::ValueId index);

  // --- expressions (lowering_expressions.cc) ---
  ir::ValueId Evaluate(ExprId id, ir::Type wanted);
  ir::ValueId EvaluateExpr(const Expr& expr);
  ir::ValueId Two(ir::OpKind bits, ir::OpKind words, const Expr& expr);
  ir::ValueId Constant(const Expr& expr);

  // --- memory (lowering_places.cc) ---
  ir::PlaceId PlaceOf(const Operand& operand);
  /// The place to read: with latched inputs the slow part has copies.
  ir::PlaceId ReadPlaceOf(const Operand& operand);
  ir::PlaceId LatchedPlaceOf(const Operand& operand);
  /// An input that the slow part sees as it was in slice 0.
  bool HasLatchedCopy(const Operand& operand) const;
  ir::Place MakePlace(const Operand& operand);
  /// A bit that has a symbol is named by it, also where the source writes its address, with I or with U.
  Operand AsNamed(const Operand& operand) const;
  ir::StateId InstanceOf(const Operand& operand);
  ir::PlaceId FlagOf(LiteralId literal);
  ir::PlaceId SystemPlaceOf(SystemPlace place);
  ir::ValueId LoadSystem(SystemPlace place) { return builder_.Load(SystemPlaceOf(place)); }
  void StoreSystem(SystemPlace place, ir::ValueId value) { builder_.Store(SystemPlaceOf(place), value); }
  void CollectSymbols();

  // --- the schedule (lowering_schedule.cc) ---
  void AddRoutines();
  void FastFrame();
  void SlowFrame();
  void Init();
  void Period();
  void FastOnly();
  void BeginPeriod();
  void AdvanceSlice();
  void StoreRetentive();
  ir::ValueId Rose(const Operand& signal, SystemPlace before);
  void MessagePlaces();
  bool sliced() const { return settings_.slices > 1 || settings_.slices_by_cost; }

  const Program& tree_;
  const Settings& settings_;
  const source::SourceManager& sources_;
  ir::Program program_;
  dialects::Builder builder_{program_};
  ir::FactChecks facts_{builder_};
  Part part_ = Part::kFast;
  ir::RegionId fast_body_, slow_body_;

  struct OpenBlock {
    BlockId block;
    ir::RegionId behind;  // where the program goes on after the whole chain
    ir::RegionId otherwise;
  };
  std::vector<OpenBlock> open_;
  OpenBlock waiting_;  // closed, its chain goes on; block none: nothing waits

  std::unordered_map<uint32_t, ir::PlaceId> places_;   // by KeyOf
  std::unordered_map<uint32_t, ir::PlaceId> latched_;  // by KeyOf
  std::vector<Operand> latch_order_;
  std::unordered_map<uint32_t, ir::StateId> instances_;  // by kind and number
  std::vector<ir::PlaceId> flags_;                       // by LiteralId
  std::array<ir::PlaceId, static_cast<size_t>(SystemPlace::kCount)> system_;
  dialects::HostCalls<HostCall> host_{builder_};
  std::unordered_map<uint32_t, SymbolId> symbols_;      // first one of exactly this operand
  std::unordered_map<uint32_t, SymbolId> bit_symbols_;  // first one of this bit, I or U

  struct Driven {
    std::vector<ir::StateId> order;
    std::unordered_set<uint32_t> known;
    void Add(ir::StateId state) {
      if (known.insert(state.index).second) order.push_back(state);
    }
  };
  std::array<Driven, 2> driven_;  // by Part: counters and one-shots that expire
  ir::RoutineId init_, fast_, slow_, period_, fast_only_;

  std::vector<source::Range> waiting_comments_;  // of the file and of '$': printed above the next statement
  size_t next_file_ = 0;
  dialects::StatementIds statement_ids_;
};

/// One number for each operand, I and U told apart.
constexpr uint32_t KeyOf(const Operand& operand) {
  return static_cast<uint32_t>(operand.kind) << 26 | static_cast<uint32_t>(operand.package) << 24 |
         static_cast<uint32_t>(operand.number) << 8 | operand.index;
}
/// I becomes U: they are one bit.
constexpr Operand AsOutput(Operand operand) {
  if (operand.kind == OperandKind::kInput) operand.kind = OperandKind::kOutput;
  return operand;
}

}  // namespace plcxx::nc110
