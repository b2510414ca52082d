// Random programs of nc110, from the grammar (section 3) and the ranges (section 5) of the specification.
//
// Few addresses, so that statements meet: bits of one word, words of one pair, inputs, outputs, work memory, the ends
// of every package. Two programs in three have addresses and a mixture of their own (Habits). All of it is legal;
// warnings are no matter.

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "tests/reference/awkward_names.h"
#include "tests/reference/nc110_random_habits.h"
#include "tests/reference/nc110_reference.h"

namespace plcxx::reference {
namespace {

using Texts = std::vector<std::string>;

constexpr uint32_t kDeepestBlock = 9;

class Generator : Nc110Habits {
 public:
  Generator(Random& random, ProgramSize size, Spelling spelling)
      : random_(random), size_(size), is_plain_(spelling == Spelling::kPlain) {}

  RandomProgram Run() {
    Choose(random_);
    Options();
    if (program_.options.contains("nc-stub") || random_.OneIn(8)) {  // what the control answers (8.2)
      for (const uint32_t number : {10, 12, 17, 21, 22}) connectors_.push_back({'K', number});
      connectors_.push_back({'N', 10});
      bits_.insert(bits_.end(), {4, 18, 20});
    }
    Names();
    std::vector<Piece> pieces;
    const uint32_t statements =
        size_ == ProgramSize::kLarge ? random_.Between(150, 600) : random_.Between(3, random_.OneIn(4) ? 150 : 30);
    const bool has_mark = !random_.OneIn(12);
    const uint32_t fast = !has_mark ? statements : random_.OneIn(3) ? 0 : random_.Below(statements);
    while (made_ < fast) pieces.push_back(Item(1));
    if (has_mark) pieces.push_back({Spelled("$", {"$", "$ slow part U4A0=1", "$;"}), {}, ""});
    while (made_ < statements) {
      pieces.push_back(Item(1));
      if (has_mark && random_.OneIn(60)) pieces.push_back({"$ again, without effect", {}, ""});
    }
    Files(std::move(pieces));
    Steps();
    return std::move(program_);
  }

 private:
  // --- options, files ---

  void Options() {
    std::map<std::string, std::string>& options = program_.options;
    if (random_.OneIn(3)) options["slices"] = std::to_string(random_.Between(2, random_.OneIn(8) ? 64 : 5));
    if (random_.OneIn(6)) options["latch-slow-inputs"] = "on";
    if (random_.OneIn(3)) options["carry"] = random_.Pick(Texts{"input", "next"});
    if (random_.OneIn(4)) options["tim"] = std::to_string(random_.Between(1, random_.OneIn(8) ? 1000 : 7));
    if (random_.OneIn(4)) options["clo"] = random_.Pick(Texts{"5,1", "20,4", "1,1", "12,3", "100,50", "7,7", "997,1"});
    xor_first_ = random_.OneIn(5);
    if (xor_first_) options["xor-prec"] = "above-or";
    if (random_.OneIn(5)) options["old"] = "on";
    if (random_.OneIn(5))
      options["t-init"] = random_.Pick(Texts{"1=02", "1=05,2=01", "64=FF", "17=A0,03=0C", "3=1,4=1"});
    if (random_.OneIn(8)) options["processes"] = std::to_string(random_.Between(2, 5));
    if (random_.OneIn(12)) {
      options["nc-stub"] = "on";
      if (random_.OneIn(2)) options["stub-ms"] = random_.Pick(Texts{"0", "1", "35", "500"});
    }
    if (!options.contains("clo") && random_.OneIn(8)) {
      options["cycle_ms"] = random_.Pick(Texts{"2", "6", "25"});
      if (random_.OneIn(2)) options["slice_ms"] = random_.Pick(Texts{"1", "2"});
    }
    if (random_.OneIn(10)) options["extern"] = random_.Pick(Texts{"W60N2", "W100N1,I10N4"});
    if (random_.OneIn(12)) options["slices"] = "auto";
    if (random_.OneIn(12)) options["ladder-lint"] = "on";
    loops_ = random_.OneIn(3);
    if (loops_) options["enable-dow"] = "on";
  }

