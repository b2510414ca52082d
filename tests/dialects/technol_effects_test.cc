// What each instruction reads, writes and leaves undefined (specification 6.9 and 6.0 to 6.8), as the checks of paths
// see it: one row an instruction, and programs in which one register is loaded in part, or no flag has a value.

#include <bitset>

#include "tests/dialects/technol_lowered.h"

namespace plcxx::technol {
namespace {

// Parts of a register: the low byte, the high byte, the upper word.
constexpr unsigned kL = 1, kH = 2, kU = 4, kLH = kL | kH, kAll = kL | kH | kU;

struct EffectRow {
  const char* code;
  std::map<char, unsigned> reads, writes;  // by register: a, b, d (DX), s (SI), i (DI), c (DR, which is ECX)
  const char* flags = "-----";             // CF ZF SF OF AF: written, undefined, - as before
  const char* flags_read = "";
  bool reads_rlo = false, writes_rlo = false;
};

const std::vector<EffectRow> kEffects = {
    {"MOV AL,BL", {{'b', kL}}, {{'a', kL}}},
    {"MOV AH,BH", {{'b', kH}}, {{'a', kH}}},
    {"MOV AX,BX", {{'b', kLH}}, {{'a', kLH}}},
    {"MOV EAX,EBX", {{'b', kAll}}, {{'a', kAll}}},
    {"MOV ESI,EDI", {{'i', kAll}}, {{'s', kAll}}},
    {"MOV DI,SI", {{'s', kLH}}, {{'i', kLH}}},
    {"MOV EDX,7", {}, {{'d', kAll}}},
    {"MOV W,CX", {{'c', kLH}}, {}},
    {"MOV CL,X", {}, {{'c', kL}}},
    {"MOV AL,BYTE.V[BX]", {{'b', kLH}}, {{'a', kL}}},
    {"MOV BYTE.V[ESI],DL", {{'s', kAll}, {'d', kL}}, {}},
    {"XCHG AX,BX", {{'a', kLH}, {'b', kLH}}, {{'a', kLH}, {'b', kLH}}},
    {"XCHG AL,AH", {{'a', kLH}}, {{'a', kLH}}},
    {"XCHG X,DH", {{'d', kH}}, {{'d', kH}}},
    {"XCHG W,BX", {{'b', kLH}}, {{'b', kLH}}},
    {"MOVZX EAX,BL", {{'b', kL}}, {{'a', kAll}}},
    {"MOVSX AX,BH", {{'b', kH}}, {{'a', kLH}}},
    {"MOVZX EDX,W", {}, {{'d', kAll}}},
    {"ADD AX,BX", {{'a', kLH}, {'b', kLH}}, {{'a', kLH}}, "wwwww"},
    {"ADC AL,1", {{'a', kL}}, {{'a', kL}}, "wwwww", "C"},
    {"SUB W,AX", {{'a', kLH}}, {}, "wwwww"},
    {"SUB AX,AX", {}, {{'a', kLH}}, "wwwww"},
    {"SBB EAX,EBX", {{'a', kAll}, {'b', kAll}}, {{'a', kAll}}, "wwwww", "C"},
    {"CMP AX,BX", {{'a', kLH}, {'b', kLH}}, {}, "wwwww"},
    {"INC DX", {{'d', kLH}}, {{'d', kLH}}, "-wwww"},
    {"DEC BYTE.V[DI]", {{'i', kLH}}, {}, "-wwww"},
    {"NEG BL", {{'b', kL}}, {{'b', kL}}, "wwwww"},
    {"NOT EBX", {{'b', kAll}}, {{'b', kAll}}},
    {"AND AX,BX", {{'a', kLH}, {'b', kLH}}, {{'a', kLH}}, "wwwwu"},
    {"OR AL,BL", {{'a', kL}, {'b', kL}}, {{'a', kL}}, "wwwwu"},
    {"XOR SI,BX", {{'s', kLH}, {'b', kLH}}, {{'s', kLH}}, "wwwwu"},
    {"XOR EDI,EDI", {}, {{'i', kAll}}, "wwwwu"},
    {"TEST AX,BX", {{'a', kLH}, {'b', kLH}}, {}, "wwwwu"},
    {"SHL AX,1", {{'a', kLH}}, {{'a', kLH}}, "wwwwu"},
    {"SHR AL,2", {{'a', kL}}, {{'a', kL}}, "wwwuu"},
    {"SAR EBX,33", {{'b', kAll}}, {{'b', kAll}}, "wwwwu"},
    {"SAR EBX,31", {{'b', kAll}}, {{'b', kAll}}, "wwwuu"},
    {"SHL AX,0", {}, {}},
    {"SHL AX,32", {}, {}},
    {"SHL AX,CL", {{'a', kLH}, {'c', kL}}, {{'a', kLH}}, "wwwuu"},
    {"ROL AX,1", {{'a', kLH}}, {{'a', kLH}}, "w--w-"},
    {"ROR AX,16", {{'a', kLH}}, {{'a', kLH}}, "w--u-"},
    {"ROR DL,CL", {{'d', kL}, {'c', kL}}, {{'d', kL}}, "w--u-"},
    {"ROL AX,0", {}, {}},
    {"RCL AX,1", {{'a', kLH}}, {{'a', kLH}}, "w--w-", "C"},
    {"RCR AX,3", {{'a', kLH}}, {{'a', kLH}}, "w--u-", "C"},
    {"RCR AX,CL", {{'a', kLH}, {'c', kL}}, {{'a', kLH}}, "w--u-", "C"},
    {"RCL AX,0", {}, {}},
    {"MUL BL", {{'a', kL}, {'b', kL}}, {{'a', kLH}}, "wuuwu"},
    {"MUL BX", {{'a', kLH}, {'b', kLH}}, {{'a', kLH}, {'d', kLH}}, "wuuwu"},
    {"IMUL EBX", {{'a', kAll}, {'b', kAll}}, {{'a', kAll}, {'d', kAll}}, "wuuwu"},
    {"IMUL W", {{'a', kLH}}, {{'a', kLH}, {'d', kLH}}, "wuuwu"},
    {"DIV BL", {{'a', kLH}, {'b', kL}}, {{'a', kLH}}, "uuuuu"},
    {"IDIV BX", {{'a', kLH}, {'b', kLH}, {'d', kLH}}, {{'a', kLH}, {'d', kLH}}, "uuuuu"},
    {"DIV EBX", {{'a', kAll}, {'b', kAll}, {'d', kAll}}, {{'a', kAll}, {'d', kAll}}, "uuuuu"},
    {"CBW", {{'a', kL}}, {{'a', kLH}}},
    {"CWD", {{'a', kLH}}, {{'d', kLH}}},
    {"CWDE", {{'a', kLH}}, {{'a', kAll}}},
    {"CDQ", {{'a', kAll}}, {{'d', kAll}}},
    {"DAA", {{'a', kL}}, {{'a', kL}}, "wwwuw", "CA"},
    {"DAS", {{'a', kL}}, {{'a', kL}}, "wwwuw", "CA"},
    {"AAM", {{'a', kL}}, {{'a', kLH}}, "uwwuu"},
    {"AAD", {{'a', kLH}}, {{'a', kLH}}, "uwwuu"},
    {"CLC", {}, {}, "w----"},
    {"STC", {}, {}, "w----"},
    {"CMC", {}, {}, "w----", "C"},
    {"NOP", {}, {}},
    {"JMP L", {}, {}},
    {"JE L", {}, {}, "-----", "Z"},
    {"JNC L", {}, {}, "-----", "C"},
    {"JA L", {}, {}, "-----", "CZ"},
    {"JLE L", {}, {}, "-----", "ZSO"},
    {"JGE L", {}, {}, "-----", "SO"},
    {"JS L", {}, {}, "-----", "S"},
    {"JNO L", {}, {}, "-----", "O"},
    {"LOOP L", {{'c', kLH}}, {{'c', kLH}}},
    {"JCXZ L", {{'c', kLH}}, {}},
    {"LDR A", {}, {}, "uuuuu", "", false, true},
    {"LA -A", {}, {}, "uuuuu", "", true, true},
    {"LO A", {}, {}, "uuuuu", "", true, true},
    {"LX A", {}, {}, "uuuuu", "", true, true},
    {"WR A", {}, {}, "uuuuu", "", true},
    {"FL 1,A", {}, {}, "uuuuu"},
    {"FL1 1,A", {}, {}, "uuuuu", "", true},
    {"FL0 1,A", {}, {}, "uuuuu", "", true},
    {"JUM L", {}, {}, "uuuuu"},
    {"JL1 L", {}, {}, "uuuuu", "", true},
    {"JL0 L", {}, {}, "uuuuu", "", true},
    {"LOD W", {}, {{'c', kAll}}, "uuuuu"},
    {"LOD BYTE.V[BX]", {{'b', kLH}}, {{'c', kAll}}, "uuuuu"},
    {"STO X", {{'c', kL}}, {}, "uuuuu"},
    {"STO W", {{'c', kLH}}, {}, "uuuuu"},
    {"STO BYTE.V[SI]", {{'c', kL}, {'s', kLH}}, {}, "uuuuu"},
    {"AD W", {{'c', kLH}}, {{'c', kAll}}, "uuuuu"},
    {"SU CNST.1", {{'c', kLH}}, {{'c', kAll}}, "uuuuu"},
    {"AND W", {{'c', kLH}}, {{'c', kAll}}, "uuuuu"},
    {"OR W", {{'c', kLH}}, {{'c', kAll}}, "uuuuu"},
    {"XOR BYTE.V[DI]", {{'c', kLH}, {'i', kLH}}, {{'c', kAll}}, "uuuuu"},
    {"MULB X", {{'c', kL}}, {{'c', kAll}}, "uuuuu"},
    {"MULW W", {{'c', kLH}}, {{'c', kAll}}, "uuuuu"},
    {"DIVB X", {{'c', kLH}}, {{'c', kAll}, {'d', kLH}}, "uuuuu"},
    {"DIVW W", {{'c', kLH}}, {{'c', kAll}, {'d', kLH}}, "uuuuu"},
    {"RL CNST.1", {{'c', kLH}}, {{'c', kAll}}, "uuuuu"},
    {"RR BYTE.X", {{'c', kLH}}, {{'c', kAll}}, "uuuuu"},
    {"BCD", {{'c', kLH}}, {{'c', kAll}}, "uuuuu"},
    {"BIN", {{'c', kLH}}, {{'c', kAll}}, "uuuuu"},
    {"EQ W", {{'c', kLH}}, {}, "uuuuu", "", false, true},
    {"GT BYTE.V[BX]", {{'c', kLH}, {'b', kLH}}, {}, "uuuuu", "", false, true},
    {"ESET 1", {}, {}, "uuuuu"},
};

constexpr std::string_view kWholeRegisterLetters = "abdsic", kFlagLetters = "CZSOA";

std::string PartName(char reg, unsigned part) {
  if (reg == 's') return part == kAll ? "ESI" : "SI";
  if (reg == 'i') return part == kAll ? "EDI" : "DI";
  const std::string letter(1, static_cast<char>(reg - 'a' + 'A'));
  return part == kL ? letter + "L" : part == kH ? letter + "H" : part == kLH ? letter + "X" : "E" + letter + "X";
}

unsigned PartsIn(const std::map<char, unsigned>& parts, char reg) {
  const auto found = parts.find(reg);
  return found == parts.end() ? 0 : found->second;
}

struct PartlyLoaded {
  std::string text = "DATA\nBITS: DFM A,B\nX: DB ?\nW: DW ?\nD: DD ?\nV: DS 100\nDATA_END\nMODULE_MAIN\n";
  uint32_t lines = 8;
  uint32_t Add(const std::string& line) {
    text += line + "\n";
    return ++lines;
  }
  /// All registers but one, of which so much is loaded.
  void Load(char except, unsigned part) {
    for (const char reg : kWholeRegisterLetters) {
      const unsigned parts = reg == except ? part : kAll;
      if (parts != 0) Add("MOV " + PartName(reg, parts) + ",0");
    }
  }
  /// The lines that read what nobody loaded or no instruction defined.
  std::map<uint32_t, std::string> Reported() {
    Add("MODULE_MAIN_END");
    Add("STOP");
    LoweredProgram lowered;
    LowerInto(lowered, text);
    std::map<uint32_t, std::string> found;
    for (const diag::Diagnostic& diagnostic : lowered.diagnostics.all()) {
      for (const std::string_view code : {"technol-TE057", "technol-TE072", "technol-TW023"}) {
        if (diagnostic.row->code == code) {
          found[lowered.sources.Locate(diagnostic.range.begin).line] = diagnostic.text;
        }
      }
      if (diagnostic.severity == diag::Severity::kError && found.empty()) ADD_FAILURE() << text << diagnostic.text;
    }
    return found;
  }
};

// covers: TECHNOL-139, TECHNOL-142, TECHNOL-140
class TechnolEffectsOf : public testing::TestWithParam<char> {};

TEST_P(TechnolEffectsOf, ARegisterThatIsLoadedInPart) {
  const char reg = GetParam();
  for (const EffectRow& row : kEffects) {
    for (const unsigned loaded : {0U, kL, kH, kLH}) {
      if ((reg == 's' || reg == 'i') && loaded != 0 && loaded != kLH) continue;
      // A part of DR that is set counts as DR.
      const unsigned missing = reg == 'c' && loaded != 0 ? 0 : kAll & ~loaded;
      PartlyLoaded program;
      program.Load(reg, loaded);
      program.Add("LDR A");
      program.Add("CMP W,0");  // every flag
      const uint32_t at = program.Add(row.code);
      const uint32_t behind = program.Add("L: MOV D," + PartName(reg, kAll));
      const std::map<uint32_t, std::string> found = program.Reported();
      const unsigned unread = PartsIn(row.reads, reg) & missing;
      EXPECT_EQ(found.contains(at), unread != 0) << row.code << ", " << reg << " loaded: " << loaded;
      if (unread != 0 && found.contains(at)) {
        const std::string name = reg == 'c' ? "DR" : PartName(reg, (unread & kU) != 0 ? kAll : unread);
        EXPECT_THAT(found.at(at), testing::HasSubstr("reads " + name + " before")) << row.code;
      }
      const unsigned written = PartsIn(row.writes, reg);
      const bool is_missing = (missing & ~(reg == 'c' && written != 0 ? kAll : written)) != 0;
      EXPECT_EQ(found.contains(behind), is_missing) << row.code << ", " << reg << " loaded: " << loaded;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Registers, TechnolEffectsOf, testing::ValuesIn(kWholeRegisterLetters));

// covers: TECHNOL-143, TECHNOL-144, TECHNOL-147, TECHNOL-148
TEST(TechnolEffects, Flags) {
  for (const EffectRow& row : kEffects) {
    for (const bool defined : {false, true}) {
      PartlyLoaded program;
      program.Load(' ', 0);
      program.Add("LDR A");
      if (defined) program.Add("CMP W,0");
      const uint32_t at = program.Add(row.code);
      program.Add("L: NOP");
      std::map<char, uint32_t> readers;
      for (const char flag : std::string_view("CZSO")) {
        const std::string jump = flag == 'C' ? "JC" : flag == 'Z' ? "JE" : flag == 'S' ? "JS" : "JO";
        readers[flag] = program.Add(jump + " " + jump + "L");
        program.Add(jump + "L: NOP");
      }
      readers['A'] = program.Add("DAA");
      const std::map<uint32_t, std::string> found = program.Reported();
      const std::string_view reads = row.flags_read;
      EXPECT_EQ(found.contains(at), !defined && !reads.empty()) << row.code;
      if (!defined && !reads.empty() && found.contains(at)) {
        EXPECT_THAT(found.at(at), testing::HasSubstr(std::string("flag ") + reads[0] + "F is")) << row.code;
      }
      const auto is_defined = [&](char flag) {
        const char change = row.flags[kFlagLetters.find(flag)];
        return change == 'w' || (change == '-' && defined);
      };
      for (const char flag : std::string_view("CZSO")) {
        EXPECT_EQ(found.contains(readers[flag]), !is_defined(flag)) << row.code << ": " << flag << "F, " << defined;
      }
      // DAA reads CF, too.
      EXPECT_EQ(found.contains(readers['A']), !is_defined('A') || !is_defined('C')) << row.code << ": AF, " << defined;
    }
  }
}

// covers: TECHNOL-111
TEST(TechnolEffects, TheResultOfLogic) {
  for (const EffectRow& row : kEffects) {
    for (const bool loaded : {false, true}) {
      PartlyLoaded program;
      program.Load(' ', 0);
      if (loaded) program.Add("LDR A");
      program.Add("CMP W,0");
      const uint32_t at = program.Add(row.code);
      const uint32_t behind = program.Add("L: WR B");
      const std::map<uint32_t, std::string> found = program.Reported();
      EXPECT_EQ(found.contains(at), row.reads_rlo && !loaded) << row.code;
      EXPECT_EQ(found.contains(behind), !row.writes_rlo && !loaded) << row.code;
    }
  }
}

}  // namespace
}  // namespace plcxx::technol
