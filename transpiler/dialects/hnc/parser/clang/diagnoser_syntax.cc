// Where the syntax breaks, and what was meant there: notations of the manual and of other languages.
#include <clang/AST/Decl.h>
#include <clang/Basic/DiagnosticLex.h>
#include <clang/Basic/DiagnosticParse.h>
#include <clang/Basic/DiagnosticSema.h>
#include <clang/Lex/Preprocessor.h>
#include <clang/Parse/Parser.h>
#include <clang/Sema/Scope.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <vector>

#include "transpiler/dialects/hnc/machine/machine.h"
#include "transpiler/dialects/hnc/machine/product_names.h"
#include "transpiler/dialects/hnc/parser/clang/diagnoser.h"
#include "transpiler/dialects/hnc/parser/clang/foreign_forms.h"
#include "transpiler/dialects/hnc/syntax/characters.h"
#include "transpiler/support/near_words.h"

namespace plcxx::hnc {
namespace {

namespace cd = clang::diag;

}  // namespace

/// The manual's own notation of a bit, `X0.1`, where the undeclared name `X0` was found.
bool Diagnoser::ManualNotation(source::Range range, const std::string& name) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (name.size() < 2 || !std::ranges::all_of(name.substr(1), is_digit)) return false;
  const bool byte = name[0] == 'X' || name[0] == 'Y' || name[0] == 'R', table = name[0] == 'F' || name[0] == 'G';
  if (!byte && !table && name[0] != 'P' && name[0] != 'B') return false;
  const std::string behind = Written({range.end, range.end + 4});
  const std::string number(behind.begin() + (behind.empty() ? 0 : 1),
                           std::find_if_not(behind.begin() + (behind.empty() ? 0 : 1), behind.end(), is_digit));
  if (!behind.starts_with('.') || number.empty() || number.size() > 2) return false;
  const int bit = std::stoi(number);
  if (bit >= (byte ? 8 : 16)) return false;
  char mask[8];
  std::snprintf(mask, sizeof mask, byte ? "0x%02X" : "0x%04X", 1u << bit);
  const std::string cell = (table ? "*" : "") + name.substr(0, 1) + "[" + name.substr(1) + "]";
  session_.findings().Report({range.begin, range.end + 1 + static_cast<source::Offset>(number.size())},
                             diag::HncManualNotation, name, name + "." + number, cell + " & " + mask,
                             cell + " |= " + mask);
  return true;
}

/// `ch_ctrl[0]` for the macro ch_ctrl(c).
bool Diagnoser::MacroWithParameters(source::Range range, const std::string& name) {
  clang::Preprocessor& preprocessor = session_.clang.getPreprocessor();
  const clang::MacroInfo* const macro = preprocessor.getMacroInfo(preprocessor.getIdentifierInfo(name));
  if (macro == nullptr || !macro->isFunctionLike()) return false;
  const std::string behind = LineAfter(range.end);
  const size_t close = behind.find(']');
  const bool is_indexed = behind.starts_with('[') && close != std::string::npos;
  const std::string call = name + "(" + (is_indexed ? behind.substr(1, close - 1) : "...") + ")";
  const bool is_table = std::ranges::any_of(macro->tokens(), [](const clang::Token& token) {
    const clang::IdentifierInfo* const word = token.getIdentifierInfo();
    const std::optional<SystemName> area = word == nullptr ? std::nullopt : FindSystemName(word->getName().str());
    return area && RowOf(area->area).table;
  });
  session_.findings().Report(range, diag::HncUndeclaredForeign, name,
                             "it is a macro with parameters: write " + (is_table ? "*" + call : call));
  return true;
}

/// One declaration is missing, however often its name is used. On a line whose syntax is wrong nothing is told of it,
/// so the next one counts.
bool Diagnoser::IsFirstUse(source::Range range, const std::string& name) {
  const clang::Decl* const function =
      session_.parser == nullptr ? nullptr : session_.parser->getActions().getCurFunctionDecl();
  if (undeclared_.contains({function, name})) return false;
  const auto begin = static_cast<source::Offset>(range.begin - LineBefore(range.begin).size());
  const bool is_untold = std::ranges::any_of(session_.findings().all(), [&](const Finding& finding) {
    return finding.phase == Phase::kSyntax && finding.range.begin >= begin && finding.range.begin <= range.begin;
  });
  if (!is_untold) undeclared_.emplace(function, name);
  return true;
}