  /// A symbol file: names for some operands of each kind.
  void Names() {
    if (random_.OneIn(2)) return;
    Piece head{"* names of the machine", {}, ""};
    const auto name = [&](Texts& names, const std::string& operand) {
      static const Texts kStems = {"START", "stop", "Pump", "axis.x", "T#4", "9th", "@level", "door'open", "ready?"};
      const bool is_awkward = random_.OneIn(3);
      const std::string awkward = is_awkward ? awkward_.Next(random_) : "";
      const std::string word =
          awkward.empty() ? std::to_string(symbols_++) + random_.Pick(kStems) : awkward;  // 10 characters count
      head.text +=
          "\n" + word + (random_.OneIn(2) ? " = " : "=") + operand + (random_.OneIn(3) ? " ; of the machine" : "");
      names.push_back(is_plain_ ? operand : "!" + word);
    };
    for (uint32_t i = random_.Between(1, 4); i > 0; --i) name(input_names_, Bit('I'));
    for (uint32_t i = random_.Between(1, 4); i > 0; --i) name(output_names_, Bit('U'));
    for (uint32_t i = random_.Between(1, 4); i > 0; --i) name(word_names_, Word());
    for (uint32_t i = random_.Below(3); i > 0; --i) name(timer_names_, Timer() + "I");
    for (uint32_t i = random_.Below(3); i > 0; --i) name(counter_names_, Counter() + "I");
    if (random_.OneIn(2)) name(element_names_, Timer() + random_.Pick(Texts{"A", "U", "D"}));
    if (random_.OneIn(2)) name(element_names_, Counter() + random_.Pick(Texts{"R", "Z", "A"}));
    if (random_.OneIn(2)) name(element_names_, OneShot());
    if (random_.OneIn(2)) name(word_names_, Counter() + "W");
    for (const std::string& parameter : kParameters) {
      if (random_.OneIn(6)) name(parameter_names_, parameter);
    }
    program_.files.push_back({"names.sym", {std::move(head)}});
    LineEnds(program_.files.back());
  }

  void Files(std::vector<Piece> pieces) {
    const uint32_t count = random_.OneIn(2) ? 1 : random_.Between(2, random_.OneIn(6) ? 9 : 4);
    const size_t part = pieces.size() / count + 1;
    for (uint32_t i = 0; i < count; ++i) {
      RandomFile file{"part" + std::to_string(i) + ".plc", {{"; part of a machine", {}, ""}}};
      for (size_t p = i * part; p < std::min(pieces.size(), (i + 1) * part); ++p) file.pieces.push_back(pieces[p]);
      LineEnds(file);
      program_.files.push_back(std::move(file));
    }
  }

  /// What a control's editor leaves (2.1, 2.2).
  void LineEnds(RandomFile& file) {
    const std::string ends = Spelled("\n", {"\n", "\n", "\n", "\r\n", "\r"});
    const std::string head = Spelled("", {"", "", "", "\xEF\xBB\xBF"});
    const std::string tail = Spelled("", {"", "", "", "\x1A", "\x1AU4A0=", "; the end"});
    file.line_end = ends;
    file.head = head;
    file.tail = tail;
  }

  // --- spelling ---

