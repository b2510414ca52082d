// Statements: each one of C is a statement of the IR, heads of ifs, loops and switches included, so that the structure
// and the comments of the source survive.

#include <algorithm>
#include <utility>

#include "transpiler/dialects/hnc/characters.h"
#include "transpiler/dialects/hnc/lowering_internal.h"

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

namespace {

constexpr uint32_t kMostPlainStores = 16;  // that clear an array one by one

/// The lines of a comment without its marks and the decoration of its left edge.
void AddLines(std::string_view text, source::Offset begin, std::vector<source::Range>& to) {
  const bool block = text.starts_with("/*");
  size_t at = 2;
  const size_t stop = block && text.size() >= 4 ? text.size() - 2 : text.size();
  while (at < stop) {
    size_t end = text.find_first_of("\r\n", at);
    if (end == std::string_view::npos) end = stop;
    size_t first = at, last = end;
    while (first < last && (IsBlank(text[first]) || (block && text[first] == '*'))) ++first;
    while (last > first && (IsBlank(text[last - 1]) || (block && text[last - 1] == '*'))) --last;
    if (first < last) {
      to.push_back({begin + static_cast<source::Offset>(first), begin + static_cast<source::Offset>(last)});
    }
    at = end + 1;
  }
}

}  // namespace

/// Comments in front of `until` that no statement has taken yet.
void Lowering::TakeComments(source::Offset until, std::vector<source::Range>& to) {
  while (next_comment_ < unit_.comments.size() && unit_.comments[next_comment_].range.begin < until) {
    const Comment& comment = unit_.comments[next_comment_++];
    AddLines(sources_.Text(comment.range), comment.range.begin, to);
  }
}

std::string Lowering::SubjectOf(const Statement& statement) const {
  ExprId id = statement.expression;
  for (int depth = 0; id.valid() && depth < 16; ++depth) {
    const Expr& expr = ExprAt(id);
    switch (expr.kind) {
      case ExprKind::kVariable:
        return unit_.variables[expr.variable].name;
      case ExprKind::kCall:
        if (expr.function.valid()) return unit_.functions[expr.function].name;
        return function_->name;
      default:
        if (!expr.a.valid()) return function_->name;
        id = expr.a;
    }
  }
  return function_->name;
}

void Lowering::MarkText(source::Range range, const std::string& subject, bool opens_block) {
  dialects::TextHash hash;
  for (const char c : function_->name) hash.Add(c);
  hash.Add(' ');
  for (const char c : sources_.Text(range)) {
    if (!IsBlank(c)) hash.Add(c);
  }
  const source::Position position = sources_.Locate(range.begin);
  const source::Position end = sources_.Locate(range.end);
  const source::File& file = sources_.Get(end.file);
  const std::string_view rest = sources_.Line(end.file, end.line);
  const source::Offset line_end = file.base + file.line_starts[end.line - 1] + static_cast<source::Offset>(rest.size());
  ir::Statement statement{.range = range,
                          .comments = {},
                          .subject = subject,
                          .id = statement_ids_.Next(hash),
                          .line = position.line,
                          .opens_block = opens_block};
  TakeComments(std::max(range.end, line_end), statement.comments);
  statement_id_ = statement.id;
  statement_range_ = range;
  builder_.SetRange(range);
  builder_.Statement(program_.statements.Add(std::move(statement)));
}

void Lowering::Mark(StatementId id, source::Range range, bool opens_block) {
  // What one use of a macro makes has one text: the statement around it has shown it.
  const MacroUseId macro = unit_.statements[id].macro;
  if (macro.valid() && macro == marked_macro_) return;
  marked_macro_ = macro;
  MarkText(range, SubjectOf(unit_.statements[id]), opens_block);
}

/// What stands before a closing brace belongs to no statement.
void Lowering::CommentsAtEnd(source::Range close) {
  if (next_comment_ >= unit_.comments.size() || unit_.comments[next_comment_].range.begin >= close.begin) return;
  MarkText({close.begin, close.begin}, "", false);
}

void Lowering::JumpTo(uint32_t label) {
  if (!flow_.reachable) return;
  builder_.Jump(label);
  Target& target = targets_[label];
  if (!target.used) {
    target = {.label = label, .at = flow_, .used = true};
  } else {
    target.at.JoinWith(flow_);
  }
  flow_.reachable = false;
}

void Lowering::PlaceLabel(uint32_t label) {
  const auto found = targets_.find(label);
  if (found == targets_.end() || !found->second.used) return;
  builder_.Label(label);
  flow_.JoinWith(found->second.at);
  targets_.erase(found);
}

