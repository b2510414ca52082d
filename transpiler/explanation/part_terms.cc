#include "transpiler/explanation/part_terms.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <string_view>
#include <unordered_set>

#include "transpiler/ir/accesses.h"
#include "transpiler/ir/builder.h"
#include "transpiler/ir/uses.h"
#include "transpiler/support/check.h"
#include "transpiler/symbolic/execute/host_writes.h"
#include "transpiler/symbolic/meaning/meaning.h"
#include "transpiler/symbolic/terms/evaluate.h"

namespace plcxx::explanation {
namespace {

/// A part that takes more than this is not explained; a machine of ten thousand statements is far below.
constexpr uint32_t kMaxTerms = 3'000'000;
constexpr uint32_t kMaxRounds = 1024;
/// Rounds of a loop of which it is not known whether it goes on; then those of the recorded part are followed.
constexpr uint32_t kMaxUnknownRounds = 8;
constexpr std::clock_t kMaxTime = 10 * CLOCKS_PER_SEC;  // of the processor: a loaded machine gives the same answers

// The names that execute/host_calls.cc gives to what a host does.
constexpr std::string_view kAnswer = "answer of ";
constexpr std::string_view kHasSecond = "has second answer of ";
constexpr std::string_view kSecond = "second answer of ";

bool IsLocal(const ir::Program& program, const execute::Cell& cell) {
  return cell.kind == execute::CellKind::kBit && program.spaces[cell.space].lifetime == ir::Lifetime::kRoutine;
}

}  // namespace

/// Sees each instruction before it is executed, and so knows whose a write is.
class PartTerms::Watch : public execute::ReplacedParts {
 public:
  explicit Watch(PartTerms& part) : part_(part), program_(part.program_) {
    statements_.resize(program_.regions.size());
    owners_.resize(program_.regions.size());
    for (uint32_t i = 0; i < program_.regions.size(); ++i) {
      for (const ir::InstId id : program_.regions[ir::RegionId(i)].insts) {
        if (!ir::OwnsRegions(program_[id])) continue;
        for (const ir::RegionId owned : ir::OwnedRegions(program_, program_[id]))
          owners_[owned.index] = ir::RegionId(i);
      }
    }
    // A bit that is never a part of a word is a coil also where a constant is written; a word may count a loop's
    // rounds, which must stay known.
    is_coil_.resize(part.cells_.count);
    for (const ir::Place& place : program_.places) {
      if (!place.is_field() && place.type == ir::Type::kBit && !place.indexed && execute::IsInside(program_, place)) {
        is_coil_[execute::CellsOf(program_, part.cells_, place).front().index] = true;
      }
    }
    for (const ir::Place& place : program_.places) {
      if (place.is_field() || !place.space.valid() || (place.type == ir::Type::kBit && !place.indexed)) continue;
      for (const execute::CellId cell : execute::TouchedCells(program_, part.cells_, place)) {
        is_coil_[cell.index] = false;
      }
    }
  }

  std::optional<std::vector<execute::CellChange>> Call(execute::Memory&, ir::RoutineId, terms::TermId) override {
    return std::nullopt;
  }

  std::optional<std::vector<execute::CellChange>> Part(execute::Memory& memory, ir::RegionId region, uint32_t& at,
                                                       terms::TermId) override {
    memory_ = &memory;
    const ir::Inst& inst = program_[program_.regions[region].insts[at]];
    // A statement lasts to the end of its region, and into the regions of its own; a routine begins without one.
    ir::StatementId& statement = statements_[region.index];
    if (at == 0)
      statement = owners_[region.index].valid() ? statements_[owners_[region.index].index] : ir::StatementId();
    if (inst.op == ir::OpKind::kStatement) statement = ir::StatementId(inst.payload);
    statement_ = statement;
    // What comes now until the next instruction is its own, once a cell; after that arms are joined.
    own_.clear();
    host_own_.clear();
    if (inst.op == ir::OpKind::kHostCall) NoteCall(ir::CallId(inst.payload));
    const auto add = [&](execute::CellId cell) { own_.insert(cell.index); };
    ir::ForEachAccess(
        program_, inst,
        [&](ir::PlaceId id, ir::Access access) {
          const ir::Place& place = program_.places[id];
          if (access == ir::Access::kRead || (!place.is_field() && !place.space.valid())) return;
          for (const execute::CellId cell : execute::TouchedCells(program_, part_.cells_, place)) add(cell);
        },
        [&](ir::StateId state) {
          for (const execute::CellId cell : execute::CellsOfInstance(program_, part_.cells_, state)) add(cell);
        });
    return std::nullopt;
  }