  /// One of several texts that mean the same; the first one is the plain one. Both spellings draw alike.
  std::string Spelled(const std::string& plain, const Texts& any) {
    const std::string& chosen = random_.Pick(any);
    return is_plain_ ? plain : chosen;
  }
  std::string Braced(const std::string& text) const { return is_plain_ ? "(" + text + ")" : text; }
  /// first op part op part ...: the plain text has the brackets that section 4 puts there.
  std::string Chain(std::vector<std::string> parts, Texts operators, bool xor_first) const {
    const auto join = [&](size_t i) {
      parts[i] = Braced(parts[i] + operators[i] + parts[i + 1]);
      parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      operators.erase(operators.begin() + static_cast<std::ptrdiff_t>(i));
    };
    // A long chain stays as it is: 32 brackets may be open (6.1).
    if (!is_plain_ || operators.size() > 4) {
      std::string text = parts[0];
      for (size_t i = 0; i < operators.size(); ++i) text += operators[i] + parts[i + 1];
      return text;
    }
    for (size_t i = 0; xor_first && i < operators.size();) {
      if (operators[i] == "&") {
        join(i);
      } else {
        ++i;
      }
    }
    while (!operators.empty()) join(0);
    return parts[0];
  }

  // --- operands ---

  std::string Number(uint32_t n) {
    const std::string zero = random_.OneIn(12) ? "0" : "";
    return (n < 10 && !is_plain_ ? zero : "") + std::to_string(n);
  }

  Connector AnyConnector() { return random_.Pick(connectors_); }
  std::string Bit(char letter) {
    const Connector c = AnyConnector();
    return letter + Number(c.number) + c.package + Number(random_.Pick(bits_));
  }
  std::string Word() {
    const Connector c = AnyConnector();
    return "W" + Number(c.number) + c.package + Number(random_.Below(4));
  }
  /// Not at the end of a package. Most are the scenario's, which keeps them small; the program writes the others, too.
  std::string Pair() {
    if (!parameter_names_.empty() && random_.OneIn(3)) return random_.Pick(parameter_names_);
    if (!random_.OneIn(3)) return random_.Pick(kParameters);
    for (;;) {
      const Connector c = AnyConnector();
      const uint32_t index = random_.Below(4);
      const bool last = (c.package == 'A' && c.number == 31) || (c.package == 'T' && c.number == 15) || c.number == 255;
      if (!last || index != 3) return "W" + Number(c.number) + c.package + std::to_string(index);
    }
  }
  std::string Timer() { return "T" + Number(random_.Pick(timers_)); }
  std::string Counter() { return "C" + Number(random_.Pick(counters_)); }
  std::string OneShot() { return "P" + Number(random_.Pick(one_shots_)); }

  std::string Constant(uint32_t least, uint32_t most) {
    const uint32_t value =
        random_.OneIn(3) ? random_.Between(least, most) : random_.Between(least, std::min(most, least + 9));
    char text[16];
    switch (const uint32_t form = random_.Below(7); is_plain_ ? 6 : form) {
      case 0:
        std::snprintf(text, sizeof text, "0%XH", value);
        return text;
      case 1:
        std::snprintf(text, sizeof text, "%oO", value);
        return text;
      case 2:
        return std::to_string(value) + "D";
      case 3:
        return "0" + std::to_string(value);
      default:
        return std::to_string(value);
    }
  }

  // --- expressions ---

  /// What may stand between two tokens.
  std::string Gap() {
    if (!random_.OneIn(6)) return "";
    return Spelled("", {" ", "  ", "\t", "\n", "\f", " ; a remark\n ", "; \x8F\xE3\xE1\xAA\n", ";=\"U4A0\n;\n"});
  }
  std::string Infix(const Texts& operators) {
    std::string text = Gap();
    text += random_.Pick(operators);
    return text + Gap();
  }

  std::string SignalOperand() {
    if (!element_names_.empty() && random_.OneIn(12)) return random_.Pick(element_names_);
    if (!timer_names_.empty() && random_.OneIn(16)) return random_.Pick(timer_names_);
    switch (random_.Below(10)) {
      case 0:
        return Timer() + random_.Pick(Texts{"I", "A", "U", "D"});
      case 1:
        return Counter() + random_.Pick(Texts{"I", "R", "Z", "A"});
      case 2:
        return OneShot();
      case 3:
      case 4:
        return Bit('U');
      case 5:
        if (!input_names_.empty()) return random_.Pick(input_names_);
        return Bit('I');
      case 6:
        if (!output_names_.empty()) return random_.Pick(output_names_);
        return Bit('U');
      default:
        return Bit('I');
    }
  }

