#include "transpiler/explanation/explain.h"

#include <algorithm>
#include <deque>
#include <map>
#include <tuple>
#include <utility>

#include "transpiler/explanation/instance_text.h"
#include "transpiler/explanation/part_terms.h"
#include "transpiler/ir/accesses.h"
#include "transpiler/ir/builder.h"
#include "transpiler/ir/place_names.h"
#include "transpiler/sim/value_text.h"
#include "transpiler/support/check.h"

namespace plcxx::explanation {
namespace {

/// Who has a cell that a reason names: what is one condition for a person.
enum class Owner : uint8_t { kBit, kWord, kInstance, kBareCell, kHostFunction };

/// One cell of a condition and the bits of it that count.
struct Member {
  const PartVariable* variable;
  terms::TermId term;
  uint64_t bits;
};

struct GroupKey {
  Owner owner{};
  uint32_t id = 0;  // of the place, the instance, the cell
  VariableKind kind{};
  uint32_t statement = 0;
  std::string function;
  auto operator<=>(const GroupKey&) const = default;
};
using Groups = std::map<GroupKey, std::vector<Member>>;

class Builder {
 public:
  Builder(const Subject& subject, const Frame& frame, const PartTerms& part)
      : subject_(subject), program_(subject.program), frame_(frame), part_(part) {}

  Explanation Build(std::span<const execute::CellId> cells, const std::string& name) {
    std::vector<terms::Reason> wanted;
    for (const terms::TermId term : part_.after()) wanted.push_back(All(term));
    std::ranges::copy(cells, std::back_inserter(root_cells_));
    Condition root{.kind = ConditionKind::kWritten, .name = name, .label = name, .text = {}, .statement = {}};
    root.cells = root_cells_;
    root.time_ms = frame_.now_ms;
    explanation_.conditions.push_back(std::move(root));
    const std::vector<terms::Reason> reasons = ReasonsOfRoot(std::move(wanted));
    AddReasons(0, reasons);
    while (!open_.empty() && explanation_.refusal.empty()) {
      const auto [number, definitions] = std::move(open_.front());
      open_.pop_front();
      AddReasons(number, part_.ReasonsFor(definitions));
    }
    if (!explanation_.refusal.empty()) return {.refusal = std::move(explanation_.refusal)};
    for (const auto& [cell, bits] : leaves_) explanation_.leaves.push_back({.cell = cell, .bits = bits});
    FoldRoot();
    return std::move(explanation_);
  }

 private:
  terms::Reason All(terms::TermId term) const {
    return {.term = term, .bits = terms::Masked(~uint64_t{0}, part_.terms().Width(term))};
  }

  /// The signal's own write is the signal, not a reason for it; what leads to that write stays a reason.
  std::vector<terms::Reason> ReasonsOfRoot(std::vector<terms::Reason> wanted) {
    Condition& root = explanation_.conditions.front();
    for (;;) {
      std::vector<terms::Reason> reasons = part_.ReasonsFor(wanted), deeper;
      std::erase_if(reasons, [&](const terms::Reason& reason) {
        const PartVariable* variable = part_.VariableOf(reason.term);
        const bool is_own = variable != nullptr && variable->kind == VariableKind::kWritten &&
                            std::ranges::find(root_cells_, variable->cell) != root_cells_.end() &&
                            (!explanation_.is_written || root.statement == variable->statement);
        if (!is_own) return false;
        explanation_.is_written = true;
        root.statement = variable->statement;
        deeper.push_back({.term = variable->definition, .bits = reason.bits});
        return true;
      });
      if (deeper.empty()) return reasons;
      wanted = std::move(deeper);
      std::ranges::copy(reasons, std::back_inserter(wanted));
    }
  }

  GroupKey KeyOf(const terms::Reason& reason, const std::map<const ir::Place*, uint32_t>& in_word) const {
    const PartVariable* variable = part_.VariableOf(reason.term);
    if (variable == nullptr) return {.owner = Owner::kHostFunction, .function = part_.HostFunctionOf(reason.term)};
    GroupKey key{.kind = variable->kind, .statement = variable->statement.index};
    const execute::Cell cell = execute::CellAt(program_, subject_.cells, variable->cell);
    if (cell.kind == execute::CellKind::kField) {
      key.owner = Owner::kInstance;
      key.id = cell.state.index;
      return key;
    }
    const ir::Place* exact = subject_.names.ExactPlace(variable->cell);
    const ir::Place* word = subject_.names.Word(variable->cell);
    // Several bits of a word are the word; one alone is what the source calls the bit.
    const bool is_word = word != nullptr && (exact == nullptr || in_word.at(word) > 1);
    if (is_word || exact != nullptr) {
      key.owner = is_word ? Owner::kWord : Owner::kBit;
      key.id = static_cast<uint32_t>((is_word ? word : exact) - &program_.places[ir::PlaceId(0)]);
    } else {
      key.owner = Owner::kBareCell;
      key.id = variable->cell.index;
    }
    return key;
  }

