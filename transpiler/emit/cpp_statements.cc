// Statements: the source's text above them, and instructions in their order.

#include <algorithm>

#include "transpiler/emit/part_printer.h"
#include "transpiler/ir/builder.h"
#include "transpiler/support/check.h"

namespace plcxx::emit {
namespace {

constexpr size_t kLineWidth = 110;

bool IsInside(const source::Range& inner, const source::Range& outer) {
  return outer.begin <= inner.begin && inner.end <= outer.end;
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
void PartPrinter::Line(std::string text) {
  Own();
  const size_t margin = static_cast<size_t>(indent_) * 2;
  if (margin + text.size() <= kLineWidth) {
    std::replace(text.begin(), text.end(), kBreak, ' ');
    out_.append(margin, ' ');
    out_ += text;
    out_ += '\n';
    return;
  }
  std::string line(margin, ' ');
  size_t last_break = std::string::npos;
  for (const char c : text) {
    if (c == kBreak) {
      last_break = line.size();
      line += ' ';
    } else {
      line += c;
    }
    if (line.size() > kLineWidth && last_break != std::string::npos) {
      out_.append(line, 0, last_break);
      out_ += '\n';
      line = std::string(margin + 4, ' ') + line.substr(last_break + 1);
      last_break = std::string::npos;
    }
  }
  out_ += line;
  out_ += '\n';
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

/// "t417": a number of three digits that the statement's own text says, so that an edit renames no other one's locals;
/// where that is taken, the next one. What is no statement of the source counts from 1.
std::string PartPrinter::NextLocalName() {
  constexpr uint32_t kFirst = 100;
  constexpr uint32_t kNumbers = 900;
  uint32_t number = statement_.valid() ? kFirst + program_.statements[statement_].id % kNumbers : 1;
  while (!numbers_.insert(number).second) ++number;
  return "t" + std::to_string(number);
}

void PartPrinter::Local(ir::InstId id) {
  const ir::Inst& inst = program_[id];
  std::string& name = local_names_[id.index];
  name = NextLocalName();
  std::string value = SpellDefinition(emittable_, local_names_, id).text;
  const std::string type(ir::CppName(inst.type));
  if (Switchable() && HasEffect(id)) value = On() + " ? " + value + " : " + type + "{}";
  Line("const " + type + " " + name + " = " + value + ";");
}

/// Whether computing a value, as it is spelled, steps an instance or calls something.
bool PartPrinter::HasEffect(ir::ValueId value) const {
  const ir::Inst& inst = program_[value];
  if (IsEffect(emittable_, value)) return true;
  const std::vector<ir::ValueId> used = ir::UsedValues(program_, inst);
  return std::any_of(used.begin(), used.end(), [this](ir::ValueId operand) {
    return !emittable_.local_value[operand.index] && HasEffect(operand);
  });
}

bool PartPrinter::Switchable() const {
  if (!debug() || !statement_.valid() || switched_) return false;
  const ir::Statement& statement = program_.statements[statement_];
  return !statement.opens_block && !statement.closes_block;
}

void PartPrinter::Effect(ir::InstId id) {
  const ir::Inst& inst = program_[id];
  switch (ir::Info(inst.op).shape) {
    case ir::Shape::kPure:
    case ir::Shape::kLoad:
    case ir::Shape::kConst:
      return;  // spelled where it is used
    case ir::Shape::kStep:
    case ir::Shape::kCall:
    case ir::Shape::kHostCall: {
      const bool loads_retentive = inst.op == ir::OpKind::kHostCall &&
                                   program_.host_functions[program_.calls[ir::CallId(inst.payload)].host].access ==
                                       ir::HostAccess::kWritesRetentive;
      if (loads_retentive) {
        const std::string& name = program_.host_functions[program_.calls[ir::CallId(inst.payload)].host].name;
        Line("Retentive copy{};");
        Line(name + "(host, copy);");
        Line("if (copy.layout == kRetentiveLayout) m.retentive = copy;");
        return;
      }
      Line(Spell(emittable_, local_names_, id).text + ";");
      return;
    }
    case ir::Shape::kStore: {
      const Spelling target = SpellPlace(emittable_, local_names_, ir::PlaceId(inst.payload), ir::ValueId(inst.b));
      const std::string value = Value(inst.a);
      // Of a variable of its own, `i = i;` is a warning of some compilers; a signal's is a call of an operator.
      Line(value == target.text && emittable_.layout.places[inst.payload].storage == Storage::kLocal
               ? "static_cast<void>(" + value + ");"
               : target.text + " = " + value + ";");
      return;
    }
    case ir::Shape::kText: {
      const std::string literal = CppString(program_.texts[ir::TextId(inst.b)]);
      Line("UpdateText(m[" + emittable_.state_names[inst.payload] + "], m[" + emittable_.state_names[inst.a] + "], " +
           literal + ");");
      return;
    }
    case ir::Shape::kIf:
      If(inst);
      return;
    case ir::Shape::kSwitch:
      Switch(inst);
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
    case ir::Shape::kStatement:
    case ir::Shape::kJump:
    case ir::Shape::kLabel:
      break;
  }
  PLCXX_UNREACHABLE();
}

void PartPrinter::Inst(ir::InstId id) {
  if (emittable_.local_value[id.index]) {
    Local(id);
  } else {
    Effect(id);
  }
}

/// A step whose result a later instruction spells is not a line of its own.
bool PartPrinter::SpelledLater(ir::RegionId region, uint32_t at, uint32_t end) const {
  const auto& insts = program_.regions[region].insts;
  const ir::Inst& inst = program_[insts[at]];
  const ir::Shape shape = ir::Info(inst.op).shape;
  const bool has_value = inst.type != ir::Type::kNone &&
                         (shape == ir::Shape::kStep || shape == ir::Shape::kCall || shape == ir::Shape::kHostCall);
  if (!has_value || emittable_.local_value[insts[at].index]) return false;
  for (uint32_t k = at + 1; k < end; ++k) {
    const std::vector<ir::ValueId> used = ir::UsedValues(program_, program_[insts[k]]);
    if (std::find(used.begin(), used.end(), insts[at]) != used.end()) return true;
  }
  return false;
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
    if (SpelledLater(region, i, end)) continue;
    if (emittable_.local_value[insts[i].index] || HoldsOthers(program_[insts[i]])) {
      close();
      Inst(insts[i]);
    } else if (IsEffect(emittable_, insts[i])) {
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
  for (uint32_t i = begin; i < end; ++i) {
    if (!SpelledLater(region, i, end)) Inst(insts[i]);
  }
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
      if (i > begin && indent_ == 1 && !out_.ends_with(":;\n")) out_ += '\n';
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
  uint32_t at = 0;  // printed so far
  const auto in_place = [this, region, &at](uint32_t end) {
    if (at < end) Range(region, at, end);
  };
  for (const uint32_t index : emittable_.region_chunks[region.index]) {
    const Chunk& chunk = emittable_.chunks[index];
    in_place(chunk.begin);
    at = chunk.end;
    if (chunk.part == part_) {
      Line(chunk.name + "(" + Arguments(chunk.locals) + ");");
      continue;
    }
    const auto run = std::find_if(emittable_.runs.begin(), emittable_.runs.end(),
                                  [index](const ChunkRun& other) { return other.chunks.front() == index; });
    if (run != emittable_.runs.end()) Line(run->name + "(" + Arguments(run->locals) + ");");
  }
  in_place(static_cast<uint32_t>(program_.regions[region].insts.size()));
}

}  // namespace plcxx::emit