/// `#define N 3;` and `#define N = 3`: the sign is part of the macro, and stands or was left where N is used.
bool Diagnoser::MacroOfBadForm(source::Range range, const std::string& token) {
  std::string name = Written(range);
  if (token.find(" of the macro '") == std::string::npos) {  // behind it
    std::string before = LineBefore(range.begin);
    while (!before.empty() && before.back() == ' ') before.pop_back();
    name = std::string(std::find_if_not(before.rbegin(), before.rend(), IsWord).base(), before.end());
  }
  if (name.empty()) return false;
  clang::Preprocessor& preprocessor = session_.clang.getPreprocessor();
  const clang::MacroInfo* const macro = preprocessor.getMacroInfo(preprocessor.getIdentifierInfo(name));
  if (macro == nullptr || macro->isBuiltinMacro() || macro->getNumTokens() < 2) return false;
  const bool begins = macro->getReplacementToken(0).is(clang::tok::equal);
  const bool ends = macro->getReplacementToken(macro->getNumTokens() - 1).is(clang::tok::semi);
  if (!begins && !ends) return false;
  session_.findings().Report(range, diag::HncSyntaxForeign, token,
                             std::string("the macro '") + name + (begins ? "' begins with '='" : "' ends with ';'") +
                                 ": leave that out in its #define");
  return true;
}

/// What ends too early: the message says what is missing.
bool Diagnoser::Unfinished(const clang::Diagnostic& info) {
  if (info.getID() == cd::err_unterm_macro_invoc) {
    unclosed_call_ = true;
    session_.findings().Report(RangeOf(info), diag::HncMacroCallOpen);
    return true;
  }
  if (info.getID() == cd::err_invalid_suffix_constant) {
    session_.findings().Report(RangeOf(info), diag::HncConstantSuffix, Written(RangeOf(info)));
    return true;
  }
  if (info.getID() != cd::err_exponent_has_no_digits) return false;
  session_.findings().Report(RangeOf(info), diag::HncConstantExponent);
  return true;
}

void Diagnoser::ReportNoPointer(const clang::Diagnostic& info) {
  const std::string operand = info.getNumRanges() > 0 ? Written(session_.places.Of(info.getRange(0).getAsRange())) : "";
  session_.findings().Report(RangeOf(info), diag::HncNoPointer, ArgumentText(info, 0),
                             operand.empty() ? "the operand" : operand);
}

/// `case 1;`: the parser has gone on behind the ';'.
bool Diagnoser::LabelWithSemicolon(const clang::Diagnostic& info) {
  if (info.getID() != cd::err_expected_after || ArgumentText(info, 1) != ":") return false;
  const source::Range range = session_.places.OfToken(session_.places.IncludedAt(info.getLocation()));
  if (Written(range) != ";") return false;
  session_.findings().Report(range, diag::HncSyntaxForeign, "';'", "a case and a default end with ':'");
  return true;
}

/// Where what stands on another line or in another file lacks its end.
void Diagnoser::NoteMissingSemicolon(const clang::Diagnostic& info) {
  Finding& finding = session_.findings().all().back();
  const source::Range behind = session_.places.OfToken(info.getLocation());  // begins where the token before it ends
  if (behind.begin <= 1 || behind.begin == finding.range.begin) return;
  if (LineBefore(finding.range.begin).find_first_not_of(" \t") != std::string::npos) return;
  finding.notes.push_back({{behind.begin - 1, behind.begin}, "the ';' is missing behind this"});
}

/// The operand that is a whole array, as `X` in `X & 1`; empty: none is.
std::string Diagnoser::AreaAmong(const clang::Diagnostic& info) const {
  for (unsigned i = 0; i < std::min(info.getNumRanges(), 2U); ++i) {
    const std::string text = Written(session_.places.Of(info.getRange(i).getAsRange()));
    const std::optional<SystemName> area = FindSystemName(text);
    if (area && !RowOf(area->area).table) return text;
  }
  return {};
}

/// Where what stands here has a name of its own in C: a remedy that says so.
bool Diagnoser::ReportMeant(source::Range range, const std::string& token) {
  const std::string written = Written(range);
  const bool macro = token.find(" of the macro '") != std::string::npos;
  if (macro && EndsWithType(LineBefore(range.begin))) {
    session_.findings().Report(range, diag::HncSyntaxMacroName, token.substr(0, token.find(" of the macro")), written);
    return true;
  }
  if (written.starts_with('.') && IndexedNotation(range)) return true;
  if (macro) return false;
  const std::string remedy = MeantBy(LineBefore(range.begin), written, LineAfter(range.end));
  if (remedy.empty()) return false;
  session_.findings().Report(range, diag::HncSyntaxForeign, token, remedy);
  return true;
}

std::string Diagnoser::LineBefore(source::Offset place) const {
  constexpr source::Offset kMost = 120;
  std::string line;
  while (place > 1 && line.size() < kMost) {
    const std::string character = Written({place - 1, place});
    if (character.size() != 1 || character == "\n" || character == "\r") break;
    line += character;
    --place;
  }
  return {line.rbegin(), line.rend()};
}

std::string Diagnoser::LineAfter(source::Offset place) const {
  constexpr source::Offset kMost = 120;
  const std::string text = Written({place, place + kMost});
  return text.substr(0, text.find_first_of("\r\n"));
}

