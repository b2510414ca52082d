// Sequential pages: transitions until nothing changes any more, then the variables of the steps.
#pragma once

#include "transpiler/dialects/classicladder/lowering/accesses.h"
#include "transpiler/dialects/classicladder/lowering/places.h"
#include "transpiler/dialects/classicladder/lowering/statement_writer.h"

namespace plcxx::classicladder {

class Pages : Context {
 public:
  Pages(const Context& context, Places& places, Accesses& accesses, StatementWriter& statements)
      : Context(context), places_(places), accesses_(accesses), statements_(statements) {}

  void Lower(const Section& section);
  /// The routine that each page calls: after the last page.
  void LowerRefresh();

 private:
  /// Sets `changed` where it fires; also where it has no step before it.
  void Fire(const Transition& transition);
  void RefreshStep(uint32_t index, const Step& step);

  Places& places_;
  Accesses& accesses_;
  StatementWriter& statements_;
  ir::RoutineId steps_;
  ir::PlaceId changed_, rounds_;
};

}  // namespace plcxx::classicladder
