#include <cstdio>

#include "transpiler/dialects/common/printing.h"
#include "transpiler/dialects/technol/parser/macros.h"
#include "transpiler/dialects/technol/parser/parser.h"
#include "transpiler/dialects/technol/source/lexer.h"
#include "transpiler/dialects/technol/syntax/raised_errors.h"

namespace plcxx::technol {
namespace {

std::string Signed(int64_t value) { return (value < 0 ? "-" : "+") + std::to_string(value < 0 ? -value : value); }

/// "LABEL_MEM+4[BX]": the named cell or area, and how far from it.
std::string ToText(const Program& program, const Address& address) {
  std::string text(Name(address.area));
  int64_t offset = address.offset;
  if (address.base.valid()) {
    const Symbol& base = program.symbols[address.base];
    text = base.name;
    offset -= base.offset;
  }
  if (offset != 0) text += Signed(offset);
  if (address.index != Register::kNone) text += "[" + std::string(Info(address.index).name) + "]";
  return text;
}

std::string_view WidthPrefix(uint8_t width) { return width == 8 ? "BYTE." : width == 16 ? "WORD." : "DWRD."; }

std::string SymbolText(const Program& program, const Symbol& symbol) {
  const std::string place = std::string(Name(symbol.area)) + "+" + std::to_string(symbol.offset);
  const std::string width = symbol.width == 0 ? "" : " width " + std::to_string(symbol.width);
  switch (symbol.kind) {
    case SymbolKind::kCell:
      return "cell " + symbol.name + " " + place + " bytes " + std::to_string(symbol.bytes) + width;
    case SymbolKind::kBit:
      return "bit " + symbol.name + " " + place + "." + std::to_string(symbol.bit);
    case SymbolKind::kMechanism:
      return "mechanism " + symbol.name;
    case SymbolKind::kConstant:
      return "constant " + symbol.name + " = " + std::to_string(symbol.value);
    case SymbolKind::kField:
      return "field " + symbol.name + " = " + std::to_string(symbol.value) + width;
    case SymbolKind::kStructure:
      return "structure " + symbol.name + " bytes " + std::to_string(symbol.bytes);
    case SymbolKind::kLabel:
      return "label " + symbol.name + " " + std::to_string(program.labels[symbol.label].at.index);
    case SymbolKind::kMacro:
      return "macro " + symbol.name;
  }
  return {};
}

/// "error 10,5 at turret.plc:12" of every ESET (9.5).
std::string ErrorList(const source::SourceManager& sources, const Program& program) {
  std::string text;
  for (const dialects::RaisedError& error : RaisedErrors(program)) {
    const source::Position place = sources.Locate(error.range.begin);
    text += "error " + std::to_string(error.main) + "," + std::to_string(error.sub) + " at " +
            sources.Get(place.file).path + ":" + std::to_string(place.line) + "\n";
  }
  return text;
}

}  // namespace

std::string ToText(const Program& program, const Operand& operand) {
  switch (operand.kind) {
    case OperandKind::kError:
      return "?";
    case OperandKind::kBit:
      return (operand.negated ? "-" : "") + program.symbols[operand.symbol].name;
    case OperandKind::kMemory:
      return std::string(WidthPrefix(operand.width)) + ToText(program, operand.address);
    case OperandKind::kConstant:
      return std::to_string(operand.value);
    case OperandKind::kRegister:
      return std::string(Info(operand.reg).name);
    case OperandKind::kLabel:
      return std::string(WrittenName(program.labels[operand.label].name));
    case OperandKind::kMechanism:
      return program.units[operand.mechanism].name;
    case OperandKind::kAutomaticTimer:
      return "-";
  }
  return {};
}

std::string ToText(const Program& program, const Instruction& instruction) {
  const InstructionInfo& info = Info(instruction.op);
  if (instruction.mechanism.valid()) {
    return std::string(info.mnemonic) + " " + program.units[instruction.mechanism].name;
  }
  if (instruction.op == Op::kModuleEnd) return program.units[instruction.unit].name + "_END";
  std::string text(info.mnemonic);
  for (uint32_t i = 0; i < instruction.operands.count; ++i) {
    const Operand& operand = program.OperandOf(instruction, i);
    text += i == 0 ? " " : ",";
    const bool data = info.form == Form::kData || info.form == Form::kNarrowData || info.form == Form::kWideData ||
                      info.form == Form::kRotation;
    if (data && operand.kind == OperandKind::kConstant) text += "CNST.";
    text += ToText(program, operand);
  }
  return text;
}

std::string PrintTokens(const source::SourceManager& sources, source::FileId file) {
  const source::File& text = sources.Get(file);
  std::string printed;
  std::vector<Token> tokens;
  for (uint32_t i = 0; i < sources.LineCount(file); ++i) {
    tokens.clear();
    LexLine(sources.Line(file, i + 1), {.begin = text.base + text.line_starts[i]}, tokens);
    printed += dialects::TokenLines(sources, tokens, [](const Token& token) { return " " + std::string(token.text); });
  }
  return printed;
}

std::string PrintSyntax(const source::SourceManager& sources, const Program& program) {
  std::string text;
  for (const Symbol& symbol : program.symbols) {
    if (symbol.origin == SymbolOrigin::kControl) continue;
    text += SymbolText(program, symbol) + "\n";
  }
  if (!program.user_data.empty()) text += "data";
  for (const uint8_t byte : program.user_data) {
    char digits[8];
    std::snprintf(digits, sizeof digits, " %02X", byte);
    text += digits;
  }
  if (!program.user_data.empty()) text += "\n";
  for (uint32_t i = 0; i < program.instructions.size(); ++i) {
    const Instruction& instruction = program.instructions[InstructionId(i)];
    const Unit& unit = program.units[instruction.unit];
    if (unit.kind == UnitKind::kModule && unit.first.index == i) text += unit.name + "\n";
    for (uint32_t label = 0; label < instruction.labels.count; ++label) {
      text += program.labels[LabelId(instruction.labels.first + label)].name + ":\n";
    }
    if (instruction.op == Op::kAreaEnd) {
      text += "end of subprograms\n";
    } else {
      text += std::to_string(sources.Locate(instruction.range.begin).line) + ": " + ToText(program, instruction) + "\n";
    }
  }
  text += ErrorList(sources, program);
  if (program.table) text += Listing(*program.table);
  return text;
}

}  // namespace plcxx::technol
