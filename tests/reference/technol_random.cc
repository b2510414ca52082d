// Random programs of dialect technol: valid ones, of the whole language (6), with few cells so that things meet.
#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "tests/reference/technol.h"
#include "tests/reference/technol_random_code.h"
#include "tests/reference/technol_random_macros.h"
#include "tests/reference/technol_random_segments.h"

namespace plcxx::reference {
namespace {

using namespace technol_code;

class TechnolGenerator : StraightCode {
 public:
  TechnolGenerator(Random& random, uint32_t instructions, Spelling spelling)
      : StraightCode(random, spelling),
        macros_(random, [this](const std::vector<std::string>& any) { return Spelled(any); }),
        instructions_(instructions) {
    at_ = &pieces_;
  }

  RandomProgram Run() {
    ChooseHabits();
    macro_definitions_ = macros_.Definitions();
    ChooseOptions();
    for (uint32_t k = Below(habits_.most_mechanisms + 1); k > 0; --k)
      mechanisms_.push_back(NewName("M", mechanisms_.size()));
    top_level_ = mechanisms_.empty() ? 0 : Below(static_cast<uint32_t>(mechanisms_.size()) + 1);
    for (uint32_t k = Below(habits_.most_subprograms + 1); k > 0; --k)
      segments_.push_back(NewName("PP", segments_.size()));
    Data();
    const uint32_t parts = 5 + static_cast<uint32_t>(mechanisms_.size() + segments_.size());
    size_ = std::max(3u, instructions_ / parts);
    std::vector<uint32_t> order = {0, 1, 2, 3, 4, 5, 6};
    for (uint32_t k = 7; k > 1; --k) std::swap(order[k - 1], order[Below(k)]);
    uint32_t next_top = 0;
    for (const uint32_t module : order) {
      Module(module);
      if (next_top < top_level_ && Chance(50)) Mechanism(next_top++);
    }
    while (next_top < top_level_) Mechanism(next_top++);
    if (Chance(12)) HostModule();
    Subprograms();
    Piece& end = pieces_.emplace_back();
    end.text = "  STOP";
    Steps();
    std::vector<RandomFile> files = Files();
    if (Chance(10)) {
      files.push_back({"TAB7.TCH", {{"$TCH 1 2 2\n00: 1.5 -2\n01: " + Text(Below(79999)) + ".07 4", {}, ""}}});
    }
    return {.files = std::move(files), .options = std::move(options_), .steps = std::move(steps_)};
  }

 private:
  void ChooseOptions() {
    options_["loop-limit"] = Text(1 + Below(Chance(80) ? 10 : 60));
    if (Chance(15)) options_["bounds"] = "trap";
    if (Chance(15)) options_["rl"] = "shift";
    if (Chance(20)) options_["mech-clear"] = "abort";
    if (Chance(10)) options_["eset"] = "binary";
    if (Chance(10)) options_["retain"] = "dual";
    if (Chance(10)) options_["evidence"] = "strict";
    if (Chance(15)) {
      options_["slow-ms"] = One(std::array{"4", "12", "40", "6"});
      if (Chance(50)) options_["fast-ms"] = One(std::array{"2", "1"});
    }
    if (Chance(10)) options_["tch-version"] = "any";
    if (Chance(10)) options_["tch-glued"] = "accept";
    reads_include_ = Chance(30);
    aborts_ = options_.contains("mech-clear");
  }

