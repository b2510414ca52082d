// What all readers of the parser's second half share: the instruction whose operands are read, by its Form.
#pragma once

#include <string_view>

#include "transpiler/dialects/technol/parser/parsing_context.h"
#include "transpiler/dialects/technol/source/token_reader.h"

namespace plcxx::technol {

/// An instruction, and what follows its mnemonic.
struct OperandReading {
  ParsingContext& context;
  Instruction& instruction;
  std::string_view mnemonic;
  TokenReader reader;
};

/// What a part of the parser sees. Refers to the reading.
class OperandReader {
 public:
  explicit OperandReader(OperandReading& reading)
      : context_(reading.context),
        instruction_(reading.instruction),
        mnemonic_(reading.mnemonic),
        reader_(reading.reader) {}

 protected:
  /// To the instruction; `first` is its first token.
  void Add(Operand operand, size_t first);
  bool ExpectComma();
  /// How the operands of an instruction with commas are written, as a remedy.
  std::string_view WrittenOperands() const;
  bool ExpectOperand(std::string_view what);
  /// The next word as a name that is that of a label (or anything else, reported); not valid when it is none.
  SymbolId ReadName(std::string_view what);

  ParsingContext& context_;
  Instruction& instruction_;
  std::string_view mnemonic_;
  TokenReader& reader_;
};

/// "X", "LABEL_MEM", for messages: what an area or symbol is called there.
std::string NameOf(const Program& program, const Address& address);

}  // namespace plcxx::technol
