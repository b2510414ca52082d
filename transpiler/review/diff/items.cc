#include "transpiler/review/diff/items.h"

#include <algorithm>

#include "transpiler/ir/accesses.h"
#include "transpiler/ir/builder.h"
#include "transpiler/ir/op.h"
#include "transpiler/ir/place_names.h"
#include "transpiler/ir/uses.h"
#include "transpiler/scenarios/element_names.h"
#include "transpiler/symbolic/meaning/meaning.h"

namespace plcxx::review::diff {
namespace {

using execute::Cell;
using execute::CellId;
using execute::CellKind;
using execute::IsInside;
using prove::machine::Version;

/// Cells of a place; of an indexed one all that it may touch.
std::pair<uint32_t, uint32_t> CellRange(const Version& version, const ir::Place& place) {
  if (place.is_field()) {
    const ir::StateKind kind = version.program->states[place.state].kind;
    const uint32_t cell = version.cells.states[place.state.index] + meaning::FieldTermIndex(kind, place.field);
    return {cell, cell + 1};
  }
  const uint32_t size = version.program->spaces[place.space].bytes;
  if (place.indexed) {
    return {version.cells.OfBit(place.space, std::min(place.low, size), 0).index,
            version.cells.OfBit(place.space, std::min(place.high, size), 0).index};
  }
  if (place.offset + ir::Bytes(place.type) > size) return {0, 0};
  const uint32_t first = version.cells.OfBit(place.space, place.offset, 0).index;
  if (place.type == ir::Type::kBit) return {first + place.bit, first + place.bit + 1};
  return {first, first + 8 * ir::Bytes(place.type)};
}

/// Walks a routine's regions with the statement at work.
class AccessWalk {
 public:
  explicit AccessWalk(const Version& version) : version_(version), program_(*version.program) {}

  std::vector<StatementAccess> Run() {
    for (const ir::Routine& routine : program_.routines) {
      for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
        Walk(region, ir::StatementId());
      }
    }
    return std::move(accesses_);
  }

 private:
  void Walk(ir::RegionId region, ir::StatementId statement) {
    if (!region.valid()) return;
    for (const ir::InstId id : program_.regions[region].insts) {
      const ir::Inst& inst = program_[id];
      if (inst.op == ir::OpKind::kStatement) statement = ir::StatementId(inst.payload);
      Note(inst, statement);
      if (ir::Info(inst.op).effect != ir::Effect::kControl) continue;
      for (const ir::RegionId owned : ir::OwnedRegions(program_, inst)) Walk(owned, statement);
    }
  }

  void Note(const ir::Inst& inst, ir::StatementId statement) {
    const auto add = [&](const std::vector<CellId>& cells, bool writes) {
      if (cells.empty()) return;
      accesses_.push_back(
          {.statement = statement, .begin = cells.front().index, .end = cells.back().index + 1, .writes = writes});
    };
    const auto on_place = [&](ir::PlaceId place, ir::Access access) {
      const std::vector<CellId> cells = execute::TouchedCells(program_, version_.cells, program_.places[place]);
      if (access != ir::Access::kWrite) add(cells, false);
      if (access != ir::Access::kRead) add(cells, true);
    };
    const auto on_instance = [&](ir::StateId state) {
      const std::vector<CellId> cells = execute::CellsOfInstance(program_, version_.cells, state);
      add(cells, false);
      add(cells, true);
    };
    ir::ForEachAccess(program_, inst, on_place, on_instance);
    if (ir::Info(inst.op).shape != ir::Shape::kHostCall) return;
    const ir::Call& call = program_.calls[ir::CallId(inst.payload)];
    for (const CellId chain : version_.cells.ChainsOf(call.host, call.exchange)) add({chain}, true);
  }

  const Version& version_;
  const ir::Program& program_;
  std::vector<StatementAccess> accesses_;
};

}  // namespace

