#include "transpiler/mutate/changes.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "transpiler/ir/bit_logic.h"
#include "transpiler/ir/builder.h"
#include "transpiler/ir/host_functions.h"
#include "transpiler/ir/name_index.h"
#include "transpiler/ir/place_names.h"
#include "transpiler/ir/uses.h"

namespace plcxx::mutate {
namespace {

constexpr size_t kMostQuoted = 40;  // bytes of the source that are shown for a value

bool IsInteger(ir::Type type) {
  return type == ir::Type::kI8 || type == ir::Type::kI16 || type == ir::Type::kI32 || type == ir::Type::kI64;
}

/// A bit that comes from somewhere: a contact, a comparison, what an instance or a call gives.
bool IsContact(const ir::Inst& inst) {
  return inst.type == ir::Type::kBit && inst.op != ir::OpKind::kConst && inst.op != ir::OpKind::kPoison &&
         !ir::IsBitLogic(inst);
}

class Finder {
 public:
  Finder(const ir::Program& program, const source::SourceManager& sources)
      : program_(program), sources_(sources), names_(program), uses_(program.insts.size()) {
    for (uint32_t i = 0; i < program.insts.size(); ++i) {
      ir::ForEachUse(program, program[ir::InstId(i)], [this](uint32_t value) { ++uses_[value]; });
    }
    for (uint32_t i = 0; i < program.statements.size(); ++i) {
      const uint32_t number = program.statements[ir::StatementId(i)].id;
      if (number != 0) statement_numbers_.insert(number);
    }
  }

  std::vector<Change> Find() {
    for (const ir::Routine& routine : program_.routines) {
      if (routine.simulation_only) continue;
      for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) Walk(region, {});
    }
    std::ranges::stable_sort(changes_, {}, [](const Change& change) { return change.statement.index; });
    return std::move(changes_);
  }

 private:
  void Walk(ir::RegionId region, ir::StatementId statement) {
    if (!region.valid()) return;
    for (const ir::InstId id : program_.regions[region].insts) {
      const ir::Inst& inst = program_[id];
      if (inst.op == ir::OpKind::kStatement) statement = ir::StatementId(inst.payload);
      if (statement.valid() && inst.op != ir::OpKind::kPoison) Visit(id, region, statement);
      if (ir::Info(inst.op).effect != ir::Effect::kControl) continue;
      for (const ir::RegionId owned : ir::OwnedRegions(program_, inst)) Walk(owned, statement);
    }
  }

  void Visit(ir::InstId id, ir::RegionId region, ir::StatementId statement) {
    const ir::Inst& inst = program_[id];
    if (IsExchange(inst)) return;
    at_ = {.kind = {},
           .statement = statement,
           .inst = id,
           .use = 0,
           .region = region,
           .becomes = {},
           .range = {},
           .text = {}};
    ir::ForEachUse(program_, inst, [this, &inst](uint32_t value) {
      Use(inst, ir::ValueId(value));
      ++at_.use;
    });
    at_.use = 0;
    for (const OperatorChange& change : OperatorChanges()) {
      if (change.from != inst.op) continue;
      at_.becomes = change.to;
      Add(ChangeKind::kOperator, inst.range, std::string(change.text));
    }
    if (const std::optional<std::string> text = TextOfLeftOut(inst)) {
      Add(ChangeKind::kLeftOut, inst.range, *text);
    }
  }

  bool IsExchange(const ir::Inst& inst) const {
    return ir::Info(inst.op).shape == ir::Shape::kHostCall && program_.calls[ir::CallId(inst.payload)].exchange;
  }

  void Use(const ir::Inst& user, ir::ValueId id) {
    const ir::Inst& value = program_[id];
    if (value.op == ir::OpKind::kConst) {
      if (!IsOfAFault(user, value)) UseOfConstant(value);
      return;
    }
    if (!IsContact(value)) return;
    const std::string name = NameOf(value);
    if (!StandsFor(user, ir::OpKind::kBitAnd)) Add(ChangeKind::kAlways0, value.range, name + " is always 0");
    if (!StandsFor(user, ir::OpKind::kBitOr)) Add(ChangeKind::kAlways1, value.range, name + " is always 1");
  }

  /// What a fault says of itself: its kind and the number of its statement, which lowering writes.
  bool IsOfAFault(const ir::Inst& user, const ir::Inst& constant) const {
    const ir::Shape shape = ir::Info(user.op).shape;
    if (shape != ir::Shape::kCall && shape != ir::Shape::kHostCall) return false;
    const ir::Call& call = program_.calls[ir::CallId(user.payload)];
    if (call.host.valid() && ir::ReportsFault(program_.host_functions[call.host])) return true;
    return constant.type == ir::Type::kI32 &&
           statement_numbers_.contains(static_cast<uint32_t>(ir::ConstantValue(constant)));
  }

