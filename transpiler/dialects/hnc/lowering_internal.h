// The lowering's state and its functions, split over lowering_*.cc by family. Only those files include it.
//
// Every C function is a routine with the same name, parameters and locals. Scalar locals are places of a space of the
// routine's own, so that generated code has them as locals; arrays, structures and what has its address taken lie in
// memory, which recursion, being refused, permits. A pointer is an offset in bytes, and beside it the number of its
// object where it may refer to several (mapping.md).
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "transpiler/dialects/common/builder.h"
#include "transpiler/dialects/common/statement_ids.h"
#include "transpiler/dialects/hnc/facts.h"
#include "transpiler/dialects/hnc/live_jumps.h"
#include "transpiler/dialects/hnc/loop_counts.h"
#include "transpiler/dialects/hnc/lowering.h"
#include "transpiler/dialects/hnc/options.h"
#include "transpiler/dialects/hnc/ranges.h"
#include "transpiler/dialects/hnc/registrations.h"
#include "transpiler/dialects/hnc/walk.h"
#include "transpiler/ir/facts.h"
#include "transpiler/ir/reference.h"

namespace plcxx::hnc {

/// A number that has been computed. `is_bit`: the IR's value is a bit that stands for the int 0 or 1.
struct Value {
  ir::ValueId id;
  TypeId type;
  bool is_bit = false;
  Bounds bounds;  // of integers
};

/// A place or the value of a pointer: bytes base + index * stride of one of the targets.
struct Address {
  ObjectSet targets;
  ir::ValueId object;  // i16, the number of the target; none where there is one target
  int64_t base = 0;
  ir::ValueId index;  // i32 with sign; none: constant
  uint32_t stride = 1;
  Bounds index_bounds;
  bool is_null = false;   // the constant 0
  bool reported = false;  // that there is none has been told
};

/// What an lvalue expression names: a local of the routine, or memory.
struct Lvalue {
  VariableId local;  // a scalar that is a named local
  Address address;
  TypeId type;
  const Member* bit_field = nullptr;
  ExprId expr;  // for messages
};

/// Where the offset of a pointer variable and the number of its object are; `object` none: it has one target.
struct PointerPlaces {
  ir::PlaceId offset, object;
};

constexpr bool IsLoop(StatementKind kind) {
  return kind == StatementKind::kWhile || kind == StatementKind::kDo || kind == StatementKind::kFor;
}

constexpr bool IsCase(StatementKind kind) { return kind == StatementKind::kCase || kind == StatementKind::kDefault; }

inline constexpr uint32_t kNullOffset = 0x80000000;
inline constexpr Bounds kAnyOffset{-0x80000000LL, 0x7FFFFFFF};  // of a pointer, null among them
inline constexpr uint32_t kMostTargets = 16;

/// Names of run-time faults in the order of 6.9, from 1.
enum class Fault : uint8_t { kDivision = 1, kIndex = 2, kLoop = 3 };

/// Of the host function that a system function is with --set sysfunc=host (8.2); empty: it is none.
std::string_view HostNameOf(SystemFunction function);

/// What is known of a loop that ends (6.6).
struct LoopProof {
  LoopCount count;
  Cell counter;
  bool knows_values = false;  // `count` has the counter's values; else its condition changes it
  /// Its limit is in memory, and what has been stored there may be forced: the values are right as long as the
  /// iterations are counted.
  bool rests_on_memory = false;
};

/// How far a proof came: of several candidates the one that came furthest says why there is none.
enum class ProofStep : uint8_t { kNothing, kCounter, kChange, kLimit, kRange };

/// Which functions are lowered: what no part reaches is checked, but no part of the program (4.1).
enum class Scope : uint8_t { kAll, kReached };

class Lowering {
 public:
  Lowering(Scope scope, const Unit& unit, const Settings& settings, const source::SourceManager& sources,
           diag::Engine& diagnostics);
  ir::Program Run();
  /// Of the program that Run has given.
  ir::Reference Describe(const ir::Program& program) const;

