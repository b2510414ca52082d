#include "transpiler/dialects/hnc/analysis/summary.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "transpiler/dialects/hnc/analysis/registrations.h"
#include "transpiler/dialects/hnc/analysis/request_codes.h"
#include "transpiler/dialects/hnc/analysis/stores.h"
#include "transpiler/dialects/hnc/machine/machine.h"
#include "transpiler/dialects/hnc/syntax/walk.h"

namespace plcxx::hnc {
namespace {

using dialects::SummaryTable;
using Names = std::set<std::string>;

constexpr int64_t kAlarmOffset = 2 * 251;  // sys_ext_alm in G, bytes
constexpr uint32_t kAlarms = 15;

std::string Joined(const Names& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
  return text;
}

/// Who reads and who writes something, and which of its bits.
struct Uses {
  Names readers, writers;
  uint64_t read_bits = 0, written_bits = 0;
  uint8_t parts = 0;
};

class Summary {
 public:
  Summary(const Unit& unit, const Objects& objects, const Facts& facts, const ir::Program& program,
          const source::SourceManager& sources)
      : unit_(unit), objects_(objects), facts_(facts), program_(program), sources_(sources) {
    std::set<std::string_view> macros;  // other names of cells are made from their addresses
    for (const Macro& macro : unit.macros) macros.insert(macro.name);
    for (const ir::Documentation& known : program.documentation) {
      if (macros.contains(known.symbols)) symbols_.emplace(known.address, known.symbols);
    }
  }

  std::vector<SummaryTable> Tables() {
    for (const FunctionId id : unit_.definitions) {
      if (facts_.PartsOf(id) != 0) Collect(id);
    }
    std::vector<SummaryTable> tables = {Handlers(), std::move(alarms_), std::move(codes_)};
    tables.push_back(OutputBits());
    tables.push_back(Parameters());
    tables.push_back(Cells());
    tables.push_back(Variables());
    tables.push_back(Limits());
    std::ranges::stable_sort(tables[1].rows, {}, [](const auto& row) { return std::stoi(row[0]); });
    return tables;
  }

 private:
  std::string PlaceOf(source::Range range) const {
    const source::Position at = sources_.Locate(range.begin);
    if (!at.file.valid()) return "";
    return std::filesystem::path(sources_.Get(at.file).path).filename().string() + ":" + std::to_string(at.line);
  }

  static std::string PartNames(uint8_t parts) {
    Names names;
    if ((parts & kPartInit) != 0) names.insert("init");
    if ((parts & kPartFast) != 0) names.insert("plc1");
    if ((parts & kPartSlow) != 0) names.insert("plc2");
    return Joined(names);
  }

  // --- what single expressions tell ---

  void Collect(FunctionId id) {
    const Function& function = unit_.functions[id];
    std::map<uint32_t, uint64_t> masks;  // by ExprId of a load: the bits that are looked at
    ForEachExprIn(unit_, function.body, [&](ExprId part) {
      const Expr& expr = unit_.expressions[part];
      if (expr.kind == ExprKind::kBinary && expr.binary == BinaryOp::kBitAnd) NoteMask(expr, masks);
      if (IsStore(expr)) NoteStore(id, expr);
      if (expr.kind == ExprKind::kLoad) {
        const auto mask = masks.find(part.index);
        NoteRead(id, expr, mask == masks.end() ? ~uint64_t{0} : mask->second);
      }
    });
    NoteCodes(id);
  }

  void NoteMask(const Expr& expr, std::map<uint32_t, uint64_t>& masks) const {
    for (const auto& [value, other] : {std::pair(expr.a, expr.b), std::pair(expr.b, expr.a)}) {
      if (!unit_.expressions[other].constant) continue;
      ExprId load = value;
      while (unit_.expressions[load].kind == ExprKind::kConvert) load = unit_.expressions[load].a;
      if (unit_.expressions[load].kind == ExprKind::kLoad) {
        masks[load.index] = static_cast<uint64_t>(unit_.expressions[other].constant->integer);
      }
    }
  }

  Uses& CellAt(ObjectId object, int64_t offset, uint32_t size) { return cells_[{object.index, offset, size}]; }