  std::string Literal() {
    std::string text = "\"" + random_.Pick(kLiterals) + "\"";
    return text;
  }

  std::string SignalPrimary(uint32_t depth) {
    if (depth == 0 || random_.OneIn(2)) return SignalOperand();
    switch (random_.Below(9)) {
      case 0:
        return random_.OneIn(2) ? "0" : "1";
      case 1:
        return Literal();
      case 2: {
        const bool bracket = random_.OneIn(2);
        const std::string inner = Arithmetic(depth - 1);
        return bracket ? "SGN[" + inner + "]" : "SGN (" + inner + ")";
      }
      case 3:
      case 4:
      case 5: {
        std::string text = "[" + CompareArgument(depth - 1);
        text += Infix({"<", "=", ">"});
        return text + CompareArgument(depth - 1) + "]";
      }
      default:
        return "(" + Signal(depth - 1) + ")";
    }
  }
  std::string SignalNot(uint32_t depth) {
    std::string nots = random_.OneIn(4) ? (random_.OneIn(5) ? "//" : "/") : "";
    if (is_plain_ && nots == "//") nots.clear();
    return nots + SignalPrimary(depth);
  }
  std::string SignalAnd(uint32_t depth) {
    return Repeated(std::min(most_terms_, depth == 0 ? 5u : 2u), {"*"}, [&] { return SignalNot(depth); });
  }
  std::string Signal(uint32_t depth) {
    // A long one has no long ones in its brackets: a statement has at most 1,024 operands.
    const uint32_t most = depth == 0 ? most_terms_ : std::min(most_terms_, 2u);
    return Repeated(most, {"+", "+", "&"}, [&] { return SignalAnd(depth); });
  }
  template <class Part>
  std::string Repeated(uint32_t most, const Texts& operators, Part&& part) {
    std::vector<std::string> parts = {part()};
    Texts between;
    for (uint32_t i = random_.Below(most + 1); i > 0; --i) {
      between.push_back(Infix(operators));
      parts.push_back(part());
    }
    return Chain(std::move(parts), std::move(between), xor_first_);
  }

  std::string WordOperand() {
    if (random_.OneIn(12)) return random_.Pick(Texts{"W51K0", "W2T0", "W50K0"});
    if (random_.OneIn(6)) return Counter() + "W";
    if (random_.OneIn(4) && !word_names_.empty()) return random_.Pick(word_names_);
    return Word();
  }
  std::string CompareArgument(uint32_t depth) {
    if (random_.OneIn(3)) return Constant(0, 255);
    if (depth > 0 && random_.OneIn(5)) return Function(depth - 1);
    return WordOperand();
  }
  std::string Function(uint32_t depth) {
    const std::string name = random_.Pick(Texts{"ENC", "DEC", "BCD", "BIN", "HIG", "LOW", "XCH", "ABS"});
    const std::string inner = depth > 0 && random_.OneIn(3) ? Function(depth - 1)
                              : name == "ABS"               ? Arithmetic(depth)
                                                            : WordExpression(depth);
    return name + Gap() + "(" + Gap() + inner + Gap() + ")";
  }
  std::string ArithmeticTerm(uint32_t depth) {
    if (depth > 0 && random_.OneIn(5)) return "(" + Arithmetic(depth - 1) + ")";
    if (depth > 0 && random_.OneIn(6)) return Function(depth - 1);
    return random_.OneIn(3) ? Constant(0, 255) : WordOperand();
  }
  std::string Arithmetic(uint32_t depth) {
    return Repeated(3, {"+", "-"}, [&] { return ArithmeticTerm(depth); });
  }
  std::string WordPrimary(uint32_t depth) {
    if (depth == 0 || random_.OneIn(2)) return random_.OneIn(3) ? Constant(0, 255) : WordOperand();
    switch (random_.Below(4)) {
      case 0:
        return "[" + Arithmetic(depth - 1) + "]";
      case 1:
        return "(" + WordExpression(depth - 1) + ")";
      default:
        return Function(depth - 1);
    }
  }
  std::string WordAnd(uint32_t depth) {
    std::string text = (random_.OneIn(5) ? "/" : "") + WordPrimary(depth);
    if (!random_.OneIn(4)) return text;
    text += Infix({"*"});
    const std::string twice = random_.OneIn(5) && !is_plain_ ? "//" : "";
    return Braced(text + twice + WordPrimary(depth));
  }
  std::string WordExpression(uint32_t depth) {
    return Repeated(2, {"+", "&"}, [&] { return WordAnd(depth); });
  }

