#include "transpiler/engines/harness.h"

#include <algorithm>

#include "transpiler/emit/print/host_function_head.h"

namespace plcxx::engines {
namespace {

// Before the host functions: what they do with a call.
constexpr std::string_view kCalls = R"(
struct Event { uint32_t function; uint32_t count; uint64_t arguments[kMostArguments]; };
struct Answer { uint64_t result; uint32_t has_second; uint64_t second; };
static Event* events = nullptr;
static uint32_t event_count = 0, event_room = 0;
static uint32_t asking = kAsksNobody;

static void Note(const Event& event) {
  if (event_count == event_room) {
    const uint32_t room = 2 * event_room + 16;
    events = static_cast<Event*>(plcxx_console::Grow(events, event_room * sizeof(Event), room * sizeof(Event)));
    event_room = room;
  }
  events[event_count++] = event;
}

static unsigned char ReadLetter() {
  unsigned char letter = 0;
  plcxx_console::Read(&letter, 1);
  return letter;
}

static uint32_t ReadWord() {
  uint32_t value = 0;
  plcxx_console::Read(&value, sizeof value);
  return value;
}

static uint64_t ReadLong() {
  const uint64_t low = ReadWord();
  return static_cast<uint64_t>(ReadWord()) << 32 | low;
}

static Answer ReadAnswer() {
  Answer answer;
  answer.result = ReadLong();
  answer.has_second = ReadWord();
  answer.second = ReadLong();
  return answer;
}

static void WriteCall(const Event& event) {
  const uint32_t head[2] = {event.function, event.count};
  plcxx_console::Write(head, sizeof head);
  plcxx_console::Write(event.arguments, event.count * sizeof(uint64_t));
}

static void HostWrites() {
  const uint32_t at = ReadWord(), mask = ReadWord(), value = ReadWord();
  unsigned char* const bytes = reinterpret_cast<unsigned char*>(&m);
  bytes[at] = static_cast<unsigned char>((bytes[at] & ~mask) | (value & mask));
  ReapplyForces(m);
}

static Answer Ask(const Event& event) {
  if (asking == kAsksNobody) return {0, 0, 0};
  plcxx_console::Write(&kHostQuestion, sizeof kHostQuestion);
  WriteCall(event);
  if (asking == kAsksWithState) {
    plcxx_console::Write(&m, kStateBytes);
    plcxx_console::Flush();
  }
  for (;;) {
    switch (ReadLetter()) {
      case 'W': HostWrites(); break;
      case 'S': StoreRetentive(); break;
      case 'A': return ReadAnswer();
      case 'D': plcxx_console::Flush(); break;
      default: plcxx_console::Quit();
    }
  }
}

template <class T>
uint64_t Bits(T value) { return static_cast<uint64_t>(value); }
static uint64_t Bits(float value) {
  uint32_t bits;
  __builtin_memcpy(&bits, &value, sizeof bits);
  return bits;
}
static uint64_t Bits(double value) {
  uint64_t bits;
  __builtin_memcpy(&bits, &value, sizeof bits);
  return bits;
}
template <class T>
void TakeBits(uint64_t bits, T& value) { value = static_cast<T>(bits); }
static void TakeBits(uint64_t bits, float& value) {
  const uint32_t low = static_cast<uint32_t>(bits);
  __builtin_memcpy(&value, &low, sizeof low);
}
static void TakeBits(uint64_t bits, double& value) { __builtin_memcpy(&value, &bits, sizeof bits); }
}
)";

constexpr std::string_view kServe = R"(
namespace harness = program::harness;

static void Report() {
  plcxx_console::Write(&harness::event_count, sizeof harness::event_count);
  for (uint32_t i = 0; i < harness::event_count; ++i) harness::WriteCall(harness::events[i]);
  harness::event_count = 0;
  plcxx_console::Write(&harness::m, harness::kStateBytes);
  plcxx_console::Flush();
}

