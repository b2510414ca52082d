// Straight-line code for random programs of dialect technol: operands, and instructions that need no labels.
//
// What makes a program valid is what has been loaded where (TE056, TE057, TE072), so the generator follows it: a set of
// what is loaded on every path to here, and of what is loaded since the last place where a wait could resume.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "tests/reference/random_program.h"
#include "tests/reference/technol_random_data.h"
#include "tests/reference/technol_random_flags.h"

namespace plcxx::reference::technol_code {

/// What one program is like.
struct Habits {
  uint32_t most_mechanisms = 3, most_subprograms = 4;
  uint32_t labels_in_hundred = 12, most_calls = 3;
  uint32_t percent_of_own_cells = 10, percent_of_names = 40;  // of the accesses to memory
  // by kind, as TechnolGenerator::Body and Acting have them
  std::array<uint32_t, 7> body = {12, 33, 20, 19, 9, 3, 4};
  std::array<uint32_t, 7> acting = {30, 20, 30, 4, 3, 5, 8};
};

struct Name {
  std::string text;
  Loaded parts = 0;
  uint8_t width = 0;
};

class StraightCode {
 public:
  StraightCode(Random& random, Spelling spelling) : random_(random), is_plain_(spelling == Spelling::kPlain) {}

 protected:
  uint32_t Below(uint32_t n) { return random_.Below(n); }
  bool Chance(uint32_t percent) { return Below(100) < percent; }
  template <size_t N>
  std::string One(const std::array<const char*, N>& texts) {
    return texts[Below(N)];
  }
  static std::string Text(int64_t n) { return std::to_string(n); }

  // --- spelling: both spellings draw alike -------------------------------------------------------------------------

  /// One of several texts that mean the same; the first of them is the plain one.
  std::string Spelled(const std::vector<std::string>& any) {
    const std::string& chosen = random_.Pick(any);
    return is_plain_ ? any.front() : chosen;
  }
  static std::string Digits(uint64_t value, uint32_t base) {
    std::string text;
    do {
      text.insert(text.begin(), "0123456789ABCDEF"[value % base]);
      value /= base;
    } while (value != 0);
    return text;
  }
  /// 2.4
  std::string Literal(uint64_t value) {
    const std::string plain = std::to_string(value);
    const std::string hex = "0" + Digits(value, 16);
    return Spelled({plain, plain, plain, plain + "D", hex + "h", hex + "H", "00" + plain,
                    value < 65536 ? Digits(value, 2) + "b" : plain, Digits(value, 8) + (value % 2 == 0 ? "q" : "O")});
  }
  /// An expression of constants (2.5), where one may stand behind "CNST.".
  std::string Expression(uint64_t value) {
    const std::string text = Literal(value);
    const std::string more = Literal(value + 1), twice = Literal(2 * value + 1);
    std::vector<std::string> forms = {text,
                                      text,
                                      text,
                                      text,
                                      "(" + more + "-1)",
                                      "(" + twice + " SHR 1)",
                                      "(" + text + "*2+2)/2-1",
                                      "(7 MOD 4-3+" + text + ")"};
    if (value == 3) forms.insert(forms.end(), 4, "TRI");
    if (value == 5) forms.insert(forms.end(), {"PET", "(TRI+2)", "pet"});
    if (value == 7) forms.insert(forms.end(), {"(SIZE S0)", "SEDM", "(TRI OR 4)", "(NOT 0 AND 7)"});
    if (value == 65) forms.insert(forms.end(), 3, "'A'");
    if (value > 0x7FFFFFFF) return text;
    return Spelled(forms);
  }
  /// The lines of an instruction or of a macro's call.
  std::string Respelled(const std::string& text) {
    const uint32_t form = random_.Below(20);
    const std::string comment =
        Spelled({"", "", "", "", "", "", "", " ;", " ; LDR I0, konec", "\t;\xC4\x8D\xC3\xA1st"});
    if (is_plain_) return "  " + text;
    std::string line = text;
    const size_t blank = line.find(' ');
    if (form < 3 && line.find('\'') == std::string::npos) {
      for (char& c : line) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    } else if (form == 3 && blank != std::string::npos) {
      line.replace(blank, 1, "\t  ");
    } else if (form == 4) {
      for (size_t at = line.find(','); at != std::string::npos; at = line.find(',', at + 3)) line.replace(at, 1, " , ");
    }
    return (form == 5 ? "" : form == 6 ? "\t" : "  ") + line + comment;
  }

