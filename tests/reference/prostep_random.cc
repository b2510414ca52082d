// Random programs of dialect prostep: valid ones, of the whole language (6), with few addresses so that things meet.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/reference/prostep.h"
#include "tests/reference/prostep_random_operands.h"

namespace plcxx::reference {
namespace {

class ProstepGenerator : ProstepOperands {
 public:
  ProstepGenerator(Random& random, uint32_t instructions, Spelling spelling)
      : ProstepOperands(random, spelling), instructions_(instructions) {}

  RandomProgram Run() {
    ChooseHabits();
    ChooseOptions();
    Declarations();
    std::vector<uint32_t> modules;
    if (!Chance(20)) modules.push_back(0);
    for (const auto& [first, last, percent] :
         {std::array{1u, 8u, 25u}, {9u, 16u, 25u}, {17u, 26u, 30u}, {27u, 99u, 2u}}) {
      for (uint32_t number = first; number <= last; ++number) {
        if (Chance(percent)) modules.push_back(number);
      }
    }
    if (modules.size() < 2) modules.push_back(modules.empty() || modules[0] != 9 ? 9 : 10);
    for (const uint32_t number : modules) {
      if (number >= 17 || Chance(12)) subroutines_.push_back(number);
    }
    std::vector<uint32_t> text_order = modules;
    for (uint32_t k = static_cast<uint32_t>(text_order.size()); k > 1; --k) {
      std::swap(text_order[k - 1], text_order[Below(k)]);
    }
    const uint32_t each = std::max<uint32_t>(3, instructions_ / static_cast<uint32_t>(modules.size()));
    std::vector<RandomFile> files;
    const uint32_t parts = Chance(30) ? 1 + Below(3) : 1;
    for (size_t k = 0; k < text_order.size(); ++k) {
      Module(text_order[k], Below(2 * each) + 1);
      if ((k + 1) % (text_order.size() / parts + 1) == 0) File(files);
      if (Chance(20)) Declaration();
    }
    File(files);
    Steps();
    return {.files = std::move(files), .options = std::move(options_), .steps = std::move(steps_)};
  }

 private:
  // --- spelling (2): both spellings draw alike ---------------------------------------------------------------------

  /// Blanks, leading zeros, case; a comment behind what is complete.
  std::string Respelled(const std::string& text, bool may_be_alone) {
    const uint32_t form = Below(16);
    const std::string remark =
        Spelled({"", "", "", "", "", " ; A I 0.0", "\t* remark", ";", may_be_alone ? " ;:" : "   oil level"});
    if (is_plain_) return text;
    std::string line = text;
    const size_t last = line.rfind(' ');
    const bool has_number =
        last != std::string::npos && last + 1 < line.size() && line[last + 1] >= '0' && line[last + 1] <= '9';
    if (form == 0) {
      for (char& c : line) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    } else if (form == 1 && has_number) {
      line.erase(last, 1);  // between a class and its number no blank is needed
      if (line.find(' ') == std::string::npos && line[0] != '=') line = text;
    } else if (form == 2 && has_number && line.back() != 'D' && line.back() != 'd') {
      line.insert(last + 1, "0");
    } else if (form == 3 && last != std::string::npos) {
      line.replace(line.find(' '), 1, "\t ");
    } else if (form == 4 && line.starts_with("= ")) {
      line.erase(1, 1);
    }
    return line + remark;
  }
  std::string Colon() { return Spelled({":", ":", ":", ": ", "  :", "\t:\t"}); }