void Lowering::Lower(StatementId id, bool last) {
  if (!id.valid()) return;
  const Statement& statement = unit_.statements[id];
  if (!flow_.reachable && !IsEntered(id)) {
    const bool says_nothing = statement.kind == StatementKind::kEmpty ||
                              statement.kind == StatementKind::kDeclaration ||
                              (statement.kind == StatementKind::kCompound && statement.body.empty());
    if (!says_nothing && !unreachable_reported_) {
      unreachable_reported_ = true;
      const bool compound = statement.kind == StatementKind::kCompound;
      diagnostics_.Report(compound ? unit_.statements[statement.body.front()].range : statement.head,
                          diag::HncUnreachable);
    }
    return;
  }
  // One warning for what is unreachable in a row: a statement that is reached ends the row.
  unreachable_reported_ = false;
  LowerReached(id, statement, last);
  unreachable_reported_ = false;
}

void Lowering::LowerReached(StatementId id, const Statement& statement, bool last) {
  switch (statement.kind) {
    case StatementKind::kCompound:
      Compound(statement, last);
      return;
    case StatementKind::kDeclaration:
      Declaration(statement);
      return;
    case StatementKind::kExpression:
      Mark(id, statement.range, false);
      Execute(statement.expression);
      return;
    case StatementKind::kEmpty:
      return;
    case StatementKind::kIf:
      If(id, statement, last);
      return;
    case StatementKind::kSwitch:
      Mark(id, statement.head, false);
      SwitchStatement(statement);
      return;
    case StatementKind::kWhile:
    case StatementKind::kDo:
    case StatementKind::kFor:
      Mark(id, statement.head, true);
      LoopStatement(statement);
      return;
    case StatementKind::kGoto:
      Mark(id, statement.range, false);
      Goto(statement);
      return;
    case StatementKind::kContinue:
      for (size_t i = around_.size(); i-- > 0;) {
        if (!around_[i].is_loop) continue;
        JumpTo(around_[i].on_continue);
        return;
      }
      return;
    case StatementKind::kBreak:
      if (id == elided_break_) {
        // The end of a case needs no jump to where the switch ends.
        if (flow_.reachable) end_of_switch_.push_back(flow_);
        flow_.reachable = false;
        return;
      }
      if (!around_.empty()) JumpTo(around_.back().on_break);
      return;
    case StatementKind::kReturn:
      Mark(id, statement.range, false);
      Return(statement, last);
      return;
    case StatementKind::kLabel:
      LabelStatement(statement, last);
      return;
    case StatementKind::kCase:
    case StatementKind::kDefault: {
      // Of a switch whose labels lie deeper than its body: see FlatSwitch.
      const auto label = case_labels_.find(id.index);
      if (label != case_labels_.end()) PlaceLabel(label->second);
      Lower(statement.then, last);
      return;
    }
    case StatementKind::kCriticalEnter:
    case StatementKind::kCriticalLeave: {
      Mark(id, statement.range, false);
      const bool enters = statement.kind == StatementKind::kCriticalEnter;
      flow_.critical = enters ? std::optional(statement.range) : std::nullopt;
      builder_.Store(CriticalFlag(), builder_.Bit(enters ? 1 : 0));
      CallCritical(enters ? "critical_enter" : "critical_leave");
      return;
    }
  }
}

void Lowering::LowerBody(const std::vector<StatementId>& body, bool last) {
  for (size_t i = 0; i < body.size(); ++i) Lower(body[i], last && i + 1 == body.size());
}

/// The automatic variables of a block that is entered at its beginning alone have no value there, and are forgotten at
/// its end: each branch copies and joins what has no value yet.
void Lowering::Compound(const Statement& statement, bool last) {
  const auto for_each_own = [&](auto visit) {
    for (const StatementId part : statement.body) {
      if (unit_.statements[part].kind != StatementKind::kDeclaration) continue;
      for (const VariableId id : unit_.statements[part].variables) {
        if (block_locals_.contains(id.index)) visit(id);
      }
    }
  };
  for_each_own([&](VariableId id) { flow_.unassigned.insert(id); });
  LowerBody(statement.body, last);
  for_each_own([&](VariableId id) { flow_.unassigned.erase(id); });
  CommentsAtEnd(statement.close);
}

