#include "transpiler/sim/read_vcd.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace plcxx::sim {
namespace {

constexpr uint32_t kMostBits = 64;

struct Word {
  std::string_view text;
  uint32_t line = 0;
};

/// The words of the file, which white space separates.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}

  /// Empty at the end of the file.
  Word Next() {
    while (!rest_.empty() && IsSpace(rest_.front())) {
      if (rest_.front() == '\n') ++line_;
      rest_.remove_prefix(1);
    }
    size_t end = 0;
    while (end < rest_.size() && !IsSpace(rest_[end])) ++end;
    const Word word{rest_.substr(0, end), line_};
    rest_.remove_prefix(end);
    return word;
  }

 private:
  static bool IsSpace(char c) { return static_cast<unsigned char>(c) <= ' '; }
  std::string_view rest_;
  uint32_t line_ = 1;
};

template <class Number>
std::optional<Number> NumberOf(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// How many of its units make a millisecond, or the other way round.
struct TimeScale {
  uint64_t ms_per_unit = 1, units_per_ms = 1;
};

std::optional<TimeScale> TimeScaleOf(std::string_view text) {
  size_t digits = 0;
  while (digits < text.size() && text[digits] >= '0' && text[digits] <= '9') ++digits;
  const std::optional<uint64_t> number = NumberOf<uint64_t>(text.substr(0, digits));
  if (!number || (*number != 1 && *number != 10 && *number != 100)) return std::nullopt;
  const std::string_view unit = text.substr(digits);
  if (unit == "s") return TimeScale{.ms_per_unit = *number * 1000};
  if (unit == "ms") return TimeScale{.ms_per_unit = *number};
  uint64_t smaller = 1000;
  for (const std::string_view name : {"us", "ns", "ps", "fs"}) {
    if (unit == name) return TimeScale{.units_per_ms = smaller / *number};
    smaller *= 1000;
  }
  return std::nullopt;
}

struct Value {
  uint64_t bits = 0;
  bool is_known = true;
};

/// "0101x": bits that are left out on the left are 0, or unknown when the first one is.
std::optional<Value> VectorValue(std::string_view digits) {
  Value value;
  if (digits.empty()) return std::nullopt;
  for (const char c : digits) {
    const bool is_known = c == '0' || c == '1';
    if (!is_known && std::string_view("xXzZ").find(c) == std::string_view::npos) return std::nullopt;
    value.bits = value.bits << 1 | static_cast<uint64_t>(c == '1');
    value.is_known = value.is_known && is_known;
  }
  return value;
}

class Reader {
 public:
  explicit Reader(std::string_view text) : words_(text) {}

  std::variant<Vcd, VcdError> Read() {
    if (!Declarations() || !Changes()) return std::move(error_);
    return std::move(vcd_);
  }

 private:
  bool Fail(uint32_t line, std::string message) {
    error_ = {.line = line, .message = std::move(message)};
    return false;
  }

  bool Declarations() {
    for (;;) {
      const Word word = words_.Next();
      if (word.text.empty())
        return Fail(word.line, "the file ends before $enddefinitions: it is no VCD file, or cut off");
      if (!word.text.starts_with('$')) {
        return Fail(word.line,
                    "'" + std::string(word.text.substr(0, 20)) + "' where a declaration ($var, $scope ...) begins");
      }
      std::vector<Word> arguments;
      if (!Arguments(word, arguments)) return false;
      if (word.text == "$enddefinitions") return true;
      if (word.text == "$var" && !Variable(word, arguments)) return false;
      if (word.text == "$timescale" && !Scale(word, arguments)) return false;
    }
  }

  /// Up to "$end".
  bool Arguments(const Word& declaration, std::vector<Word>& arguments) {
    for (Word word = words_.Next(); word.text != "$end"; word = words_.Next()) {
      if (word.text.empty()) return Fail(declaration.line, std::string(declaration.text) + " has no $end");
      arguments.push_back(word);
    }
    return true;
  }

  bool Scale(const Word& declaration, const std::vector<Word>& arguments) {
    std::string text;
    for (const Word& word : arguments) text += word.text;
    const std::optional<TimeScale> scale = TimeScaleOf(text);
    if (!scale)
      return Fail(declaration.line, "'" + text + "' is no time scale: 1, 10 or 100 of s, ms, us, ns, ps or fs");
    scale_ = *scale;
    return true;
  }

  /// $var wire 8 code name [7:0] $end
  bool Variable(const Word& declaration, const std::vector<Word>& arguments) {
    constexpr size_t kWidth = 1, kCode = 2, kName = 3;
    const std::optional<uint32_t> width =
        arguments.size() > kName ? NumberOf<uint32_t>(arguments[kWidth].text) : std::nullopt;
    if (!width || *width == 0) return Fail(declaration.line, "$var without type, width, code and name");
    signals_of_[arguments[kCode].text].push_back(static_cast<uint32_t>(vcd_.signals.size()));
    vcd_.signals.push_back({.name = std::string(arguments[kName].text),
                            .width = *width,
                            .is_real = arguments.front().text == "real" || arguments.front().text == "realtime"});
    return true;
  }

  bool Changes() {
    for (Word word = words_.Next(); !word.text.empty(); word = words_.Next()) {
      const char kind = word.text.front();
      if (kind == '#') {
        if (!Time(word)) return false;
      } else if (word.text == "$comment") {
        std::vector<Word> text;
        if (!Arguments(word, text)) return false;
      } else if (kind == '$') {
        continue;  // $dumpvars, $dumpall, $dumpoff, $dumpon and their $end: what is between them are changes
      } else if (!Change(word)) {
        return false;
      }
    }
    return true;
  }

  bool Time(const Word& word) {
    const std::optional<uint64_t> units = NumberOf<uint64_t>(word.text.substr(1));
    if (!units) return Fail(word.line, "'" + std::string(word.text) + "' is no time");
    if (*units / scale_.units_per_ms > std::numeric_limits<uint64_t>::max() / scale_.ms_per_unit) {
      return Fail(word.line, "the time " + std::string(word.text) + " is beyond what can be counted");
    }
    const uint64_t time_ms = *units / scale_.units_per_ms * scale_.ms_per_unit;
    if (has_time_ && time_ms < vcd_.last_ms) return Fail(word.line, "the time goes back at " + std::string(word.text));
    if (!has_time_) vcd_.first_ms = time_ms;
    has_time_ = true;
    vcd_.last_ms = time_ms;
    return true;
  }

  /// "1!", "b0101 !", "r1.5 !"
  bool Change(const Word& word) {
    const char kind = word.text.front();
    const std::string_view digits = word.text.substr(1);
    std::string_view code;
    std::optional<Value> value;
    if (kind == 'b' || kind == 'B') {
      code = words_.Next().text;
      value = VectorValue(digits);
    } else if (kind == 'r' || kind == 'R') {
      code = words_.Next().text;
      if (const std::optional<double> real = NumberOf<double>(digits)) value = Value{std::bit_cast<uint64_t>(*real)};
    } else {
      code = digits;
      value = VectorValue(word.text.substr(0, 1));
    }
    if (!value) return Fail(word.line, "'" + std::string(word.text.substr(0, 40)) + "' is no change of a value");
    const auto signals = signals_of_.find(code);
    if (signals == signals_of_.end()) {
      return Fail(word.line, "'" + std::string(code.substr(0, 20)) + "' is the code of no $var");
    }
    for (const uint32_t signal : signals->second) {
      if (vcd_.signals[signal].width > kMostBits) continue;
      vcd_.changes.push_back(
          {.time_ms = vcd_.last_ms, .signal = signal, .value = value->bits, .is_known = value->is_known});
    }
    return true;
  }

  Words words_;
  Vcd vcd_;
  VcdError error_;
  TimeScale scale_;
  bool has_time_ = false;
  std::map<std::string_view, std::vector<uint32_t>> signals_of_;
};

}  // namespace

std::variant<Vcd, VcdError> ReadVcd(std::string_view text) { return Reader(text).Read(); }

}  // namespace plcxx::sim
