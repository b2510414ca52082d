// Generated text from IR texts: expressions, temporaries, storage, branches.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/emit/print/print.h"
#include "transpiler/ir/reader.h"

namespace plcxx::emit::print {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr std::string_view kDeclarations = R"(program "p" test
space A 32 volatile little host_visible "outputs"
space T 4 retentive little host_visible "kept"
space system 8 volatile little "times"
state T5 on_delay_timer
state C5 ring_counter
state P6 one_shot
place a bit A[0].0
place b bit A[0].1
place c bit A[0].2
place d bit A[1].0
place W bit A[2].3
place WORD i8 A[2]
place V i8 A[3]
place KEPT bit T[1].4
place KEPT_WORD i8 T[2]
place T5U bit field T5 done
place P6 bit field P6 pulse
place now i32 system[0]
host fault (kind : i8 = (LOW, HIGH), index : i32) "a diagnostic"
)";

struct Printed {
  std::string header, source;
};

Printed Print(std::string_view body, Flavour flavour = Flavour::kRelease) {
  const ir::Program program =
      ir::ReadOrDie(std::string(kDeclarations) + "routine fast fast {\n  body {\n" + std::string(body) + "\n  }\n}\n");
  const source::SourceManager sources;
  const auto files = PrintCpp(legalize::Legalize(program, {.name = "p", .flavour = flavour}), sources);
  return {files[0].text, files[1].text};
}

TEST(Expressions, OneStatementIsOneExpression) {
  EXPECT_THAT(Print("%0 = load a\n%1 = load b\n%2 = and.bit %0 %1\n%3 = load c\n%4 = or.bit %2 %3\nstore d %4").source,
              HasSubstr("  m[d] = (m[a] & m[b]) | m[c];\n"));
}

TEST(Expressions, ChainsOfOneOperatorNeedNoBrackets) {
  EXPECT_THAT(Print("%0 = load a\n%1 = load b\n%2 = and.bit %0 %1\n%3 = load c\n%4 = and.bit %2 %3\nstore d %4").source,
              HasSubstr("  m[d] = m[a] & m[b] & m[c];\n"));
}

TEST(Expressions, OnTheRightTheyNeedThem) {
  for (const auto& [operation, sign] :
       {std::pair("and.bit", "&"), std::pair("or.bit", "|"), std::pair("xor.bit", "^")}) {
    const std::string op(operation), text(sign);
    EXPECT_THAT(
        Print("%0 = load b\n%1 = load c\n%2 = " + op + " %0 %1\n%3 = load a\n%4 = " + op + " %3 %2\nstore d %4").source,
        HasSubstr("m[d] = m[a] " + text + " (m[b] " + text + " m[c]);\n"));
  }
}

TEST(Expressions, TheTreeIsKept) {
  EXPECT_THAT(Print("%0 = load a\n%1 = load b\n%3 = load c\n%2 = or.bit %1 %3\n%4 = or.bit %0 %2\nstore d %4").source,
              HasSubstr("  m[d] = m[a] | (m[b] | m[c]);\n"));
}

TEST(Expressions, NegationInFrontIsBracketed) {
  // GCC warns of "!a & b" where b is a packed bit; behind the operator it does not.
  EXPECT_THAT(
      Print("%0 = load a\n%1 = not.bit %0\n%2 = load b\n%3 = not.bit %2\n%4 = and.bit %1 %3\nstore d %4").source,
      HasSubstr("  m[d] = (!m[a]) & !m[b];\n"));
}

TEST(Expressions, ConstantsKeepTheirBase) {
  EXPECT_THAT(Print("%0 = load V\n%1 = const i8 0x33\n%2 = eq.i8 %0 %1\nstore d %2").source,
              HasSubstr("m[d] = m[V] == 0x33;\n"));
  EXPECT_THAT(Print("%0 = load V\n%1 = const i8 51\n%2 = eq.i8 %0 %1\nstore d %2").source,
              HasSubstr("m[d] = m[V] == 51;\n"));
}

TEST(Expressions, AComparisonThatNeverHoldsIsCalledByName) {
  EXPECT_THAT(Print("%0 = load V\n%1 = const i8 255\n%2 = ugt.i8 %0 %1\nstore d %2").source,
              HasSubstr("m[d] = Greater8(m[V], 255);\n"));
  EXPECT_THAT(Print("%0 = load V\n%1 = const i8 0\n%2 = ult.i8 %0 %1\nstore d %2").source,
              HasSubstr("m[d] = Less8(m[V], 0);\n"));
}

TEST(Temporaries, AValueReadBeforeAWriteGetsAName) {
  const std::string source = Print("%0 = load a\n%1 = load b\nstore a %1\nstore b %0").source;
  EXPECT_THAT(source, HasSubstr("  const bool t1 = m[a];\n  m[a] = m[b];\n  m[b] = t1;\n"));
}

TEST(Temporaries, AValueUsedTwiceGetsAName) {
  const std::string source = Print("%0 = load a\nstore b %0\nstore c %0").source;
  EXPECT_THAT(source, HasSubstr("  const bool t1 = m[a];\n  m[b] = t1;\n  m[c] = t1;\n"));
}

