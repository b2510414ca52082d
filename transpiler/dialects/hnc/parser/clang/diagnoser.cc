#include "transpiler/dialects/hnc/parser/clang/diagnoser.h"

#include <clang/AST/ASTContext.h>
#include <clang/AST/Decl.h>
#include <clang/AST/Type.h>
#include <clang/Basic/DiagnosticAST.h>
#include <clang/Basic/DiagnosticIDs.h>
#include <clang/Basic/DiagnosticLex.h>
#include <clang/Basic/DiagnosticParse.h>
#include <clang/Basic/DiagnosticSema.h>
#include <clang/Basic/IdentifierTable.h>
#include <clang/Lex/Preprocessor.h>
#include <clang/Parse/Parser.h>
#include <clang/Sema/Scope.h>
#include <clang/Sema/Sema.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <string_view>
#include <vector>

#include "transpiler/dialects/hnc/machine/machine.h"
#include "transpiler/dialects/hnc/machine/product_names.h"
#include "transpiler/dialects/hnc/parser/clang/diagnoser_rules.h"
#include "transpiler/dialects/hnc/parser/clang/foreign_forms.h"
#include "transpiler/dialects/hnc/syntax/characters.h"

namespace plcxx::hnc {
namespace {

namespace cd = clang::diag;

/// Clang walks through all that was declared of a name before, wrong or not: reading on would grow with the square of
/// the errors. Far more than the 50 that are shown.
constexpr uint32_t kMostErrors = 1000;

/// Clang's own words for what is accepted are warnings that no rule names.
bool IsError(clang::DiagnosticsEngine::Level level) { return level >= clang::DiagnosticsEngine::Error; }

bool IsRefused(clang::DiagnosticsEngine::Level level, const clang::Diagnostic& info) {
  if (IsError(level)) return true;
  if (!clang::DiagnosticIDs::isBuiltinExtensionDiag(info.getID()) || IsAccepted(info.getID())) return false;
  constexpr int kOutsideFunction = 0;
  return info.getID() != cd::ext_extra_semi || info.getRawArg(0) != kOutsideFunction;
}

}  // namespace

std::string Quoted(const std::string& text) { return "'" + text + "'"; }

std::string ArgumentText(const clang::Diagnostic& info, unsigned index) {
  if (index >= info.getNumArgs()) return {};
  switch (info.getArgKind(index)) {
    case clang::DiagnosticsEngine::ak_std_string:
      return info.getArgStdStr(index);
    case clang::DiagnosticsEngine::ak_c_string:
      return info.getArgCStr(index);
    case clang::DiagnosticsEngine::ak_sint:
      return std::to_string(info.getArgSInt(index));
    case clang::DiagnosticsEngine::ak_uint:
      return std::to_string(info.getArgUInt(index));
    case clang::DiagnosticsEngine::ak_tokenkind: {
      const auto kind = static_cast<clang::tok::TokenKind>(info.getRawArg(index));
      if (const char* sign = clang::tok::getPunctuatorSpelling(kind)) return sign;
      if (const char* word = clang::tok::getKeywordSpelling(kind)) return word;
      return kind == clang::tok::identifier ? "a name" : clang::tok::getTokenName(kind);
    }
    case clang::DiagnosticsEngine::ak_identifierinfo: {
      const clang::IdentifierInfo* name = info.getArgIdentifier(index);
      return name == nullptr ? std::string() : name->getName().str();
    }
    case clang::DiagnosticsEngine::ak_qualtype: {
      clang::PrintingPolicy policy{clang::LangOptions()};
      policy.AnonymousTagLocations = false;  // the place in the text that Clang was given
      return clang::QualType::getFromOpaquePtr(reinterpret_cast<void*>(info.getRawArg(index))).getAsString(policy);
    }
    case clang::DiagnosticsEngine::ak_declarationname:
      return clang::DeclarationName::getFromOpaqueInteger(info.getRawArg(index)).getAsString();
    case clang::DiagnosticsEngine::ak_nameddecl:
      return reinterpret_cast<const clang::NamedDecl*>(info.getRawArg(index))->getNameAsString();
    default:
      return {};
  }
}

source::Range Diagnoser::RangeOf(const clang::Diagnostic& info) const {
  const bool syntax =
      session_.parser != nullptr && clang::DiagnosticIDs::getCategoryNumberForDiag(info.getID()) ==
                                        clang::DiagnosticIDs::getCategoryNumberForDiag(cd::err_expected);
  // The token at which the syntax breaks, not the end of the one before it.
  const clang::SourceLocation place = syntax && session_.parser->getCurToken().getLocation().isValid()
                                          ? session_.parser->getCurToken().getLocation()
                                          : info.getLocation();
  const source::Range range = session_.places.OfToken(session_.places.IncludedAt(place));
  return range.begin == 0 ? session_.output.unit.last_token : range;
}

std::string Diagnoser::TokenAt(source::Range range) const {
  const clang::Token* current = session_.parser == nullptr ? nullptr : &session_.parser->getCurToken();
  if (current != nullptr && current->is(clang::tok::eof)) return "the end of the file";
  if (current != nullptr && session_.places.OfToken(current->getLocation()) == range && !current->isAnnotation()) {
    const std::string token = Quoted(session_.clang.getPreprocessor().getSpelling(*current));
    if (!current->getLocation().isMacroID()) return token;
    const std::string macro = Written(range);
    return std::ranges::all_of(macro, IsWord) && Quoted(macro) != token ? token + " of the macro " + Quoted(macro)
                                                                        : token;
  }
  return Quoted(Written(range));
}

bool Diagnoser::ByTable(const clang::Diagnostic& info) {
  if (const Extension* form = FindExtension(info.getID())) {
    session_.findings().Report(RangeOf(info), diag::HncExtension, form->words, form->remedy);
    return true;
  }
  const Rule* rule = FindRule(info.getID());
  if (rule == nullptr) return false;
  const source::Range range = RangeOf(info);
  std::string text = rule->words;
  if (rule->argument == kToken) text = TokenAt(range);
  if (rule->argument >= 0) text = ArgumentText(info, static_cast<unsigned>(rule->argument));
  if (text.starts_with(kProductPrefix)) {  // what FilterTokens makes of asm, where no statement can stand
    session_.findings().Report(range, diag::HncAssembler, "outside a function");
    return true;
  }
  const bool system = FindSystemName(text).has_value() || FindSystemFunction(text) != nullptr || text == "plc1_time" ||
                      text == "plc2_time";
  const bool type =
      info.getID() == cd::err_redefinition_different_type || info.getID() == cd::err_redeclaration_different_type;
  const bool undeclared = rule->message == &diag::HncUndeclared;
  if (undeclared && (ManualNotation(range, text) || MacroWithParameters(range, text))) return true;
  if (undeclared && (mistyped_.contains(text) || !IsFirstUse(range, text))) return true;  // reported
  if (undeclared || info.getID() == cd::err_unknown_typename) {
    const std::string name = Written(range);
    if (const std::string declared = NameAfter(range.end); !declared.empty()) mistyped_.insert(declared);
    if (const std::string remedy = MeantByName(name); !remedy.empty()) {
      session_.findings().Report(range, undeclared ? diag::HncUndeclaredForeign : diag::HncSyntaxForeign,
                                 undeclared ? text : Quoted(name), remedy);
      return true;
    }
  }
  if (undeclared) {
    if (const std::string near = NearDeclared(text); !near.empty()) {
      session_.findings().Report(range, diag::HncUndeclaredNear, text, near);
      return true;
    }
  }
  if (system && type) {
    const bool period = text == "plc1_time" || text == "plc2_time";
    session_.findings().Report(range, diag::HncConflictingSystem, text,
                               period ? "define it as unsigned " + text + ", or leave it out: plc.h declares it"
                                      : "leave it out: plc.h declares it");
  } else if (rule->message == &diag::HncRedefinition && system) {
    session_.findings().Report(range, diag::HncRedefinitionSystem, text);
  } else if (const std::string_view remedy = RemedyOfTypes(text); rule->argument == kWords && !remedy.empty()) {
    session_.findings().Report(range, diag::HncIncompatibleHint, text, remedy);
  } else {
    session_.findings().Report(range, *rule->message, text);
  }
  return true;
}

bool Diagnoser::Calls(const clang::Diagnostic& info) {
  switch (info.getID()) {
    case cd::err_typecheck_call_too_few_args:
    case cd::err_typecheck_call_too_few_args_one:
    case cd::err_typecheck_call_too_few_args_at_least:
    case cd::err_typecheck_call_too_few_args_at_least_one:
    case cd::err_typecheck_call_too_many_args:
    case cd::err_typecheck_call_too_many_args_one:
    case cd::err_typecheck_call_too_many_args_at_most:
    case cd::err_typecheck_call_too_many_args_at_most_one:
      session_.findings().Report(RangeOf(info), diag::HncArgumentMismatch);
      return true;
    case cd::err_too_few_args_in_macro_invoc:
      session_.findings().Report(RangeOf(info), diag::HncPreprocessorArguments, "few");
      return true;
    case cd::err_too_many_args_in_macro_invoc:
      session_.findings().Report(RangeOf(info), diag::HncPreprocessorArguments, "many");
      return true;
    case cd::err_typecheck_array_not_modifiable_lvalue:
      session_.findings().Report(RangeOf(info), diag::HncArrayNotAssignable,
                                 info.getNumRanges() > 0
                                     ? Quoted(Written(session_.places.Of(info.getRange(0).getAsRange())))
                                     : TokenAt(RangeOf(info)));
      return true;
    case cd::ext_param_promoted_not_compatible_with_prototype:
      session_.findings().Report(RangeOf(info), diag::HncConflictingTypes, Written(RangeOf(info)));
      return true;
    case cd::err_function_definition_not_allowed:
      session_.findings().Report(RangeOf(info), diag::HncFunctionInside);
      return true;
    case cd::err_multiple_default_labels_defined:
      session_.findings().Report(RangeOf(info), diag::HncDuplicateDefault);
      return true;
    case cd::err_pp_expects_filename:
      session_.findings().Report(RangeOf(info), diag::HncIncludeNothing);
      return true;
    case cd::err_unterminated_block_comment:
      session_.findings().Report(RangeOf(info), diag::HncUnterminatedComment);
      return true;
    case cd::ext_unterminated_char_or_string:
      if (info.getArgSInt(0) == 1) {
        session_.findings().Report(RangeOf(info), diag::HncUnterminatedString);
      } else {
        session_.findings().Report(RangeOf(info), diag::HncUnterminatedCharacter);
      }
      return true;
    default:
      return false;
  }
}

/// A pointer among the operands, or none: E019 or E018.
bool Diagnoser::Operands(const clang::Diagnostic& info) {
  const auto is_pointer = [&](unsigned index) {
    if (index >= info.getNumArgs() || info.getArgKind(index) != clang::DiagnosticsEngine::ak_qualtype) return false;
    const auto type = clang::QualType::getFromOpaquePtr(reinterpret_cast<void*>(info.getRawArg(index)));
    return !type.isNull() && (type->isPointerType() || type->isArrayType());
  };
  switch (info.getID()) {
    case cd::err_typecheck_invalid_operands:
    case cd::err_typecheck_unary_expr:
    case cd::err_typecheck_statement_requires_integer:
    case cd::err_typecheck_indirection_requires_pointer:
    case cd::err_typecheck_illegal_increment_decrement:
    case cd::err_typecheck_subscript_not_integer:
      break;
    default:
      return false;
  }
  const auto is_array = [&] {
    return info.getArgKind(0) == clang::DiagnosticsEngine::ak_qualtype &&
           clang::QualType::getFromOpaquePtr(reinterpret_cast<void*>(info.getRawArg(0)))->isArrayType();
  };
  if (info.getID() == cd::err_typecheck_illegal_increment_decrement && is_array()) {
    session_.findings().Report(RangeOf(info), diag::HncArrayNotAssignable, TokenAt(RangeOf(info)));
    return true;
  }
  if (info.getID() == cd::err_typecheck_statement_requires_integer) {
    session_.findings().Report(RangeOf(info), diag::HncPointerAsValue, "the selector of a switch is no integer");
    return true;
  }
  // `F_ui[3] |= 1` stores into the table.
  const std::string sign = Written(RangeOf(info));
  if (is_pointer(0) && sign.size() >= 2 && sign.ends_with('=') && sign != "==" && sign != "!=" && sign != "<=" &&
      sign != ">=" && info.getNumRanges() > 0) {
    const source::Range target = session_.places.Of(info.getRange(0).getAsRange());
    const std::string text = Written(target);
    if (text.find_first_of("[(") != std::string::npos) {
      session_.findings().Report(target, diag::HncPointerTable, Quoted(text));
      return true;
    }
  }
  const bool invalid_indirection = info.getID() == cd::err_typecheck_indirection_requires_pointer;
  if (invalid_indirection) {
    ReportNoPointer(info);
  } else if (is_pointer(0) || is_pointer(1)) {
    if (const std::string area = AreaAmong(info); !area.empty()) {
      session_.findings().Report(RangeOf(info), diag::HncAreaAsValue, area);
    } else {
      const unsigned pointer = is_pointer(0) ? 0 : 1;
      const std::string operand = pointer < info.getNumRanges()
                                      ? Quoted(Written(session_.places.Of(info.getRange(pointer).getAsRange())))
                                      : "an operand";
      session_.findings().Report(RangeOf(info), diag::HncPointerAsValue, operand + " is an address");
    }
  } else {
    std::string types = Quoted(ArgumentText(info, 0));
    if (info.getNumArgs() > 1) types += " and " + Quoted(ArgumentText(info, 1));
    session_.findings().Report(RangeOf(info), diag::HncIncompatible, "an operator cannot take " + types);
  }
  return true;
}

bool Diagnoser::Conversions(const clang::Diagnostic& info) {
  switch (info.getID()) {
    case cd::err_typecheck_convert_incompatible:
    case cd::ext_typecheck_convert_incompatible_pointer:
      session_.findings().Report(RangeOf(info), diag::HncIncompatible,
                                 Quoted(ArgumentText(info, 0)) + " and " + Quoted(ArgumentText(info, 1)));
      return true;
    case cd::ext_typecheck_convert_incompatible_pointer_sign: {
      const std::string first = ArgumentText(info, 0), second = ArgumentText(info, 1);
      const auto is_char = [](const std::string& type) { return type.find("char") != std::string::npos; };
      if (is_char(first) && is_char(second)) return true;  // accepted, 10.4
      session_.findings().Report(RangeOf(info), diag::HncIncompatible, Quoted(first) + " and " + Quoted(second));
      return true;
    }
    default:
      return false;
  }
}

namespace {

/// Behind a comment, or a constant in quotes, that begins there; none does: the same place.
size_t BehindText(std::string_view text, size_t at) {
  const auto behind = [&](size_t found, size_t length) {
    return found == std::string_view::npos ? text.size() : found + length;
  };
  if (text.substr(at).starts_with("/*")) return behind(text.find("*/", at + 2), 2);
  if (text.substr(at).starts_with("//")) return behind(text.find('\n', at), 1);
  if (text[at] != '\'' && text[at] != '"') return at;
  const char quote = text[at];
  for (size_t end = at + 1; end < text.size(); ++end) {
    if (text[end] == '\\') {
      ++end;
    } else if (text[end] == quote) {
      return end + 1;
    }
  }
  return text.size();
}

std::vector<std::string_view> WordsOf(std::string_view text) {
  std::vector<std::string_view> words;
  for (size_t at = 0; at < text.size();) {
    size_t end = at;
    while (end < text.size() && IsWord(text[end])) ++end;
    if (end > at) words.push_back(text.substr(at, end - at));
    at = end > at ? end : std::max(BehindText(text, at), at + 1);
  }
  return words;
}

}  // namespace

/// Clang can compute with the values of const variables, too.
bool Diagnoser::NamesVariable(const clang::Diagnostic& info) const {
  if (session_.parser == nullptr || info.getNumRanges() == 0) return true;
  clang::Preprocessor& preprocessor = session_.clang.getPreprocessor();
  std::vector<clang::IdentifierInfo*> words;
  const std::string text = Written(session_.places.Of(info.getRange(0).getAsRange()));
  for (const std::string_view word : WordsOf(text)) words.push_back(preprocessor.getIdentifierInfo(word));
  for (size_t i = 0; i < words.size(); ++i) {
    clang::IdentifierInfo* const word = words[i];
    if (const clang::MacroInfo* macro = preprocessor.getMacroInfo(word)) {
      for (const clang::Token& token : macro->tokens()) {
        clang::IdentifierInfo* const part = token.getIdentifierInfo();
        const bool is_parameter = part != nullptr && macro->getParameterNum(part) >= 0;
        if (part != nullptr && !is_parameter && std::ranges::find(words, part) == words.end()) words.push_back(part);
      }
    }
    const clang::NamedDecl* const found = session_.parser->getActions().LookupSingleName(
        session_.parser->getCurScope(), word, info.getLocation(), clang::Sema::LookupOrdinaryName);
    if (llvm::isa_and_nonnull<clang::VarDecl>(found)) return true;
  }
  return false;
}

/// What was no constant for Clang only overflows: it wraps, with a warning (6.2).
void Diagnoser::AcceptOverflow(const clang::Diagnostic& info) {
  is_folded_ = false;
  reported_last_ = false;
  const source::Range range = session_.findings().all().back().range;
  session_.findings().all().pop_back();
  if ((session_.parser->getCurScope()->getFlags() & clang::Scope::EnumScope) != 0) return;  // folding tells of it
  int64_t value = 0;
  const std::string digits = ArgumentText(info, 0);
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const auto type = clang::QualType::getFromOpaquePtr(reinterpret_cast<void*>(info.getRawArg(1)));
  const bool is_long = session_.clang.getASTContext().getTypeSize(type) > 16;
  const int64_t wrapped = is_long ? static_cast<int32_t>(value) : static_cast<int16_t>(value);
  session_.findings().Report(range, diag::HncConstantOverflow, std::to_string(wrapped));
}

/// "the other one": Clang's notes that name an earlier declaration or bracket.
void Diagnoser::AddNote(const clang::Diagnostic& info) {
  const bool wild_shift =
      info.getID() == cd::note_constexpr_large_shift || info.getID() == cd::note_constexpr_negative_shift;
  if (folded_size_.begin != 0 && wild_shift) {
    session_.findings().SetPhase(Phase::kMeaning);
    session_.findings().Report(folded_size_, diag::HncConstantRequired, "with a shift count inside the width");
    folded_size_ = {};
    return;
  }
  if (!reported_last_ || session_.places.InProduct(info.getLocation())) return;
  if (is_folded_ && info.getID() == cd::note_constexpr_overflow) return AcceptOverflow(info);
  const auto add = [&](const char* text) {
    session_.findings().all().back().notes.push_back({session_.places.OfToken(info.getLocation()), text});
  };
  switch (info.getID()) {
    case cd::note_previous_definition:
    case cd::note_previous_declaration:
    case cd::note_previous_implicit_declaration:
      if (!last_is_in_product_) return add("the other one is here");
      session_.findings().all().back().range = session_.places.OfToken(info.getLocation());
      return;
    case cd::note_duplicate_case_prev: {
      // Clang walks through the labels from the last to the first.
      Finding& finding = session_.findings().all().back();
      const source::Range other = session_.places.OfToken(info.getLocation());
      const source::Range later = other.begin > finding.range.begin ? other : finding.range;
      const source::Range earlier = other.begin > finding.range.begin ? finding.range : other;
      finding.range = later;
      finding.notes.push_back({earlier, "the first one is here"});
      return;
    }
    case cd::note_matching:
      return add("to match this");
    default:
      return;
  }
}

void Diagnoser::HandleDiagnostic(clang::DiagnosticsEngine::Level level, const clang::Diagnostic& info) {
  if (level == clang::DiagnosticsEngine::Note) return AddNote(info);
  if (IsError(level)) ++session_.errors;
  if (info.getID() == cd::warn_implicit_function_decl || info.getID() == cd::ext_implicit_function_decl_c99) {
    session_.output.open_names.push_back(ArgumentText(info, 0));
  }
  reported_last_ = is_folded_ = false;
  // Accepted, but not with each operation: the note after it tells.
  folded_size_ = info.getID() == cd::ext_vla_folded_to_constant ? RangeOf(info) : source::Range{};
  if (session_.stopped || IsFoundElsewhere(info.getID())) return;
  if (!IsError(level) && info.getLocation().isValid() && session_.places.InProduct(info.getLocation())) return;
  const size_t before = session_.findings().all().size();
  const llvm::StringRef category =
      clang::DiagnosticIDs::getCategoryNameFromID(clang::DiagnosticIDs::getCategoryNumberForDiag(info.getID()));
  const bool lexical = category.starts_with("Lexical"), syntactic = category.starts_with("Parse");
  session_.findings().SetPhase(lexical ? Phase::kText : syntactic ? Phase::kSyntax : Phase::kMeaning);
  const bool known = ByTable(info) || Unfinished(info) || Calls(info) || Operands(info) || Conversions(info);
  if (!known && IsRefused(level, info)) {
    if (lexical) {
      session_.findings().Report(RangeOf(info), diag::HncPreprocessor, "this cannot be read");
    } else if (syntactic) {
      Syntax(info);
    } else {
      session_.findings().Report(RangeOf(info), diag::HncIncompatible, TokenAt(RangeOf(info)) + " does not fit here");
    }
  }
  reported_last_ = session_.findings().all().size() > before;
  is_folded_ = reported_last_ && info.getID() == cd::ext_expr_not_ice && !NamesVariable(info);
  last_is_in_product_ = session_.places.InProduct(info.getLocation());
  if (session_.parser == nullptr || !reported_last_) return;
  if (session_.findings().all().back().row.severity == diag::Severity::kError && ++errors_ == kMostErrors)
    session_.Stop();
}

}  // namespace plcxx::hnc
