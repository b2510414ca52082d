// Operands, expressions and the blocks without Q of host50 (sections 3, 6.3, 6.4 and 6.6), on the memory and the
// elements that they name.
#pragma once

#include <array>
#include <cstdint>

#include "tests/reference/host50_elements.h"
#include "tests/reference/host50_image.h"
#include "tests/reference/reference.h"
#include "transpiler/dialects/dialect.h"
#include "transpiler/dialects/host50/syntax/syntax.h"

namespace plcxx::reference {

/// An int32 or a binary32.
struct Host50Value {
  bool is_float = false;
  int32_t whole = 0;
  float real = 0;

  float AsFloat() const { return is_float ? real : static_cast<float>(whole); }
};
bool Compare(host50::ExprKind relation, const Host50Value& a, const Host50Value& b);

class Host50Machine : public Reference {
 public:
  Host50Machine(dialects::Request& request, HostCalls host);

 protected:
  const host50::Operand& OperandOf(host50::InstructionId id, uint32_t number) const;
  bool Bit(const host50::Operand& operand) const;
  bool Bit(const host50::Address& address) const;
  Host50Value Number(const host50::Operand& operand) const;
  Host50Value Number(const host50::Address& address) const;
  Host50Value Evaluate(host50::ExprId id) const;
  /// The value becomes what the destination holds, as MOV converts.
  void Store(const host50::Operand& operand, const Host50Value& value);
  /// A block without Q, with ACC = 1; not those of program control and of axes.
  void RunBlock(host50::InstructionId id, host50::Op op);

  host50::Program tree_;
  Host50Image image_;
  std::array<host50_elements::Timer, 101> timers_{};
  std::array<host50_elements::Counter, 101> counters_{};
};

}  // namespace plcxx::reference
