#include "transpiler/dialects/nc110/control/locate.h"

#include <algorithm>

#include "transpiler/dialects/nc110/machine/options.h"
#include "transpiler/dialects/nc110/machine/places.h"
#include "transpiler/dialects/nc110/parser/parser.h"
#include "transpiler/dialects/nc110/source/tokens.h"

namespace plcxx::nc110 {
namespace {

constexpr size_t kSample = 64 * 1024;

/// The operand that a symbol stands for, by the documentation that lowering wrote.
Operand OperandOfSymbol(const ir::NameIndex& names, std::string_view symbol) {
  const ir::Documentation* const entry = names.WithSymbol(symbol, kSignificant);
  return entry == nullptr ? Operand{} : OperandFromText(entry->address);
}

dialects::Location LocationOf(const ir::NameIndex& names, const Operand& operand) {
  dialects::Location location;
  const auto field = FieldOfOperand(operand);
  if (!field) {
    location.place = MemoryPlace(operand);
  } else {
    location.place.type = operand.kind == OperandKind::kCounterValue ? ir::Type::kI8 : ir::Type::kBit;
    location.place.field = field->field;
    location.place.state = names.State(field->kind, field->instance);
    location.absent = !location.place.state.valid();
  }
  location.place.name = ToText(operand);
  return location;
}

/// "4A": the 32 signals of a connector, of which signal 0 is the least bit.
std::optional<dialects::Location> WholeConnector(std::string_view text) {
  const Operand first = text.empty() ? Operand{} : OperandFromText("W" + std::string(text) + "0");
  if (first.kind != OperandKind::kWord || first.index != 0 || IsDigit(text.back())) return std::nullopt;
  dialects::Location location;
  location.place = MemoryPlace(first);
  location.place.type = ir::Type::kI32;
  location.place.name = text;
  return location;
}

}  // namespace

std::optional<dialects::Location> Locate(const ir::NameIndex& names, std::string_view text) {
  text = Trim(text);
  if (text == "OPERATOR_TEXT") {
    dialects::Location location;
    location.text_input = true;
    location.place.name = text;
    return location;
  }
  const bool symbol_only = text.starts_with('!');
  if (symbol_only) text.remove_prefix(1);
  if (text.empty()) return std::nullopt;
  Operand operand;
  if (!symbol_only) operand = OperandFromText(text);
  if (operand.kind == OperandKind::kNone) operand = OperandOfSymbol(names, text);
  if (operand.kind == OperandKind::kNone) return WholeConnector(text);
  return LocationOf(names, operand);
}

std::optional<uint64_t> ParseValue(std::string_view text) {
  text = Trim(text);
  if (text.empty()) return std::nullopt;  // "FFH" is no name here, so it needs no 0 in front
  const Number number = Evaluate(text);
  if (!number.well_formed) return std::nullopt;
  return number.value;
}

/// One assignment to an operand, or the head of a block, is enough: no other dialect writes "U4A8=" or "DOF:".
bool Recognize(std::string_view text) {
  // A symbol file; but in other languages '*' begins a comment and ':' an instruction.
  if (text.starts_with('*'))
    return text.find("\n:") == std::string_view::npos && text.find("\r:") == std::string_view::npos;
  text = text.substr(0, kSample);
  while (!text.empty()) {
    const size_t end = std::min(text.find_first_of("\r\n"), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    line = Trim(line.substr(0, line.find(';')));
    if (line.starts_with('/')) line.remove_prefix(1);
    const size_t run = std::min(line.find_first_of(" \t=(:"), line.size());
    const std::string_view first = line.substr(0, run);
    line = Trim(line.substr(run));
    if (first.empty() || line.empty()) continue;
    const TokenKind kind = Classify(first).kind;
    if (kind == TokenKind::kOperand && (line[0] == '=' || line[0] == '(')) return true;
    if (kind == TokenKind::kDof && line.find(':') != std::string_view::npos) return true;
  }
  return false;
}

}  // namespace plcxx::nc110
