#include "transpiler/dialects/hnc/parser/clang/diagnoser_rules.h"

#include <clang/AST/ASTContext.h>
#include <clang/Basic/DiagnosticAST.h>
#include <clang/Basic/DiagnosticLex.h>
#include <clang/Basic/DiagnosticParse.h>
#include <clang/Basic/DiagnosticSema.h>

#include <algorithm>
#include <iterator>

namespace plcxx::hnc {
namespace {

namespace cd = clang::diag;

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
    {cd::ext_delimited_escape_sequence, &diag::HncEscape, kWords, "digits in braces"},
    {cd::warn_ucn_not_valid_in_c89_literal, &diag::HncEscape, kWords, "\\u"},
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
    {cd::ext_pp_embed_directive, &diag::HncPreprocessor, kWords, "unknown directive #embed"},
    {cd::ext_pp_gnu_line_directive, &diag::HncPreprocessor, kWords, "unknown directive: behind '#' stands its name"},
    {cd::ext_pp_comma_expr, &diag::HncPreprocessor, kWords, "a comma in #if"},
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
    {cd::ext_typecheck_cast_nonscalar, &diag::HncIncompatible, kWords, "a cast gives a number or a pointer"},
    // accepted
    {cd::ext_c_label_end_of_compound_statement, &diag::HncWithoutMeaning, kWords, "a label without a statement"},
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
    {cd::ext_c_label_followed_by_declaration, "declaration behind a label",
     "move it to the beginning of its block, and write the initial value as an assignment here"},
    {cd::ext_anonymous_union, "union without a name as a member", kMemberName},
    {cd::ext_clang_c_enum_fixed_underlying_type, "type of an enumeration", "leave it out: an enumeration is an int"},
    {cd::warn_ext_c23_attributes, "attribute", "leave it out"},
    {cd::ext_c99_array_usage, "static or qualifier in an array", "write the size alone, or a pointer"},
};

}  // namespace

const Rule* FindRule(unsigned id) {
  const Rule* const rule = std::ranges::find(kRules, id, &Rule::id);
  return rule == std::end(kRules) ? nullptr : rule;
}

const Extension* FindExtension(unsigned id) {
  const Extension* const extension = std::ranges::find(kExtensions, id, &Extension::id);
  return extension == std::end(kExtensions) ? nullptr : extension;
}

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

bool IsAccepted(unsigned id) {
  switch (id) {
    case cd::ext_line_comment:  // from here: texts
    case cd::ext_string_too_long:
    case cd::ext_multi_line_line_comment:
    case cd::ext_no_newline_eof:
    case cd::warn_bad_string_encoding:
    case cd::warn_bad_character_encoding:
    case cd::warn_invalid_utf8_in_comment:
    case cd::ext_token_used:         // FilterTokens looks at all words
    case cd::ext_empty_fnmacro_arg:  // from here: the preprocessor
    case cd::ext_c99_whitespace_required_after_macro_name:
    case cd::ext_missing_whitespace_after_macro_name:
    case cd::ext_pp_extra_tokens_at_eol:
    case cd::ext_embedded_directive:
    case cd::warn_pp_macro_hides_keyword:
    case cd::warn_defined_in_function_type_macro:
    case cd::ext_enumerator_list_comma_c:  // from here: the grammar
    case cd::ext_empty_translation_unit:
    case cd::ext_ident_list_in_param:
    case cd::ext_parameter_name_omitted_c23:
    case cd::ext_missing_type_specifier:
    case cd::ext_param_not_declared:
    case cd::ext_no_declarators:
    case cd::ext_standalone_specifier:
    case cd::ext_typedef_without_a_name:
    case cd::ext_duplicate_declspec:
    case cd::ext_warn_duplicate_declspec:
    case cd::ext_forward_ref_enum_def:
    case cd::ext_many_braces_around_init:
    case cd::ext_aggregate_init_not_constant:  // from here: meanings
    case cd::ext_initializer_overrides:
    case cd::ext_implicit_function_decl_c99:
    case cd::ext_implicit_lib_function_decl:
    case cd::ext_implicit_lib_function_decl_c99:
    case cd::ext_use_out_of_scope_declaration:
    case cd::err_func_returning_qualified_void:
    case cd::ext_subscript_non_lvalue:
    case cd::ext_typecheck_addrof_void:  // what it is the address of has been refused
    case cd::ext_vla_folded_to_constant:
    case cd::warn_strict_prototypes:
    case cd::warn_undefined_internal:
    case cd::warn_gnu_null_ptr_arith:
    case cd::ext_flexible_array_init:  // from here: consequences
    case cd::ext_flexible_array_in_array:
    case cd::ext_flexible_array_empty_aggregate_gnu:
    case cd::ext_flexible_array_union_gnu:
    case cd::ext_typecheck_ordered_comparison_of_pointer_and_zero:
    case cd::ext_typecheck_ordered_comparison_of_function_pointers:
    case cd::ext_typecheck_comparison_of_fptr_to_void:
    case cd::ext_typecheck_convert_pointer_void_func:
    case cd::ext_cast_fn_obj:
    case cd::ext_main_used:
    case cd::ext_main_returns_nonint:
    case cd::ext_variadic_main:
      return true;
    default:
      return false;
  }
}

}  // namespace plcxx::hnc