  // --- operands ----------------------------------------------------------------------------------------------------

  std::string Bit(bool written) {
    if (!mechanisms_.empty() && Chance(12) && !(written && inside_ && aborts_)) return random_.Pick(mechanisms_);
    if (Chance(6)) {
      return One(std::array{"REQ_SEND_PLCMEM", "REQ_SEND_NCTAB", "REQ_BACKUP_MEM", "REQ_SEND_TABTECH", "UPS_BATLOW",
                            "REQ_BACKUP_POS", "REQ_CLOSE_ALL", "REQ_PIS_HALT", "NC_PRIPRAVNE", "NC_ZAVERECNE",
                            "NC_CLEAR", "UPS_SHUTDOWN", "UPS_LINEFAIL"});
    }
    if (!cells_.bits.empty() && Chance(25)) return random_.Pick(cells_.bits);
    return Chance(30)   ? One(std::array{"I0", "I1", "I2", "I3", "I7"})
           : Chance(20) ? One(std::array{"O0", "O1", "O3", "O5"})
                        : "A" + Text(Below(8));
  }

  /// A place of so many bits; `reads` is what its index needs.
  std::string Memory(uint32_t width, Loaded& reads) {
    const uint32_t choice = Below(100);
    const std::string prefix = width == 8 ? "BYTE." : width == 16 ? "WORD." : "DWRD.";
    if (Chance(habits_.percent_of_own_cells)) {
      const std::vector<std::string>& own = width == 8 ? cells_.bytes : width == 16 ? cells_.words : cells_.longs;
      if (!own.empty() && Chance(60)) return random_.Pick(own);
      if (!cells_.any.empty()) {
        const std::string& base = random_.Pick(cells_.any);
        const std::string offset = Text(Below(5));
        return prefix + (Chance(40) ? base : Chance(50) ? base + "+" + offset : "(" + base + "+" + offset + ")");
      }
    }
    if (choice < habits_.percent_of_names) {
      if (width == 8)
        return One(std::array{"B0", "B1", "BITS", "IN1", "OUT1", "BZH21", "SYSREQ", "TAB", "ST.P0", "TEXT"});
      if (width == 16) return One(std::array{"W0", "W1", "W2", "ST.P1", "ST2.P1", "W0", "W1", "W2"});
      return One(std::array{"D0", "D1", "ST.P2"});
    }
    if (choice < habits_.percent_of_names + 25) {
      return prefix + One(std::array{"B0",
                                     "B1",
                                     "BITS",
                                     "W0",
                                     "W1+1",
                                     "D0",
                                     "D1",
                                     "TAB+2",
                                     "(TAB+3)",
                                     "ST.P0",
                                     "ST.P1",
                                     "LABEL_MEM",
                                     "LABEL_MEM+7",
                                     "(LABEL_MEM+40)",
                                     "LABEL_MEM.P1",
                                     "IN0",
                                     "OUT0",
                                     "OUT1",
                                     "SET_NCTAB",
                                     "SET_NCTAB.NCTAB_SLOUPEC",
                                     "TAB_TECHNOL.TCH_VOLBA",
                                     "TAB_TECHNOL+33",
                                     "BUKON01",
                                     "TAB2+4",
                                     "TEXT+3",
                                     "ST2.P2",
                                     "(ST3+9)",
                                     "IN60",
                                     "OUT60",
                                     "MATTL",
                                     "UPS_STAT",
                                     "UPS_CMD",
                                     "TAB_TECHNOL.TCH_AKTIV"});
    }
    static const std::array<Name, 6> kIndexes = {{{"BX", Word(1), 16},
                                                  {"SI", Word(4), 16},
                                                  {"DI", Word(5), 16},
                                                  {"EBX", Whole(1), 32},
                                                  {"ESI", Whole(4), 32},
                                                  {"EDI", Whole(5), 32}}};
    const Name& index = kIndexes[Chance(60) ? 0 : Below(6)];
    reads |= index.parts;
    const std::string area = !cells_.any.empty() && Chance(20)
                                 ? random_.Pick(cells_.any)
                                 : One(std::array{"TAB", "B0", "LABEL_MEM", "LABEL_MEM.P1", "TAB_TECHNOL", "SET_NCTAB",
                                                  "W1", "IN0", "OUT0", "D1"});
    const std::string in_brackets =
        "[" + index.text + (Chance(30) ? One(std::array{"+1", "+4", "-1", "-3", "+996", "-1000"}) : "") + "]";
    switch (Below(6)) {
      case 0:
        return prefix + area + "+" + Text(Below(5)) + in_brackets;
      case 1:
        return prefix + area + in_brackets + One(std::array{".P1", "+2", ".P2"});
      case 2:
        return prefix + "(" + area + "+" + Text(Below(3)) + ")" + in_brackets;
      default:
        return prefix + area + in_brackets;
    }
  }