  /// What other lines of the source use: constants and macros, here or in a file that is included.
  std::vector<Piece> Prolog() {
    std::vector<Piece> lines;
    lines.push_back({Spelled({"EQUI TRI,3", "EQUI tri , 1+2", "EQUI TRI,9/3"}), {}, ""});
    lines.push_back({Spelled({"PET EQU 5", "PET = 5", "Pet EQU TRI+2", "PET EQU (TRI SHL 1)-1"}), {}, ""});
    lines.push_back({Spelled({"SEDM = 7", "SEDM = 4 OR 2 OR 1", "SEDM EQU 0FFH AND 7", "SEDM EQU 15 MOD 8"}), {}, ""});
    const auto macro = [&](const std::string& text) {
      const std::string close = Spelled({"  ENDM", "ENDM ; konec"});
      lines.push_back({text, {}, close});
    };
    macro("PLUS MACRO C1,O1\n  LOD C1\n  AD CNST.O1\n  STO C1");
    macro("DVAKRAT MACRO C2\n  PLUS C2,1\n  PLUS C2,2");
    macro("SKOK MACRO P1,V1\n  LOCAL DAL\n  LDR P1\n  JL1 DAL\n  FL 1,V1\nDAL:");
    macro("SPOJ MACRO P2\n  LOD W&P2\n  STO W&P2");
    std::ranges::move(macro_definitions_, std::back_inserter(lines));
    return lines;
  }

  std::vector<RandomFile> Files() {
    std::vector<RandomFile> files(1);
    files[0].name = "program.plc";
    std::vector<Piece> prolog = Prolog();
    if (reads_include_ && !is_plain_) {
      files[0].pieces = {{One(std::array{"  T_INCLUDE spol.inc", "\tt_include spol.inc ; konstanty"}), {}, ""}};
    } else {
      if (reads_include_) One(std::array{"", ""});
      files[0].pieces = prolog;
    }
    const std::string title =
        Spelled({"", "", "  TITLE a machine", "  INCLUDE KONST.ASH", "  PAGE 60,132", "  SUBTTL data", "  NAME stroj"});
    files[0].pieces.insert(files[0].pieces.begin(), {title, {}, ""});
    // The data, some units; then a file with data of its own.
    const size_t cut = Chance(25) ? 1 + Below(4) : pieces_.size();
    for (size_t i = 0; i < pieces_.size(); ++i) {
      if (i == cut) {
        files.push_back({.name = "second.plc", .pieces = {{"  DATA", {{"X9: DS 2", {}, ""}}, "  DATA_END"}}});
      }
      files.back().pieces.push_back(std::move(pieces_[i]));
    }
    if (reads_include_ && !is_plain_) {
      files.push_back({.name = "spol.inc", .pieces = std::move(prolog), .is_source = false});
    }
    for (RandomFile& file : files) {
      if (!file.is_source) continue;
      const std::string ends = Spelled({"\n", "\n", "\r\n", "\r"});
      const std::string head = Spelled({"", "", "\xEF\xBB\xBF"});
      if (!is_plain_) file.line_end = ends, file.head = head;
    }
    if (cut >= pieces_.size()) files[0].tail = Spelled({"", "", "\x1A", "text behind STOP\n"});
    return files;
  }

  void Data() {
    Piece data{"  DATA", {}, Spelled({"  DATA_END", "  START"})};
    const auto line = [&](const std::string& text) { data.body.push_back({text, {}, ""}); };
    RandomData own(
        random_, [this](const std::vector<std::string>& any) { return Spelled(any); },
        [this](uint64_t value) { return Literal(value); }, awkward_);
    for (const std::string& text : own.Lines()) line(text);
    cells_ = own.cells();
    const std::string open = Spelled({"S0 STRUC", "S0 STRUCT", "S0 STRUC ; pole"});
    line(open + "\nP0 DB 3\nP1 DW ?\nP2 DD ?\nS0 ENDS");
    line("BITS: DFM A0,A1,A2,A3,A4,A5,A6,A7");
    line("B0: DB " + Expression(Below(256)));
    line(Spelled({"B1: DS 1", "B1 DB ?", "B1: db 1 DUP (?)"}));
    line("W0: DW " + Literal(Below(65536)));
    line("W1: DS 2");
    line("W2: DS 2");
    line("D0: DD " + Literal(random_.Next() & 0xFFFFFFFF));
    line("D1: DS 4");
    line(Spelled({"TAB: DB 1,2,3,0F9h,5 DUP (7)", "TAB: DB 1,2,TRI,371q,5 DUP (7)",
                  "TAB DB 1 , 2 , 3 , 249 , (PET) DUP (SEDM)"}));
    line("ST: S0 <1,2,3>");
    line(Spelled({"TEXT: DB 'AHOJ',0", "TEXT DB 'AHO','J',0", "TEXT: DB 65,72,79,74,0"}));
    line(Spelled({"TAB2: DB 2 DUP (1,2 DUP (?),4)", "TAB2 DB 1,?,?,4,1,2 DUP (?),4"}));
    line(Spelled({"ST2: S0 <,7>", "ST2: S0 <3,7>", "ST2 S0 <,7,?>"}));
    line("ST3: S0 2 DUP (<>)");
    line("UPS_FAULT: DFM U0,U1");
    line("IN0: DFM I0,I1,I2,I3,I4,I5,I6,I7");
    line("OUT0: DFM O0,O1,O2,O3,,O5");
    pieces_.push_back(std::move(data));
  }