  /// Whether an earlier operand of `user`, a series or a parallel circuit, has the same change already: the value that
  /// decides the result decides it from any operand.
  bool StandsFor(const ir::Inst& user, ir::OpKind op) const {
    return user.op == op && at_.use == 1 && Decides(ir::ValueId(user.a), op);
  }

  /// Whether some contact in `id` has the change that decides operation `op`.
  bool Decides(ir::ValueId id, ir::OpKind op) const {
    const ir::Inst& value = program_[id];
    if (IsContact(value)) return true;
    if (value.op != op || uses_[id.index] != 1) return false;
    return Decides(ir::ValueId(value.a), op) || Decides(ir::ValueId(value.b), op);
  }

  void UseOfConstant(const ir::Inst& constant) {
    const uint64_t number = ir::ConstantValue(constant);
    const std::string name = Spelled(constant.range).value_or(std::to_string(number));
    if (constant.type == ir::Type::kBit) {
      Add(number != 0 ? ChangeKind::kAlways0 : ChangeKind::kAlways1, constant.range,
          name + " becomes " + (number != 0 ? "0" : "1"));
      return;
    }
    if (!IsInteger(constant.type)) return;
    Add(ChangeKind::kMore, constant.range, name + " becomes one more");
    if (number != 0) Add(ChangeKind::kLess, constant.range, name + " becomes one less");
  }

  /// None: it cannot be left out, for its value is used or it has no effect of its own.
  std::optional<std::string> TextOfLeftOut(const ir::Inst& inst) const {
    switch (ir::Info(inst.op).shape) {
      case ir::Shape::kStore:
        return PlaceText(ir::PlaceId(inst.payload)) + " is not written";
      case ir::Shape::kStep:
        if (inst.type != ir::Type::kNone) return std::nullopt;
        return program_.states[ir::StateId(inst.payload)].name + " is not executed";
      case ir::Shape::kCall:
      case ir::Shape::kHostCall: {
        if (inst.type != ir::Type::kNone) return std::nullopt;
        const ir::Call& call = program_.calls[ir::CallId(inst.payload)];
        return (call.routine.valid() ? program_.routines[call.routine].name : program_.host_functions[call.host].name) +
               " is not called";
      }
      case ir::Shape::kPure:
      case ir::Shape::kConst:
      case ir::Shape::kLoad:
      case ir::Shape::kText:
      case ir::Shape::kStatement:
      case ir::Shape::kIf:
      case ir::Shape::kSwitch:
      case ir::Shape::kLoop:
      case ir::Shape::kBlock:
      case ir::Shape::kExit:
      case ir::Shape::kRepeat:
      case ir::Shape::kJump:
      case ir::Shape::kLabel:
        return std::nullopt;
    }
    return std::nullopt;
  }

  std::string NameOf(const ir::Inst& value) const {
    if (const std::optional<std::string> quoted = Quoted(value.range)) return *quoted;
    if (ir::Info(value.op).shape == ir::Shape::kLoad) return PlaceText(ir::PlaceId(value.payload));
    return "the condition";
  }

  /// What the source says there, where that is short.
  std::optional<std::string> Quoted(source::Range range) const {
    if (range.begin == range.end || range.end - range.begin > kMostQuoted) return std::nullopt;
    const std::string_view text = sources_.Text(range);
    if (text.empty() || text.find_first_of("\r\n") != std::string_view::npos) return std::nullopt;
    return std::string(text);
  }

  /// The same of a number; none where the source says no number there, for lowering made it of something else.
  std::optional<std::string> Spelled(source::Range range) const {
    std::optional<std::string> quoted = Quoted(range);
    const auto is_of_number = [](char c) {
      return std::string_view(".'_+-$%&#").find(c) != std::string_view::npos || IsAlphanumeric(c);
    };
    if (!quoted || !std::ranges::all_of(*quoted, is_of_number)) return std::nullopt;
    return quoted;
  }

  static bool IsAlphanumeric(char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
  }

  /// "U101K0 (M00)", where the source has a name for the address.
  std::string PlaceText(ir::PlaceId id) const {
    const std::string& address = ir::SourceName(program_.places[id]);
    const ir::Documentation* const known = names_.WithAddress(address);
    return known == nullptr || known->symbols.empty() ? address : address + " (" + known->symbols + ")";
  }