CellWords::CellWords(const Version& version, const compilation::Compilation& compilation)
    : version_(version),
      compilation_(compilation),
      compiled_names_(compilation.program),
      version_names_(*version.program) {
  const ir::Program& program = *version.program;
  for (const ir::Documentation& known : program.documentation) known_.emplace(known.address, &known);
  for (uint32_t i = 0; i < program.places.size(); ++i) {
    const ir::PlaceId id(i);
    const ir::Place& place = program.places[id];
    if (place.is_field() || place.indexed || place.name.empty()) continue;
    const auto [begin, end] = CellRange(version, place);
    if (begin == end) continue;
    if (place.type == ir::Type::kBit) {
      bits_.emplace(begin, id);
    } else {
      const auto [at, added] = words_.emplace(begin, id);
      if (!added && ir::Bytes(program.places[at->second].type) > ir::Bytes(place.type)) at->second = id;
    }
  }
}

/// Whether people say the name, not the address: a distance from the beginning of an area stands in no source.
bool CellWords::IsNamed(const ir::Place& place) const {
  if (place.name.empty() || place.address.find('+') == std::string::npos) return false;
  const auto [at, added] = is_named_.try_emplace(place.name, false);
  if (added) at->second = compilation_.dialect->locate(compiled_names_, place.name).has_value();
  return at->second;
}

CellWord CellWords::OfPlace(const ir::Place& place) const {
  const ir::Program& program = *version_.program;
  CellWord word{.name = ir::SourceName(place), .address = {}, .place = place, .cells = {}};
  if (IsNamed(place)) {
    word.name = place.name;
    word.address = place.address;
  }
  if (IsInside(program, place)) word.cells = execute::CellsOf(program, version_.cells, place);
  return word;
}

CellWord CellWords::WordOf(CellId id) const {
  const ir::Program& program = *version_.program;
  const Cell cell = execute::CellAt(program, version_.cells, id);
  if (cell.kind != CellKind::kBit) {
    CellWord word{.name = execute::CellName(program, cell), .address = {}, .place = std::nullopt, .cells = {id}};
    if (cell.kind != CellKind::kField) return word;
    const ir::FieldInfo& info = ir::Info(program.states[cell.state].kind).fields[cell.field];
    if (info.hidden) {
      // How a timer does it is the timer's own.
      word.name = program.states[cell.state].name;
    } else if (info.count == 1) {
      word.place = ir::Place{.name = word.name,
                             .type = ir::Info(program.states[cell.state].kind).fields[cell.field].type,
                             .state = cell.state,
                             .field = cell.field};
      // The program's own name for the field, where it has one.
      for (const ir::Place& place : program.places) {
        if (place.state == cell.state && place.field == cell.field && !ir::SourceName(place).empty())
          word.name = ir::SourceName(place);
      }
    }
    return word;
  }
  const uint32_t first_bit = id.index - cell.bit;
  if (const auto bit = bits_.find(id.index); bit != bits_.end()) return OfPlace(program.places[bit->second]);
  // The word that begins in this byte or in one of the seven before it.
  for (uint32_t back = 0; back < 8 && back <= cell.offset; ++back) {
    const auto word = words_.find(first_bit - 8 * back);
    if (word != words_.end() && ir::Bytes(program.places[word->second].type) > back) {
      return OfPlace(program.places[word->second]);
    }
  }
  if (const std::optional<ir::Place> named = scenarios::NamedElement(version_names_, *compilation_.dialect, cell))
    return OfPlace(*named);
  CellWord byte{.name = program.spaces[cell.space].name + " byte " + std::to_string(cell.offset),
                .address = {},
                .place = std::nullopt,
                .cells = {}};
  for (uint32_t bit = 0; bit < 8; ++bit) byte.cells.emplace_back(first_bit + bit);
  return byte;
}

std::string CellWords::MeaningOf(const CellWord& word) const {
  const bool has_address = !word.address.empty();
  std::string text = word.address;
  const auto found = known_.find(has_address ? word.address : word.name);
  if (found == known_.end()) return text;
  const ir::Documentation& known = *found->second;
  const std::string symbols = has_address && known.symbols == word.name ? std::string() : known.symbols;
  for (const std::string& part : {symbols, known.predefined, known.meaning, known.help}) {
    if (!part.empty()) text += (text.empty() ? "" : ", ") + part;
  }
  return text;
}

