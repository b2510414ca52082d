#include "transpiler/dialects/technol/parser/constant_reader.h"

#include "transpiler/dialects/technol/parser/expressions.h"

namespace plcxx::technol {

namespace {

/// The value of all of `tokens`; none when it is wrong (reported).
std::optional<int64_t> WholeConstant(std::span<const Token> tokens, const Token& name, ParsingContext& context) {
  TokenReader reader(tokens);
  if (reader.AtEnd()) {
    context.Report(name.range, diag::TechnolOperandMissing, name.text, "a value");
    return std::nullopt;
  }
  const std::optional<int64_t> value = ReadConstant(reader, context);
  if (value && !reader.AtEnd()) {
    context.Report(reader.Here(), diag::TechnolSurplus, Shown(reader.Peek()), name.text);
    return std::nullopt;
  }
  return value;
}

}  // namespace

/// EQUI name,expr
void ConstantReader::ReadEqui(const Statement& statement) {
  TokenReader reader(statement.words.subspan(1));
  if (!reader.IsKind(TokenKind::kWord)) {
    context_.Report(reader.AtEnd() ? statement.range : reader.Here(), diag::TechnolOperandMissing, "EQUI",
                    "a name, a comma and a value");
    return;
  }
  const Token& name = reader.Take();
  if (!reader.TakePunctuation(',')) {
    context_.Report(reader.Here(), diag::TechnolSyntax, Shown(reader.Peek()), "','");
    return;
  }
  if (statement.label != nullptr) {
    context_.Report(statement.label->range, diag::TechnolSurplus, "label '" + std::string(statement.label->text) + "'",
                    "EQUI");
    return;
  }
  DefineConstant(name, statement.words.subspan(3));
  SetComments(name, statement);
}

/// name EQU expr
void ConstantReader::ReadEqu(const Statement& statement) {
  WarnOfCompletion(statement.words[1]);
  DefineConstant(statement.first(), statement.words.subspan(2));
  SetComments(statement.first(), statement);
}

/// name = expr
void ConstantReader::ReadAssignment(const Statement& statement) {
  AssignConstant(statement.first(), statement.words.subspan(2));
  SetComments(statement.first(), statement);
}

void ConstantReader::SetComments(const Token& name, const Statement& statement) {
  const SymbolId symbol = context_.names.Find(name.text);
  if (symbol.valid() && context_.names[symbol].comments.count == 0) {
    context_.names[symbol].comments = comments_.TakeComments(statement);
  }
}

void ConstantReader::DefineConstant(const Token& name, std::span<const Token> expression) {
  if (!context_.IsName(name)) return;
  const std::optional<int64_t> value = WholeConstant(expression, name, context_);
  const SymbolId known = context_.names.Find(name.text);
  if (!known.valid()) {
    const SymbolId symbol = context_.Define(name, {.kind = SymbolKind::kConstant, .value = value.value_or(0)});
    if (symbol.valid()) context_.names[symbol].faulty = !value;
    return;
  }
  Symbol& symbol = context_.names[known];
  if (symbol.kind != SymbolKind::kConstant || symbol.origin != SymbolOrigin::kSource) {
    context_.IsTaken(name);
  } else if (value && !symbol.faulty && *value != symbol.value) {
    context_.Report(name.range, diag::TechnolConstantRedefined, name.text, symbol.value, *value)
        .notes.push_back({symbol.range, "it is defined here"});
  }
}

void ConstantReader::AssignConstant(const Token& name, std::span<const Token> expression) {
  const SymbolId known = context_.names.Find(name.text);
  if (known.valid() && context_.names[known].kind == SymbolKind::kCell) {
    const bool is_number = expression.size() == 1 && expression.front().kind == TokenKind::kNumber;
    context_.Report(name.range, diag::TechnolAlreadyDefinedHint, name.text,
                    "'=' defines constants; a cell gets its value by LOD CNST." +
                        (is_number ? std::string(expression.front().text) : std::string("5")) + " and STO " +
                        std::string(name.text));
    return;
  }
  if (!known.valid() || !assigned_.contains(known)) {  // EQUI and EQU are for good
    DefineConstant(name, expression);
    const SymbolId symbol = context_.names.Find(name.text);
    if (!known.valid() && symbol.valid()) assigned_.insert(symbol);
    return;
  }
  const std::optional<int64_t> value = WholeConstant(expression, name, context_);
  if (value) context_.names.Assign(known, *value, context_.statement);
}

}  // namespace plcxx::technol