  std::string Constant(uint32_t width) {
    switch (Below(5)) {
      case 0:
        return Literal(Below(10));
      case 1:
        return width == 8    ? One(std::array{"0", "1", "127", "128", "255", "-1", "-128"})
               : width == 16 ? One(std::array{"0", "1", "255", "256", "7FFFh", "8000h", "0FFFFh", "-1", "-32768",
                                              "9999", "10000"})
                             : One(std::array{"0", "1", "65535", "65536", "7FFFFFFFh", "80000000h", "0FFFFFFFFh", "-1",
                                              "-2", "79999999", "80000000"});
      default: {
        const uint32_t bits = std::min(width, 4 + Below(29));
        return Literal(random_.Next() & ((uint64_t{1} << bits) - 1));
      }
    }
  }

  /// Memory or CNST.
  std::string DataOperand(uint32_t least, uint32_t most, Loaded& reads) {
    std::vector<uint32_t> widths;
    for (const uint32_t width : {8u, 16u, 32u}) {
      if (width >= least && width <= most) widths.push_back(width);
    }
    const uint32_t width = random_.Pick(widths);
    if (Chance(40)) {
      if (most == 8) return "CNST." + Expression(Below(Chance(50) ? 8 : 256));
      if (most == 16) return "CNST." + Expression(Below(Chance(50) ? 8 : 65536));
      return "CNST." + Constant(width == 8 ? 16 : width);
    }
    return Memory(width, reads);
  }

  Name RegisterOf(uint32_t width, bool avoid_dr) {
    static constexpr std::array<const char*, 6> kLong = {"EAX", "EBX", "ECX", "EDX", "ESI", "EDI"};
    uint32_t reg = 0;
    do {
      reg = Below(width == 8 ? 4 : 6);
    } while (avoid_dr && reg == kEcx);
    if (width == 32) return {kLong[reg], Whole(reg), 32};
    if (width == 16) return {std::string(kLong[reg]).substr(1), Word(reg), 16};
    const bool high = Chance(40);
    return {std::string(1, kLong[reg][1]) + (high ? "H" : "L"), Parts(reg, high ? 2 : 1), 8};
  }

  // --- what is loaded ----------------------------------------------------------------------------------------------

  void Line(const std::string& text) {
    std::string line = Respelled(text);
    if (!waiting_label_.empty()) line = std::exchange(waiting_label_, {}) + line;
    at_->push_back({line, {}, ""});
  }
  /// On a line of its own: what follows is no instruction.
  void PutLabelDown() {
    if (!waiting_label_.empty()) at_->push_back({std::exchange(waiting_label_, {}), {}, ""});
  }
  /// `BYTE.x` is also `BYTE PTR x` in an assembler's instruction.
  std::string AssemblerMemory(uint32_t width, Loaded& reads) {
    const std::string text = Memory(width, reads);
    const std::string pointer = width == 8 ? "BYTE PTR " : width == 16 ? "WORD PTR " : "DWORD PTR ";
    const bool has_prefix = text.starts_with("BYTE.") || text.starts_with("WORD.") || text.starts_with("DWRD.");
    return Spelled({text, has_prefix ? pointer + text.substr(5) : text});
  }

