// Method. Each candidate encoding is asked how surprising the text would be, in half bits, if it were meant so:
// letters by the letter before them (Russian words are far from random), changes between small and capital letters
// inside a word, frames that touch letters, symbols that hardly anybody writes. The least surprising reading wins.
// CP1251 and KOI8-R differ mainly in the case and the order of the letters, which is why single letters are not enough.
// The fallback wins unless another reading is clearly less surprising: a lone degree sign is no evidence.
#include "transpiler/source/detect.h"

#include <array>
#include <cstdint>

#include "transpiler/source/decode.h"

namespace plcxx::source {
namespace {

constexpr Encoding kCandidates[] = {Encoding::kCp866, Encoding::kCp1251, Encoding::kKoi8R};

/// More bytes above 7FH than these do not change the answer, but cost time.
constexpr size_t kEnough = 16384;

constexpr std::string_view kSurprise[] = {
#define PLCXX_LETTER_ROW(columns) columns,
#include "transpiler/source/russian_letters.def"
#undef PLCXX_LETTER_ROW
};
constexpr size_t kLetters = 32;
constexpr size_t kWordBegin = 0;       // row
constexpr size_t kWordEnd = kLetters;  // column
static_assert(std::size(kSurprise) == kLetters + 1);

// Costs in half bits.
constexpr int kFallbackBonus = 4;
constexpr int kKoi8Handicap = 6;        // rare on machine tools: very short texts are hardly ever KOI8-R
constexpr int kCapitalThenSmall = 2;    // at the beginning of a word, as a sentence begins
constexpr int kCapitalsThenSmall = 12;  // later in a word
constexpr int kSmallThenCapital = 16;
constexpr int kThirdOfTheSame = 16;  // no word has a letter three times in a row; frames have
constexpr int kBesideLatin = 8;      // a word that goes on from Latin into Russian letters or back
constexpr int kFirstOfFrame = 18;
constexpr int kNextOfFrame = 22;  // frames are mostly long lines of the same
constexpr int kSameOfFrame = 2;
constexpr int kFrameBesideLetter = 14;
constexpr int kUsualSymbol = 20;
constexpr int kUnusualSymbol = 36;
constexpr int kUndefinedByte = 40;

enum class Kind : uint8_t { kOther, kLatin, kSmall, kCapital, kFrame, kUsual, kUnusual, kUndefined };

struct Meaning {
  Kind kind = Kind::kOther;
  uint8_t letter = 0;  // from 0; small and capital letters have the same
};

using Meanings = std::array<Meaning, 256>;

Meaning MeaningOf(char16_t unit) {
  constexpr std::u16string_view kUsualSymbols = u"№°«»–—„“”…·±§";
  if (unit == u'ё') return {Kind::kSmall, u'е' - u'а'};
  if (unit == u'Ё') return {Kind::kCapital, u'е' - u'а'};
  if (unit >= u'а' && unit <= u'я') return {Kind::kSmall, static_cast<uint8_t>(unit - u'а')};
  if (unit >= u'А' && unit <= u'Я') return {Kind::kCapital, static_cast<uint8_t>(unit - u'А')};
  if (unit >= 0x2500 && unit <= 0x259F) return {Kind::kFrame};
  if (unit == 0xFFFD) return {Kind::kUndefined};
  return {kUsualSymbols.find(unit) != std::u16string_view::npos ? Kind::kUsual : Kind::kUnusual};
}

Meanings MeaningsOf(Encoding encoding) {
  Meanings meanings;
  for (char c = 'a'; c <= 'z'; ++c) {
    meanings[static_cast<uint8_t>(c)].kind = Kind::kLatin;
    meanings[static_cast<uint8_t>(c - 'a' + 'A')].kind = Kind::kLatin;
  }
  const std::array<char16_t, 128>& upper = UpperHalf(encoding);
  for (size_t i = 0; i < upper.size(); ++i) meanings[0x80 + i] = MeaningOf(upper[i]);
  return meanings;
}

/// Adds up the surprise of one reading, byte by byte.
class Reading {
 public:
  explicit Reading(Encoding encoding) : meanings_(MeaningsOf(encoding)) {}

