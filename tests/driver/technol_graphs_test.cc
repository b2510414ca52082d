// All small graphs of jumps, waits, calls and labels in TECHNOL: each compiles, keeps the rules of the IR, and does in
// the simulator what a reading of the specification (6.4, 6.7) of its own does, step by step. Generated code is
// compared with the simulator for many of them in one program.
#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/driver/run_plcxx.h"
#include "transpiler/compilation/compilation.h"
#include "transpiler/ir/verifier.h"
#include "transpiler/sim/simulator.h"

namespace plcxx::driver {
namespace {

constexpr uint32_t kLoopLimit = 9;

enum class What : uint8_t { kNothing, kWait, kWaitWhile, kJumpIf, kJump, kCall, kReturn };

/// One line: it notes its number, then does one thing.
struct GraphLine {
  What what = What::kNothing;
  uint32_t to = 0;  // a line; the number of lines is the end
};
using Graph = std::vector<GraphLine>;

std::string ToText(const Graph& graph) {
  std::string text;
  for (const GraphLine& line : graph) {
    constexpr const char* kNames[] = {"-", "EX", "EX1", "JL1", "JUM", "CALL", "RET"};
    text += std::string(text.empty() ? "" : ", ") + kNames[static_cast<size_t>(line.what)];
    if (line.what >= What::kJumpIf && line.what <= What::kCall) text += " " + std::to_string(line.to);
  }
  return text;
}

/// Number `index` of the graphs with `lines` lines, each of which is one of `kinds` with each target.
Graph GraphOf(uint32_t index, uint32_t lines, const std::vector<GraphLine>& kinds) {
  Graph graph;
  for (uint32_t i = 0; i < lines; ++i) {
    graph.push_back(kinds[index % kinds.size()]);
    index /= static_cast<uint32_t>(kinds.size());
  }
  return graph;
}

/// The trace and the random bits that conditions take. As the program keeps them: T (32 bits), W (16 bits).
struct Cells {
  uint32_t trace = 0;
  uint16_t bits = 0;

  void Note(uint32_t line) { trace = (trace << 5 | trace >> 27) ^ (line + 1); }
  bool TakeBit() {
    bits = static_cast<uint16_t>(bits << 15 | bits >> 1);
    return (bits & 1) != 0;
  }
};

/// What the specification says, read once more.
class Reference {
 public:
  explicit Reference(const Graph& graph) : graph_(graph) {}

  /// One pass of the mechanism.
  void Pass(Cells& cells) {
    came_ = {resume_, resumes_behind_note_};
    rounds_ = kLoopLimit;
    uint32_t at = resume_;
    for (bool noted = resumes_behind_note_; at < graph_.size(); noted = false) {
      if (!noted) cells.Note(at);
      const GraphLine& line = graph_[at];
      resumes_behind_note_ = line.what == What::kWaitWhile && (cells.bits & 1) != 0;
      if (line.what == What::kWait || resumes_behind_note_) {
        resume_ = resumes_behind_note_ ? at : at + 1;
        return;
      }
      const bool jumps = line.what == What::kJump || (line.what == What::kJumpIf && cells.TakeBit());
      if (jumps && line.to <= at && rounds_-- == 0) return LeaveAsItCame();
      at = jumps ? line.to : at + 1;
    }
    resume_ = 0;
    resumes_behind_note_ = false;
  }

  /// A call of the lines from `at` on to their RET. False: the guard has left everything.
  bool Call(uint32_t at, Cells& cells) {
    while (true) {
      if (at == graph_.size()) return true;  // the last line is followed by RET
      cells.Note(at);
      const GraphLine& line = graph_[at];
      if (line.what == What::kReturn) return true;
      if (line.what == What::kCall && !Call(line.to, cells)) return false;
      const bool jumps = line.what == What::kJump || (line.what == What::kJumpIf && cells.TakeBit());
      if (jumps && line.to <= at && rounds_-- == 0) return false;
      at = jumps ? line.to : at + 1;
    }
  }
  void BeginCalls() { rounds_ = kLoopLimit; }

 private:
  /// The guard of the loops leaves the step alone (6.4).
  void LeaveAsItCame() { std::tie(resume_, resumes_behind_note_) = came_; }

