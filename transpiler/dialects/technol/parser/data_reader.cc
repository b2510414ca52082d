#include "transpiler/dialects/technol/parser/data_reader.h"

#include <algorithm>

#include "transpiler/dialects/technol/parser/expressions.h"
#include "transpiler/dialects/technol/parser/values.h"

namespace plcxx::technol {
namespace {

/// DB, DW, DD, also with a '?' glued to it; 0: none of them.
uint8_t WidthOf(std::string_view upper) {
  if (upper.size() < 2 || upper[0] != 'D') return 0;
  switch (upper[1]) {
    case 'B':
      return 8;
    case 'W':
      return 16;
    case 'D':
      return 32;
    default:
      return 0;
  }
}

Token Part(const Token& token, size_t begin, size_t length, TokenKind kind) {
  Token part{.kind = kind, .text = token.text.substr(begin, length), .range = token.range};
  if (token.range.end - token.range.begin == token.text.size()) {
    part.range.begin += static_cast<source::Offset>(begin);
    part.range.end = part.range.begin + static_cast<source::Offset>(length);
  }
  return part;
}

}  // namespace

bool DataReader::IsDataPlace(const Statement& statement, const Token* name) {
  if (IsOutside(statement)) return false;
  if (now_.in_data) return true;
  const Token& word = statement.first();
  context_.Report(statement.range, diag::TechnolOutsideData, name != nullptr ? name->text : word.text);
  // The name counts as defined: its uses are not at fault.
  if (name != nullptr && !context_.names.Find(name->text).valid() && !IsReserved(Upper(name->text))) {
    const SymbolId symbol = context_.names.Add(
        {.kind = SymbolKind::kCell, .faulty = true, .name = std::string(name->text), .range = name->range},
        context_.statement);
    context_.names[symbol].uses = 1;
  }
  return false;
}

void DataReader::ReadAllocation(const Statement& statement, const Token* name, size_t directive) {
  if (!IsDataPlace(statement, name)) return;
  const Token& word = statement.words[directive];
  const std::string upper = Upper(word.text);
  if (upper == "DFM") return ReadBits(statement, directive);
  std::span<const Token> words = statement.words.subspan(directive + 1);
  if (upper == "DS") return ReserveBytes(statement, name, words);

  std::vector<Token> repaired;
  if (upper.ends_with('?')) {
    const std::string right(upper.substr(0, 2) + " ?");
    context_.Report(word.range, diag::TechnolRepaired, word.text, right);
    repaired.push_back(Part(word, 2, 1, TokenKind::kWord));
    repaired.insert(repaired.end(), words.begin(), words.end());
    words = repaired;
  }
  const uint8_t width = WidthOf(upper);
  TokenReader reader(words);
  std::vector<uint8_t> bytes;
  if (reader.AtEnd()) {
    context_.Report(word.range, diag::TechnolOperandMissing, upper, "a value or '?'");
  } else if (ReadValues(reader, width, bytes, context_) && !reader.AtEnd()) {
    context_.Report(reader.Here(), diag::TechnolSurplus, Shown(reader.Peek()), word.text);
  }
  DefineCell(statement, name, width, bytes);
}

/// DS n
void DataReader::ReserveBytes(const Statement& statement, const Token* name, std::span<const Token> words) {
  if (name == nullptr) {
    context_.Report(statement.range, diag::TechnolStrayLine, "DS", "needs a name in front of it");
    return;
  }
  TokenReader reader(words);
  if (reader.AtEnd()) context_.Report(statement.range, diag::TechnolOperandMissing, "DS", "the number of bytes");
  const std::optional<int64_t> count = reader.AtEnd() ? std::nullopt : ReadConstant(reader, context_);
  if (count && !reader.AtEnd()) {
    context_.Report(reader.Here(), diag::TechnolSurplus, Shown(reader.Peek()), "DS");
  } else if (count && (*count < 1 || *count > kUserBytes)) {
    context_.Report(reader.RangeFrom(0), diag::TechnolDsSize, *count);
  }
  const bool right = !context_.faulty && count;
  const std::vector<uint8_t> bytes(right ? static_cast<size_t>(*count) : 0);
  const bool plain = bytes.size() == 1 || bytes.size() == 2 || bytes.size() == 4;
  DefineCell(statement, name, plain ? static_cast<uint8_t>(bytes.size() * 8) : 0, bytes);
}

void DataReader::DefineCell(const Statement& statement, const Token* name, uint8_t width,
                            std::span<const uint8_t> bytes) {
  std::vector<uint8_t>& data = context_.program.user_data;
  Symbol symbol{.kind = SymbolKind::kCell, .width = width, .area = Area::kUser};
  symbol.offset = static_cast<uint32_t>(data.size());
  symbol.bytes = static_cast<uint32_t>(bytes.size());
  symbol.comments = comments_.TakeComments(statement);
  if (data.size() + bytes.size() > kUserBytes) {
    context_.Report(statement.range, diag::TechnolDataTooLarge, name != nullptr ? name->text : statement.first().text);
  } else {
    data.insert(data.end(), bytes.begin(), bytes.end());
  }
  symbol.faulty = context_.faulty;
  if (name == nullptr) return;
  if (context_.faulty) {  // the cell counts as defined, unless its name is another's
    if (!context_.names.Find(name->text).valid()) {
      symbol.name = name->text;
      symbol.range = name->range;
      context_.names.Add(std::move(symbol), context_.statement);
    }
    return;
  }
  context_.Define(*name, std::move(symbol));
}

/// name: DFM b0,...,b7: a byte of its own, or names for the bits of a predefined one.
void DataReader::ReadBits(const Statement& statement, size_t directive) {
  if (statement.label == nullptr || directive != 0) {
    context_.Report(statement.range, diag::TechnolSyntax, "'DFM'", "a name and a colon in front of it");
    return;
  }
  std::vector<const Token*> names;
  TokenReader reader(statement.words.subspan(1));
  bool comma = !reader.AtEnd();
  while (comma) {
    names.push_back(reader.IsKind(TokenKind::kWord) ? &reader.Take() : nullptr);
    comma = reader.TakePunctuation(',');
  }
  if (!reader.AtEnd()) {
    context_.Report(reader.Here(), diag::TechnolSyntax, Shown(reader.Peek()), "a name of a bit or ','");
    return;
  }
  if (names.size() > kBitsOfDfm) {
    context_.Report(statement.range, diag::TechnolDfmNames, static_cast<int64_t>(names.size()));
  }
  DefineBits(statement, names);
}

/// Null: this bit has no name.
void DataReader::DefineBits(const Statement& statement, std::span<const Token* const> names) {
  const Token& name = *statement.label;
  const SymbolId known = context_.names.Find(name.text);
  const bool predefined = known.valid() && context_.names[known].origin != SymbolOrigin::kSource &&
                          context_.names[known].kind == SymbolKind::kCell && context_.names[known].width == 8;
  SymbolId carrier = known;
  if (!predefined) {
    const uint8_t zero[] = {0};
    DefineCell(statement, &name, 8, zero);
    carrier = context_.names.Find(name.text);
    if (carrier.valid() && context_.names[carrier].range != name.range) carrier = {};  // another's name
  }
  const Span comments = carrier.valid() ? context_.names[carrier].comments : Span();
  for (size_t bit = 0; bit < names.size(); ++bit) {
    if (names[bit] == nullptr) continue;
    Symbol symbol{.kind = SymbolKind::kBit, .width = 1, .bit = static_cast<uint8_t>(bit % kBitsOfDfm)};
    if (carrier.valid()) {
      const Symbol& cell = context_.names[carrier];
      symbol.direction = cell.direction;
      symbol.area = cell.area;
      symbol.offset = cell.offset;
      symbol.faulty = cell.faulty;
    }
    symbol.faulty |= context_.faulty || !carrier.valid();
    symbol.byte = carrier;
    if (predefined && !comments_.IsWaiting() && statement.comment == nullptr) {
      symbol.comments = comments;
    } else if (predefined) {
      symbol.comments = comments_.TakeComments(statement);
    }
    const bool before = context_.faulty;
    context_.Define(*names[bit], std::move(symbol));
    if (!before) context_.faulty = false;  // each name of the line has its own fault
  }
}

void DataReader::ReadInstance(const Statement& statement, const Token* name, size_t index) {
  if (!IsDataPlace(statement, name)) return;
  const SymbolId symbol = context_.names.Find(statement.words[index].text);
  ++context_.names[symbol].uses;
  const Structure& structure = *structures_.Find(symbol);
  TokenReader reader(statement.words.subspan(index + 1));
  std::vector<uint8_t> bytes;
  if (reader.TakePunctuation('<')) {
    ReadFields(reader, structure, bytes);
  } else if (reader.AtEnd()) {
    ReportSyntax(reader, "'<' and initial values");
  } else {
    ReadCopies(statement, reader, structure, bytes);
  }
  if (!context_.faulty && !reader.AtEnd()) {
    context_.Report(reader.Here(), diag::TechnolSurplus, Shown(reader.Peek()), structure.name);
  }
  DefineCell(statement, name, 0, bytes);
}

void DataReader::ReportSyntax(const TokenReader& reader, std::string_view expected) {
  context_.Report(reader.Here(), diag::TechnolSyntax, Shown(reader.Peek()), expected);
}

/// After '<'.
void DataReader::ReadFields(TokenReader& reader, const Structure& structure, std::vector<uint8_t>& bytes) {
  bytes = structure.initial;
  for (size_t field = 0; !context_.faulty && !reader.IsPunctuation('>'); ++field) {
    if (reader.AtEnd()) {
      ReportSyntax(reader, "'>'");
      break;
    }
    if (field >= structure.fields.size()) {
      context_.Report(reader.Here(), diag::TechnolTooManyValues, structure.name,
                      static_cast<int64_t>(structure.fields.size()));
      break;
    }
    const bool given = !reader.IsPunctuation(',') && !reader.IsPunctuation('>');
    if (given && !ReadField(reader, structure.fields[field], bytes)) break;
    if (!reader.IsPunctuation('>') && !reader.TakePunctuation(',')) {
      ReportSyntax(reader, "',' or '>'");
      break;
    }
  }
  reader.TakePunctuation('>');
}

/// n DUP (<>)
void DataReader::ReadCopies(const Statement& statement, TokenReader& reader, const Structure& structure,
                            std::vector<uint8_t>& bytes) {
  const size_t first = reader.position();
  const std::optional<int64_t> count = ReadConstant(reader, context_);
  if (!count) return;
  if (*count < 1 || *count > kUserBytes) {
    context_.Report(reader.RangeFrom(first), diag::TechnolDupCount, *count);
  } else if (!(reader.TakeWord("DUP") && reader.TakePunctuation('(') && reader.TakePunctuation('<') &&
               reader.TakePunctuation('>') && reader.TakePunctuation(')'))) {
    ReportSyntax(reader, "DUP (<>)");
  } else if (structure.initial.size() * static_cast<size_t>(*count) > kUserBytes) {
    context_.Report(statement.range, diag::TechnolDataTooLarge, reader.TextFrom(first));
  } else {
    for (int64_t i = 0; i < *count; ++i) bytes.insert(bytes.end(), structure.initial.begin(), structure.initial.end());
  }
}

/// One initial value of an instance; after the first element an array keeps the structure's own values.
bool DataReader::ReadField(TokenReader& reader, const StructureField& field, std::vector<uint8_t>& instance) {
  const size_t first = reader.position();
  const Token& token = *reader.Peek();
  std::vector<uint8_t> bytes;
  if (token.kind == TokenKind::kString && field.width == 8 && (token.text.size() > 3 || field.bytes > 1)) {
    reader.Take();
    const std::string_view text = token.text.substr(1, token.text.size() - 2);
    if (text.size() > field.bytes) {
      context_.Report(token.range, diag::TechnolStringDoesNotFit, token.text, int64_t{field.bytes});
      return false;
    }
    bytes.assign(text.begin(), text.end());
    bytes.resize(field.bytes);
  } else if (!ReadValue(reader, field.width, bytes, context_)) {
    return false;
  } else if (bytes.size() > field.bytes) {
    context_.Report(reader.RangeFrom(first), diag::TechnolStringDoesNotFit, reader.TextFrom(first),
                    int64_t{field.bytes});
    return false;
  }
  std::ranges::copy(bytes, instance.begin() + field.offset);
  return true;
}

}  // namespace plcxx::technol
