// Characters above 7EH: look-alike letters, pictures and names of code points.
#include <array>

#include "transpiler/dialects/nc110/source/lexer.h"

namespace plcxx::nc110 {
namespace {

struct LookAlikeLetter {
  char32_t cyrillic;
  char latin;
};

// The 3 is reported as the others, but never mapped: digits do not turn into letters or back.
constexpr std::array kLookAlikes = {
    LookAlikeLetter{0x410, 'A'}, LookAlikeLetter{0x412, 'B'}, LookAlikeLetter{0x421, 'C'}, LookAlikeLetter{0x415, 'E'},
    LookAlikeLetter{0x41D, 'H'}, LookAlikeLetter{0x406, 'I'}, LookAlikeLetter{0x41A, 'K'}, LookAlikeLetter{0x41C, 'M'},
    LookAlikeLetter{0x41E, 'O'}, LookAlikeLetter{0x420, 'P'}, LookAlikeLetter{0x422, 'T'}, LookAlikeLetter{0x425, 'X'},
    LookAlikeLetter{0x423, 'Y'}, LookAlikeLetter{0x417, '3'}, LookAlikeLetter{0x430, 'a'}, LookAlikeLetter{0x432, 'b'},
    LookAlikeLetter{0x441, 'c'}, LookAlikeLetter{0x435, 'e'}, LookAlikeLetter{0x43D, 'h'}, LookAlikeLetter{0x456, 'i'},
    LookAlikeLetter{0x43A, 'k'}, LookAlikeLetter{0x43C, 'm'}, LookAlikeLetter{0x43E, 'o'}, LookAlikeLetter{0x440, 'p'},
    LookAlikeLetter{0x442, 't'}, LookAlikeLetter{0x445, 'x'}, LookAlikeLetter{0x443, 'y'}, LookAlikeLetter{0x437, '3'}};

}  // namespace

char LatinFor(char32_t letter) {
  for (const LookAlikeLetter& row : kLookAlikes) {
    if (row.cyrillic == letter) {
      return row.latin;
    }
  }
  return '\0';
}

std::string Picture(std::string_view text, source::CodePoint point) {
  const bool control = point.value < 0x20 || (point.value >= 0x7F && point.value < 0xA0);
  return control ? "without a picture" : "'" + std::string(text.substr(0, point.length)) + "'";
}

bool IsNameCharacter(char c) {
  return IsLetter(c) || IsDigit(c) || c == '@' || c == '#' || c == '.' || c == '\'' || c == '?';
}

HomoglyphReader::Outcome HomoglyphReader::Read(std::string_view text, source::Offset begin, std::string& mapped) {
  struct Found {
    source::Range range;
    std::string letter;
    char32_t value;
    char latin;
  };
  std::vector<Found> found;
  mapped.clear();
  for (uint32_t at = 0; at < text.size();) {
    const source::CodePoint point = source::FirstCodePoint(text.substr(at));
    const source::Range range = {begin + at, begin + at + point.length};
    char latin = static_cast<char>(point.value);
    if (point.value >= 0x80) {
      latin = LatinFor(point.value);
      if (latin == '\0') {
        diagnostics_.Report(range, diag::Nc110UnknownCharacter, Picture(text.substr(at), point),
                            source::CodePointName(point.value));
        mapped.clear();
        return Outcome::kReported;
      }
      found.push_back({range, std::string(text.substr(at, point.length)), point.value, latin});
    }
    mapped += latin;
    at += point.length;
  }
  const Found* rejected = nullptr;
  for (const Found& letter : found) {
    if (mode_ == Homoglyphs::kReject || letter.latin == '3') {
      rejected = &letter;
      break;
    }
  }
  if (rejected != nullptr) {
    diag::Diagnostic& report =
        diagnostics_.Report(rejected->range, diag::Nc110Homoglyph, rejected->letter,
                            source::CodePointName(rejected->value), std::string_view(&rejected->latin, 1));
    for (const Found& letter : found) {
      report.fixits.push_back({letter.range, std::string(1, letter.latin)});
    }
    return Outcome::kReported;
  }
  if (!warned_) {
    warned_ = true;
    const Found& first = found.front();
    diagnostics_.Report(first.range, diag::Nc110HomoglyphsMapped, first.letter, source::CodePointName(first.value),
                        std::string_view(&first.latin, 1));
  }
  return Outcome::kMapped;
}

}  // namespace plcxx::nc110