void Lowering::ClearObject(ObjectId object) {
  const uint32_t size = objects_[object].size;
  if (size == 0) return;
  if (size <= 4 * kMostPlainStores) {
    for (uint32_t at = 0; at < size;) {
      const ir::Type width = size - at >= 4 ? ir::Type::kI32 : size - at >= 2 ? ir::Type::kI16 : ir::Type::kI8;
      builder_.Store(PlaceAt(object, at, width), builder_.Constant(width, 0));
      at += ir::Bytes(width);
    }
    return;
  }
  const ir::PlaceId at = AddLocal("clear", ir::Type::kI32);
  builder_.Store(at, Long(0));
  ir::Loop loop{.kind = ir::LoopBound::kProven,
                .bound = size,
                .budget = {},
                .condition = builder_.NewRegion(),
                .body = builder_.NewRegion(),
                .step = builder_.NewRegion(),
                .exhausted = {}};
  builder_.Into(loop.condition, [&] { Pure(OpKind::kLess32, {builder_.Load(at), Long(size)}); });
  builder_.Into(loop.body, [&] {
    builder_.Store(IndexedPlaceAt(object, 0, 1, ir::Type::kI8), builder_.Constant(ir::Type::kI8, 0), builder_.Load(at));
  });
  builder_.Into(loop.step, [&] { builder_.Increment(at); });
  builder_.LoopWith(loop);
}

void Lowering::Initialise(VariableId id) {
  const Variable& variable = unit_.variables[id];
  flow_.unassigned.erase(id);
  const Type& type = TypeAt(variable.type);
  if (type.kind == TypeKind::kPointer) {
    if (!variable.initial.empty()) StorePointer(id, EvaluatePointer(variable.initial.front().value));
    return;
  }
  if (local_places_[id.index].valid()) {
    if (variable.initial.empty()) return;
    Lvalue target;
    target.local = id;
    target.type = variable.type;
    Store(target, Convert(Evaluate(variable.initial.front().value), variable.type));
    return;
  }
  uint32_t filled = 0;
  for (const InitialValue& initial : variable.initial) filled += TypeAt(initial.type).size;
  if (filled < type.size) ClearObject(objects_.OfVariable(id));
  for (const InitialValue& initial : variable.initial) {
    Lvalue target;
    target.address.targets.Add(objects_.OfVariable(id));
    target.address.base = initial.offset;
    target.type = initial.type;
    const Type& part = TypeAt(initial.type);
    if (part.kind == TypeKind::kArray) {
      if (ExprAt(initial.value).kind != ExprKind::kString) continue;
      const std::string& bytes = unit_.strings[ExprAt(initial.value).string];
      for (uint32_t i = 0; i < part.size; ++i) {
        Address at = target.address;
        at.base += i;
        const uint8_t byte = i < bytes.size() ? static_cast<uint8_t>(bytes[i]) : uint8_t{0};
        StoreAt(at, ir::Type::kI8, builder_.Constant(ir::Type::kI8, byte), {});
      }
    } else if (part.kind == TypeKind::kRecord) {
      AssignRecord(target.address, RecordAddress(initial.value), initial.type);
    } else if (part.kind == TypeKind::kPointer) {
      if (const auto pointee = facts_.PointeeOf(initial.value)) {
        StoreAt(target.address, ir::Type::kI16, Word(NumberOf(pointee->object)), {});
      }
    } else {
      Member field;
      if (initial.is_bit_field) {
        field = {.name = "",
                 .type = initial.type,
                 .offset = 0,
                 .is_bit_field = true,
                 .bit_offset = initial.bit_offset,
                 .bit_width = initial.bit_width,
                 .range = {}};
        target.bit_field = &field;
      }
      Store(target, Convert(Evaluate(initial.value), initial.type));
    }
  }
  flow_.Forget(objects_.OfVariable(id));
}

void Lowering::Declaration(const Statement& statement) {
  bool marked = false;
  for (const VariableId id : statement.variables) {
    const Variable& variable = unit_.variables[id];
    if (variable.storage != Storage::kAutomatic || !variable.initialised) continue;
    if (!flow_.reachable) continue;
    if (!marked) MarkText(statement.range, variable.name, false);
    marked = true;
    Initialise(id);
  }
}