  void Emit(const std::string& text, Loaded reads, Loaded sets, Loaded spoils, bool pure) {
    Line(text);
    run_is_whole_ = run_is_whole_ && (reads & ~since_) == 0;
    loaded_ = (loaded_ & ~spoils) | sets;
    since_ = (since_ & ~spoils) | sets;
    if (pure) return;
    since_ = 0;
    run_is_whole_ = true;
  }
  void EmitTechnol(const std::string& text, Loaded reads, Loaded sets, bool pure) {
    Emit(text, reads, sets, kAllFlags & ~sets, pure);
  }

  void Ensure(Loaded wanted) {
    if ((wanted & kRlo & ~loaded_) != 0) EmitTechnol("LDR " + Bit(false), 0, kRlo, true);
    if ((wanted & kDr & ~loaded_) != 0) {
      EmitTechnol(Chance(50) ? "LOD W" + Text(Below(3)) : "LOD CNST." + Constant(Chance(60) ? 16 : 32), 0, kDr, true);
    }
    static constexpr std::array<const char*, 6> kLong = {"EAX", "EBX", "ECX", "EDX", "ESI", "EDI"};
    for (uint32_t reg = 0; reg < 6; ++reg) {
      if ((wanted & Whole(reg) & ~loaded_) == 0) continue;
      if (reads_zero_ && reg != kEcx && Chance(30)) continue;  // TW023: 0
      if (Chance(15)) {
        BoundedRegister(reg, kLong[reg], (wanted & Whole(reg) & ~Word(reg)) != 0);
        continue;
      }
      // The ends of the areas that an index may reach (5.1).
      const std::string value = Chance(50)   ? Text(Below(12))
                                : Chance(40) ? One(std::array{"999", "998", "996", "1000", "1631", "1628", "1632", "63",
                                                              "64", "60", "8", "9", "32767", "32768", "65535", "-1000"})
                                : Chance(40) ? "-" + Text(1 + Below(3))
                                             : Constant(32);
      Emit("MOV " + std::string(kLong[reg]) + "," + value, 0, Whole(reg), 0, true);
    }
    if ((wanted & kAllFlags & ~loaded_) != 0) {
      Emit(Chance(50) ? "CMP B0," + Constant(8) : "CMP W1," + Constant(16), 0, kAllFlags, 0, true);
    }
  }

  /// A value that its own instructions keep below something, which an index needs no check for.
  void BoundedRegister(uint32_t reg, const std::string& name, bool is_long) {
    const std::string& half = name.substr(1);
    const std::string byte = One(std::array{"B0", "B1", "BYTE.TAB", "BYTE.W0"});
    const std::string last = Text(Chance(70) ? (1 << Below(6)) - 1 : Below(1100));
    switch (Below(3)) {
      case 0:
        Emit("MOVZX " + (is_long ? name : half) + "," + byte, 0, is_long ? Whole(reg) : Word(reg), 0, true);
        break;
      case 1:
        Emit("MOVZX " + name + ",W" + Text(Below(3)), 0, Whole(reg), 0, true);
        Emit("AND " + (is_long && Chance(50) ? name : half) + "," + last, Whole(reg), Whole(reg) | (kAllFlags & ~kAf),
             kAf, true);
        break;
      default:
        Emit("MOV " + name + ",0", 0, Whole(reg), 0, true);
        if (reg < 4) Emit("MOV " + std::string(1, name[1]) + "L," + byte, 0, Parts(reg, 1), 0, true);
        break;
    }
  }

  /// What a flag is, kept in a byte: only a jump shows one. The flags stay, so several may follow each other.
  void FlagProbe() {
    std::vector<FlagJump> readable;
    for (const FlagJump& jump : kFlagJumps) {
      if ((jump.reads & ~loaded_) == 0) readable.push_back(jump);
    }
    if (readable.empty()) return;
    constexpr Loaded kAdjusted = Parts(kEax, 1) | kCf | kAf;
    if ((kAdjusted & ~loaded_) == 0 && Chance(20)) {  // what AF is, nothing else shows
      Emit(One(std::array{"DAA", "DAS"}), kAdjusted, kAdjusted | kZf | kSf, kOf, true);
      return;
    }
    const FlagJump& jump = random_.Pick(readable);
    const std::string label = "PRIZNAK" + Text(probes_++);
    Emit(std::string(jump.word) + " " + label, jump.reads, 0, 0, false);
    Loaded reads = 0;
    const std::string to = Chance(80) ? One(std::array{"B0", "B1", "BITS", "BYTE.W2"}) : AssemblerMemory(8, reads);
    if ((reads & ~loaded_) != 0) {
      Emit("NOT BITS", 0, 0, 0, false);
    } else {
      Emit("MOV " + to + "," + Text(Below(256)), reads, 0, 0, false);
    }
    waiting_label_ = label + ":";
    if (!Chance(40) || is_plain_) PutLabelDown();
  }