  void Add(ChangeKind kind, source::Range range, std::string text) {
    at_.kind = kind;
    at_.range = range.begin != 0 ? range : program_.statements[at_.statement].range;
    at_.text = std::move(text);
    changes_.push_back(at_);
  }

  const ir::Program& program_;
  const source::SourceManager& sources_;
  const ir::NameIndex names_;
  std::vector<uint32_t> uses_;  // by ValueId
  std::set<uint32_t> statement_numbers_;
  Change at_;  // of what is being looked at
  std::vector<Change> changes_;
};

uint64_t MaskOf(ir::Type type) {
  if (type == ir::Type::kI8) return 0xFF;
  if (type == ir::Type::kI16) return 0xFFFF;
  if (type == ir::Type::kI32) return 0xFFFF'FFFF;
  return ~uint64_t{0};
}

/// What is used instead of `value`.
uint64_t NumberInstead(ChangeKind kind, const ir::Inst& value) {
  switch (kind) {
    case ChangeKind::kAlways1:
      return 1;
    case ChangeKind::kMore:
      return (ir::ConstantValue(value) + 1) & MaskOf(value.type);
    case ChangeKind::kLess:
      return (ir::ConstantValue(value) - 1) & MaskOf(value.type);
    case ChangeKind::kAlways0:
    case ChangeKind::kOperator:
    case ChangeKind::kLeftOut:
      break;
  }
  return 0;
}

/// The word that names the value whose use is changed.
template <class AnyProgram>
auto* UseIn(AnyProgram& program, const Change& change) {
  decltype(&program[change.inst].a) used = nullptr;
  uint32_t use = 0;
  ir::ForEachUse(program, program[change.inst], [&](auto& word) {
    if (use++ == change.use) used = &word;
  });
  return used;
}

/// Puts a constant in the place of the value that is used there.
void PutConstant(const Change& change, ir::Program& program) {
  constexpr unsigned kHalf = 32;
  uint32_t* const used = UseIn(program, change);
  ir::Inst constant = program[ir::ValueId(*used)];
  const uint64_t number = NumberInstead(change.kind, constant);
  constant = {.op = ir::OpKind::kConst, .type = constant.type, .range = constant.range};
  constant.a = static_cast<uint32_t>(number);
  constant.b = static_cast<uint32_t>(number >> kHalf);
  *used = program.insts.size();  // before the table grows, and the word moves
  program.insts.Add(constant);
}

}  // namespace

std::string_view Name(ChangeKind kind) {
  switch (kind) {
    case ChangeKind::kAlways0:
      return "always-0";
    case ChangeKind::kAlways1:
      return "always-1";
    case ChangeKind::kMore:
      return "one-more";
    case ChangeKind::kLess:
      return "one-less";
    case ChangeKind::kOperator:
      return "operator";
    case ChangeKind::kLeftOut:
      return "left-out";
  }
  return {};
}

const std::vector<OperatorChange>& OperatorChanges() {
  static const std::vector<OperatorChange> kChanges = {
#define PLCXX_CHANGE(from, to, text) {ir::OpKind::k##from, ir::OpKind::k##to, text},
#include "transpiler/mutate/changes.def"
#undef PLCXX_CHANGE
  };
  return kChanges;
}

std::vector<Change> FindChanges(const ir::Program& program, const source::SourceManager& sources) {
  return Finder(program, sources).Find();
}

void Apply(const Change& change, ir::Program& program) {
  switch (change.kind) {
    case ChangeKind::kOperator:
      program[change.inst].op = change.becomes;
      break;
    case ChangeKind::kLeftOut:
      std::erase(program.regions[change.region].insts, change.inst);
      break;
    case ChangeKind::kAlways0:
    case ChangeKind::kAlways1:
    case ChangeKind::kMore:
    case ChangeKind::kLess:
      PutConstant(change, program);
      break;
  }
}

sim::ChangedInst AsExecuted(const Change& change, const ir::Program& program) {
  sim::ChangedInst executed{.id = change.inst, .region = change.region};
  switch (change.kind) {
    case ChangeKind::kOperator:
      executed.how = sim::ChangedHow::kOperation;
      executed.operation = change.becomes;
      break;
    case ChangeKind::kLeftOut:
      executed.how = sim::ChangedHow::kLeftOut;
      break;
    case ChangeKind::kAlways0:
    case ChangeKind::kAlways1:
    case ChangeKind::kMore:
    case ChangeKind::kLess:
      executed.how = sim::ChangedHow::kOperand;
      executed.use = change.use;
      executed.number = NumberInstead(change.kind, program[ir::ValueId(*UseIn(program, change))]);
      break;
  }
  return executed;
}

}  // namespace plcxx::mutate
