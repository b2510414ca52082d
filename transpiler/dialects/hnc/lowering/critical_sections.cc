#include "transpiler/dialects/hnc/lowering/critical_sections.h"

#include "transpiler/dialects/hnc/lowering/host_calls.h"
#include "transpiler/dialects/hnc/lowering/memory.h"

namespace plcxx::hnc {

void CriticalSections::Call(const std::string& name) {
  const bool enters = name == "critical_enter";
  builder_.CallHost(host_calls_.Function(name, {}, ir::Type::kNone,
                                         enters ? "asm cli: nothing may interrupt from here on."
                                                : "asm sti, or the end of a part that has not executed one."),
                    {});
}

ir::PlaceId CriticalSections::Flag() {
  if (!flag_.valid()) flag_ = memory_.AddScalar("critical", ir::Type::kBit);
  return flag_;
}

void CriticalSections::End() {
  if (!flag_.valid()) return;
  builder_.When(builder_.Load(flag_), [&] {
    builder_.Store(flag_, builder_.Bit(0));
    Call("critical_leave");
  });
}

}  // namespace plcxx::hnc