  void AtLabel() {
    loaded_ = base_;
    since_ = 0;
    run_is_whole_ = true;
  }

  // --- instructions ------------------------------------------------------------------------------------------------

  void PureTechnol() {
    Loaded reads = 0;
    const uint32_t choice = Below(100);
    if (choice < 30) {
      const std::string mnemonic = One(std::array{"LDR ", "LA ", "LO ", "LX "});
      const Loaded needs = mnemonic == "LDR " ? 0 : kRlo;
      Ensure(needs);
      EmitTechnol(mnemonic + (Chance(30) ? "-" : "") + Bit(false), needs, kRlo, true);
    } else if (choice < 45) {
      const std::string text = DataOperand(8, 32, reads);
      Ensure(reads);
      EmitTechnol("LOD " + text, reads, kDr, true);
    } else if (choice < 65) {
      const std::string text = DataOperand(8, 32, reads);
      reads |= kDr;
      Ensure(reads);
      EmitTechnol(One(std::array{"AD ", "SU ", "AND ", "OR ", "XOR "}) + text, reads, kDr, true);
    } else if (choice < 75) {
      const bool narrow = Chance(50);
      const bool divides = Chance(50);
      const std::string text = DataOperand(8, narrow ? 8 : 16, reads);
      reads |= kDr;
      Ensure(reads);
      EmitTechnol(std::string(divides ? "DIV" : "MUL") + (narrow ? "B " : "W ") + text, reads,
                  kDr | (divides ? Word(kEdx) : 0), true);
    } else if (choice < 82) {
      const std::string count = Chance(70) ? "CNST." + Text(Below(40)) : Memory(8, reads);
      reads |= kDr;
      Ensure(reads);
      EmitTechnol(One(std::array{"RL ", "RR "}) + count, reads, kDr, true);
    } else if (choice < 87) {
      Ensure(kDr);
      EmitTechnol(One(std::array{"BCD", "BIN"}), kDr, kDr, true);
    } else {
      const std::string text = DataOperand(8, 32, reads);
      reads |= kDr;
      Ensure(reads);
      EmitTechnol(One(std::array{"EQ ", "NE ", "LT ", "LE ", "GT ", "GE "}) + text, reads, kRlo, true);
    }
  }

  uint32_t Width() { return 8u << Below(3); }

