#include "transpiler/dialects/technol/machine/machine.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "transpiler/support/check.h"
#include "transpiler/support/near_words.h"

namespace plcxx::technol {
namespace {

struct AreaRow {
  std::string_view name;
  uint32_t bytes;
};
constexpr AreaRow kAreas[] = {
#define TECHNOL_AREA(Key, Text, Bytes) {Text, Bytes},
#include "transpiler/dialects/technol/machine/machine.def"
    {"DATA", 0},
};

constexpr RegisterInfo kRegisters[] = {
#define TECHNOL_REGISTER(Key, Text, Width, Whole, Shift) {Register::k##Key, Text, Width, Register::k##Whole, Shift},
#include "transpiler/dialects/technol/machine/machine.def"
};

constexpr ModuleInfo kModules[] = {
#define TECHNOL_MODULE(Key, Text, Standard, Waits, Mechanisms, EvidenceKey) \
  {ModuleKind::k##Key, Text, Standard, Waits, Mechanisms, Evidence::k##EvidenceKey == Evidence::kCompletion},
#include "transpiler/dialects/technol/machine/machine.def"
    {.kind = ModuleKind::kOther, .keyword = "MODULE_", .completion = true},
};

constexpr InstructionInfo Own(Op op, std::string_view text, Form form, Access access, Evidence evidence,
                              Purity purity) {
  return {.op = op, .mnemonic = text, .form = form, .first = access, .evidence = evidence, .purity = purity};
}
constexpr InstructionInfo Assembler(Op op, std::string_view text, Form form, Access access, Purity purity) {
  return {.op = op, .mnemonic = text, .form = form, .first = access, .purity = purity, .assembler = true};
}

constexpr InstructionInfo kInstructions[] = {
#define TECHNOL_INSTRUCTION(Key, Text, FormKey, AccessKey, EvidenceKey, PurityKey, ...) \
  Own(Op::k##Key, Text, Form::k##FormKey, Access::k##AccessKey, Evidence::k##EvidenceKey, Purity::k##PurityKey),
#define TECHNOL_ASSEMBLER(Key, Text, FormKey, AccessKey, PurityKey, ...) \
  Assembler(Op::k##Key, Text, Form::k##FormKey, Access::k##AccessKey, Purity::k##PurityKey),
#include "transpiler/dialects/technol/machine/machine.def"
    {.op = Op::kMechanismBegin, .mnemonic = "MECH_BEGIN"},
    {.op = Op::kMechanismEnd, .mnemonic = "MECH_END"},
    {.op = Op::kModuleEnd},
    {.op = Op::kAreaEnd},
    {},
};

using OpName = std::pair<std::string_view, Op>;
constexpr OpName kSynonyms[] = {
#define TECHNOL_SYNONYM(Text, Key) {Text, Op::k##Key},
#include "transpiler/dialects/technol/machine/machine.def"
};
constexpr std::string_view kForeignInstructions[] = {
#define TECHNOL_FOREIGN(Text) Text,
#include "transpiler/dialects/technol/machine/machine.def"
};
constexpr std::string_view kForeignRegisters[] = {
#define TECHNOL_FOREIGN_REGISTER(Text) Text,
#include "transpiler/dialects/technol/machine/machine.def"
};
constexpr std::string_view kReserved[] = {
#define TECHNOL_RESERVED(Text) Text,
#include "transpiler/dialects/technol/machine/machine.def"
};

/// By name; of two meanings of one mnemonic TECHNOL's own, which has the smaller Op.
const std::vector<OpName>& OpsByName() {
  static const std::vector<OpName> sorted = [] {
    std::vector<OpName> ops(std::begin(kSynonyms), std::end(kSynonyms));
    for (const InstructionInfo& info : kInstructions) {
      if (info.op < Op::kMechanismBegin) ops.emplace_back(info.mnemonic, info.op);
    }
    std::ranges::sort(ops);
    return ops;
  }();
  return sorted;
}

std::vector<std::string_view> Sorted(std::span<const std::string_view> words) {
  std::vector<std::string_view> sorted(words.begin(), words.end());
  std::ranges::sort(sorted);
  return sorted;
}

/// MODULE_MAIN_END ...
std::vector<std::string> EndsOfModules() {
  std::vector<std::string> ends;
  for (const ModuleInfo& info : Modules()) {
    if (info.kind != ModuleKind::kOther) ends.push_back(std::string(info.keyword) + "_END");
  }
  return ends;
}

}  // namespace

std::string_view Name(Area area) { return area == Area::kNone ? "" : kAreas[static_cast<size_t>(area)].name; }
uint32_t BytesOf(Area area) { return area == Area::kNone ? 0 : kAreas[static_cast<size_t>(area)].bytes; }

std::optional<Area> AreaByName(std::string_view name) {
  const auto end = std::end(kAreas) - 1;  // the segment of the program's cells has no name in a source
  const auto row = std::find_if(std::begin(kAreas), end, [&](const AreaRow& area) { return area.name == name; });
  if (row == end) return std::nullopt;
  return static_cast<Area>(row - std::begin(kAreas));
}

const RegisterInfo& Info(Register reg) {
  PLCXX_CHECK(reg != Register::kNone);
  return kRegisters[static_cast<size_t>(reg)];
}

Register RegisterByName(std::string_view word) {
  const auto row = std::ranges::find(kRegisters, word, &RegisterInfo::name);
  return row == std::end(kRegisters) ? Register::kNone : row->key;
}

bool IsForeignRegister(std::string_view word) {
  return std::ranges::find(kForeignRegisters, word) != std::end(kForeignRegisters);
}

std::span<const ModuleInfo> Modules() { return kModules; }
const ModuleInfo& Info(ModuleKind kind) { return kModules[static_cast<size_t>(kind)]; }

std::span<const InstructionInfo> Instructions() { return kInstructions; }
const InstructionInfo& Info(Op op) { return kInstructions[static_cast<size_t>(op)]; }

Op OpByMnemonic(std::string_view word) {
  const auto found = std::ranges::lower_bound(OpsByName(), word, {}, &OpName::first);
  return found == OpsByName().end() || found->first != word ? Op::kUnknown : found->second;
}

std::string_view NearMnemonic(std::string_view word) {
  static const std::vector<std::string_view> mnemonics = [] {
    std::vector<std::string_view> words;
    for (const auto& [name, op] : OpsByName()) words.push_back(name);
    for (const std::string_view other :
         {"DATA", "DATA_END", "STOP", "MECH_BEGIN", "MECH_END", "DFM", "EQUI", "T_INCLUDE"}) {
      words.push_back(other);
    }
    static const std::vector<std::string> ends = EndsOfModules();
    for (const ModuleInfo& info : Modules()) {
      if (info.kind != ModuleKind::kOther) words.push_back(info.keyword);
    }
    words.insert(words.end(), ends.begin(), ends.end());
    return words;
  }();
  constexpr std::string_view kEnd = "END_";
  if (word.starts_with(kEnd)) {
    const std::string turned = std::string(word.substr(kEnd.size())) + "_END";
    const auto same = std::ranges::find(mnemonics, turned);
    if (same != mnemonics.end()) return *same;
  }
  return support::NearestWord(word, mnemonics);
}

Op AssemblerForm(Op op) {
  if (op == Op::kAnd) return Op::kAsmAnd;
  if (op == Op::kOr) return Op::kAsmOr;
  if (op == Op::kXor) return Op::kAsmXor;
  return op;
}

bool IsForeignInstruction(std::string_view word) {
  static const std::vector<std::string_view> words = Sorted(kForeignInstructions);
  return std::ranges::binary_search(words, word);
}

std::string_view ForeignHint(std::string_view word) {
  struct ForeignWord {
    std::string_view word, hint;
  };
  constexpr std::string_view kLoadBit = "a bit is loaded by LDR, data by LOD", kWriteBit = "a bit is written by WR";
  constexpr std::string_view kAnd = "bits are combined by LA", kOr = "bits are combined by LO";
  constexpr std::string_view kAndNot = "bits are combined by LA, negated by '-': LA -NAME",
                             kOrNot = "bits are combined by LO, negated by '-': LO -NAME";
  constexpr std::string_view kSet = "a bit is set by FL 1,NAME", kReset = "a bit is reset by FL 0,NAME";
  constexpr std::string_view kJump = "the jump is JUM, with a condition JL0 or JL1",
                             kTimer = "waiting for a time is TIM, in a mechanism";
  constexpr ForeignWord kWords[] = {
      {"LD", kLoadBit},
      {"LDN", "a negated bit is loaded by LDR -NAME"},
      {"LDI", "a negated bit is loaded by LDR -NAME"},
      {"L", kLoadBit},
      {"ST", "a bit is written by WR, data by STO"},
      {"STN", "a bit is written by WR; negate where it is read"},
      {"OUT", kWriteBit},
      {"T", "data is stored by STO"},
      {"S", kSet},
      {"SET", kSet},
      {"R", kReset},
      {"RST", kReset},
      {"RES", kReset},
      {"RESET", kReset},
      {"CLR", kReset},
      {"A", kAnd},
      {"U", kAnd},
      {"AN", kAndNot},
      {"UN", kAndNot},
      {"ANDN", kAndNot},
      {"ANI", kAndNot},
      {"LAN", kAndNot},
      {"LON", kOrNot},
      {"LDRN", "a negated bit is loaded by LDR -NAME"},
      {"FL2", "flags are written by FL always, by FL1 and FL0 where the result is 1 or 0"},
      {"TEX", "waiting with a limit is TEX0 until the result is 1, TEX1 until it is 0"},
      {"EX2", "waiting is EX for a pass, EX0 until the result is 1, EX1 until it is 0"},
      {"O", kOr},
      {"ON", kOrNot},
      {"ORN", kOrNot},
      {"ORI", kOrNot},
      {"JUMP", kJump},
      {"JU", kJump},
      {"GOTO", kJump},
      {"SPA", kJump},
      {"BRA", kJump},
      {"JC", "the jump with a condition is JL1, when the result is 1, or JL0"},
      {"SPB", "the jump with a condition is JL1, when the result is 1, or JL0"},
      {"JMPC", "the jump with a condition is JL1, when the result is 1, or JL0"},
      {"IF", "load the condition with LDR and jump with JL0 or JL1"},
      {"RETURN", "a subprogram ends with RET"},
      {"END", "a module ends with its name and _END, a program with STOP"},
      {"TON", kTimer},
      {"TOF", kTimer},
      {"TP", kTimer},
      {"TIMER", kTimer},
      {"WAIT", "waiting is EX0, EX1, TEX0, TEX1 or TIM, in a mechanism"},
  };
  const auto* const row = std::ranges::find(kWords, word, &ForeignWord::word);
  return row == std::end(kWords) ? std::string_view() : row->hint;
}

bool IsReserved(std::string_view word) {
  static const std::vector<std::string_view> words = Sorted(kReserved);
  if (std::ranges::binary_search(words, word) || OpByMnemonic(word) != Op::kUnknown) return true;
  if (RegisterByName(word) != Register::kNone) return true;
  if (word.ends_with("_END")) word.remove_suffix(4);
  return word.starts_with("MODULE_") || word == Info(ModuleKind::kPripravne).keyword ||
         word == Info(ModuleKind::kZaverecne).keyword;
}

}  // namespace plcxx::technol
