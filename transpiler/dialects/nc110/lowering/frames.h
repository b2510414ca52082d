// What is before and after the statements of a part: numbers of scans, slices, copies of inputs, texts, ends of pulses
// (specification 4.2 to 4.5).
#pragma once

#include "transpiler/dialects/nc110/lowering/context.h"

namespace plcxx::nc110 {

class Expirations;
class LatchedInputs;
class Routines;
class SystemPlaces;
class Texts;

class Frames : Context {
 public:
  Frames(const Context& context, const Routines& routines, SystemPlaces& system, LatchedInputs& inputs, Texts& texts,
         const Expirations& expirations);

  /// After the statements, which say what is needed.
  void LowerFast();
  void LowerSlow();

 private:
  void LowerSlowPrologue();

  const Routines& routines_;
  SystemPlaces& system_;
  LatchedInputs& inputs_;
  Texts& texts_;
  const Expirations& expirations_;
};

}  // namespace plcxx::nc110