  bool IsCut(execute::CellId id) const { return !IsLocal(program_, execute::CellAt(program_, part_.cells_, id)); }

  terms::TermId Cut(execute::CellId id, terms::TermId value) {
    const execute::Cell cell = execute::CellAt(program_, part_.cells_, id);
    if (cell.kind == execute::CellKind::kCalls || IsLocal(program_, cell)) return value;
    if (part_.IsForced(cell)) return part_.Initial(id);
    if (host_own_.erase(id.index) != 0) return WrittenByHost(id, cell);
    const bool is_own = own_.erase(id.index) != 0;
    if (!is_own || (part_.terms_.IsConst(value) && !is_coil_[id.index])) return value;
    const terms::Term& term = part_.terms_[value];
    if (term.kind == terms::TermKind::kVariable && part_.variables_[term.a].cell == id) return value;
    return part_.NewVariable(
        {.kind = VariableKind::kWritten, .cell = id, .value = 0, .definition = value, .statement = statement_});
  }

 private:
  /// What the call writes while it is executed; what is written after that is where arms are joined.
  void NoteCall(ir::CallId call) {
    host_function_ = program_.calls[call].host;
    const ir::HostFunction& host = program_.host_functions[host_function_];
    for (uint32_t i = 0; i < program_.spaces.size(); ++i) {
      const ir::SpaceId space(i);
      for (uint32_t offset = 0; offset < program_.spaces[space].bytes; ++offset) {
        const uint8_t written = execute::BitsMayWrite(program_, host, space, offset);
        for (uint8_t bit = 0; bit < 8; ++bit) {
          if ((written >> bit & 1) != 0) host_own_.insert(part_.cells_.OfBit(space, offset, bit).index);
        }
      }
    }
  }

  /// What a call that writes the state has left in a cell: nothing new, as a rule.
  terms::TermId WrittenByHost(execute::CellId id, const execute::Cell& cell) {
    const RecordedCall* writer = nullptr;
    for (const RecordedCall& call : part_.frame_.calls) {
      if (call.function != host_function_ || call.memory.empty()) continue;
      if (writer != nullptr) part_.refusal_ = "the control writes the memory several times in one scan";
      writer = &call;
    }
    if (writer == nullptr || cell.kind != execute::CellKind::kBit) return memory_->Read(id);
    const uint64_t value = writer->memory[cell.space.index][cell.offset] >> cell.bit & 1;
    return part_.NewVariable(
        {.kind = VariableKind::kHost, .cell = id, .value = value, .definition = {}, .statement = {}});
  }