  /// `memory`: a destination in memory is wanted now and then.
  void Assembler(bool memory) {
    const uint32_t width = Width();
    const bool in_memory = memory && Chance(40);
    Loaded reads = 0;
    Name d = RegisterOf(width, false);
    if (in_memory) d = {AssemblerMemory(width, reads), 0, static_cast<uint8_t>(width)};
    const uint32_t choice = Below(100);
    if (choice < 22) {
      const std::string s = Source(width, in_memory, reads);
      Ensure(reads);
      Emit("MOV " + d.text + "," + s, reads, d.parts, 0, !in_memory);
    } else if (choice < 42) {
      const std::string s = Source(width, in_memory, reads);
      const std::string mnemonic =
          One(std::array{"ADD ", "ADC ", "SUB ", "SBB ", "CMP ", "AND ", "OR ", "XOR ", "TEST "});
      const bool logic = mnemonic == "AND " || mnemonic == "OR " || mnemonic == "XOR " || mnemonic == "TEST ";
      const bool stores = mnemonic != "CMP " && mnemonic != "TEST ";
      reads |= d.parts | (mnemonic == "ADC " || mnemonic == "SBB " ? kCf : 0);
      Ensure(reads);
      Emit(mnemonic + d.text + "," + s, reads, (stores ? d.parts : 0) | (logic ? kAllFlags & ~kAf : kAllFlags),
           logic ? kAf : 0, !in_memory || !stores);
    } else if (choice < 54) {
      const std::string mnemonic = One(std::array{"INC ", "DEC ", "NEG ", "NOT "});
      reads |= d.parts;
      Ensure(reads);
      Emit(mnemonic + d.text, reads,
           d.parts | (mnemonic == "NOT "   ? 0
                      : mnemonic == "NEG " ? kAllFlags
                                           : kAllFlags & ~kCf),
           0, !in_memory);
    } else if (choice < 70) {
      ShiftOrRotate(d, in_memory, reads);
    } else if (choice < 80) {
      const std::string mnemonic = One(std::array{"MUL ", "IMUL ", "DIV ", "IDIV "});
      const bool divides = mnemonic[0] == 'D' || mnemonic[1] == 'D';
      const Name s = Chance(50) ? RegisterOf(width, false) : Name{AssemblerMemory(width, reads), 0, 0};
      const Loaded a = width == 8 ? Word(kEax) : width == 16 ? Word(kEax) | Word(kEdx) : Whole(kEax) | Whole(kEdx);
      reads |= s.parts | (divides ? a : width == 8 ? Parts(kEax, 1) : width == 16 ? Word(kEax) : Whole(kEax));
      Ensure(reads);
      Emit(mnemonic + s.text, reads, a | (divides ? 0 : kCf | kOf), divides ? kAllFlags : kZf | kSf | kAf, true);
    } else if (choice < 86) {
      const std::string mnemonic = One(std::array{"CBW", "CWD", "CWDE", "CDQ"});
      const Loaded from = mnemonic == "CBW" ? Parts(kEax, 1) : mnemonic == "CDQ" ? Whole(kEax) : Word(kEax);
      const Loaded to = mnemonic == "CBW"    ? Word(kEax)
                        : mnemonic == "CWD"  ? Word(kEdx)
                        : mnemonic == "CWDE" ? Whole(kEax)
                                             : Whole(kEdx);
      Ensure(from);
      Emit(mnemonic, from, to, 0, true);
    } else if (choice < 90) {
      const std::string mnemonic = One(std::array{"DAA", "DAS", "AAM", "AAD"});
      const bool decimal = mnemonic[0] == 'D';
      const Loaded from = decimal ? Parts(kEax, 1) | kCf | kAf : mnemonic == "AAM" ? Parts(kEax, 1) : Word(kEax);
      Ensure(from);
      Emit(mnemonic, from, (decimal ? Parts(kEax, 1) | kCf | kAf : Word(kEax)) | kZf | kSf,
           decimal ? kOf : kCf | kOf | kAf, true);
    } else if (choice < 94) {
      const Name s = RegisterOf(width, false);
      if (in_memory && Chance(50)) {
        reads |= s.parts;
        Ensure(reads);
        Emit("XCHG " + s.text + "," + d.text, reads, s.parts, 0, false);
      } else {
        reads |= s.parts | d.parts;
        Ensure(reads);
        Emit("XCHG " + d.text + "," + s.text, reads, s.parts | d.parts, 0, !in_memory);
      }
    } else if (choice < 97) {
      const uint32_t to = Chance(50) ? 16 : 32;
      const uint32_t from = to == 32 && Chance(50) ? 16 : 8;
      reads = 0;
      const Name s = Chance(50) ? RegisterOf(from, false) : Name{AssemblerMemory(from, reads), 0, 0};
      const Name r = RegisterOf(to, false);
      reads |= s.parts;
      Ensure(reads);
      Emit(One(std::array{"MOVZX ", "MOVSX "}) + r.text + "," + s.text, reads, r.parts, 0, true);
    } else {
      const std::string mnemonic = One(std::array{"CLC", "STC", "CMC", "NOP"});
      const Loaded from = mnemonic == "CMC" ? kCf : 0;
      Ensure(from);
      Emit(mnemonic, from, mnemonic == "NOP" ? 0 : kCf, 0, true);
    }
  }

  std::string Source(uint32_t width, bool no_memory, Loaded& reads) {
    const uint32_t choice = Below(100);
    if (choice < 35) return Constant(width);
    if (choice < 70 || no_memory) {
      const Name s = RegisterOf(width, false);
      reads |= s.parts;
      return s.text;
    }
    return AssemblerMemory(width, reads);
  }