  const Graph& graph_;
  uint32_t resume_ = 0;               // a line
  bool resumes_behind_note_ = false;  // of that line
  std::pair<uint32_t, bool> came_;
  uint32_t rounds_ = 0;
};

/// The lines as code; `name` makes labels and cells their own.
std::string CodeOf(const Graph& graph, const std::string& name) {
  std::string code;
  for (uint32_t i = 0; i <= graph.size(); ++i) {
    const std::string label = name + "L" + std::to_string(i);
    if (i == graph.size()) return code + label + ": NOP\n";
    code += label + ": LOD T" + name + "\nRL CNST.5\nXOR CNST." + std::to_string(i + 1) + "\nSTO T" + name + "\n";
    const std::string to = " " + name + "L" + std::to_string(graph[i].to) + "\n";
    switch (graph[i].what) {
      case What::kNothing:
        break;
      case What::kWait:
        code += "EX\n";
        break;
      case What::kWaitWhile:
        code += "LOD W" + name + "\nAND CNST.1\nEQ CNST.1\nEX1\n";
        break;
      case What::kJumpIf:
        code += "LOD W" + name + "\nRR CNST.1\nSTO W" + name + "\nAND CNST.1\nEQ CNST.1\nJL1" + to;
        break;
      case What::kJump:
        code += "JUM" + to;
        break;
      case What::kCall:
        code += "CALL" + to;
        break;
      case What::kReturn:
        code += "RET\n";
        break;
    }
  }
  return code;
}

std::string CellsOf(const std::string& name) { return "T" + name + ": DD ?\nW" + name + ": DW ?\n"; }

std::string MechanismOf(const Graph& graph, const std::string& name) {
  return "FL 1,M" + name + "\nMECH_BEGIN M" + name + "\n" + CodeOf(graph, name) + "MECH_END M" + name + "\n";
}

/// Calls each line once, in a mechanism of its own, for a refused jump leaves that.
std::string CallsOf(const Graph& graph, const std::string& name) {
  std::string code = "FL 1,M" + name + "\nMECH_BEGIN M" + name + "\n";
  for (uint32_t i = 0; i < graph.size(); ++i) code += "CALL " + name + "L" + std::to_string(i) + "\n";
  return code + "MECH_END M" + name + "\n";
}

std::string ProgramOf(const std::string& cells, const std::string& main, const std::string& subprograms) {
  return "DATA\n" + cells + "DATA_END\nMODULE_MAIN\n" + main + "MODULE_MAIN_END\n" + subprograms + "STOP\n";
}

class Compiled {
 public:
  explicit Compiled(const std::string& text) {
    compilation::CompilationRequest request;
    request.sources = {work_.Write("graph.plc", text)};
    request.dialect = "technol";
    request.options = {{"loop-limit", std::to_string(kLoopLimit)}};
    compilation_ = compilation::Compile(request);
  }
  const compilation::Compilation& operator*() const { return compilation_; }
  const compilation::Compilation* operator->() const { return &compilation_; }
  ir::Place Place(const std::string& name) const {
    return compilation_.dialect->locate(ir::NameIndex(compilation_.program), name).value().place;
  }

