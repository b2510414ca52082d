#include "transpiler/dialects/technol/parser/memory_reader.h"

#include <algorithm>

#include "transpiler/dialects/technol/parser/expressions.h"

namespace plcxx::technol {
namespace {

constexpr uint32_t kMostBrackets = 200;  // brackets in brackets: each is a call of this parser
constexpr Register kIndexRegisters[] = {Register::kBx,  Register::kSi,  Register::kDi,
                                        Register::kEbx, Register::kEsi, Register::kEdi};

}  // namespace

/// The width; 0: there is no prefix. None when it is wrong (reported).
std::optional<uint8_t> MemoryReader::ReadPrefix(Prefixes prefixes) {
  struct Row {
    std::string_view word;
    uint8_t width;
  };
  constexpr Row kDotted[] = {{"BYTE", 8}, {"WORD", 16}, {"DWRD", 32}};
  constexpr Row kPointers[] = {{"BYTE", 8}, {"WORD", 16}, {"DWORD", 32}};
  for (const Row& row : kDotted) {
    if (!reader_.IsWord(row.word) || !reader_.IsPunctuation('.', 1)) continue;
    reader_.Take();
    reader_.Take();
    return row.width;
  }
  if (prefixes == Prefixes::kTechnol) return 0;
  for (const Row& row : kPointers) {
    if (!reader_.IsWord(row.word)) continue;
    reader_.Take();
    if (reader_.TakeWord("PTR")) return row.width;
    context_.Report(reader_.Here(), diag::TechnolSyntax, Shown(reader_.Peek()), "'PTR' or '.' behind the size");
    return std::nullopt;
  }
  return 0;
}

std::optional<Operand> MemoryReader::ReadMemory(Prefixes prefixes) {
  const size_t first = reader_.position();
  const std::optional<uint8_t> prefix = ReadPrefix(prefixes);
  if (!prefix) return std::nullopt;
  Operand operand{.kind = OperandKind::kMemory};
  uint8_t width = 0;
  if (!ReadAddress(operand.address, width, 0)) return std::nullopt;
  operand.width = *prefix != 0 ? *prefix : width;
  operand.symbol = operand.address.base;
  operand.range = reader_.RangeFrom(first);
  if (operand.width != 0) CheckRange(operand);
  if (context_.faulty) return std::nullopt;
  return operand;
}

/// What follows a name or a bracket: fields, indexes, constants.
bool MemoryReader::ReadAddress(Address& address, uint8_t& width, uint32_t level) {
  if (!ReadBase(address, width, level)) return false;
  while (true) {
    if (reader_.TakePunctuation('.')) {
      if (!ReadField(address, width)) return false;
    } else if (reader_.TakePunctuation('[')) {
      if (!ReadIndex(address)) return false;
    } else if (reader_.IsPunctuation('+') || reader_.IsPunctuation('-')) {
      const bool plus = reader_.Take().text == "+";
      const std::optional<int64_t> value = ReadConstantTerm(reader_, context_);
      if (!value) return false;
      address.offset += plus ? *value : -*value;
    } else {
      return true;
    }
  }
}

bool MemoryReader::ReadBase(Address& address, uint8_t& width, uint32_t level) {
  const Token* token = reader_.Peek();
  if (reader_.TakePunctuation('(')) {
    if (level >= kMostBrackets) {
      context_.Report(token->range, diag::TechnolSyntax, "'('", "an address with fewer brackets");
      return false;
    }
    if (!ReadAddress(address, width, level + 1)) return false;
    if (reader_.TakePunctuation(')')) return true;
    context_.Report(reader_.Here(), diag::TechnolSyntax, Shown(reader_.Peek()), "')'")
        .notes.push_back({token->range, "to match this '('"});
    return false;
  }
  if (token != nullptr && token->kind == TokenKind::kNumber) {
    context_.Report(token->range, diag::TechnolConstantAsMemory, token->text);
    return false;
  }
  if (token != nullptr && token->text == "[") {
    context_.Report(token->range, diag::TechnolSyntaxHint, Shown(token), "the name of a cell",
                    "memory is addressed by a name, to which the register is added: TABLE[BX]");
    return false;
  }
  const SymbolId symbol = ReadName("the name of a cell");
  if (!symbol.valid()) return false;
  const Symbol& named = context_.names[symbol];
  switch (named.kind) {
    case SymbolKind::kCell:
      address.area = named.area;
      address.offset = named.offset;
      address.base = symbol;
      width = named.width;
      return true;
    case SymbolKind::kConstant:
    case SymbolKind::kField:
      context_.Report(token->range, diag::TechnolConstantAsMemory, token->text);
      return false;
    case SymbolKind::kBit:
    case SymbolKind::kMechanism:
      ReportBitAsData(*token);
      return false;
    case SymbolKind::kStructure:
    case SymbolKind::kLabel:
    case SymbolKind::kMacro:
      context_.Report(token->range, diag::TechnolUndefinedAs, token->text, "a cell", KindText(named));
      return false;
  }
  return false;
}

/// A field adds its offset and tells the width; any other constant only adds.
bool MemoryReader::ReadField(Address& address, uint8_t& width) {
  const Token* token = reader_.Peek();
  const SymbolId symbol = ReadName("the name of a field");
  if (!symbol.valid()) return false;
  const Symbol& field = context_.names[symbol];
  if (field.kind != SymbolKind::kField && field.kind != SymbolKind::kConstant) {
    context_.Report(token->range, diag::TechnolUndefinedAs, token->text, "a field", KindText(field));
    return false;
  }
  if (!context_.names.IsDefinedAt(symbol, context_.statement)) {
    context_.ReportUndefined(token->text, token->range);
    return false;
  }
  address.offset += context_.names.ValueAt(symbol, context_.statement);
  if (field.kind == SymbolKind::kField) {
    address.field = symbol;
    width = field.width;
  }
  return true;
}

bool MemoryReader::ReadIndexRegister(Address& address) {
  const Token& token = reader_.Take();
  const Register reg = RegisterByName(Upper(token.text));
  if (std::ranges::find(kIndexRegisters, reg) == std::end(kIndexRegisters)) {
    context_.Report(token.range, diag::TechnolIndexRegister, Shown(&token));
    return false;
  }
  if (address.index != Register::kNone) {
    context_.Report(token.range, diag::TechnolTwoIndexes, token.text);
    return false;
  }
  address.index = reg;
  return true;
}

/// After '[': a register with constants, or a constant.
bool MemoryReader::ReadIndex(Address& address) {
  const auto is_register = [this](size_t ahead) {
    return reader_.IsKind(TokenKind::kWord, ahead) &&
           RegisterByName(Upper(reader_.Peek(ahead)->text)) != Register::kNone;
  };
  if (is_register(0)) {
    if (!ReadIndexRegister(address)) return false;
    while (reader_.IsPunctuation('+') || reader_.IsPunctuation('-')) {
      const bool plus = reader_.Take().text == "+";
      if (plus && is_register(0)) {
        if (!ReadIndexRegister(address)) return false;
        continue;
      }
      const std::optional<int64_t> value = ReadConstantTerm(reader_, context_);
      if (!value) return false;
      address.offset += plus ? *value : -*value;
    }
  } else if (reader_.IsKind(TokenKind::kWord) && IsForeignRegister(Upper(reader_.Peek()->text))) {
    context_.Report(reader_.Here(), diag::TechnolForeignRegister, Upper(reader_.Peek()->text));
    return false;
  } else {
    const std::optional<int64_t> value = ReadConstant(reader_, context_);
    if (!value) return false;
    address.offset += *value;
  }
  if (reader_.TakePunctuation(']')) return true;
  context_.Report(reader_.Here(), diag::TechnolSyntax, Shown(reader_.Peek()), "']'");
  return false;
}

void MemoryReader::CheckRange(const Operand& operand) {
  const Address& address = operand.address;
  const int64_t end = address.offset + operand.width / 8;
  const int64_t bytes = BytesOf(context_.program, address.area);
  const std::string_view text = context_.sources.Text(operand.range);
  const std::string area = address.area == Area::kUser ? "the program's data" : std::string(Name(address.area));
  if (address.index != Register::kNone) {
    const int64_t most = Info(address.index).width == 16 ? 0x7FFF : 0x7FFFFFFF;
    if (address.offset + most >= 0 && end - most - 1 <= bytes && operand.width / 8 <= bytes) return;
    context_.Report(operand.range, diag::TechnolIndexNeverInside, text, Info(address.index).name, area, bytes,
                    address.offset);
    return;
  }
  const std::string name = NameOf(context_.program, address);
  if (address.offset < 0 || end > bytes) {
    context_.Report(operand.range, diag::TechnolAddressRange, text, area, bytes, address.offset);
    return;
  }
  if (!address.base.valid() || address.area != Area::kUser)
    return;  // bytes of the image are used in words as they come
  const Symbol& base = context_.names[address.base];
  if (address.offset >= base.offset && end <= int64_t{base.offset} + base.bytes) return;
  context_.Report(operand.range, diag::TechnolPastSymbol, text, name);
}

bool MemoryReader::IsAddressAhead() const {
  uint32_t depth = 0;
  for (size_t i = 0; const Token* token = reader_.Peek(i); ++i) {
    if (token->kind == TokenKind::kPunctuation) {
      if (token->text == "[") return true;
      if (token->text == "(") ++depth;
      if (token->text == ")" && depth > 0) --depth;
      if (token->text == "," && depth == 0) return false;
      continue;
    }
    if (token->kind != TokenKind::kWord) continue;
    const std::string upper = Upper(token->text);
    if (upper == "BYTE" || upper == "WORD" || upper == "DWRD" || upper == "DWORD") return true;
    if (upper == "SIZE") {
      ++i;  // the structure's name is part of a constant
      continue;
    }
    const SymbolId symbol = context_.names.Find(token->text);
    if (!symbol.valid()) continue;
    const SymbolKind kind = context_.names[symbol].kind;
    if (kind != SymbolKind::kConstant && kind != SymbolKind::kField) return true;
  }
  return false;
}

bool MemoryReader::CheckWidth(const Operand& operand) {
  if (operand.width != 0) return true;
  context_.Report(reader_.RangeFrom(0), diag::TechnolNoWidth, NameOf(context_.program, operand.address));
  return false;
}

/// AND I1 and the like: the instructions of bits have names of their own.
void MemoryReader::ReportBitAsData(const Token& token) {
  std::string_view meant;
  if (instruction_.op == Op::kLod) meant = "LDR";
  if (instruction_.op == Op::kSto) meant = "WR";
  if (instruction_.op == Op::kAnd || instruction_.op == Op::kAsmAnd) meant = "LA";
  if (instruction_.op == Op::kOr || instruction_.op == Op::kAsmOr) meant = "LO";
  if (instruction_.op == Op::kMov) meant = "LDR and WR";
  if (instruction_.op == Op::kNot) meant = "LDR with '-' in front of the name";
  if (meant.empty()) {
    context_.Report(token.range, diag::TechnolBitAsData, token.text);
  } else {
    context_.Report(token.range, diag::TechnolBitAsDataMeant, token.text, mnemonic_, meant);
  }
}

}  // namespace plcxx::technol