 private:
  // --- for plcxx verify (lowering_reference.cc) ---
  void DescribeAreas(const ir::Program& program, ir::Reference& reference) const;
  void DescribeVariables(ir::Reference& reference) const;
  void DescribeFunction(FunctionId id, ir::Reference& reference) const;
  void DescribeCallees(const ir::Program& program, ir::Reference& reference) const;
  void DescribeEffects(const ir::Program& program, ir::Reference& reference) const;
  ir::ReferenceBytes BytesOf(ObjectId object) const;
  /// What its head has that has no equal in the reference; empty: nothing.
  std::string WhyInCallers(const Function& function) const;

  // --- functions (lowering.cc) ---
  void AddRoutines();
  void LowerFunction(FunctionId id);
  void BeginLocals(const Function& function);
  std::vector<FunctionId> CalleesFirst() const;
  std::string CommentAbove(const Function& function) const;
  /// Whether the routine of the function is made.
  bool IsIncluded(FunctionId id) const { return scope_ == Scope::kAll || facts_.PartsOf(id) != 0; }

  // --- memory (lowering_memory.cc) ---
  void AddSpaces();
  void AddVariables();
  void InitialBytes(const Variable& variable, uint32_t begin);
  void InitialBytesOf(const InitialValue& initial, uint32_t begin);
  void PutBytes(ir::SpaceId space, uint32_t offset, uint64_t value, uint32_t bytes);
  void AddPointerPlaces(VariableId id);
  uint16_t NumberOf(ObjectId object) const { return static_cast<uint16_t>(object.index + 1); }
  ir::PlaceId AddLocal(std::string name, ir::Type type);
  ir::PlaceId AddScalar(std::string name, ir::Type type, uint64_t initial = 0);
  /// A scalar at a constant offset of an object, named by what the source calls it.
  ir::PlaceId PlaceAt(ObjectId object, uint32_t offset, ir::Type type);
  ir::PlaceId IndexedPlaceAt(ObjectId object, uint32_t offset, uint32_t stride, ir::Type type);
  std::string NameOfCell(ObjectId object, uint32_t offset, ir::Type type) const;
  void CollectCellNames();
  ir::ValueId LoadWord(Area area, uint32_t word, ir::Type type = ir::Type::kI16);
  void StoreWord(Area area, uint32_t word, ir::ValueId value, ir::Type type = ir::Type::kI16);

  // --- values (lowering_values.cc) ---
  const Type& TypeAt(TypeId id) const { return types_[id]; }
  TypeId IntegerType(uint8_t bits, bool is_signed);
  const Expr& ExprAt(ExprId id) const { return unit_.expressions[id]; }
  ir::Type IrType(TypeId id) const;
  Value Number(int64_t value, TypeId type, uint32_t base = 10);
  Value Zero(TypeId type);
  Value Make(ir::ValueId id, TypeId type);
  Value Convert(const Value& value, TypeId to);
  Value ConvertInteger(const Value& value, TypeId to);
  ir::ValueId Narrow8(ir::ValueId value);
  ir::ValueId Narrow16(ir::ValueId value);
  ir::ValueId AsBit(const Value& value);
  Value FromBit(ir::ValueId bit);
  ir::ValueId AsIndex(const Value& value);  // i32 with sign
  std::optional<int64_t> KnownInteger(const Value& value) const;
  ir::ValueId Word(uint32_t value) { return builder_.Constant(ir::Type::kI16, value & 0xFFFF); }
  ir::ValueId Long(uint32_t value) { return builder_.Constant(ir::Type::kI32, value); }
  ir::ValueId Pure(ir::OpKind op, std::initializer_list<ir::ValueId> operands) { return builder_.Pure(op, operands); }

