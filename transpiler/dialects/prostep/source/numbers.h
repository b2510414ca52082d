// Numbers of dialect prostep (specification 2.4, 2.5): constants in three forms, addresses with and without a bit.
//
// In: the text of one number token. Out: the value, or what is wrong with it. Not its job: places in files,
// diagnostics.
#pragma once

#include <cstdint>
#include <string_view>

#include "transpiler/dialects/prostep/syntax/syntax.h"

namespace plcxx::prostep {

enum class NumberFault : uint8_t { kNone, kMalformed, kRange };

struct ConstantNumber {
  uint32_t value = 0;  // of `bytes` bytes; negative numbers in two's complement
  NumberForm form = NumberForm::kDecimal;
  NumberFault fault = NumberFault::kNone;
};
/// `bytes` 1, 2 or 4: K and DDW have two, DDB one, DDD four.
ConstantNumber ReadConstant(std::string_view text, uint32_t bytes);

struct AddressNumber {
  uint32_t number = 0;  // saturated
  uint32_t bit = 0;     // saturated
  bool has_bit = false;
  bool malformed = false;
};
/// "10", "10.1".
AddressNumber ReadAddress(std::string_view text);

/// Digits only, saturated; empty text gives 0.
uint32_t ReadDigits(std::string_view digits);

/// What a BCD constant of a timer or counter shows of the sixteen bits.
enum class BcdUse : uint8_t { kTime, kPreset };
/// Are the bits a time (three digits and a scale 0 to 3) or a preset (three digits) as 7.1 and 7.2 want it?
bool IsBcd(uint16_t bits, BcdUse use);

}  // namespace plcxx::prostep