  Groups GroupsOf(const std::vector<terms::Reason>& reasons) const {
    std::map<const ir::Place*, uint32_t> in_word;
    for (const terms::Reason& reason : reasons) {
      if (const PartVariable* variable = part_.VariableOf(reason.term)) ++in_word[subject_.names.Word(variable->cell)];
    }
    Groups groups;
    for (const terms::Reason& reason : reasons) {
      groups[KeyOf(reason, in_word)].push_back(
          {.variable = part_.VariableOf(reason.term), .term = reason.term, .bits = reason.bits});
    }
    return groups;
  }

  void AddReasons(uint32_t number, const std::vector<terms::Reason>& reasons) {
    if (!std::ranges::all_of(reasons, [this](const terms::Reason& reason) { return part_.IsKnown(reason.term); })) {
      explanation_.refusal = "a loop decides whose rounds depend on data";
      return;
    }
    for (auto& [key, members] : GroupsOf(reasons)) {
      std::ranges::sort(members, {}, [](const Member& member) { return member.term.index; });
      std::vector<std::pair<uint32_t, uint64_t>> identity;
      for (const Member& member : members) {
        // What a cell held before the part is one thing, however often it was asked for.
        const bool is_before = member.variable != nullptr && member.variable->kind != VariableKind::kWritten;
        identity.emplace_back(is_before ? member.variable->cell.index : member.term.index, member.bits);
      }
      const auto [known, is_new] =
          known_.emplace(std::pair(key, std::move(identity)), static_cast<uint32_t>(explanation_.conditions.size()));
      if (is_new) explanation_.conditions.push_back(ConditionOf(key, members));
      std::vector<uint32_t>& because = explanation_.conditions[number].because;
      if (std::ranges::find(because, known->second) == because.end()) because.push_back(known->second);
      if (is_new && key.owner != Owner::kHostFunction && key.kind == VariableKind::kWritten) {
        std::vector<terms::Reason> definitions;
        for (const Member& member : members) {
          definitions.push_back({.term = member.variable->definition, .bits = member.bits});
        }
        open_.emplace_back(known->second, std::move(definitions));
      }
    }
  }

  Condition ConditionOf(const GroupKey& key, const std::vector<Member>& members) {
    Condition condition;
    condition.time_ms = frame_.now_ms;
    if (key.owner == Owner::kHostFunction) {
      condition.kind = ConditionKind::kAnswer;
      condition.name = condition.label = key.function;
      condition.text = std::to_string(part_.Value(members.front().term));
      condition.predicate = "is " + condition.text;
      if (std::ranges::find(explanation_.answers, key.function) == explanation_.answers.end()) {
        explanation_.answers.push_back(key.function);
      }
      return condition;
    }
    for (const Member& member : members) condition.cells.push_back(member.variable->cell);
    Name(key, members, condition);
    condition.is_internal = std::ranges::all_of(condition.cells, [this](execute::CellId id) {
      const execute::Cell cell = execute::CellAt(program_, subject_.cells, id);
      return cell.kind == execute::CellKind::kBit && !subject_.is_named[id.index];
    });
    switch (key.kind) {
      case VariableKind::kWritten:
        condition.kind = ConditionKind::kWritten;
        condition.statement = members.front().variable->statement;
        return condition;
      case VariableKind::kHost:
        condition.kind = ConditionKind::kInput;
        condition.last_write =
            sim::LastWrite{.writer = sim::Writer::kHost, .first_ms = frame_.now_ms, .last_ms = frame_.now_ms};
        return condition;
      case VariableKind::kForced:
        condition.kind = ConditionKind::kForced;
        break;
      case VariableKind::kBefore:
        condition.last_write = LastWriteOf(members.front().variable->cell);
        condition.kind = key.owner == Owner::kInstance ? ConditionKind::kState
                         : condition.last_write && condition.last_write->writer == sim::Writer::kProgram
                             ? ConditionKind::kKept
                             : ConditionKind::kInput;
        break;
    }
    for (const Member& member : members) leaves_[member.variable->cell] |= member.bits;
    return condition;
  }

