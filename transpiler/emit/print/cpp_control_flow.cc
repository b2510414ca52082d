// If, switch, loops, blocks, and the ways out of them.

#include <algorithm>
#include <optional>

#include "transpiler/emit/print/part_printer.h"
#include "transpiler/ir/builder.h"
#include "transpiler/support/check.h"

namespace plcxx::emit::print {
namespace {

Text Bracketed(const Spelling& spelling) {
  return spelling.precedence <= ir::Precedence::kUnary ? spelling.text : "(" + spelling.text + ")";
}

}  // namespace

/// A condition, switched off together with its statement in the debug flavour.
Text PartPrinter::Condition(ir::InstId id) const {
  const Spelling condition = Spell(emittable_, ir::ValueId(program_[id].a));
  const Switch* of = SwitchOf(id);
  if (of == nullptr) return condition.text;
  const std::string on = On(of->statement);
  switch (of->joint) {
    case Switch::Joint::kAnd:
    case Switch::Joint::kLoop:
    case Switch::Joint::kValue:
      return on + " & " + Bracketed(condition);
    case Switch::Joint::kOnlyIfOn:
      return on + " && " + Bracketed(condition);
    case Switch::Joint::kUnlessOff:
      return "!" + on + " || " + Bracketed(condition);
  }
  PLCXX_UNREACHABLE();
}

void PartPrinter::If(ir::InstId id) {
  const ir::StatementId outer = statement_;
  Line(Spelled("if (" + Condition(id) + ") {", id));
  for (ir::InstId at = id; at.valid();) {
    const ir::Inst& inst = program_[at];
    ++indent_;
    RegionBody(ir::RegionId(inst.b));
    --indent_;
    const ElseArm& arm = emittable_.else_arms.at(at.index);
    std::string before = "} ";
    if (arm.statement.valid()) {
      Line("}");
      statement_ = arm.statement;
      StatementComments(program_.statements[statement_]);
      before.clear();
    }
    switch (arm.kind) {
      case ElseArm::Kind::kNone:
        Line("}");
        break;
      case ElseArm::Kind::kBlock:
        Line("} else {");
        ++indent_;
        RegionBody(ir::RegionId(inst.c));
        --indent_;
        Line("}");
        break;
      case ElseArm::Kind::kBehind:
        if (arm.leave != Leave::kFallsThrough) {
          ++indent_;
          Line(Word(arm.leave));
          --indent_;
        }
        Line("}");
        if (indent_ == 1) BlankLine();  // as between other statements
        RegionBody(ir::RegionId(inst.c));
        break;
      case ElseArm::Kind::kIf:
        Line(Spelled(before + "else if (" + Condition(arm.chained) + ") {", arm.chained));
        break;
      case ElseArm::Kind::kAlways:
        Line(Spelled(before + "else {", arm.chained));
        break;
    }
    at = arm.chained;
  }
  statement_ = outer;
}

void PartPrinter::SwitchOver(ir::InstId id) {
  const ir::Inst& inst = program_[id];
  const std::vector<ir::SwitchCase>& arms = program_.switches[ir::SwitchId(inst.payload)].cases;
  // A label must be a value of the type in which C++ computes what it compares.
  constexpr uint64_t kMostOfInt = 0x7FFF'FFFF;
  const bool has_large = std::ranges::any_of(arms, [](const ir::SwitchCase& arm) {
    return std::ranges::any_of(arm.values, [](uint64_t value) { return value > kMostOfInt; });
  });
  const ir::ValueId selector(inst.a);
  Text spelled = has_large ? SpellInItsType(emittable_, selector) : Value(inst.a);
  // Clang takes a switch over a condition for a mistake.
  if (IsSpelledAsBool(emittable_, selector)) spelled = Text("static_cast<int>(") + spelled + ")";
  Line(Spelled("switch (" + spelled + ") {", id));
  ++indent_;
  for (size_t arm_index = 0; arm_index < arms.size(); ++arm_index) {
    const ir::SwitchCase& arm = arms[arm_index];
    const ArmEnd arm_end = emittable_.arm_ends[inst.payload][arm_index];
    if (arm.values.empty()) {
      Line("default: {");
    } else {
      for (size_t i = 0; i < arm.values.size(); ++i) {
        Line("case " + IntegerText(arm.values[i], arm.Base(i)) + (i + 1 < arm.values.size() ? ":" : ": {"));
      }
    }
    ++indent_;
    RegionBody(arm.region);
    if (arm_end == ArmEnd::kBreak) Line("break;");
    --indent_;
    Line("}");
    if (arm_end == ArmEnd::kFallsThrough) Line("[[fallthrough]];");
  }
  --indent_;
  Line("}");
}

/// A label stands one step to the left of what it labels.
void PartPrinter::Label(const std::string& label) {
  if (label.empty()) return;
  if (indent_ == 1) BlankLine();  // it belongs to what follows
  --indent_;
  Line(label + ":;");
  ++indent_;
  last_ = Last::kLabel;
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
  if (labels.ends_with_break) Line("break;");
  --indent_;
  Line("}");
  Label(labels.behind);
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
  spelled_.Add(Spelled("", id));
  const Landing& labels = emittable_.landings.at(id.index);
  if (loop.kind == ir::LoopBound::kBudget) {
    loops_.push_back({out_.line(), std::nullopt, loop.budget});
    BudgetLoop(loop, labels);
    return;
  }
  loops_.push_back({out_.line(), loop.bound});
  const Switch* of = SwitchOf(id);
  Spelling condition;
  if (loop.condition.valid()) condition = Spell(emittable_, program_.regions[loop.condition].insts.back());
  Text in_head = labels.condition_in_head ? condition.text : Text();
  if (labels.condition_in_head && of != nullptr) in_head = "(" + On(of->statement) + " & " + Bracketed(condition) + ")";
  Line(LoopHead(loop, labels.counter, in_head));
  ++indent_;
  if (loop.condition.valid() && !labels.condition_in_head) {
    // Switched off, it asks nothing.
    if (of != nullptr) Line("if (!" + On(of->statement) + ") break;");
    Range(loop.condition, 0, static_cast<uint32_t>(program_.regions[loop.condition].insts.size()));
    Line("if (!" + Bracketed(condition) + ") break;");
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

/// "return;", "break;"
std::string PartPrinter::Word(Leave leave) const {
  switch (leave) {
    case Leave::kReturn:
      return return_;
    case Leave::kBreak:
      return "break;";
    case Leave::kContinue:
      return "continue;";
    case Leave::kFallsThrough:
    case Leave::kGoto:
      break;  // has no text; has a label, too
  }
  PLCXX_UNREACHABLE();
}

/// "return;", "goto to_U4A8;"
std::string PartPrinter::Departure(ir::InstId id) const {
  const Leave leave = emittable_.leaves.at(id.index);
  if (leave != Leave::kGoto) return Word(leave);
  const ir::Inst& inst = program_[id];
  const Landing& landing = emittable_.landings.at(inst.payload);
  return "goto " + (inst.op == ir::OpKind::kRepeat ? landing.again : landing.behind) + ";";
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