  void Acting() {
    Loaded reads = 0;
    if (segment_ != kNone && !mechanisms_.empty() && Chance(6)) {  // of one that may have called
      EmitTechnol("MECH_INIT " + random_.Pick(mechanisms_), 0, 0, false);
      return;
    }
    switch (Weighed(habits_.acting)) {
      case 0:
        Ensure(kRlo);
        EmitTechnol("WR " + Bit(true), kRlo, 0, false);
        break;
      case 1: {
        const std::string mnemonic = One(std::array{"FL ", "FL1 ", "FL0 "});
        if (mnemonic != "FL ") Ensure(kRlo);
        EmitTechnol(mnemonic + Text(Below(2)) + "," + Bit(true), mnemonic == "FL " ? 0 : kRlo, 0, false);
        break;
      }
      case 2: {
        const std::string text = Memory(Width(), reads);
        reads |= kDr;
        Ensure(reads);
        EmitTechnol("STO " + text, reads, 0, false);
        break;
      }
      case 3:
        EmitTechnol("ESET " + Text(1 + Below(99)) + (Chance(50) ? "," + Text(Below(100)) : ""), 0, 0, false);
        break;
      case 4:
        if (!mechanisms_.empty()) EmitTechnol("MECH_INIT " + random_.Pick(mechanisms_), 0, 0, false);
        break;
      case 5:
        Macro();
        break;
      default:
        Assembler(true);
        break;
    }
  }

  /// A call of a macro; the plain text is what it stands for.
  void Macro() {
    const std::string cell = "W" + Text(Below(3)), step = Expression(1 + Below(9));
    const auto plus = [](const std::string& to, const std::string& by) {
      return "LOD " + to + "\n  AD CNST." + by + "\n  STO " + to;
    };
    if (!macros_.empty() && Chance(60)) {
      const MacroCall call = macros_.Call();
      EmitTechnol(is_plain_ ? call.expanded : call.text, 0, (call.loads_dr ? kDr : 0) | (call.loads_rlo ? kRlo : 0),
                  false);
      if (call.has_label) AtLabel();
      return;
    }
    switch (Below(4)) {
      case 0:
        EmitTechnol(is_plain_ ? plus(cell, step) : "PLUS " + cell + "," + step, 0, kDr, false);
        break;
      case 1:
        EmitTechnol(is_plain_ ? plus(cell, "1") + "\n  " + plus(cell, "2") : "DVAKRAT " + cell, 0, kDr, false);
        break;
      case 2:
        EmitTechnol(is_plain_ ? "LOD " + cell + "\n  STO " + cell : "SPOJ " + cell.substr(1), 0, kDr, false);
        break;
      default: {
        const std::string from = Bit(false), to = "A" + Text(Below(8));
        const std::string label = "PL" + Text(macro_labels_++);
        const std::string expanded = "LDR " + from + "\n  JL1 " + label + "\n  FL 1," + to + "\n" + label + ":";
        EmitTechnol(is_plain_ ? expanded : "SKOK " + from + "," + to, 0, kRlo, false);
        AtLabel();
        break;
      }
    }
  }

