// Random networks of host50: instruction lists and drawings, all of them legal.
//
// Few addresses, so that rungs meet: both sides of the border of retentive memory, alarms, the signals of axes, the
// ends of every area. Two programs in three have addresses and a mixture of their own. Each timer number has a kind and
// a unit of its own (E501).
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/reference/awkward_names.h"
#include "tests/reference/random_program.h"

namespace plcxx::reference::host50_random {

using Texts = std::vector<std::string>;

enum class Section : uint8_t { kFast, kOther };
/// The subroutines that a section may call, and at how many places: each of them calls others, so that what is executed
/// is the product.
struct Callees {
  uint32_t first = 1, last = 0, most = 0;
};

class Networks {
 public:
  Networks(Random& random, Spelling spelling) : random_(random), is_plain_(spelling == Spelling::kPlain) {}

  /// What this program is like: its addresses, how deep, how many of each. Before anything else.
  void ChooseHabits(uint32_t channels);
  void UsePredefinedNames() { predefined_ = true; }
  /// Bits that a scenario may set, and words.
  const Texts& bits() const { return bits_; }
  const Texts& words() const { return words_; }
  const Texts& floats() const { return floats_; }

  void Begin(Section section, Callees callees) {
    section_ = section;
    callees_ = callees;
  }
  /// The network at a position among so many of its section, until so many instructions have been made.
  Piece Network(uint32_t position, uint32_t count, uint32_t wanted);
  /// The lines of the table of symbols that the networks use.
  std::vector<Piece> Symbols() const;
  uint32_t made() const { return made_; }
  /// One of several texts that mean the same; the first of them is the plain one. Both spellings draw alike.
  std::string Spelled(const Texts& any) {
    const std::string& chosen = random_.Pick(any);
    return is_plain_ ? any.front() : chosen;
  }
  /// A decimal number, with leading zeros or without.
  std::string Padded(uint32_t number) {
    const std::string text = std::to_string(number);
    return Spelled({text, text, text, "0" + text, std::string(4 - std::min<size_t>(3, text.size()), '0') + text});
  }

 private:
  // --- operands ---
  std::string Address(const std::string& address);
  std::string Bit();
  std::string Coil();
  std::string Whole();
  std::string WholeConstant();
  std::string WholeResult();
  std::string Real();
  std::string RealConstant();
  std::string RealResult();
  std::string Number() { return random_.OneIn(2) ? Whole() : Real(); }
  std::string Expression(uint32_t depth, bool whole_only);
  std::string Primary(uint32_t depth, bool whole_only);
  std::string Relation();
  std::string Plain(const std::string& operand) const;
  /// Or without; text in quotes has one line.
  std::string InQuotes(const std::string& text) {
    return Spelled({text, text, text.find('\n') == std::string::npos ? '"' + text + '"' : text});
  }
  std::string Comma() { return Spelled({", ", ",", " , ", ",\t"}); }

  // --- instruction lists ---
  void Line(const std::string& text);
  std::string Respelled(const std::string& text);
  std::string Edge(const std::string& plain);
  void Load();
  void Contacts(uint32_t depth);
  void Logic(uint32_t depth);
  void Rest(uint32_t depth);
  void Outputs();
  void Output();
  void Counter();
  void Rotation();
  Piece Rung();

  // --- blocks, as a list or a drawing has them ---
  std::string Timer();
  std::string Compare();
  std::string BlockWithoutQ();
  std::string Axis();
  std::string Pin(const std::string& name);

  // --- drawings (host50_random_drawings.cc) ---
  /// A part of a drawing: its rows, all of one width; it is entered at the left end of the first row.
  using Rows = std::vector<std::string>;
  Piece Drawing();
  static std::string OneLine(std::string text);
  std::string DrawnContact();
  std::string DrawnElement();
  std::string DrawnOutput();
  static Rows InSeries(const Rows& left, const Rows& right);
  static Rows InParallel(const Rows& upper, const Rows& lower);
  Rows Conducting(uint32_t depth, uint32_t elements);
  Rows Ending(uint32_t depth, uint32_t elements);

  /// first op part op part ...: the plain text has the brackets that precedence puts there.
  std::string Chain(Texts parts, Texts operators, const std::string& tighter) const;

  Random& random_;
  const bool is_plain_;
  Section section_ = Section::kOther;
  Callees callees_;
  std::vector<std::string> lines_;
  uint32_t made_ = 0;
  uint32_t position_ = 0, count_ = 1;

  // of this program
  struct NamedAddress {
    std::string address, name;
  };
  std::vector<NamedAddress> names_ = {{"%I0", "START"}, {"%B1", "axis4-"}, {"%Q0", "PUMP"}, {"%W1", "Count_1"},
                                      {"%F0", "speed"}, {"%TM1", "T_RUN"}, {"%C1", "TURNS"}};
  std::vector<uint32_t> timers_ = {0, 1, 2, 3, 4, 5, 6, 7, 8};
  Texts counters_ = {"%C0", "%C1", "%C100"};
  Texts bits_ = {"%I0",    "%I1",   "%I2",    "%I3",    "%I4", "%I199",  "%I500", "%I2000", "%Q0",
                 "%Q1",    "%Q400", "%Q1000", "%Q2000", "%B0", "%B1",    "%B499", "%B500",  "%B501",
                 "%B2000", "%TM0",  "%TM1.Q", "%TM2",   "%T3", "%TM4.Q", "%C0",   "%C1.Q",  "%C100"};
  Texts coils_ = {"%Q0", "%Q1", "%Q2", "%Q400", "%Q401", "%Q499", "%Q1000", "%Q2000",
                  "%B0", "%B1", "%B2", "%B499", "%B500", "%B501", "%B2000"};
  Texts words_ = {"%W0",  "%W1",  "%W2",    "%W100",  "%W101",  "%W300",  "%IW0",  "%IW110", "%IW300",
                  "%QW0", "%QW5", "%TM0.V", "%TM1.V", "%TM2.P", "%TM3.V", "%C0.V", "%C1.V",  "%C100.P"};
  Texts results_ = {"%W0", "%W1", "%W2", "%W100", "%W101", "%W300", "%QW0", "%QW5", "%IW0", "%C1.V"};
  Texts floats_ = {"%F0", "%F1", "%F100", "%F101", "%F300", "%IF0", "%IF300", "%QF0", "%QF10"};
  Texts float_results_ = {"%F0", "%F1", "%F100", "%F101", "%F300", "%QF0", "%QF10", "%IF0"};
  bool predefined_ = false;
  uint32_t deepest_ = 3, most_contacts_ = 2, most_outputs_ = 2;
  uint32_t one_drawing_in_ = 5, one_jump_in_ = 5, one_branch_in_ = 6, one_coil_in_ = 2;
};

}  // namespace plcxx::reference::host50_random
