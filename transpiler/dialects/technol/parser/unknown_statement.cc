#include "transpiler/dialects/technol/parser/unknown_statement.h"

namespace plcxx::technol {
namespace {

constexpr std::string_view kAllocationHint =
    "memory is DB, DW, DD with its values, DS with its bytes, DFM with its bits";

void ReportForeign(const Token& first, const std::string& upper, ParsingContext& context) {
  const std::string_view meant = ForeignHint(upper);
  if (meant.empty()) {
    context.Report(first.range, diag::TechnolForeignInstruction, first.text);
  } else {
    context.Report(first.range, diag::TechnolForeignInstructionHint, first.text, meant);
  }
}

/// Is the first word a label that lacks its colon?
bool IsLabel(const Statement& statement) {
  return statement.label == nullptr && OpByMnemonic(UpperWord(statement.words, 1)) != Op::kUnknown;
}

/// A cell with a directive that is none: DELAY DQ 5.
bool IsCell(const Statement& statement, CodePlace place) {
  return place == CodePlace::kData && statement.label == nullptr && !UpperWord(statement.words, 1).empty();
}

void ReportUnknownWord(const Statement& statement, CodePlace place, ParsingContext& context) {
  const Token& first = statement.first();
  const std::string_view meant = ForeignHint(statement.upper);
  const std::string_view near = NearMnemonic(statement.upper);
  if (IsLabel(statement)) {
    context.Report(first.range, diag::TechnolUnknownInstructionForeign, first.text,
                   "a label ends with ':': " + std::string(first.text) + ":");
  } else if (meant.empty() && near.empty() && IsCell(statement, place)) {
    const Token& directive = statement.words[1];
    context.Report(directive.range, diag::TechnolUnknownInstructionForeign, directive.text, kAllocationHint);
  } else if (meant.empty() && near.empty() && statement.words.size() == 1 && place == CodePlace::kCode) {
    context.Report(first.range, diag::TechnolUnknownInstructionForeign, first.text,
                   "a label ends with ':': " + std::string(first.text) + ":, a comment begins with ';'");
  } else if (!meant.empty()) {
    context.Report(first.range, diag::TechnolUnknownInstructionForeign, first.text, meant);
  } else if (near.empty()) {
    context.Report(first.range, diag::TechnolUnknownInstruction, first.text);
  } else {
    context.Report(first.range, diag::TechnolUnknownInstructionNear, first.text, near);
  }
}

}  // namespace

bool ReportUnknown(const Statement& statement, CodePlace place, ParsingContext& context) {
  const Token& first = statement.first();
  const std::string& upper = statement.upper;
  const SymbolId symbol = context.names.Find(first.text);
  if (upper == "EQU" || upper == "STRUC" || upper == "STRUCT" || upper == "ENDS" || upper == "MACRO") {
    const Token* const name = statement.words.size() > 1 ? &statement.words[1] : nullptr;
    if (name != nullptr && name->kind == TokenKind::kWord) {
      context.Report(first.range, diag::TechnolStrayLineHint, first.text, "needs a name in front of it",
                     "write " + std::string(name->text) + " " + std::string(first.text) +
                         (upper == "EQU" ? ", and the value" : ""));
    } else {
      context.Report(first.range, diag::TechnolStrayLine, first.text, "needs a name in front of it");
    }
    return false;
  }
  if (upper == "LEA") {
    context.Report(first.range, diag::TechnolSegments, first.text);
  } else if (IsForeignInstruction(upper)) {
    ReportForeign(first, upper, context);
  } else if (symbol.valid() && context.names[symbol].faulty) {
    context.Forgive();
    return false;
  } else if (IsReserved(upper)) {
    const bool in_data = place == CodePlace::kData;
    context.Report(first.range, diag::TechnolSyntax, Shown(&first),
                   in_data ? "DB, DW, DD, DS or DFM" : "an instruction");
    return false;
  } else {
    ReportUnknownWord(statement, place, context);
  }
  return true;
}

}  // namespace plcxx::technol