  std::string SomeLabel() {
    if (!targets_.empty()) return random_.Pick(targets_);
    // The subprogram area is one unit (6.4): also a later subprogram's label, which makes no ring.
    if (segment_ != kNone && segment_ + 1 < segments_.size() && Chance(15)) {
      return segments_[segment_ + 1 + Below(static_cast<uint32_t>(segments_.size()) - segment_ - 1)];
    }
    if (segment_ != kNone && segment_ > 0 && Chance(10)) {
      if (const std::string label = LabelAbove(); !label.empty()) return label;
    }
    if (forward_only_) {
      return placed_ < labels_ ? Label(placed_ + Below(labels_ - placed_)) : "";
    }
    return labels_ == 0 ? "" : Label(Below(labels_));
  }
  std::string Label(uint32_t number) const { return "L" + Text(unit_) + "_" + Text(number); }

  /// One of an earlier subprogram.
  std::string LabelAbove() {
    const uint32_t target = Below(segment_);
    if (!made_segments_.JumpsBackTo(target)) return "";
    const Segments::Labels labels = made_segments_.LabelsOf(target);
    if (labels.count == 0 || Chance(40)) return segments_[target];
    return "L" + Text(labels.unit) + "_" + Text(Below(labels.count));
  }

  void Jump() {
    const std::string label = SomeLabel();
    if (label.empty()) return;
    const uint32_t choice = Below(100);
    if (choice < 40) {
      Ensure(kRlo);
      EmitTechnol(One(std::array{"JL0 ", "JL1 "}) + label, kRlo, 0, false);
    } else if (choice < 48) {
      EmitTechnol("JUM " + label, 0, 0, false);
    } else if (choice < 52) {
      Emit("JMP " + label, 0, 0, kAllFlags, false);
    } else if (choice < 62) {
      Ensure(Word(kEcx));
      Emit("LOOP " + label, Word(kEcx), Word(kEcx), 0, false);
    } else if (choice < 68) {
      Ensure(Word(kEcx));
      Emit("JCXZ " + label, Word(kEcx), 0, 0, false);
    } else {
      const FlagJump& jump = kFlagJumps[Below(kFlagJumps.size())];
      Ensure(jump.reads);
      Emit(jump.word + std::string(Chance(10) ? " SHORT " : " ") + label, jump.reads, 0, 0, false);
    }
  }

  void Call() {
    const uint32_t first = segment_ == kNone ? 0 : segment_ + 1;
    if (first >= segments_.size() || calls_ >= std::min(habits_.most_calls, segments_.size() > 5 ? 2u : 3u)) return;
    ++calls_;
    const bool outer_zero = std::exchange(reads_zero_, false);
    Ensure(kSubprogramBase);
    reads_zero_ = outer_zero;
    const uint32_t target = first + Below(static_cast<uint32_t>(segments_.size()) - first);
    if (segment_ != kNone) made_segments_.Calls(target);
    EmitTechnol("CALL " + segments_[target], kSubprogramBase, 0, false);
  }

  void Wait() {
    if (!run_is_whole_ || Chance(20)) EmitTechnol("FL " + Text(Below(2)) + ",A" + Text(Below(8)), 0, 0, false);
    const uint32_t choice = Below(100);
    if (choice < 15) {
      Line("EX");
      AtLabel();
      return;
    }
    const std::string cell = Chance(60) ? "-" : "W" + Text(Below(3));
    const std::string limit = Chance(70)   ? Literal(Below(4))
                              : Chance(50) ? "CNST." + Expression(Below(8))
                                           : "W" + Text(Below(3));
    if (choice < 40) {
      Line("TIM " + cell + "," + limit);
      AtLabel();
      return;
    }
    loaded_ = since_;
    for (uint32_t k = Below(4); k > 0; --k) {
      if (Chance(75)) {
        PureTechnol();
      } else {
        Assembler(false);
      }
    }
    Ensure(kRlo);
    const std::string label = SomeLabel();
    const bool limited = choice >= 70 && !label.empty();
    EmitTechnol(
        limited ? One(std::array{"TEX0 ", "TEX1 "}) + cell + "," + limit + "," + label : One(std::array{"EX0", "EX1"}),
        kRlo, 0, false);
  }

