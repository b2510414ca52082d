// The power cuts of power_cuts.h on an emulated processor: the program ends with 0 when each left a whole content.

#include "tests/baremetal/power_cuts.h"

#include "samples/baremetal/common/board.h"

void TimerTick() {}

void FaultHook(FaultKind) { board::End("fault", 3); }

int main() {
  const plcxx_test::CutCounts counts = plcxx_test::PowerCuts<20>().Run();
  if (counts.wrong > 0) board::End("a power cut left a mixture", 1);
  if (counts.cuts < 10'000 || counts.old_content == 0 || counts.new_content == 0) board::End("too few cuts", 2);
  board::End("every power cut left the old or the new content", 0);
}