  void Line(const std::string& text) {
    const std::string colon = Colon();
    const bool may_be_alone = text.find(' ') == std::string::npos;
    at_->push_back({std::exchange(label_, {}) + colon + Respelled(text, may_be_alone), {}, ""});
    if (Chance(3)) {
      const std::string comment = Spelled(
          {"", "", "; a comment: A I 0.0", "* a comment", "free text without its mark", " \t", ":", ": ; nothing"});
      // Behind an instruction that waits for operands, too.
      if (!comment.empty()) at_->back().text += "\n" + comment;
    }
  }
  /// Of the instruction before: they are left out together.
  void OperandLine(const std::string& text) {
    const std::string colon = Spelled({": ", ": ", ":", "  :  "});
    at_->back().text += "\n" + colon + Respelled(text, false);
  }
  void PlaceLabel(uint32_t label) {
    PutLabelDown();
    label_ = Label(label) + Spelled({" ", "", "\t"});
    if (!Chance(40) || is_plain_) PutLabelDown();
  }
  /// On a colon of its own.
  void PutLabelDown() {
    if (!label_.empty()) at_->push_back({std::exchange(label_, {}) + ":", {}, ""});
  }
  static std::string Label(uint32_t label) {
    static const std::array<const char*, 5> kNames = {"L0", "DT1", "A+-.#", "EM", "L_%$4"};
    // The grammar has all letters.
    static const std::array<const char*, 4> kMore = {"GJNQ", "UVWYZ", "MB", "X\"'()"};
    if (label >= kNames.size() && label < kNames.size() + kMore.size()) return kMore[label - kNames.size()];
    return label < kNames.size() ? kNames[label] : "L" + std::to_string(label);
  }
  template <class Inside>
  void Around(const std::string& text, const std::string& end, Inside inside) {
    std::vector<Piece>* const outer = at_;
    if (text.starts_with("MOD")) PutLabelDown();
    Piece piece{std::exchange(label_, {}) + Colon() + text, {}, Colon() + end};
    at_ = &piece.body;
    inside();
    PutLabelDown();
    at_ = outer;
    at_->push_back(std::move(piece));
  }

  void File(std::vector<RandomFile>& files) {
    RandomFile file{.name = "part" + std::to_string(files.size()) + ".plc", .pieces = std::move(pieces_)};
    pieces_.clear();
    const std::string head = Spelled({"", "", "", "\xEF\xBB\xBF"});
    const std::string header = Spelled({"", "", "%PLC", "; machine\n%PLC 1:2"});
    file.line_end = Spelled({"\n", "\n", "\n", "\r\n", "\r", "\n\r"});
    file.tail = Spelled({"", "", "", "\x03", "\x1A:MOD PM"});
    file.head = head;
    file.pieces.insert(file.pieces.begin(), {header, {}, ""});
    if (file.pieces.size() > 1 || files.empty()) files.push_back(std::move(file));
  }

  /// Texts and M functions: the control's own.
  void Declaration() {
    switch (Below(4)) {
      case 0:
        if (m_functions_ < 20) {
          pieces_.push_back({"DMF " + std::to_string(m_functions_++ * 3) +
                                 One(std::array{"", " P", " S 5", " D 3", " P S 24 D 16", " D1 P S1", " S7 D2"}),
                             {},
                             ""});
        }
        break;
      case 1:
        if (texts_ < 20) {
          pieces_.push_back(
              {"DM " + std::to_string(++texts_) + One(std::array{" .door open", " . oil; low *", " .\xC5\x82", ".x"}),
               {},
               ""});
        }
        break;
      case 2:
        if (menus_ < 20) pieces_.push_back({"DT" + std::to_string(++menus_) + " .HOME  AXIS", {}, ""});
        break;
      default:
        pieces_.push_back(
            {One(std::array{"; between modules", "free text", "  DDB 3 4 is no declaration", "*"}), {}, ""});
        break;
    }
  }

