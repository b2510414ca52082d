// Ways out of a function and what it gives (specification 6.8).
#pragma once

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class Addresses;
class Conversions;
class Expressions;
class LivePath;
class Pointers;
class Records;

class Returns : Context {
 public:
  Returns(const Context& context, LivePath& path, Conversions& conversions, Pointers& pointers, Records& records,
          Addresses& addresses, Expressions& expressions)
      : Context(context),
        path_(path),
        conversions_(conversions),
        pointers_(pointers),
        records_(records),
        addresses_(addresses),
        expressions_(expressions) {}

  /// What a caller gets of a function that is left without a value: 0 (6.8), which of a pointer is the null pointer.
  void StoreNoResult();
  /// W9: a way out on which nothing ends what `asm cli` began.
  void Leave();
  void Lower(const Statement& statement, Tail tail);

 private:
  LivePath& path_;
  Conversions& conversions_;
  Pointers& pointers_;
  Records& records_;
  Addresses& addresses_;
  Expressions& expressions_;
};

}  // namespace plcxx::hnc
