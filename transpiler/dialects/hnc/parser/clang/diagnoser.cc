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

#include <algorithm>
#include <cstdio>

#include "transpiler/dialects/hnc/machine/machine.h"
#include "transpiler/dialects/hnc/machine/product_names.h"
#include "transpiler/dialects/hnc/parser/clang/foreign_forms.h"
#include "transpiler/dialects/hnc/syntax/characters.h"

namespace plcxx::hnc {
namespace {

namespace cd = clang::diag;

/// Where the text of a message's parameter comes from, apart from the arguments 0, 1, ...
constexpr int kToken = -1;  // the token at the place, in quotes
constexpr int kWords = -2;  // Rule::words

struct Rule {
  unsigned id;
  const diag::Message<diag::Text>* message;
  int argument;
  const char* words = "";
};

// What is not here goes by its category: lexical E007, syntax E001, meaning E018.
const Rule kRules[] = {
    // literals
    {cd::ext_empty_character, &diag::HncCharacterConstant, kWords, "''"},
    {cd::err_invalid_digit, &diag::HncConstantDigits, kToken},
    {cd::err_integer_literal_too_large, &diag::HncConstantTooLarge, kToken},
    {cd::ext_integer_literal_too_large_for_signed, &diag::HncConstantTooLarge, kToken},
    {cd::err_character_too_large, &diag::HncCharacterConstant, kToken},
    {cd::err_escape_too_large, &diag::HncEscape, kWords, "above 255"},
    {cd::err_hex_escape_no_digits, &diag::HncEscape, kWords, "\\x without digits"},
    {cd::ext_unknown_escape, &diag::HncEscape, 0},
    {cd::ext_nonstandard_escape, &diag::HncEscape, 0},
    {cd::err_enumerator_wrapped, &diag::HncConstantTooLarge, kToken},
    // preprocessor
    {cd::err_pp_hash_error, &diag::HncErrorDirective, 0},
    {cd::err_pp_unterminated_conditional, &diag::HncUnterminatedConditional, kWords, "this #if"},
    {cd::err_pp_empty_filename, &diag::HncCannotOpenInclude, kWords, ""},
    {cd::ext_pp_redef_builtin_macro, &diag::HncMacroRedefined, kToken},
    {cd::ext_pp_undef_builtin_macro, &diag::HncMacroRedefined, kToken},
    {cd::err_pp_invalid_directive, &diag::HncPreprocessor, kWords, "unknown directive"},
    {cd::ext_pp_warning_directive, &diag::HncPreprocessor, kWords, "unknown directive #warning"},
    {cd::ext_pp_include_next_directive, &diag::HncPreprocessor, kWords, "unknown directive #include_next"},
    {cd::ext_pp_ident_directive, &diag::HncPreprocessor, kWords, "unknown directive #ident"},
    {cd::ext_pp_import_directive, &diag::HncPreprocessor, kWords, "unknown directive #import"},
    {cd::ext_c23_pp_directive, &diag::HncPreprocessor, kWords, "unknown directive"},
    {cd::err_pp_endif_without_if, &diag::HncPreprocessor, kWords, "#endif without #if"},
    {cd::pp_err_else_without_if, &diag::HncPreprocessor, kWords, "#else without #if"},
    {cd::pp_err_elif_without_if, &diag::HncPreprocessor, kWords, "#elif without #if"},
    {cd::pp_err_else_after_else, &diag::HncPreprocessor, kWords, "a second #else"},
    {cd::pp_err_elif_after_else, &diag::HncPreprocessor, kWords, "#elif behind #else"},
    {cd::err_pp_division_by_zero, &diag::HncPreprocessor, kWords, "division by zero in #if"},
    {cd::err_pp_remainder_by_zero, &diag::HncPreprocessor, kWords, "division by zero in #if"},
    {cd::err_pp_expected_value_in_expr, &diag::HncPreprocessor, kWords, "a value is missing in #if"},
    {cd::err_pp_expr_bad_token_start_expr, &diag::HncPreprocessor, kWords, "#if takes integer constants only"},
    {cd::err_pp_expr_bad_token_binop, &diag::HncPreprocessor, kWords, "an operator is missing in #if"},
    {cd::err_pp_expr_bad_token_lparen, &diag::HncPreprocessor, kWords, "no function-like macro of this name in #if"},
    {cd::err_pp_illegal_floating_literal, &diag::HncPreprocessor, kWords, "floating constant in #if"},
    {cd::err_pp_macro_not_identifier, &diag::HncPreprocessor, kWords, "a macro has a name"},
    {cd::err_pp_missing_macro_name, &diag::HncPreprocessor, kWords, "the name of a macro is missing"},
    {cd::ext_pp_line_zero, &diag::HncPreprocessor, kWords, "#line takes a number from 1 to 32767"},
    {cd::ext_pp_line_too_big, &diag::HncPreprocessor, kWords, "#line takes a number from 1 to 32767"},
    {cd::err_pp_stringize_not_parameter, &diag::HncPreprocessor, kWords, "behind '#' stands a parameter of the macro"},
    {cd::err_pp_bad_paste, &diag::HncPreprocessor, kWords, "'##' does not join these to one token"},
    {cd::err_pp_operator_used_as_macro_name, &diag::HncPreprocessor, kWords, "'defined' is no name of a macro"},
    {cd::err_paste_at_start, &diag::HncPreprocessor, kWords, "'##' at the beginning of a macro"},
    {cd::err_paste_at_end, &diag::HncPreprocessor, kWords, "'##' at the end of a macro"},
    // names
    {cd::err_undeclared_var_use, &diag::HncUndeclared, 0},
    {cd::err_undeclared_use, &diag::HncUndeclared, 0},
    {cd::err_unknown_typename, &diag::HncSyntaxAt, kToken},
    {cd::err_no_member, &diag::HncNoMember, 0},
    {cd::err_undeclared_label_use, &diag::HncUndefinedLabel, 0},
    {cd::err_redefinition, &diag::HncRedefinition, 0},
    {cd::err_redefinition_of_label, &diag::HncRedefinition, 0},
    {cd::err_redefinition_of_enumerator, &diag::HncRedefinition, 0},
    {cd::err_redefinition_different_kind, &diag::HncRedefinition, 0},
    {cd::err_redefinition_different_type, &diag::HncRedefinition, 0},
    {cd::err_redeclaration_different_type, &diag::HncRedefinition, 0},
    {cd::err_redefinition_different_typedef, &diag::HncRedefinition, 2},
    {cd::ext_redefinition_of_typedef, &diag::HncRedefinition, 0},
    {cd::err_nested_redefinition, &diag::HncRedefinition, 0},
    {cd::err_use_with_wrong_tag, &diag::HncRedefinition, 0},
    {cd::err_param_redefinition, &diag::HncRedefinition, 0},
    {cd::err_duplicate_member, &diag::HncRedefinition, 0},
    {cd::err_static_non_static, &diag::HncRedefinition, 0},
    {cd::err_non_static_static, &diag::HncRedefinition, 0},
    {cd::err_extern_non_extern, &diag::HncRedefinition, 0},
    {cd::err_non_extern_extern, &diag::HncRedefinition, 0},
    {cd::err_conflicting_types, &diag::HncConflictingTypes, 0},
    // places
    {cd::err_duplicate_case, &diag::HncDuplicateCase, 0},
    {cd::err_duplicate_case_differing_expr, &diag::HncDuplicateCase, 0},
    {cd::err_break_not_in_loop_or_switch, &diag::HncMisplaced, kWords, "break"},
    {cd::err_continue_not_in_loop, &diag::HncMisplaced, kWords, "continue"},
    {cd::err_case_not_in_switch, &diag::HncMisplaced, kWords, "case"},
    {cd::err_default_not_in_switch, &diag::HncMisplaced, kWords, "default"},
    // what can be assigned
    {cd::err_typecheck_assign_const, &diag::HncNotAssignable, kWords, "it is const"},
    {cd::err_typecheck_expression_not_modifiable_lvalue, &diag::HncNotAssignable, kWords, "it is a value"},
    {cd::err_typecheck_lvalue_casts_not_supported, &diag::HncNotAssignable, kWords, "a cast is a value"},
    {cd::err_typecheck_non_object_not_modifiable_lvalue, &diag::HncNotAssignable, kWords, "a function is no variable"},
    {cd::err_typecheck_incomplete_type_not_modifiable_lvalue, &diag::HncNotAssignable, kWords,
     "an array is no variable"},
    {cd::err_typecheck_invalid_lvalue_addrof, &diag::HncNotAssignable, kWords, "a value has no address"},
    {cd::err_typecheck_address_of, &diag::HncNotAssignable, kWords, "it has no address"},
    // constants
    {cd::err_expr_not_ice, &diag::HncConstantRequired, kWords, "here"},
    {cd::ext_expr_not_ice, &diag::HncConstantRequired, kWords, "here"},
    {cd::err_init_element_not_constant, &diag::HncConstantRequired, kWords, "to initialise static data"},
    {cd::err_decl_negative_array_size, &diag::HncConstantRequired, kWords, "that is not negative"},
    {cd::err_typecheck_negative_array_size, &diag::HncConstantRequired, kWords, "that is not negative"},
    {cd::err_array_size_non_int, &diag::HncConstantRequired, kWords, "as the size of an array"},
    {cd::err_array_too_large, &diag::HncConstantRequired, kWords, "that is smaller"},
    {cd::err_vla_decl_in_file_scope, &diag::HncConstantRequired, kWords, "as the size of an array"},
    {cd::err_vla_decl_has_static_storage, &diag::HncConstantRequired, kWords, "as the size of an array"},
    {cd::err_vm_decl_in_file_scope, &diag::HncConstantRequired, kWords, "as the size of an array"},
    {cd::err_bitfield_width_exceeds_type_width, &diag::HncConstantRequired, kWords,
     "as the width of a bit-field: too wide"},
    {cd::err_anon_bitfield_has_negative_width, &diag::HncConstantRequired, kWords, "as the width of a bit-field"},
    {cd::err_bitfield_has_negative_width, &diag::HncConstantRequired, kWords, "as the width of a bit-field"},
    {cd::err_bitfield_has_zero_width, &diag::HncConstantRequired, kWords, "as the width of a bit-field with a name"},
    {cd::err_ice_not_integral, &diag::HncConstantRequired, kWords, "of integer type"},
    // sizes
    {cd::err_typecheck_decl_incomplete_type, &diag::HncIncomplete, 0},
    {cd::ext_typecheck_decl_incomplete_type, &diag::HncIncomplete, 0},
    {cd::err_tentative_def_incomplete_type, &diag::HncIncomplete, 0},
    {cd::err_sizeof_alignof_incomplete_or_sizeless_type, &diag::HncIncomplete, kWords,
     "sizeof of something without a size"},
    {cd::ext_sizeof_alignof_void_type, &diag::HncIncomplete, kWords, "sizeof of void"},
    {cd::ext_sizeof_alignof_function_type, &diag::HncIncomplete, kWords, "sizeof of a function"},
    {cd::err_sizeof_alignof_function_type, &diag::HncIncomplete, kWords, "sizeof of a function"},
    {cd::err_field_incomplete_or_sizeless, &diag::HncIncomplete, 0},
    {cd::err_array_incomplete_or_sizeless_type, &diag::HncIncomplete, 0},
    {cd::err_typecheck_incomplete_array_needs_initializer, &diag::HncIncomplete, kWords, "an array without a size"},
    {cd::err_typecheck_incomplete_tag, &diag::HncIncomplete, 0},
    {cd::err_incomplete_type, &diag::HncIncomplete, 0},
    {cd::err_dereference_incomplete_type, &diag::HncIncomplete, 0},
    {cd::err_subscript_incomplete_or_sizeless_type, &diag::HncIncomplete, 0},
    {cd::err_typecheck_arithmetic_incomplete_or_sizeless_type, &diag::HncIncomplete, 0},
    {cd::err_typecheck_cast_to_incomplete, &diag::HncIncomplete, 0},
    {cd::err_call_incomplete_argument, &diag::HncIncomplete, 0},
    {cd::err_call_incomplete_return, &diag::HncIncomplete, 0},
    {cd::err_call_function_incomplete_return, &diag::HncIncomplete, 0},
    {cd::err_func_def_incomplete_result, &diag::HncIncomplete, 0},
    {cd::err_param_with_void_type, &diag::HncIncomplete, kWords, "a parameter of type void"},
    {cd::ext_gnu_void_ptr, &diag::HncIncomplete, kWords, "arithmetic with a pointer to void"},
    {cd::ext_gnu_ptr_func_arith, &diag::HncIncomplete, kWords, "arithmetic with a pointer to a function"},
    {cd::ext_gnu_subscript_void_type, &diag::HncIncomplete, kWords, "an element of void"},
    {cd::ext_typecheck_indirection_through_void_pointer, &diag::HncIncomplete, kWords, "'*' of a pointer to void"},
    {cd::ext_forward_ref_enum, &diag::HncIncomplete, kWords, "the enumeration is not defined yet"},
    {cd::ext_flexible_array_in_struct, &diag::HncIncomplete, 0},
    {cd::ext_c99_flexible_array_member, &diag::HncIncomplete, 0},
    // types
    {cd::ext_excess_initializers, &diag::HncIncompatible, kWords, "more initialisers than there is room for"},
    {cd::ext_excess_initializers_in_char_array_initializer, &diag::HncIncompatible, kWords,
     "more initialisers than there is room for"},
    {cd::err_excess_initializers, &diag::HncIncompatible, kWords, "more initialisers than there is room for"},
    {cd::ext_initializer_string_for_char_array_too_long, &diag::HncIncompatible, kWords,
     "the string is longer than the array"},
    {cd::err_initializer_string_for_char_array_too_long, &diag::HncIncompatible, kWords,
     "the string is longer than the array"},
    {cd::err_array_init_not_init_list, &diag::HncIncompatible, kWords, "an array is initialised with { } or a string"},
    {cd::ext_typecheck_convert_discards_qualifiers, &diag::HncIncompatible, kWords, "const or volatile is lost"},
    {cd::ext_typecheck_comparison_of_distinct_pointers, &diag::HncIncompatible, kWords,
     "pointers to different types are compared"},
    {cd::ext_typecheck_cond_incompatible_pointers, &diag::HncIncompatible, kWords,
     "pointers to different types behind '?'"},
    {cd::ext_return_has_expr, &diag::HncIncompatible, kWords, "a value is returned from a void function"},
    {cd::ext_return_has_void_expr, &diag::HncIncompatible, kWords, "a void function returns nothing"},
    {cd::err_typecheck_member_reference_struct_union, &diag::HncIncompatible, kWords, "'.' needs a struct or union"},
    {cd::err_typecheck_member_reference_arrow, &diag::HncIncompatible, kWords,
     "'->' needs a pointer to a struct or union"},
    {cd::err_typecheck_member_reference_suggestion, &diag::HncIncompatible, kWords,
     "'.' needs a struct, '->' a pointer to one"},
    {cd::err_typecheck_call_not_function, &diag::HncIncompatible, kWords, "what is called is no function"},
    {cd::err_not_integral_type_bitfield, &diag::HncIncompatible, kWords, "a bit-field is int, unsigned or char"},
    {cd::err_not_integral_type_anon_bitfield, &diag::HncIncompatible, kWords, "a bit-field is int, unsigned or char"},
    {cd::ext_typecheck_cond_one_void, &diag::HncIncompatible, kWords, "one side of ':' is void"},
    // accepted
    {cd::ext_c_label_end_of_compound_statement, &diag::HncWithoutMeaning, kWords, "a label without a statement"},
};

/// What the language does not have (3.5), and what to write.
struct Extension {
  unsigned id;
  const char* words;
  const char* remedy;
};

constexpr const char* kFixedParameters = "give the macro a fixed number of parameters";
constexpr const char* kInOrder = "write the values in their order, without names, and 0 for what is left out";
constexpr const char* kAMember = "write a member into it";
constexpr const char* kMemberName = "write a name between its '}' and the ';'";
constexpr const char* kStatementsBefore = "write them as statements in front of this one, or as a function";

const Extension kExtensions[] = {
    {cd::ext_variadic_macro, "macro with any number of arguments", kFixedParameters},
    {cd::ext_named_variadic_macro, "macro with any number of arguments", kFixedParameters},
    {cd::ext_vla, "array of variable length", "write a constant size that is large enough"},
    {cd::ext_typecheck_zero_array_size, "array without elements", "write a size of at least 1"},
    {cd::ext_designated_init, "designated initialiser", kInOrder},
    {cd::ext_gnu_array_range, "designated initialiser", kInOrder},
    {cd::ext_gnu_missing_equal_designator, "designated initialiser", kInOrder},
    {cd::ext_gnu_old_style_field_designator, "designated initialiser", kInOrder},
    {cd::ext_c_empty_initializer, "empty initialiser", "write {0}"},
    {cd::ext_mixed_decls_code, "declaration behind a statement",
     "move it to the beginning of its block, and write the initial value as an assignment here"},
    {cd::ext_c99_variable_decl_in_for_loop, "declaration in the head of for",
     "declare the variable at the beginning of the block, and assign it in the head"},
    {cd::ext_empty_struct_union, "struct or union without members", kAMember},
    {cd::ext_no_named_members_in_struct_union, "struct or union without members", kAMember},
    {cd::ext_c11_anonymous_struct, "struct without a name as a member", kMemberName},
    {cd::ext_gnu_anonymous_struct, "struct without a name as a member", kMemberName},
    {cd::ext_gnu_case_range, "range of cases", "write a case for each value, or an if in front of the switch"},
    {cd::ext_gnu_statement_expr, "statements in an expression", kStatementsBefore},
    {cd::ext_gnu_statement_expr_macro, "statements in an expression", kStatementsBefore},
    {cd::ext_gnu_conditional_expr, "'?:' without its middle operand", "write the condition between '?' and ':' again"},
    {cd::ext_gnu_indirect_goto, "computed goto", "write a switch with a goto in each case"},
    {cd::ext_gnu_address_of_label, "address of a label", "keep a number, and write a switch with a goto in each case"},
    {cd::ext_c99_compound_literal, "compound literal",
     "declare a variable with this initialiser, and write its name here"},
    {cd::ext_c99_longlong, "long long", "write long, which has 32 bits"},
    {cd::ext_typecheck_cast_to_union, "cast to a union", "assign to the member of a union variable"},
    {cd::ext_imaginary_constant, "imaginary constant", "write a real number"},
    {cd::ext_c99_array_usage, "static or qualifier in an array", "write the size alone, or a pointer"},
};

/// Diagnostics that other code of ours reports, or that mean nothing here.
bool IsFoundElsewhere(unsigned id) {
  switch (id) {
    case cd::err_pp_file_not_found:  // MissingInclude
    case cd::err_pp_file_not_found_angled_include_not_fatal:
    case cd::err_pp_include_too_deep:
    case cd::warn_pp_undef_identifier:
    case cd::ext_pp_macro_redef:      // the preprocessor's watcher: blanks do not count
    case cd::ext_enum_value_not_int:  // enumerators in the tree
    case cd::ext_enumerator_increment_too_large:
    case cd::ext_typecheck_convert_pointer_int:  // from here: conversions in the tree
    case cd::err_typecheck_convert_pointer_int:
    case cd::ext_typecheck_convert_int_pointer:
    case cd::err_typecheck_convert_int_pointer:
    case cd::ext_typecheck_cond_pointer_integer_mismatch:
    case cd::ext_typecheck_comparison_of_pointer_integer:
    case cd::err_typecheck_comparison_of_pointer_integer:
    case cd::ext_typecheck_ordered_comparison_of_pointer_integer:
    case cd::ext_typecheck_convert_incompatible_function_pointer:
    case cd::err_typecheck_convert_incompatible_function_pointer:
    case cd::ext_return_missing_expr:  // W25
    case cd::warn_return_missing_expr:
      return true;
    default:
      return false;
  }
}

/// Clang walks through all that was declared of a name before, wrong or not: reading on would grow with the square of
/// the errors. Far more than the 50 that are shown.
constexpr uint32_t kMostErrors = 1000;

/// Clang's own words for what is accepted are warnings that no rule names.
bool IsError(clang::DiagnosticsEngine::Level level) { return level >= clang::DiagnosticsEngine::Error; }

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
  if (const Extension* form = std::ranges::find(kExtensions, info.getID(), &Extension::id);
      form != std::end(kExtensions)) {
    session_.findings().Report(RangeOf(info), diag::HncExtension, form->words, form->remedy);
    return true;
  }
  const Rule* rule = std::ranges::find(kRules, info.getID(), &Rule::id);
  if (rule == std::end(kRules)) return false;
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
  reported_last_ = false;
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
  if (!known && IsError(level)) {
    if (lexical) {
      session_.findings().Report(RangeOf(info), diag::HncPreprocessor, "this cannot be read");
    } else if (syntactic) {
      Syntax(info);
    } else {
      session_.findings().Report(RangeOf(info), diag::HncIncompatible, TokenAt(RangeOf(info)) + " does not fit here");
    }
  }
  reported_last_ = session_.findings().all().size() > before;
  last_is_in_product_ = session_.places.InProduct(info.getLocation());
  if (session_.parser == nullptr || !reported_last_) return;
  if (session_.findings().all().back().row.severity == diag::Severity::kError && ++errors_ == kMostErrors)
    session_.Stop();
}

}  // namespace plcxx::hnc
