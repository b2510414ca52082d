// Registers and logic stack: what a few instructions leave in the IR.

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "transpiler/dialects/common/logic_stack.h"
#include "transpiler/dialects/common/register.h"
#include "transpiler/ir/printer.h"

namespace plcxx::dialects {
namespace {

class Logic : public testing::Test {
 protected:
  Logic() {
    const ir::SpaceId image = program_.spaces.Add({.name = "I", .title = "I", .bytes = 1, .host_visible = true});
    const ir::SpaceId locals =
        program_.spaces.Add({.name = "registers", .title = "", .bytes = 4, .lifetime = ir::Lifetime::kRoutine});
    for (uint8_t bit = 0; bit < 8; ++bit) {
      places_[bit] = program_.places.Add(
          {.name = std::string(1, static_cast<char>('a' + bit)), .type = ir::Type::kBit, .space = image, .bit = bit});
    }
    s_ = program_.places.Add({.name = "s", .type = ir::Type::kBit, .space = locals, .bit = 0});
    ax_ = program_.places.Add({.name = "ax", .type = ir::Type::kI16, .space = locals, .offset = 2});
    body_ = builder_.NewRegion();
    builder_.SetRegion(body_);
  }

  ir::ValueId Load(char name) { return builder_.Load(places_[name - 'a']); }
  void Store(char name, ir::ValueId value) { builder_.Store(places_[name - 'a'], value); }
  /// The instructions so far, each with the names of what it uses: "c = (a and b)".
  std::string Stores() const {
    std::string out;
    for (const ir::InstId id : program_.regions[body_].insts) {
      const ir::Inst& inst = program_[id];
      if (inst.op != ir::OpKind::kStore) continue;
      out += program_.places[ir::PlaceId(inst.payload)].name + " = " + Text(ir::ValueId(inst.a)) + "\n";
    }
    return out;
  }
  std::string Text(ir::ValueId value) const {
    const ir::Inst& inst = program_[value];
    switch (inst.op) {
      case ir::OpKind::kLoad:
        return program_.places[ir::PlaceId(inst.payload)].name;
      case ir::OpKind::kConst:
        return std::to_string(ir::ConstantValue(inst));
      case ir::OpKind::kBitNot:
        return "!" + Text(ir::ValueId(inst.a));
      case ir::OpKind::kBitAnd:
        return "(" + Text(ir::ValueId(inst.a)) + " & " + Text(ir::ValueId(inst.b)) + ")";
      case ir::OpKind::kBitOr:
        return "(" + Text(ir::ValueId(inst.a)) + " | " + Text(ir::ValueId(inst.b)) + ")";
      case ir::OpKind::kBitXor:
        return "(" + Text(ir::ValueId(inst.a)) + " ^ " + Text(ir::ValueId(inst.b)) + ")";
      default:
        return "?";
    }
  }

