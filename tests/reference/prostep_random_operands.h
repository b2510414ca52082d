// Operands for random programs of dialect prostep: constants, bits, fields, ports.
//
// Each program has few addresses, so that its statements meet, but every program has its own (Habits): those at the
// start of a space, or any, with the last ones of each space among them; likewise timers and counters. How often it
// jumps, calls, counts or nests is the program's own, too: a mixture that is the same everywhere never has much of
// one thing.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/reference/random_program.h"

namespace plcxx::reference {

/// What one program is like.
struct ProstepHabits {
  std::vector<uint32_t> bytes = {0, 1, 2, 3, 4};    // of I, O and F
  std::vector<uint32_t> data = {0, 1, 2, 3, 4, 5};  // of D
  std::vector<uint32_t> timers = {0, 1, 2, 3, 4, 5, 63}, counters = {0, 1, 2, 3, 4, 63};
  uint32_t percent_of_borders = 20;  // of the accesses: at the ends of a space
  uint32_t percent_of_brackets = 12, percent_of_strings = 12;
  uint32_t most_depth = 8;
  uint32_t most_logic = 5, most_ends = 3;                          // operations of a sequence
  uint32_t labels_in_hundred = 8;                                  // instructions
  uint32_t most_calls = 2;                                         // of a module
  std::array<uint32_t, 9> ends = {26, 8, 4, 4, 12, 10, 8, 5, 26};  // by kind: ProstepGenerator::End
  bool long_times = false;                                         // timers of seconds, and runs that let them end
};

class ProstepOperands {
 public:
  ProstepOperands(Random& random, Spelling spelling) : random_(random), is_plain_(spelling == Spelling::kPlain) {}

 protected:
  uint32_t Below(uint32_t n) { return random_.Below(n); }
  bool Chance(uint32_t percent) { return Below(100) < percent; }
  template <size_t N>
  std::string One(const std::array<const char*, N>& texts) {
    return texts[Below(N)];
  }
  /// One of several texts that mean the same; the first of them is the plain one. Both spellings draw alike.
  std::string Spelled(const std::vector<std::string>& any) {
    const std::string& chosen = random_.Pick(any);
    return is_plain_ ? any.front() : chosen;
  }

  /// One program in three is of the kind that it always was; the others have addresses and a mixture of their own.
  void ChooseHabits() {
    if (Chance(33)) return;
    const auto some = [&](std::vector<uint32_t>& numbers, uint32_t size, uint32_t most) {
      numbers.clear();
      for (uint32_t k = 2 + Below(most); k > 0; --k) {
        numbers.push_back(Chance(25) ? size - 1 - Below(4) : Chance(25) ? Below(4) : Below(size));
      }
    };
    if (Chance(70)) some(habits_.bytes, 256, 6);
    if (Chance(70)) some(habits_.data, 1000, 8);
    if (Chance(50)) some(habits_.timers, 64, 6);
    if (Chance(50)) some(habits_.counters, 64, 5);
    habits_.percent_of_borders = Below(40);
    habits_.percent_of_brackets = Below(30);
    habits_.percent_of_strings = Below(30);
    habits_.most_depth = 1 + Below(8);
    habits_.most_logic = 1 + Below(12);
    habits_.most_ends = 1 + Below(6);
    habits_.labels_in_hundred = Below(30);
    habits_.most_calls = Below(5);
    for (uint32_t& weight : habits_.ends) weight = Chance(25) ? 0 : Below(40);
    habits_.ends[Chance(50) ? 0 : 8] += 5;
    habits_.long_times = Chance(20);
  }

  /// The same sixteen bits.
  std::string Number(uint32_t value) {
    const std::string text = std::to_string(value);
    std::vector<std::string> forms = {text, text, "00" + text, "0" + Hex(value) + "H"};
    if (value >= 32768) forms.push_back("-" + std::to_string(65536 - value));
    if (Hex(value).find_first_of("ABCDEF") == std::string::npos && value != 0) forms.push_back(Hex(value) + "D");
    return Spelled(forms);
  }
  static std::string Hex(uint32_t value) {
    std::string text;
    for (; value != 0; value >>= 4) text.insert(text.begin(), "0123456789ABCDEF"[value & 15]);
    return text.empty() ? "0" : text;
  }

  std::string Constant() {
    switch (Below(6)) {
      case 0:
        return Number(Below(20));
      case 1:
        return "-" + std::to_string(1 + Below(Chance(50) ? 20 : 32768));
      case 2:
        return Number(Below(65536));
      case 3:
        return One(std::array{"0", "1", "32767", "-32768", "65535", "255", "256", "9999", "10000", "0FFH", "8000H"});
      case 4:
        return std::to_string(Below(10000)) + "D";
      default: {
        constexpr std::string_view kDigits = "0123456789ABCDEF";
        std::string text = "0";
        for (uint32_t k = Below(4) + 1; k > 0; --k) text += kDigits[Below(16)];
        return text + "H";
      }
    }
  }

