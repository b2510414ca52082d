// The lowering's state and its functions, split over lowering_*.cc by family. Only those files include it.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "transpiler/dialects/classicladder/lowering/lowering.h"
#include "transpiler/dialects/classicladder/machine/places.h"
#include "transpiler/dialects/common/builder.h"
#include "transpiler/dialects/common/host_calls.h"
#include "transpiler/dialects/common/statement_ids.h"

namespace plcxx::classicladder {

enum class HostCall : uint8_t { kReadInputs, kWriteOutputs, kFault, kCount };
enum class Fault : uint8_t { kJumpLoop, kIndex, kDivision };

/// What comes out of an element, or into one: a bit that is computed, or known.
struct Signal {
  enum class Kind : uint8_t { kZero, kOne, kValue } kind = Kind::kZero;
  ir::ValueId value;

  static Signal One() { return {.kind = Kind::kOne, .value = {}}; }
  static Signal Of(ir::ValueId value) { return {.kind = Kind::kValue, .value = value}; }
};

class Lowering {
 public:
  Lowering(const Program& tree, const Settings& settings, const source::SourceManager& sources)
      : tree_(tree), settings_(settings), sources_(sources) {}
  ir::Program Run();

 private:
  // --- sections and rungs (lowering.cc) ---
  void AddCalledRoutines(const Section& section);
  void LowerLadder(const Section& section, ir::RegionId body);
  void LowerRung(const Rung& rung);
  /// False: nothing after the element is executed.
  bool Execute(uint32_t x, uint32_t y, const Element& element);
  void AddStatement(const Rung& rung);
  std::string SubjectOf(const Rung& rung) const;
  bool Jump(Signal condition, uint32_t rung);
  void RefuseJump();
  uint32_t LabelOf(uint32_t rung);

  // --- elements (elements.cc) ---
  /// What arrives at the left side of a cell: the outputs left of it in its row, and in the rows that are joined there.
  Signal Left(uint32_t x, uint32_t y);
  void Contact(uint32_t x, uint32_t y, const Element& element);
  void Coil(uint32_t x, uint32_t y, const Element& element);
  void Timer(uint32_t x, uint32_t y, uint32_t number);
  void Monostable(uint32_t x, uint32_t y, uint32_t number);
  void Counter(uint32_t x, uint32_t y, uint32_t number);
  void TimerIec(uint32_t x, uint32_t y, uint32_t number);
  ir::StateId EdgeOf(const Element& element);

  // --- signals (elements.cc) ---
  ir::ValueId ToBit(Signal signal);
  Signal And(Signal a, Signal b);
  Signal Or(Signal a, Signal b);
  Signal Not(Signal a);
  template <class Then>
  void When(Signal condition, Then&& then);
  template <class Then, class Otherwise>
  void Choose(Signal condition, Then&& then, Otherwise&& otherwise);

  // --- variables (places.cc) ---
  void NameSymbols();
  std::string NameInCode(const Address& address) const;
  ir::PlaceId PlaceOf(const Address& address);
  ir::PlaceId FieldOf(Group group, Part part, uint32_t number);
  ir::PlaceId HiddenOf(Group group, Hidden part, uint32_t number);
  ir::PlaceId Named(std::string name, ir::Place place);
  ir::PlaceId NewSystemPlace(std::string name, ir::Type type);
  ir::PlaceId NewLocal(std::string name, ir::Type type);
  ir::ValueId ReadNumber(const Variable& variable);
  ir::ValueId ReadBit(const Variable& variable);
  void WriteNumber(const Variable& variable, ir::ValueId value);
  void WriteBit(const Variable& variable, ir::ValueId bit);
  /// Where an indexed variable is, and by what it is reached; reports an index that leads out of the array.
  struct Indexed {
    ir::PlaceId place;
    ir::ValueId index;
    ir::Type type{};
  };
  Indexed IndexOfVariable(const Variable& variable);
  ir::ValueId BaseOf(const Variable& variable, ir::ValueId index);
  void Initial(const ir::Place& place, uint32_t value);
  void InitialValues();
  void Document();

  // --- expressions (expressions.cc) ---
  Signal Compare(uint32_t number);
  void Operate(uint32_t number);
  ir::ValueId Evaluate(const Expression& expression, uint32_t node);
  ir::ValueId Divide(ir::OpKind op, ir::ValueId dividend, ir::ValueId divisor);
  ir::ValueId Power(ir::ValueId base, ir::ValueId exponent);

  // --- sequential pages (sequential.cc) ---
  void LowerPage(const Section& section);
  void Fire(const Transition& transition);
  void RefreshStep(uint32_t index, const Step& step);
  void RefreshSteps();
  ir::PlaceId ActiveOf(uint32_t step);

  // --- the schedule (schedule.cc) ---
  void AddRoutines();
  void Init();
  void Period();
  void Schedule();
  void CallFault(Fault fault);

  ir::ValueId Word(uint32_t value) { return builder_.Constant(ir::Type::kI32, value); }

  const Program& tree_;
  const Settings& settings_;
  const source::SourceManager& sources_;
  ir::Program program_;
  dialects::Builder builder_{program_};
  dialects::HostCalls<HostCall> host_{builder_};
  dialects::StatementIds statement_ids_;

  /// What is being lowered.
  struct Current {
    const Section* section = nullptr;
    const Rung* rung = nullptr;
    size_t position = 0;                  // of the rung in its section
    std::map<uint32_t, size_t> order;     // rung -> position
    std::map<uint32_t, uint32_t> labels;  // rung -> label
    ir::PlaceId jumps_left;               // none: no jump goes back
    uint32_t end_label = 0;
    bool end_is_used = false;
    Signal outputs[kRungWidth][kRungHeight];
    Signal lefts[kRungWidth][kRungHeight];  // by the topmost row that is joined
    bool knows_left[kRungWidth][kRungHeight] = {};
  };
  Current now_;
  uint32_t next_label_ = 0;
  std::map<std::string, ir::PlaceId> places_;                   // by name and address
  std::map<std::pair<uint32_t, uint32_t>, std::string> names_;  // of symbols: by kind and number
  std::map<source::Offset, ir::StateId> edges_;                 // by the place of the element
  std::vector<const Element*> edge_elements_;                   // in their order
  std::map<std::string, uint32_t> edge_names_;
  std::map<uint32_t, ir::RoutineId> routines_;  // by section
  std::vector<const Section*> called_;          // in the order of their routines
  std::set<std::pair<uint32_t, uint32_t>> used_;
  ir::RoutineId init_, fast_, period_, steps_;
  ir::PlaceId periods_, stopped_, changed_, rounds_;
};

template <class Then>
void Lowering::When(Signal condition, Then&& then) {
  if (condition.kind == Signal::Kind::kOne) return then();
  if (condition.kind == Signal::Kind::kValue) builder_.When(condition.value, then);
}

template <class Then, class Otherwise>
void Lowering::Choose(Signal condition, Then&& then, Otherwise&& otherwise) {
  if (condition.kind == Signal::Kind::kOne) return then();
  if (condition.kind == Signal::Kind::kZero) return otherwise();
  builder_.Choose(condition.value, then, otherwise);
}

}  // namespace plcxx::classicladder