static void Serve() {
  program::Host& host = harness::host;
  program::State& m = harness::m;
  const auto word = [] { return harness::ReadWord(); };
  static char* text = nullptr;
  static uint32_t text_room = 0;
  m = program::State{};
  host = program::Host{};
  harness::event_count = 0;
  harness::asking = harness::kAsksNobody;
  for (;;) {
    switch (harness::ReadLetter()) {
      case 'Q': return;
      case 'I': program::init(m, host); Report(); break;
      case 'P': host.now = word(); RunPeriod(m, host); Report(); break;
      case 'F': host.now = word(); RunFastOnly(m, host); Report(); break;
      case 'L': host.now = word(); RunElapse(m, host); Report(); break;
      case 'W': harness::HostWrites(); break;
)";

// Of the debug flavour only.
constexpr std::string_view kForcing = R"(      case 'K': {
        const uint32_t at = word(), mask = word(), value = word();
        m.force_mask[at] = static_cast<unsigned char>(m.force_mask[at] | mask);
        m.force_value[at] = static_cast<unsigned char>((m.force_value[at] & ~mask) | (value & mask));
        m.ReapplyForces();
        break;
      }
      case 'R': {
        const uint32_t at = word(), mask = word();
        m.force_mask[at] = static_cast<unsigned char>(m.force_mask[at] & ~mask);
        break;
      }
      case 'E': {
        const uint32_t statement = word();
        m.off[statement] = word() == 0;
        break;
      }
)";

constexpr std::string_view kServeOn = R"(      case 'T': {
        const uint32_t size = word();
        if (size > text_room) {
          text = static_cast<char*>(plcxx_console::Grow(text, 0, 2 * static_cast<size_t>(size)));
          text_room = 2 * size;
        }
        plcxx_console::Read(text, size);
        SendText(m, text, size);
        Report();
        break;
      }
      case 'H': harness::asking = word(); break;
      case 'A': harness::ReadAnswer(); break;
      case 'D': break;
      case 'S': harness::StoreRetentive(); break;
      default: plcxx_console::Quit();
    }
  }
}
}
)";

bool TakesState(const ir::HostFunction& function) {
  return function.access == ir::HostAccess::kReadsState || function.access == ir::HostAccess::kWritesState;
}

/// The body of a function whose calls are events, and are answered by who drives the engine.
std::string Asking(const ir::HostFunction& function, uint32_t number) {
  std::string call = std::to_string(number) + ", " + std::to_string(function.parameters.size()) + ", {";
  for (const ir::Parameter& parameter : function.parameters) {
    call += (call.back() == '{' ? "" : ", ") + ("harness::Bits(" + parameter.name + ")");
  }
  call += '}';
  std::string out = "  static_cast<void>(host);\n  const harness::Event harness_event = {" + call + "};\n";
  if (!function.routine_exchange) out += "  harness::Note(harness_event);\n";
  out += "  const harness::Answer harness_answer = harness::Ask(harness_event);\n";
  if (!function.out.name.empty())
    out += "  if (harness_answer.has_second) harness::TakeBits(harness_answer.second, " + function.out.name + ");\n";
  if (function.result == ir::Type::kNone) return out + "  static_cast<void>(harness_answer);\n";
  return out + "  " + std::string(ir::CppName(function.result)) +
         " harness_result;\n  harness::TakeBits(harness_answer.result, harness_result);\n  return harness_result;\n";
}

/// The host's store of retentive memory, kept beside the State.
std::string Storing(const ir::HostFunction& function, uint32_t number) {
  const bool loads = function.access == ir::HostAccess::kWritesRetentive;
  std::string out;
  if (!function.routine_exchange) out += "  harness::Note({" + std::to_string(number) + ", 0, {}});\n";
  out += loads ? "  if (host.has_stored) retentive = host.stored;\n"
               : "  host.stored = retentive;\n  host.has_stored = true;\n";
  if (function.result != ir::Type::kNone && !loads) out += "  return {};\n";
  return out;
}

std::string HostFunctions(const emit::Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  std::string out;
  for (uint32_t i = 0; i < program.host_functions.size(); ++i) {
    if (!emittable.host_used[i]) continue;
    const ir::HostFunctionId id(i);
    const ir::HostFunction& function = program.host_functions[id];
    out += emit::print::HostFunctionHead(function) + " {\n";
    if (TakesState(function)) out += "  static_cast<void>(m);\n";
    if (id == program.schedule.now) {
      out += "  return host.now;\n";
    } else if (id == program.schedule.retentive_load || id == program.schedule.retentive_store) {
      out += Storing(function, i);
    } else {
      out += Asking(function, i);
    }
    out += "}\n";
  }
  return out;
}