  // --- items ---

  std::string Assignment() {
    ++made_;
    if (random_.OneIn(one_word_in_)) {
      const std::string target = random_.OneIn(6)                           ? Counter() + "W"
                                 : random_.OneIn(6) && !word_names_.empty() ? random_.Pick(word_names_)
                                                                            : Word();
      return target + Infix({"="}) + (random_.OneIn(4) ? Mux() : WordExpression(random_.Below(deepest_ + 1)));
    }
    std::string target = random_.OneIn(4) ? "/" : "";
    bool is_element = false;
    switch (random_.Below(most_kind_)) {
      case 0:
        target += !timer_names_.empty() && random_.OneIn(2) ? random_.Pick(timer_names_) : Timer() + "I";
        target += Gap() + "(" + (random_.OneIn(3) ? Pair() : Constant(1, 255)) + ")";
        is_element = true;
        break;
      case 1:
        target += !counter_names_.empty() && random_.OneIn(2) ? random_.Pick(counter_names_) : Counter() + "I";
        target += Gap() + "(" + (random_.OneIn(3) ? Pair() : Constant(2, 255)) + ")";
        is_element = true;
        break;
      case 2:
        target += random_.OneIn(3) ? Timer() + "A" : Counter() + random_.Pick(Texts{"Z", "A"});
        is_element = true;
        break;
      case 3:
        target += OneShot();
        is_element = true;
        break;
      case 4:
        target += output_names_.empty() ? Bit('U') : random_.Pick(output_names_);
        break;
      default:
        target += Bit('U');
        break;
    }
    // A long expression is seldom the same for long: elements also have one input of the machine.
    const uint32_t depth = is_element && !random_.OneIn(2) ? 0 : random_.Below(deepest_ + 1);
    if (is_element && random_.OneIn(2)) return target + Infix({"="}) + SignalNot(random_.Below(2));
    return target + Infix({"="}) + Signal(depth);
  }

  std::string Mux() {
    const uint32_t count = random_.Between(1, 8);
    std::string words, signals;
    for (uint32_t i = 0; i < count; ++i) {
      words += (i == 0 ? "" : ",") + (random_.OneIn(3)   ? Constant(0, 255)
                                      : random_.OneIn(6) ? WordExpression(1)
                                                         : WordOperand());
      signals += (i == 0 ? "" : ", ") + std::string(random_.OneIn(4) ? "/" : "") +
                 (random_.OneIn(6) ? "(" + Signal(1) + ")" : SignalOperand());
    }
    return "MUX(" + words + ")" + Gap() + "," + Gap() + "(" + signals + ")";
  }

  std::string Lower(std::string text) {
    for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return text;
  }

  Piece Item(uint32_t level) {
    if (level <= kDeepestBlock && random_.OneIn(one_block_in_ + (level == 1 ? 0 : 2))) return Blocks(level);
    std::string text = Assignment();
    if (random_.OneIn(15)) text += " " + Assignment();
    const std::string remark = " ; " + std::to_string(made_);
    text += Spelled("", {"", "", "", "", "", "", remark});
    // Names and texts keep their case; what has neither may be written small.
    if (random_.OneIn(10) && !is_plain_ && text.find_first_of("!\";") == std::string::npos) text = Lower(text);
    if (random_.OneIn(40)) text += "\n" + Message();
    return {text, {}, ""};
  }

