#include "transpiler/dialects/technol/parser/values.h"

#include "transpiler/dialects/technol/parser/expressions.h"

namespace plcxx::technol {
namespace {

constexpr uint32_t kMostDupLevels = 100;  // DUP within DUP: each is a call of this parser

class ValueReader {
 public:
  ValueReader(TokenReader& reader, uint8_t width, ParsingContext& context)
      : reader_(reader), width_(width), context_(context) {}

  bool ReadValues(uint32_t level, std::vector<uint8_t>& bytes) {
    do {
      if (!ReadValue(level, bytes)) return false;
    } while (reader_.TakePunctuation(','));
    return true;
  }

  bool ReadValue(uint32_t level, std::vector<uint8_t>& bytes) {
    const size_t first = reader_.position();
    const Token* token = reader_.Peek();
    if (reader_.TakeWord("?")) return AppendNumber(0, bytes);
    if (token != nullptr && token->kind == TokenKind::kString && token->text.size() > 3) {
      reader_.Take();
      return AppendText(*token, bytes);
    }
    const std::optional<int64_t> value = ReadConstant(reader_, context_);
    if (!value) return false;
    if (reader_.TakeWord("DUP")) return ReadRepetition(first, *value, level, bytes);
    if (AppendNumber(*value, bytes)) return true;
    context_.Report(reader_.RangeFrom(first), diag::TechnolDoesNotFit, *value, int64_t{width_});
    return false;
  }

 private:
  bool AppendNumber(int64_t value, std::vector<uint8_t>& bytes) const {
    const int64_t values = int64_t{1} << width_;
    if (value < -values / 2 || value >= values) return false;
    for (uint8_t bit = 0; bit < width_; bit += 8)
      bytes.push_back(static_cast<uint8_t>(static_cast<uint64_t>(value) >> bit));
    return true;
  }

  bool AppendText(const Token& token, std::vector<uint8_t>& bytes) {
    if (width_ != 8) {
      context_.Report(token.range, diag::TechnolStringOutsideDb, token.text, width_ == 16 ? "DW" : "DD");
      return false;
    }
    const std::string_view text = token.text.substr(1, token.text.size() - 2);
    bytes.insert(bytes.end(), text.begin(), text.end());
    return true;
  }

  /// After `count` DUP; the count is token `first`.
  bool ReadRepetition(size_t first, int64_t count, uint32_t level, std::vector<uint8_t>& bytes) {
    if (count < 1 || count > kUserBytes) {
      context_.Report(reader_.RangeFrom(first), diag::TechnolDupCount, count);
      return false;
    }
    if (!reader_.TakePunctuation('(') || level >= kMostDupLevels) {
      context_.Report(reader_.Here(), diag::TechnolSyntax, Shown(reader_.Peek()), "'(' and the values to repeat");
      return false;
    }
    std::vector<uint8_t> part;
    if (!ReadValues(level + 1, part)) return false;
    if (!reader_.TakePunctuation(')')) {
      context_.Report(reader_.Here(), diag::TechnolSyntax, Shown(reader_.Peek()), "',' or ')'");
      return false;
    }
    if (part.size() * static_cast<size_t>(count) > kUserBytes) return ReportTooLarge(first);
    for (int64_t i = 0; i < count; ++i) bytes.insert(bytes.end(), part.begin(), part.end());
    return bytes.size() <= kUserBytes || ReportTooLarge(first);
  }

  /// False.
  bool ReportTooLarge(size_t first) {
    context_.Report(reader_.RangeFrom(first), diag::TechnolDataTooLarge, reader_.TextFrom(first));
    return false;
  }

  TokenReader& reader_;
  uint8_t width_;
  ParsingContext& context_;
};

}  // namespace

bool ReadValues(TokenReader& reader, uint8_t width, std::vector<uint8_t>& bytes, ParsingContext& context) {
  return ValueReader(reader, width, context).ReadValues(0, bytes);
}

bool ReadValue(TokenReader& reader, uint8_t width, std::vector<uint8_t>& bytes, ParsingContext& context) {
  return ValueReader(reader, width, context).ReadValue(0, bytes);
}

}  // namespace plcxx::technol