  // --- units -------------------------------------------------------------------------------------------------------

  void Body(uint32_t size, bool waits) {
    for (uint32_t k = 0; k < size; ++k) {
      if (placed_ < labels_ && Below(size) < labels_ * 2) PlaceLabel();
      switch (Weighed(habits_.body)) {
        case 0:
          if (waits) {
            Wait();
          } else {
            PureTechnol();
          }
          break;
        case 1:
          PureTechnol();
          break;
        case 2:
          Assembler(true);
          for (uint32_t probes = Chance(30) ? 1 + Below(3) : 0; probes > 0; --probes) FlagProbe();
          break;
        case 3:
          Acting();
          break;
        case 4:
          Jump();
          break;
        case 5:
          Call();
          break;
        default:
          Stack(0);
          break;
      }
    }
  }
  void PlaceLabel() { Place(Label(placed_++)); }
  void Place(const std::string& label) {
    PutLabelDown();
    waiting_label_ = label + ":";
    if (!Chance(40) || is_plain_) PutLabelDown();
    AtLabel();
  }

  /// Steps one after the other as people write them: what goes wrong leads to one place below, which may begin again.
  void Sequence() {
    labels_ = placed_ = 0;
    const std::string name = "K" + Text(unit_), fault = name + "_CHYBA", end = name + "_KONEC";
    const auto act = [&] {
      for (uint32_t k = Below(4); k > 0; --k) {
        Chance(50) ? Acting() : PureTechnol();
      }
    };
    const auto leave_for = [&](const std::string& label) {
      targets_ = {label};
      Jump();
      targets_.clear();
    };
    const bool begins_again = Chance(60);
    if (begins_again) Place(name + "_ZNOVU");
    for (uint32_t steps = 1 + Below(4); steps > 0; --steps) {
      act();
      targets_ = {fault};
      if (Chance(30)) targets_.push_back(end);
      Wait();
      if (Chance(30)) Jump();
      targets_.clear();
    }
    if (Chance(60)) EmitTechnol("JUM " + end, 0, 0, false);
    Place(fault);
    act();
    if (begins_again && Chance(70)) leave_for(name + "_ZNOVU");
    Place(end);
    act();
    if (begins_again && Chance(20)) leave_for(name + "_ZNOVU");
  }

  /// A unit with its own labels around `inside`.
  template <class Inside>
  void Unit(const std::string& open, const std::string& close, bool waits, Inside inside) {
    PutLabelDown();
    const auto outer = std::tuple(at_, unit_, labels_, placed_, base_, forward_only_, calls_);
    std::vector<Piece>* const into = at_;
    Piece piece{open, {}, close};
    at_ = &piece.body;
    unit_ = units_++;
    labels_ = Chance(25) ? 0 : Below(2 + size_ * habits_.labels_in_hundred / 100);
    placed_ = 0;
    calls_ = 0;
    base_ = 0;
    forward_only_ = waits && Chance(40);
    AtLabel();
    inside();
    while (placed_ < labels_) PlaceLabel();
    PutLabelDown();
    std::tie(at_, unit_, labels_, placed_, base_, forward_only_, calls_) = outer;
    into->push_back(std::move(piece));
    AtLabel();
  }