  void NoteStore(FunctionId id, const Expr& store) {
    const std::string& name = unit_.functions[id].name;
    for (const ObjectId object : facts_.ObjectsOf(store.a).objects) {
      Uses& uses = variables_[object.index];
      uses.writers.insert(name);
      if (store.kind != ExprKind::kAssign) uses.readers.insert(name);
      uses.parts |= facts_.PartsOf(id);
    }
    const std::optional<ChangedBits> changed = ChangedBy(unit_, facts_, store);
    if (!changed || objects_[changed->object].kind != ObjectKind::kArea) return;
    Uses& cell = CellAt(changed->object, changed->offset, changed->size);
    cell.writers.insert(name);
    cell.written_bits |= changed->mask;
    cell.parts |= facts_.PartsOf(id);
    NoteOutputs(id, *changed);
    if (objects_.IsArea(changed->object, Area::kG)) NoteAlarms(*changed, store);
  }

  void NoteOutputs(FunctionId id, const ChangedBits& changed) {
    const AreaRow* area = AreaOf(changed.object.index);
    if (area->area != Area::kY && area->area != Area::kG) return;
    for (uint32_t bit = 0; bit < 8 * changed.size; ++bit) {
      if ((changed.mask >> bit & 1) == 0) continue;
      const int64_t byte = changed.offset + bit / 8, in_group = byte % BytesOf(*area) * 8 + bit % 8;
      Uses& uses = outputs_[{changed.object.index, byte / BytesOf(*area), in_group}];
      uses.writers.insert(unit_.functions[id].name);
      uses.parts |= facts_.PartsOf(id);
    }
  }

  void NoteRead(FunctionId id, const Expr& load, uint64_t mask) {
    if (!IsArithmetic(unit_.types[load.type])) return;  // an element of a pointer table, which is a constant
    const std::string& name = unit_.functions[id].name;
    for (const ObjectId object : facts_.ObjectsOf(load.a).objects) {
      variables_[object.index].readers.insert(name);
      variables_[object.index].parts |= facts_.PartsOf(id);
    }
    const std::optional<StaticAddress> at = facts_.AddressOf(load.a);
    const uint32_t size = unit_.types[load.type].size;
    if (!at || objects_[at->object].kind != ObjectKind::kArea || size == 0 || size > 4) return;
    Uses& cell = CellAt(at->object, at->offset, size);
    cell.readers.insert(name);
    cell.read_bits |= mask & ((uint64_t{1} << (8 * size)) - 1);
    cell.parts |= facts_.PartsOf(id);
  }

  /// Bits that a constant raises; what clears them is no alarm.
  void NoteAlarms(const ChangedBits& changed, const Expr& store) {
    if (store.kind == ExprKind::kIncrement) return;
    const std::optional<Constant>& constant = unit_.expressions[store.b].constant;
    const bool clears = store.kind == ExprKind::kCompoundAssign && store.binary == BinaryOp::kBitAnd;
    if (!constant || clears) return;
    const uint64_t bits = static_cast<uint64_t>(constant->integer) & changed.mask;
    for (uint32_t bit = 0; bit < kAlarms; ++bit) {
      const int64_t byte = kAlarmOffset + bit / 8;
      if (byte < changed.offset || byte >= changed.offset + changed.size) continue;
      if ((bits >> (8 * (kAlarmOffset - changed.offset) + bit) & 1) == 0) continue;
      const Comment* comment = CommentBehind(unit_, sources_, store.range.end);
      std::string text = comment == nullptr ? "" : comment->text;
      std::ranges::replace_if(text, [](char c) { return c == '\n' || c == '\r'; }, ' ');
      alarms_.rows.push_back({std::to_string(bit + 1), std::to_string(bit), PlaceOf(store.range), text});
    }
  }

  void NoteCodes(FunctionId id) {
    for (const RequestCode& code : RequestCodes(unit_, objects_, facts_, id)) {
      const std::string last = code.last == code.first ? "" : "-" + std::to_string(code.last);
      codes_.rows.push_back({std::string(1, kHandlerKinds[code.kind]), std::to_string(code.first) + last,
                             unit_.functions[id].name, PlaceOf(code.place)});
    }
  }

  // --- tables ---

