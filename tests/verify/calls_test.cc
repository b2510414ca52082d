// Calls of proved functions that are not what they were proved with, and what is executed without a call of the
// program: none of it is proved. Each change computes something else, though what stands for the call would be the
// same.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "tests/verify/changed_code.h"

namespace plcxx::prove {
namespace {

using ::testing::HasSubstr;

constexpr const char* kSubprogram = R"(        DATA
IN0: DFM KUS
OUT0: DFM A,C
P: DS 4
W: DS 2
        DATA_END
        MODULE_MAIN
        LOD CNST.5
        MOV DX,5
        LDR KUS
        CALL UPRAV
        MOV W,DX
        WR A
        MODULE_MAIN_END
UPRAV:  WR C
        INC DX
        AD CNST.5
        BIN
        STO P
        RET
        STOP
)";

constexpr std::string_view kCall = "  UPRAV(m, rlo, dr, dx, host);";
constexpr std::string_view kBefore = "// The continuous branch: in every slow pass.\n";

constexpr Mutation kCalls[] = {
    {"one_object_for_two_references", "turret.cpp", kCall, "  UPRAV(m, rlo, dx, dx, host);"},
    {"object_too_small", "turret.cpp", kCall,
     "  alignas(2) uint8_t low = dx & 255, high = dx >> 8;\n  UPRAV(m, rlo, dr, reinterpret_cast<uint16_t&>(low), "
     "host);\n"
     "  dx = low | high << 8;"},
    {"host_as_state", "turret.cpp", kCall, "  UPRAV(reinterpret_cast<State&>(host), rlo, dr, dx, host);"},
    {"state_as_host", "turret.cpp", kCall, "  UPRAV(m, rlo, dr, dx, reinterpret_cast<Host&>(m));"},
};

/// Behind another function that stands in front.
constexpr std::string_view kOverload = "static void UPRAV(State&, uint8_t&, uint16_t&, uint16_t&, Host&) noexcept {}\n";
constexpr Mutation kOverloaded = {"overload", "turret.cpp", kCall,
                                  "  UPRAV(m, reinterpret_cast<uint8_t&>(rlo), dr, dx, host);"};
constexpr std::string_view kCopying =
    "struct Kept { uint64_t value[4]; };\n[[gnu::noinline]] static uint16_t Next(Kept kept) noexcept {\n"
    "  kept.value[0] += 7;\n  return static_cast<uint16_t>(kept.value[0]);\n}\n";
constexpr Mutation kCopied = {"copied_argument", "turret.cpp", "  dx = 5;\n",
                              "  Kept kept{{static_cast<uint64_t>(-2)}};\n  const uint16_t next = Next(kept);\n"
                              "  dx = static_cast<uint16_t>(kept.value[0] + next - 5);\n"};

constexpr Mutation kOutside[] = {
    {"constructor", "turret.cpp", kBefore,
     "[[gnu::constructor]] static void Begin() noexcept { static volatile int begun; begun = 1; }\n"},
    {"assembler_outside", "turret.cpp", kBefore, "asm(\".globl begin\");\n"},
};

Subject Turret() { return {"turret.plc", kSubprogram, "technol"}; }

void PutInFront(Subject& subject, std::string_view function) {
  std::string& text = subject.TextOf("turret.cpp");
  text.insert(text.find(kBefore), function);
}

TEST(Calls, UnchangedIsProved) { EXPECT_EQ(Turret().Caught(), ""); }

TEST(Calls, WithOtherObjectsAreCaught) {
  Subject turret = Turret();
  for (const Mutation& mutation : kCalls) Expect(Outcome::kCaught, turret, mutation);
}

TEST(Calls, OfAnotherFunctionOfTheNameAreCaught) {
  Subject turret = Turret();
  PutInFront(turret, kOverload);
  Expect(Outcome::kCaught, turret, kOverloaded);
}

TEST(Calls, ThatCopyAreCaught) {
  Subject turret = Turret();
  PutInFront(turret, kCopying);
  Expect(Outcome::kCaught, turret, kCopied);
}

TEST(Calls, WhatRunsWithoutOneIsCaught) {
  Subject turret = Turret();
  for (const Mutation& mutation : kOutside) Expect(Outcome::kCaught, turret, mutation);
}

/// Functions that only their file calls are kept by a definition of `static`: no text may depend on it.
TEST(Calls, LinesForThePreprocessorAreTold) {
  const auto found = compile::FindToolchain(compile::Targets().front(), verify::kVerifyCompiler);
  const auto* toolchain = std::get_if<compile::Toolchain>(&found);
  ASSERT_NE(toolchain, nullptr);
  const std::vector<emit::OutputFile> files = {
      {.name = "a.cpp", .text = "#include <stdint.h>\n  #ifdef static\n#endif\n"}};
  const auto compiled = verify::CompileToBitcode({.toolchain = toolchain, .files = &files});
  const auto* failure = std::get_if<verify::BitcodeFailure>(&compiled);
  ASSERT_NE(failure, nullptr);
  EXPECT_THAT(failure->message, HasSubstr("a.cpp has a line for the preprocessor: #ifdef static"));
}

}  // namespace
}  // namespace plcxx::prove