  void Module(uint32_t module) {
    static constexpr std::array<const char*, 7> kModules = {"MODULE_INIT",     "MODULE_MAIN", "MODULE_FAST",
                                                            "MODULE_CLEAR",    "MODULE_HALT", "PRIPRAVNE_FUNKCE",
                                                            "ZAVERECNE_FUNKCE"};
    if (module != 1 && Chance(module == 4 ? 40 : 8)) return;
    const std::string name = kModules[module];
    const bool waits = module >= 5;
    Unit("  " + name, "  " + name + "_END", waits, [&] {
      const bool preloaded = !waits && Chance(60);
      reads_zero_ = !waits;
      if (preloaded) base_ = kRlo | kDr;
      Ensure(base_);
      const uint32_t share = module == 1 || waits ? size_ : size_ / 2 + 1;
      Body(share, waits);
      if (module != 1) return;
      for (uint32_t m = top_level_; m < mechanisms_.size(); ++m) {
        Mechanism(m);
        loaded_ = since_ = 0;
        Ensure(base_);
        Body(share / 2, false);
      }
    });
  }

  std::string NewName(const char* stem, size_t number) {
    const std::string awkward = Chance(25) ? awkward_.Next(random_) : "";
    return awkward.empty() ? stem + std::to_string(number) : awkward;
  }

  /// Called by the host alone, which no scenario does: it has to be generated all the same.
  void HostModule() {
    const std::string name =
        One(std::array{"MODULE_SEST", "MODULE_?", "MODULE_@X?", "MODULE_main_2", "MODULE_m", "MODULE_int"});
    Unit("  " + name, "  " + name + "_END", false, [&] {
      reads_zero_ = true;
      Body(size_ / 2 + 1, false);
    });
  }

  void Mechanism(uint32_t number) {
    const bool outer = std::exchange(inside_, true);
    const bool outer_zero = std::exchange(reads_zero_, false);
    Unit("  MECH_BEGIN " + mechanisms_[number], "  MECH_END " + mechanisms_[number], true,
         [&] { Chance(35) ? Sequence() : Body(size_, true); });
    inside_ = outer;
    reads_zero_ = outer_zero;
  }

  void Subprograms() {
    inside_ = true;
    reads_zero_ = false;
    for (segment_ = 0; segment_ < segments_.size(); ++segment_) {
      const bool falls = segment_ + 1 < segments_.size() && Chance(30);
      made_segments_.Begin();
      Unit(segments_[segment_] + ":", falls ? "" : "  RET", false, [&] {
        base_ = kSubprogramBase;
        AtLabel();
        Body(size_, false);
        made_segments_.End({.unit = unit_, .count = labels_});
      });
    }
    segment_ = kNone;
    inside_ = false;
  }

  // --- scenario ----------------------------------------------------------------------------------------------------

  std::string Assignment() {
    switch (Below(9)) {
      case 0:
        return One(std::array{"NC_PRIPRAVNE: ", "NC_ZAVERECNE: ", "NC_CLEAR: "}) + Text(Chance(75) ? 1 : 0);
      case 1:
        if (!mechanisms_.empty()) return "'" + random_.Pick(mechanisms_) + "': " + Text(Chance(70) ? 1 : 0);
        [[fallthrough]];
      case 2:
        return "W" + Text(Below(3)) + ": " + Text(Below(Chance(50) ? 6 : 65536));
      case 3:
        return "DWRD.D" + Text(Below(2)) + ": " + Text(random_.Next() & 0xFFFFFFFF);
      case 4:
        if (Chance(30)) {
          const std::string item = Text(1 + (Below(2) << 8) + ((1 + Below(2)) << 16) + ((1 + Below(5)) << 24));
          return "DWRD.SET_NCTAB: " + item + ", BYTE.(SET_NCTAB+4): " + Text(50 + Below(12)) +
                 ", DWRD.(SET_NCTAB+5): " + Text(Below(9));
        }
        return Chance(40) ? "REQ_BACKUP_MEM: " + Text(Below(2)) : "SYSREQ: " + Text(Below(128));
      case 5:
        return "BYTE.(LABEL_MEM+" + Text(Below(8)) + "): " + Text(Below(256));
      case 6:
        if (!cells_.bytes.empty() && Chance(60)) return "'" + random_.Pick(cells_.bytes) + "': " + Text(Below(256));
        if (!cells_.words.empty() && Chance(50)) return "'" + random_.Pick(cells_.words) + "': " + Text(Below(65536));
        return "BITS: " + Text(Below(256));
      default:
        return "IN" + Text(Below(2)) + ": " + Text(Below(256));
    }
  }