  PartTerms& part_;
  const ir::Program& program_;
  execute::Memory* memory_ = nullptr;
  ir::StatementId statement_;
  std::vector<ir::StatementId> statements_;  // by region: the one that its execution has come to
  std::vector<ir::RegionId> owners_;         // by region: the one around it; none: a routine's
  std::unordered_set<uint32_t> own_;         // looked up only
  std::vector<bool> is_coil_;                // by cell
  std::unordered_set<uint32_t> host_own_;    // the same of a call of the host
  ir::HostFunctionId host_function_;
};

PartTerms::PartTerms(const ir::Program& program, const execute::Cells& cells, const Frame& frame,
                     std::span<const execute::CellId> wanted)
    : program_(program), cells_(cells), frame_(frame), written_(frame.before) {
  // Every field of every instance in the order of the cells.
  std::vector<uint8_t> bytes;
  frame.before.instances.AppendTo(bytes);
  size_t next = 0;
  for (const ir::StateInstance& state : program.states) {
    for (const ir::FieldInfo& field : ir::Info(state.kind).fields) {
      for (uint8_t element = 0; element < field.count; ++element) {
        uint64_t value = 0;
        for (uint32_t i = 0; i < ir::Bytes(field.type); ++i) value |= uint64_t{bytes[next++]} << (8 * i);
        fields_.push_back(value);
      }
    }
  }
  ReplayCalls();
  Execute(wanted);
  if (!refusal_.empty()) return;
  Evaluate();
  for (uint32_t i = 0; i < terms_.size(); ++i) cone_.emplace_back(i);
  justification_.emplace(terms_, cone_, values_, definitions_, [](const terms::TermFunction& function) {
    return IsAnswer(function) ? terms::UnknownFunction::kCounts : terms::UnknownFunction::kAvoided;
  });
}

terms::TermId PartTerms::NewVariable(PartVariable variable) {
  const execute::Cell cell = execute::CellAt(program_, cells_, variable.cell);
  definitions_.push_back(variable.definition);
  variables_.push_back(variable);
  return terms_.Variable({}, execute::CellWidth(program_, cell));
}

uint64_t PartTerms::ValueBefore(const execute::Cell& cell) const {
  switch (cell.kind) {
    case execute::CellKind::kBit:
      return frame_.before.spaces[cell.space.index][cell.offset] >> cell.bit & 1;
    case execute::CellKind::kField: {
      const uint32_t first = cells_.states[cell.state.index] - cells_.states.front();
      const uint32_t field = meaning::FieldTermIndex(program_.states[cell.state].kind, cell.field);
      return fields_[first + field + cell.element];
    }
    case execute::CellKind::kCalls:
      return 0;
  }
  PLCXX_UNREACHABLE();
}

/// What is forced keeps its value when something else is written.
bool PartTerms::IsForced(const execute::Cell& cell) const {
  switch (cell.kind) {
    case execute::CellKind::kBit: {
      const auto mask = static_cast<uint8_t>(1u << cell.bit);
      const uint8_t before = frame_.before.spaces[cell.space.index][cell.offset];
      sim::ForcedBytes& written = written_.spaces[cell.space.index];
      written.Write(cell.offset, mask, static_cast<uint8_t>(~before));
      const bool is_forced = written[cell.offset] == before;
      written.Write(cell.offset, mask, before);
      return is_forced;
    }
    case execute::CellKind::kField: {
      if (ir::Info(program_.states[cell.state].kind).fields[cell.field].count != 1) return false;
      const uint64_t before = frame_.before.instances.Read(cell.state.index, cell.field);
      written_.instances.Write(cell.state.index, cell.field, ~before);
      const bool is_forced = written_.instances.Read(cell.state.index, cell.field) == before;
      written_.instances.Write(cell.state.index, cell.field, before);
      return is_forced;
    }
    case execute::CellKind::kCalls:
      return false;
  }
  PLCXX_UNREACHABLE();
}

terms::TermId PartTerms::Initial(execute::CellId id) {
  const execute::Cell cell = execute::CellAt(program_, cells_, id);
  if (cell.kind == execute::CellKind::kCalls) return terms_.Const(0, execute::CellWidth(program_, cell));
  return NewVariable({.kind = IsForced(cell) ? VariableKind::kForced : VariableKind::kBefore,
                      .cell = id,
                      .value = ValueBefore(cell),
                      .definition = {},
                      .statement = {}});
}

void PartTerms::Execute(std::span<const execute::CellId> wanted) {
  Watch watch(*this);
  const std::clock_t begin = std::clock();
  const uint8_t now_width = program_.schedule.now.valid()
                                ? meaning::WidthOf(program_.host_functions[program_.schedule.now].result)
                                : uint8_t{32};
  execute::Environment environment{
      .initial = [this](execute::CellId cell) { return Initial(cell); },
      .cut = [&watch](execute::CellId cell, terms::TermId value) { return watch.Cut(cell, value); },
      .is_cut = [&watch](execute::CellId cell) { return watch.IsCut(cell); },
      .now = terms_.Const(frame_.now_ms, now_width),
      .replaced = &watch,
      .summarize_after = kMaxUnknownRounds,
      .holds = [this](terms::TermId condition) { return Holds(condition); },
      .most_rounds = kMaxRounds,
      .most_terms = kMaxTerms,
      .is_late = [begin] { return std::clock() - begin > kMaxTime; }};
  execute::Memory memory(terms_, program_, cells_, std::move(environment));
  const execute::Refusal refusal = execute::Execute(memory, RoutineOf(program_, frame_.kind));
  if (refusal_.empty()) refusal_ = refusal;
  if (!refusal_.empty()) return;
  for (const execute::CellId cell : wanted) after_.push_back(memory.Read(cell));
}

void PartTerms::ReplayCalls() {
  std::vector<uint64_t> told(cells_.CallCells());
  for (const RecordedCall& call : frame_.calls) {
    const std::string& name = program_.host_functions[call.function].name;
    const terms::TermFunction function{.name = "told " + name, .width = 64, .evaluate = nullptr};
    const auto after = [&](uint64_t calls) {
      std::vector<uint64_t> arguments{calls};
      arguments.insert(arguments.end(), call.arguments.begin(), call.arguments.end());
      return terms::MadeUpValue(function, arguments);
    };
    uint64_t key = 0;
    for (const execute::CellId chain : cells_.ChainsOf(call.function, false)) {
      uint64_t& calls = told[chain.index - cells_.calls];
      key = calls = after(calls);
    }
    answers_[{name, key}] = call.answer;
  }
}

bool PartTerms::Holds(terms::TermId condition) {
  Evaluate();
  return Value(condition) != 0;
}

/// Of the terms that are new since the last time.
void PartTerms::Evaluate() {
  const auto first = static_cast<uint32_t>(values_.size());
  values_.resize(terms_.size());
  const auto value = [this](terms::TermId id) { return values_[id.index]; };
  const auto variable = [this](uint32_t number) {
    const PartVariable& known = variables_[number];
    return known.definition.valid() ? values_[known.definition.index] : known.value;
  };
  for (uint32_t i = first; i < terms_.size(); ++i) {
    const terms::Term& term = terms_[terms::TermId(i)];
    values_[i] = terms::EvaluateTerm(terms_, term, value, variable);
    if (term.kind != terms::TermKind::kApply) continue;
    const std::string_view name = terms_.Info(terms::FunctionId(term.a)).name;
    const auto answer_to = [&](std::string_view prefix) -> const sim::HostAnswer* {
      if (!name.starts_with(prefix)) return nullptr;
      const auto found =
          answers_.find({std::string(name.substr(prefix.size())), value(terms_.Arguments(term).front())});
      return found == answers_.end() ? nullptr : &found->second;
    };
    if (const sim::HostAnswer* answer = answer_to(kAnswer)) values_[i] = terms::Masked(answer->result, term.width);
    if (const sim::HostAnswer* answer = answer_to(kHasSecond)) values_[i] = answer->out.has_value() ? 1 : 0;
    if (const sim::HostAnswer* answer = answer_to(kSecond)) {
      values_[i] = terms::Masked(answer->out.value_or(0), term.width);
    }
  }
}

const PartVariable* PartTerms::VariableOf(terms::TermId term) const {
  const terms::Term& known = terms_[term];
  return known.kind == terms::TermKind::kVariable ? &variables_[known.a] : nullptr;
}

bool PartTerms::IsAnswer(const terms::TermFunction& function) {
  return function.name.starts_with(kAnswer) || function.name.starts_with(kHasSecond) ||
         function.name.starts_with(kSecond);
}

bool PartTerms::IsKnown(terms::TermId reason) const {
  const terms::Term& term = terms_[reason];
  return term.kind != terms::TermKind::kApply || IsAnswer(terms_.Info(terms::FunctionId(term.a)));
}

std::string PartTerms::HostFunctionOf(terms::TermId answer) const {
  const std::string_view name = terms_.Info(terms::FunctionId(terms_[answer].a)).name;
  for (const std::string_view prefix : {kAnswer, kHasSecond, kSecond}) {
    if (name.starts_with(prefix)) return std::string(name.substr(prefix.size()));
  }
  return std::string(name);
}

}  // namespace plcxx::explanation
