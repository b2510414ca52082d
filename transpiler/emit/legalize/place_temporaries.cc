// Decides which values become named locals.
//
//   %1 = load a; store a, x; store b, %1   ->   const bool t1 = a; a = x; b = t1
//
// All others are spelled inside the expression that uses them. A value may be spelled there when it is used once, in
// its own region, and nothing between its computation and its use could change what it reads, and when the expression
// does not grow beyond what compilers and readers take. (PlaceEffects decides the rest: whether anything asks for a
// value, and where what has an effect is spelled.)

#include <algorithm>

#include "transpiler/emit/legalize/steps.h"
#include "transpiler/ir/builder.h"

namespace plcxx::emit::legalize {
namespace {

/// Operations in one expression. Each may stand in brackets of its own, of which Clang takes 256 inside each other, and
/// GCC's memory grows with the square: 2,000 operations took it 4 GB, as many in parts of this size 0.1.
constexpr uint32_t kMostOperations = 128;

struct Temporaries {
  const ir::Program& program;
  std::vector<Form>& forms;
  std::vector<uint8_t> uses;         // by InstId, saturating
  std::vector<uint32_t> epoch;       // by InstId: effects executed before it
  std::vector<bool> reads;           // by InstId: its inline spelling reads memory or steps an instance
  std::vector<uint32_t> operations;  // by InstId: spelled in the expression of the value
  uint32_t now = 0;

  void CountUses();
  void Region(ir::RegionId region);
  void Consume(ir::ValueId value, bool only_unary, uint32_t at);
  void Measure(ir::InstId id);
  void CutLong(ir::InstId id);
  void MakeLocal(ir::ValueId value);
  bool IsLocal(ir::ValueId value) const { return forms[value.index] == Form::kLocal; }
};

void Temporaries::CountUses() {
  uses.assign(program.insts.size(), 0);
  for (const ir::Inst& inst : program.insts) {
    for (const ir::ValueId value : ir::UsedValues(program, inst)) {
      if (uses[value.index] < 255) ++uses[value.index];
    }
  }
}

/// A local is spelled where it is computed, and what it is made of inside it.
void Temporaries::MakeLocal(ir::ValueId value) {
  if (IsLocal(value)) return;
  forms[value.index] = Form::kLocal;
  const ir::Inst& inst = program[value];
  const ir::Shape shape = ir::Info(inst.op).shape;
  if (shape != ir::Shape::kPure && shape != ir::Shape::kLoad) return;  // its operands were consumed when it was met
  for (const ir::ValueId operand : ir::UsedValues(program, inst)) {
    Consume(operand, ir::Info(inst.op).operand_count == 1, epoch[value.index]);
  }
}

/// `value` is about to be spelled inside an instruction that runs at the epoch `at`.
void Temporaries::Consume(ir::ValueId value, bool only_unary, uint32_t at) {
  const ir::Inst& inst = program[value];
  if (IsLocal(value) || inst.op == ir::OpKind::kConst || inst.op == ir::OpKind::kPoison) return;
  const ir::Shape shape = ir::Info(inst.op).shape;
  const bool step = shape != ir::Shape::kPure && shape != ir::Shape::kLoad;
  const bool stale = reads[value.index] && epoch[value.index] != at;
  // A step's result may only be spelled where it is all that is evaluated: C++ leaves the order of operands open.
  if (uses[value.index] > 1 || stale || (step && !only_unary)) {
    MakeLocal(value);
    return;
  }
  if (step) return;  // its operands were consumed when it was met
  for (const ir::ValueId operand : ir::UsedValues(program, inst)) {
    Consume(operand, only_unary && ir::Info(inst.op).operand_count == 1, at);
  }
}

void Temporaries::Measure(ir::InstId id) {
  operations[id.index] = 1;
  for (const ir::ValueId operand : ir::UsedValues(program, program[id]))
    operations[id.index] += IsLocal(operand) ? 0 : operations[operand.index];
}

/// The longest operands of a value become locals until it is short enough.
void Temporaries::CutLong(ir::InstId id) {
  const std::vector<ir::ValueId> operands = ir::UsedValues(program, program[id]);
  for (Measure(id); operations[id.index] > kMostOperations; Measure(id)) {
    MakeLocal(*std::ranges::max_element(
        operands, {}, [this](ir::ValueId operand) { return IsLocal(operand) ? 0 : operations[operand.index]; }));
  }
}

void Temporaries::Region(ir::RegionId region) {
  for (const ir::InstId id : program.regions[region].insts) {
    const ir::Inst& inst = program[id];
    const ir::Shape shape = ir::Info(inst.op).shape;
    switch (shape) {
      case ir::Shape::kConst:
      case ir::Shape::kStatement:
        break;
      case ir::Shape::kLoad:
        epoch[id.index] = now;
        reads[id.index] = true;
        Measure(id);
        break;
      case ir::Shape::kPure: {
        epoch[id.index] = now;
        for (const ir::ValueId operand : ir::UsedValues(program, inst)) {
          const bool stale = reads[operand.index] && epoch[operand.index] != now;
          if (stale || (uses[operand.index] > 1 && program[operand].op != ir::OpKind::kConst)) MakeLocal(operand);
        }
        CutLong(id);
        for (const ir::ValueId operand : ir::UsedValues(program, inst)) {
          if (!IsLocal(operand) && reads[operand.index]) reads[id.index] = true;
        }
        break;
      }
      case ir::Shape::kStep:
      case ir::Shape::kStore:
      case ir::Shape::kText:
      case ir::Shape::kIf:
      case ir::Shape::kSwitch:
      case ir::Shape::kLoop:
      case ir::Shape::kBlock:
      case ir::Shape::kExit:
      case ir::Shape::kRepeat:
      case ir::Shape::kCall:
      case ir::Shape::kHostCall:
      case ir::Shape::kJump:
      case ir::Shape::kLabel: {
        const std::vector<ir::ValueId> operands = ir::UsedValues(program, inst);
        for (const ir::ValueId operand : operands) Consume(operand, operands.size() == 1, now);
        Measure(id);
        if (shape != ir::Shape::kBlock) ++now;  // to enter a block does nothing
        epoch[id.index] = now;
        reads[id.index] = true;
        for (const ir::RegionId owned : ir::OwnedRegions(program, inst)) {
          Region(owned);
          ++now;
        }
        if (ir::Info(inst.op).effect == ir::Effect::kControl && !ir::OwnedRegions(program, inst).empty())
          epoch[id.index] = now;
        break;
      }
    }
  }
  ++now;
}

}  // namespace

void PlaceTemporaries(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  const size_t count = program.insts.size();
  emittable.forms.assign(count, Form::kNowhere);
  Temporaries temporaries{program,
                          emittable.forms,
                          {},
                          std::vector<uint32_t>(count, 0),
                          std::vector<bool>(count, false),
                          std::vector<uint32_t>(count, 0)};
  temporaries.CountUses();
  for (const ir::Routine& routine : program.routines) {
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      if (region.valid()) temporaries.Region(region);
    }
  }
}

}  // namespace plcxx::emit::legalize