  std::string Bit() {
    if (Chance(3)) return One(std::array{"F 250.", "F 251."}) + std::to_string(Below(8));
    // What the control writes and reads: time, keys, messages, axes.
    if (Chance(4)) {
      return One(std::array{"I 20.0", "I 20.1", "I 20.7", "I 62.0", "O 106.7", "F 221.7", "O 100.0", "F 222.0",
                            "I 21.0", "O 64.3"});
    }
    const uint32_t byte =
        Chance(92) ? random_.Pick(habits_.bytes) : random_.Pick(std::vector<uint32_t>{20, 44, 47, 213, 220, 254, 255});
    return One(std::array{"I ", "O ", "F ", "F "}) + std::to_string(byte) + "." + std::to_string(Below(8));
  }
  std::string CounterNumber() { return std::to_string(random_.Pick(habits_.counters)); }
  std::string TimerNumber() { return std::to_string(random_.Pick(habits_.timers)); }

  std::string ReadableBit() {
    switch (Below(12)) {
      case 0:
        return "C " + CounterNumber();
      case 1:
        return "T " + TimerNumber();
      case 2:
        return Chance(40) ? "P " + std::to_string(Below(24)) + "." + std::to_string(Below(8)) : Bit();
      default:
        return Bit();
    }
  }
  std::string WritableBit() {
    return Chance(6) ? "P " + std::to_string(Below(12)) + "." + std::to_string(Below(8)) : Bit();
  }

  /// `width` bytes of a space; near its ends now and then.
  std::string Field(uint32_t width, bool borders_matter) {
    const uint32_t space = Below(5);
    if (space < 3) {
      const uint32_t last = 256 - width;
      uint32_t number = random_.Pick(habits_.bytes);
      if (Chance(habits_.percent_of_borders)) number = Chance(50) ? last - Below(3) : Below(last + 1);
      number = std::min(number, last);
      return std::string(1, "IOF"[space]) + (Chance(50) || width == 1 ? "B " : Wide(number, 255)) +
             std::to_string(number);
    }
    uint32_t number = 0;
    do {
      switch (Below(100) < 2 * habits_.percent_of_borders ? Below(2) : 2) {
        case 0:
          number = 490 + Below(20);
          break;
        case 1:
          number = 1000 - width - Below(4);
          break;
        default:
          number = std::min(random_.Pick(habits_.data) + (Chance(10) ? width : 0), 1000 - width);
          break;
      }
      if (borders_matter && number < 500 && number + width > 500) number = Chance(50) ? 500 : 500 - width;
    } while (borders_matter && number < 500 && number + width > 500);
    return "D" + (Chance(50) || width == 1 ? "B " : Wide(number, 999)) + std::to_string(number);
  }
  /// A word operand unless the number is the last byte of the space.
  static std::string Wide(uint32_t number, uint32_t last) { return number < last ? "W " : "B "; }

  std::string Data(uint32_t width) {
    std::string text = Field(width, false);
    if (width == 1 || text[1] == 'W') return text;
    text[1] = 'W';  // Field has left room for `width` bytes
    return text;
  }
  std::string Port(uint32_t width, uint32_t count) {
    const uint32_t number = Chance(70) ? Below(count - width + 1) : 100 + Below(33 - width);
    return std::string(width == 1 ? "PB " : "PW ") + std::to_string(number);
  }
  std::string ReadableData() {
    const uint32_t width = 1 + Below(2);
    return Chance(8) ? Port(width, 24) : Data(width);
  }
  std::string WritableData() {
    const uint32_t width = 1 + Below(2);
    return Chance(6) ? Port(width, 12) : Data(width);
  }
  std::string DataOrConstant() { return Chance(40) ? "K " + Constant() : ReadableData(); }

  std::string Digits(uint32_t count) {
    std::string text;
    for (; count > 0; --count) text += static_cast<char>('0' + (Chance(50) ? 0 : Below(10)));
    return text + "D";
  }
  std::string WordOr(const std::string& constant) {
    return Chance(65) ? "K " + constant : Chance(5) ? Port(2, 24) : Data(2);
  }
  /// What has just been reached at the end of its space, and what has just not.
  std::string Displacement(const std::string& base) {
    const uint32_t size = base[0] == 'D' ? 1000 : 256;
    const int number = std::stoi(base.substr(base.find(' ') + 1));
    switch (Below(6)) {
      case 0:
        return "K " + std::to_string(static_cast<int>(size) - number - static_cast<int>(Below(4)));
      case 1:
        return "K " + std::to_string(static_cast<int>(Below(3)) - number - 1);
      case 2:
        return "K " + std::to_string(static_cast<int>(Below(24)) - 8);
      case 3:
        return Chance(30) ? Port(1 + Below(2), 24) : ReadableData();
      default:
        return DataOrConstant();
    }
  }

  Random& random_;
  const bool is_plain_;
  ProstepHabits habits_;
};

}  // namespace plcxx::reference