  // --- operators (lowering_operators.cc) ---
  Value Binary(BinaryOp op, const Value& a, const Value& b, const Expr& at);
  Value BinaryInteger(BinaryOp op, const Value& a, const Value& b, const Expr& at);
  Value AsMask(const Value& value);
  Value BinaryReal(BinaryOp op, const Value& a, const Value& b);
  Value Compare(BinaryOp op, const Value& a, const Value& b);
  Value Divide(BinaryOp op, const Value& a, const Value& b, const Expr& at);
  Value Shift(BinaryOp op, const Value& a, const Value& b, const Expr& at);
  Value Unary(UnaryOp op, const Value& a);
  Value SelectValue(ir::ValueId condition, const Value& a, const Value& b, TypeId type);

  // --- expressions (lowering_expressions.cc) ---
  Value Evaluate(ExprId id);
  Value EvaluateLeaf(ExprId id);
  /// For its effects only.
  void Execute(ExprId id);
  ir::ValueId Condition(ExprId id);
  ir::ValueId Logical(ExprId id);
  Value Conditional(const Expr& expr);
  Value Assign(ExprId id);
  Value CompoundAssign(ExprId id);
  void StoreBack(const Lvalue& target, const Value& value);
  Value Increment(ExprId id);
  /// Whether evaluating it does nothing but compute, and cannot fault.
  bool IsSimple(ExprId id) const;
  /// Whether evaluating it may change what another operand reads.
  bool HasEffects(ExprId id) const;

  // --- structures as values (lowering_records.cc) ---
  void AssignRecord(const Address& to, const Address& from, TypeId type);
  /// The value as it is now; what is executed before it is stored does not change it.
  std::vector<ir::ValueId> LoadRecord(const Address& from, TypeId type);
  void StoreRecord(const Address& to, const std::vector<ir::ValueId>& pieces, TypeId type);
  /// The address of a record value.
  Address RecordAddress(ExprId id);
  Address ConditionalAddress(const Expr& expr, Address (Lowering::*evaluate)(ExprId));
  Address SelectAddress(ir::ValueId condition, const Address& a, const Address& b);
  void StoreNoResult();

  // --- addresses (lowering_addresses.cc) ---
  Lvalue EvaluateLvalue(ExprId id);
  Address EvaluatePointer(ExprId id);
  Address TableElement(const Expr& load);
  void AddIndex(Address& address, const Value& index, uint32_t size, int64_t sign);
  Address PointerIn(VariableId id);
  void StorePointer(VariableId id, const Address& value);
  ir::ValueId OffsetOf(const Address& address);
  ir::ValueId ObjectOf(const Address& address);
  /// Null is the least offset.
  static bool MayBeNull(const Address& address);
  Value ComparePointers(const Expr& expr);
  ir::ValueId IsNotNull(const Address& address, ExprId id);
  Value PointerDifference(const Expr& expr);
  bool CheckTargets(const Address& address, ExprId at);
  bool HasPoisonedSource(VariableId variable) const;

  // --- accesses (lowering_accesses.cc) ---
  Value Load(const Lvalue& lvalue);
  void CheckAssigned(VariableId id, ExprId at);
  void Store(const Lvalue& lvalue, const Value& value);
  ir::ValueId LoadAt(const Address& address, ir::Type type, ExprId at);
  void StoreAt(const Address& address, ir::Type type, ir::ValueId value, ExprId at);
  /// A place of an object, and the index for it; none: outside, which has been reported.
  struct Access {
    ir::PlaceId place;
    ir::ValueId index;
  };
  std::optional<Access> AccessTo(ObjectId object, const Address& address, ir::Type type, ExprId at);
  Value LoadBitField(const Lvalue& lvalue);
  /// What a bit-field gives back of a value that was stored into it: its width's digits, with its sign.
  Value InBitField(const Value& digits, const Lvalue& lvalue);
  void StoreBitField(const Lvalue& lvalue, const Value& value);
  std::optional<Cell> CellOf(const Lvalue& lvalue) const;
  void NoteStore(const Lvalue& lvalue, const Value& value);
  void ReportIndex(ObjectId object, int64_t offset, uint32_t bytes, ExprId at);
  /// A choice among the objects that an address may be in.
  void ForEachTargetOf(const Address& address, const std::function<void(ObjectId)>& body);

