#include "transpiler/dialects/host50/lowering/tables.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace plcxx::host50 {

void Tables::Add() {
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
  AddTitle();
  AddMCodes();
  AddSettings();
}

void Tables::AddTitle() {
  ir::Table table{.name = "title",
                  .comment = "What the program is called",
                  .columns = {{.name = "key", .type = ir::Type::kNone}, {.name = "text", .type = ir::Type::kNone}},
                  .cells = {},
                  .texts = {}};
  for (const TitleField& field : tree_.title) {
    table.cells.push_back(table.AddText(std::string(TitleKeys()[static_cast<size_t>(field.key)].name)));
    table.cells.push_back(table.AddText(field.text));
  }
  program_.tables.push_back(std::move(table));
}

void Tables::AddMCodes() {
  ir::Table table{.name = "m_codes",
                  .comment = "M codes: number, text",
                  .columns = {{.name = "number", .type = ir::Type::kI16}, {.name = "text", .type = ir::Type::kNone}},
                  .cells = {},
                  .texts = {}};
  std::vector<const MCode*> codes;
  for (const MCode& code : tree_.mcodes) codes.push_back(&code);
  std::ranges::stable_sort(codes, {}, &MCode::number);
  for (const MCode* code : codes) {
    table.cells.push_back(code->number);
    table.cells.push_back(table.AddText(code->text));
  }
  program_.tables.push_back(std::move(table));
}

/// By the names of the options, as the directives spell them.
void Tables::AddSettings() {
  ir::Table table{.name = "settings",
                  .comment = "What the program was compiled with",
                  .columns = {{.name = "name", .type = ir::Type::kNone}, {.name = "value", .type = ir::Type::kNone}},
                  .cells = {},
                  .texts = {}};
  const auto record = [&table](std::string_view name, std::string value) {
    table.cells.push_back(table.AddText(std::string(name)));
    table.cells.push_back(table.AddText(std::move(value)));
  };
  record("SLOWDIV", std::to_string(settings_.slowdiv));
  record("CHANNELS", std::to_string(settings_.channels));
#define HOST50_OPTION(Name, Member, Key, First, FirstText, Other, OtherText, ...) \
  record(Key, settings_.Member == Name##Option::First ? FirstText : OtherText);
#include "transpiler/dialects/host50/machine/machine.def"
  program_.tables.push_back(std::move(table));
}

}  // namespace plcxx::host50
