// A small program with a host's files, compiled against the stub of HAL, as a process that a test talks to.
#pragma once

#include <cstdlib>
#include <string>

#include "tests/driver/run_plcxx.h"

namespace plcxx::host {

inline constexpr std::string_view kSymbols = "*\nPUMP=U4A0\nLAMP=U4A1\nKEPT=W0T0\nLIMIT=W0T2\n";
inline constexpr std::string_view kProgram =
    "$\n!PUMP=I0A0+!PUMP*/"
    "I0A1\nT5I(2)=!PUMP\n!LAMP=T5U\n!KEPT=W1A0\nU10N4=I0A2\nU4A2=[W5A1=3]*I20A5\nU4A3=[!LIMIT>5]\n";

/// The API that the module is compiled for: tests/host/stub/hal.h.
enum class HalApi : uint16_t { k29 = 29, k210 = 210, k211 = 211 };
inline constexpr HalApi kHalApis[] = {HalApi::k29, HalApi::k210, HalApi::k211};

class HostProgram {
 public:
  HostProgram(const std::string& host, std::string_view symbols = kSymbols, std::string_view program = kProgram) {
    work.Write("fan.sym", symbols);
    work.Write("fan.plc", program);
    emitted = work.Run("emit fan.sym fan.plc --name fan -o out --host " + host);
  }

  /// What the compilers say; empty: nothing.
  std::string Compile(const std::string& sources, const std::string& flags) const {
    const std::string command = "cd '" + work.Path(".") +
                                "' && c++ -std=c++17 -O1 -Wall -Wextra -Wshadow -Wconversion -Werror -fno-rtti -I out "
                                "-I " PLCXX_ROOT "/runtime_support " +
                                flags + " " + sources + " -o fan -lpthread >compiler 2>&1";
    if (std::system(command.c_str()) == 0) return work.Read("compiler");
    return "failed\n" + work.Read("compiler");
  }
  std::string CompileModule(HalApi api) const {
    const std::string version = "-DSTUB_HAL=" + std::to_string(static_cast<int>(api)) + " ";
    return Compile("out/fan.cpp out/fan_pins.cpp out/fan_linuxcnc.cpp " PLCXX_ROOT "/tests/host/stub/stub.cc",
                   version + "-I " PLCXX_ROOT "/tests/host/stub");
  }

  /// Of the compiled program.
  driver::Ran Talk(const std::string& arguments, const std::string& lines) const {
    work.Write("lines", lines);
    const std::string command =
        "cd '" + work.Path(".") + "' && timeout 30 ./fan " + arguments + " <lines >said 2>errors";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, work.Read("said"), work.Read("errors")};
  }

  driver::Workplace work;
  driver::Ran emitted;
};

}  // namespace plcxx::host