  // --- facts that are executed (lowering_facts.cc) ---
  void Check(ir::FactKind kind, ir::ValueId fact, ir::ValueId value);
  void CheckBounds(ir::FactKind kind, const Value& value);

  // --- faults and host (lowering_faults.cc) ---
  void AddFaultRoutine();
  void CallCritical(const std::string& name);
  ir::PlaceId CriticalFlag();
  void EndCritical();
  void RecordFault(Fault fault);
  void FaultWhen(ir::ValueId condition, Fault fault);
  ir::HostFunctionId Host(std::string name, std::vector<ir::Parameter> parameters, ir::Type result, std::string comment,
                          ir::HostAccess access = ir::HostAccess::kNone);

  // --- statements (lowering_statements.cc) ---
  void Lower(StatementId id, bool last);
  void LowerReached(StatementId id, const Statement& statement, bool last);
  void LowerBody(const std::vector<StatementId>& body, bool last);
  void Compound(const Statement& statement, bool last);
  void Declaration(const Statement& statement);
  void Initialise(VariableId id);
  /// Zeros for all bytes of an object in memory.
  void ClearObject(ObjectId object);
  void If(StatementId id, const Statement& statement, bool last);
  void FlatIf(const Statement& statement);
  void Return(const Statement& statement, bool last);
  void LeaveFunction();
  void Mark(StatementId id, source::Range range, bool opens_block);
  void MarkText(source::Range range, const std::string& subject, bool opens_block);
  void TakeComments(source::Offset until, std::vector<source::Range>& to);
  void CommentsAtEnd(source::Range close);
  std::string SubjectOf(const Statement& statement) const;
  bool IsEntered(StatementId id) const { return id.valid() && entered_.contains(id.index); }
  uint32_t NewLabel() { return next_label_++; }
  void JumpTo(uint32_t label);
  void PlaceLabel(uint32_t label);
  void Refine(ExprId condition, bool holds);
  void RefineComparison(const Expr& expr, bool holds);
  std::optional<Cell> CellOfRead(ExprId id) const;

  // --- switch and jumps (lowering_switch.cc) ---
  void SwitchStatement(const Statement& statement);
  Value ConvertSelector(ExprId id);
  void FlatSwitch(const Statement& statement, const Value& selector);
  StatementId LastBreak(StatementId id) const;
  void CheckFallThrough(StatementId from, StatementId to);
  void FindLabels(const Function& function);
  void FindEntries(const Function& function);
  bool AreInOneArm(StatementId list, StatementId a, StatementId b) const;
  void CheckJumps(const Function& function);
  StatementId ParentOf(StatementId id) const;
  /// In the source; ranges do not tell, for all that one use of a macro makes has its range.
  bool IsBefore(StatementId a, StatementId b) const { return OrderOf(a) < OrderOf(b); }

  // --- goto (lowering_goto.cc) ---
  void Goto(const Statement& statement);
  uint32_t GotoLabel(LabelId id);
  void LabelStatement(const Statement& statement, bool last);
  /// Statements of a function by their order.
  struct Span {
    uint32_t first = 0, last = 0;
    bool Holds(uint32_t order) const { return first <= order && order <= last; }
  };
  const std::vector<StatementId>& JumpsTo(StatementId label) const;
  Span Repeated(LabelId label, const std::vector<StatementId>& jumps) const;
  bool IsEnteredElsewhere(const Span& span) const;
  bool HasChoiceAround(StatementId label, StatementId jump) const;
  void SetBudget(ir::PlaceId budget, uint32_t left, StatementId label);
  void SetBudgetBefore(ir::RegionId region, size_t at, ir::PlaceId budget, uint32_t left);
  void PrepareBackJump(const Statement& label, const std::vector<StatementId>& jumps);

