#include "transpiler/dialects/prostep/parser/declaration_reader.h"

#include <algorithm>
#include <array>

#include "transpiler/source/decode.h"

namespace plcxx::prostep {
namespace {

constexpr uint32_t kStaticBits = 24;
constexpr uint32_t kDynamicBits = 16;
constexpr uint32_t kMenuTexts = 20;
constexpr size_t kMessageLength = 40;
constexpr size_t kMenuTextLength = 14;  // two rows of seven
constexpr uint32_t kMostOutputBytesDeclared = 20;
constexpr uint8_t kAlwaysAfterMove[] = {0, 1, 2, 5, 30};

size_t CountCharacters(std::string_view text) {
  return static_cast<size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

bool IsInMazovia(char32_t character) {
  if (character < 0x80) return true;
  const auto& upper = source::UpperHalf(source::Encoding::kMazovia);
  return character <= 0xFFFF && std::ranges::find(upper, static_cast<char16_t>(character)) != upper.end();
}

std::string_view RangeOfValue(uint32_t bytes) {
  if (bytes == 1) return "a byte is -128 to 255, 0FFH, two BCD digits";
  if (bytes == 2) return "a word is -32768 to 65535, 0FFFFH, four BCD digits";
  return "a double word is -2147483648 to 4294967295, 0FFFFFFFFH, eight BCD digits";
}

}  // namespace

void DeclarationReader::TakeDeclaration(const LexedFile& lexed, const Line& line) {
  std::vector<Token> tokens;
  Token comment;
  for (uint32_t i = 0; i < line.tokens.count; ++i) {
    const Token& token = lexed.tokens[line.tokens.first + i];
    if (token.kind == TokenKind::kComment) {
      comment = token;
    } else {
      tokens.push_back(token);
    }
  }
  const source::Range range = {tokens.front().range.begin, tokens.back().range.end};
  const std::string word = UpperOf(tokens.front());
  Span comments;
  if (now_.waiting.found < now_.waiting.most) {
    // Between an instruction and its operand lines: all comments are the instruction's.
    if (comment.range.end > comment.range.begin) comments_.AddComment(comment.range, CommentPlace::kLeading);
  } else {
    comments = comments_.TakeComments();
    comments_.AttachTrailing(comments, comment);
  }
  if (now_.seen_module) {
    const source::Range name = {tokens[0].range.begin, tokens[1].range.end};
    diagnostics_.Report(name, diag::ProstepDeclarationLate, word + " " + std::string(TextOf(tokens[1])));
  }
  if (std::ranges::any_of(tokens, &Token::faulty)) return;
  if (word == "DMF") return DeclareMFunction(tokens, range, comments);
  if (word == "DM" || word == "DT") return DeclareText(word, tokens, range, comments);
  DeclareData(word, tokens, range, comments);
}

void DeclarationReader::DeclareData(std::string_view word, const std::vector<Token>& tokens, source::Range range,
                                    Span comments) {
  const uint32_t bytes = word == "DDB" ? 1 : word == "DDW" ? 2 : 4;
  const std::string_view digits = TextOf(tokens[1]);
  const std::string text = std::string(word) + " " + std::string(digits);
  if (!std::ranges::all_of(digits, IsDigit)) {
    diagnostics_.Report(tokens[1].range, diag::ProstepMalformedNumber, digits);
    return;
  }
  const uint32_t address = ReadDigits(digits);
  if (address > kFirstKeptByte - bytes) {
    diagnostics_.Report({range.begin, tokens[1].range.end}, diag::ProstepDataRange, text);
    return;
  }
  if (tokens.size() < 3) {
    diagnostics_.Report(range, diag::ProstepNumberMissing, text);
    return;
  }
  const ConstantNumber constant = ReadConstant(TextOf(tokens[2]), bytes);
  if (constant.fault == NumberFault::kMalformed) {
    diagnostics_.Report(tokens[2].range, diag::ProstepMalformedNumber, TextOf(tokens[2]));
    return;
  }
  if (constant.fault == NumberFault::kRange) {
    diagnostics_.Report(tokens[2].range, diag::ProstepConstantRange, TextOf(tokens[2]), RangeOfValue(bytes));
    return;
  }
  const DataDeclaration declared{.address = static_cast<uint16_t>(address),
                                 .bytes = static_cast<uint8_t>(bytes),
                                 .value = constant.value,
                                 .range = range,
                                 .comments = comments};
  CheckIoCount(declared, text, tokens[2].range);
  WarnOfOverlap(declared, text);
  program_.data.push_back(declared);
}

void DeclarationReader::CheckIoCount(const DataDeclaration& declared, std::string_view text, source::Range range) {
  if (declared.bytes != 2) return;
  const bool inputs = declared.address == kInputCountAddress;
  if (!inputs && declared.address != kOutputCountAddress) return;
  const uint32_t most = inputs ? kMostInputBytes : kMostOutputBytesDeclared;
  if (declared.value > most) {
    diagnostics_.Report(range, diag::ProstepIoCountRange, text, declared.value, most);
  } else if (!inputs && declared.value > kMostOutputBytes) {
    diagnostics_.Report(range, diag::ProstepOutputCount, declared.value);
  }
}

void DeclarationReader::WarnOfOverlap(const DataDeclaration& declared, std::string_view text) {
  const auto index = static_cast<uint32_t>(program_.data.size());
  bool warned = false;
  for (uint32_t i = 0; i < declared.bytes; ++i) {
    uint32_t& owner = data_owner_[declared.address + i];
    if (owner != 0 && !warned) {
      const source::Range before = program_.data[owner - 1].range;
      diagnostics_.Report(declared.range, diag::ProstepDataOverlap, text, sources_.Text(before))
          .notes.push_back({before, "declared here"});
      warned = true;
    }
    owner = index + 1;
  }
}

std::optional<uint8_t> DeclarationReader::DeclarationNumber(std::string_view word, const Token& number, uint32_t first,
                                                            uint32_t last) {
  const std::string_view digits = TextOf(number);
  if (!std::ranges::all_of(digits, IsDigit)) {
    diagnostics_.Report(number.range, diag::ProstepDeclarationNumberMalformed, word, digits, first, last);
    return std::nullopt;
  }
  const uint32_t value = ReadDigits(digits);
  if (value < first || value > last) {
    const std::string name = std::string(word) + " " + std::string(digits);
    diagnostics_.Report(number.range, diag::ProstepDeclarationNumber, name, first, last);
    return std::nullopt;
  }
  return static_cast<uint8_t>(value);
}

bool DeclarationReader::IsFirst(std::map<uint8_t, source::Range>& declared, std::string_view name, uint8_t number,
                                source::Range range) {
  const auto [entry, is_new] = declared.emplace(number, range);
  if (!is_new) {
    diagnostics_.Report(range, diag::ProstepDeclaredTwice, name).notes.push_back({entry->second, "first defined here"});
  }
  return is_new;
}

void DeclarationReader::DeclareMFunction(const std::vector<Token>& tokens, source::Range range, Span comments) {
  constexpr uint32_t kLastMFunction = 99;
  const auto number = DeclarationNumber("DMF", tokens[1], 0, kLastMFunction);
  if (!number) return;
  const std::string name = "DMF " + std::string(TextOf(tokens[1]));
  if (!IsFirst(m_functions_, name, *number, {range.begin, tokens[1].range.end})) return;
  MFunction function{.number = *number, .range = range, .comments = comments};
  function.after_move = std::ranges::find(kAlwaysAfterMove, *number) != std::end(kAlwaysAfterMove);
  std::set<char> seen;
  for (size_t i = 2; i < tokens.size(); ++i) {
    if (!TakeSwitch(tokens[i], name, function, seen)) return;
  }
  WarnOfSharedBits(function);
  program_.m_functions.push_back(function);
}

bool DeclarationReader::TakeSwitch(const Token& token, std::string_view name, MFunction& function,
                                   std::set<char>& seen) {
  const std::string_view text = TextOf(token);
  std::string written = Upper(text);
  std::erase_if(written, IsBlank);
  const char letter = written.front();
  const std::string_view digits = std::string_view(written).substr(1);
  const bool plain = letter == 'P' && digits.empty();
  const bool numbered = (letter == 'S' || letter == 'D') && !digits.empty() && std::ranges::all_of(digits, IsDigit);
  if (!plain && !numbered) {
    diagnostics_.Report(token.range, diag::ProstepSwitchUnknown, name, text);
    return false;
  }
  if (!seen.insert(letter).second) {
    diagnostics_.Report(token.range, diag::ProstepSwitchTwice, name, text);
    return false;
  }
  if (plain) {
    function.after_move = true;
    return true;
  }
  const uint32_t last = letter == 'S' ? kStaticBits : kDynamicBits;
  const uint32_t bit = ReadDigits(digits);
  if (bit < 1 || bit > last) {
    diagnostics_.Report(token.range, diag::ProstepSwitchRange, name, text, last);
    return false;
  }
  (letter == 'S' ? function.static_bit : function.dynamic_bit) = static_cast<uint8_t>(bit);
  return true;
}

void DeclarationReader::WarnOfSharedBits(const MFunction& function) {
  const auto warn = [&](uint8_t MFunction::* bit, std::string_view kind) {
    if (function.*bit == 0) return;
    const auto other = std::ranges::find_if(program_.m_functions,
                                            [&](const MFunction& before) { return before.*bit == function.*bit; });
    if (other == program_.m_functions.end()) return;
    diagnostics_
        .Report(function.range, diag::ProstepMBitShared, "DMF " + std::to_string(other->number),
                "DMF " + std::to_string(function.number), std::string(kind) + " " + std::to_string(function.*bit))
        .notes.push_back({other->range, "declared here"});
  };
  warn(&MFunction::static_bit, "static bit");
  warn(&MFunction::dynamic_bit, "dynamic bit");
}

void DeclarationReader::DeclareText(std::string_view word, const std::vector<Token>& tokens, source::Range range,
                                    Span comments) {
  const bool message = word == "DM";
  const auto number = DeclarationNumber(word, tokens[1], 1, message ? kMessages : kMenuTexts);
  if (!number) return;
  const std::string name = std::string(word) + " " + std::string(TextOf(tokens[1]));
  const size_t limit = message ? kMessageLength : kMenuTextLength;
  if (!IsFirst(message ? messages_ : menu_texts_, name, *number, {range.begin, tokens[1].range.end})) return;
  if (tokens.size() < 3 || tokens[2].kind != TokenKind::kText) {
    diagnostics_.Report(range, diag::ProstepTextMalformed, name, static_cast<int64_t>(limit));
    return;
  }
  const std::string_view text = TextOf(tokens[2]);
  if (const size_t length = CountCharacters(text); length > limit) {
    diagnostics_.Report(tokens[2].range, diag::ProstepTextLength, name, static_cast<int64_t>(length),
                        static_cast<int64_t>(limit));
    return;
  }
  for (size_t at = 0; at < text.size();) {
    const source::CodePoint point = source::FirstCodePoint(text.substr(at));
    if (!IsInMazovia(point.value)) {
      const source::Offset begin = tokens[2].range.begin + static_cast<source::Offset>(at);
      diagnostics_.Report(
          {begin, begin + point.length}, diag::ProstepNotInMazovia, name,
          "'" + std::string(text.substr(at, point.length)) + "' (" + source::CodePointName(point.value) + ")");
      break;
    }
    at += point.length;
  }
  (message ? program_.messages : program_.menu_texts)
      .push_back({.number = *number, .text = std::string(text), .range = range, .comments = comments});
}

}  // namespace plcxx::prostep
