#include "transpiler/ir/printer_state.h"
#include "transpiler/ir/text_format.h"
#include "transpiler/ir/zones.h"

namespace plcxx::ir {
namespace {

using text::Quoted;
using text::Word;

template <class Store, class Name>
std::vector<std::string> Names(const Store& store, Name name) {
  std::vector<std::string> names;
  for (const auto& item : store) names.push_back(name(item));
  names = text::Handles(names);
  for (std::string& handle : names) handle = Word(handle);
  return names;
}

std::string Decimal(uint64_t value) { return std::to_string(value); }

void PrintSpaces(Printer& printer) {
  std::string& out = printer.out;
  for (uint32_t i = 0; i < printer.program.spaces.size(); ++i) {
    const Space& space = printer.program.spaces[SpaceId(i)];
    const std::string& handle = printer.spaces[i];
    out += "space " + handle + ' ' + Decimal(space.bytes) + ' ';
    out += text::kLifetimes[static_cast<size_t>(space.lifetime)];
    out += ' ';
    out += text::kOrders[static_cast<size_t>(space.order)];
    if (space.host_visible) out += " host_visible";
    if (space.own) out += " own";
    if (space.zones_are_arrays) out += " arrays";
    if (!space.part_of.empty()) out += " part_of " + Word(space.part_of) + ' ' + Decimal(space.part_begin);
    if (handle != Word(space.name)) out += " named " + Word(space.name);
    if (!space.title.empty()) out += ' ' + Quoted(space.title);
    out += '\n';
    for (const Zone& zone : space.zones) {
      const uint32_t unit = IsOfBytes(zone) ? 8 : 1;
      out += "zone " + handle + (unit == 1 ? " bits " : " ") + Decimal(zone.begin / unit) + ' ' +
             Decimal(zone.end / unit) + ' ';
      out += text::kDirections[static_cast<size_t>(zone.direction)];
      out += '\n';
    }
    for (const ByteRange& range : space.constants) {
      out += "constant " + handle + ' ' + Decimal(range.begin) + ' ' + Decimal(range.end) + '\n';
    }
    for (const InitialByte& byte : space.initial) {
      out += "initial " + handle + ' ' + Decimal(byte.offset) + " 0x" + text::Hex(byte.value) + '\n';
    }
  }
}

void PrintPlaces(Printer& printer) {
  const Program& program = printer.program;
  std::string& out = printer.out;
  for (uint32_t i = 0; i < program.places.size(); ++i) {
    const Place& place = program.places[PlaceId(i)];
    const std::string& handle = printer.places[i];
    out += "place " + handle + ' ';
    out += Name(place.type);
    if (place.is_field()) {
      out += " field " + printer.states[place.state.index] + ' ';
      out += Info(program.states[place.state].kind).fields[place.field].name;
    } else {
      out +=
          ' ' + (place.space.valid() ? printer.spaces[place.space.index] : "none") + '[' + Decimal(place.offset) + ']';
      if (place.bit != kNoBit) out += '.' + Decimal(place.bit);
      if (place.indexed) {
        out += " stride " + Decimal(place.stride) + " low " + Decimal(place.low) + " high " + Decimal(place.high) +
               " indexed";
      }
    }
    if (!place.address.empty()) out += " address " + Word(place.address);
    if (handle != Word(place.name)) out += " named " + Word(place.name);
    out += '\n';
  }
}

std::string ParameterText(const Parameter& parameter) {
  return Word(parameter.name) + " : " + std::string(Name(parameter.type)) +
         (parameter.is_statement ? " statement" : "");
}

void PrintHostFunctions(Printer& printer) {
  std::string& out = printer.out;
  for (uint32_t i = 0; i < printer.program.host_functions.size(); ++i) {
    const HostFunction& host = printer.program.host_functions[HostFunctionId(i)];
    const std::string& handle = printer.host_functions[i];
    out += "host " + handle + " (";
    for (size_t j = 0; j < host.parameters.size(); ++j) {
      out += (j == 0 ? "" : ", ") + ParameterText(host.parameters[j]);
      const auto& enumerators = host.parameters[j].enumerators;
      for (size_t k = 0; k < enumerators.size(); ++k) out += (k == 0 ? " = (" : ", ") + Word(enumerators[k]);
      if (!enumerators.empty()) out += ')';
    }
    out += ')';
    if (host.result != Type::kNone) out += " -> " + std::string(Name(host.result));
    if (host.out.type != Type::kNone) out += " out " + ParameterText(host.out);
    if (host.access != HostAccess::kNone) {
      out += ' ';
      out += text::kAccesses[static_cast<size_t>(host.access)];
      if (host.only_space.valid()) out += " in " + printer.spaces[host.only_space.index];
    }
    if (host.routine_exchange) out += " routine_exchange";
    if (host.polled) out += " polled";
    if (handle != Word(host.name)) out += " named " + Word(host.name);
    if (!host.comment.empty()) out += ' ' + Quoted(host.comment);
    out += '\n';
  }
}

void PrintMessages(std::string& out, std::string_view keyword, const std::vector<MessageText>& messages) {
  for (const MessageText& message : messages) {
    out += keyword;
    out += ' ' + Decimal(message.number) + " colour " + Decimal(message.colour) + ' ' + Quoted(message.text) + '\n';
  }
}

void PrintTable(std::string& out, const Table& table) {
  out += "table " + Word(table.name) + " (";
  for (size_t i = 0; i < table.columns.size(); ++i) out += (i == 0 ? "" : ", ") + ParameterText(table.columns[i]);
  out += ')';
  if (!table.comment.empty()) out += ' ' + Quoted(table.comment);
  for (size_t i = 0; i < table.cells.size(); ++i) {
    const size_t column = i % table.columns.size();
    const bool is_text = table.columns[column].type == Type::kNone;
    out += column == 0 ? "\nrow " : " ";
    out += is_text ? Quoted(table.texts[table.cells[i]]) : Decimal(table.cells[i]);
  }
  out += '\n';
}

}  // namespace

Printer::Printer(const Program& printed) : program(printed) {
  const auto name = [](const auto& item) { return item.name; };
  spaces = Names(program.spaces, name);
  places = Names(program.places, name);
  states = Names(program.states, name);
  host_functions = Names(program.host_functions, name);
  routines = Names(program.routines, name);
  statements = text::StatementHandles(program);
}

void Printer::PrintDeclarations() {
  out += "program " + Word(program.name) + ' ' + Word(program.dialect) + '\n';
  PrintSpaces(*this);
  for (uint32_t i = 0; i < program.states.size(); ++i) {
    const StateInstance& state = program.states[StateId(i)];
    out += "state " + states[i] + ' ' + std::string(Info(state.kind).text);
    if (states[i] != Word(state.name)) out += " named " + Word(state.name);
    out += '\n';
  }
  PrintPlaces(*this);
  PrintHostFunctions(*this);
  for (const std::string& string : program.texts) out += "text " + Quoted(string) + '\n';
  for (uint32_t i = 0; i < program.statements.size(); ++i) {
    const Statement& statement = program.statements[StatementId(i)];
    out += "statement " + statements[i];
    if (!statement.subject.empty()) out += " subject " + Word(statement.subject);
    if (statement.opens_block) out += " opens";
    if (statement.closes_block) out += " closes";
    out += '\n';
  }
}

void Printer::PrintSchedule() {
  const Schedule& schedule = program.schedule;
  const Schedule usual;
  const auto entry = [this](std::string_view key, const std::string& value) {
    out += "schedule ";
    out += key;
    out += ' ' + value + '\n';
  };
  if (schedule.init.valid()) entry("init", routines[schedule.init.index]);
  if (schedule.period.valid()) entry("period", routines[schedule.period.index]);
  if (schedule.fast_only.valid()) entry("fast_only", routines[schedule.fast_only.index]);
  if (schedule.elapse.valid()) entry("elapse", routines[schedule.elapse.index]);
  if (schedule.elapses_every_ms) entry("elapses_every_ms", "1");
  if (schedule.period_ends_its_time) entry("period_ends_its_time", "1");
  if (schedule.period_ms != usual.period_ms) entry("period_ms", Decimal(schedule.period_ms));
  if (schedule.slot_ms != usual.slot_ms) entry("slot_ms", Decimal(schedule.slot_ms));
  if (schedule.fast_ms != usual.fast_ms) entry("fast_ms", Decimal(schedule.fast_ms));
  if (schedule.slices_by_cost) entry("slices_by_cost", "1");
  if (schedule.slow_done.valid()) entry("slow_done", PlaceName(schedule.slow_done));
  if (schedule.fast_done.valid()) entry("fast_done", PlaceName(schedule.fast_done));
  if (schedule.fast_every_ms != 0) entry("fast_every_ms", Decimal(schedule.fast_every_ms));
  if (schedule.slow_every_ms != 0) entry("slow_every_ms", Decimal(schedule.slow_every_ms));
  if (schedule.most_periods != usual.most_periods) entry("most_periods", Decimal(schedule.most_periods));
  if (schedule.now.valid()) entry("now", host_functions[schedule.now.index]);
  if (schedule.retentive_load.valid()) entry("retentive_load", host_functions[schedule.retentive_load.index]);
  if (schedule.retentive_store.valid()) entry("retentive_store", host_functions[schedule.retentive_store.index]);
  if (schedule.retain_at_power_off.valid()) entry("retain_at_power_off", PlaceName(schedule.retain_at_power_off));
  if (schedule.retention) entry("retention", "1");
  if (program.text_inbox.valid()) out += "text_inbox " + states[program.text_inbox.index] + '\n';
  for (const MessageBits& bits : program.message_bits) {
    out += "message_bits " + spaces[bits.space.index] + ' ' + Decimal(bits.offset) + " first " +
           Decimal(bits.first_number) + " count " + Decimal(bits.count) + '\n';
  }
  for (const MessageWord& word : program.message_words) out += "message_word " + PlaceName(word.place) + '\n';
  if (program.text_encoding != source::Encoding::kUtf8) {
    out += "text_encoding " + Quoted(source::Name(program.text_encoding)) + '\n';
  }
  PrintMessages(out, "message", program.messages);
  PrintMessages(out, "menu_text", program.menu_texts);
  for (const Table& table : program.tables) PrintTable(out, table);
}

}  // namespace plcxx::ir
