// Structure of programs and operands of instructions: what comes out of right ones, what is said about wrong ones.
#include "tests/dialects/technol_parsing.h"

namespace plcxx::technol {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(TechnolParser, Operands) {
  EXPECT_THAT(
      CodeItems("LDR -A\nWR Q\nFL 1,NC_CLEAR\nLOD WORD.(LABEL_MEM + 4)\nLOD CNST.8-1\nSTO TAB_TECHNOL.TCH_AKTIV\n"
                "LOD X\nLOD BYTE.TAB_TECHNOL.TCH_SLOUPCE\nLOD DWRD.LABEL_MEM[BX+4].TCH_DATA\nRL CNST.2\n"),
      ElementsAre("LDR -A", "WR Q", "FL 1,NC_CLEAR", "LOD WORD.LABEL_MEM+4", "LOD CNST.7", "STO BYTE.TAB_TECHNOL+8",
                  "LOD BYTE.X", "LOD BYTE.TAB_TECHNOL+2", "LOD DWRD.LABEL_MEM+36[BX]", "RL CNST.2"));
  EXPECT_THAT(
      CodeItems("MOV BYTE PTR P,5\nMOV AL,P\nAND AX,0Fh\nAND CNST.0Fh\nSAL W,CL\nMOVZX EAX,X\nXCHG AX,W\nPUSH BX\n"),
      ElementsAre("MOV BYTE.P,5", "MOV AL,BYTE.P", "AND AX,15", "AND CNST.15", "SHL WORD.W,CL", "MOVZX EAX,BYTE.X",
                  "XCHG AX,WORD.W", "PUSH BX"));
}

TEST(TechnolParser, WidthsOfOperands) {
  Parsed parsed;
  ParseInto(parsed, {InProgram(kCells, "LOD CNST.0FFFFh\nLOD CNST.-8000h\nLOD CNST.10000h\nLOD BUKON07\nMOV AX,-1\n")});
  ASSERT_THAT(parsed.Errors(), IsEmpty());
  std::vector<int> widths;
  for (const Operand& operand : parsed.program.operands) widths.push_back(operand.width);
  EXPECT_THAT(widths, ElementsAre(16, 16, 32, 32, 16, 16));
}

TEST(TechnolParser, LabelsStandInFrontOfInstructionsAndMarks) {
  Parsed parsed;
  ParseInto(parsed, {InProgram(kCells, "L1:\nL2: LDR A\nL3: MECH_BEGIN M\nL4: MECH_END M\n")});
  ASSERT_THAT(parsed.Errors(), IsEmpty());
  const Program& program = parsed.program;
  std::vector<Op> ops;
  std::vector<UnitKind> units;
  for (const Label& label : program.labels) {
    ops.push_back(program.instructions[label.at].op);
    units.push_back(program.units[label.unit].kind);
  }
  EXPECT_THAT(ops, ElementsAre(Op::kLdr, Op::kLdr, Op::kMechanismBegin, Op::kMechanismEnd));
  EXPECT_THAT(units, ElementsAre(UnitKind::kModule, UnitKind::kModule, UnitKind::kModule, UnitKind::kMechanism));
}

TEST(TechnolParser, SubprogramsAreOneUnitAtTheEnd) {
  Parsed parsed;
  ParseInto(parsed, {"DATA\nDATA_END\nS1: RET\nMODULE_MAIN\nCALL S1\nCALL S2\nMODULE_MAIN_END\nS2: JUM S1\nSTOP\n"});
  ASSERT_THAT(parsed.Errors(), IsEmpty());
  const Program& program = parsed.program;
  const Unit& area = program.units[program.subprograms()];
  EXPECT_EQ(area.kind, UnitKind::kSubprograms);
  std::vector<Op> ops;
  for (uint32_t i = area.first.index; i < area.end.index; ++i) ops.push_back(program.instructions[InstructionId(i)].op);
  EXPECT_THAT(ops, ElementsAre(Op::kRet, Op::kAreaEnd, Op::kJum, Op::kAreaEnd));
}

TEST(TechnolParser, Comments) {
  Parsed parsed;
  ParseInto(parsed, {"; head\n\nDATA\n; cell\nX: DS 1 ; own\nDATA_END\nMODULE_MAIN\n; above\nLOD X ; "
                     "beside\nMODULE_MAIN_END\nSTOP\n"});
  const Program& program = parsed.program;
  const auto texts = [&](Span span) {
    std::vector<std::string> shown;
    for (uint32_t i = 0; i < span.count; ++i)
      shown.emplace_back(parsed.sources.Text(program.comments[span.first + i].range));
    return shown;
  };
  EXPECT_THAT(texts(program.files[0].header), ElementsAre("; head"));
  EXPECT_THAT(texts(parsed.Find("X")->comments), ElementsAre("; cell", "; own"));
  EXPECT_THAT(texts(program.instructions[InstructionId(0)].comments), ElementsAre("; above", "; beside"));
}

TEST(TechnolParserErrors, Structure) {
  EXPECT_THAT(ErrorsOf("MODULE_MAIN\nMODULE_MAIN_END\n"), ElementsAre("2:1 TE020", "2:1 TE021"));
  EXPECT_THAT(ErrorsOf("DATA\nDATA_END\nMODULE_INIT\nMODULE_MAIN\nMODULE_MAIN_END\nMODULE_INIT_END\nSTOP\n"),
              ElementsAre("4:1 TE024"));
  EXPECT_THAT(ErrorsOf("DATA\nDATA_END\nMODULE_INIT\nMODULE_INIT_END\nMODULE_INIT\nMODULE_FAST_END\nSTOP\n"),
              ElementsAre("5:1 TE022", "6:1 TE023"));
  EXPECT_THAT(ErrorsOf("DATA\nLOD X\nX DS 1\nDATA_END\nY: DS 1\nLOD Y\nSTOP\n"),
              ElementsAre("2:1 TE026", "5:4 TE027", "6:1 TE001"));
  EXPECT_THAT(CodeErrors("MECH_BEGIN M\nMECH_BEGIN N\nMECH_END N\nMECH_END M\nMECH_END O\n"),
              ElementsAre("2:1 TE059", "5:1 TE061"));
  EXPECT_THAT(CodeErrors("MECH_BEGIN M\nEX\nMECH_END N\nMECH_BEGIN M\nMECH_END M\nMECH_BEGIN O\n"),
              ElementsAre("3:1 TE061", "4:12 TE012", "7:1 TE076"));
  EXPECT_THAT(
      ErrorsOf("DATA\nDATA_END\nMODULE_FAST\nMECH_BEGIN M\nMECH_END M\nMODULE_FAST_END\nSTOP\nLOD\n; end\nRET\n"),
      ElementsAre("4:1 TE062"));
}

/// The word is in error where it was to be a name, and nowhere else (10.5).
TEST(TechnolParserErrors, AReservedWordIsOneError) {
  EXPECT_THAT(ErrorsOf(InProgram("NE: DB 5\nS: DFM CH\n", "LOD NE\nSTO NE\nFL 1,CH\nLDR CH\n")),
              ElementsAre("2:1 TE005", "3:8 TE005"));
}

TEST(TechnolParserErrors, SeveralFiles) {
  const std::string first = "DATA\nX: DS 1\nDATA_END\nMODULE_INIT\nLOD Y\nSTO X\nMODULE_INIT_END\n";
  Parsed parsed;
  ParseInto(parsed, {first, InProgram("Y: DS 1\n", "LOD X\nSTO Y\n")});
  EXPECT_THAT(parsed.Errors(), IsEmpty());
  EXPECT_EQ(parsed.Find("Y")->offset, 1u);
  Parsed wrong;
  ParseInto(wrong, {first + "STOP\n", InProgram("Y: DS 1\n", "LOD X\n")});
  EXPECT_THAT(wrong.Errors(), ElementsAre("8:1 TE028"));
}

TEST(TechnolParserErrors, Operands) {
  EXPECT_THAT(CodeErrors("LDR X\nLDR A,B\nLDR\nWR -Q\nFL 2,Q\nFL Q\nLOD A\nLOD 5\nLOD P\nLOD NIC\nLOD LABEL_MEM+4\n"
                         "LOD BYTE.LABEL_MEM[1000]\nSTO CNST.5\nSTO A\nMULB W\nDIVW CNST.65536\n"),
              ElementsAre("1:5 TE044", "2:1 TE045", "3:1 TE045", "4:1 TE043", "5:4 TE046", "6:1 TE045", "7:5 TE044",
                          "8:5 TE055", "9:5 TE041", "10:5 TE010", "11:5 TE041", "12:5 TE042", "13:1 TE054",
                          "14:1 TE054", "15:1 TE053", "16:1 TE053"));
  EXPECT_THAT(
      CodeErrors("MOV AX,SP\nMOV AL,[BX]\nMOV AX,ES:W\nMOV W,X\nMOV AX,X\nMOV P,5\nMOV AL,256\nINT 21h\nLEA BX,W\n"
                 "MOV AX,OFFSET W\nLOD BYTE.LABEL_MEM[BX][SI]\nMOV DS,CX\n"),
      ElementsAre("1:8 TE060", "2:8 TE064", "3:8 TE065", "4:1 TE066", "5:1 TE067", "6:1 TE068", "7:1 TE069",
                  "8:1 TE070", "9:1 TE065", "10:8 TE065", "11:24 TE077", "12:5 TE060"));
  EXPECT_THAT(CodeErrors("ESET 100\nESET 5,100\nMECH_INIT NIC\nTIM X,5\nTIM -,65536\nLDX A\nRET\n"),
              ElementsAre("1:6 TE063", "2:8 TE063", "3:11 TE075", "4:5 TE074", "5:7 TE073", "6:1 TE011", "7:1 TE052"));
}

TEST(TechnolParserErrors, Jumps) {
  EXPECT_THAT(CodeErrors("JUM L1\nMECH_BEGIN M\nL1: EX\nJUM L2\nMECH_END M\nL2: CALL L2\nCALL X\nJUM NIC\n"),
              ElementsAre("1:5 TE047", "4:5 TE047", "6:10 TE048", "7:6 TE048", "8:5 TE010"));
}

TEST(TechnolParserErrors, OneForEachCause) {
  EXPECT_THAT(CodeErrors("LOD NIC\nSTO NIC\nLOD NIC\n"), ElementsAre("1:5 TE010")) << "a name is undefined once";
  EXPECT_THAT(ErrorsOf(InProgram("X: DS 0\nX: DS 1\n", "LOD X\n")), ElementsAre("2:7 TE030", "3:1 TE012"));
  Parsed parsed;
  ParseInto(parsed, {InProgram("X: DS 1\n", "LOD CNST.FFFFh\nSTO X\n")});
  EXPECT_THAT(parsed.diagnostics.all()[0].remedy, HasSubstr("leading 0"));
}

/// What a faulty line may define is no fault where it is used.
TEST(TechnolParserErrors, AFaultyDefinitionIsOneError) {
  const auto errors = [](const std::string& data, const std::string& code) { return ErrorsOf(InProgram(data, code)); };
  EXPECT_THAT(errors("EQUI CAS 50\nX: DS 1\n", "LOD CNST.CAS\nSTO X\n"), ElementsAre("2:10 TE001"));
  EXPECT_THAT(errors("CAS EQUI 50\nX: DS 1\n", "LOD CNST.CAS\nSTO X\n"), ElementsAre("2:1 TE011"));
  EXPECT_THAT(errors("EQU CAS,50\nX: DS 1\n", "LOD CNST.CAS\nSTO X\n"), ElementsAre("2:1 TE001"));
  EXPECT_THAT(errors("CAS: EQU 50\nX: DS 1\n", "LOD CNST.CAS\nSTO X\n"), ElementsAre("2:6 TE001"));
  EXPECT_THAT(errors("IN0 DFM A,B\n", "LDR A\nLA B\nWR A\n"), ElementsAre("2:1 TE001"));
  EXPECT_THAT(errors("IN0: DFM A B,C\n", "LDR A\nLA B\nWR C\n"), ElementsAre("2:12 TE001"));
  EXPECT_THAT(errors("IN0: DFB A,B\n", "LDR A\nLA B\nWR A\n"), ElementsAre("2:6 TE011"));
  EXPECT_THAT(errors("X: WORD 2\n", "LOD X\nSTO X\n"), ElementsAre("2:4 TE001"));
  EXPECT_THAT(errors("X DQ ?\n", "LOD X\nSTO X\n"), ElementsAre("2:3 TE011"));
  EXPECT_THAT(CodeErrors("LDR A\nJL1 L\nWR Q\nL LDR A\nWR Q\n"), ElementsAre("4:1 TE011"));
  EXPECT_THAT(CodeErrors("LDR A\nJL1 L\nWR Q\nL\nLDR A\nWR Q\n"), ElementsAre("4:1 TE011"));
  EXPECT_THAT(CodeErrors("LDR A\nJL1 LL\nWR Q\nL\nLDR A\nWR Q\n"), ElementsAre("2:5 TE010", "4:1 TE011"));
}

/// A misspelt word of the structure begins or ends what it means.
TEST(TechnolParserErrors, AMisspeltWordOfTheStructureIsOneError) {
  const std::string cells = "DATA\nX: DS 1\n", rest = "MODULE_MAIN\nLOD X\nSTO X\nMODULE_MAIN_END\nSTOP\n";
  for (const char* end : {"DATAEND", "END_DATA", "DATA_EN"}) {
    EXPECT_THAT(ErrorsOf(cells + end + "\n" + rest), ElementsAre("3:1 TE011")) << end;
  }
  const std::string body = "LOD X\nSTO X\nCALL P\n", sub = "P: LOD X\nRET\nSTOP\n";
  const auto around = [&](const std::string& begin, const std::string& end) {
    return ErrorsOf(cells + "DATA_END\n" + begin + "\n" + body + end + "\n" + sub);
  };
  EXPECT_THAT(around("MODUL_MAIN", "MODULE_MAIN_END"), ElementsAre("4:1 TE011"));
  EXPECT_THAT(around("MODULE_MAIN", "MODUL_MAIN_END"), ElementsAre("8:1 TE011"));
  EXPECT_THAT(around("MODULE_MAIN", "END_MODULE_MAIN"), ElementsAre("8:1 TE011"));
  EXPECT_THAT(around("MODULE_MAIN", "END"), ElementsAre("8:1 TE011"));
  EXPECT_THAT(ErrorsOf(cells + "DATA_END\nMODULE_MAIN\n" + "LOD X\nSTO X\nMODULE_MAIN_END\nEND\n"),
              ElementsAre("8:1 TE011"));
}

TEST(TechnolParserErrors, AMechanismWithoutItsNameIsOneError) {
  EXPECT_THAT(CodeErrors("FL 1,M\nMECH_BEGIN\nLDR A\nEX0\nTIM -,5\nMECH_END M\nMECH_INIT M\n"),
              ElementsAre("2:1 TE001"));
  EXPECT_THAT(CodeErrors("FL 1,M\nMECH_BEGIN N\nLDR A\nEX0\nMECH_END M\nMECH_INIT M\n"), ElementsAre("5:1 TE061"));
  EXPECT_THAT(CodeErrors("FL 1,M\nMECH_BEGIN M\nTIM 10\nMECH_END M\n"), ElementsAre("3:1 TE001"));
  EXPECT_THAT(CodeErrors("FL 1,M\nMECH_BEGIN M\nLDR A\nTEX0 5,L\nL: MECH_END M\n"), ElementsAre("4:1 TE001"));
}

TEST(TechnolParserErrors, RemediesNameWhatIsMeant) {
  const auto text = [](const std::string& code) {
    Parsed parsed;
    ParseInto(parsed, {InProgram(kCells, code)});
    return parsed.diagnostics.all().empty() ? "" : parsed.diagnostics.all().front().remedy;
  };
  EXPECT_THAT(text("LDR A\nWR Q\nEQ CNST,10\n"), HasSubstr("CNST.10"));
  EXPECT_THAT(text("LOD BYTE,X\nSTO X\n"), HasSubstr("BYTE.X"));
  EXPECT_THAT(text("ESET 10.2\n"), HasSubstr("comma"));
  EXPECT_THAT(text("LDR A\nJL1 L:\nL: WR Q\n"), HasSubstr("colon"));
  EXPECT_THAT(CodeErrors("LOD BYT.X\nSTO X\n"), ElementsAre("1:5 TE010"));
}

TEST(TechnolParserWarnings, OfTexts) {
  Settings strict;
  strict.evidence = EvidenceRule::kStrict;
  EXPECT_THAT(WarningsOf(InProgram(kCells, "LDR A\nLX B\nWR Q\nFL0 1,C\nLOD X\nSTO W\nLOD D\n"), strict),
              ElementsAre("6:1 TW004", "10:1 TW030", "12:1 TW030"));
  EXPECT_THAT(WarningsOf(InProgram("X: DS 1\n", "LOD X\nL: STO X\nFL 0,REQ_CLOSE_ALL\n") + "LOD\n"),
              ElementsAre("6:1 TW004", "7:1 TW013", "10:1 TW003"));
  EXPECT_THAT(WarningsOf(InProgram("X: DB?\nY: DS 1\n", "LOD WORD.X\nSTO Y\n")), ElementsAre("2:4 TW002", "6:5 TW021"));
}

}  // namespace
}  // namespace plcxx::technol