TEST(Temporaries, AValueUsedVeryOftenGetsANameAsWell) {
  for (const uint32_t uses : {255U, 256U, 257U, 513U}) {
    std::string body = "%0 = load a\n%1 = load b\n%2 = and.bit %0 %1\n";
    for (uint32_t i = 0; i < uses; ++i) body += i % 2 == 0 ? "store c %2\n" : "store d %2\n";
    EXPECT_THAT(Print(body).source, HasSubstr("  const bool t1 = m[a] & m[b];\n  m[c] = t1;\n  m[d] = t1;\n")) << uses;
    // In one expression, where nothing is stored between them; a long one is cut (kMostOperations).
    std::string once = "%0 = load a\n%1 = load b\n%2 = and.bit %0 %1\n%3 = load c\n";
    for (uint32_t i = 0; i < uses; ++i) {
      once += "%" + std::to_string(i + 4) + " = or.bit %" + std::to_string(i + 3) + " %2\n";
    }
    EXPECT_THAT(Print(once + "store d %" + std::to_string(uses + 3) + "\n").source,
                HasSubstr("  const bool t1 = m[a] & m[b];\n  const bool t2 = m[c] | t1 | t1"))
        << uses;
  }
}

TEST(Temporaries, APureValueOfAnOldReadUsesTheNameOfTheRead) {
  const std::string source = Print("%0 = load a\n%1 = load b\nstore a %1\n%2 = not.bit %0\nstore b %2").source;
  EXPECT_THAT(source, HasSubstr("  const bool t1 = m[a];\n  m[a] = m[b];\n  m[b] = !t1;\n"));
}

TEST(Temporaries, AResultOfAStepIsSpelledWhereItIsAsked) {
  const std::string source =
      Print(
          "%0 = load a\n%1 = const i16 3\n%2 = const i32 1\n%3 = step.count_slow C5 %0 %1 %2\n%4 = not.bit %3\n"
          "if %4 {\n%5 = const i8 1\n%6 = const i32 5\nhost fault (%5, %6)\n}")
          .source;
  EXPECT_THAT(source,
              HasSubstr("  if (!CountSlow(m[C5], m[a], 3, 1)) {\n    fault(host, fault_kind::HIGH, 5);\n  }\n"));
}

// What a host function takes has a type of its own where the function says so: a number becomes one of it.
TEST(Calls, AnArgumentWithNamesIsOneOfThemOrAConversion) {
  const auto call = [](const std::string& kind) {
    return Print(kind + "\n%6 = const i32 5\nhost fault (%5, %6)\n").source;
  };
  EXPECT_THAT(call("%5 = const i8 0"), HasSubstr("  fault(host, fault_kind::LOW, 5);\n"));
  EXPECT_THAT(call("%5 = const i8 1"), HasSubstr("  fault(host, fault_kind::HIGH, 5);\n"));
  EXPECT_THAT(call("%5 = load V"), HasSubstr("  fault(host, static_cast<fault_kind>(m[V]), 5);\n"));
}

TEST(Branches, AnElseArmThatIsOneIfIsAChain) {
  const std::string source = Print(
                                 "%0 = load a\nif %0 {\n%1 = const bit 1\nstore c %1\n} else {\n%2 = load b\nif %2 "
                                 "{\n%3 = const bit 0\nstore c %3\n}\n}")
                                 .source;
  EXPECT_THAT(source, HasSubstr("  if (m[a]) {\n    m[c] = true;\n  } else if (m[b]) {\n    m[c] = false;\n  }\n"));
}

TEST(StorageChoice, SingleBitsHaveAByteEachAndMixedBytesStayPacked) {
  const Printed printed =
      Print("%0 = load WORD\nstore V %0\n%1 = load W\nstore a %1\n%2 = load KEPT\nstore KEPT_WORD %0");
  EXPECT_THAT(printed.header, HasSubstr("enum Bit : uint16_t {\n  a,\n};\n"));
  EXPECT_THAT(printed.header, HasSubstr("enum Byte : uint16_t {\n  WORD,\n  V,\n};\n"));
  EXPECT_THAT(printed.header, HasSubstr("inline constexpr plcxx::PackedBit W{WORD, 3};\n"));
  EXPECT_THAT(printed.header, HasSubstr("inline constexpr plcxx::RetentiveBit KEPT{1, 4};\n"));
  EXPECT_THAT(printed.header, HasSubstr("  KEPT_WORD = 2,\n"));
  // The statement's text is the same for a bit of its own and a bit of a word.
  EXPECT_THAT(printed.source, HasSubstr("  m[a] = m[W];\n"));
}

TEST(StorageChoice, AnInstanceNamedAsItsSignalGivesWay) {
  const Printed printed = Print("%0 = load a\n%1 = const i32 1\nstep.pulse_slow P6 %0 %1\n%2 = load P6\nstore b %2");
  EXPECT_THAT(printed.source, HasSubstr("  PulseSlow(m[P6_state], m[a], 1);\n  m[b] = m[P6];\n"));
}

TEST(Flavours, ReleaseCarriesNoForces) {
  const Printed release = Print("%0 = load a\nstore b %0");
  EXPECT_THAT(release.header, Not(HasSubstr("force")));
  EXPECT_THAT(Print("%0 = load a\nstore b %0", Flavour::kDebug).header, HasSubstr("force_mask"));
}

TEST(Flavours, OnlyTheCalledHostFunctionsAreDeclared) {
  EXPECT_THAT(Print("%0 = load a\nstore b %0").header, Not(HasSubstr("fault")));
}

}  // namespace
}  // namespace plcxx::emit::print
