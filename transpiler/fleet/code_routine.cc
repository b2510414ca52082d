// One routine as text: its instructions, in pieces that a compiler can hold.

#include <algorithm>

#include "transpiler/fleet/code_writer.h"
#include "transpiler/ir/builder.h"
#include "transpiler/support/check.h"

namespace plcxx::fleet {
namespace {

/// Instructions of one function of the generated code; a statement is never cut.
constexpr size_t kMostInstructions = 400;

enum class Needs : uint8_t { kNothing, kConstant, kClock };

struct SlicedForm {
  ir::OpKind op;
  Needs needs;
  int constant;  // the operand that has to be one
  const char* function;
};

constexpr SlicedForm kSlicedForms[] = {
#define PLCXX_SLICED(Kind, function) {ir::OpKind::k##Kind, Needs::kNothing, -1, function},
#define PLCXX_SLICED_BY(Kind, operand, function) {ir::OpKind::k##Kind, Needs::kConstant, operand, function},
#define PLCXX_SLICED_CLOCK(Kind, function) {ir::OpKind::k##Kind, Needs::kClock, -1, function},
#include "transpiler/fleet/sliced_operations.def"
#undef PLCXX_SLICED
#undef PLCXX_SLICED_BY
#undef PLCXX_SLICED_CLOCK
};

uint32_t Operand(const ir::Inst& inst, int i) { return i == 0 ? inst.a : i == 1 ? inst.b : inst.c; }

bool IsConstant(const ir::Program& program, uint32_t value) {
  return program[ir::InstId(value)].op == ir::OpKind::kConst;
}

/// Null: it is executed lane by lane.
const SlicedForm* FindForm(const ir::Program& program, const ir::Inst& inst, bool has_clock) {
  const auto fits = [&](const SlicedForm& one) {
    switch (one.needs) {
      case Needs::kNothing:
        return true;
      case Needs::kConstant:
        return IsConstant(program, Operand(inst, one.constant));
      case Needs::kClock:
        return has_clock;
    }
    return false;
  };
  const auto* const form =
      std::ranges::find_if(kSlicedForms, [&](const SlicedForm& one) { return one.op == inst.op && fits(one); });
  return form == std::end(kSlicedForms) ? nullptr : form;
}

std::string ConstantText(const ir::Inst& inst) {
  if (inst.type == ir::Type::kBit) return ir::ConstantValue(inst) != 0 ? "Ones()" : "Zeros()";
  return "Fixed<" + std::string(ir::CppName(inst.type)) + ", " + std::to_string(ir::ConstantValue(inst)) + "ull>{}";
}

size_t Instructions(const ir::Program& program, const ir::Inst& inst) {
  size_t count = 1;
  if (ir::Info(inst.op).effect != ir::Effect::kControl) return count;
  for (const ir::RegionId region : ir::OwnedRegions(program, inst))
    ir::ForEachInst(program, region, [&](ir::InstId) { ++count; });
  return count;
}

}  // namespace

std::string ValueName(ir::ValueId id) { return "v" + std::to_string(id.index); }

std::string RowsOf(const ir::Program& program, ir::ValueId id) {
  return "In<" + std::string(ir::CppName(program[id].type)) + ">(" + ValueName(id) + ")";
}

std::string RoutineWriter::Write() {
  const ir::Routine& routine = program_.routines[routine_];
  contexts_ = {{"active", ir::InstId(), false}};
  for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) WriteTop(region);
  EndPiece();
  return "// " + routine.name + "\n" + text_ + "template <class M>\nvoid R" + std::to_string(routine_.index) +
         "(State& m, const M& active) {\n" + calls_ + "}\n";
}

void RoutineWriter::EndPiece() {
  if (out_.empty()) return;
  const std::string name = "R" + std::to_string(routine_.index) + "_" + std::to_string(pieces_++);
  text_ += "template <class M>\n[[gnu::noinline]] void " + name + "(State& m, const M& active) {\n" + out_ + "}\n";
  calls_ += "  " + name + "(m, active);\n";
  out_.clear();
}

/// A value never crosses a statement of a routine's outermost region.
void RoutineWriter::WriteTop(ir::RegionId region) {
  if (!region.valid()) return;
  EndPiece();
  size_t instructions = 0;
  for (const ir::InstId id : program_.regions[region].insts) {
    const ir::Inst& inst = program_[id];
    if (inst.op == ir::OpKind::kStatement && instructions > kMostInstructions) {
      EndPiece();
      instructions = 0;
    }
    instructions += Instructions(program_, inst);
    WriteInst(id);
  }
}

void RoutineWriter::WriteRegion(ir::RegionId region) {
  if (!region.valid()) return;
  for (const ir::InstId id : program_.regions[region].insts) WriteInst(id);
}