  // --- loops (lowering_loops.cc, loop_bounds.cc) ---
  /// What goes round: `tests_first` is 0 of a do loop, whose first round is not tested.
  struct LoopShape {
    ExprId condition, step;
    std::vector<StatementId> body;
    bool tests_first = true;
    bool holds = true;               // 0: it goes round where the condition does not hold
    bool is_statement = true;        // 0: a label and the goto back to it
    Span region = {};                // from the label to the goto
    std::vector<StatementId> tests;  // ifs around the goto: their conditions are evaluated in every round
  };
  /// An if around a jump back, which goes on to the jump where its condition is `holds`.
  struct RoundTest {
    StatementId test;
    bool holds = true;
    size_t in_front = 0;  // statements of the round in front of it
  };
  std::optional<uint64_t> RoundsOfGoto(StatementId label, StatementId jump);
  bool PathBack(StatementId label, StatementId jump, std::vector<StatementId>& body,
                std::vector<RoundTest>& tests) const;
  void LoopStatement(const Statement& statement);
  void Rounds(const Statement& statement, uint32_t on_continue);
  void ConditionRegion(ExprId id, ir::RegionId region);
  Flow RefineWaysOut(ExprId condition, bool counts);
  bool IsSingleStore(ir::RegionId region) const;
  bool IsLocalObject(ObjectId object) const;
  bool GoesOn(StatementId id, bool& continues) const;
  bool Continues(StatementId id, StatementId outer) const;
  void ForgetWrites(StatementId id);
  void ForgetWritesOf(ExprId id);
  void CheckRounds(source::Range keyword, uint64_t rounds);
  std::optional<LoopProof> Prove(const LoopShape& loop);
  std::optional<LoopProof> ProveBy(ExprId conjunct, const LoopShape& loop, const std::vector<ExprId>& parts,
                                   const ObjectSet& declared);
  void WhyUnbounded(ProofStep step, std::string why);
  std::optional<ExprId> OnlyStore(const Cell& cell, const std::vector<ExprId>& parts);
  ExprId Unwidened(ExprId id, uint32_t bits) const;
  std::optional<int64_t> StepOf(const Expr& expr, const StaticAddress& counter) const;
  bool IsUnconditional(ExprId change, ExprId root) const;
  bool IsInEveryRound(ExprId change, const LoopShape& loop) const;
  bool IsJumpedOver(StatementId place, const LoopShape& loop) const;
  bool IsPassedBy(StatementId place, const LoopShape& loop) const;
  /// The place of a statement in the function's text. What is in no body comes after all: the statement of a label that
  /// is not declared, which was reported.
  uint32_t OrderOf(StatementId id) const;
  bool IsPartOf(StatementId id, const std::vector<StatementId>& statements) const;
  bool GoesToInnerLoop(StatementId id, const LoopShape& loop) const;
  bool IsUnchanged(ExprId limit, const std::vector<ExprId>& parts) const;
  /// By facts of this origin at most: what is decided for good rests on nothing that may be forced.
  Bounds BoundsOfExpr(ExprId id, Origin believed);

  // --- calls (lowering_calls.cc, lowering_system.cc, lowering_library.cc) ---
  struct CallResult {
    std::optional<Value> value;
    std::optional<Address> address;  // of pointers, and of records
  };
  CallResult Call(ExprId id);
  CallResult CallFunction(const Expr& expr);
  CallResult CallSystem(const Expr& expr);
  CallResult CallLibrary(const Expr& expr);
  void ForgetAfterCall(const Expr& expr);
  FunctionId Replacement(SystemFunction function) const;
  ir::RoutineId SystemRoutine(SystemFunction function);
  void BuildSystemRoutine(SystemFunction function, ir::RoutineId id);
  /// The function, or what the program has in its place (D13).
  void CallAgain(SystemFunction function, std::vector<ir::ValueId> arguments);
  ir::ValueId AxisWord(Area area, uint32_t word, ir::Type type, ir::ValueId axis);
  void SetAxisWord(uint32_t word, ir::Type type, ir::ValueId value, ir::ValueId axis);
  ir::PlaceId HandwheelPlace();
  ir::ValueId NumberIsOutside(const Value& number, uint32_t count, const Expr& call, size_t argument, bool& bad);
  CallResult MemoryFunction(const Expr& expr);
  ir::ValueId RoomBehind(const Address& address);
  Address At(const Address& address, ir::ValueId counter);
  void Register(const Expr& call);