  void ChooseOptions() {
    options_["loop-budget"] = std::to_string(1 + Below(Chance(80) ? 12 : 100));
    if (Chance(25)) options_["first-check"] = "dynamic";
    if (Chance(15)) options_["counter-set"] = "edge";
    if (Chance(15)) options_["muldiv"] = "unsigned";
    if (Chance(10)) options_["io-refresh"] = "1ms";
    if (Chance(15)) {
      options_["retentive"] = One(std::array{"600-700", "500-501", "510-998", "999-999", "500-998", "0-999"});
      // DW 4, which scenarios force, is in one block (4.5).
      const uint32_t first = Chance(20) ? 0 : 6 + Below(994);
      const uint32_t last = std::max(first, 6u) + Below(1000 - std::max(first, 6u));
      if (Chance(40)) options_["retentive"] = std::to_string(first) + "-" + std::to_string(last);
    }
    if (Chance(10)) options_["tick"] = std::to_string(1 + Below(Chance(80) ? 30 : 1000));
    if (Chance(10)) options_["plc-axes"] = std::to_string(Below(6));
    if (Chance(5)) options_["text-encoding"] = "mazovia";
  }

  void Declarations() {
    if (Chance(50)) pieces_.push_back({"DDW 496 " + std::to_string(Below(25)), {}, ""});
    if (Chance(50)) pieces_.push_back({"DDW 498 " + std::to_string(Below(13)), {}, ""});
    for (uint32_t k = Below(6); k > 0; --k) {
      const uint32_t kind = Below(3);
      const uint32_t number = Chance(70) ? Below(24) : Below(490);
      std::string text = kind == 0 ? "DDB " + std::to_string(number) + " " + std::to_string(Below(256))
                         : kind == 1
                             ? "DDW " + std::to_string(number) + " " + Constant()
                             : "DDD " + std::to_string(number) + " " + std::to_string(random_.Next() & 0xFFFFFFFF);
      pieces_.push_back({std::move(text), {}, ""});
    }
  }

  // --- sequences ---------------------------------------------------------------------------------------------------

  void Neutral() {
    switch (Below(6)) {
      case 0:
        Line("NOP");
        break;
      case 1:
        Line(One(std::array{"L C ", "LD C "}) + CounterNumber());
        break;
      case 2:
        Line(One(std::array{"L T ", "LD T "}) + TimerNumber());
        break;
      case 3:
        Line("L");
        OperandLine("K " + Constant());
        break;
      default:
        Line("L " + ReadableData());
        break;
    }
  }

  void Compare() {
    Line(One(std::array{"!=", "><", "<", "<=", ">", ">="}));
    OperandLine(DataOrConstant());
  }

  void LogicOperation(uint32_t depth) {
    const uint32_t choice = Below(76 + habits_.percent_of_strings + habits_.percent_of_brackets);
    const uint32_t strings = 60 + habits_.percent_of_strings, brackets = strings + habits_.percent_of_brackets;
    if (choice < 60) {
      const std::string mnemonic = One(std::array{"A ", "AN ", "O ", "ON "});
      Line(mnemonic + ReadableBit());
      if (mnemonic[0] == 'O') string_open_ = false;
    } else if (choice < strings) {
      Line("O");
      string_open_ = true;
    } else if (choice < brackets && depth < habits_.most_depth) {
      const bool is_or = Chance(50);
      const bool outer = string_open_ && !is_or;
      string_open_ = false;
      Around(is_or ? "O(" : "A(", ")", [&] { Bracket(depth + 1); });
      string_open_ = outer;
    } else if (choice < brackets + 6) {
      Compare();
      string_open_ = false;
    } else {
      Neutral();
    }
  }

  void Bracket(uint32_t depth) {
    const uint32_t count = 1 + Below(4);
    const uint32_t sure = Below(count);
    for (uint32_t k = 0; k < count; ++k) {
      if (k == sure) {
        if (Chance(70)) {
          Line(One(std::array{"A ", "AN ", "O ", "ON "}) + ReadableBit());
        } else {
          Compare();
        }
      } else {
        LogicOperation(Chance(60) ? kNoMore : depth);
      }
    }
  }

