// Where values live: overlapping, unaligned, indexed, retentive, floating-point. Emitted, compiled, compared.

#include <gmock/gmock.h>

#include "tests/emit/emitted_program.h"

namespace plcxx::emit {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The body of the period over these declarations.
std::string WithPeriod(std::string_view declarations, std::string_view body) {
  return std::string(declarations) + "routine period schedule {\n" + std::string(body) + "}\nschedule period period\n";
}

/// Words at odd addresses, in bytes that are also read as bytes and bits.
constexpr std::string_view kOverlaps = R"(space F 16 volatile ORDER host_visible
place F0_1 bit F[0].1
place F1_7 bit F[1].7
place F9_0 bit F[9].0
place F15_3 bit F[15].3
place FB1 i8 F[1]
place FB3 i8 F[3]
place FB12 i8 F[12]
place FW0 i16 F[0]
place FW1 i16 F[1]
place FW5 i16 F[5]
place FD2 i32 F[2]
place FQ4 i64 F[4]
place FW13 i16 F[13]
)";

constexpr std::string_view kOverlapBody = R"(
  stmt s1
  %0 = load FW0
  %1 = load FW1
  %2 = add.i16 %0 %1
  store FW5 %2
  stmt s2
  %0 = load FB1
  %1 = load FB3
  %2 = add.i8 %0 %1
  store FB12 %2
  stmt s3
  %0 = load F1_7
  %1 = load F0_1
  %2 = and.bit %0 %1
  store F9_0 %2
  stmt s4
  %0 = load FD2
  %1 = const i32 0x10001
  %2 = add.i32 %0 %1
  store FD2 %2
  stmt s5
  %0 = load FQ4
  %1 = low_half.i64 %0
  %2 = sext.i32.i64 %1
  store FQ4 %2
  stmt s6
  %0 = load FW13
  %1 = load FW1
  %2 = or.i16 %0 %1
  store FW13 %2
  stmt s7
  %0 = load FW13
  %1 = load FB3
  %2 = zext.i8.i16 %1
  %3 = eq.i16 %0 %2
  store F15_3 %3
)";

std::string Ordered(std::string_view declarations, std::string_view order) {
  std::string text(declarations);
  text.replace(text.find("ORDER"), 5, order);
  return text;
}

const std::vector<std::string> kOverlapInputs = {"FW0", "FW1", "FB3", "FD2", "FQ4", "FW13", "F0_1"};

TEST(EmitStorage, OverlappingWordsOfEitherOrder) {
  for (const std::string_view order : {"little", "big"}) {
    const EmittedProgram program(WithPeriod(Ordered(kOverlaps, order), kOverlapBody), kOverlapInputs);
    program.ExpectRunsAsSimulated();
    program.ExpectDebugsAsSimulated();
  }
}

TEST(EmitStorage, AStatementsTextDoesNotDependOnTheStorage) {
  const EmittedProgram program(WithPeriod(Ordered(kOverlaps, "little"), kOverlapBody), {});
  EXPECT_THAT(program.Source(), HasSubstr("  m[FW5] = Add16(m[FW0], m[FW1]);\n"));
  EXPECT_THAT(program.Source(), HasSubstr("  m[FW13] = m[FW13] | m[FW1];\n"));
  EXPECT_THAT(program.Header(), HasSubstr("inline constexpr plcxx::Little<uint16_t> FW5{F_0 + 5};\n"));
  // FW13 overlaps nothing: a member of its own.
  EXPECT_THAT(program.Header(), HasSubstr("enum Word16 : uint16_t {\n  FW13,\n};\n"));
  EXPECT_THAT(program.Header(), HasSubstr("enum Byte : uint16_t {\n  FB12,\n  F_0,  // F 0..11 at several widths\n"
                                          "  FB1 = F_0 + 1,\n  FB3 = F_0 + 3,\n};\n"));
  EXPECT_THAT(program.Header(), HasSubstr("inline constexpr plcxx::PackedBit F9_0{F_0 + 9, 0};\n"));
  EXPECT_THAT(program.Header(), HasSubstr("#include <plcxx/wide.h>\n"));
}

TEST(EmitStorage, RetentiveValuesAreBytesInAddressOrder) {
  constexpr std::string_view kRetentive = R"(space W 24 retentive ORDER host_visible
space B 2 retentive little host_visible
place W0 i32 W[0]
place W1 i32 W[4]
place W1L i16 W[4]
place F2 f32 W[8]
place D3 i64 W[12]
place W20_4 bit W[20].4
place WB21 i8 W[21]
place B9 bit B[1].1
)";
  constexpr std::string_view kBody = R"(
  %0 = load W0
  %1 = load W1
  %2 = sub.i32 %0 %1
  store W1 %2
  stmt s2
  %0 = load F2
  %1 = const f32 0x3FC00000
  %2 = mul.f32 %0 %1
  store F2 %2
  stmt s3
  %0 = load D3
  %1 = load W0
  %2 = sext.i32.i64 %1
  %3 = mul.i64 %0 %2
  store D3 %3
  stmt s4
  %0 = load B9
  store W20_4 %0
  stmt s5
  %0 = load W1L
  %1 = low_byte.i16 %0
  store WB21 %1
)";
  for (const std::string_view order : {"little", "big"}) {
    const EmittedProgram program(WithPeriod(Ordered(kRetentive, order), kBody), {"W0", "W1", "F2", "D3", "B9"});
    program.ExpectRunsAsSimulated();
    program.ExpectDebugsAsSimulated();
    const std::string kind = order == "little" ? "RetentiveLittle" : "RetentiveBig";
    EXPECT_THAT(program.Header(), HasSubstr("inline constexpr plcxx::" + kind + "<float> F2{8};\n"));
    EXPECT_THAT(program.Source(), HasSubstr("  m[F2] = MulF32(m[F2], 1.5F);\n"));
  }
}

