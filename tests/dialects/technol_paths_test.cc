// Errors and warnings of paths, and of reads and writes that miss each other.

#include "tests/dialects/technol_lowered.h"

namespace plcxx::technol {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr size_t kFirstCodeLine = 8;  // of the code

std::vector<std::string> Reported(std::string_view code, const std::vector<std::string>& codes,
                                  std::string_view behind = "") {
  LoweredProgram lowered;
  LowerInto(lowered, TechnolProgram(code, behind));
  std::vector<std::string> result;
  for (const std::string& line : lowered.Reported(codes)) {
    const size_t blank = line.find(' ');
    result.push_back(std::to_string(std::stoul(line.substr(0, blank)) - kFirstCodeLine + 1) + line.substr(blank));
  }
  return result;
}

// covers: TECHNOL-111, TECHNOL-162
TEST(TechnolPaths, ValuesThatNobodyLoaded) {
  EXPECT_THAT(Reported("WR A\n", {"TE"}), ElementsAre("1 TE057"));
  EXPECT_THAT(Reported("LDR A\nJL1 L\nLOD W\nL: STO W\n", {"TE"}), ElementsAre("4 TE057"));
  EXPECT_THAT(Reported("MOV W,AX\n", {"TE", "TW023"}), ElementsAre("1 TW023"));
  EXPECT_THAT(Reported("XOR AX,AX\nMOV W,AX\n", {"TE", "TW023"}), IsEmpty());
  EXPECT_THAT(Reported("JE L\nL: LDR A\nWR B\n", {"TE"}), ElementsAre("1 TE072"));
}

// covers: TECHNOL-088
TEST(TechnolPaths, ASubprogramHandsOnWhatItLoads) {
  EXPECT_THAT(Reported("CALL S\nWR A\n", {"TE"}, "S: LDR B\nRET\n"), IsEmpty());
  EXPECT_THAT(Reported("CALL S\nSTO W\n", {"TE"}, "S: LDR B\nRET\n"), ElementsAre("2 TE057"));
  // What one call has loaded does not make up for another.
  EXPECT_THAT(Reported("LDR A\nCALL S\nLOD W\nCALL S\n", {"TE"}, "S: STO W\nRET\n"), ElementsAre("6 TE057"));
}

// covers: TECHNOL-134
TEST(TechnolPaths, NothingSurvivesAWait) {
  const char* const kMechanism = "MECH_BEGIN M\nLDR A\nEX\nWR B\nMECH_END M\n";
  EXPECT_THAT(Reported("FL 1,M\n", {"TE"}, kMechanism), ElementsAre("6 TE056"));
  EXPECT_THAT(Reported("FL 1,M\n", {"TE"}, "MECH_BEGIN M\nLDR A\nEX1\nWR B\nMECH_END M\n"), IsEmpty());
  EXPECT_THAT(Reported("FL 1,M\n", {"TE"}, "MECH_BEGIN M\nLOD W\nFL 1,A\nEQ X\nEX0\nMECH_END M\n"),
              ElementsAre("6 TE056"));
}

// covers: TECHNOL-090
TEST(TechnolPaths, Subprograms) {
  EXPECT_THAT(Reported("CALL S\n", {"TE"}, "S: FL 1,A\n"), ElementsAre("3 TE049"));
  EXPECT_THAT(Reported("LDR A\nWR B\n", {"TE"}, "S: FL 1,A\n"), ElementsAre("4 TE049"));
  EXPECT_THAT(Reported("CALL S\n", {"TE"}, "S: CALL T\nRET\nT: CALL S\nRET\n"), ElementsAre("5 TE050"));
}

TEST(TechnolPaths, SixteenCallsDeepAtMost) {
  std::string chain;
  for (int i = 1; i < 17; ++i) {
    chain += "S" + std::to_string(i) + ": CALL S" + std::to_string(i + 1) + "\nRET\n";
  }
  chain += "S17: RET\n";
  EXPECT_THAT(Reported("CALL S2\n", {"TE"}, chain), IsEmpty());
  EXPECT_THAT(Reported("CALL S1\n", {"TE"}, chain), ElementsAre("33 TE051"));
}

/// A mechanism with so many waits, and what stands behind them.
std::string Waiting(size_t waits, const std::string& before = "", const std::string& behind = "") {
  std::string code = "MECH_BEGIN M\n" + before;
  for (size_t i = 0; i < waits; ++i) code += "EX\n";
  return code + behind + "MECH_END M\n";
}

TEST(TechnolPaths, AMechanismGoesOnAtNoMorePlacesThanAWordNumbers) {
  LoweredProgram most;
  LowerInto(most, TechnolProgram("FL 1,M\n", Waiting(65535)));
  EXPECT_THAT(most.Reported({"TE"}), IsEmpty());
  const std::vector<std::string> lines = most.Routine("mech_M");
  EXPECT_THAT(lines, testing::Contains(testing::HasSubstr("case 65535 ")));
  EXPECT_THAT(lines, testing::Contains(testing::HasSubstr("const i16 65535")));
  EXPECT_THAT(Reported("FL 1,M\n", {"TE"}, Waiting(65536)), ElementsAre("65539 TE078"));
  // A label counts where a jump leads back to it across a wait, and not where it begins the mechanism.
  const std::string back = "LDR A\nJL1 L\n";
  EXPECT_THAT(Reported("FL 1,M\n", {"TE"}, Waiting(65534, "FL 1,B\nL: FL 0,B\n", back)), IsEmpty());
  EXPECT_THAT(Reported("FL 1,M\n", {"TE"}, Waiting(65535, "FL 1,B\nL: FL 0,B\n", back)), ElementsAre("65540 TE078"));
  EXPECT_THAT(Reported("FL 1,M\n", {"TE"}, Waiting(65535, "L: FL 0,B\n", back)), IsEmpty());
}

// covers: TECHNOL-154
TEST(TechnolPaths, PushAndPop) {
  EXPECT_THAT(Reported("MOV AX,1\nPUSH AX\nPOP BX\nMOV W,BX\n", {"TE"}), IsEmpty());
  EXPECT_THAT(Reported("MOV AX,1\nPUSH AX\n", {"TE"}), ElementsAre("2 TE071"));
  EXPECT_THAT(Reported("POP AX\nMOV W,AX\n", {"TE"}), ElementsAre("1 TE071"));
  EXPECT_THAT(Reported("MOV EAX,1\nPUSH EAX\nPOP BX\nMOV W,BX\n", {"TE"}), ElementsAre("3 TE071"));
  EXPECT_THAT(Reported("MOV AX,1\nLDR A\nJL1 L\nPUSH AX\nL: LDR B\nWR C\n", {"TE"}), ElementsAre("4 TE071"));
}

// covers: TECHNOL-110
TEST(TechnolPaths, WidthsOfTheDataRegister) {
  EXPECT_THAT(Reported("LOD W\nLDR A\nJL1 L\nLOD D\nL: STO D\n", {"TE", "TW022"}), ElementsAre("5 TW022"));
  EXPECT_THAT(Reported("LOD W\nLDR A\nJL1 L\nLOD D\nSTO D\nL: LDR A\nWR B\n", {"TE", "TW022"}), IsEmpty());
  EXPECT_THAT(Reported("LOD D\nSTO W\n", {"TW020"}), ElementsAre("2 TW020"));
}

// covers: TECHNOL-132, TECHNOL-209
TEST(TechnolPaths, WaitsOutsideAndCodeThatNothingReaches) {
  EXPECT_THAT(Reported("LDR A\nEX1\n", {"TE"}), ElementsAre("2 TE058"));
  EXPECT_THAT(Reported("JUM L\nFL 1,A\nFL 1,B\nL: FL 1,C\n", {"TW005"}), ElementsAre("2 TW005"));
  EXPECT_THAT(Reported("LDR A\nLDR B\nWR C\n", {"TW026"}), ElementsAre("1 TW026"));
}

// covers: TECHNOL-206, TECHNOL-208, TECHNOL-210
TEST(TechnolPaths, ReadsAndWrites) {
  EXPECT_THAT(Reported("LDR A\nWR B\nWR B\n", {"TW006"}), ElementsAre("3 TW006"));
  EXPECT_THAT(Reported("LDR A\nWR B\nFL 1,B\n", {"TW006"}), ElementsAre("3 TW006"));
  EXPECT_THAT(Reported("FL 1,B\nFL 0,B\n", {"TW006"}), IsEmpty());
  EXPECT_THAT(Reported("MECH_BEGIN M\nMECH_END M\n", {"TW009"}), ElementsAre("1 TW009"));
  EXPECT_THAT(Reported("LOD CNST.1\nSTO IN3\n", {"TW012"}), ElementsAre("2 TW012"));
  EXPECT_THAT(Reported("FL 0,REQ_CLOSE_ALL\n", {"TW013"}), ElementsAre("1 TW013"));
  EXPECT_THAT(Reported("FL 1,REQ_CLOSE_ALL\n", {"TW014"}), ElementsAre("1 TW014"));
}

}  // namespace
}  // namespace plcxx::technol
