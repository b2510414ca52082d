// Random programs as trees of text, so that one that shows a disagreement can be made small.
//
// A generator (one a dialect) makes a RandomProgram from the specification's grammar; Render makes files and a scenario
// of it. Everything follows from the seed, on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace plcxx::reference {

class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}

  uint64_t Next() {  // SplitMix64
    uint64_t z = state_ += 0x9E3779B97F4A7C15;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
    return z ^ (z >> 31);
  }
  /// 0 .. count-1.
  uint32_t Below(uint32_t count) { return static_cast<uint32_t>(Next() % count); }
  uint32_t Between(uint32_t least, uint32_t most) { return least + Below(most - least + 1); }
  bool OneIn(uint32_t count) { return Below(count) == 0; }
  template <class List>
  const typename List::value_type& Pick(const List& list) {
    return list[Below(static_cast<uint32_t>(list.size()))];
  }

 private:
  uint64_t state_;
};

/// Lines of a source. A piece with a body can be left out whole, or without what it puts around its body.
struct Piece {
  std::string text;
  std::vector<Piece> body;
  std::string end;
};

struct RandomFile {
  std::string name;
  std::vector<Piece> pieces;
  std::string head = {};        // bytes in front: a mark of the byte order
  std::string line_end = "\n";  // everywhere
  bool is_source = true;        // false: another file includes it
  std::string tail = {};        // bytes behind the last line end, which a control does not read
};

struct RandomProgram {
  std::vector<RandomFile> files;
  std::map<std::string, std::string> options;
  std::vector<std::string> steps;         // of the scenario, each one line: "set: {I0A3: 1}"
  std::optional<uint64_t> caprices = {};  // the control's (capricious_control.h); none: it is obliging
};

enum class ProgramSize : uint8_t { kSmall, kLarge };

/// Two texts of one program: from one seed, with the same draws. What differs is only what the language lets differ:
/// radix and leading zeros of numbers, case, blanks, comments, line ends, names for operands, brackets that precedence
/// makes superfluous. A reference shares the parser with the tool; that both texts mean the same shows the parser
/// right.
enum class Spelling : uint8_t { kAny, kPlain };

struct RenderedFile {
  std::string name, text;
};
/// The sources, and the scenario last.
std::vector<RenderedFile> Render(const RandomProgram& program, const std::string& dialect);

}  // namespace plcxx::reference
