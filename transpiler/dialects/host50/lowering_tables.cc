// Alarms, M codes and titles (9).

#include <algorithm>

#include "transpiler/dialects/host50/lowering_internal.h"

namespace plcxx::host50 {

void Lowering::Tables() {
  for (const Alarm& alarm : tree_.alarms) {
    if (alarm.text.empty()) continue;
    program_.messages.push_back(
        {.number = alarm.index, .colour = static_cast<uint32_t>(alarm.severity), .text = alarm.text});
  }
  std::ranges::stable_sort(program_.messages, {}, &ir::MessageText::number);
  program_.message_bits.push_back({.space = SpaceOf({.area = Area::kQ, .number = kFirstAlarm}),
                                   .offset = kFirstAlarm / 8,
                                   .first_number = 0,
                                   .count = kAlarmCount});
}

}  // namespace plcxx::host50