TEST(EmitStorage, FloatsOfTheirOwnAreMembers) {
  constexpr std::string_view kFloats = R"(space F 16 volatile little host_visible
place F0 f32 F[0]
place F1 f32 F[4]
place F2 f32 F[8]
place F2W i32 F[8]
place F3 f32 F[12]
space B 1 volatile little host_visible
place B0 bit B[0].0
place B1 bit B[0].1
)";
  constexpr std::string_view kBody = R"(
  %0 = load F0
  %1 = load F1
  %2 = add.f32 %0 %1
  store F1 %2
  stmt s2
  %0 = load F1
  %1 = load F2
  %2 = lt.f32 %0 %1
  store B0 %2
  stmt s3
  %0 = load F2W
  %1 = sint_to_f32 %0
  store F3 %1
  stmt s4
  %0 = load F3
  %1 = const f32 0x7F800000
  %2 = const f32 0xC0490FDB
  %3 = gt.f32 %0 %2
  %4 = ne.f32 %0 %1
  %5 = and.bit %3 %4
  store B1 %5
)";
  const EmittedProgram program(WithPeriod(kFloats, kBody), {"F0", "F2", "F2W"});
  program.ExpectRunsAsSimulated();
  program.ExpectDebugsAsSimulated();
  EXPECT_THAT(program.Header(), HasSubstr("enum Float32 : uint16_t {\n  F0,\n  F1,\n  F3,\n};\n"));
  EXPECT_THAT(program.Header(), HasSubstr("inline constexpr plcxx::Little<float> F2{F_8};\n"));
  EXPECT_THAT(program.Header(), HasSubstr("#include <plcxx/floats.h>\n"));
  EXPECT_THAT(program.Source(), HasSubstr("(t104 > -3.1415927F) & NotEqualF32(t104, F32OfBits(0x7F800000))"));
}

/// A table of words and the bytes of it, by an index; in a volatile and in a retentive space.
constexpr std::string_view kIndexed = R"(space D 40 LIFETIME ORDER host_visible
place DB10 i8 D[10] stride 1 low 4 high 30 indexed
place DW10 i16 D[10] stride 1 low 4 high 30 indexed
place ROW i32 D[16] stride 5 low 4 high 30 indexed
place NONE i64 D[8] stride 3 low 8 high 12 indexed
place DB8 i8 D[8]
place DW6 i16 D[6]
place DW28 i16 D[28]
place DD20 i32 D[20]
place DW32 i16 D[32]
space I 12 volatile little host_visible
place at i32 I[0]
place word i16 I[4]
place byte i8 I[6]
place long i32 I[8]
)";

constexpr std::string_view kIndexedBody = R"(
  %0 = load at
  %1 = const i32 4294967290
  %2 = add.i32 %0 %1
  %3 = load byte
  store DB10[%2] %3
  stmt s2
  %0 = load at
  %1 = load DW10[%0]
  %2 = load word
  %3 = add.i16 %1 %2
  store word %3
  stmt s3
  %0 = load at
  %1 = load long
  store ROW[%0] %1
  stmt s4
  %0 = load at
  %1 = load ROW[%0]
  store long %1
  stmt s5
  %0 = load at
  %1 = load DW10[%0]
  %2 = load DB10[%0]
  %3 = with_low_byte.i16 %1 %2
  store DW10[%0] %3
  store DW32 %3
  stmt s6
  %0 = load at
  %1 = load NONE[%0]
  store NONE[%0] %1
)";

std::string Lasting(std::string text, std::string_view lifetime) {
  text.replace(text.find("LIFETIME"), 8, lifetime);
  return text;
}

TEST(EmitStorage, IndicesOutsideReadZeroAndWriteNothing) {
  for (const std::string_view lifetime : {"volatile", "retentive"}) {
    for (const std::string_view order : {"little", "big"}) {
      const EmittedProgram program(WithPeriod(Ordered(Lasting(std::string(kIndexed), lifetime), order), kIndexedBody),
                                   {"at", "word", "byte", "long", "DW28", "DB8"});
      program.ExpectRunsAsSimulated();
      program.ExpectDebugsAsSimulated();
    }
  }
}