void Lowering::If(StatementId id, const Statement& statement, bool last) {
  Mark(id, statement.head, true);
  if (flat_.contains(id.index)) {
    FlatIf(statement);
    return;
  }
  const ValueId condition = Condition(statement.expression);
  const Flow before = flow_;
  Flow then;
  const auto lower_then = [&] {
    Refine(statement.expression, true);
    Lower(statement.then, last);
    then = flow_;
  };
  if (statement.otherwise.valid()) {
    builder_.Choose(condition, lower_then, [&] {
      flow_ = before;
      Refine(statement.expression, false);
      Lower(statement.otherwise, last);
    });
  } else {
    builder_.When(condition, lower_then);
    flow_ = before;
    Refine(statement.expression, false);
  }
  flow_.JoinWith(then);
}

/// A goto or a case leads into one of its arms: both lie in the list of the if itself.
void Lowering::FlatIf(const Statement& statement) {
  const uint32_t otherwise = NewLabel(), end = NewLabel();
  const bool entered = flow_.reachable;
  if (entered) {
    const ValueId condition = Condition(statement.expression);
    const Flow before = flow_;
    Refine(statement.expression, false);
    builder_.Jump(otherwise, Pure(OpKind::kBitNot, {condition}));
    targets_[otherwise] = {.label = otherwise, .at = flow_, .used = true};
    flow_ = before;
    Refine(statement.expression, true);
  }
  Lower(statement.then, false);
  if (statement.otherwise.valid()) {
    JumpTo(end);
    PlaceLabel(otherwise);
    Lower(statement.otherwise, false);
    PlaceLabel(end);
  } else {
    PlaceLabel(otherwise);
  }
}

/// W9: a way out on which nothing ends what `asm cli` began.
void Lowering::LeaveFunction() {
  if (flow_.reachable && flow_.critical) diagnostics_.Report(*flow_.critical, diag::HncCliWithoutSti);
  flow_.critical.reset();
}

void Lowering::Return(const Statement& statement, bool last) {
  const Type& result = TypeAt(function_->result);
  if (statement.expression.valid() && result.kind == TypeKind::kPointer) {
    const Address address = EvaluatePointer(statement.expression);
    for (const ObjectId object : address.targets.objects) {
      const Object& target = objects_[object];
      if (target.kind != ObjectKind::kVariable) continue;
      const Variable& pointee = unit_.variables[VariableId(target.index)];
      const bool local = pointee.storage == Storage::kAutomatic || pointee.storage == Storage::kParameter;
      if (local && pointee.function == function_id_) {
        diagnostics_.Report(statement.range, diag::HncLocalAddress, pointee.name);
      }
    }
    const PointerPlaces& places = result_pointers_[function_id_.index];
    if (places.object.valid()) builder_.Store(places.object, ObjectOf(address));
    builder_.Store(result_, OffsetOf(address));
  } else if (statement.expression.valid() && result.kind == TypeKind::kRecord) {
    Address to;
    to.targets.Add(objects_.OfResult(function_id_));
    AssignRecord(to, RecordAddress(statement.expression), function_->result);
  } else if (statement.expression.valid() && result_.valid()) {
    const Value value = Convert(Evaluate(statement.expression), function_->result);
    builder_.Store(result_, value.id);
    if (IsInteger(result)) {
      result_bounds_ = result_bounds_ ? Join(*result_bounds_, value.bounds) : value.bounds;
    }
  } else if (statement.expression.valid()) {
    Execute(statement.expression);
  } else {
    StoreNoResult();
    if (result_.valid()) result_bounds_ = result_bounds_ ? Join(*result_bounds_, {0, 0}) : Bounds{0, 0};
  }
  LeaveFunction();
  const bool entry = function_id_ == unit_.init || function_id_ == unit_.plc1 || function_id_ == unit_.plc2;
  if (!statement.expression.valid() && result.kind != TypeKind::kVoid && !entry) {
    diagnostics_.Report(statement.range, diag::HncNoReturnValue, function_->name);
  }
  if (last) {
    flow_.reachable = false;
  } else {
    JumpTo(end_label_);
  }
}

/// The cell that an operand of a comparison reads, perhaps converted without a change of its value.
std::optional<Cell> Lowering::CellOfRead(ExprId id) const {
  while (id.valid() && ExprAt(id).kind == ExprKind::kConvert) {
    const Type& from = unit_.TypeOf(ExprAt(id).a);
    const Type& to = unit_.TypeOf(id);
    if (!IsInteger(from) || !IsInteger(to) || !BoundsOf(from).Within(BoundsOf(to))) return std::nullopt;
    id = ExprAt(id).a;
  }
  if (!id.valid() || ExprAt(id).kind != ExprKind::kLoad || !IsInteger(TypeAt(ExprAt(id).type))) return std::nullopt;
  const std::optional<StaticAddress> at = facts_.AddressOf(ExprAt(id).a);
  if (!at) return std::nullopt;
  const Expr& lvalue = ExprAt(ExprAt(id).a);
  if (lvalue.kind == ExprKind::kMember &&
      unit_.records[TypeAt(ExprAt(lvalue.a).type).record].members[lvalue.member].is_bit_field) {
    return std::nullopt;
  }
  return Cell{at->object, at->offset, TypeAt(ExprAt(id).type).size};
}

