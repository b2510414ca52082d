// What declarations become: initial data, messages, menu texts, M functions with the NC's part of them (specification
// 8.2, 8.3, 9).
#pragma once

#include "transpiler/dialects/prostep/lowering/context.h"

namespace plcxx::prostep {

class Cells;
class Locals;

class Declarations : Context {
 public:
  Declarations(const Context& context, Cells& cells, Locals& locals)
      : Context(context), cells_(cells), locals_(locals) {}

  void AddInitialData();
  void AddMessages();
  /// The table, and what a host calls that plays the NC.
  void AddMFunctions();

 private:
  void AddTable();
  void AddBegin();
  void AddEnd();
  /// Sets or clears the static and the dynamic bit that the M function `number`, an i8, has by its DMF.
  void SetBits(ir::ValueId number);
  void ClearDynamicBit(ir::ValueId number);
  template <class Fill>
  void ForEachFunction(ir::ValueId number, Fill&& fill);

  Cells& cells_;
  Locals& locals_;
};

}  // namespace plcxx::prostep