  std::optional<sim::LastWrite> LastWriteOf(execute::CellId id) const {
    const execute::Cell cell = execute::CellAt(program_, subject_.cells, id);
    ir::Place place;
    if (cell.kind == execute::CellKind::kField) {
      place.state = cell.state;
      place.field = cell.field;
    } else {
      place.space = cell.space;
      place.offset = cell.offset;
      place.bit = cell.bit;
    }
    const std::vector<sim::LastWrite> writes = frame_.writes_before.Of(place);
    if (writes.empty()) return std::nullopt;
    return writes.front();
  }

  /// What the condition is about, and what it is.
  void Name(const GroupKey& key, const std::vector<Member>& members, Condition& condition) const {
    if (key.owner == Owner::kInstance) return NameInstance(key, members, condition);
    NamePlace(key, members, condition);
    condition.predicate = "is " + condition.text;
  }

  void NameInstance(const GroupKey& key, const std::vector<Member>& members, Condition& condition) const {
    const ir::StateId state(key.id);
    const ir::Place* exact = members.size() == 1 ? subject_.names.ExactPlace(members.front().variable->cell) : nullptr;
    condition.name = exact != nullptr ? subject_.names.NameOf(*exact) : program_.states[state].name;
    condition.label = exact != nullptr ? ir::SourceName(*exact) : program_.states[state].name;
    const auto add = [&](const std::string& text, const std::string& predicate) {
      condition.text += (condition.text.empty() ? "" : "; ") + text;
      condition.predicate += (condition.predicate.empty() ? "" : " and ") + predicate;
    };
    const bool before = key.kind == VariableKind::kBefore;
    if (exact != nullptr) {
      const std::string value =
          FieldDigits(program_.states[state].kind, exact->type, part_.Value(members.front().term));
      add(value, "is " + value);
    } else if (!before) {
      const bool one = HasOneField(program_.states[state].kind);
      const std::string fields = FieldsText(state, members);
      add(fields, one ? "is " + std::to_string(part_.Value(members.front().term)) : "has " + fields);
    }
    if (!before) return;
    // A timer's time is that of the moment that is asked about; of everything else what decided was there before.
    const sim::Instances& then =
        IsTimer(program_.states[state].kind) ? frame_.after.instances : frame_.before.instances;
    const std::string kept = InstanceText(program_, state, then);
    const std::string predicate = InstancePredicate(program_, state, then);
    if (exact == nullptr || !HasOneField(program_.states[state].kind)) return add(kept, predicate);
    condition.text += "; " + kept;
  }

  void NamePlace(const GroupKey& key, const std::vector<Member>& members, Condition& condition) const {
    const auto value_of = [this](const Member& member) { return part_.Value(member.term); };
    switch (key.owner) {
      case Owner::kBit: {
        const ir::Place& place = program_.places[ir::PlaceId(key.id)];
        condition.name = subject_.names.NameOf(place);
        condition.label = ir::SourceName(place);
        condition.text = std::to_string(value_of(members.front()));
        return;
      }
      case Owner::kWord: {
        const ir::Place& place = program_.places[ir::PlaceId(key.id)];
        condition.name = subject_.names.NameOf(place);
        condition.label = ir::SourceName(place);
        condition.text = WordText(place, members);
        return;
      }
      case Owner::kBareCell:
        condition.name = condition.label =
            execute::CellName(program_, execute::CellAt(program_, subject_.cells, members.front().variable->cell));
        condition.text = std::to_string(value_of(members.front()));
        return;
      case Owner::kInstance:
      case Owner::kHostFunction:
        return;
    }
  }

  /// "count 5, input 1": what the members are called, and are.
  std::string FieldsText(ir::StateId state, const std::vector<Member>& members) const {
    std::string text;
    for (const Member& member : members) {
      const execute::Cell cell = execute::CellAt(program_, subject_.cells, member.variable->cell);
      const ir::FieldInfo& field = ir::Info(program_.states[state].kind).fields[cell.field];
      text += (text.empty() ? "" : ", ") + std::string(field.name) + " " +
              FieldDigits(program_.states[state].kind, field.type, part_.Value(member.term));
    }
    return text;
  }