  void End() {
    string_open_ = false;
    const std::string timer = "T " + TimerNumber();
    const std::string counter = "C " + CounterNumber();
    switch (WhichEnd()) {
      case 0:
        Line(One(std::array{"= ", "= ", "S ", "R "}) + WritableBit());
        break;
      case 1:
        Line(One(std::array{"CU ", "CD "}) + counter);
        break;
      case 2:
        Line("S " + counter);
        OperandLine(WordOr(Digits(3)));
        break;
      case 3:
        Line("R " + (Chance(50) ? counter : timer));
        break;
      case 4:
        Line(One(std::array{"SP ", "SE ", "SR ", "SS ", "SF "}) + timer);
        OperandLine(WordOr(std::to_string(Chance(habits_.long_times ? 20 : 80) ? Below(2) : Below(4)) + Digits(3)));
        break;
      case 5:
        Line("T " + WritableData());
        break;
      case 6:
        if (labels_ > 0) {
          const std::string jump = One(std::array{"JU ", "JC ", "JC ", "JC "});
          Line(jump + Label(Below(labels_)));
        } else {
          Line(Chance(80) ? "EMC" : "EM");
        }
        break;
      case 7:
        Call();
        break;
      default:
        FunctionCall();
        break;
    }
    if (Chance(2)) Line(Chance(75) ? "EMC" : "EM");
  }
  size_t WhichEnd() {
    uint32_t all = 0;
    for (const uint32_t weight : habits_.ends) all += weight;
    uint32_t left = Below(all);
    for (size_t kind = 0; kind < habits_.ends.size(); ++kind) {
      if (left < habits_.ends[kind]) return kind;
      left -= habits_.ends[kind];
    }
    return 0;
  }

  /// Upwards only, so that there is no ring.
  void Call() {
    std::vector<uint32_t> targets;
    for (const uint32_t number : subroutines_) {
      if (number > module_) targets.push_back(number);
    }
    if (targets.empty() || calls_ >= std::min(habits_.most_calls, subroutines_.size() > 5 ? 2u : 4u)) {
      Line("= " + WritableBit());
      return;
    }
    ++calls_;
    Line(One(std::array{"JU PM ", "JC PM ", "JC PM "}) +
         std::to_string(targets[Below(static_cast<uint32_t>(targets.size()))]));
  }

  std::string LongOperand(uint32_t width) { return Chance(8) ? "K " + Constant() : Field(width, true); }

  /// A field is its space and number, whatever its class (6.9).
  std::string AnyClass(std::string field) {
    const uint32_t last = field[0] == 'D' ? 999 : 255;
    if (Chance(50) && std::stoul(field.substr(3)) < last) field[1] = 'W';
    return field;
  }

  /// Index and offset of a variable of the control.
  void Variable() {
    OperandLine(Chance(50) ? "K " + std::to_string(Below(47)) : Chance(80) ? ReadableData() : Port(1 + Below(2), 24));
    OperandLine(Chance(50)   ? "K " + std::to_string(static_cast<int>(Below(6)) - 1)
                : Chance(80) ? ReadableData()
                             : Port(1 + Below(2), 24));
  }

