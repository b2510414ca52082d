// Mechanisms: entered while their bit is 1, ended, stopped, and begun anew (specification 7.1 to 7.4).
#pragma once

#include "transpiler/dialects/technol/lowering/context.h"

namespace plcxx::technol {

class Exits;
class Locals;
class MechanismPlaces;

class Mechanisms : Context {
 public:
  Mechanisms(const Context& context, Locals& locals, MechanismPlaces& places, Exits& exits)
      : Context(context), locals_(locals), places_(places), exits_(exits) {}

  /// `if (mechanism) mechanism()`.
  void Enter(const Routine& mechanism);
  /// Its last instruction, and those of PRIPRAVNE_FUNKCE and ZAVERECNE_FUNKCE: the bit is 0, and it begins anew.
  void End(UnitId unit);
  /// MECH_INIT.
  void Init(const Instruction& instruction);
  /// Its bit was cleared, with mech-clear=abort: it is as after MECH_INIT.
  void Stop(UnitId mechanism);
  /// Step and automatic timers are 0; the bit is not touched.
  void Rewind(UnitId unit);
  /// With mech-clear=abort: what the host has cleared begins anew, though its MECH_BEGIN may not be reached before the
  /// bit is set again. What the program clears is rewound where it does.
  void RewindCleared();
  /// Does it keep anything from one pass to the next?
  bool Keeps(const Routine& mechanism) const;
  /// A local bit: has a subprogram stopped the mechanism?
  ir::PlaceId StoppedPlace(UnitId mechanism);

 private:
  void LeaveStopped(UnitId mechanism);

  Locals& locals_;
  MechanismPlaces& places_;
  Exits& exits_;
};

}  // namespace plcxx::technol