  // --- the schedule (lowering_schedule.cc, lowering_dispatcher.cc) ---
  void AddScheduleScalars();
  void AddScheduleRoutines();
  void AddStandstill();
  void WhenRunning(const std::function<void()>& body);
  void Exchange(std::string_view name, std::string_view comment, ir::HostAccess access);
  void Parameters();
  void Copy(Area area, uint32_t to, uint32_t from, uint32_t bytes);
  void CallEntry(FunctionId function);
  void Cycle();
  uint32_t LongestPeriod(Storage storage) const;
  void FillSchedule();
  void AddDispatcher();
  ir::RoutineId AddChannelRoutine(const std::string& name, std::string comment, ir::PlaceId& channel);
  ir::PlaceId ChannelWord(Area area, uint32_t word, std::string_view name);
  ir::PlaceId ChannelByte(ir::PlaceId first, const std::string& name);
  void CallHandlers(uint32_t kind, ir::PlaceId channel, const std::function<void()>& otherwise);
  void Dispatch(ir::PlaceId channel);
  void Complete(ir::PlaceId channel);

  // --- names (lowering_symbols.cc) ---
  void AddSymbols();
  void AddSymbol(const std::string& name, TypeId type, uint32_t offset, const std::vector<ir::Symbol::Index>& indices);
  std::string AddressText(ObjectId object, uint32_t offset, ir::Type type) const;
  std::string MeaningOf(const Variable& variable) const;
  void Document();

  Scope scope_;
  const Unit& unit_;
  const Settings& settings_;
  const source::SourceManager& sources_;
  diag::Engine& diagnostics_;
  ir::Program program_;
  dialects::Builder builder_{program_};
  Objects objects_{unit_};
  Facts facts_{unit_, objects_};
  FixedHandlers fixed_handlers_ = FindFixedHandlers(unit_, facts_);
  support::Store<TypeId, Type> types_ = unit_.types;  // and those that only lowering needs
  TypeId int_, unsigned_, long_, unsigned_long_, double_;

  // Memory.
  std::array<ir::SpaceId, 7> area_spaces_;
  ir::SpaceId data_, automatic_, strings_, system_, pointers_, arguments_;
  uint32_t system_bytes_ = 0, pointer_bytes_ = 0, argument_bytes_ = 0;
  std::vector<uint32_t> object_begin_;                               // by ObjectId: byte in its space
  std::vector<ir::SpaceId> object_space_;                            // by ObjectId
  std::unordered_map<uint32_t, PointerPlaces> pointer_places_;       // by VariableId; pointers in memory and locals
  std::unordered_map<uint32_t, PointerPlaces> result_pointers_;      // by FunctionId
  std::unordered_map<std::string, ir::PlaceId> places_;              // by object, offset, type, stride
  std::map<std::pair<uint32_t, uint32_t>, std::string> cell_names_;  // by area object and byte: a macro's name
  std::vector<ir::PlaceId> local_places_;                            // by VariableId: scalars that are named locals
  std::vector<ir::RoutineId> routines_;                              // by FunctionId
  std::vector<ir::SpaceId> function_spaces_;                         // likewise: of its locals
  std::vector<uint32_t> function_bytes_;
  std::unordered_map<uint32_t, ir::PlaceId> copied_parameters_;  // by VariableId: those that lie in memory
  std::unordered_map<uint32_t, ir::RoutineId> system_routines_;  // by SystemFunction