  void FunctionCall() {
    static constexpr std::array<uint32_t, 65> kNumbers = {
        0,  0,  1,  1,  2,  2,  3,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12, 13, 14, 15, 16, 17,
        18, 30, 31, 32, 33, 34, 41, 42, 44, 51, 52, 54, 60, 61, 62, 63, 64, 65, 66, 70, 71, 72,
        73, 74, 75, 76, 77, 78, 80, 81, 81, 81, 81, 81, 6,  7,  8,  9,  10, 15, 16, 17, 18};
    uint32_t number = kNumbers[Below(kNumbers.size())];
    if (number == 81) number += Below(8);
    Line(One(std::array{"JU FM ", "JU FM ", "JC FM "}) + std::to_string(number));
    if (number <= 3) {
      if (number == 3 && Chance(80)) {
        OperandLine(Field(4, true));
      } else {
        OperandLine(number == 3 ? "K " + Constant() : DataOrConstant());
      }
      OperandLine(DataOrConstant());
      OperandLine(number < 2 ? WritableData() : Field(4, true));
    } else if (number >= 6 && number <= 10) {
      OperandLine(Chance(35)   ? "K " + (number <= 7 ? std::to_string(Below(18)) : Constant())
                  : Chance(70) ? ReadableData()
                               : Port(1 + Below(2), 24));
    } else if (number >= 15 && number <= 18) {
      const std::string base = AnyClass(Field(1, false));
      OperandLine(base);
      OperandLine(Displacement(base));
    } else if (number >= 41 && number <= 44) {
      Variable();
      OperandLine(AnyClass(Field(number - 40, true)));
    } else if (number >= 51 && number <= 54) {
      OperandLine(AnyClass(Field(number - 50, true)));
      Variable();
    } else if (number >= 60 || (number >= 30 && number <= 34)) {
      const bool quad = number == 62 || number == 63 || number == 32 || number == 33;
      const bool two = number == 34 || number == 70 || number >= 80 || (number >= 64 && number <= 66 && Chance(30));
      const bool one = number >= 71 && number <= 78;
      OperandLine(LongOperand(4));
      if (!one) OperandLine(LongOperand(4));
      if (!one && !two) OperandLine(LongOperand(quad ? 8 : 4));
    }
  }

  // --- modules -----------------------------------------------------------------------------------------------------

  void Module(uint32_t number, uint32_t size) {
    module_ = number;
    calls_ = 0;
    labels_ = Chance(30) ? 0 : Below(2 + size * habits_.labels_in_hundred / 100);
    string_open_ = false;
    uint32_t placed = 0;
    Around("MOD PM " + std::to_string(number), "END PM " + std::to_string(number), [&] {
      if (number == 0) Activate();
      for (uint32_t k = 0; k < size;) {
        if (!string_open_ && placed < labels_ && Below(size) < 3 * labels_) PlaceLabel(placed++);
        const uint32_t logic = Chance(12) ? 0 : 1 + Below(habits_.most_logic);
        for (uint32_t j = 0; j < logic; ++j) LogicOperation(0);
        const uint32_t ends = 1 + Below(habits_.most_ends);
        for (uint32_t j = 0; j < ends; ++j) End();
        k += logic + ends;
      }
      while (placed < labels_) PlaceLabel(placed++);
      for (uint32_t k = Chance(25) ? 3 : 0; k > 0; --k) LogicOperation(0);  // END folds, too
    });
  }

  void Activate() {
    Line("L");
    OperandLine("K " + std::to_string(Chance(60) ? 255 : Below(256)));
    Line("T FB 250");
    Line("L");
    OperandLine("K " + std::to_string(Chance(60) ? 255 : Below(256)));
    Line("T FB 251");
  }

  // --- scenario ----------------------------------------------------------------------------------------------------

  std::string Assignment() {
    const auto number = [](uint32_t n) { return std::to_string(n); };
    switch (Below(13)) {
      case 10:
        return "IB" + number(random_.Pick(habits_.bytes)) + ": " + number(Chance(50) ? 1u << Below(8) : Below(256));
      case 11:
        return One(std::array{"FB", "OB", "FB"}) + number(random_.Pick(habits_.bytes)) + ": " + number(Below(256));
      case 12: {
        const uint32_t at = std::min(random_.Pick(habits_.data), 998u);
        // Times and presets are BCD.
        static const std::vector<uint32_t> kWords = {0,      1,      9,      0x10,   0x999, 0x1003,
                                                     0x2001, 0x3001, 0x3999, 0xFFFF, 0x8000};
        return "DW" + number(at) + ": " + number(Chance(60) ? random_.Pick(kWords) : Below(65536));
      }
      case 8:
        return One(std::array{"DW", "FW", "IW"}) + number(Below(4)) + ": " + number(Below(65536));
      case 9:
        return One(std::array{"I 62.0: ", "F 221.7: ", "OB3: ", "I 45.3: ", "PB101: ", "DB700: "}) + number(Below(2));
      case 0:
        return "PB" + number(Below(24)) + ": " + number(Below(256));
      case 1:
        return "FB" + number(Below(4)) + ": " + number(Below(256));
      case 2:
        return "D" + std::string(Chance(50) ? "B" : "W") + number(Below(6)) + ": " + number(Below(256));
      case 3:
        return "DB" + number(496 + Below(8)) + ": " + number(Below(30));
      case 4:
        return One(std::array{"FB250: ", "FB251: "}) + number(Below(256));
      default:
        return "IB" + number(Below(4)) + ": " + number(Below(256));
    }
  }