/// Where the commands of one program are obeyed: a namespace beside the program's own, so that neither's names are in
/// the other's way.
std::string ServerName(const emit::Emittable& emittable) { return emittable.namespace_name + "_server"; }

/// State, Host and the host functions of one program, then its server.
std::string ProgramHarness(const emit::Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  const bool retentive = emittable.layout.retentive_bytes > 0;
  size_t most_arguments = 1;
  for (const ir::HostFunction& function : program.host_functions) {
    most_arguments = std::max(most_arguments, function.parameters.size());
  }
  std::string out = "namespace " + emittable.namespace_name + " {\nstruct Host {\n  uint32_t now = 0;\n";
  if (retentive) out += "  Retentive stored{};\n  bool has_stored = false;\n";
  out += "};\nnamespace harness {\nstatic State m;\nstatic Host host;\n";
  out += "constexpr size_t kStateBytes = " + std::to_string(emittable.layout.size) + ";\n";
  out += "constexpr size_t kMostArguments = " + std::to_string(most_arguments) + ";\n";
  const auto number = [&out](std::string_view name, uint32_t value) {
    out += "constexpr uint32_t " + std::string(name) + " = " + std::to_string(value) + "u;\n";
  };
  number("kHostQuestion", kHostQuestion);
  number("kAsksNobody", static_cast<uint32_t>(Asking::kNobody));
  number("kAsksWithState", static_cast<uint32_t>(Asking::kWithState));
  const bool debug = emittable.options.flavour == emit::Flavour::kDebug;
  out += std::string("static void ReapplyForces(State& state) {") +
         (debug ? " state.ReapplyForces(); }\n" : " static_cast<void>(state); }\n");
  out += "static void StoreRetentive() {\n";
  if (retentive) out += "  host.stored = m.retentive;\n  host.has_stored = true;\n";
  out += "}\n" + std::string(kCalls) + HostFunctions(emittable) + "}\n";
  out += "namespace " + ServerName(emittable) + " {\nnamespace program = ::" + emittable.namespace_name + ";\n";
  const auto runner = [&](std::string_view name, ir::RoutineId routine) {
    out += "static void " + std::string(name) +
           "(program::State& m, program::Host& host) {\n  static_cast<void>(m);\n  static_cast<void>(host);\n";
    if (routine.valid()) out += "  program::" + program.routines[routine].name + "(m, host);\n";
    out += "}\n";
  };
  runner("RunPeriod", program.schedule.period);
  runner("RunFastOnly", program.schedule.fast_only);
  runner("RunElapse", program.schedule.elapse);
  out += "static void SendText(program::State& m, const char* text, size_t length) {\n";
  out += program.text_inbox.valid()
             ? "  program::send_operator_text(m, text, length);\n"
             : "  static_cast<void>(m);\n  static_cast<void>(text);\n  static_cast<void>(length);\n";
  out += "}\n";
  out += kServe;
  if (debug) out += kForcing;
  return out + std::string(kServeOn);
}

}  // namespace

std::string HarnessText(std::span<const emit::Emittable> programs) {
  std::string out;
  // A program in one part is compiled here. All in front of the console, whose macros may be names of a program.
  for (const emit::Emittable& emittable : programs)
    out += "#include \"" + emittable.options.name + (emittable.parts.size() == 1 ? ".cpp" : ".hpp") + "\"\n";
  out += "#include \"console.h\"\n";
  // The code of the programs is optimized as the platform says. The harness need not be, and is half of the whole.
  out += "#if defined(__GNUC__) && !defined(__clang__)\n#pragma GCC optimize (\"O0\")\n#endif\n";
  for (const emit::Emittable& emittable : programs) out += ProgramHarness(emittable);
  out +=
      "int main() {\n  for (;;) {\n    uint32_t number = 0;\n    plcxx_console::Read(&number, sizeof number);\n"
      "    switch (number) {\n";
  for (size_t i = 0; i < programs.size(); ++i)
    out += "      case " + std::to_string(i) + ": " + ServerName(programs[i]) + "::Serve(); break;\n";
  return out + "      default: return 0;\n    }\n  }\n}\n";
}

}  // namespace plcxx::engines
