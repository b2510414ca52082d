// `plcxx print tokens` and `plcxx print syntax`: one line per token or item, stable, places as line:column.
#include <vector>

#include "transpiler/dialects/common/printing.h"
#include "transpiler/dialects/nc110/parser/parser.h"
#include "transpiler/dialects/nc110/source/lexer.h"
#include "transpiler/support/check.h"

namespace plcxx::nc110 {
namespace {

std::string_view OperatorName(ExprKind kind) {
  switch (kind) {
    case ExprKind::kError:
      return "error";
    case ExprKind::kOperand:
      return "operand";
    case ExprKind::kConstant:
      return "constant";
    case ExprKind::kAscii:
      return "ascii";
    case ExprKind::kNot:
      return "not";
    case ExprKind::kAnd:
      return "and";
    case ExprKind::kOr:
      return "or";
    case ExprKind::kXor:
      return "xor";
    case ExprKind::kAdd:
      return "add";
    case ExprKind::kSubtract:
      return "subtract";
    case ExprKind::kLess:
      return "less";
    case ExprKind::kEqual:
      return "equal";
    case ExprKind::kGreater:
      return "greater";
#define PLCXX_WORD_FUNCTION(Kind, NameText, ...) \
  case ExprKind::k##Kind:                        \
    return NameText;
#include "transpiler/dialects/nc110/machine/functions.def"
    case ExprKind::kSgn:
      return "SGN";
  }
  PLCXX_UNREACHABLE();
}

class SyntaxPrinter : dialects::SyntaxLines {
 public:
  SyntaxPrinter(const source::SourceManager& sources, const Program& program)
      : SyntaxLines(sources), program_(program) {}

  std::string Run() {
    for (const SourceFile& file : program_.files) {
      writer_.Line("file ", sources_.Get(file.file).path, file.is_symbol_file ? " (symbols)" : "");
      const support::Indented deeper(writer_);
      if (file.is_symbol_file) PrintSymbols(file);
      for (uint32_t i = 0; i < file.items.count; ++i) {
        const Item& item = program_.items[ItemId(file.items.first + i)];
        Node(item.range, Text(item), item.faulty && item.kind != ItemKind::kError ? " (faulty)" : "");
      }
    }
    return writer_.Take();
  }

 private:
  void PrintSymbols(const SourceFile& file) {
    const source::Range whole = sources_.WholeFile(file.file);
    for (const Symbol& symbol : program_.symbols) {
      if (symbol.range.begin < whole.begin || symbol.range.begin >= whole.end) continue;
      Node(symbol.range, "!", symbol.name, " = ", ToText(symbol.operand));
    }
  }

  std::string Text(const Item& item) const {
    switch (item.kind) {
      case ItemKind::kError:
        return "error";
      case ItemKind::kCycleMark:
        return "cycle-mark";
      case ItemKind::kAssignment:
        return Text(program_.assignments[item.assignment()]);
      case ItemKind::kBlockHead:
        return Text(program_.blocks[item.block()]);
      case ItemKind::kBlockEnd:
        return Text(program_.block_ends[item.block_end()]);
      case ItemKind::kMessage: {
        const Message& message = program_.messages[item.message()];
        return "message " + std::to_string(message.number) + " \"" + std::string(sources_.Text(message.text)) + "\"";
      }
    }
    PLCXX_UNREACHABLE();
  }

  std::string Text(const OperandUse& use) const { return Text(use.operand, use.symbol); }
  std::string Text(const Operand& operand, SymbolId symbol) const {
    return ToText(operand) + (symbol.valid() ? ":!" + program_.symbols[symbol].name : "");
  }

  std::string Text(const Assignment& assignment) const {
    std::string text = (assignment.inverted ? "assign-inverted " : "assign ") + Text(assignment.target);
    if (assignment.parameter.valid()) text += " [" + Text(assignment.parameter) + "]";
    return text + " " + (assignment.mux.valid() ? Text(program_.muxes[assignment.mux]) : Text(assignment.value));
  }

  std::string Text(const Mux& mux) const {
    std::string text = "(MUX";
    for (uint32_t i = 0; i < mux.count; ++i) {
      const MuxInput& input = program_.mux_inputs[mux.first + i];
      text += " (" + Text(input.selector) + " -> " + Text(input.word) + ")";
    }
    return text + ")";
  }

  static std::string Id(BlockId id) { return id.valid() ? "#" + std::to_string(id.index) : "none"; }

  std::string Name(source::Range name) const {
    return name.begin == name.end ? "" : " '" + std::string(sources_.Text(name)) + "'";
  }

  std::string Text(const Block& block) const {
    const std::string kind = block.kind == BlockKind::kDof ? "DOF" : block.kind == BlockKind::kDoe ? "DOE" : "DOW";
    return kind + Name(block.name) + " level " + std::to_string(block.level) +
           (block.previous.valid() ? " after " + Id(block.previous) : "") + ": " +
           (block.condition.valid() ? Text(block.condition) : "always");
  }

  std::string Text(const BlockEnd& end) const {
    const std::string kind = end.kind == BlockKind::kDof ? "ENDF" : end.kind == BlockKind::kDoe ? "ENDE" : "ENDW";
    return kind + Name(end.name) + " of " + Id(end.block);
  }

  std::string Text(ExprId id) const {
    const Expr& expr = program_.exprs[id];
    switch (expr.kind) {
      case ExprKind::kOperand:
        return Text(expr.operand, expr.symbol);
      case ExprKind::kConstant:
        return std::to_string(expr.value);
      case ExprKind::kAscii:
        return "\"" + std::string(sources_.Text(program_.literals[expr.literal].range)) + "\"";
      case ExprKind::kError:
        return "error";
      case ExprKind::kNot:
      case ExprKind::kAnd:
      case ExprKind::kOr:
      case ExprKind::kXor:
      case ExprKind::kAdd:
      case ExprKind::kSubtract:
      case ExprKind::kLess:
      case ExprKind::kEqual:
      case ExprKind::kGreater:
      case ExprKind::kSgn:
#define PLCXX_WORD_FUNCTION(Kind, ...) case ExprKind::k##Kind:
#include "transpiler/dialects/nc110/machine/functions.def"
        break;
    }
    std::vector<ExprId> operands;
    for (const ExprId child : {expr.left, expr.right}) {
      if (child.valid()) operands.push_back(child);
    }
    return dialects::PrefixForm(OperatorName(expr.kind), operands, [this](ExprId child) { return Text(child); });
  }

  const Program& program_;
};

}  // namespace

std::string PrintTokens(const source::SourceManager& sources, source::FileId file, const ParseOptions& options) {
  diag::Engine unused;
  const LexedFile lexed =
      Lex(sources, file, options.accept_homoglyphs ? Homoglyphs::kAccept : Homoglyphs::kReject, unused);
  return dialects::TokenLines(sources, lexed.tokens, [&](const Token& token) {
    if (token.kind == TokenKind::kEndOfFile) return std::string();
    return " " + (token.mapped ? lexed.mapped.at(token.range.begin) : std::string(sources.Text(token.range)));
  });
}

std::string PrintSyntax(const source::SourceManager& sources, const Program& program) {
  return SyntaxPrinter(sources, program).Run();
}

}  // namespace plcxx::nc110