  /// 9.7: a number once.
  std::string Message() {
    const std::string number = std::to_string(++messages_);
    if (messages_ > 255) return "; no further message";
    return "MSG " + number + random_.Pick(Texts{" \"door open\"", "=\"a;b\"", " = oil level, low", " U4A0 is not set"});
  }

  std::string BlockName() {
    if (!random_.OneIn(3)) return "";
    return random_.Pick(Texts{"0", "B11", "P1", "turret", "LongName1"});
  }

  std::vector<Piece> BlockBody(uint32_t level) {
    std::vector<Piece> body;
    if (is_deep_ && level < kDeepestBlock && !random_.OneIn(4)) body.push_back(Blocks(level + 1));
    for (uint32_t i = random_.Below(level > 2 ? 3 : most_in_block_ + 1); i > 0; --i) body.push_back(Item(level + 1));
    return body;
  }

  Piece Member(const std::string& head, const std::string& end, const std::string& condition, uint32_t level) {
    const std::string name = BlockName();
    made_ += 2;
    Piece member{head + (name.empty() ? "" : " " + name) + ":" + (condition.empty() ? "" : " " + condition),
                 BlockBody(level), end};
    const std::string again = " " + (name == "LongName1" ? "LongName2" : name);
    if (!name.empty()) member.end += Spelled("", {"", again});
    // An absent condition is known by what follows (3.4).
    if (condition.empty() && random_.OneIn(2)) {
      const std::string same_line = Assignment();
      if (head == "DOE") member.text += Spelled("\n", {"\n", " ", "\t"}) + same_line;
    }
    return member;
  }

  /// A chain of blocks, or a loop.
  Piece Blocks(uint32_t level) {
    if (loops_ && random_.OneIn(2)) {
      loops_ = false;  // one within another could take 255 * 255 passes
      Piece loop = Member("DOW", "ENDW", random_.OneIn(2) ? SignalNot(1) : Signal(1), level);
      loop.body.push_back({"W51K0=[W51K0+1]", {}, ""});  // counts the passes
      loops_ = true;
      return loop;
    }
    Piece chain = Member("DOF", Spelled("ENDF", {"ENDF", "ENDF", "END F", "END\tF"}), Signal(2), level);
    const uint32_t members = random_.OneIn(2) ? random_.Below(level > 2 ? 3 : most_members_ + 1) : 0;
    if (members == 0) return chain;
    Piece whole{"; a chain", {std::move(chain)}, ""};
    for (uint32_t i = 0; i < members; ++i) {
      const bool otherwise = i + 1 == members && random_.OneIn(2);
      whole.body.push_back(
          Member("DOE", Spelled("ENDE", {"ENDE", "ENDE", "END E"}), otherwise ? "" : Signal(1), level));
    }
    return whole;
  }

  // --- the scenario ---

