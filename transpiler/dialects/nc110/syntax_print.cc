// `plcxx print tokens` and `plcxx print syntax`: one line per token or item, stable, places as line:column.
#include "transpiler/dialects/common/printing.h"
#include "transpiler/dialects/nc110/lexer.h"
#include "transpiler/dialects/nc110/parser.h"

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
#include "transpiler/dialects/nc110/functions.def"
    case ExprKind::kSgn:
      return "SGN";
  }
  PLCXX_UNREACHABLE();
}

class SyntaxPrinter {
 public:
  SyntaxPrinter(const source::SourceManager& sources, const Program& program) : sources_(sources), program_(program) {}

  std::string Run() {
    for (const SourceFile& file : program_.files) {
      out_ += "file " + sources_.Get(file.file).path;
      out_ += file.is_symbol_file ? " (symbols)\n" : "\n";
      if (file.is_symbol_file) {
        PrintSymbols(file);
      }
      for (uint32_t i = 0; i < file.items.count; ++i) {
        Print(program_.items[ItemId(file.items.first + i)]);
      }
    }
    return std::move(out_);
  }

 private:
  void PrintSymbols(const SourceFile& file) {
    const source::Range whole = sources_.WholeFile(file.file);
    for (const Symbol& symbol : program_.symbols) {
      if (symbol.range.begin >= whole.begin && symbol.range.begin < whole.end) {
        out_ += "  " + dialects::PlaceText(sources_, symbol.range.begin) + " !" + symbol.name + " = " +
                ToText(symbol.operand) + "\n";
      }
    }
  }

  void Print(const Item& item) {
    out_ += "  " + dialects::PlaceText(sources_, item.range.begin) + " ";
    switch (item.kind) {
      case ItemKind::kError:
        out_ += "error";
        break;
      case ItemKind::kCycleMark:
        out_ += "cycle-mark";
        break;
      case ItemKind::kAssignment:
        Print(program_.assignments[item.assignment()]);
        break;
      case ItemKind::kBlockHead:
        Print(program_.blocks[item.block()]);
        break;
      case ItemKind::kBlockEnd:
        Print(program_.block_ends[item.block_end()]);
        break;
      case ItemKind::kMessage: {
        const Message& message = program_.messages[item.message()];
        out_ += "message " + std::to_string(message.number) + " \"" + std::string(sources_.Text(message.text)) + "\"";
        break;
      }
    }
    out_ += item.faulty && item.kind != ItemKind::kError ? " (faulty)\n" : "\n";
  }

  void Print(const OperandUse& use) { Print(use.operand, use.symbol); }
  void Print(const Operand& operand, SymbolId symbol) {
    out_ += ToText(operand);
    if (symbol.valid()) {
      out_ += ":!" + program_.symbols[symbol].name;
    }
  }

  void Print(const Assignment& assignment) {
    out_ += assignment.inverted ? "assign-inverted " : "assign ";
    Print(assignment.target);
    if (assignment.parameter.valid()) {
      out_ += " [";
      Print(assignment.parameter);
      out_ += "]";
    }
    out_ += " ";
    if (!assignment.mux.valid()) {
      Print(assignment.value);
      return;
    }
    const Mux& mux = program_.muxes[assignment.mux];
    out_ += "(MUX";
    for (uint32_t i = 0; i < mux.count; ++i) {
      const MuxInput& input = program_.mux_inputs[mux.first + i];
      out_ += " (";
      Print(input.selector);
      out_ += " -> ";
      Print(input.word);
      out_ += ")";
    }
    out_ += ")";
  }

  std::string Id(BlockId id) const { return id.valid() ? "#" + std::to_string(id.index) : "none"; }

  void PrintName(source::Range name) {
    if (name.begin != name.end) {
      out_ += " '" + std::string(sources_.Text(name)) + "'";
    }
  }

  void Print(const Block& block) {
    out_ += block.kind == BlockKind::kDof ? "DOF" : block.kind == BlockKind::kDoe ? "DOE" : "DOW";
    PrintName(block.name);
    out_ += " level " + std::to_string(block.level);
    if (block.previous.valid()) {
      out_ += " after " + Id(block.previous);
    }
    out_ += ": ";
    if (block.condition.valid()) {
      Print(block.condition);
    } else {
      out_ += "always";
    }
  }

  void Print(const BlockEnd& end) {
    out_ += end.kind == BlockKind::kDof ? "ENDF" : end.kind == BlockKind::kDoe ? "ENDE" : "ENDW";
    PrintName(end.name);
    out_ += " of " + Id(end.block);
  }

  void Print(ExprId id) {
    const Expr& expr = program_.exprs[id];
    switch (expr.kind) {
      case ExprKind::kOperand:
        Print(expr.operand, expr.symbol);
        return;
      case ExprKind::kConstant:
        out_ += std::to_string(expr.value);
        return;
      case ExprKind::kAscii:
        out_ += "\"" + std::string(sources_.Text(program_.literals[expr.literal].range)) + "\"";
        return;
      case ExprKind::kError:
        out_ += "error";
        return;
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
#include "transpiler/dialects/nc110/functions.def"
        break;
    }
    out_ += "(";
    out_ += OperatorName(expr.kind);
    for (const ExprId child : {expr.left, expr.right}) {
      if (child.valid()) {
        out_ += " ";
        Print(child);
      }
    }
    out_ += ")";
  }

  const source::SourceManager& sources_;
  const Program& program_;
  std::string out_;
};

}  // namespace

std::string PrintTokens(const source::SourceManager& sources, source::FileId file, const ParseOptions& options) {
  diag::Engine unused;
  const LexedFile lexed =
      Lex(sources, file, options.accept_homoglyphs ? Homoglyphs::kAccept : Homoglyphs::kReject, unused);
  std::string out;
  for (const Token& token : lexed.tokens) {
    out += dialects::PlaceText(sources, token.range.begin) + " ";
    out += Name(token.kind);
    if (token.kind != TokenKind::kEndOfFile) {
      out += " ";
      out += token.mapped ? std::string_view(lexed.mapped.at(token.range.begin)) : sources.Text(token.range);
    }
    out += "\n";
  }
  return out;
}

std::string PrintSyntax(const source::SourceManager& sources, const Program& program) {
  return SyntaxPrinter(sources, program).Run();
}

}  // namespace plcxx::nc110