  SummaryTable Handlers() const {
    SummaryTable table{
        "handlers", "Handlers of M, S, T, B requests and of E", {"channel", "kind", "function", "when", "place"}, {}};
    const FixedHandlers fixed = FindFixedHandlers(unit_, facts_);
    for (const Registration& registration : facts_.registrations()) {
      const bool always = fixed[registration.channel][registration.kind].has_value();
      table.rows.push_back({std::to_string(registration.channel), std::string(1, kHandlerKinds[registration.kind]),
                            registration.function.valid() ? unit_.functions[registration.function].name : "none",
                            always ? "always" : "at run time", PlaceOf(unit_.expressions[registration.call].range)});
    }
    return table;
  }

  const AreaRow* AreaOf(uint32_t object) const {
    if (objects_[ObjectId(object)].kind != ObjectKind::kArea) return nullptr;
    return &Areas()[object];
  }
  /// Of a group.
  static uint32_t BytesOf(const AreaRow& area) { return area.basic == "unsigned char" ? 1 : 2; }

  SummaryTable OutputBits() const {
    SummaryTable table{"outputs", "Bits of Y and G that are written", {"bit", "written by", "parts"}, {}};
    for (const auto& [key, uses] : outputs_) {
      const auto& [object, group, bit] = key;
      table.rows.push_back({std::string(AreaOf(object)->name) + std::to_string(group) + "." + std::to_string(bit),
                            Joined(uses.writers), PartNames(uses.parts)});
    }
    return table;
  }

  std::string CellName(uint32_t object, int64_t offset, uint32_t size) const {
    const AreaRow& area = *AreaOf(object);
    const uint32_t basic = BytesOf(area);
    const uint32_t stride = area.table ? 2 : size;
    std::string name(area.name);
    if (size != basic) name += size == 1 ? "_uc" : size == 2 ? "_ui" : "_ul";
    if (offset % stride != 0) return name + " at byte " + std::to_string(offset);
    return name + "[" + std::to_string(offset / stride) + "]";
  }

  std::string SymbolOf(const std::string& address) const {
    const auto found = symbols_.find(address);
    return found == symbols_.end() ? "" : std::string(found->second);
  }

  SummaryTable Parameters() const {
    SummaryTable table{"parameters", "User parameters that are read", {"parameter", "name", "read by"}, {}};
    for (const auto& [cell, uses] : cells_) {
      const auto& [object, offset, size] = cell;
      if (!objects_.IsArea(ObjectId(object), Area::kP) || uses.readers.empty()) continue;
      const std::string name = CellName(object, offset, size);
      table.rows.push_back({name, SymbolOf(name), Joined(uses.readers)});
    }
    return table;
  }

  static std::string Bits(uint64_t bits, uint32_t size) {
    if (bits == 0) return "";
    if (bits == (uint64_t{1} << (8 * size)) - 1) return "all";
    std::string text;
    for (uint32_t bit = 0; bit < 8 * size; ++bit) {
      if ((bits >> bit & 1) != 0) text += (text.empty() ? "" : " ") + std::to_string(bit);
    }
    return text;
  }

  SummaryTable Cells() const {
    SummaryTable table{"cells",
                       "Register cells with constant addresses",
                       {"cell", "name", "bits read", "read by", "bits written", "written by", "parts"},
                       {}};
    for (const auto& [cell, uses] : cells_) {
      const auto& [object, offset, size] = cell;
      const std::string name = CellName(object, offset, size);
      table.rows.push_back({name, SymbolOf(name), Bits(uses.read_bits, size), Joined(uses.readers),
                            Bits(uses.written_bits, size), Joined(uses.writers), PartNames(uses.parts)});
    }
    return table;
  }

  SummaryTable Variables() {
    SummaryTable table{"variables",
                       "Global and static variables",
                       {"name", "type", "initial value", "read by", "written by", "parts"},
                       {}};
    for (uint32_t i = 0; i < objects_.size(); ++i) {
      const Object& object = objects_[ObjectId(i)];
      if (object.kind != ObjectKind::kVariable) continue;
      const Variable& variable = unit_.variables[VariableId(object.index)];
      if (variable.storage != Storage::kGlobal && variable.storage != Storage::kStaticLocal) continue;
      std::string initial = "0";
      if (variable.initialised && variable.initial.size() == 1 && variable.initial.front().value.valid()) {
        initial = sources_.Text(unit_.expressions[variable.initial.front().value].range);
      } else if (variable.initialised) {
        initial = "{...}";
      }
      const Uses& uses = variables_[i];
      table.rows.push_back({object.name, unit_.types[variable.type].text, initial, Joined(uses.readers),
                            Joined(uses.writers), PartNames(uses.parts)});
    }
    return table;
  }

