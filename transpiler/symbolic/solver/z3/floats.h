// What a function of floating point gives (terms/floats.h), as Z3 has it. For the files of this module only.
//
// In: such a function, its operands as bit vectors. Out: the result as one; every NaN is the same one, as where these
// functions are evaluated. Not its job: when it is worth to ask so, for each of them is a circuit of thousands of bits.
#pragma once

#include <z3++.h>

#include <optional>
#include <string_view>

namespace plcxx::solver {

class Floats {
 public:
  explicit Floats(z3::context& context)
      : context_(context), nearest_(context, Z3_mk_fpa_rne(context)), to_zero_(context, Z3_mk_fpa_rtz(context)) {}

  static bool IsNamed(std::string_view name) { return name.starts_with("f32.") || name.starts_with("f64."); }

  /// None: `name` is no function that is known here.
  std::optional<z3::expr> Result(std::string_view name, const z3::expr_vector& operands) {
    if (!IsNamed(name)) return std::nullopt;
    const bool is_double = name.starts_with("f64.");
    const std::string_view operation = name.substr(4);
    const z3::sort sort = is_double ? context_.fpa_sort<64>() : context_.fpa_sort<32>();
    const auto operand = [&](unsigned index) { return Number(operands[static_cast<int>(index)], sort); };
    const auto binary = [&](auto make) { return Bits(Checked(make(context_, nearest_, operand(0), operand(1)))); };
    if (operation == "add") return binary(Z3_mk_fpa_add);
    if (operation == "mul") return binary(Z3_mk_fpa_mul);
    if (operation == "div") return binary(Z3_mk_fpa_div);
    if (operation == "sqrt") return Bits(Checked(Z3_mk_fpa_sqrt(context_, nearest_, operand(0))));
    if (operation == "rint") return Bits(Checked(Z3_mk_fpa_round_to_integral(context_, nearest_, operand(0))));
    if (operation == "from_s64") return Bits(Checked(Z3_mk_fpa_to_fp_signed(context_, nearest_, operands[0], sort)));
    if (operation == "from_u64") return Bits(Checked(Z3_mk_fpa_to_fp_unsigned(context_, nearest_, operands[0], sort)));
    if (operation == "to_f64" || operation == "to_f32") {
      const z3::sort to = operation == "to_f64" ? context_.fpa_sort<64>() : context_.fpa_sort<32>();
      return Bits(Checked(Z3_mk_fpa_to_fp_float(context_, nearest_, operand(0), to)));
    }
    if (operation == "to_s64") return Whole(operand(0), sort);
    return std::nullopt;
  }

 private:
  z3::expr Checked(Z3_ast ast) {
    context_.check_error();
    return z3::expr(context_, ast);
  }
  z3::expr Number(const z3::expr& bits, const z3::sort& sort) {
    return Checked(Z3_mk_fpa_to_fp_bv(context_, bits, sort));
  }
  z3::expr Bits(const z3::expr& number) {
    const bool is_double = number.get_sort().fpa_sbits() > 24;
    const z3::expr nan =
        is_double ? context_.bv_val(uint64_t{0x7FF8000000000000}, 64) : context_.bv_val(uint64_t{0x7FC00000}, 32);
    return z3::ite(Checked(Z3_mk_fpa_is_nan(context_, number)), nan, Checked(Z3_mk_fpa_to_ieee_bv(context_, number)));
  }
  /// Toward zero; what does not fit is 0.
  z3::expr Whole(const z3::expr& number, const z3::sort& sort) {
    const z3::expr limit = Checked(Z3_mk_fpa_numeral_double(context_, 0x1p63, sort)),
                   least = Checked(Z3_mk_fpa_numeral_double(context_, -0x1p63, sort));
    const z3::expr fits =
        Checked(Z3_mk_fpa_geq(context_, number, least)) && Checked(Z3_mk_fpa_lt(context_, number, limit));
    return z3::ite(fits, Checked(Z3_mk_fpa_to_sbv(context_, to_zero_, number, 64)), context_.bv_val(0, 64));
  }

  z3::context& context_;
  z3::expr nearest_, to_zero_;
};

}  // namespace plcxx::solver
