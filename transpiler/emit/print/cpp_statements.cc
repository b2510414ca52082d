// Statements: the source's text above them, and instructions in their order.

#include <algorithm>

#include "transpiler/emit/print/part_printer.h"
#include "transpiler/ir/builder.h"
#include "transpiler/support/check.h"

namespace plcxx::emit::print {
namespace {

constexpr size_t kLineWidth = 110;

bool IsInside(const source::Range& inner, const source::Range& outer) {
  return outer.begin <= inner.begin && inner.end <= outer.end;
}

/// Where a text that is wider than `width` is broken: as far outside of brackets as possible, so that what is compared
/// or negated stays on one line, and behind its first third.
size_t BreakIn(std::string_view text, size_t width) {
  size_t best = std::string_view::npos;
  int depth = 0, best_depth = 0;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(') ++depth;
    if (text[i] == ')') --depth;
    if (text[i] != kBreak) continue;
    if (i > width) return best != std::string_view::npos ? best : i;
    if (best == std::string_view::npos || best < width / 3 || depth <= best_depth) {
      best = i;
      best_depth = depth;
    }
  }
  return best;
}

}  // namespace

void PartPrinter::Own(ir::StatementId statement) {
  const ir::StatementId before = owners_.empty() ? ir::StatementId() : owners_.back().statement;
  if (statement != before) owners_.push_back({out_.size(), statement});
}

void PartPrinter::Comment(std::string_view text) {
  Own();
  out_.append(static_cast<size_t>(indent_) * 2, ' ');
  out_ += "//";
  const std::string safe = CommentText(text);
  if (!safe.empty()) {
    out_ += ' ';
    out_ += safe;
  }
  out_ += '\n';
}

/// Writes a line; a long one is broken before operators.
void PartPrinter::Line(Text line_of) {
  Own();
  spelled_.Add(line_of);
  std::string& text = line_of.chars;
  const size_t margin = static_cast<size_t>(indent_) * 2;
  if (margin + text.size() <= kLineWidth) {
    std::replace(text.begin(), text.end(), kBreak, ' ');
    out_.append(margin, ' ');
    out_ += text;
    out_ += '\n';
    return;
  }
  std::string_view rest = text;
  for (size_t indent = margin; !rest.empty(); indent = margin + 4) {
    size_t end = rest.size();
    if (indent + end > kLineWidth) end = std::min(end, BreakIn(rest, kLineWidth - std::min(kLineWidth, indent)));
    std::string line(rest.substr(0, end));
    std::replace(line.begin(), line.end(), kBreak, ' ');
    out_.append(indent, ' ');
    out_ += line;
    out_ += '\n';
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
}

/// The source's comments, then its lines as they stand there. A comment between these lines has its place among them.
void PartPrinter::StatementComments(const ir::Statement& statement) {
  for (const source::Range& comment : statement.comments) {
    if (!IsInside(comment, statement.range)) Comment(sources_.Text(comment));
  }
  const std::string_view text = sources_.Text(statement.range);
  size_t begin = 0;
  while (begin < text.size()) {
    size_t end = text.find_first_of("\r\n", begin);
    if (end == std::string_view::npos) end = text.size();
    const std::string_view row = text.substr(begin, end - begin);
    if (row.find_first_not_of(" \t") != std::string_view::npos) Comment(row);
    begin = end + 1;
  }
  if (text.empty() && !statement.subject.empty()) Comment(statement.subject);
}

void PartPrinter::Local(ir::InstId id) {
  Text value = SpellDefinition(emittable_, id).text;
  const std::string type(ir::CppName(program_[id].type));
  if (Switchable() && !value.effects.empty()) value = On() + " ? " + value + " : " + type + "{}";
  Line("const " + type + " " + emittable_.value_names[id.index] + " = " + value + ";");
}

std::string PartPrinter::On(ir::StatementId statement) const {
  PLCXX_CHECK(uses_state_);
  return "m.on(" + std::to_string(statement.index) + ")";
}

bool PartPrinter::Switchable() const {
  if (!debug() || !statement_.valid() || switched_) return false;
  const ir::Statement& statement = program_.statements[statement_];
  return !statement.opens_block && !statement.closes_block;
}

/// The copy is taken over only when it has this program's layout.
void PartPrinter::LoadRetentive(ir::InstId id) {
  const std::string& name = program_.host_functions[program_.calls[ir::CallId(program_[id].payload)].host].name;
  Line("Retentive copy{};");
  Line(Spelled(name + "(host, copy);", id));
  Line("if (copy.layout == kRetentiveLayout) m.retentive = copy;");
}

void PartPrinter::Store(ir::InstId id) {
  const ir::Inst& inst = program_[id];
  const Text target = SpellPlace(emittable_, ir::PlaceId(inst.payload), ir::ValueId(inst.b)).text;
  const Text value = Value(inst.a);
  // Of a variable of its own, `i = i;` is a warning of some compilers; a signal's is a call of an operator.
  const bool same =
      value.chars == target.chars && emittable_.layout.places[inst.payload].storage == layout::Storage::kLocal;
  Line(Spelled(same ? "static_cast<void>(" + value + ");" : target + " = " + value + ";", id));
}

/// An instruction that has lines of its own.
void PartPrinter::Effect(ir::InstId id) {
  const ir::Inst& inst = program_[id];
  switch (ir::Info(inst.op).shape) {
    case ir::Shape::kStep:
    case ir::Shape::kCall:
    case ir::Shape::kHostCall: {
      const bool loads_retentive = inst.op == ir::OpKind::kHostCall &&
                                   program_.host_functions[program_.calls[ir::CallId(inst.payload)].host].access ==
                                       ir::HostAccess::kWritesRetentive;
      if (loads_retentive) return LoadRetentive(id);
      Line(SpellDefinition(emittable_, id).text + ";");
      return;
    }
    case ir::Shape::kStore:
      Store(id);
      return;
    case ir::Shape::kText: {
      const std::string literal = CppString(program_.texts[ir::TextId(inst.b)]);
      Line(Spelled("UpdateText(m[" + emittable_.state_names[inst.payload] + "], m[" + emittable_.state_names[inst.a] +
                       "], " + literal + ");",
                   id));
      return;
    }
    case ir::Shape::kIf:
      If(id);
      return;
    case ir::Shape::kSwitch:
      Switch(id);
      return;
    case ir::Shape::kLoop:
      Loop(id, inst);
      return;
    case ir::Shape::kBlock:
      Block(id, inst);
      return;
    case ir::Shape::kExit:
      Exit(id, inst);
      return;
    case ir::Shape::kRepeat:
      Repeat(id, inst);
      return;
    case ir::Shape::kPure:
    case ir::Shape::kLoad:
    case ir::Shape::kConst:
    case ir::Shape::kStatement:
    case ir::Shape::kJump:
    case ir::Shape::kLabel:
      break;
  }
  PLCXX_UNREACHABLE();
}

/// Of statements in something that does nothing.
void PartPrinter::Comments(ir::InstId id) {
  for (const ir::RegionId owned : ir::OwnedRegions(program_, program_[id])) RegionBody(owned);
}

void PartPrinter::Inst(ir::InstId id) {
  switch (emittable_.forms[id.index]) {
    case Form::kNowhere:
      Comments(id);
      return;
    case Form::kInside:
      return;
    case Form::kLocal:
      Local(id);
      return;
    case Form::kLine:
      Effect(id);
      return;
  }
}

/// Whether switching the statement off leaves other statements in its regions on: they were put there by a jump.
bool PartPrinter::HoldsOthers(const ir::Inst& inst) const {
  switch (inst.op) {
    case ir::OpKind::kBlock:
      return true;
    case ir::OpKind::kLoop:
      return program_.loops[ir::LoopId(inst.payload)].kind == ir::LoopBound::kBudget;
    case ir::OpKind::kIf:
      return static_cast<ir::IfOrigin>(inst.payload) != ir::IfOrigin::kSource;
    default:
      return false;
  }
}

void PartPrinter::OpenStretch(ir::RegionId region, uint32_t begin, uint32_t end) {
  const auto& insts = program_.regions[region].insts;
  const auto close = [this] {
    if (!switched_) return;
    switched_ = false;
    --indent_;
    Line("}");
  };
  for (uint32_t i = begin; i < end; ++i) {
    const Form form = emittable_.forms[insts[i].index];
    if (form == Form::kLocal || (form == Form::kLine && HoldsOthers(program_[insts[i]]))) {
      close();
      Inst(insts[i]);
    } else if (form == Form::kNowhere) {
      Comments(insts[i]);
    } else if (form == Form::kLine) {
      if (!switched_) {
        Line("if (" + On() + ") {");
        ++indent_;
        switched_ = true;
      }
      Effect(insts[i]);
    }
  }
  close();
}

void PartPrinter::Stretch(ir::RegionId region, uint32_t begin, uint32_t end) {
  const auto& insts = program_.regions[region].insts;
  const bool switchable = Switchable();
  if (switchable && std::any_of(insts.begin() + begin, insts.begin() + end,
                                [this](ir::InstId id) { return HoldsOthers(program_[id]); })) {
    OpenStretch(region, begin, end);
    return;
  }
  if (switchable) {
    Line("if (" + On() + ") {");
    ++indent_;
    switched_ = true;
  }
  for (uint32_t i = begin; i < end; ++i) Inst(insts[i]);
  if (switchable) {
    switched_ = false;
    --indent_;
    Line("}");
  }
}

void PartPrinter::Range(ir::RegionId region, uint32_t begin, uint32_t end) {
  const ir::StatementId outer = statement_;
  const bool outer_switched = switched_;
  const auto& insts = program_.regions[region].insts;
  for (uint32_t i = begin; i < end;) {
    if (program_[insts[i]].op == ir::OpKind::kStatement) {
      if (i > begin && indent_ == 1 && !out_.ends_with(":;\n") && !out_.ends_with("\n\n")) out_ += '\n';
      statement_ = ir::StatementId(program_[insts[i]].payload);
      switched_ = false;
      StatementComments(program_.statements[statement_]);
      ++i;
    }
    uint32_t stop = i;
    while (stop < end && program_[insts[stop]].op != ir::OpKind::kStatement) ++stop;
    Stretch(region, i, stop);
    i = stop;
  }
  statement_ = outer;
  switched_ = outer_switched;
}

void PartPrinter::RegionBody(ir::RegionId region) {
  for (const Piece& piece : PiecesOf(emittable_, region)) {
    if (piece.chunk == Piece::kInPlace) {
      Range(region, piece.begin, piece.end);
      continue;
    }
    const ChunkCall call = CallOf(emittable_, piece.chunk, part_);
    if (!call.name.empty()) Line(call.name + "(" + Arguments(*call.locals) + ");");
  }
}

}  // namespace plcxx::emit::print