  void Steps() {
    for (uint32_t k = 4 + Below(16); k > 0; --k) {
      std::string set;
      for (uint32_t j = Below(4); j > 0; --j) {
        const std::string assignment = Assignment();
        const bool twice = set.find(assignment.substr(0, assignment.find(':') + 1)) != std::string::npos;
        if (!twice) set += (set.empty() ? "" : ", ") + assignment;
      }
      if (!set.empty()) steps_.push_back("set: {" + set + "}");
      if (Chance(6))
        steps_.push_back(
            "force: {" +
            One(std::array{"FB1: 3", "DB3: 7", "IB0: 1", "F 221.7: 1", "DW4: 9999", "FW2: 4660", "IB1: 255"}) + "}");
      if (Chance(5)) {  // a place of this program's own
        const std::string place = Chance(60)
                                      ? One(std::array{"FB", "IB", "OB"}) + std::to_string(random_.Pick(habits_.bytes))
                                      : "DB" + std::to_string(random_.Pick(habits_.data));
        steps_.push_back("force: {" + place + ": " + std::to_string(Below(256)) + "}");
        if (Chance(50)) {
          steps_.push_back("run: {slow: 2}");
          steps_.push_back("release: [" + place + "]");
        }
      }
      if (Chance(6)) steps_.push_back("release: [FB1, DB3, DW4, IB0, IB1, FW2, F 221.7]");
      const uint32_t choice = Below(20);
      if (choice == 0) {
        steps_.push_back("power_cycle:");
      } else if (choice < 5) {
        steps_.push_back("run: {fast: " + std::to_string(1 + Below(3)) + "}");
      } else if (choice < 7 && habits_.long_times) {
        steps_.push_back(Chance(50) ? "run: {s: " + std::to_string(1 + Below(12)) + "}"
                                    : "run: {ms: " + std::to_string(1000 + Below(9000)) + "}");
      } else if (choice < 10) {
        steps_.push_back("run: {ms: " + std::to_string(1 + Below(Chance(80) ? 60 : 600)) + "}");
      } else {
        steps_.push_back("run: {slow: " + std::to_string(1 + Below(6)) + "}");
      }
    }
  }

  uint32_t instructions_;
  std::vector<Piece> pieces_;
  std::vector<Piece>* at_ = &pieces_;
  std::map<std::string, std::string> options_;
  std::vector<std::string> steps_;
  std::vector<uint32_t> subroutines_;
  std::string label_;                     // of the next line
  static constexpr uint32_t kNoMore = 8;  // no bracket fits in
  uint32_t m_functions_ = 0, texts_ = 0, menus_ = 0;
  uint32_t module_ = 0;
  uint32_t labels_ = 0;
  uint32_t calls_ = 0;
  bool string_open_ = false;
};

}  // namespace

RandomProgram MakeRandomProstep(Random& random, ProgramSize size, Spelling spelling) {
  const uint32_t instructions =
      size == ProgramSize::kLarge ? random.Between(150, 600) : random.Between(5, random.OneIn(4) ? 150 : 80);
  return ProstepGenerator(random, instructions, spelling).Run();
}

}  // namespace plcxx::reference