  std::string Setting() {
    if (random_.OneIn(3)) {
      const std::string bit = Bit('I'), word = Word();
      return random_.OneIn(3) ? word + ": " + std::to_string(random_.Below(random_.OneIn(2) ? 256 : 5))
                              : bit + ": " + std::to_string(random_.Below(2));
    }
    static const Texts kInputs = {"I0A0", "I0A1", "I0A2", "I1A7",  "I0A8",  "I1A15", "I0A31",  "I0K0",
                                  "I3K1", "I9K2", "I0N0", "I10K0", "I10N4", "I26K1", "I31A31", "I157K0"};
    static const Texts kWords = {"W0A0",  "W1A1",  "W0K0",  "W3K3",  "W0T0",   "W0T1", "W1T0",
                                 "W40K0", "W40K3", "W41K0", "W15T3", "W255K3", "W0N1", "W60N2"};
    switch (random_.Below(15)) {
      case 14: {  // what only the control's own statements write otherwise
        const std::string value = ": " + std::to_string(random_.Below(2));
        return random_.OneIn(3) ? "P" + std::to_string(random_.Pick(one_shots_)) + value
               : random_.OneIn(3)
                   ? "C" + std::to_string(random_.Pick(counters_)) + "R" + value
                   : "T" + std::to_string(random_.Pick(timers_)) + random_.Pick(Texts{"I", "U", "D"}) + value;
      }
      case 12:
      case 13:
        return random_.Pick(kParameters) + ": " +
               std::to_string(random_.OneIn(8) ? random_.Below(256) : random_.Below(7));
      case 0:
        return "C" + std::to_string(random_.Pick(counters_)) + "W: " + std::to_string(random_.Below(256));
      case 1:
        return random_.OneIn(2) ? "T" + std::to_string(random_.Pick(timers_)) + "A: " + std::to_string(random_.Below(2))
                                : "C" + std::to_string(random_.Pick(counters_)) + random_.Pick(Texts{"A", "Z", "I"}) +
                                      ": " + std::to_string(random_.Below(2));
      case 2:
      case 3:
      case 4:
        return random_.Pick(kWords) + ": " + std::to_string(random_.OneIn(2) ? random_.Below(4) : random_.Below(256));
      default:
        return random_.Pick(kInputs) + ": " + std::to_string(random_.Below(2));
    }
  }

  std::string RunStep() {
    if (long_times_ && random_.OneIn(4)) {
      return random_.OneIn(2) ? "run: {s: " + std::to_string(random_.Between(1, 12)) + "}"
                              : "run: {ms: " + std::to_string(random_.Between(1000, 12000)) + "}";
    }
    switch (random_.Below(6)) {
      case 0:
        return "run: {fast: " + std::to_string(random_.Between(1, 4)) + "}";
      case 1:
        return "run: {ms: " + std::to_string(random_.Between(1, 45)) + "}";
      case 2:
        return random_.OneIn(2) ? "run: {ms: " + std::to_string(random_.Between(50, 600)) + "}" : "run: {slow: 1}";
      default:
        return "run: {slow: " + std::to_string(random_.Between(1, 5)) + "}";
    }
  }

  void Steps() {
    const uint32_t steps = size_ == ProgramSize::kLarge ? 30 : random_.Between(8, 30);
    for (uint32_t i = 0; i < steps; ++i) {
      for (uint32_t sets = random_.Below(4); sets > 0; --sets) program_.steps.push_back("set: {" + Setting() + "}");
      if (random_.OneIn(12))
        program_.steps.push_back("set: {OPERATOR_TEXT: '" + (random_.OneIn(8) ? kTooLong : random_.Pick(kLiterals)) +
                                 "'}");
      if (random_.OneIn(25)) program_.steps.push_back("force: {" + Setting() + "}");
      if (random_.OneIn(25)) program_.steps.push_back("release: [I0A0, W1A1, W40K0, I0A1, C5W, T3A]");
      if (random_.OneIn(25)) program_.steps.push_back("power_cycle: {}");
      program_.steps.push_back(RunStep());
    }
  }

  inline static const Texts kParameters = {"W2T0", "W2T2", "W50K0", "W50K3", "W100N1", "W22A1"};
  inline static const Texts kLiterals = {"OK", "ok", "TOOL 4", "a;b$c!d", "12345678901234567890123456789012", " "};
  inline static const std::string kTooLong = "12345678901234567890123456789012+";

  Random& random_;
  ProgramSize size_;
  RandomProgram program_;
  const bool is_plain_;
  Texts input_names_, output_names_, word_names_, timer_names_, counter_names_, element_names_, parameter_names_;
  AwkwardNames awkward_;
  uint32_t symbols_ = 0, made_ = 0, messages_ = 0;
  bool loops_ = false, xor_first_ = false;
};

}  // namespace

RandomProgram RandomNc110(Random& random, ProgramSize size, Spelling spelling) {
  return Generator(random, size, spelling).Run();
}

}  // namespace plcxx::reference
