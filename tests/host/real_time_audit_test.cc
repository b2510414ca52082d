// What runs in LinuxCNC's real-time thread takes no memory, no lock and no system call: all that the exported function
// reaches in the compiled module is looked at, here with objdump, and in `plcxx build --host` by its audit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/host/host_program.h"

namespace plcxx::host {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// By function, what it calls or jumps to; "*": what nobody knows.
using CallGraph = std::map<std::string, std::set<std::string>>;

CallGraph ReadDisassembly(const std::string& text) {
  const std::regex head(R"(^[0-9a-f]+ <([^>]+)>:$)");
  const std::regex direct(R"(\s(?:call|jmp)q?\s+[0-9a-f]+ <([^>+]+)(\+0x[0-9a-f]+)?>)");
  const std::regex indirect(R"(\s(?:call|jmp)q?\s+\*)");
  CallGraph graph;
  std::string function;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::smatch found;
    if (std::regex_match(line, found, head)) {
      function = found[1];
      graph[function];
    } else if (std::regex_search(line, found, direct)) {
      if (found[1] != function) graph[function].insert(found[1]);
    } else if (std::regex_search(line, indirect) && function.find("@plt") == std::string::npos) {
      graph[function].insert("*");
    }
  }
  return graph;
}

std::set<std::string> Reached(const CallGraph& graph, const std::string& from) {
  std::set<std::string> reached;
  std::vector<std::string> open = {from};
  while (!open.empty()) {
    const std::string function = open.back();
    open.pop_back();
    if (!reached.insert(function).second) continue;
    const auto known = graph.find(function);
    if (known == graph.end() || function.find("@plt") != std::string::npos) continue;
    open.insert(open.end(), known->second.begin(), known->second.end());
  }
  return reached;
}

/// What is not of the module itself and may wait.
std::vector<std::string> Refused(const std::set<std::string>& reached) {
  std::vector<std::string> refused;
  for (const std::string& function : reached) {
    const bool outside = function == "*" || function.find("@plt") != std::string::npos;
    if (outside && function != "memcpy@plt" && function != "memcmp@plt" && function != "memset@plt")
      refused.push_back(function);
  }
  return refused;
}

std::string Disassembly(const HostProgram& program) {
  EXPECT_EQ(program.Compile("out/fan.cpp out/fan_pins.cpp out/fan_linuxcnc.cpp",
                            "-O2 -fPIC -shared -Wl,-Bsymbolic -fno-exceptions -I " PLCXX_ROOT "/tests/host/stub"),
            "");
  const std::string command = "cd '" + program.work.Path(".") + "' && objdump -d --no-show-raw-insn fan > disassembly";
  EXPECT_EQ(std::system(command.c_str()), 0);
  return program.work.Read("disassembly");
}

std::string NameOf(const CallGraph& graph, const std::string& part) {
  for (const auto& [function, calls] : graph) {
    if (function.find(part) != std::string::npos && function.find("@plt") == std::string::npos) return function;
  }
  return "";
}

TEST(RealTimeAudit, TheExportedFunctionNeverWaits) {
  const HostProgram program("linuxcnc");
  const CallGraph graph = ReadDisassembly(Disassembly(program));
  const std::string run = NameOf(graph, "3RunEPvl");
  ASSERT_NE(run, "") << "the module has no function for a thread";
  const std::set<std::string> reached = Reached(graph, run);
  EXPECT_THAT(reached, Contains(HasSubstr("4StepE")));
  EXPECT_THAT(reached, Contains(HasSubstr("fan6period")));
  EXPECT_THAT(Refused(reached), IsEmpty());

  // The thread beside it does wait: this would be seen.
  const std::string loop = NameOf(graph, "4LoopEPv");
  ASSERT_NE(loop, "");
  EXPECT_THAT(Refused(Reached(graph, loop)), Contains("nanosleep@plt"));
  EXPECT_THAT(Refused(Reached(graph, loop)), Contains("fsync@plt"));
}

/// Of `plcxx build`, which audits one period of a host as it audits the program.
driver::Ran Build(const HostProgram& program, const std::string& arguments) {
  return program.work.Run("build fan.sym fan.plc --name fan -o built --target host " + arguments);
}

TEST(RealTimeAudit, BuildAuditsThePeriodOfALoop) {
  const HostProgram program("posix");
  const driver::Ran ran = Build(program, "--host posix");
  EXPECT_EQ(ran.code, 0) << ran;
  for (const char* file : {"libfan.a", "fan_posix.cpp", "fan_pins.hpp", "plcxx/bits.h", "plcxx_host/posix.h"})
    EXPECT_TRUE(program.work.Has(std::string("built/") + file)) << file;
  // The object that was audited is the one that runs.
  program.work.Write("io.cpp",
                     "#include <plcxx_host/posix.h>\n#include \"fan_pins.hpp\"\nnamespace plcxx::host {\n"
                     "bool io_open(int, char**) noexcept { return true; }\n"
                     "void io_read(Value* pins) noexcept { pins[fan::Host::At::I0A0].bit = true; }\n"
                     "void io_write(const Value* pins) noexcept { printf(\"%d\", pins[fan::Host::At::PUMP].bit); }\n"
                     "void io_close() noexcept {}\n}\n");
  EXPECT_EQ(std::system(
                ("cd '" + program.work.Path(".") + "' && c++ -std=c++17 -I built io.cpp -Lbuilt -lfan -lpthread -o fan")
                    .c_str()),
            0);
  EXPECT_EQ(program.Talk("--periods 3", "").out, "111");
}

TEST(RealTimeAudit, BuildMakesTheModuleOrSaysWhatIsMissing) {
  for (const auto& [host, header] :
       {std::pair{"linuxcnc", "/usr/include/linuxcnc/hal.h"}, std::pair{"modbus", "/usr/include/modbus/modbus.h"}}) {
    const HostProgram program(host);
    const driver::Ran ran = Build(program, std::string("--host ") + host);
    if (std::filesystem::exists(header)) {
      EXPECT_EQ(ran.code, 0) << ran;
      EXPECT_EQ(program.work.Has("built/fan.so"), std::string(host) == "linuxcnc");
    } else {
      EXPECT_EQ(ran.code, 2) << ran;
      EXPECT_THAT(ran.errors, HasSubstr(std::string(header) + ", which is not there: install Debian's "));
      EXPECT_FALSE(program.work.Has("built"));
    }
  }
}

TEST(RealTimeAudit, AHostIsForLinux) {
  const HostProgram program("posix");
  const driver::Ran ran = program.work.Run("build fan.plc --target cortex-m4 --host posix");
  EXPECT_EQ(ran.code, 2) << ran;
  EXPECT_THAT(ran.errors, HasSubstr("--host posix runs on Linux: --target host"));
}

}  // namespace
}  // namespace plcxx::host
