// The emittable program as text: what was decided, in the order of the program.

#include "transpiler/emit/function_insts.h"
#include "transpiler/emit/print/print.h"
#include "transpiler/ir/builder.h"

namespace plcxx::emit::print {
namespace {

/// The text of a function as it was decided: what has lines or a name, and how branches are written.
class FunctionText {
 public:
  FunctionText(const Emittable& emittable, std::string& out)
      : emittable_(emittable), program_(*emittable.program), out_(out) {}

  void Run(const std::string& name, const Locals& locals, const std::vector<Piece>& pieces);

 private:
  void Pieces(const std::vector<Piece>& pieces);
  void Inst(ir::InstId id);
  std::string Decisions(ir::InstId id) const;
  std::string OfIf(const ElseArm& arm) const;
  std::string OfLanding(const Landing& landing) const;
  std::string OfLeave(ir::InstId id) const;
  std::string OfSwitch(ir::InstId id) const;
  void Guards(const Piece& piece);
  void Line(const std::string& text) { out_ += std::string(2 * depth_, ' ') + text + "\n"; }

  const Emittable& emittable_;
  const ir::Program& program_;
  std::string& out_;
  size_t depth_ = 0;
};

void FunctionText::Run(const std::string& name, const Locals& locals, const std::vector<Piece>& pieces) {
  std::string head = "function " + name;
  for (const Parameter& parameter : locals.parameters)
    head += ", " + parameter.type + " " + parameter.name + (parameter.used ? "" : " unused");
  Line(head);
  ++depth_;
  for (const Locals::Declared& local : locals.declared)
    Line("variable " + emittable_.place_names[local.place.index] + (local.read ? "" : ", never read") +
         (local.first.valid() ? ", first value in its declaration" : ""));
  Pieces(pieces);
  --depth_;
}

void FunctionText::Guards(const Piece& piece) {
  for (const Guard& guard : emittable_.guards[piece.region.index]) {
    if (guard.begin < piece.begin || guard.end > piece.end) continue;
    Line("guard of " + program_.statements[guard.statement].subject + ": " + std::to_string(guard.begin) + " to " +
         std::to_string(guard.end));
  }
}

void FunctionText::Pieces(const std::vector<Piece>& pieces) {
  for (const Piece& piece : pieces) {
    if (piece.chunk != Piece::kInPlace) {
      Line("call " + emittable_.chunks[piece.chunk].name);
      continue;
    }
    Guards(piece);
    for (uint32_t i = piece.begin; i < piece.end; ++i) Inst(program_.regions[piece.region].insts[i]);
  }
}

std::string WordOf(Leave leave) {
  switch (leave) {
    case Leave::kFallsThrough:
      return " to what follows";
    case Leave::kReturn:
      return " by return";
    case Leave::kBreak:
      return " by break";
    case Leave::kContinue:
      return " by continue";
    case Leave::kGoto:
      return " by goto";
  }
  return "";
}

std::string FunctionText::OfIf(const ElseArm& arm) const {
  const std::string comments = arm.statement.valid() ? " behind comments" : "";
  switch (arm.kind) {
    case ElseArm::Kind::kNone:
      return "";
    case ElseArm::Kind::kBlock:
      return ", else";
    case ElseArm::Kind::kBehind:
      return std::string(arm.leave == Leave::kFallsThrough ? "" : ", its arm ends" + WordOf(arm.leave)) +
             ", the other arm behind it";
    case ElseArm::Kind::kIf:
      return ", else if" + comments;
    case ElseArm::Kind::kAlways:
      return ", else of a chain" + comments;
  }
  return "";
}

std::string FunctionText::OfLanding(const Landing& landing) const {
  std::string text;
  if (!landing.behind.empty()) text += ", label " + landing.behind;
  if (!landing.again.empty()) text += ", label at its head " + landing.again;
  if (!landing.counter.empty()) text += ", counter " + landing.counter;
  if (landing.braces) text += ", braces";
  if (landing.condition_in_head) text += ", condition in the head";
  if (landing.ends_with_break) text += ", break at its end";
  return text;
}

std::string FunctionText::OfLeave(ir::InstId id) const {
  const ir::Inst& inst = program_[id];
  const Leave leave = emittable_.leaves.at(id.index);
  if (leave != Leave::kGoto) return WordOf(leave);
  const Landing& landing = emittable_.landings.at(inst.payload);
  return WordOf(leave) + " " + (inst.op == ir::OpKind::kRepeat ? landing.again : landing.behind);
}

std::string FunctionText::OfSwitch(ir::InstId id) const {
  const auto found = emittable_.switches.find(id.index);
  if (found == emittable_.switches.end()) return "";
  switch (found->second.joint) {
    case Switch::Joint::kAnd:
      return ", switched by &";
    case Switch::Joint::kOnlyIfOn:
      return ", switched by &&";
    case Switch::Joint::kUnlessOff:
      return ", switched by ||";
    case Switch::Joint::kValue:
      return ", switched by ?";
    case Switch::Joint::kLoop:
      return ", switched as a loop";
  }
  return "";
}

std::string FunctionText::Decisions(ir::InstId id) const {
  const ir::Inst& inst = program_[id];
  std::string text;
  if (inst.op == ir::OpKind::kIf && emittable_.else_arms.contains(id.index))
    text += OfIf(emittable_.else_arms.at(id.index));
  if (inst.op == ir::OpKind::kExit || inst.op == ir::OpKind::kRepeat) text += OfLeave(id);
  if (emittable_.returns.contains(id.index)) text += ", as a return";
  if (emittable_.landings.contains(id.index)) text += OfLanding(emittable_.landings.at(id.index));
  if (inst.op == ir::OpKind::kSwitch) {
    static constexpr std::string_view kEnds[] = {"break", "fallthrough", "nothing"};
    text += ", arms end with";
    for (const ArmEnd end : emittable_.arm_ends[inst.payload])
      text += " " + std::string(kEnds[static_cast<size_t>(end)]);
  }
  return text + OfSwitch(id);
}

void FunctionText::Inst(ir::InstId id) {
  static constexpr std::string_view kForms[] = {"nowhere", "inside", "local", "line"};
  static constexpr std::string_view kWordings[] = {"",
                                                   ", as a call",
                                                   ", as its complement",
                                                   ", as a discarded value",
                                                   ", as a negative number",
                                                   ", as a subtraction"};
  const ir::Inst& inst = program_[id];
  const Form form = emittable_.forms[id.index];
  const Wording wording = emittable_.wordings[id.index];
  if (inst.op == ir::OpKind::kStatement) {
    Line("stmt " + program_.statements[ir::StatementId(inst.payload)].subject);
    return;
  }
  if (IsEffect(emittable_, id) || form == Form::kLocal || wording != Wording::kTable) {
    const std::string name = form == Form::kLocal ? " " + emittable_.value_names[id.index] : "";
    const std::string loose = emittable_.loose_locals.contains(id.index) ? "loose " : "";
    Line(loose + std::string(kForms[static_cast<size_t>(form)]) + name + ": " + std::string(ir::Info(inst.op).text) +
         std::string(kWordings[static_cast<size_t>(wording)]) + Decisions(id));
  }
  ++depth_;
  for (const ir::RegionId owned : ir::OwnedRegions(program_, inst)) Pieces(PiecesOf(emittable_, owned));
  --depth_;
}

}  // namespace

std::string PrintEmittable(const Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  std::string out = "emittable " + emittable.namespace_name + "\n";
  for (const layout::Member& member : emittable.layout.members) {
    out += "member " + member.name + " : " + member.element + "[" + std::to_string(member.count) + "] at " +
           std::to_string(member.offset) + "\n";
  }
  static constexpr std::string_view kStorage[] = {"none",
                                                  "bit",
                                                  "byte",
                                                  "packed_bit",
                                                  "word16",
                                                  "word32",
                                                  "word64",
                                                  "float32",
                                                  "float64",
                                                  "wide",
                                                  "indexed",
                                                  "retentive_byte",
                                                  "retentive_bit",
                                                  "retentive_wide",
                                                  "retentive_indexed",
                                                  "field",
                                                  "local"};
  for (uint32_t i = 0; i < program.places.size(); ++i) {
    if (emittable.place_names[i].empty()) continue;
    const layout::PlaceStorage& stored = emittable.layout.places[i];
    out += "place " + emittable.place_names[i] + " " + std::string(kStorage[static_cast<size_t>(stored.storage)]) +
           " at " + std::to_string(stored.offset) + (stored.bit != 0 ? "." + std::to_string(stored.bit) : "") + "\n";
  }
  for (const Chunk& chunk : emittable.chunks) {
    out += "chunk " + chunk.name + " " + std::to_string(chunk.statements) + " statements, file " +
           emittable.options.name + emittable.parts[chunk.part].suffix + ".cpp\n";
  }
  for (const Chunk& chunk : emittable.chunks)
    FunctionText(emittable, out).Run(chunk.name, chunk.locals, {PieceOf(chunk)});
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    FunctionText(emittable, out)
        .Run(emittable.routine_names[i], emittable.routine_locals[i], PiecesOf(emittable, ir::RoutineId(i)));
  }
  return out;
}

}  // namespace plcxx::emit::print