void RoutineWriter::WriteInst(ir::InstId id) {
  const ir::Inst& inst = program_[id];
  switch (ir::Info(inst.op).shape) {
    case ir::Shape::kPure:
      return WritePure(id, inst);
    case ir::Shape::kStep:
      return WriteStep(id, inst);
    case ir::Shape::kConst:
      out_ += "const auto " + ValueName(id) + " = " + ConstantText(inst) + ";\n";
      return;
    case ir::Shape::kLoad:
      Count(share_, places_.IsPerLane(ir::PlaceId(inst.payload)));
      out_ += "const auto " + ValueName(id) + " = " +
              places_.Load(ir::PlaceId(inst.payload), ir::ValueId(inst.a), Mask()) + ";\n";
      return;
    case ir::Shape::kStore:
      return WriteStore(inst);
    case ir::Shape::kText:
      return WriteUpdateText(inst);
    case ir::Shape::kStatement:
      return;
    case ir::Shape::kIf:
      return WriteIf(inst);
    case ir::Shape::kSwitch:
      return WriteSwitch(inst);
    case ir::Shape::kLoop:
      return WriteLoop(id, inst);
    case ir::Shape::kBlock:
      return WriteBlock(id, inst);
    case ir::Shape::kExit:
      return WriteExit(inst);
    case ir::Shape::kRepeat:
      return WriteRepeat(inst);
    case ir::Shape::kCall:
      return WriteCall(id, inst);
    case ir::Shape::kHostCall:
      return WriteHostCall(id, inst);
    case ir::Shape::kJump:
    case ir::Shape::kLabel:
      PLCXX_UNREACHABLE();  // structuring has replaced both
  }
  PLCXX_UNREACHABLE();
}

std::string RoutineWriter::Scalar(ir::ValueId id) const {
  const ir::Inst& inst = program_[id];
  if (inst.op != ir::OpKind::kConst) return ValueName(id) + ".value";
  if (inst.type == ir::Type::kBit) return ir::ConstantValue(inst) != 0 ? "true" : "false";
  return ValueName(id) + "[0]";
}

/// Whatever form the place has.
void RoutineWriter::StoreInto(ir::PlaceId place, ir::ValueId value) {
  out_ += (places_.IsScalar(place) ? places_.StoreScalar(place, Scalar(value))
                                   : places_.Store(place, ir::ValueId(), ValueName(value), Mask())) +
          "\n";
}

void RoutineWriter::WriteStore(const ir::Inst& inst) {
  const ir::PlaceId place(inst.payload);
  Count(share_, places_.IsPerLane(place));
  if (!ir::ValueId(inst.b).valid()) return StoreInto(place, ir::ValueId(inst.a));
  out_ += places_.Store(place, ir::ValueId(inst.b), ValueName(ir::ValueId(inst.a)), Mask()) + "\n";
}

void RoutineWriter::WritePure(ir::InstId id, const ir::Inst& inst) {
  const ir::OpInfo& info = ir::Info(inst.op);
  if (same_.Value(id)) {
    Count(share_, false);
    out_ += "const auto " + ValueName(id) + " = Uniform<" + std::string(ir::CppName(info.result)) +
            ">{plcxx::" + std::string(info.function) + "(";
    for (int i = 0; i < info.operand_count; ++i) out_ += (i > 0 ? ", " : "") + Scalar(ir::ValueId(Operand(inst, i)));
    out_ += ")};\n";
    return;
  }
  const SlicedForm* const form = FindForm(program_, inst, false);
  Count(share_, form == nullptr);
  std::string text = "const auto " + ValueName(id) + " = ";
  if (form != nullptr) {
    text += std::string(form->function) + "(";
  } else {
    text += "PerLane<" + std::string(ir::CppName(info.result)) +
            ">([](auto... value) { return plcxx::" + std::string(info.function) + "(value...); }, ";
  }
  for (int i = 0; i < info.operand_count; ++i) {
    const ir::ValueId operand(Operand(inst, i));
    text += (i > 0 ? ", " : "") + (form != nullptr ? ValueName(operand) : RowsOf(program_, operand));
  }
  out_ += text + ");\n";
}

void RoutineWriter::WriteStep(ir::InstId id, const ir::Inst& inst) {
  const ir::OpInfo& info = ir::Info(inst.op);
  const bool has_clock = layout_.clocks[inst.payload] != kNowhere;
  const SlicedForm* const form = FindForm(program_, inst, has_clock);
  Count(share_, form == nullptr);
  std::string first = std::to_string(layout_.fields[inst.payload].front());
  if (form != nullptr && form->needs == Needs::kClock) first += ", " + std::to_string(layout_.clocks[inst.payload]);
  const bool gives = info.result != ir::Type::kNone;
  std::string text = gives ? "const auto " + ValueName(id) + " = " : "";
  std::string operands;
  for (int i = 0; i < info.operand_count; ++i) {
    const ir::ValueId operand(Operand(inst, i));
    operands += ", " + (form != nullptr ? ValueName(operand) : RowsOf(program_, operand));
  }
  if (form != nullptr) {
    text += std::string(form->function) + "(m, " + first + operands + ", " + Mask() + ");\n";
  } else {
    const std::string kind(ir::Info(*info.state).struct_name);
    const std::string call = "plcxx::" + std::string(info.function) + "(instance, value...)";
    text += "StepPerLane<plcxx::" + kind + ", " + (gives ? std::string(ir::CppName(info.result)) : "uint8_t") +
            ">(m, " + first + ", " + Mask() + ", [](auto& instance, auto... value) { " +
            (gives ? "return " + call + ";" : call + "; return uint8_t{0};") + " }" + operands + ");\n";
  }
  out_ += text;
}

void RoutineWriter::WriteUpdateText(const ir::Inst& inst) {
  Count(share_, false);
  std::string literal;
  for (const char c : program_.texts[ir::TextId(inst.b)]) {
    const auto byte = static_cast<unsigned char>(c);
    const auto digit = [](unsigned value) { return static_cast<char>('0' + value); };
    literal += {'\\', digit(byte >> 6), digit(byte >> 3 & 7), digit(byte & 7)};
  }
  out_ += "UpdateText(m, " + std::to_string(layout_.fields[inst.payload].front()) + ", " +
          std::to_string(layout_.fields[inst.a].front()) + ", \"" + literal + "\", " + Mask() + ");\n";
}

}  // namespace plcxx::fleet