  // Of the function that is being lowered.
  FunctionId function_id_;
  const Function* function_ = nullptr;
  ir::SpaceId locals_;
  uint32_t local_bytes_ = 0;
  ir::PlaceId result_;
  Flow flow_;
  uint32_t next_label_ = 0;
  uint32_t end_label_ = 0;
  struct Target {
    uint32_t label;
    Flow at;
    bool used = false;
  };
  std::map<uint32_t, Target> targets_;  // labels that jumps forward lead to
  struct Around {
    uint32_t on_break = 0, on_continue = 0;
    bool is_loop = false;
  };
  std::vector<Around> around_;
  std::vector<ir::RegionId> iterated_;  // the bodies of the loops around, those that are executed once left out
  struct BackLabel {
    ir::RegionId region;
    ir::InstId label;
    Span span;  // what is executed in its iterations
  };
  std::vector<BackLabel> back_labels_;  // of the function so far
  StatementId elided_break_;            // ends the case that is being lowered
  std::vector<Flow> end_of_switch_;     // behind such breaks
  std::optional<Bounds> result_bounds_;
  std::unordered_map<uint32_t, Bounds> bounds_of_results_;  // by FunctionId
  std::unordered_map<uint32_t, uint32_t> goto_labels_;      // by LabelId
  std::unordered_set<uint32_t> flat_;                       // by StatementId: ifs and switches that jumps lead into
  std::unordered_map<uint32_t, uint32_t> case_labels_;      // by StatementId of a case, of a flat switch
  std::unordered_map<uint32_t, ir::PlaceId> goto_budgets_;  // by LabelId
  std::unordered_set<uint32_t> live_gotos_;                 // by StatementId
  std::unordered_set<uint32_t> entered_;                    // by StatementId: a jump from outside leads into it
  std::unordered_map<uint32_t, StatementId> parents_;       // by StatementId
  std::unordered_map<uint32_t, uint32_t> order_;            // by StatementId
  std::vector<StatementId> statements_;                     // of the function, by their order
  std::unordered_map<uint32_t, std::vector<StatementId>> jumps_to_;  // gotos by StatementId of their label
  std::unordered_set<uint32_t> placed_labels_;                       // by LabelId: jumps to them go back
  std::unordered_map<uint32_t, bool> annotated_labels_;
  bool index_is_checked_ = false;  // by the load in front of the store of `+=` and `++`: one access, one fault
  std::string why_unbounded_;
  ProofStep failed_at_ = ProofStep::kNothing;
  MacroUseId marked_macro_;    // whose text the last marker shows
  uint32_t statement_id_ = 0;  // for faults
  source::Range statement_range_;
  std::unordered_set<uint32_t> refused_pointers_;  // by VariableId
  std::unordered_set<uint32_t> read_unassigned_;   // likewise: reported
  std::unordered_set<uint32_t> block_locals_;      // likewise: scalars of blocks that no jump leads into
  uint64_t rounds_around_ = 1;
  bool unreachable_reported_ = false;
  ir::PlaceId critical_flag_;
  size_t next_comment_ = 0;
  dialects::StatementIds statement_ids_;

  // Schedule.
  ir::RoutineId init_, fast_, slow_, cycle_, period_, fault_;
  ir::FactChecks facts_stated_{builder_};
  ir::ValueId given_;  // a bit: where it is 0, what is computed is not used; none: it is
  ir::RoutineId dispatch_, complete_, standstill_;
  ir::PlaceId fault_code_, fault_statement_, fault_count_, stop_, stopped_, started_, due_fast_, due_slow_, next_fast_,
      next_slow_, fast_done_, slow_done_, now_, period1_, period2_;
  std::array<std::array<ir::PlaceId, 5>, 4> handler_slots_;  // of handlers that are not fixed
  std::array<std::array<ir::PlaceId, 4>, 4> states_, called_;
  std::array<ir::PlaceId, 4> modal_, handwheels_;
  ir::PlaceId handwheel_place_;
  std::array<std::array<std::vector<FunctionId>, 5>, 4> handlers_;  // by channel and kind: that a slot may hold
  std::unordered_map<std::string, ir::HostFunctionId> host_;
};

}  // namespace plcxx::hnc