TEST(EmitStorage, AnIndexedPlaceIsReadAndWrittenByAt) {
  const EmittedProgram program(WithPeriod(Ordered(Lasting(std::string(kIndexed), "volatile"), "little"), kIndexedBody),
                               {});
  EXPECT_THAT(program.Source(), HasSubstr("  m[At(ROW, m[at])] = m[long_n];\n"));
  EXPECT_THAT(program.Source(), HasSubstr("  m[word] = Add16(m[At(DW10, m[at])], m[word]);\n"));
  EXPECT_THAT(program.Header(),
              HasSubstr("inline constexpr plcxx::Indexed<plcxx::Little<uint16_t>> DW10{D_4, 1, -6, 25};\n"));
  EXPECT_THAT(program.Header(),
              HasSubstr("inline constexpr plcxx::Indexed<plcxx::Little<uint32_t>> ROW{D_4 + 2, 5, -2, 5};\n"));
  EXPECT_THAT(program.Header(), HasSubstr("Little<uint64_t>> NONE{D_4"));
  EXPECT_THAT(program.Header(), HasSubstr("enum Word16 : uint16_t {\n  DW32,\n  word,\n};\n"));
}

TEST(EmitStorage, InitialValuesReachEveryKindOfStorage) {
  std::string text = R"(space D 60 volatile ORDER host_visible
space R 8 retentive ORDER host_visible
place D0_3 bit D[0].3
place DB1 i8 D[1]
place DB1_0 bit D[1].0
place DW2 i16 D[2]
place DD4 i32 D[4]
place DF8 f32 D[8]
place DQ12 i64 D[12]
place DW20 i16 D[20]
place DW21 i16 D[21]
place DW30 i16 D[30]
place DW32 i16 D[32]
place DW34 i16 D[34]
place DW36 i16 D[36]
place DW38 i16 D[38]
place DW40 i16 D[40]
place DW42 i16 D[42]
place DW44 i16 D[44]
place DW46 i16 D[46]
place DB50 i8 D[50] stride 1 low 50 high 60 indexed
place RW2 i16 R[2]
place R7_7 bit R[7].7
place at i32 D[24]
initial D 0 0x0F
initial D 1 0x81
initial D 2 0x34
initial D 3 0x12
initial D 5 0x07
initial D 8 0xFF
initial D 9 0x7F
initial D 10 0xFF
initial D 11 0x3F
initial D 12 1
initial D 19 2
initial D 20 0xAA
initial D 22 0xBB
initial D 25 9
initial D 30 1
initial D 33 2
initial D 36 3
initial D 38 4
initial D 40 5
initial D 41 1
initial D 42 6
initial D 44 7
initial D 46 8
initial D 51 11
initial D 52 12
initial D 54 14
initial D 55 15
initial D 56 16
initial D 57 17
initial D 58 18
initial D 59 19
initial R 2 0x78
initial R 7 0xF0
routine init init {
  %0 = load at
  %1 = load DB50[%0]
  store DB1 %1
  stmt s2
  %0 = load D0_3
  %1 = load DB1_0
  %2 = and.bit %0 %1
  store R7_7 %2
}
routine period schedule {
)";
  for (const std::string_view place : {"DW2", "DW20", "DW21", "RW2", "DW30", "DW32", "DW34", "DW36", "DW38", "DW40",
                                       "DW42", "DW44", "DW46", "DD4", "DF8", "DQ12"}) {
    const std::string name(place);
    text += "  %" + name + " = load " + name + "\n  store " + name + " %" + name + "\n";
  }
  text += "}\nschedule init init\nschedule period period\n";
  for (const std::string_view order : {"little", "big"}) {
    const EmittedProgram program(Ordered(Ordered(text, order), order), {});
    program.ExpectRunsAsSimulated();
    program.ExpectDebugsAsSimulated();
    if (order != "little") continue;
    EXPECT_THAT(program.Source(), HasSubstr("  m.bit[D0_3] = true;\n"));
    EXPECT_THAT(program.Source(), HasSubstr("  m.word32[DD4] = 1792;\n"));
    EXPECT_THAT(program.Source(), HasSubstr("  m.float32[DF8] = 1.9960936F;\n"));
    // Many values are a table whose rows begin at multiples of 16; it ends where the addresses are far apart.
    EXPECT_THAT(program.Source(), HasSubstr("  m.word16[DW2] = 4660;\n"
                                            "  {\n    static constexpr uint16_t kValues[] = {\n      1,\n"
                                            "      512, 0, 3, 4, 261, 6, 7, 8,\n    };\n"
                                            "    plcxx::Place(m.word16, DW30, kValues);\n"));
    EXPECT_THAT(program.Source(), HasSubstr("    plcxx::Place(m.byte, D_50 + 1, kValues);\n"));
    EXPECT_THAT(program.Source(), HasSubstr("  m.retentive.bytes[7] = 0xF0;\n"));
  }
}

}  // namespace
}  // namespace plcxx::emit
