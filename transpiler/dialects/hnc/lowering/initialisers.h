// Automatic variables get their values where they are declared (specification 5.4).
#pragma once

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class Accesses;
class Addresses;
class Conversions;
class Expressions;
class Pointers;
class Records;
class StatementWriter;

class Initialisers : Context {
 public:
  Initialisers(const Context& context, StatementWriter& writer, Conversions& conversions, Pointers& pointers,
               Accesses& accesses, Records& records, Addresses& addresses, Expressions& expressions)
      : Context(context),
        writer_(writer),
        conversions_(conversions),
        pointers_(pointers),
        accesses_(accesses),
        records_(records),
        addresses_(addresses),
        expressions_(expressions) {}

  void Lower(const Statement& statement);

 private:
  void Initialise(VariableId id);
  /// Those that an initialiser of the type can give: bit-fields share bytes, and some bits are of none.
  uint32_t NamedBits(TypeId id) const;

  StatementWriter& writer_;
  Conversions& conversions_;
  Pointers& pointers_;
  Accesses& accesses_;
  Records& records_;
  Addresses& addresses_;
  Expressions& expressions_;
};

}  // namespace plcxx::hnc
