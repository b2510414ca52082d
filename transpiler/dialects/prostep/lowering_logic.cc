// Logic operations, brackets, comparisons, = S R (specification 6.1 to 6.3).

#include "transpiler/dialects/prostep/lowering_internal.h"

namespace plcxx::prostep {

using dialects::Inverted;
using dialects::Join;
using ir::OpKind;
using ir::ValueId;

void Lowering::Decided(uint64_t first) {
  if (first_ != nullptr) first_->Set(builder_.Bit(first));
}

void Lowering::Operate(Join join, ValueId operand) {
  // Inside brackets and OR strings the text decides in both readings.
  if (first_ != nullptr && logic_->depth() == 0 && !logic_->has_alternative()) {
    const std::optional<uint64_t> first = first_->Known();
    if (!first) {
      logic_->OperateUnless(first_->Get(), join, operand);
      Decided(0);
      return;
    }
    if (*first != 0) {
      logic_->EndSequence();
    } else {
      logic_->ContinueSequence();
    }
  }
  logic_->Operate(join, operand);
  if (logic_->depth() == 0) Decided(0);
}

void Lowering::Fold() {
  if (logic_->JoinAlternatives() && logic_->depth() == 0) Decided(0);
}

void Lowering::BeginString() {
  Fold();
  if (first_ == nullptr || logic_->depth() > 0) return logic_->BeginAlternative();
  const std::optional<uint64_t> first = first_->Known();
  if (!first) {
    const ValueId before = dialects::Joined(builder_, Join::kAnd, logic_->Value(), Inverted(builder_, first_->Get()));
    return logic_->BeginAlternative(before);
  }
  logic_->BeginAlternative(*first != 0 ? builder_.Bit(0) : logic_->Value());
}

void Lowering::Open(Join join) {
  if (join == Join::kOr) Fold();
  brackets_.push_back(join);
  logic_->Push();
}

void Lowering::Close() {
  const Join join = brackets_.back();
  brackets_.pop_back();
  Operate(join, logic_->Pop());
}

ValueId Lowering::ReadBit(const Operand& operand) {
  switch (operand.shape()) {
    case Shape::kCounter:
      return builder_.Pure(OpKind::kNotEqual16, {builder_.Load(ValueOf(operand.number)), Word(0)});
    case Shape::kTimer:
      return builder_.Load(OutputOf(operand.number));
    case Shape::kBit:
      break;
    case Shape::kByte:
    case Shape::kWord:
    case Shape::kDouble:
    case Shape::kConstant:
    case Shape::kModule:
    case Shape::kFunction:
      PLCXX_UNREACHABLE();
  }
  if (operand.space() != Space::kP) return builder_.Load(BitPlace(operand));
  return builder_.Pure(OpKind::kTestBit8, {ReadPort(operand.number), Byte(operand.bit)});
}

void Lowering::Assign(const Operand& target) {
  builder_.Store(BitPlace(target), logic_->Value());
  if (target.space() == Space::kP) SendLatch(target.number);
}

/// Without a branch, so that the worst scan costs what the mean one costs: x | S and x & !S.
void Lowering::SetOrReset(const Operand& target, bool set) {
  const ir::PlaceId place = BitPlace(target);
  if (target.space() == Space::kP) {  // with S = 0 the port is not touched
    return builder_.When(logic_->Value(), [&] {
      builder_.Store(place, builder_.Bit(set ? 1 : 0));
      SendLatch(target.number);
    });
  }
  const ValueId before = builder_.Load(place);
  const ValueId value = set ? dialects::Joined(builder_, Join::kOr, before, logic_->Value())
                            : dialects::Joined(builder_, Join::kAnd, before, Inverted(builder_, logic_->Value()));
  builder_.Store(place, value);
}

namespace {

struct CompareRow {
  Op op;
  OpKind bytes, words;
};
constexpr CompareRow kCompares[] = {
    {Op::kEqual, OpKind::kEqual8, OpKind::kEqual16},
    {Op::kNotEqual, OpKind::kNotEqual8, OpKind::kNotEqual16},
    {Op::kLess, OpKind::kSignedLess8, OpKind::kSignedLess16},
    {Op::kLessEqual, OpKind::kSignedLessEqual8, OpKind::kSignedLessEqual16},
    {Op::kGreater, OpKind::kSignedGreater8, OpKind::kSignedGreater16},
    {Op::kGreaterEqual, OpKind::kSignedGreaterEqual8, OpKind::kSignedGreaterEqual16},
};

}  // namespace

void Lowering::Compare(const Instruction& instruction) {
  const CompareRow* row = nullptr;
  for (const CompareRow& candidate : kCompares) {
    if (candidate.op == instruction.op) row = &candidate;
  }
  PLCXX_CHECK(row != nullptr);
  const bool byte = instruction.operand.shape() == Shape::kByte;
  const ValueId left = byte ? LowByte() : ax_->Get();
  const ValueId right = ReadData(instruction.operand);
  builder_.SetRange(instruction.whole);
  logic_->Replace(builder_.Pure(byte ? row->bytes : row->words, {left, right}));
  if (logic_->depth() == 0) Decided(0);
}

}  // namespace plcxx::prostep
