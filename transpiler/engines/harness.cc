#include "transpiler/engines/harness.h"

#include "transpiler/emit/print/host_function_head.h"

namespace plcxx::engines {
namespace {

// What the programs of one executable share: the commands, and what a host call does. It is compiled once, however many
// they are; State and Host are seen through a table.
constexpr std::string_view kServer = R"(
namespace plcxx_harness {
struct Program {
  void* state;
  size_t state_bytes;
  uint32_t* now;
  void (*start)();
  void (*init)();
  void (*period)();
  void (*fast_only)();
  void (*elapse)();
  void (*store_retentive)();
  void (*reapply_forces)();
  void (*send_text)(const char*, size_t);
  // Of the debug flavour only.
  unsigned char* force_mask;
  unsigned char* force_value;
  bool* off;
};
struct Answer { uint64_t result; uint32_t has_second; uint64_t second; };
static const Program* served = nullptr;
static uint32_t* told = nullptr;  // the events, as they are written
static uint32_t told_words = 0, told_room = 0, event_count = 0;
static uint32_t asking = kAsksNobody;

static void Tell(uint32_t word) {
  if (told_words == told_room) {
    const uint32_t room = 2 * told_room + 64;
    told = static_cast<uint32_t*>(plcxx_console::Grow(told, told_room * sizeof(uint32_t), room * sizeof(uint32_t)));
    told_room = room;
  }
  told[told_words++] = word;
}

static void Note(uint32_t function, uint32_t count, const uint64_t* arguments) {
  Tell(function);
  Tell(count);
  for (uint32_t i = 0; i < count; ++i) {
    Tell(static_cast<uint32_t>(arguments[i]));
    Tell(static_cast<uint32_t>(arguments[i] >> 32));
  }
  ++event_count;
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

static void SetBits(unsigned char& byte, uint32_t mask, uint32_t value) {
  byte = static_cast<unsigned char>((byte & ~mask) | (value & mask));
}

static void HostWrites() {
  const uint32_t at = ReadWord(), mask = ReadWord(), value = ReadWord();
  SetBits(static_cast<unsigned char*>(served->state)[at], mask, value);
  served->reapply_forces();
}

static Answer Ask(uint32_t function, uint32_t count, const uint64_t* arguments) {
  if (asking == kAsksNobody) return {0, 0, 0};
  const uint32_t head[3] = {kHostQuestion, function, count};
  plcxx_console::Write(head, sizeof head);
  if (count > 0) plcxx_console::Write(arguments, count * sizeof(uint64_t));
  if (asking == kAsksWithState) {
    plcxx_console::Write(served->state, served->state_bytes);
    plcxx_console::Flush();
  }
  for (;;) {
    switch (ReadLetter()) {
      case 'W': HostWrites(); break;
      case 'S': served->store_retentive(); break;
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

static void Report() {
  plcxx_console::Write(&event_count, sizeof event_count);
  if (told_words > 0) plcxx_console::Write(told, told_words * sizeof(uint32_t));
  event_count = told_words = 0;
  plcxx_console::Write(served->state, served->state_bytes);
  plcxx_console::Flush();
}

static void Run(void (*part)()) {
  *served->now = ReadWord();
  part();
  Report();
}

static void Force() {
  const uint32_t at = ReadWord(), mask = ReadWord(), value = ReadWord();
  served->force_mask[at] = static_cast<unsigned char>(served->force_mask[at] | mask);
  SetBits(served->force_value[at], mask, value);
  served->reapply_forces();
}

static void Release() {
  const uint32_t at = ReadWord(), mask = ReadWord();
  SetBits(served->force_mask[at], mask, 0);
}

static void SendText() {
  static char* text = nullptr;
  static uint32_t room = 0;
  const uint32_t size = ReadWord();
  if (size > room) {
    text = static_cast<char*>(plcxx_console::Grow(text, 0, 2 * static_cast<size_t>(size)));
    room = 2 * size;
  }
  plcxx_console::Read(text, size);
  served->send_text(text, size);
  Report();
}

static void Serve(const Program& program) {
  served = &program;
  program.start();
  event_count = told_words = 0;
  asking = kAsksNobody;
  for (;;) {
    const unsigned char letter = ReadLetter();
    if (!program.off && (letter == 'K' || letter == 'R' || letter == 'E')) plcxx_console::Quit();
    switch (letter) {
      case 'Q': return;
      case 'I': program.init(); Report(); break;
      case 'P': Run(program.period); break;
      case 'F': Run(program.fast_only); break;
      case 'L': Run(program.elapse); break;
      case 'W': HostWrites(); break;
      case 'K': Force(); break;
      case 'R': Release(); break;
      case 'E': {
        const uint32_t statement = ReadWord();
        program.off[statement] = ReadWord() == 0;
        break;
      }
      case 'T': SendText(); break;
      case 'H': asking = ReadWord(); break;
      case 'A': ReadAnswer(); break;
      case 'D': break;
      case 'S': program.store_retentive(); break;
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
  std::string out = "  static_cast<void>(host);\n";
  std::string call = std::to_string(number) + ", " + std::to_string(function.parameters.size());
  if (function.parameters.empty()) {
    call += ", nullptr)";
  } else {
    out += "  const uint64_t harness_arguments[] = {";
    for (const ir::Parameter& parameter : function.parameters)
      out += (out.back() == '{' ? "" : ", ") + ("::plcxx_harness::Bits(" + parameter.name + ")");
    out += "};\n";
    call += ", harness_arguments)";
  }
  if (!function.routine_exchange) out += "  ::plcxx_harness::Note(" + call + ";\n";
  out += "  const ::plcxx_harness::Answer harness_answer = ::plcxx_harness::Ask(" + call + ";\n";
  if (!function.out.name.empty())
    out += "  if (harness_answer.has_second) ::plcxx_harness::TakeBits(harness_answer.second, " + function.out.name +
           ");\n";
  if (function.result == ir::Type::kNone) return out + "  static_cast<void>(harness_answer);\n";
  return out + "  " + std::string(ir::CppName(function.result)) +
         " harness_result;\n  ::plcxx_harness::TakeBits(harness_answer.result, harness_result);\n  return "
         "harness_result;\n";
}

/// The host's store of retentive memory, kept beside the State.
std::string Storing(const ir::HostFunction& function, uint32_t number) {
  const bool loads = function.access == ir::HostAccess::kWritesRetentive;
  std::string out;
  if (!function.routine_exchange) out += "  ::plcxx_harness::Note(" + std::to_string(number) + ", 0, nullptr);\n";
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

/// Where State, Host and what the server calls of one program stand: a namespace beside the program's own, so that
/// neither's names are in the other's way.
std::string ServedName(const emit::Emittable& emittable) { return emittable.namespace_name + "_served"; }

/// Host and the host functions of one program, then its row of the table.
std::string ProgramHarness(const emit::Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  const bool retentive = emittable.layout.retentive_bytes > 0;
  const bool debug = emittable.options.flavour == emit::Flavour::kDebug;
  std::string out = "namespace " + emittable.namespace_name + " {\nstruct Host {\n  uint32_t now = 0;\n";
  if (retentive) out += "  Retentive stored{};\n  bool has_stored = false;\n";
  out += "};\n" + HostFunctions(emittable) + "}\n";
  out += "namespace " + ServedName(emittable) + " {\nnamespace program = ::" + emittable.namespace_name + ";\n";
  out += "static program::State m;\nstatic program::Host host;\n";
  const auto function = [&out](std::string_view name, std::string_view body) {
    out += "static void " + std::string(name) + "() {" + std::string(body) + "}\n";
  };
  const auto run = [&](std::string_view name, ir::RoutineId routine) {
    function(name, routine.valid() ? " program::" + program.routines[routine].name + "(m, host); " : "");
  };
  function("Start", " m = program::State{}; host = program::Host{}; ");
  function("Init", " program::init(m, host); ");
  run("Period", program.schedule.period);
  run("FastOnly", program.schedule.fast_only);
  run("Elapse", program.schedule.elapse);
  function("StoreRetentive", retentive ? " host.stored = m.retentive; host.has_stored = true; " : "");
  function("ReapplyForces", debug ? " m.ReapplyForces(); " : "");
  out += "static void SendText(const char* text, size_t length) {";
  out += program.text_inbox.valid() ? " program::send_operator_text(m, text, length); "
                                    : " static_cast<void>(text); static_cast<void>(length); ";
  out += "}\n";
  return out + "static const plcxx_harness::Program row = {&m, " + std::to_string(emittable.layout.size) +
         ", &host.now, Start, Init, Period, FastOnly, Elapse, StoreRetentive, ReapplyForces, SendText, " +
         (debug ? "m.force_mask, m.force_value, m.off" : "nullptr, nullptr, nullptr") + "};\n}\n";
}

std::string Constant(std::string_view name, uint32_t value) {
  return "constexpr uint32_t " + std::string(name) + " = " + std::to_string(value) + "u;\n";
}

}  // namespace

std::string HarnessText(std::span<const emit::Emittable> programs) {
  std::string out;
  // A program in one part is compiled here. All in front of the console, whose macros may be names of a program.
  for (const emit::Emittable& emittable : programs)
    out += "#include \"" + emittable.options.name + (emittable.parts.size() == 1 ? ".cpp" : ".hpp") + "\"\n";
  out += "#include \"console.h\"\n";
  // The code of the programs is optimized as the platform says. The harness need not be.
  out += "#if defined(__GNUC__) && !defined(__clang__)\n#pragma GCC optimize (\"O0\")\n#endif\n";
  out += "namespace plcxx_harness {\n" + Constant("kHostQuestion", kHostQuestion) +
         Constant("kAsksNobody", static_cast<uint32_t>(Asking::kNobody)) +
         Constant("kAsksWithState", static_cast<uint32_t>(Asking::kWithState)) + "}" + std::string(kServer);
  for (const emit::Emittable& emittable : programs) out += ProgramHarness(emittable);
  out += "static const plcxx_harness::Program* const programs[] = {";
  for (const emit::Emittable& emittable : programs) out += "&" + ServedName(emittable) + "::row, ";
  return out +
         "};\nint main() {\n  for (;;) {\n    uint32_t number = 0;\n    plcxx_console::Read(&number, sizeof number);\n"
         "    if (number >= sizeof programs / sizeof *programs) return 0;\n    "
         "plcxx_harness::Serve(*programs[number]);\n"
         "  }\n}\n";
}

}  // namespace plcxx::engines