std::string Diagnoser::NameAfter(source::Offset place) const {
  const std::string line = LineAfter(place);
  const size_t begin = line.find_first_not_of(" \t*");
  if (begin == 0 || begin == std::string::npos || !IsWord(line[begin]) || (line[begin] >= '0' && line[begin] <= '9')) {
    return {};
  }
  size_t end = begin;
  while (end < line.size() && IsWord(line[end])) ++end;
  return line.substr(begin, end - begin);
}

/// Only so many times: each looks at all names.
std::string Diagnoser::NearDeclared(const std::string& name) {
  constexpr uint32_t kMostSearches = 50;
  if (session_.parser == nullptr || ++near_searches_ > kMostSearches) return {};
  std::set<std::string> names;
  for (const clang::Scope* scope = session_.parser->getCurScope(); scope != nullptr; scope = scope->getParent()) {
    for (const clang::Decl* declaration : scope->decls()) {
      const auto* named = llvm::dyn_cast<clang::NamedDecl>(declaration);
      if (named != nullptr && named->getDeclName().isIdentifier()) names.insert(named->getNameAsString());
    }
  }
  clang::Preprocessor& preprocessor = session_.clang.getPreprocessor();
  for (const auto& macro : preprocessor.macros(false)) names.insert(macro.first->getName().str());
  names.erase(name);
  const std::vector<std::string_view> words(names.begin(), names.end());
  const std::string near(support::NearestWord(name, words));
  return near.starts_with(kProductPrefix) || near.starts_with("__") ? std::string() : near;
}

/// `X[0].1`, where the `.1` is found.
bool Diagnoser::IndexedNotation(source::Range range) {
  const std::string before = LineBefore(range.begin), written = Written(range);
  if (written.size() < 2 || written.size() > 3 || !before.ends_with(']')) return false;
  const std::string digits = written.substr(1);
  if (!std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; })) return false;
  const size_t bracket = before.rfind('[');
  if (bracket == std::string::npos || bracket == 0) return false;
  size_t name = bracket;
  while (name > 0 && IsWord(before[name - 1])) --name;
  const std::string area = before.substr(name, bracket - name);
  const bool byte = area == "X" || area == "Y" || area == "R", word = area == "P" || area == "B";
  const int bit = std::stoi(digits);
  if ((!byte && !word) || bit >= (byte ? 8 : 16)) return false;
  char mask[8];
  std::snprintf(mask, sizeof mask, byte ? "0x%02X" : "0x%04X", 1u << bit);
  const std::string cell = before.substr(name);
  session_.findings().Report(range, diag::HncManualNotationIndexed, "'" + written + "'", cell + " & " + mask,
                             cell + " |= " + mask);
  return true;
}

bool Diagnoser::HasUnterminated() const {
  return std::ranges::any_of(session_.output.findings.all(), [](const Finding& finding) {
    return finding.row.key == diag::HncUnterminatedComment.row.key ||
           finding.row.key == diag::HncUnterminatedString.row.key ||
           finding.row.key == diag::HncUnterminatedCharacter.row.key;
  });
}

void Diagnoser::Syntax(const clang::Diagnostic& info) {
  const source::Range range = RangeOf(info);
  const std::string token = TokenAt(range);
  const unsigned id = info.getID();
  if (LabelWithSemicolon(info) || MacroOfBadForm(range, token) || ReportMeant(range, token)) return;
  // What is not closed has taken the rest with it, as it has the bracket that is missing now.
  if (token == "the end of the file" && (unclosed_call_ || HasUnterminated())) return;
  if (id == cd::err_expected_expression && token == "'else'") {
    session_.findings().Report(range, diag::HncMisplaced, "else");
  } else if (id == cd::err_expected || id == cd::err_expected_after) {
    session_.findings().Report(range, diag::HncSyntax, token,
                               Quoted(ArgumentText(info, id == cd::err_expected ? 0 : 1)));
  } else if (id == cd::err_expected_semi_after_expr || id == cd::err_expected_semi_after_stmt ||
             id == cd::err_expected_semi_declaration || id == cd::err_expected_semi_decl_list) {
    session_.findings().Report(range, diag::HncSyntax, token, "';'");
    NoteMissingSemicolon(info);
  } else if (id == cd::err_expected_expression) {
    session_.findings().Report(range, diag::HncSyntax, token, "an expression");
  } else if (id == cd::err_invalid_token_after_toplevel_declarator) {
    session_.findings().Report(range, diag::HncSyntax, token, "';'");
    NoteMissingSemicolon(info);
  } else if (id == cd::err_extraneous_closing_brace) {
    session_.findings().Report(range, diag::HncSyntaxForeign, token, "there is one '}' more in front of it than '{'");
  } else if (id == cd::err_expected_lparen_after) {
    session_.findings().Report(range, diag::HncSyntax, token, "'('");
  } else if (id == cd::err_invalid_decl_spec_combination) {
    session_.findings().Report(range, diag::HncSyntaxTypeWords, token);
  } else {
    session_.findings().Report(range, diag::HncSyntaxAt, token);
  }
}

}  // namespace plcxx::hnc
