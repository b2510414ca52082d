#include <algorithm>
#include <charconv>

#include "transpiler/ir/reader_state.h"
#include "transpiler/ir/zones.h"

namespace plcxx::ir {
namespace {

/// `named X` after a handle that is not the name itself.
void ReadNamed(Reader& reader, std::string& name) {
  if (reader.Accept("named")) name = reader.Name();
}

void ReadText(Reader& reader, std::string& string) {
  if (reader.AtString()) string = reader.Name();
}

void ReadSpace(Reader& reader) {
  Space space;
  const std::string handle = space.name = reader.Name();
  space.bytes = reader.Number32();
  space.lifetime = static_cast<Lifetime>(reader.OneOf(text::kLifetimes, "lifetime"));
  space.order = static_cast<ByteOrder>(reader.OneOf(text::kOrders, "byte order"));
  space.host_visible = reader.Accept("host_visible");
  space.own = reader.Accept("own");
  space.zones_are_arrays = reader.Accept("arrays");
  if (reader.Accept("part_of")) {
    space.part_of = reader.Name();
    space.part_begin = reader.Number32();
  }
  ReadNamed(reader, space.name);
  ReadText(reader, space.title);
  reader.Declare(reader.spaces, handle, reader.program.spaces.Add(std::move(space)), "space");
}

void ReadZone(Reader& reader) {
  const SpaceId space = reader.Known(reader.spaces, "space");
  const bool is_bits = reader.Accept("bits");
  Zone zone{.begin = reader.Number32(), .end = reader.Number32()};
  constexpr uint32_t kMaxBytes = 0x1FFFFFFF;  // of which the bits can be counted; no space has as many
  if (!is_bits) zone = ZoneOfBytes(std::min(zone.begin, kMaxBytes), std::min(zone.end, kMaxBytes), zone.direction);
  zone.direction = static_cast<Direction>(reader.OneOf(text::kDirections, "direction"));
  if (!reader.error) reader.program.spaces[space].zones.push_back(zone);
}

void ReadConstant(Reader& reader) {
  const SpaceId space = reader.Known(reader.spaces, "space");
  const ByteRange range{.begin = reader.Number32(), .end = reader.Number32()};
  if (!reader.error) reader.program.spaces[space].constants.push_back(range);
}

void ReadInitial(Reader& reader) {
  const SpaceId space = reader.Known(reader.spaces, "space");
  const uint32_t offset = reader.Number32();
  const auto value = static_cast<uint8_t>(reader.Number());
  if (!reader.error) reader.program.spaces[space].initial.push_back({offset, value});
}

void ReadState(Reader& reader) {
  StateInstance state{.kind = {}, .name = reader.Name()};
  const std::string handle = state.name;
  const std::string kind = reader.Name();
  const std::optional<StateKind> known = StateByText(kind);
  if (!known) reader.Fail("unknown kind of state '" + kind + "'");
  state.kind = known.value_or(StateKind{});
  ReadNamed(reader, state.name);
  reader.Declare(reader.states, handle, reader.program.states.Add(std::move(state)), "state");
}

void ReadField(Reader& reader, Place& place) {
  place.state = reader.Known(reader.states, "state");
  const std::string field = reader.Name();
  if (reader.error) return;
  const auto fields = Info(reader.program.states[place.state].kind).fields;
  while (place.field < fields.size() && fields[place.field].name != field) ++place.field;
  if (place.field == fields.size()) reader.Fail("unknown field '" + field + "'");
}

void ReadMemory(Reader& reader, Place& place) {
  place.space = reader.Known(reader.spaces, "space");
  reader.Expect("[");
  place.offset = reader.Number32();
  reader.Expect("]");
  if (reader.AtEnd()) return;
  const std::string& next = reader.lines[reader.line].tokens[reader.token].text;
  if (next.starts_with('.')) {
    const std::optional<uint64_t> bit = text::Number(std::string_view(next).substr(1));
    if (!bit || *bit > 0xFF) reader.Fail("bit expected, found '" + next + "'");
    place.bit = static_cast<uint8_t>(bit.value_or(0));
    ++reader.token;
  }
  if (reader.Accept("stride")) place.stride = reader.Number32();
  if (reader.Accept("low")) place.low = reader.Number32();
  if (reader.Accept("high")) place.high = reader.Number32();
  place.indexed = reader.Accept("indexed");
}

void ReadPlace(Reader& reader) {
  Place place;
  const std::string handle = place.name = reader.Name();
  place.type = reader.TypeName();
  if (reader.Accept("field")) {
    ReadField(reader, place);
  } else {
    ReadMemory(reader, place);
  }
  if (reader.Accept("address")) place.address = reader.Name();
  ReadNamed(reader, place.name);
  reader.Declare(reader.places, handle, reader.program.places.Add(std::move(place)), "place");
}

/// `(a : bit, b : i8 = (LOW, HIGH))`; of routines `b : i8 = place`.
void ReadParameters(Reader& reader, std::vector<Parameter>& parameters, std::vector<PlaceId>* places) {
  if (!reader.Accept("(") || reader.Accept(")")) return;
  do {
    Parameter parameter{.name = reader.Name()};
    reader.Expect(":");
    parameter.type = reader.TypeName();
    parameter.is_statement = reader.Accept("statement");
    if (reader.Accept("=")) {
      if (places != nullptr) {
        places->push_back(reader.Known(reader.places, "place"));
      } else {
        reader.Expect("(");
        do parameter.enumerators.push_back(reader.Name());
        while (reader.Accept(","));
        reader.Expect(")");
      }
    }
    parameters.push_back(std::move(parameter));
  } while (reader.Accept(","));
  reader.Expect(")");
}

void ReadHostFunction(Reader& reader) {
  HostFunction host;
  const std::string handle = host.name = reader.Name();
  ReadParameters(reader, host.parameters, nullptr);
  if (reader.Accept("->")) host.result = reader.TypeName();
  if (reader.Accept("out")) {
    host.out.name = reader.Name();
    reader.Expect(":");
    host.out.type = reader.TypeName();
  }
  for (size_t i = 0; i < std::size(text::kAccesses); ++i) {
    if (reader.Accept(text::kAccesses[i])) host.access = static_cast<HostAccess>(i);
  }
  if (reader.Accept("in")) host.only_space = reader.Known(reader.spaces, "space");
  host.routine_exchange = reader.Accept("routine_exchange");
  host.polled = reader.Accept("polled");
  ReadNamed(reader, host.name);
  ReadText(reader, host.comment);
  reader.Declare(reader.host_functions, handle, reader.program.host_functions.Add(std::move(host)), "host function");
}

void ReadRoutine(Reader& reader) {
  Routine routine;
  const std::string handle = routine.name = reader.Name();
  routine.kind = static_cast<RoutineKind>(reader.OneOf(text::kRoutineKinds, "kind of routine"));
  ReadParameters(reader, routine.parameters, &routine.parameter_places);
  if (reader.Accept("->")) {
    routine.result = reader.TypeName();
    if (!reader.Accept("none")) routine.result_place = reader.Known(reader.places, "place");
  }
  routine.sliced = reader.Accept("sliced");
  if (reader.Accept("slices")) routine.slices = static_cast<uint8_t>(reader.Number());
  routine.simulation_only = reader.Accept("simulation_only");
  ReadNamed(reader, routine.name);
  if (reader.Accept("file")) routine.file_comment = reader.Name();
  ReadText(reader, routine.comment);
  reader.Expect("{");
  reader.Declare(reader.routines, handle, reader.program.routines.Add(std::move(routine)), "routine");
}

void ReadStatement(Reader& reader) {
  const StatementId id = reader.DeclareStatement(reader.Name());
  if (reader.error) return;
  Statement& statement = reader.program.statements[id];
  if (reader.Accept("subject")) statement.subject = reader.Name();
  statement.opens_block = reader.Accept("opens");
  statement.closes_block = reader.Accept("closes");
}

void ReadMessage(Reader& reader, std::vector<MessageText>& messages) {
  MessageText message{.number = reader.Number32()};
  if (reader.Accept("colour")) message.colour = reader.Number32();
  message.text = reader.Name();
  messages.push_back(std::move(message));
}

void ReadTable(Reader& reader) {
  Table table{.name = reader.Name(), .comment = {}, .columns = {}, .cells = {}};
  ReadParameters(reader, table.columns, nullptr);
  ReadText(reader, table.comment);
  reader.program.tables.push_back(std::move(table));
}

void ReadRow(Reader& reader) {
  if (reader.program.tables.empty()) return reader.Fail("row without a table");
  Table& table = reader.program.tables.back();
  for (const Parameter& column : table.columns) {
    if (column.type != Type::kNone) {
      table.cells.push_back(reader.Number());
    } else if (reader.AtString()) {
      table.cells.push_back(table.AddText(reader.Name()));
    } else {
      return reader.Fail("text in quotation marks expected in column '" + column.name + "'");
    }
  }
}

void ReadMessageBits(Reader& reader) {
  MessageBits bits{.space = reader.Known(reader.spaces, "space"), .offset = reader.Number32()};
  reader.Expect("first");
  bits.first_number = reader.Number32();
  reader.Expect("count");
  bits.count = reader.Number32();
  reader.program.message_bits.push_back(bits);
}

}  // namespace

StatementId Reader::DeclareStatement(const std::string& name) {
  Statement statement;
  const char* end = name.data() + name.size();
  const auto [stop, problem] = std::from_chars(name.data() + !name.empty(), end, statement.id, 16);
  if (!name.starts_with('s') || problem != std::errc() || (stop != end && *stop != '~')) {
    Fail("statement expected (s and a hexadecimal number), found '" + name + "'");
    return {};
  }
  const StatementId id = program.statements.Add(std::move(statement));
  Declare(statements, name, id, "statement");
  return id;
}

void Reader::ReadDeclaration(std::string_view keyword) {
  if (keyword == "program") {
    program.name = Name();
    program.dialect = Name();
  } else if (keyword == "space") {
    ReadSpace(*this);
  } else if (keyword == "zone") {
    ReadZone(*this);
  } else if (keyword == "constant") {
    ReadConstant(*this);
  } else if (keyword == "initial") {
    ReadInitial(*this);
  } else if (keyword == "state") {
    ReadState(*this);
  } else if (keyword == "place") {
    ReadPlace(*this);
  } else if (keyword == "host") {
    ReadHostFunction(*this);
  } else if (keyword == "text") {
    const std::string string = Name();
    texts.emplace(string, program.texts.Add(string));
  } else if (keyword == "statement") {
    ReadStatement(*this);
  } else if (keyword == "routine") {
    ReadRoutine(*this);
  } else if (keyword == "text_inbox") {
    program.text_inbox = Known(states, "state");
  } else if (keyword == "message_bits") {
    ReadMessageBits(*this);
  } else if (keyword == "message_word") {
    program.message_words.push_back({Known(places, "place")});
  } else if (keyword == "text_encoding") {
    const std::string name = Name();
    const std::optional<source::Encoding> encoding = source::EncodingByName(name);
    if (!encoding) return Fail("unknown encoding '" + name + "'");
    program.text_encoding = *encoding;
  } else if (keyword == "message") {
    ReadMessage(*this, program.messages);
  } else if (keyword == "menu_text") {
    ReadMessage(*this, program.menu_texts);
  } else if (keyword == "table") {
    ReadTable(*this);
  } else if (keyword == "row") {
    ReadRow(*this);
  } else {
    Fail("declaration expected, found '" + std::string(keyword) + "'");
  }
}

void Reader::ReadScheduleEntry() {
  Schedule& schedule = program.schedule;
  const std::string key = Name();
  if (key == "init") {
    schedule.init = Known(routines, "routine");
  } else if (key == "period") {
    schedule.period = Known(routines, "routine");
  } else if (key == "fast_only") {
    schedule.fast_only = Known(routines, "routine");
  } else if (key == "elapse") {
    schedule.elapse = Known(routines, "routine");
  } else if (key == "elapses_every_ms") {
    schedule.elapses_every_ms = Number32() != 0;
  } else if (key == "period_ends_its_time") {
    schedule.period_ends_its_time = Number32() != 0;
  } else if (key == "period_ms") {
    schedule.period_ms = Number32();
  } else if (key == "slot_ms") {
    schedule.slot_ms = Number32();
  } else if (key == "fast_ms") {
    schedule.fast_ms = Number32();
  } else if (key == "slices_by_cost") {
    schedule.slices_by_cost = Number() != 0;
  } else if (key == "slow_done") {
    schedule.slow_done = Known(places, "place");
  } else if (key == "fast_done") {
    schedule.fast_done = Known(places, "place");
  } else if (key == "fast_every_ms") {
    schedule.fast_every_ms = Number32();
  } else if (key == "slow_every_ms") {
    schedule.slow_every_ms = Number32();
  } else if (key == "most_periods") {
    schedule.most_periods = Number32();
  } else if (key == "now") {
    schedule.now = Known(host_functions, "host function");
  } else if (key == "retentive_load") {
    schedule.retentive_load = Known(host_functions, "host function");
  } else if (key == "retentive_store") {
    schedule.retentive_store = Known(host_functions, "host function");
  } else if (key == "retain_at_power_off") {
    schedule.retain_at_power_off = Known(places, "place");
  } else if (key == "retention") {
    schedule.retention = Number() != 0;
  } else {
    Fail("unknown entry of the schedule '" + key + "'");
  }
}

}  // namespace plcxx::ir
