// Changes of a program: which there are, and that each leaves a program that the simulator can execute.
#include "transpiler/mutate/changes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "transpiler/ir/printer.h"
#include "transpiler/ir/reader.h"
#include "transpiler/ir/verifier.h"

namespace plcxx::mutate {
namespace {

/// Series and parallel contacts, a limit, a timer, a call.
ir::Program Sample() {
  return ir::ReadOrDie(R"(
    space m 4 volatile little
    place a bit m[0].0
    place b bit m[0].1
    place c bit m[0].2
    place q bit m[0].3
    place n i16 m[2]
    state t on_delay_timer
    host report (level : i16) "a level"
    routine fast fast {
      stmt s1
      %0 = load a
      %1 = load b
      %2 = load c
      %3 = and.bit %0 %1
      %4 = and.bit %3 %2
      store q %4
      stmt s2
      %5 = load n
      %6 = const i16 7
      %7 = ult.i16 %5 %6
      if %7 {
        %8 = const i16 0
        store n %8
        host report (%6)
      }
    })");
}

std::vector<std::string> TextsOf(const std::vector<Change>& changes) {
  std::vector<std::string> texts;
  for (const Change& change : changes) texts.push_back(change.text);
  return texts;
}

TEST(Changes, AreThoseOfTheStatements) {
  const ir::Program program = Sample();
  const source::SourceManager sources;
  const std::vector<std::string> texts = TextsOf(FindChanges(program, sources));
  EXPECT_EQ(texts, (std::vector<std::string>{
                       // In a series the first contact that is always 0 stands for the others.
                       "a is always 0", "a is always 1", "b is always 1", "'and' becomes 'or'", "c is always 1",
                       "'and' becomes 'or'", "q is not written", "7 becomes one more", "7 becomes one less",
                       "'less' becomes 'less or equal'", "the condition is always 0", "the condition is always 1",
                       "0 becomes one more", "n is not written", "7 becomes one more", "7 becomes one less",
                       "report is not called"}));
}

// Nobody has written these numbers, and a routine may tell them on.
TEST(Changes, WhatAFaultSaysOfItselfIsNone) {
  ir::Program program = ir::ReadOrDie(R"(
    space m 4 volatile little
    place a bit m[0].0
    space own 8 routine little own
    place at i32 own[0]
    host fault (kind : i8, number : i32)
    routine tell subroutine (at : i32 = at) {
      stmt s1
      %0 = load at
      %1 = const i8 2
      host fault (%1, %0)
    }
    routine fast fast {
      stmt s2
      %2 = load a
      if %2 {
        %3 = const i32 1151664144
        call tell (%3)
        %4 = const i8 3
        host fault (%4, %3)
      }
    })");
  for (uint32_t i = 0; i < program.statements.size(); ++i) program.statements[ir::StatementId(i)].id = 1151664143 + i;
  EXPECT_EQ(TextsOf(FindChanges(program, source::SourceManager())),
            (std::vector<std::string>{"fault is not called", "a is always 0", "a is always 1", "tell is not called",
                                      "fault is not called"}));
}

TEST(Changes, LeaveAProgramAndChangeIt) {
  const ir::Program program = Sample();
  const std::string before = ir::Print(program);
  for (const Change& change : FindChanges(program, source::SourceManager())) {
    ir::Program changed = program;
    Apply(change, changed);
    EXPECT_NE(ir::Print(changed), before) << change.text;
    EXPECT_TRUE(change.statement.valid());
  }
}

TEST(OperatorChange, TakesAndGivesTheSame) {
  std::set<ir::OpKind> from;
  for (const OperatorChange& change : OperatorChanges()) {
    const ir::OpInfo& one = ir::Info(change.from);
    const ir::OpInfo& other = ir::Info(change.to);
    const std::string name(one.text);
    EXPECT_TRUE(from.insert(change.from).second) << name << " stands twice";
    EXPECT_NE(change.from, change.to) << name;
    EXPECT_EQ(one.shape, other.shape) << name;
    EXPECT_EQ(one.state, other.state) << name;
    EXPECT_EQ(one.result, other.result) << name;
    ASSERT_EQ(one.operand_count, other.operand_count) << name;
    EXPECT_TRUE(std::equal(one.operands, one.operands + one.operand_count, other.operands)) << name;
  }
}

}  // namespace
}  // namespace plcxx::mutate
