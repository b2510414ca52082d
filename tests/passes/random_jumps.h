// Random jumps, and what is executed when they are followed: for the tests of what turns them into regions, and of what
// spells these as C++.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "tests/passes/passes_testing.h"

namespace plcxx::passes {

inline constexpr uint32_t kRounds = 7;  // of the budget
inline constexpr uint32_t kNoLabel = ~0u;

/// The stores to bits, in order; what is stored is not kept. The value of a bit depends on what was stored before, so
/// that a loop does not go round for ever the same way.
struct Follower {
  const ir::Program& program;
  uint32_t inputs;
  std::vector<uint32_t> trace = {};
  ir::InstId leaving = {};  // an Exit or Repeat was taken, to this block or loop
  bool repeats = false;
  uint32_t label = kNoLabel;  // a Jump was taken, to this label
  std::vector<uint64_t> values = {};
  uint64_t rounds = kRounds;
  std::vector<uint64_t> words = {};  // by PlaceId: where loops go on

  bool going() const { return !leaving.valid() && label == kNoLabel; }

  bool Bit(uint32_t place) const {
    const uint64_t mixed = (inputs + 1) * 2654435761u + place * 40503u + trace.size() * 97u;
    return ((mixed * 0x9E3779B97F4A7C15u) >> 40 & 1) != 0;
  }

  /// Whether a round is left of the budget; otherwise what is refused happens.
  bool TakeRound(ir::RegionId refused) {
    if (rounds > 0) {
      --rounds;
      return true;
    }
    if (refused.valid()) Region(refused);
    return false;
  }

  void Inst(ir::InstId id) {
    const ir::Inst& inst = program[id];
    const bool condition = !ir::ValueId(inst.a).valid() || inst.a >= values.size() || values[inst.a] != 0;
    const bool is_word = (inst.op == ir::OpKind::kLoad || inst.op == ir::OpKind::kStore) &&
                         program.places[ir::PlaceId(inst.payload)].type == ir::Type::kI32;
    switch (inst.op) {
      case ir::OpKind::kConst:
        values[id.index] = ir::ConstantValue(inst);
        break;
      case ir::OpKind::kStore:
        if (is_word) {
          words[inst.payload] = values[inst.a];
        } else {
          trace.push_back(id.index);  // passes keep ids
        }
        break;
      case ir::OpKind::kLoad:
        values[id.index] = is_word ? words[inst.payload] : Bit(inst.payload);
        break;
      case ir::OpKind::kBitNot:
        values[id.index] = values[inst.a] == 0 ? 1 : 0;
        break;
      case ir::OpKind::kEqual32:
        values[id.index] = values[inst.a] == values[inst.b] ? 1 : 0;
        break;
      case ir::OpKind::kJump:
        if (!condition) break;
        if (!ir::PlaceId(inst.c).valid() || TakeRound(ir::RegionId(inst.b))) label = inst.payload;
        break;
      case ir::OpKind::kExit:
        if (condition) leaving = ir::InstId(inst.payload);
        repeats = false;
        break;
      case ir::OpKind::kRepeat:
        if (!condition || !TakeRound(ir::RegionId(inst.b))) break;
        leaving = ir::InstId(inst.payload);
        repeats = true;
        break;
      case ir::OpKind::kIf:
        Region(ir::RegionId(condition ? inst.b : inst.c));
        break;
      case ir::OpKind::kSwitch:
        Choose(inst);
        break;
      case ir::OpKind::kBlock:
        Region(ir::RegionId(inst.a));
        if (leaving == id) leaving = {};
        break;
      case ir::OpKind::kLoop:
        Loop(id);
        break;
      default:
        break;
    }
  }

  void Loop(ir::InstId id) {
    const ir::Loop& loop = program.loops[ir::LoopId(program[id].payload)];
    for (uint64_t done = 0;; ++done) {
      if (loop.condition.valid() && !Holds(loop.condition)) return;
      if (loop.kind != ir::LoopBound::kBudget && done == loop.bound) {
        if (loop.exhausted.valid()) Region(loop.exhausted);
        return;
      }
      Region(loop.body);
      const bool again = loop.kind != ir::LoopBound::kBudget ? going() : leaving == id && repeats;
      if (leaving == id) leaving = {};
      if (!again) return;
      if (loop.step.valid()) Region(loop.step);
    }
  }

  /// The condition's value is that of its last instruction.
  bool Holds(ir::RegionId condition) {
    Region(condition);
    return values[program.regions[condition].insts.back().index] != 0;
  }

  void Choose(const ir::Inst& inst) {
    const std::vector<ir::SwitchCase>& cases = program.switches[ir::SwitchId(inst.payload)].cases;
    size_t chosen = cases.size();
    for (size_t i = 0; i < cases.size(); ++i) {
      if (cases[i].values.empty()) chosen = i;
    }
    for (size_t i = 0; i < cases.size(); ++i) {
      if (std::ranges::find(cases[i].values, values[inst.a]) != cases[i].values.end()) chosen = i;
    }
    for (; chosen < cases.size() && going(); ++chosen) {
      Region(cases[chosen].region);
      if (!cases[chosen].falls_through) return;
    }
  }

