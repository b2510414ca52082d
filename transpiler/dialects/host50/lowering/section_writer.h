// Sections: FAST, SLOW and the subroutines, each a routine.
#pragma once

#include "transpiler/dialects/host50/lowering/context.h"

namespace plcxx::host50 {

class Jumps;
class NetworkWriter;
class Routines;
class Slices;
class StatementWriter;

class SectionWriter : Context {
 public:
  SectionWriter(const Context& context, Routines& routines, Jumps& jumps, StatementWriter& statements,
                NetworkWriter& networks, Slices& slices);

  void LowerAll();

 private:
  void Lower(SectionId id, ir::RegionId body);
  void LowerWhole(const Section& section);
  void End();

  Routines& routines_;
  Jumps& jumps_;
  StatementWriter& statements_;
  NetworkWriter& networks_;
  Slices& slices_;
};

}  // namespace plcxx::host50