  /// The most rounds of a loop in the region, those around it multiplied in.
  uint64_t Rounds(ir::RegionId region, uint64_t around) const {
    if (!region.valid()) return 0;
    uint64_t most = 0;
    for (const ir::InstId id : program_.regions[region].insts) {
      const ir::Inst& inst = program_[id];
      if (inst.op == ir::OpKind::kIf) {
        most = std::max({most, Rounds(ir::RegionId(inst.b), around), Rounds(ir::RegionId(inst.c), around)});
      } else if (inst.op == ir::OpKind::kBlock) {
        most = std::max(most, Rounds(ir::RegionId(inst.a), around));
      } else if (inst.op == ir::OpKind::kSwitch) {
        for (const ir::SwitchCase& one : program_.switches[ir::SwitchId(inst.payload)].cases) {
          most = std::max(most, Rounds(one.region, around));
        }
      } else if (inst.op == ir::OpKind::kLoop) {
        const ir::Loop& loop = program_.loops[ir::LoopId(inst.payload)];
        const uint64_t all = around * std::max<uint64_t>(1, loop.bound);
        most = std::max({most, all, Rounds(loop.body, all)});
      }
    }
    return most;
  }

  /// Calls below a function; 0: it calls none of the program's.
  uint32_t Depth(FunctionId id) {
    const auto [known, added] = depths_.emplace(id.index, 0);
    if (!added) return known->second;
    uint32_t depth = 0;
    for (const FunctionId callee : facts_.CalleesOf(id)) {
      if (unit_.functions[callee].is_defined) depth = std::max(depth, Depth(callee) + 1);
    }
    return depths_[id.index] = depth;
  }

  SummaryTable Limits() {
    SummaryTable table{"limits", "Loops and calls", {"function", "parts", "most rounds of a loop", "calls below"}, {}};
    std::map<std::string_view, ir::RegionId> bodies;  // by the name of the routine
    for (const ir::Routine& routine : program_.routines) {
      if (routine.kind == ir::RoutineKind::kSubroutine) bodies[routine.name] = routine.body;
    }
    for (const FunctionId id : unit_.definitions) {
      if (facts_.PartsOf(id) == 0) continue;
      const auto body = bodies.find(id == unit_.init ? "plc_init" : unit_.functions[id].name);
      const uint64_t rounds = body == bodies.end() ? 0 : Rounds(body->second, 1);
      table.rows.push_back(
          {unit_.functions[id].name, PartNames(facts_.PartsOf(id)), std::to_string(rounds), std::to_string(Depth(id))});
    }
    return table;
  }

  const Unit& unit_;
  const Objects& objects_;
  const Facts& facts_;
  const ir::Program& program_;
  const source::SourceManager& sources_;
  std::map<std::string_view, std::string_view> symbols_;            // by address
  std::map<std::tuple<uint32_t, int64_t, uint32_t>, Uses> cells_;   // by area object, byte, bytes
  std::map<std::tuple<uint32_t, int64_t, int64_t>, Uses> outputs_;  // by area object, group, bit
  std::map<uint32_t, Uses> variables_;                              // by ObjectId
  std::map<uint32_t, uint32_t> depths_;                             // by FunctionId
  SummaryTable alarms_{"alarms", "User alarms that constants raise", {"alarm", "bit", "place", "comment"}, {}};
  SummaryTable codes_{
      "codes", "Codes of requests that switches and comparisons name", {"kind", "code", "function", "place"}, {}};
};

}  // namespace

std::vector<SummaryTable> SummaryTables(const Unit& unit, const Objects& objects, const Facts& facts,
                                        const ir::Program& program, const source::SourceManager& sources) {
  return Summary(unit, objects, facts, program, sources).Tables();
}

}  // namespace plcxx::hnc