  void Region(ir::RegionId region) {
    if (!region.valid()) return;
    const std::vector<ir::InstId>& insts = program.regions[region].insts;
    for (size_t i = 0; i < insts.size(); ++i) {
      Inst(insts[i]);
      if (label != kNoLabel) {
        size_t target = 0;
        while (target < insts.size() &&
               !(program[insts[target]].op == ir::OpKind::kLabel && program[insts[target]].payload == label)) {
          ++target;
        }
        if (target == insts.size()) return;  // of a region around this one
        label = kNoLabel;
        i = target;
      }
      if (!going()) return;
    }
  }
};

inline Follower Begin(const ir::Program& program, uint32_t inputs) {
  Follower follower{.program = program, .inputs = inputs};
  follower.values.resize(program.insts.size());
  follower.words.resize(program.places.size());
  for (uint32_t i = 0; i < program.places.size(); ++i) {
    if (program.places[ir::PlaceId(i)].name == "slice") follower.words[i] = inputs % 5;
  }
  return follower;
}

inline std::vector<uint32_t> Trace(const ir::Program& program, uint32_t inputs) {
  Follower follower = Begin(program, inputs);
  follower.Region(program.routines[ir::RoutineId(0)].body);
  EXPECT_TRUE(follower.going());
  return follower.trace;
}

enum class Ways : uint8_t { kForward, kBoth };

/// A choice between labels, in ascending order as often as not, as a mechanism begins.
inline std::string RandomEntry(std::mt19937& random, uint32_t count) {
  if (random() % 3 == 0) return "";
  std::string entry = "%8 = load slice\nswitch %8 {\n";
  const bool ascending = random() % 2 == 0;
  uint32_t label = 0;
  for (uint32_t value = 1; value <= 3; ++value) {
    label = ascending ? std::min(count, label + 1 + static_cast<uint32_t>(random() % 3))
                      : static_cast<uint32_t>(random() % (count + 1));
    entry += "  case " + std::to_string(value) + " {\n    jump L" + std::to_string(label) + "\n  }\n";
  }
  return entry + (random() % 2 == 0 ? "  default {\n  }\n" : "") + "}\n";
}

/// `count` statements; each may jump to a label, each label stands before or behind a marker. The numbers of statements
/// and labels begin with `first`.
inline std::string RandomBody(std::mt19937& random, uint32_t count, Ways ways, uint32_t first = 0) {
  const auto below = [&random](uint32_t n) { return static_cast<uint32_t>(random() % n); };
  const auto label_at = [first](uint32_t number) { return "L" + std::to_string(first + number); };
  const std::string end = label_at(count);
  std::string body;
  for (uint32_t i = 0; i < count; ++i) {
    const std::string label = "label " + label_at(i) + "\n";
    const std::string marker = "stmt s" + std::to_string(first + i + 1) + "\n";
    body += below(2) == 0 ? label + marker : marker + label;
    if (below(3) != 0) body += "%9 = load a\nstore b %9\n";
    const uint32_t target = ways == Ways::kBoth ? below(count + 1) : i + 1 + below(count - i);
    const std::string place(1, "abc"[below(3)]);
    std::string jump = "jump " + label_at(target), rest = "\n";
    if (target <= i) {
      rest = " budget rounds refused {\n  %7 = load b\n  store a %7\n  jump " +
             (below(2) == 0 ? end : label_at(i + 1)) + "\n}\n";
    }
    uint32_t next = 10;  // numbers of values, each once in a statement
    const auto arm = [&] {
      const auto value = [&next] { return "%" + std::to_string(next++); };
      std::string text;
      if (below(3) != 0) {
        const std::string read = value();
        text += "  " + read + " = load " + std::string(1, "abc"[below(3)]) + "\n  store b " + read + "\n";
      }
      const std::string condition = value(), refused = value();
      std::string leave = below(3) == 0 ? "jump " + end : jump + rest;
      if (const size_t at = leave.find("%7"); at != std::string::npos) {
        leave.replace(at, 2, refused);
        leave.replace(leave.find("%7"), 2, refused);
      }
      if (below(2) == 0) {
        text += "  " + condition + " = load c\n";
        leave.insert(leave.find_first_of(" \n", 5) == std::string::npos ? leave.size() : leave.find_first_of(" \n", 5),
                     " if " + condition);
      }
      return below(4) == 0 ? text : text + "  " + leave + (leave.ends_with('\n') ? "" : "\n");
    };
    switch (below(9)) {
      case 0:
        body += jump + rest;
        break;
      case 1:
        body += "%0 = load " + place + "\n" + jump + " if %0" + rest + "store c %0\n";
        break;
      case 2:
        body += "%0 = load " + place + "\n%1 = not.bit %0\n" + jump + " if %1" + rest;
        break;
      case 3:  // nested
        body += "%0 = load " + place + "\nif %0 {\n  %1 = load b\n  store c %1\n  " + jump +
                (below(2) == 0 ? "" : " if %1") + rest + "}\n";
        break;
      case 4:  // in both arms
        body += "%0 = load " + place + "\nif %0 {\n" + arm() + "} else {\n" + arm() + "}\nstore c %0\n";
        break;
      case 5:
        body += "%8 = load slice\nswitch %8 {\n  case 1" + std::string(below(2) == 0 ? " falls_through" : "") + " {\n" +
                arm() + "}\n  case 2 {\n" + arm() + "}\n" + (below(2) == 0 ? "  default {\n" + arm() + "}\n" : "") +
                "}\n";
        break;
      case 6:
        body += "loop @1 guard 3 {\n  condition {\n    %30 = load " + place +
                "\n    %31 = not.bit %30\n  }\n  body {\n" + arm() + "}\n" +
                (below(2) == 0 ? "  exhausted {\n" + arm() + "}\n" : "") + "}\n";
        break;
      default:
        break;
    }
  }
  return body + "label " + end + "\n";
}

}  // namespace plcxx::passes