 private:
  Workplace work_;
  compilation::Compilation compilation_;
};

constexpr uint16_t kBits[] = {0x0000, 0xFFFF, 0x5A5A, 0x2D71};

void ExpectRunsAs(const Graph& graph, const Compiled& compiled, auto&& pass) {
  ASSERT_TRUE(compiled->ok()) << ToText(graph) << ": " << compiled->diagnostics.all().front().text;
  for (const uint16_t bits : kBits) {
    sim::Simulator simulator(compiled->program);
    simulator.PowerOn();
    simulator.Write(compiled.Place("W"), bits);
    Cells cells{.trace = 0, .bits = bits};
    Reference reference(graph);
    for (uint32_t round = 1; round <= 4; ++round) {
      cells.TakeBit();  // W changes between passes
      simulator.Write(compiled.Place("W"), cells.bits);
      simulator.RunPeriod(20 * round);
      pass(reference, cells);
      ASSERT_EQ(simulator.Read(compiled.Place("T")), cells.trace) << ToText(graph) << " in pass " << round;
      ASSERT_EQ(simulator.Read(compiled.Place("W")), cells.bits) << ToText(graph) << " in pass " << round;
    }
  }
}

std::vector<GraphLine> KindsOfMechanisms(uint32_t lines) {
  std::vector<GraphLine> kinds = {{}, {What::kWait, 0}, {What::kWaitWhile, 0}};
  for (uint32_t to = 0; to <= lines; ++to) kinds.push_back({What::kJumpIf, to});
  for (uint32_t to = 0; to <= lines; ++to) kinds.push_back({What::kJump, to});
  return kinds;
}

std::vector<GraphLine> KindsOfSubprograms(uint32_t lines) {
  std::vector<GraphLine> kinds = {{}, {What::kReturn, 0}};
  for (const What what : {What::kJumpIf, What::kJump, What::kCall}) {
    for (uint32_t to = 0; to < lines; ++to) kinds.push_back({what, to});
  }
  return kinds;
}

uint32_t CountOf(uint32_t lines, size_t kinds) {
  uint32_t count = 1;
  for (uint32_t i = 0; i < lines; ++i) count *= static_cast<uint32_t>(kinds);
  return count;
}

/// Does a line call, on whatever way, itself? That is refused (TE050).
bool IsRecursive(const Graph& graph) {
  const auto reached = [&](uint32_t from) {
    std::set<uint32_t> lines;
    std::vector<uint32_t> work = {from};
    while (!work.empty()) {
      const uint32_t at = work.back();
      work.pop_back();
      if (at >= graph.size() || !lines.insert(at).second) continue;
      if (graph[at].what == What::kJump || graph[at].what == What::kJumpIf) work.push_back(graph[at].to);
      if (graph[at].what != What::kJump && graph[at].what != What::kReturn) work.push_back(at + 1);
    }
    return lines;
  };
  std::vector<std::set<uint32_t>> calls(graph.size());
  for (uint32_t i = 0; i < graph.size(); ++i) {
    for (const uint32_t at : reached(i)) {
      if (graph[at].what == What::kCall) calls[i].insert(graph[at].to);
    }
  }
  for (size_t round = 0; round < graph.size(); ++round) {
    for (auto& callees : calls) {
      for (const uint32_t callee : std::set<uint32_t>(callees)) {
        callees.insert(calls[callee].begin(), calls[callee].end());
      }
    }
  }
  for (uint32_t i = 0; i < graph.size(); ++i) {
    if (calls[i].contains(i)) return true;
  }
  return false;
}

void CheckMechanism(const Graph& graph) {
  const Compiled compiled(ProgramOf(CellsOf(""), MechanismOf(graph, ""), ""));
  ExpectRunsAs(graph, compiled, [](Reference& reference, Cells& cells) { reference.Pass(cells); });
}

void CheckSubprograms(const Graph& graph) {
  const Compiled compiled(ProgramOf(CellsOf(""), CallsOf(graph, ""), CodeOf(graph, "") + "RET\n"));
  ExpectRunsAs(graph, compiled, [&](Reference& reference, Cells& cells) {
    reference.BeginCalls();
    for (uint32_t i = 0; i < graph.size() && reference.Call(i, cells); ++i) {
    }
  });
}

/// The graphs of both kinds: each with up to three lines, then each `every`th one with `lines` lines.
template <class Visit>
void ForEachGraph(uint32_t lines, uint32_t every, std::vector<GraphLine> (*kinds_of)(uint32_t), Visit&& visit) {
  for (uint32_t n = 1; n <= lines; ++n) {
    const std::vector<GraphLine> kinds = kinds_of(n);
    const uint32_t step = n == lines ? every : 1;
    for (uint32_t i = 0; i < CountOf(n, kinds.size()); i += step) visit(GraphOf(i, n, kinds));
  }
}

TEST(TechnolGraphs, AllSmallMechanismsGoOnWhereTheyWait) {
  ForEachGraph(4, 41, KindsOfMechanisms, [](const Graph& graph) {
    if (!testing::Test::HasFailure()) CheckMechanism(graph);
  });
}

TEST(TechnolGraphs, AllSmallGroupsOfSubprogramsCallAndShareTheirTails) {
  ForEachGraph(4, 79, KindsOfSubprograms, [](const Graph& graph) {
    if (!testing::Test::HasFailure() && !IsRecursive(graph)) CheckSubprograms(graph);
  });
}

TEST(TechnolGraphs, RecursionIsRefused) {
  ForEachGraph(2, 1, KindsOfSubprograms, [](const Graph& graph) {
    if (!IsRecursive(graph)) return;
    const Compiled compiled(ProgramOf(CellsOf(""), CallsOf(graph, ""), CodeOf(graph, "") + "RET\n"));
    EXPECT_FALSE(compiled->ok()) << ToText(graph);
  });
}

/// Some of the graphs, all in one program: generated code in lockstep with the simulator.
TEST(TechnolGraphs, GeneratedCodeDoesTheSame) {
  std::string cells, main, subprograms, inputs;
  uint32_t number = 0;
  const auto add = [&](const Graph& graph, bool calls) {
    const std::string name = "G" + std::to_string(number++);
    cells += CellsOf(name);
    main += calls ? CallsOf(graph, name) : MechanismOf(graph, name);
    if (calls) subprograms += CodeOf(graph, name) + "RET\n";
    inputs += (inputs.empty() ? "" : ", ") + ("W" + name) + ": " + std::to_string(kBits[number % 4] ^ number);
  };
  ForEachGraph(4, 701, KindsOfMechanisms, [&, n = 0](const Graph& graph) mutable {
    if (n++ % 11 == 0 || graph.size() == 4) add(graph, false);
  });
  ForEachGraph(4, 1009, KindsOfSubprograms, [&, n = 0](const Graph& graph) mutable {
    if ((n++ % 17 == 0 || graph.size() == 4) && !IsRecursive(graph)) add(graph, true);
  });
  const Workplace work;
  work.Write("graphs.plc", ProgramOf(cells, main, subprograms));
  work.Write("graphs.yaml", "dialect: technol\nsources: [graphs.plc]\noptions: {loop-limit: " +
                                std::to_string(kLoopLimit) + "}\nsteps:\n- set: {" + inputs + "}\n- run: {slow: 5}\n");
  const Ran ran = work.Run("test graphs.yaml --engine sim,host");
  EXPECT_EQ(ran.code, 0) << ran;
}

}  // namespace
}  // namespace plcxx::driver