  void Add(unsigned char byte) {
    const Meaning now = meanings_[byte];
    const bool letter = IsLetter(now.kind);
    if (!letter) EndWord(now.kind);
    switch (now.kind) {
      case Kind::kSmall:
      case Kind::kCapital:
        AddLetter(now);
        break;
      case Kind::kFrame:
        cost_ += before_.kind != Kind::kFrame ? kFirstOfFrame : byte == byte_before_ ? kSameOfFrame : kNextOfFrame;
        break;
      case Kind::kUsual:
        cost_ += kUsualSymbol;
        break;
      case Kind::kUnusual:
        cost_ += kUnusualSymbol;
        break;
      case Kind::kUndefined:
        cost_ += kUndefinedByte;
        break;
      case Kind::kLatin:
      case Kind::kOther:
        break;
    }
    before_ = now;
    byte_before_ = byte;
  }

  int64_t Finish() {
    EndWord(Kind::kOther);
    return cost_;
  }

 private:
  static bool IsLetter(Kind kind) { return kind == Kind::kSmall || kind == Kind::kCapital; }
  static int Surprise(size_t row, size_t column) { return kSurprise[row][column] - 'a'; }

  void AddLetter(Meaning now) {
    cost_ += Surprise(length_ == 0 ? kWordBegin : before_.letter + 1u, now.letter);
    if (length_ == 0) {
      if (before_.kind == Kind::kLatin) cost_ += kBesideLatin;
      if (before_.kind == Kind::kFrame) cost_ += kFrameBesideLetter;
    } else if (before_.kind != now.kind) {
      cost_ += now.kind == Kind::kCapital ? kSmallThenCapital : length_ == 1 ? kCapitalThenSmall : kCapitalsThenSmall;
    }
    same_ = length_ != 0 && before_.letter == now.letter ? same_ + 1 : 1;
    if (same_ >= 3) cost_ += kThirdOfTheSame;
    ++length_;
  }

  void EndWord(Kind next) {
    if (length_ == 0) return;
    cost_ += Surprise(before_.letter + 1u, kWordEnd);
    if (next == Kind::kLatin) cost_ += kBesideLatin;
    if (next == Kind::kFrame) cost_ += kFrameBesideLetter;
    length_ = 0;
  }

  Meanings meanings_;
  Meaning before_;
  unsigned char byte_before_ = 0;
  size_t length_ = 0;  // of the Russian word so far
  int same_ = 0;
  int64_t cost_ = 0;
};

/// The text up to where there is enough evidence.
std::string_view Evidence(std::string_view bytes) {
  size_t high = 0;
  for (size_t i = 0; i < bytes.size(); ++i) {
    if (static_cast<unsigned char>(bytes[i]) >= 0x80 && ++high > kEnough) return bytes.substr(0, i);
  }
  return bytes;
}

int64_t Surprise(std::string_view bytes, Encoding encoding) {
  Reading reading(encoding);
  for (const char c : bytes) reading.Add(static_cast<unsigned char>(c));
  return reading.Finish();
}

}  // namespace

Encoding DetectEightBit(std::string_view bytes, Encoding fallback) {
  const std::string_view evidence = Evidence(bytes);
  Encoding best = fallback;
  int64_t least = fallback == Encoding::kUtf8 ? INT64_MAX : Surprise(evidence, fallback) - kFallbackBonus;
  for (const Encoding candidate : kCandidates) {
    if (candidate == fallback) continue;
    const int handicap = candidate == Encoding::kKoi8R ? kKoi8Handicap : 0;
    const int64_t surprise = Surprise(evidence, candidate) + handicap;
    if (surprise < least) {
      best = candidate;
      least = surprise;
    }
  }
  return best;
}

}  // namespace plcxx::source
