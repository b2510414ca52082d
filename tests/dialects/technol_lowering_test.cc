// What the instructions of a module become.

#include <map>
#include <string>

#include "tests/dialects/technol_lowered.h"

namespace plcxx::technol {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;
using testing::StartsWith;
using testing::UnorderedElementsAre;

// covers: TECHNOL-077
TEST(TechnolLowering, ALogicSequenceIsOneExpression) {
  EXPECT_THAT(Main("LDR A\nLO B\nLA -C\nWR Q\n"),
              ElementsAre("stmt Q", "%0 = load A", "%1 = load B", "%2 = or.bit %0 %1", "%3 = load C", "%4 = not.bit %3",
                          "%5 = and.bit %2 %4", "store Q %5"));
}

// covers: TECHNOL-095
TEST(TechnolLowering, ALoadWithWhatIsStoredIsOneExpression) {
  EXPECT_THAT(Main("LOD W\nAD CNST.1\nSTO W\n"),
              ElementsAre("stmt W", "%0 = load W", "%1 = const i16 1", "%2 = add.i16 %0 %1", "store W %2"));
}

// covers: TECHNOL-096
TEST(TechnolLowering, ADoublewordMakesTheOperationWide) {
  EXPECT_THAT(Main("LOD W\nAD D\nSTO D\n"), IsSupersetOf({"%4 = add.i32 %2 %3", "store D %4"}));
}

size_t StatementsOf(const std::vector<std::string>& lines) {
  return static_cast<size_t>(std::ranges::count_if(lines, [](const auto& line) { return line.starts_with("stmt"); }));
}

TEST(TechnolLowering, AStatementOfAssemblerEndsWhereItStores) {
  EXPECT_EQ(StatementsOf(Main("MOV AX,W\nMOV W,AX\nMOV BX,AX\nMOV W,BX\n")), 2);
  EXPECT_EQ(StatementsOf(Main("MOV AX,W\nCMP W,AX\nMOV BX,AX\nMOV W,BX\n")), 1);
}

TEST(TechnolLowering, WhatAMacroAddsIsAStatementOfItsOwn) {
  LoweredProgram lowered;
  LowerInto(lowered,
            "ZAPIS MACRO\nWR Q\nENDM\nDATA\nBITS: DFM A,Q\nDATA_END\nMODULE_MAIN\nLDR A\n ZAPIS\nMODULE_MAIN_END\n"
            "STOP\n");
  EXPECT_THAT(lowered.Reported({"TE"}), IsEmpty());
  EXPECT_EQ(StatementsOf(lowered.Routine("MODULE_MAIN")), 2);
}

TEST(TechnolLowering, TheCommentOfAByteIsThatOfItsBits) {
  LoweredProgram lowered;
  LowerInto(lowered,
            "DATA\nBITS: DFM A,Q ; memory\nOUT0: DFM V1,V2 ; valves\nDATA_END\nMODULE_MAIN\nLDR A\nWR Q\nWR V1\n"
            "WR V2\nMODULE_MAIN_END\nSTOP\n");
  std::map<std::string, std::string> meanings;
  for (const ir::Documentation& known : lowered.program().documentation) meanings[known.symbols] = known.meaning;
  EXPECT_EQ(meanings["A"], "memory");
  EXPECT_EQ(meanings["Q"], "memory");
  EXPECT_EQ(meanings["V2"], "valves");
}

// The head of a file at its first module, the end of a module at its end.
TEST(TechnolLowering, CommentsAboutAFileAndAModuleAreKept) {
  LoweredProgram lowered;
  LowerInto(lowered,
            "; saw, version 3\n\nDATA\nBITS: DFM A,Q\nDATA_END\nMODULE_INIT\nFL 0,Q\nMODULE_INIT_END ; end of init\n"
            "MODULE_MAIN\nLDR A\nWR Q\n; last\nMODULE_MAIN_END ; end of main\nSTOP\n");
  std::vector<std::string> comments;
  for (const ir::Statement& statement : lowered.program().statements) {
    for (const source::Range& range : statement.comments) comments.emplace_back(lowered.sources.Text(range));
  }
  EXPECT_THAT(comments, ElementsAre("; saw, version 3", "MODULE_INIT", "; end of init", "MODULE_MAIN", "; last",
                                    "; end of main"));
}

// One inside a module has its line and comments there; one beside the modules has nothing else.
TEST(TechnolLowering, AMechanismBesideTheModulesBeginsWithItsOwnLine) {
  LoweredProgram lowered;
  LowerInto(lowered,
            "; arm, version 2\n\n; --- the arm\nMECH_BEGIN RUKA ; down and up\nFL 1,Q\nMECH_END RUKA\n"
            "DATA\nBITS: DFM A,Q\nDATA_END\nMODULE_MAIN\nFL 1,RUKA\n; --- the door\nMECH_BEGIN DVERE ; open\n"
            "FL 0,Q\nMECH_END DVERE\nMODULE_MAIN_END\nSTOP\n");
  EXPECT_THAT(lowered.Reported({"TE"}), IsEmpty());
  std::vector<std::string> comments;
  for (const ir::Statement& statement : lowered.program().statements) {
    for (const source::Range& range : statement.comments) comments.emplace_back(lowered.sources.Text(range));
  }
  EXPECT_THAT(comments, UnorderedElementsAre("; arm, version 2", "; --- the arm", "MECH_BEGIN RUKA ; down and up",
                                             "MODULE_MAIN", "; --- the door"));
}

TEST(TechnolLowering, AJumpBackWithinAStretchNeedsNoStep) {
  EXPECT_THAT(Main("FL 1,B\nZPET: LDR A\nJL1 ZPET\nWR C\n"), Not(Contains(HasSubstr("step"))));
}

// covers: TECHNOL-155
TEST(TechnolLowering, AJumpBehindCmpIsAComparison) {
  EXPECT_THAT(Main("MOV AX,W\nCMP AX,5\nJA L\nFL 1,A\nL: LDR A\nWR B\n"),
              IsSupersetOf({"%8 = zext.i16.i32 %0", "%10 = ugt.i32 %8 %9", "jump L5 if %10"}));
  EXPECT_THAT(Main("MOV AX,W\nCMP AX,5\nJL L\nFL 1,A\nL: LDR A\nWR B\n"), Contains("%7 = slt.i16 %0 %1"));
}

// covers: TECHNOL-139, TECHNOL-142
TEST(TechnolLowering, HalvesOfRegistersAreTakenApartWithoutComputing) {
  EXPECT_THAT(Main("MOV AL,X\nMOV AH,5\nMOV X,AH\n"), IsSupersetOf({"%4 = const i8 5", "store X %4"}));
  EXPECT_THAT(Main("MOV BL,X\nXOR BH,BH\nMOV W,BX\n"), IsSupersetOf({"%5 = zext.i8.i16 %0", "store W %5"}));
}

// covers: TECHNOL-068
TEST(TechnolLowering, AnIndexedAccessIsCheckedBesideIt) {
  const std::vector<std::string> lines = Main("MOV BX,W\nMOV AL,X[BX]\nMOV X,AL\n");
  EXPECT_THAT(lines, IsSupersetOf({"%1 = sext.i16.i32 %0", "%3 = add.i32 %1 %2", "%4 = const i32 7",
                                   "%5 = ugt.i32 %3 %4", "if %5 {", "%8 = load X_indexed[%1]", "store X %8"}));
}

// covers: TECHNOL-068
TEST(TechnolLowering, AnIndexThatCannotLeaveTheAreaIsNotChecked) {
  const std::string data =
      "DATA\nTAB: DS 256\nX: DB ?\nDATA_END\nMODULE_MAIN\nMOV BL,X\nXOR BH,BH\nMOV AL,BYTE PTR "
      "TAB[BX]\nMOV X,AL\nMODULE_MAIN_END\nSTOP\n";
  LoweredProgram lowered;
  LowerInto(lowered, data);
  EXPECT_THAT(lowered.Reported({"TE"}), IsEmpty());
  EXPECT_THAT(lowered.Routine("MODULE_MAIN"), Not(Contains(testing::StartsWith("host fault"))));
}

// covers: TECHNOL-103
TEST(TechnolLowering, AnIndexIsCheckedWhereTheAreaIsAByteTooShort) {
  const auto is_checked = [](std::string_view index, uint32_t bytes) {
    LoweredProgram lowered;
    LowerInto(lowered, "DATA\nX: DB ?\nW: DW ?\nV: DS " + std::to_string(bytes) + "\nDATA_END\nMODULE_MAIN\n" +
                           std::string(index) + "MODULE_MAIN_END\nSTOP\n");
    EXPECT_THAT(lowered.Reported({"TE"}), IsEmpty()) << index;
    const std::vector<std::string> lines = lowered.Routine("MODULE_MAIN");
    return std::any_of(lines.begin(), lines.end(),
                       [](const std::string& line) { return line.find("fault") != std::string::npos; });
  };
  // The cells in front of V are three bytes of the area.
  const std::vector<std::pair<std::string, uint32_t>> rows = {
      {"MOVZX BX,X\nMOV AL,BYTE.V[BX]\n", 256},         {"MOVZX EBX,X\nMOV AL,BYTE.V[EBX]\n", 256},
      {"MOVZX BX,X\nMOV AX,WORD.V[BX]\n", 257},         {"MOVZX BX,X\nMOV AL,BYTE.(V+10)[BX]\n", 266},
      {"MOV BX,W\nAND BX,31\nMOV AL,BYTE.V[BX]\n", 32}, {"MOV BX,W\nAND BX,7FFFh\nMOV AL,BYTE.V[BX]\n", 32768}};
  for (const auto& [index, bytes] : rows) {
    EXPECT_FALSE(is_checked(index, bytes)) << index;
    EXPECT_TRUE(is_checked(index, bytes - 1)) << index;
  }
  EXPECT_TRUE(is_checked("MOV BX,W\nAND BX,8FFFh\nMOV AL,BYTE.V[BX]\n", 40000));
  EXPECT_TRUE(is_checked("MOV BX,W\nMOV AL,BYTE.V[BX]\n", 32768));
}

TEST(TechnolLowering, ADivisionBranchesWhereTheDivisorIsNotKnown) {
  EXPECT_THAT(Main("LOD W\nDIVB X\nSTO W\n"), Contains("} else {"));
  EXPECT_THAT(Main("LOD W\nDIVB CNST.10\nSTO W\n"), Not(Contains("} else {")));
}

// covers: TECHNOL-115, TECHNOL-119
TEST(TechnolLowering, AMechanismIsASwitchOverItsStep) {
  LoweredProgram lowered;
  LowerInto(lowered, TechnolProgram("FL 1,M\n", "MECH_BEGIN M\nFL 1,A\nLDR B\nEX0\nFL 1,C\nMECH_END M\n"));
  EXPECT_THAT(lowered.Reported({"TE"}), IsEmpty());
  std::vector<std::string> lines = lowered.Routine("mech_M");
  lines.erase(lines.begin(), std::find(lines.begin(), lines.end(), "%12 = load M_step"));
  std::erase_if(lines, [](const std::string& line) { return line.starts_with("store rlo"); });
  EXPECT_THAT(lines, ElementsAre("%12 = load M_step", "switch %12 {", "default falls_through {", "stmt A",
                                 "%0 = const bit 1", "store A %0", "}", "case 1 {", "stmt M", "%0 = load B",
                                 "%1 = not.bit %0", "if %1 {", "%2 = const i16 1", "store M_step %2", "jump L0", "}",
                                 "stmt C", "%0 = const bit 1", "store C %0", "stmt M", "%0 = const bit 0", "store M %0",
                                 "%1 = const i16 0", "store M_step %1", "}", "}", "label L0"));
}

// covers: TECHNOL-116
TEST(TechnolLowering, AJumpBackAcrossAWaitIsAnotherRoundOfTheSwitch) {
  LoweredProgram lowered;
  LowerInto(lowered,
            TechnolProgram("FL 1,M\n", "MECH_BEGIN M\nFL 1,A\nZ: FL 1,C\nLDR B\nEX0\nLDR A\nJL1 Z\nMECH_END M\n"));
  EXPECT_THAT(lowered.Reported({"TE"}), IsEmpty());
  const std::vector<std::string> lines = lowered.Routine("mech_M");
  const auto has = [&](std::string_view line) { return std::ranges::count(lines, line); };
  EXPECT_EQ(has("default falls_through {"), 1) << "up to Z";
  EXPECT_EQ(has("case 1 falls_through {"), 1) << "from Z to the wait";
  EXPECT_EQ(has("case 2 {"), 1);
  EXPECT_THAT(lines, Contains(StartsWith("loop")));
  EXPECT_THAT(lines, Contains(StartsWith("repeat")));
  EXPECT_THAT(lines, Not(Contains(HasSubstr("resume"))));
}

// covers: TECHNOL-116
TEST(TechnolLowering, AJumpToTheNextStretchEndsItsOwn) {
  LoweredProgram lowered;
  LowerInto(lowered,
            TechnolProgram("FL 1,M\n", "MECH_BEGIN M\nLDR A\nJL1 Z\nFL 1,C\nZ: LDR B\nEX0\nFL 0,C\nMECH_END M\n"));
  EXPECT_THAT(lowered.Reported({"TE"}), IsEmpty());
  EXPECT_THAT(lowered.Routine("mech_M"), IsSupersetOf({"default falls_through {", "case 1 {"}));
}

// covers: TECHNOL-089
TEST(TechnolLowering, SubprogramsWithACommonTailAreOneRoutine) {
  LoweredProgram lowered;
  LowerInto(lowered, TechnolProgram("CALL S1\nCALL S2\n", "S1: FL 1,A\nS2: FL 1,B\nRET\n"));
  EXPECT_THAT(lowered.Reported({"TE"}), IsEmpty());
  EXPECT_THAT(lowered.Routine("S1"), IsSupersetOf({"%0 = load entry", "switch %0 {", "case 1 {"}));
  EXPECT_THAT(lowered.Routine("MODULE_MAIN"), IsSupersetOf({"call S1 (%0)"}));
}

/// The calls of so many subprograms of which each runs on into the next one.
std::vector<std::string> CallsOfEntries(uint32_t count) {
  std::string calls, subprograms;
  for (uint32_t i = 0; i < count; ++i) {
    calls += "CALL S" + std::to_string(i) + "\n";
    subprograms += "S" + std::to_string(i) + ": FL 1,A\n";
  }
  LoweredProgram lowered;
  LowerInto(lowered, TechnolProgram(calls, subprograms + "RET\n"));
  return lowered.Routine("MODULE_MAIN");
}

TEST(TechnolLowering, EntriesThatAByteCannotCountAreNumberedInMore) {
  EXPECT_THAT(CallsOfEntries(256), Contains(HasSubstr("const i8 255")));
  EXPECT_THAT(CallsOfEntries(257), Contains(HasSubstr("const i32 256")));
}

// covers: TECHNOL-087
TEST(TechnolLowering, ARefusedJumpInASubprogramLeavesItsCallers) {
  LoweredProgram lowered;
  LowerInto(lowered, TechnolProgram("CALL S\nFL 1,A\n", "S: LDR B\nJL1 S\nRET\n"));
  EXPECT_THAT(lowered.Reported({"TE"}), IsEmpty());
  EXPECT_THAT(lowered.Routine("MODULE_MAIN"), IsSupersetOf({"%0 = call S ()", "jump L0 if %0"}));
}

// covers: TECHNOL-196
TEST(TechnolLowering, WhatUsesAValueOfAnEarlierStatementIsAStatementOfItsOwn) {
  const auto statements = [](std::string_view code) {
    const std::vector<std::string> lines = Main(code);
    return std::count_if(lines.begin(), lines.end(), [](const std::string& line) { return line.starts_with("stmt"); });
  };
  EXPECT_EQ(statements("LOD W\nSTO D\nLDR A\nWR B\nSTO W\n"), 3);
  EXPECT_EQ(statements("LDR A\nWR B\nLOD W\nSTO D\nWR C\n"), 3);
  EXPECT_EQ(statements("LOD W\nLDR A\nWR B\nAD W\nSTO W\n"), 3);
}

TEST(TechnolLowering, ACommentInFrontOfTheEndOfAModuleIsKeptThere) {
  LoweredProgram lowered;
  LowerInto(lowered, TechnolProgram("LDR A\nWR B\n; the last one\n", "S: LDR A\nWR C\nRET\n"));
  const std::vector<std::string> lines = lowered.Routine("MODULE_MAIN");
  EXPECT_EQ(lines.back(), "stmt");
  std::vector<std::string> comments;
  for (const ir::Statement& statement : lowered.program().statements) {
    for (const source::Range comment : statement.comments) comments.emplace_back(lowered.sources.Text(comment));
  }
  EXPECT_THAT(comments, Contains(testing::HasSubstr("the last one")));
}

TEST(TechnolLowering, AModuleThatTheSchedulerDoesNotKnowIsARoutineOfItsName) {
  LoweredProgram lowered;
  LowerInto(
      lowered,
      "DATA\nBITS: DFM A,B\nDATA_END\nMODULE_MAIN\nMODULE_MAIN_END\nMODULE_AZ_9\nLDR A\nWR B\nMODULE_AZ_9_END\nSTOP\n");
  EXPECT_FALSE(lowered.Routine("module_az_9").empty());
}

TEST(TechnolLowering, OnlyRequestsOfTheProgramAreAskedFor) {
  LoweredProgram lowered;
  LowerInto(lowered, TechnolProgram("FL 1,REQ_CLOSE_ALL\n"));
  EXPECT_THAT(lowered.Routine("requests"), IsSupersetOf({"%0 = load REQ_CLOSE_ALL", "host close_all ()"}));
  EXPECT_THAT(lowered.Routine("requests"), Not(Contains("host backup_pos ()")));
}

TEST(TechnolLocate, AddressesWithoutRegisters) {
  LoweredProgram lowered;
  LowerInto(lowered, TechnolProgram("LDR A\nWR Q\nMECH_BEGIN M\nMECH_END M\n"));
  const auto at = [&](std::string_view text) {
    const auto location = Locate(ir::NameIndex(lowered.program()), text);
    if (!location) return std::string("none");
    const ir::Place& place = location->place;
    return lowered.program().spaces[place.space].name + " " + std::to_string(place.offset) + " " +
           std::string(ir::Name(place.type));
  };
  EXPECT_EQ(at("a"), "DATA 0 bit");
  EXPECT_EQ(at("M"), "mechanisms 0 bit");
  EXPECT_EQ(at("W"), "DATA 2 i16");
  EXPECT_EQ(at("BYTE.W+1"), "DATA 3 i8");
  EXPECT_EQ(at("DWRD.(TAB_TECHNOL+32)"), "TAB_TECHNOL 32 i32");
  EXPECT_EQ(at("byte.(LABEL_MEM + 3*4)"), "LABEL_MEM 12 i8");
  EXPECT_EQ(at("TAB_TECHNOL.TCH_VOLBA"), "TAB_TECHNOL 6 i16");
  EXPECT_EQ(at("WORD.LABEL_MEM[10]"), "LABEL_MEM 10 i16");
  EXPECT_EQ(at("REQ_PIS_HALT"), "SYS 7 bit");
  EXPECT_EQ(at("BUKON99"), "BUKON 396 i32");
  for (const char* text : {"LABEL_MEM", "WORD.LABEL_MEM+999", "NIC", "", "5", "WORD.", "W[BX]", "BYTE.A", "W W"}) {
    EXPECT_EQ(at(text), "none") << text;
  }
  EXPECT_EQ(ParseValue("0FFh"), 255U);
  EXPECT_EQ(ParseValue("'T'"), 84U);
  EXPECT_EQ(ParseValue("1x"), std::nullopt);
}

}  // namespace
}  // namespace plcxx::technol