  void Steps() {
    for (uint32_t k = 4 + Below(14); k > 0; --k) {
      std::string set;
      for (uint32_t j = Below(4); j > 0; --j) {
        const std::string assignment = Assignment();
        const bool twice = set.find(assignment.substr(0, assignment.find(':') + 1)) != std::string::npos;
        if (!twice) set += (set.empty() ? "" : ", ") + assignment;
      }
      if (!set.empty()) steps_.push_back("set: {" + set + "}");
      if (Chance(6)) {
        static constexpr std::array kForced = {"force: {A3: 1}", "force: {W1: 7}",    "force: {B0: 255}",
                                               "force: {I2: 1}", "force: {OUT1: 85}", "force: {DWRD.D1: 9}",
                                               "force: {A3: 0}", "force: {IN0: 3}"};
        steps_.emplace_back(One(kForced));
      }
      if (Chance(6)) {  // a cell of this program's own
        const std::string own = !cells_.words.empty()  ? random_.Pick(cells_.words)
                                : !cells_.bits.empty() ? random_.Pick(cells_.bits)
                                                       : "A5";
        steps_.push_back("force: {'" + own + "': 1}");
        if (Chance(50)) {
          steps_.emplace_back("run: {slow: 2}");
          steps_.push_back("release: ['" + own + "']");
        }
      }
      if (Chance(6)) steps_.emplace_back("release: [A3, W1, B0, I2, OUT1, DWRD.D1, IN0]");
      const uint32_t choice = Below(20);
      if (choice == 0) {
        steps_.push_back("power_cycle:");
      } else if (choice < 4) {
        steps_.push_back("run: {fast: " + Text(1 + Below(3)) + "}");
      } else if (choice < 7) {
        steps_.push_back(Chance(3) ? "run: {s: " + Text(1 + Below(3)) + "}" : "run: {ms: " + Text(1 + Below(60)) + "}");
      } else {
        steps_.push_back("run: {slow: " + Text(1 + Below(5)) + "}");
      }
    }
  }

  static constexpr uint32_t kNone = 0xFFFFFFFF;
  bool reads_include_ = false;
  uint32_t macro_labels_ = 0;
  static constexpr Loaded kSubprogramBase = kRlo | kDr | Whole(kEax) | Whole(kEbx);

  RandomMacros macros_;
  std::vector<Piece> macro_definitions_;
  uint32_t instructions_;
  uint32_t size_ = 0;  // of a unit
  std::vector<Piece> pieces_;
  std::map<std::string, std::string> options_;
  std::vector<std::string> steps_;
  uint32_t top_level_ = 0;             // of mechanisms_: the first ones
  std::vector<std::string> segments_;  // of subprograms: their names
  Segments made_segments_;
  AwkwardNames awkward_;
  uint32_t segment_ = kNone;
  uint32_t units_ = 0;
  // of the unit
  uint32_t unit_ = 0, labels_ = 0, placed_ = 0, calls_ = 0;
  bool forward_only_ = false;
  std::vector<std::string> targets_;  // of jumps here; none: any label of the unit
};

}  // namespace

RandomProgram MakeRandomTechnol(Random& random, ProgramSize size, Spelling spelling) {
  const uint32_t instructions =
      size == ProgramSize::kLarge ? random.Between(150, 600) : random.Between(10, random.OneIn(4) ? 150 : 90);
  return TechnolGenerator(random, instructions, spelling).Run();
}

}  // namespace plcxx::reference
