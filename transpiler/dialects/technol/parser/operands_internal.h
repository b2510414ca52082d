// The second half of the parser: the operands of one instruction after the other, by its Form. Shared by its files
// only.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "transpiler/dialects/technol/parser/expressions.h"
#include "transpiler/dialects/technol/parser/parsing_context.h"
#include "transpiler/dialects/technol/parser/pending.h"
#include "transpiler/dialects/technol/source/token_reader.h"

namespace plcxx::technol {

class OperandParser {
 public:
  OperandParser(ParsingContext& context, Instruction& instruction, std::string_view mnemonic, TokenReader reader)
      : context_(context), instruction_(instruction), mnemonic_(mnemonic), reader_(reader) {}

  /// Reads all operands of the instruction; its op becomes the assembler's where their number says so.
  void Run();

 private:
  // operands.cc: labels, mechanisms, timers, constants
  void TakeForm(Form form);
  void TakeNone();
  void TakeJump();
  void TakeCall();
  void TakeMechanism();
  void TakeTimerCell();
  void TakeTime();
  void TakeError();
  void CheckEnd();
  bool ExpectComma();
  bool ExpectOperand(std::string_view what);
  void Add(Operand operand, size_t first);
  /// The next word as a name that stands for a label (or anything else, reported); not valid when it is none.
  SymbolId TakeName(std::string_view what);
  void CheckJumpTarget(LabelId label, source::Range range);
  std::string UnitName(UnitId unit) const;

  // operands_bits.cc
  void TakeBit(Access access);
  void TakeFlag();
  bool IsSingleBit();
  std::string BitOfByte(SymbolId cell) const;
  void ReportBitAsData(const Token& token);
  std::optional<Operand> ReadBit();
  void CheckRequest(const Operand& bit, int64_t value);

  // operands_data.cc
  void TakeData(Form form);
  void TakeStore();
  void TakeRotation();
  /// CNST.expression, when the next word is CNST.
  std::optional<Operand> ReadCounted();
  std::optional<Operand> ReadDataOperand();
  void CheckNarrow(const Operand& operand, Form form);

  // operands_addresses.cc
  /// [BYTE.|WORD.|DWRD.] address, or assembler's BYTE PTR; width 0 where nothing tells it. Checks ranges when the width
  /// is known. None when it is wrong (reported).
  enum class Prefixes : uint8_t { kTechnol, kAssembler };
  std::optional<Operand> ReadMemory(Prefixes prefixes);
  bool ReadAddress(Address& address, uint8_t& width, uint32_t level);
  bool ReadBase(Address& address, uint8_t& width, uint32_t level);
  bool ReadField(Address& address, uint8_t& width);
  bool ReadIndex(Address& address);
  bool TakeIndexRegister(Address& address);
  std::optional<uint8_t> TakePrefix(Prefixes prefixes);
  /// Is the whole access inside its area? Warns when it leaves its symbol.
  void CheckRange(const Operand& operand);
  bool CheckWidth(const Operand& operand);

  // operands_assembler.cc
  void TakeTwo();
  void TakeOne();
  void TakeShift();
  void TakeExchange();
  void TakeExtend();
  void TakeStack();
  std::optional<Operand> ReadAssembler(bool constant_allowed);
  std::optional<Operand> ReadRegister();
  bool IsAddressAhead() const;
  bool IsForeignOperand();
  void Match(Operand& left, Operand& right);
  bool CheckSize(const Operand& operand);
  bool CheckImmediate(Operand& constant, uint8_t width);

  ParsingContext& context_;
  Instruction& instruction_;
  std::string_view mnemonic_;
  TokenReader reader_;
};

/// "1 byte", for messages: what an area or symbol is called there.
std::string NameOf(const Program& program, const Address& address);

}  // namespace plcxx::technol