void Lowering::RefineComparison(const Expr& expr, bool holds) {
  BinaryOp op = expr.binary;
  if (!holds) {
    switch (op) {
      case BinaryOp::kLess:
        op = BinaryOp::kGreaterEqual;
        break;
      case BinaryOp::kGreater:
        op = BinaryOp::kLessEqual;
        break;
      case BinaryOp::kLessEqual:
        op = BinaryOp::kGreater;
        break;
      case BinaryOp::kGreaterEqual:
        op = BinaryOp::kLess;
        break;
      case BinaryOp::kEqual:
        op = BinaryOp::kNotEqual;
        break;
      case BinaryOp::kNotEqual:
        op = BinaryOp::kEqual;
        break;
      default:
        return;
    }
  }
  for (const bool turned : {false, true}) {
    const ExprId read = turned ? expr.b : expr.a, limit = turned ? expr.a : expr.b;
    const std::optional<Cell> cell = CellOfRead(read);
    if (!cell || !limit.valid() || !IsInteger(unit_.TypeOf(limit))) continue;
    // What is known of the cell keeps its origin; what it is compared with must hold for good.
    const Bounds now = BoundsOfExpr(read, Origin::kStored), other = BoundsOfExpr(limit, Origin::kTested);
    Bounds bounds = now;
    const bool upward = op == BinaryOp::kGreater || op == BinaryOp::kGreaterEqual;
    switch (op) {
      case BinaryOp::kLess:
      case BinaryOp::kLessEqual:
      case BinaryOp::kGreater:
      case BinaryOp::kGreaterEqual: {
        const int64_t strict = op == BinaryOp::kLess || op == BinaryOp::kGreater ? 1 : 0;
        if (upward != turned) {
          bounds.low = std::max(bounds.low, other.low + strict);
        } else {
          bounds.high = std::min(bounds.high, other.high - strict);
        }
        break;
      }
      case BinaryOp::kEqual:
        bounds = {std::max(now.low, other.low), std::min(now.high, other.high)};
        break;
      case BinaryOp::kNotEqual:
        if (other.IsOne() && bounds.low == other.low) ++bounds.low;
        if (other.IsOne() && bounds.high == other.low) --bounds.high;
        break;
      default:
        break;
    }
    if (bounds.low <= bounds.high && bounds != now) flow_.Narrow(*cell, bounds);
  }
}

/// What the outcome of a condition tells of the cells that it compares.
void Lowering::Refine(ExprId condition, bool holds) {
  std::vector<ExprId> open = {condition};
  while (!open.empty()) {
    const ExprId id = open.back();
    open.pop_back();
    if (!id.valid() || !ExprAt(id).type.valid()) continue;
    const Expr& expr = ExprAt(id);
    switch (expr.kind) {
      case ExprKind::kAnd:
        if (!holds || !IsSimple(expr.b)) break;
        open.push_back(expr.b);
        open.push_back(expr.a);
        break;
      case ExprKind::kOr:
        if (holds || !IsSimple(expr.b)) break;
        open.push_back(expr.b);
        open.push_back(expr.a);
        break;
      case ExprKind::kUnary:
        if (expr.unary == UnaryOp::kNot && open.empty()) {
          holds = !holds;
          open.push_back(expr.a);
        }
        break;
      case ExprKind::kBinary:
        if (expr.binary >= BinaryOp::kLess && expr.binary <= BinaryOp::kNotEqual && IsSimple(id)) {
          RefineComparison(expr, holds);
        }
        break;
      case ExprKind::kLoad:
      case ExprKind::kConvert: {
        const std::optional<Cell> cell = CellOfRead(id);
        if (!cell) break;
        Bounds bounds = BoundsOfExpr(id, Origin::kStored);
        if (!holds && bounds.Holds(0)) {
          flow_.Narrow(*cell, {0, 0});
        } else if (holds && bounds.low == 0 && bounds.high > 0) {
          flow_.Narrow(*cell, {1, bounds.high});
        }
        break;
      }
      default:
        break;
    }
  }
}

}  // namespace plcxx::hnc