  void ShiftOrRotate(const Name& d, bool in_memory, Loaded reads) {
    const std::string mnemonic = One(std::array{"SHL ", "SAL ", "SHR ", "SAR ", "ROL ", "ROR ", "RCL ", "RCR "});
    const bool rotates = mnemonic[0] == 'R';
    const bool through = mnemonic[1] == 'C';
    const bool in_cl = Chance(40);
    const uint32_t count = Chance(50) ? 1 : Below(34);
    reads |= d.parts | (through ? kCf : 0) | (in_cl ? Parts(kEcx, 1) : 0);
    Ensure(reads);
    const Loaded changed = rotates ? kCf : kCf | kZf | kSf;
    if (in_cl) {
      Emit(mnemonic + d.text + ",CL", reads, d.parts | changed, kOf | (rotates ? 0 : kAf), !in_memory);
    } else if ((count & 31) == 0) {
      Emit(mnemonic + d.text + "," + Text(count), reads, d.parts, 0, !in_memory);
    } else {
      const bool one = (count & 31) == 1;
      Emit(mnemonic + d.text + "," + Text(count), reads, d.parts | changed | (one ? kOf : 0),
           (one ? 0 : kOf) | (rotates ? 0 : kAf), !in_memory);
    }
  }
  /// PUSH, something, POP into any register of the same width.
  void Stack(uint32_t depth) {
    const uint32_t width = Chance(50) ? 16 : 32;
    const Name from = RegisterOf(width, false);
    Ensure(from.parts);
    PutLabelDown();
    std::vector<Piece>* const outer = at_;
    Piece piece{"  PUSH " + from.text, {}, ""};
    run_is_whole_ = true;
    since_ = 0;
    at_ = &piece.body;
    for (uint32_t k = Below(4); k > 0; --k) {
      if (Chance(15) && depth < 4) {
        Stack(depth + 1);
      } else if (Chance(50)) {
        Assembler(true);
      } else {
        PureTechnol();
      }
    }
    const Name to = RegisterOf(width, false);
    piece.end = "  POP " + to.text;
    at_ = outer;
    at_->push_back(std::move(piece));
    loaded_ |= to.parts;
    since_ = 0;
    run_is_whole_ = true;
  }

  /// One program in three is of the kind that it always was; the others have a mixture of their own.
  void ChooseHabits() {
    if (Chance(33)) return;
    habits_.most_mechanisms = Below(9);
    habits_.most_subprograms = Below(9);
    habits_.labels_in_hundred = Below(40);
    habits_.most_calls = 1 + Below(3);
    habits_.percent_of_own_cells = Below(80);
    habits_.percent_of_names = Below(70);
    for (uint32_t& weight : habits_.body) weight = Chance(25) ? 0 : Below(40);
    habits_.body[1 + Below(3)] += 10;
    for (uint32_t& weight : habits_.acting) weight = Chance(25) ? 0 : Below(30);
    habits_.acting[Below(3)] += 10;
  }
  template <size_t N>
  size_t Weighed(const std::array<uint32_t, N>& weights) {
    uint32_t all = 0;
    for (const uint32_t weight : weights) all += weight;
    uint32_t left = Below(all);
    for (size_t kind = 0; kind < N; ++kind) {
      if (left < weights[kind]) return kind;
      left -= weights[kind];
    }
    return 0;
  }

  Random& random_;
  const bool is_plain_;
  Habits habits_;
  Cells cells_;                       // of this program alone
  std::string waiting_label_;         // of the next line
  std::vector<Piece>* at_ = nullptr;  // where lines go
  std::vector<std::string> mechanisms_;
  uint32_t probes_ = 0;
  bool aborts_ = false;      // mech-clear=abort: inside a mechanism no activation bit is written
  bool inside_ = false;      // a mechanism or a subprogram
  bool reads_zero_ = false;  // no wait is near: a register that is not loaded is 0
  Loaded base_ = 0;          // at labels
  Loaded loaded_ = 0, since_ = 0;
  bool run_is_whole_ = true;  // what stands since the last resume point reads nothing from before it
};

}  // namespace plcxx::reference::technol_code