  /// The whole word where all of it counts, else its bits.
  std::string WordText(const ir::Place& place, const std::vector<Member>& members) const {
    const std::vector<execute::CellId> cells = execute::CellsOf(program_, subject_.cells, place);
    std::map<size_t, uint64_t> bits;
    for (const Member& member : members) {
      const auto at = std::ranges::find(cells, member.variable->cell);
      bits[static_cast<size_t>(at - cells.begin())] = part_.Value(member.term);
    }
    if (bits.size() == cells.size()) {
      uint64_t value = 0;
      for (const auto& [bit, one] : bits) value |= one << bit;
      return sim::ValueDigits(place.type, value);
    }
    std::string zeros, ones;
    for (const auto& [bit, one] : bits) {
      std::string& list = one == 0 ? zeros : ones;
      list += (list.empty() ? "" : " ") + std::to_string(bit);
    }
    std::string text;
    for (const auto& [value, list] : {std::pair("0", zeros), std::pair("1", ones)}) {
      if (list.empty()) continue;
      text += (text.empty() ? "" : ", ") + std::string(value) + " in bit" +
              (list.find(' ') != std::string::npos ? "s " : " ") + list;
    }
    return text;
  }

  /// A signal that no statement wrote now is what it was before; the reasons are why none did.
  void FoldRoot() {
    Condition& root = explanation_.conditions.front();
    if (explanation_.is_written) return;
    const auto itself = std::ranges::find_if(root.because, [&](uint32_t reason) {
      const Condition& condition = explanation_.conditions[reason];
      return condition.kind != ConditionKind::kWritten && condition.kind != ConditionKind::kAnswer &&
             std::ranges::all_of(condition.cells, [&](execute::CellId cell) {
               return std::ranges::find(root_cells_, cell) != root_cells_.end();
             });
    });
    if (itself == root.because.end()) return;
    const Condition& before = explanation_.conditions[*itself];
    root.kind = before.kind;
    root.text = before.text;
    root.predicate = before.predicate;
    root.last_write = before.last_write;
    root.is_internal = before.is_internal;
    root.because.erase(itself);
    // Nothing else names it, or it stays where it is named.
    if (root.because.empty()) explanation_.conditions.resize(1);
  }

  const Subject& subject_;
  const ir::Program& program_;
  const Frame& frame_;
  const PartTerms& part_;
  std::vector<execute::CellId> root_cells_;
  Explanation explanation_;
  std::deque<std::pair<uint32_t, std::vector<terms::Reason>>> open_;  // conditions whose reasons are not known yet
  std::map<std::pair<GroupKey, std::vector<std::pair<uint32_t, uint64_t>>>, uint32_t> known_;
  std::map<execute::CellId, uint64_t> leaves_;
};

uint64_t CellAfter(const Subject& subject, const Frame& frame, execute::CellId id) {
  const execute::Cell cell = execute::CellAt(subject.program, subject.cells, id);
  if (cell.kind == execute::CellKind::kField) return frame.after.instances.Read(cell.state.index, cell.field);
  return frame.after.spaces[cell.space.index][cell.offset] >> cell.bit & 1;
}

}  // namespace

Subject::Subject(const ir::Program& the_program)
    : program(the_program), cells(execute::MakeCells(the_program)), names(program, cells), is_named(cells.count) {
  const auto note = [this](ir::PlaceId id) {
    const ir::Place& place = program.places[id];
    if (place.is_field() || !place.space.valid()) return;
    for (const execute::CellId cell : execute::TouchedCells(program, cells, place)) is_named[cell.index] = true;
  };
  for (const ir::Routine& routine : program.routines) {
    if (routine.kind == ir::RoutineKind::kSchedule || routine.kind == ir::RoutineKind::kInit) continue;
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      if (!region.valid()) continue;
      ir::ForEachInst(program, region, [&](ir::InstId id) {
        ir::ForEachAccess(
            program, program[id], [&](ir::PlaceId place, ir::Access) { note(place); }, [](ir::StateId) {});
      });
    }
  }
}

bool IsBookkeeping(const std::vector<Condition>& conditions, uint32_t number) {
  const Condition& condition = conditions[number];
  if (!condition.is_internal) return false;
  const bool has_statement =
      condition.statement.valid() || (condition.last_write && condition.last_write->statement.valid());
  return !has_statement &&
         std::ranges::all_of(condition.because, [&](uint32_t reason) { return IsBookkeeping(conditions, reason); });
}

Explanation Explain(const Subject& subject, const Frame& frame, std::span<const execute::CellId> cells,
                    const std::string& name) {
  const PartTerms part(subject.program, subject.cells, frame, cells);
  Explanation explanation;
  if (!part.refusal().empty()) {
    explanation.refusal = part.refusal();
    return explanation;
  }
  for (size_t i = 0; i < cells.size(); ++i) {
    if (part.Value(part.after()[i]) == CellAfter(subject, frame, cells[i])) continue;
    explanation.refusal = "the scan cannot be followed exactly";
    return explanation;
  }
  return Builder(subject, frame, part).Build(cells, name);
}

}  // namespace plcxx::explanation