namespace {

/// Walks all routines with the statement that owns the region.
class HeadWalk {
 public:
  explicit HeadWalk(const ir::Program& program) : program_(program) {}

  StatementHeads Run() {
    for (uint32_t i = 0; i < program_.routines.size(); ++i) {
      routine_ = ir::RoutineId(i);
      const ir::Routine& routine = program_.routines[routine_];
      for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
        Walk(region, ir::StatementId());
      }
    }
    for (const auto& [statement, routine] : outermost_) {
      for (const ir::StatementId caller : callers_[routine]) Add(statement, caller);
    }
    return std::move(heads_);
  }

 private:
  void Add(ir::StatementId statement, ir::StatementId head) {
    if (head.valid() && head != statement) heads_[statement].insert(head);
  }

  void Walk(ir::RegionId region, ir::StatementId owner) {
    if (!region.valid()) return;
    ir::StatementId statement = owner;
    for (const ir::InstId id : program_.regions[region].insts) {
      const ir::Inst& inst = program_[id];
      if (inst.op == ir::OpKind::kStatement) {
        statement = ir::StatementId(inst.payload);
        Add(statement, owner);
        if (!owner.valid()) outermost_.emplace(statement, routine_);
      }
      if (inst.op == ir::OpKind::kCall) callers_[program_.calls[ir::CallId(inst.payload)].routine].insert(statement);
      if (ir::Info(inst.op).effect != ir::Effect::kControl) continue;
      for (const ir::RegionId owned : ir::OwnedRegions(program_, inst)) Walk(owned, statement);
    }
  }

  const ir::Program& program_;
  ir::RoutineId routine_;
  StatementHeads heads_;
  std::map<ir::StatementId, ir::RoutineId> outermost_;
  std::map<ir::RoutineId, std::set<ir::StatementId>> callers_;
};

}  // namespace

StatementHeads HeadsOf(const Version& version) { return HeadWalk(*version.program).Run(); }

StatementHeads NeededBy(const Version& version) {
  const ir::Program& program = *version.program;
  StatementHeads needed = HeadsOf(version);
  std::vector<ir::StatementId> statement_of(program.insts.size());
  const auto walk = [&](const auto& self, ir::RegionId region, ir::StatementId statement) -> void {
    if (!region.valid()) return;
    for (const ir::InstId id : program.regions[region].insts) {
      const ir::Inst& inst = program[id];
      if (inst.op == ir::OpKind::kStatement) statement = ir::StatementId(inst.payload);
      statement_of[id.index] = statement;
      ir::ForEachUse(program, inst, [&](uint32_t used) {
        const ir::StatementId source = statement_of[used];
        if (source.valid() && statement.valid() && source != statement) needed[statement].insert(source);
      });
      if (ir::Info(inst.op).effect != ir::Effect::kControl) continue;
      for (const ir::RegionId owned : ir::OwnedRegions(program, inst)) self(self, owned, statement);
    }
  };
  for (const ir::Routine& routine : program.routines) {
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue})
      walk(walk, region, ir::StatementId());
  }
  return needed;
}

std::set<ir::StatementId> WithNeeded(const StatementHeads& needed, const std::set<ir::StatementId>& statements) {
  std::set<ir::StatementId> all = statements;
  std::vector<ir::StatementId> open(statements.begin(), statements.end());
  while (!open.empty()) {
    const auto of = needed.find(open.back());
    open.pop_back();
    if (of == needed.end()) continue;
    for (const ir::StatementId one : of->second) {
      if (all.insert(one).second) open.push_back(one);
    }
  }
  return all;
}

std::vector<StatementAccess> AccessesOf(const Version& version) { return AccessWalk(version).Run(); }

}  // namespace plcxx::review::diff
