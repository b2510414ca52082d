// If, switch, loops, blocks, and the ways out of them.

#include <algorithm>

#include "transpiler/emit/print/part_printer.h"
#include "transpiler/ir/builder.h"
#include "transpiler/support/check.h"

namespace plcxx::emit::print {
namespace {

Text Bracketed(const Spelling& spelling) {
  return spelling.precedence <= ir::Precedence::kUnary ? spelling.text : "(" + spelling.text + ")";
}

ir::IfOrigin OriginOf(const ir::Inst& inst) { return static_cast<ir::IfOrigin>(inst.payload); }

}  // namespace

Text PartPrinter::Condition(const ir::Inst& inst) const {
  const Spelling condition = Spell(emittable_, ir::ValueId(inst.a));
  if (!debug() || !statement_.valid()) return condition.text;
  const bool head = program_.statements[statement_].opens_block;
  switch (head ? ir::IfOrigin::kSource : OriginOf(inst)) {
    case ir::IfOrigin::kSource:
      return On() + " & " + Bracketed(condition);
    case ir::IfOrigin::kJumps:
      return Switchable() ? On() + " && " + Bracketed(condition) : condition.text;
    case ir::IfOrigin::kStays:
      return Switchable() ? "!" + On() + " || " + Bracketed(condition) : condition.text;
  }
  PLCXX_UNREACHABLE();
}

ir::InstId PartPrinter::ChainedIf(ir::RegionId otherwise, ir::StatementId& statement) const {
  const auto& insts = program_.regions[otherwise].insts;
  const ir::InstId last = insts.back();
  if (program_[last].op != ir::OpKind::kIf || emittable_.forms[last.index] != Form::kLine) return {};
  if (!emittable_.region_chunks[otherwise.index].empty()) return {};
  statement = {};
  for (size_t i = 0; i + 1 < insts.size(); ++i) {
    const ir::Inst& other = program_[insts[i]];
    if (other.op == ir::OpKind::kStatement && i == 0) {
      statement = ir::StatementId(other.payload);
    } else if (IsEffect(emittable_, insts[i]) || other.op == ir::OpKind::kStatement ||
               emittable_.forms[insts[i].index] == Form::kLocal) {
      return {};
    }
  }
  // Switched off, both arms of a plain If are off, which a chain cannot say; the head of a block is just false.
  const ir::StatementId own = statement.valid() ? statement : statement_;
  const bool head = !own.valid() || program_.statements[own].opens_block;
  const bool plain = OriginOf(program_[last]) == ir::IfOrigin::kSource;
  if (debug() && !head && plain && (statement.valid() || !switched_)) return {};
  return last;
}

void PartPrinter::If(ir::InstId id) {
  const ir::StatementId outer = statement_;
  const bool outer_switched = switched_;
  const ir::Inst* inst = &program_[id];
  Text head = Spelled("if (" + Condition(*inst) + ") {", id);
  for (;;) {
    Line(std::move(head));
    ++indent_;
    RegionBody(ir::RegionId(inst->b));
    --indent_;
    Line("}");
    const ir::RegionId otherwise(inst->c);
    if (!otherwise.valid() || program_.regions[otherwise].insts.empty()) break;
    ir::StatementId statement;
    const ir::InstId chained = ChainedIf(otherwise, statement);
    if (!chained.valid()) {
      out_.resize(out_.size() - 1);
      out_ += " else {\n";
      ++indent_;
      RegionBody(otherwise);
      --indent_;
      Line("}");
      break;
    }
    if (statement.valid()) {
      statement_ = statement;
      switched_ = false;
      StatementComments(program_.statements[statement]);
    }
    inst = &program_[chained];
    const ir::Inst& condition = program_[ir::ValueId(inst->a)];
    const bool always =
        condition.op == ir::OpKind::kConst && ir::ConstantValue(condition) != 0 && !ir::RegionId(inst->c).valid();
    head = Spelled(always && !debug() ? "else {" : "else if (" + Condition(*inst) + ") {", chained);
    if (!statement.valid()) {
      out_.pop_back();  // no comment between: "} else if"
      head = "} " + head;
      out_.resize(out_.rfind('\n') + 1);
    }
  }
  statement_ = outer;
  switched_ = outer_switched;
}

/// Whether the last thing in the region is a jump, so that nothing behind it is reached.
bool PartPrinter::EndsElsewhere(ir::RegionId region) const {
  const std::vector<ir::InstId>& insts = program_.regions[region].insts;
  if (debug() || insts.empty()) return false;
  const ir::Inst& last = program_[insts.back()];
  if (last.op != ir::OpKind::kExit || ir::ValueId(last.a).valid()) return false;
  return emittable_.leaves.at(insts.back().index) != Leave::kFallsThrough;
}

void PartPrinter::Switch(ir::InstId id) {
  const ir::Inst& inst = program_[id];
  Line(Spelled("switch (" + Value(inst.a) + ") {", id));
  ++indent_;
  for (const ir::SwitchCase& arm : program_.switches[ir::SwitchId(inst.payload)].cases) {
    if (arm.values.empty()) {
      Line("default: {");
    } else {
      for (size_t i = 0; i < arm.values.size(); ++i) {
        Line("case " + std::to_string(arm.values[i]) + (i + 1 < arm.values.size() ? ":" : ": {"));
      }
    }
    ++indent_;
    RegionBody(arm.region);
    if (!arm.falls_through && !EndsElsewhere(arm.region)) Line("break;");
    --indent_;
    Line("}");
    if (arm.falls_through) Line("[[fallthrough]];");
  }
  --indent_;
  Line("}");
}

/// A label stands one step to the left of what it labels.
void PartPrinter::Label(const std::string& label) {
  if (label.empty()) return;
  if (indent_ == 1) out_ += '\n';  // it belongs to what follows
  --indent_;
  Line(label + ":;");
  ++indent_;
}

/// Whether control never gets to the end of a list.
bool PartPrinter::EndsByLeaving(ir::RegionId region) const {
  if (!region.valid()) return false;
  const auto& insts = program_.regions[region].insts;
  for (size_t i = insts.size(); i-- > 0;) {
    if (!IsEffect(emittable_, insts[i])) continue;
    const ir::Inst& inst = program_[insts[i]];
    const bool always = !ir::ValueId(inst.a).valid();
    if (inst.op == ir::OpKind::kExit) {
      return always && emittable_.leaves.at(insts[i].index) != Leave::kFallsThrough;
    }
    if (inst.op == ir::OpKind::kRepeat) return always && EndsByLeaving(ir::RegionId(inst.b));
    if (inst.op == ir::OpKind::kIf) return EndsByLeaving(ir::RegionId(inst.b)) && EndsByLeaving(ir::RegionId(inst.c));
    return false;
  }
  return false;
}

/// Whether all of the list is in the spelling of its last value.
bool PartPrinter::IsSpelledAsOne(ir::RegionId region) const {
  const auto& insts = program_.regions[region].insts;
  return std::all_of(insts.begin(), insts.end(), [this](ir::InstId id) {
    const ir::Shape shape = ir::Info(program_[id].op).shape;
    const bool value = shape == ir::Shape::kConst || shape == ir::Shape::kPure || shape == ir::Shape::kLoad;
    return value && emittable_.forms[id.index] != Form::kLocal;
  });
}

/// "i = Add16(i, 1)"; empty: the loop has no step.
Text PartPrinter::Step(ir::RegionId region) const {
  if (!region.valid() || program_.regions[region].insts.empty()) return "";
  const ir::InstId id = program_.regions[region].insts.back();
  const ir::Inst& store = program_[id];
  const Spelling target = SpellPlace(emittable_, ir::PlaceId(store.payload), ir::ValueId(store.b));
  return Spelled(target.text + " = " + Value(store.a), id);
}

void PartPrinter::BudgetLoop(const ir::Loop& loop, const Landing& labels) {
  Line("for (;;) {");
  ++indent_;
  Label(labels.again);
  RegionBody(loop.body);
  if (debug() || !EndsByLeaving(loop.body)) Line("break;");
  --indent_;
  Line("}");
  Label(labels.behind);
}

/// In the head of the loop.
Spelling PartPrinter::LoopCondition(const ir::Loop& loop, ir::StatementId statement) const {
  const Spelling spelled = Spell(emittable_, program_.regions[loop.condition].insts.back());
  if (!debug() || !statement.valid()) return spelled;
  return Spelling{"(" + On(statement) + " & " + Bracketed(spelled) + ")", ir::Precedence::kPrimary};
}

/// `condition` is empty where it has lines of its own.
Text PartPrinter::LoopHead(const ir::Loop& loop, const std::string& counter, const Text& condition) const {
  const Text step = Step(loop.step);
  const Text between = condition.chars.empty() ? condition : " " + condition;
  // A proven loop ends by itself: nobody counts its iterations.
  if (!counter.empty()) {
    return "for (uint32_t " + counter + " = 0;" + between + "; ++" + counter + (step.chars.empty() ? "" : ", ") + step +
           ") {";
  }
  if (!step.chars.empty()) return "for (;" + between + "; " + step + ") {";
  return condition.chars.empty() ? "for (;;) {" : "while (" + condition + ") {";
}

void PartPrinter::Loop(ir::InstId id, const ir::Inst& inst) {
  const ir::Loop& loop = program_.loops[ir::LoopId(inst.payload)];
  loops_.push_back({out_.size(), ir::LoopId(inst.payload)});
  spelled_.Add(Spelled("", id));
  const auto landing = emittable_.landings.find(id.index);
  const Landing none;
  const Landing& labels = landing == emittable_.landings.end() ? none : landing->second;
  if (loop.kind == ir::LoopBound::kBudget) {
    BudgetLoop(loop, labels);
    return;
  }
  const ir::StatementId statement = statement_;
  const bool in_head = loop.condition.valid() && IsSpelledAsOne(loop.condition);
  Line(LoopHead(loop, labels.counter, in_head ? LoopCondition(loop, statement).text : Text()));
  ++indent_;
  if (loop.condition.valid() && !in_head) {
    // Switched off, it asks nothing.
    if (debug() && statement.valid()) Line("if (!" + On(statement) + ") break;");
    Range(loop.condition, 0, static_cast<uint32_t>(program_.regions[loop.condition].insts.size()));
    Line("if (!" + Bracketed(Spell(emittable_, program_.regions[loop.condition].insts.back())) + ") break;");
  }
  if (loop.kind == ir::LoopBound::kGuard) {
    Line("if (" + labels.counter + " == " + std::to_string(loop.bound) + ") {");
    ++indent_;
    if (loop.exhausted.valid()) RegionBody(loop.exhausted);
    Line("break;");
    --indent_;
    Line("}");
  }
  RegionBody(loop.body);
  --indent_;
  Line("}");
  Label(labels.behind);
}

void PartPrinter::Block(ir::InstId id, const ir::Inst& inst) {
  spelled_.Add(Spelled("", id));  // its braces and label, where it has any
  const auto landing = emittable_.landings.find(id.index);
  const bool braces = landing != emittable_.landings.end() && landing->second.braces;
  if (braces) {
    Line("{");
    ++indent_;
  }
  RegionBody(ir::RegionId(inst.a));
  if (braces) {
    --indent_;
    Line("}");
  }
  if (landing != emittable_.landings.end()) Label(landing->second.behind);
}

/// "return;", "goto to_U4A8;"
std::string PartPrinter::Departure(ir::InstId id) const {
  const Leave leave = emittable_.leaves.at(id.index);
  switch (leave) {
    case Leave::kFallsThrough:
      break;  // has no text
    case Leave::kReturn:
      return return_;
    case Leave::kBreak:
      return "break;";
    case Leave::kContinue:
      return "continue;";
    case Leave::kGoto: {
      const ir::Inst& inst = program_[id];
      const Landing& landing = emittable_.landings.at(inst.payload);
      return "goto " + (inst.op == ir::OpKind::kRepeat ? landing.again : landing.behind) + ";";
    }
  }
  PLCXX_UNREACHABLE();
}

void PartPrinter::Exit(ir::InstId id, const ir::Inst& inst) {
  const std::string departure = Departure(id);
  Line(Spelled(ir::ValueId(inst.a).valid() ? "if (" + Value(inst.a) + ") " + departure : departure, id));
}

void PartPrinter::Repeat(ir::InstId id, const ir::Inst& inst) {
  const ir::PlaceId budget = program_.loops[ir::LoopId(program_[ir::InstId(inst.payload)].payload)].budget;
  const std::string left = SpellPlace(emittable_, budget, {}).text.chars;
  const bool local = emittable_.layout.places[budget.index].storage == layout::Storage::kLocal;
  const bool conditional = ir::ValueId(inst.a).valid();
  if (conditional) {
    Line("if (" + Value(inst.a) + ") {");
    ++indent_;
  }
  Line(Spelled("if (" + left + " != 0) {", id));
  ++indent_;
  Line(local ? "--" + left + ";" : left + " = " + left + " - 1;");
  Line(Departure(id));
  --indent_;
  Line("}");
  if (ir::RegionId(inst.b).valid()) RegionBody(ir::RegionId(inst.b));
  if (conditional) {
    --indent_;
    Line("}");
  }
}

}  // namespace plcxx::emit::print
