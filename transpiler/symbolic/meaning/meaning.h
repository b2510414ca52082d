// What each operation of ir/ops.def means, as terms: an independent reading of the specifications.
//
// verify compares compiled code, in which runtime_support is inlined, with these meanings; so they are written from the
// operations' definitions and never call runtime_support. One definition for each row of ops.def: a row without one
// does not compile. Floating point is by the functions of floats.h, of which solvers know the names only.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "transpiler/ir/op.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::meaning {

/// Bits of a term that holds a value of this type.
constexpr uint8_t WidthOf(ir::Type type) {
  return type == ir::Type::kBit ? uint8_t{1} : static_cast<uint8_t>(8 * ir::Bytes(type));
}

/// The value of a pure operation for operands of the widths of its row.
terms::TermId MeaningOf(terms::Terms& terms, ir::OpKind op, std::span<const terms::TermId> operands);

/// The number of terms that an instance of this kind is: one for each field of ir::Info(kind).fields, `count` for an
/// array.
uint32_t FieldTerms(ir::StateKind kind);
/// The term of the first element of a field.
uint32_t FieldTermIndex(ir::StateKind kind, uint8_t field);

/// Advances an instance: `fields` (FieldTerms of them, each of its field's width) become what they are afterwards.
/// Gives the operation's value; none (an invalid id) when its row has no result.
terms::TermId StepMeaning(terms::Terms& terms, ir::OpKind op, std::span<terms::TermId> fields,
                          std::span<const terms::TermId> operands);

/// The core operation UpdateText: `flag` and `inbox` are the terms of a TextFlag and the TextInbox.
void UpdateTextMeaning(terms::Terms& terms, std::span<terms::TermId> flag, std::span<terms::TermId> inbox,
                       std::string_view text);

}  // namespace plcxx::meaning
