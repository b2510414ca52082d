// An instruction between the two halves of the parser: its line is known, its operands are still tokens, since names of
// cells, bits and labels may be defined further down (D3).
#pragma once

#include <cstdint>
#include <vector>

#include "transpiler/dialects/technol/parser/parsing_context.h"
#include "transpiler/dialects/technol/syntax/syntax.h"

namespace plcxx::technol {

struct Pending {
  Instruction instruction;
  Span tokens;             // after the mnemonic, in the store of tokens
  Span mnemonic;           // one token, of the store; none for marks
  uint32_t statement = 0;  // its number: what constants are known
};

/// Reads the operands of all instructions of the program and checks them (TE040 to TE048, TE052 to TE055, TE060 to
/// TE069, TE073 to TE075, TE077). `pending` holds one entry for each instruction.
void ReadOperands(const std::vector<Pending>& pending, const std::vector<Token>& tokens, ParsingContext& context);

}  // namespace plcxx::technol