  ir::Program program_;
  ir::Builder builder_{program_};
  ir::FactChecks facts_{builder_};
  std::array<ir::PlaceId, 8> places_;
  ir::PlaceId s_, ax_;
  ir::RegionId body_;
};

TEST_F(Logic, LeftToRightWithoutPrecedence) {
  Register status(builder_, s_, facts_);
  LogicStack logic(builder_, status);
  logic.Operate(Join::kAnd, Load('a'));
  logic.Operate(Join::kOr, Load('b'));
  logic.Operate(Join::kAnd, Inverted(builder_, Load('c')));
  Store('d', logic.Value());
  EXPECT_EQ(Stores(), "d = ((a | b) & !c)\n");
}

TEST_F(Logic, AnEndedSequenceKeepsItsValueAndLoadsNext) {
  Register status(builder_, s_, facts_);
  LogicStack logic(builder_, status);
  logic.Operate(Join::kAnd, Load('a'));
  logic.EndSequence();
  EXPECT_TRUE(logic.first());
  Store('b', logic.Value());
  logic.Operate(Join::kOr, Load('c'));
  Store('d', logic.Value());
  EXPECT_EQ(Stores(), "b = a\nd = c\n");
}

TEST_F(Logic, AlternativesJoinAndBeforeOr) {
  Register status(builder_, s_, facts_);
  LogicStack logic(builder_, status);
  logic.Operate(Join::kAnd, Load('a'));
  logic.Operate(Join::kAnd, Load('b'));
  logic.BeginAlternative();
  logic.Operate(Join::kAnd, Load('c'));
  logic.BeginAlternative();
  logic.Operate(Join::kAnd, Load('d'));
  logic.Operate(Join::kAnd, Load('e'));
  EXPECT_TRUE(logic.JoinAlternatives());
  EXPECT_FALSE(logic.JoinAlternatives());
  Store('f', logic.Value());
  EXPECT_EQ(Stores(), "f = (((a & b) | c) | (d & e))\n");
}

TEST_F(Logic, AnEmptyStringIsNothingAndAnOrEndsOne) {
  Register status(builder_, s_, facts_);
  LogicStack logic(builder_, status);
  logic.Operate(Join::kAnd, Load('a'));
  logic.BeginAlternative();
  logic.Operate(Join::kOr, Load('b'));  // a, O, O b: joins first, so it does not load
  Store('c', logic.Value());
  EXPECT_EQ(Stores(), "c = (a | b)\n");
}

TEST_F(Logic, LevelsBeginEmpty) {
  Register status(builder_, s_, facts_);
  LogicStack logic(builder_, status);
  logic.Operate(Join::kAnd, Load('a'));
  logic.Push();
  EXPECT_TRUE(logic.first());
  logic.Operate(Join::kAnd, Load('b'));
  logic.BeginAlternative();
  logic.Operate(Join::kAnd, Load('c'));
  logic.Pop(Join::kAnd);
  Store('d', logic.Value());
  logic.EndSequence();
  logic.Push();
  logic.Operate(Join::kXor, Load('e'));
  logic.Pop(Join::kOr);  // the first operation of a sequence: loads
  Store('f', logic.Value());
  EXPECT_EQ(Stores(), "d = (a & (b | c))\nf = e\n");
}

TEST_F(Logic, AComparisonReplacesWhatWaits) {
  Register status(builder_, s_, facts_);
  LogicStack logic(builder_, status);
  logic.Operate(Join::kAnd, Load('a'));
  logic.BeginAlternative();
  logic.Replace(Load('b'));
  EXPECT_FALSE(logic.has_alternative());
  logic.Operate(Join::kAnd, Load('c'));
  Store('d', logic.Value());
  EXPECT_EQ(Stores(), "d = (b & c)\n");
}

TEST_F(Logic, TheRunTimeTellsWhatIsFirst) {
  Register status(builder_, s_, facts_);
  LogicStack logic(builder_, status);
  logic.OperateUnless(Load('f'), Join::kAnd, Load('a'));
  Store('b', logic.Value());
  logic.OperateUnless(Load('f'), Join::kOr, Load('c'));
  Store('d', logic.Value());
  EXPECT_EQ(Stores(), "b = ((s | f) & a)\nd = ((((s | f) & a) & !f) | c)\n");
}

TEST_F(Logic, ARegisterIsLoadedOnceAndStoredWhereItMustLast) {
  Register status(builder_, s_, facts_);
  Store('a', status.Get());
  Store('b', status.Get());
  status.Spill();  // nothing was set
  status.Set(Load('c'));
  status.EndStatement();
  Store('d', status.Get());
  EXPECT_EQ(Stores(), "a = s\nb = s\ns = c\nd = s\n");
}

TEST_F(Logic, AConstantSurvivesItsStatementButNoBorder) {
  Register status(builder_, s_, facts_);
  status.Set(builder_.Bit(1));
  EXPECT_EQ(status.Known(), 1u);
  status.EndStatement();
  Store('a', status.Get());
  status.Forget();
  Store('b', status.Get());
  status.Know(0);
  Store('c', status.Get());
  status.EndStatement();  // its place holds the 0 already
  EXPECT_EQ(Stores(), "s = 1\na = 1\nb = s\nc = 0\n");
}

}  // namespace
}  // namespace plcxx::dialects
