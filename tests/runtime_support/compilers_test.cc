// Every runtime header alone, and code like the generated one, on every compiler of a target that is installed.
#include <gtest/gtest.h>

#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>

#include "tests/temporary_directory.h"

namespace plcxx {
namespace {

struct Compiler {
  const char* name;
  const char* core;  // flags that choose the smallest core; the headers must need nothing more
  const char* symbols;
};

void PrintTo(const Compiler& compiler, std::ostream* out) { *out << compiler.name; }

const Compiler kCompilers[] = {
    {"g++", "", "nm"},
    {"clang++-19", "", "nm"},
    {"arm-none-eabi-g++", "-mcpu=cortex-m0 -mthumb", "arm-none-eabi-nm"},
    {"riscv64-unknown-elf-g++", "-march=rv32i -mabi=ilp32", "riscv64-unknown-elf-nm"},
};

const std::string kRoot = PLCXX_ROOT;
const std::string kFixtures = kRoot + "/tests/runtime_support/fixtures/";

bool Succeeds(const std::string& command) { return std::system(command.c_str()) == 0; }

class Compilers : public testing::TestWithParam<Compiler> {
 protected:
  void SetUp() override {
    if (!Succeeds(std::string(GetParam().name) + " --version >/dev/null 2>&1")) {
      GTEST_SKIP() << GetParam().name << " is not installed";
    }
  }
  std::string Command(const std::string& rest) const {
    return std::string(GetParam().name) + " " + GetParam().core +
           " -std=c++17 -ffreestanding -fno-exceptions -fno-rtti -Wall -Wextra -Wconversion -Wshadow -Wsign-conversion"
           " -Werror -I" +
           kRoot + "/runtime_support " + rest;
  }
  std::string Object(const std::string& name) const { return directory_.File(name + ".o"); }

  const testing_support::TemporaryDirectory directory_;
};

TEST_P(Compilers, EachHeaderAlone) {
  for (const auto& entry : std::filesystem::directory_iterator(kRoot + "/runtime_support/plcxx")) {
    const std::string header = "plcxx/" + entry.path().filename().string();
    EXPECT_TRUE(Succeeds(Command("-fsyntax-only -include " + header + " -x c++ /dev/null"))) << header;
  }
}

TEST_P(Compilers, CodeLikeTheGeneratedOne) {
  for (const char* flags : {"-std=c++17 -O0", "-std=c++17 -O2", "-std=c++17 -Os", "-std=c++20 -O2"}) {
    EXPECT_TRUE(
        Succeeds(Command(std::string(flags) + " -c -o " + Object("like") + " " + kFixtures + "generated_code.cc")))
        << flags;
  }
}

/// The undefined symbols of a fixture's object, one per line; a freestanding compiler may call memcpy and its kin.
std::string LibraryCalls(const std::string& compile, const std::string& object, const std::string& symbols) {
  const std::string list = object + ".txt";
  if (!Succeeds(compile) || !Succeeds(symbols + " -u " + object + " >" + list)) return "failed: " + compile;
  std::ifstream file(list);
  std::string calls;
  for (std::string word; file >> word;) {
    if (word != "U" && !word.starts_with("mem")) calls += word + "\n";
  }
  return calls;
}

TEST_P(Compilers, NoLibraryCalls) {
  const std::string object = Object("calls");
  for (const char* flags : {"-O2", "-Os"}) {
    EXPECT_EQ(LibraryCalls(Command(std::string(flags) + " -c -o " + object + " " + kFixtures + "no_library_calls.cc"),
                           object, GetParam().symbols),
              "");
  }
}

TEST_P(Compilers, WhatChangesFloatingPointIsRefused) {
  for (const char* header : {"floats", "doubles"}) {
    const std::string include = std::string("-fsyntax-only -include plcxx/") + header + ".h -x c++ /dev/null";
    EXPECT_TRUE(Succeeds(Command("-O2 " + include)));
    EXPECT_FALSE(Succeeds(Command("-O2 -ffast-math " + include + " 2>/dev/null")));
    if (std::string(GetParam().name) != "g++") continue;
    EXPECT_TRUE(Succeeds(Command("-m32 -msse2 -mfpmath=sse " + include)));
    EXPECT_FALSE(Succeeds(Command("-m32 -mfpmath=387 " + include + " 2>/dev/null")));
  }
}

TEST_P(Compilers, FaultsAreFound) {
  EXPECT_FALSE(Succeeds(Command("-fsyntax-only " + kFixtures + "narrowing.cc 2>/dev/null")));
  if (std::string(GetParam().name) == "clang++-19") {
    EXPECT_FALSE(Succeeds(Command("-fsyntax-only " + kFixtures + "effects_unknown.cc 2>/dev/null")));
  }
  if (*GetParam().core != '\0') {
    const std::string object = Object("division");
    EXPECT_NE(
        LibraryCalls(Command("-O2 -c -o " + object + " " + kFixtures + "library_call.cc"), object, GetParam().symbols),
        "");
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, Compilers, testing::ValuesIn(kCompilers), [](const auto& compiler) {
  std::string name = compiler.param.name;
  for (char& c : name) {
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  }
  return name;
});

}  // namespace
}  // namespace plcxx
