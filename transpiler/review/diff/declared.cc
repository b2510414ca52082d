#include "transpiler/review/diff/declared.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "transpiler/sim/value_text.h"

namespace plcxx::review::diff {
namespace {

/// What is declared under a name.
struct Declaration {
  std::string name;
  std::string text;  // in words
  std::string is;    // the same in both versions where they mean the same; empty: the text is
  const std::string& identity() const { return is.empty() ? text : is; }
};
using Declarations = std::vector<Declaration>;

std::string YesOrNo(bool value) { return value ? "yes" : "no"; }

std::string Ms(uint32_t ms) { return std::to_string(ms) + " ms"; }

/// A place is known by its name where the program lays out memory, and by its address where the control does.
Declaration PlaceOf(const ir::Program& program, const std::string& what, ir::PlaceId id) {
  if (!id.valid()) return {.name = what, .text = "none", .is = {}};
  const ir::Place& place = program.places[id];
  const bool has_address = place.space.valid() && program.spaces[place.space].host_visible;
  return {.name = what,
          .text = place.name,
          .is = has_address ? program.spaces[place.space].name + "+" + std::to_string(place.offset) + "." +
                                  std::to_string(place.bit) + ":" + std::string(ir::Name(place.type))
                            : std::string()};
}

/// Every member of ir::Schedule but the routines, whose behaviour is compared, the names of host functions, and what
/// automatic slicing divides by: the number of slices is told.
Declarations ScheduleOf(const ir::Program& program) {
  const ir::Schedule& schedule = program.schedule;
  Declarations declared{
      {"period", Ms(schedule.period_ms)},
      {"period of the fast part", schedule.fast_ms == 0 ? "that of the whole" : Ms(schedule.fast_ms)},
      {"longest time between fast parts", schedule.fast_every_ms == 0 ? "not known" : Ms(schedule.fast_every_ms)},
      {"longest time between slow parts", schedule.slow_every_ms == 0 ? "not known" : Ms(schedule.slow_every_ms)},
      {"first period at the end of its time", YesOrNo(schedule.period_ends_its_time)},
      {"time that passes between periods is followed", YesOrNo(schedule.elapse.valid())},
      {"each millisecond is followed", YesOrNo(schedule.elapses_every_ms)},
      {"most periods of one part", std::to_string(schedule.most_periods)},
      PlaceOf(program, "counts slow parts", schedule.slow_done),
      PlaceOf(program, "counts fast parts", schedule.fast_done),
      {"memory is kept without power", YesOrNo(schedule.retention)},
      PlaceOf(program, "memory is kept where this is 1", schedule.retain_at_power_off),
  };
  for (const ir::Routine& routine : program.routines) {
    if (routine.kind == ir::RoutineKind::kSlow || routine.sliced)
      declared.emplace_back("slices of " + routine.name, std::to_string(routine.slices));
  }
  return declared;
}

Declarations TextsOf(std::string_view what, const std::vector<ir::MessageText>& texts) {
  Declarations declared;
  for (const ir::MessageText& text : texts) {
    declared.emplace_back(
        std::string(what) + " " + std::to_string(text.number),
        "'" + text.text + "'" + (text.colour == 0 ? std::string() : " (colour " + std::to_string(text.colour) + ")"));
  }
  return declared;
}

/// Which memory makes which message.
Declarations MessageBitsOf(const ir::Program& program) {
  Declarations declared;
  for (const ir::MessageBits& bits : program.message_bits) {
    declared.emplace_back("messages from " + std::to_string(bits.first_number),
                          std::to_string(bits.count) + " bits from " + program.spaces[bits.space].name + "+" +
                              std::to_string(bits.offset));
  }
  for (size_t i = 0; i < program.message_words.size(); ++i) {
    declared.push_back(
        PlaceOf(program, "number of a message " + std::to_string(i + 1), program.message_words[i].place));
  }
  return declared;
}

std::string CellText(const ir::Table& table, size_t cell) {
  const ir::Parameter& column = table.columns[cell % table.columns.size()];
  const uint64_t value = table.cells[cell];
  if (column.type == ir::Type::kNone) return value < table.texts.size() ? "'" + table.texts[value] + "'" : "none";
  return sim::IsFloat(column.type) ? sim::ValueDigits(column.type, value) : std::to_string(value);
}

Declarations ItemsOf(const ir::Program& program, const std::string& name) {
  Declarations declared;
  for (const ir::Table& table : program.tables) {
    if (table.name != name) continue;
    for (size_t cell = 0; cell < table.cells.size(); ++cell) {
      declared.emplace_back(table.name + "[" + std::to_string(cell / table.columns.size()) + "]." +
                                table.columns[cell % table.columns.size()].name,
                            CellText(table, cell));
    }
  }
  return declared;
}

constexpr size_t kMostListed = 20;  // of one table; a row more in front changes all of them

void AddChanges(ItemKind kind, const std::string& together, const Declarations& old_declared,
                const Declarations& new_declared, std::vector<DiffItem>& items) {
  const size_t first = items.size();
  const auto add = [&](const std::string& name, std::string old_text, std::string new_text) {
    items.push_back({.name = name, .kind = kind, .verdict = ItemVerdict::kDifferent, .changed_itself = true});
    items.back().declared = {std::move(old_text), std::move(new_text)};
  };
  const auto by_name = [](const Declarations& declared) {
    std::map<std::string, const Declaration*> found;
    for (const Declaration& one : declared) found.emplace(one.name, &one);
    return found;
  };
  const auto before = by_name(old_declared), after = by_name(new_declared);
  for (const Declaration& old_one : old_declared) {
    const auto now = after.find(old_one.name);
    if (now == after.end()) {
      add(old_one.name, old_one.text, "not there");
    } else if (now->second->identity() != old_one.identity()) {
      add(old_one.name, old_one.text, now->second->text);
    }
  }
  for (const Declaration& new_one : new_declared) {
    if (!before.contains(new_one.name)) add(new_one.name, "not there", new_one.text);
  }
  const size_t count = items.size() - first;
  if (count <= kMostListed) return;
  items.resize(first);
  add(together, std::to_string(old_declared.size()) + " entries",
      std::to_string(new_declared.size()) + ", and " + std::to_string(count) + " of all are other ones");
}

}  // namespace

std::vector<DiffItem> CompareDeclarations(const ir::Program& old_program, const ir::Program& new_program) {
  std::vector<DiffItem> items;
  AddChanges(ItemKind::kSchedule, "schedule", ScheduleOf(old_program), ScheduleOf(new_program), items);
  const auto add_data = [&](const std::string& together, const auto& declarations_of) {
    AddChanges(ItemKind::kData, together, declarations_of(old_program), declarations_of(new_program), items);
  };
  add_data("messages", [](const ir::Program& program) { return TextsOf("message", program.messages); });
  add_data("menu texts", [](const ir::Program& program) { return TextsOf("menu text", program.menu_texts); });
  add_data("encoding", [](const ir::Program& program) {
    return Declarations{{"encoding of texts", std::string(source::Name(program.text_encoding))}};
  });
  add_data("memory of messages", MessageBitsOf);
  std::set<std::string> tables;
  for (const ir::Program* const program : {&old_program, &new_program}) {
    for (const ir::Table& table : program->tables) tables.insert(table.name);
  }
  for (const std::string& name : tables)
    add_data("table " + name, [&name](const ir::Program& program) { return ItemsOf(program, name); });
  return items;
}

}  // namespace plcxx::review::diff
