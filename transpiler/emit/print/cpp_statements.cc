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
/// or negated stays on one line, and after its first third.
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
  if (statement != before) owners_.push_back({out_.line(), statement});
}

void PartPrinter::Comment(std::string_view text) {
  Own();
  last_ = Last::kText;
  out_ += std::string(static_cast<size_t>(indent_) * 2, ' ');
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
  last_ = Last::kText;
  spelled_.Add(line_of);
  std::string& text = line_of.chars;
  const size_t margin = static_cast<size_t>(indent_) * 2;
  if (margin + text.size() <= kLineWidth) {
    std::replace(text.begin(), text.end(), kBreak, ' ');
    out_ += std::string(margin, ' ');
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
    out_ += std::string(indent, ' ');
    out_ += line;
    out_ += '\n';
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
}

void PartPrinter::BlankLine() {
  out_ += '\n';
  last_ = Last::kBlank;
}

/// A comment for each line that is not blank.
void PartPrinter::CommentLines(std::string_view text) {
  size_t begin = 0;
  while (begin < text.size()) {
    size_t end = text.find_first_of("\r\n", begin);
    if (end == std::string_view::npos) end = text.size();
    const std::string_view row = text.substr(begin, end - begin);
    if (row.find_first_not_of(" \t") != std::string_view::npos) Comment(row);
    begin = end + 1;
  }
}

/// The source's comments, then its lines as they stand there. A comment between these lines has its place among them.
void PartPrinter::StatementComments(const ir::Statement& statement) {
  for (const source::Range& comment : statement.comments) {
    if (!IsInside(comment, statement.range)) Comment(sources_.Text(comment));
  }
  const std::string_view text = sources_.Text(statement.range);
  CommentLines(text);
  if (text.empty() && !statement.subject.empty()) Comment(statement.subject);
}

void PartPrinter::Local(ir::InstId id) {
  Text value = SpellDefinition(emittable_, id).text;
  const std::string type(ir::CppName(program_[id].type));
  if (const Switch* of = SwitchOf(id)) value = On(of->statement) + " ? " + value + " : " + type + "{}";
  local_names_[id.index] = emittable_.value_names[id.index];
  const std::string& name = emittable_.value_names[id.index];
  if (emittable_.loose_locals.contains(id.index)) {
    Line(type + " " + name + ";");
    Line(name + " = " + value + ";");
  } else {
    Line("const " + type + " " + name + " = " + value + ";");
  }
}

std::string PartPrinter::On(ir::StatementId statement) const {
  PLCXX_CHECK(uses_state_);
  return "m.on(" + std::to_string(statement.index) + ")";
}

const Switch* PartPrinter::SwitchOf(ir::InstId id) const {
  const auto found = emittable_.switches.find(id.index);
  return found == emittable_.switches.end() ? nullptr : &found->second;
}

/// The copy is taken over only when it has this program's layout.
void PartPrinter::LoadRetentive(ir::InstId id) {
  const std::string& name = program_.host_functions[program_.calls[ir::CallId(program_[id].payload)].host].name;
  Line("Retentive copy{};");
  Line(Spelled(name + "(host, copy);", id));
  Line("if (copy.layout == kRetentiveLayout) m.retentive = copy;");
  if (debug()) Line("m.ReapplyForces();");  // a force outlives a power cycle
}

void PartPrinter::Store(ir::InstId id) {
  const ir::Inst& inst = program_[id];
  const Text target = SpellPlace(emittable_, ir::PlaceId(inst.payload), ir::ValueId(inst.b)).text;
  const Text value = Value(inst.a);
  if (const auto returned = emittable_.returns.find(id.index); returned != emittable_.returns.end()) {
    Text text = Spelled("return " + value + ";", id);
    Line(returned->second.valid() ? Spelled(std::move(text), returned->second) : std::move(text));
    return;
  }
  const bool discard = emittable_.wordings[id.index] == Wording::kDiscard;
  Line(Spelled(discard ? "static_cast<void>(" + value + ");" : target + " = " + value + ";", id));
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
      SwitchOver(id);
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

void PartPrinter::Segment(ir::RegionId region, uint32_t begin, uint32_t end) {
  const auto& insts = program_.regions[region].insts;
  const std::vector<Guard>& guards = emittable_.guards[region.index];
  auto guard = std::ranges::lower_bound(guards, begin, {}, &Guard::begin);
  const auto open = [&] {
    Line("if (" + On(guard->statement) + ") {");
    ++indent_;
  };
  const auto close = [&] {
    --indent_;
    Line("}");
    ++guard;
  };
  bool inside = false;
  for (uint32_t i = begin; i < end; ++i) {
    if (inside && guard->end == i) {
      close();
      inside = false;
    }
    if (!inside && guard != guards.end() && guard->begin == i) {
      open();
      inside = true;
    }
    Inst(insts[i]);
  }
  // Of a statement without instructions, too.
  if (begin == end && guard != guards.end() && guard->begin == begin) {
    open();
    inside = true;
  }
  if (inside) close();
}

void PartPrinter::Range(ir::RegionId region, uint32_t begin, uint32_t end) {
  const ir::StatementId outer = statement_;
  const auto& insts = program_.regions[region].insts;
  for (uint32_t i = begin; i < end;) {
    if (program_[insts[i]].op == ir::OpKind::kStatement) {
      if (i > begin && indent_ == 1 && last_ == Last::kText) BlankLine();
      statement_ = ir::StatementId(program_[insts[i]].payload);
      StatementComments(program_.statements[statement_]);
      ++i;
    }
    uint32_t stop = i;
    while (stop < end && program_[insts[stop]].op != ir::OpKind::kStatement) ++stop;
    Segment(region, i, stop);
    i = stop;
  }
  statement_ = outer;
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
