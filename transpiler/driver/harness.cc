#include "transpiler/driver/harness.h"

namespace plcxx::driver {
namespace {

constexpr std::string_view kMain = R"(
namespace {

using program::Host;
using program::State;

State m;
Host host;

uint32_t ReadWord() {
  uint32_t value = 0;
  if (fread(&value, sizeof value, 1, stdin) != 1) exit(0);
  return value;
}

void Answer() {
  const uint32_t count = static_cast<uint32_t>(host.events.size());
  fwrite(&count, sizeof count, 1, stdout);
  for (const Host::Event& event : host.events) {
    const uint32_t head[2] = {event.function, static_cast<uint32_t>(event.arguments.size())};
    fwrite(head, sizeof head, 1, stdout);
    fwrite(event.arguments.data(), sizeof(uint64_t), event.arguments.size(), stdout);
  }
  host.events.clear();
  fwrite(&m, kStateBytes, 1, stdout);
  fflush(stdout);
}

}  // namespace

int main() {
  unsigned char* const bytes = reinterpret_cast<unsigned char*>(&m);
  for (;;) {
    switch (getchar()) {
      case 'I': program::init(m, host); Answer(); break;
      case 'P': host.now = ReadWord(); RunPeriod(m, host); Answer(); break;
      case 'F': host.now = ReadWord(); RunFastOnly(m, host); Answer(); break;
      case 'W': {
        const uint32_t at = ReadWord(), mask = ReadWord(), value = ReadWord();
        bytes[at] = static_cast<unsigned char>((bytes[at] & ~mask) | (value & mask));
        m.ReapplyForces();
        break;
      }
      case 'K': {
        const uint32_t at = ReadWord(), mask = ReadWord(), value = ReadWord();
        m.force_mask[at] = static_cast<unsigned char>(m.force_mask[at] | mask);
        m.force_value[at] = static_cast<unsigned char>((m.force_value[at] & ~mask) | (value & mask));
        m.ReapplyForces();
        break;
      }
      case 'R': {
        const uint32_t at = ReadWord(), mask = ReadWord();
        m.force_mask[at] = static_cast<unsigned char>(m.force_mask[at] & ~mask);
        break;
      }
      case 'T': {
        std::vector<char> text(ReadWord() + 1);
        if (text.size() > 1 && fread(text.data(), text.size() - 1, 1, stdin) != 1) exit(0);
        SendText(m, text.data(), text.size() - 1);
        Answer();
        break;
      }
      case 'E': {
        const uint32_t statement = ReadWord();
        m.off[statement] = ReadWord() == 0;
        break;
      }
      case 'S': StoreRetentive(m, host); break;
      default: return 0;
    }
  }
}
)";

std::string Parameters(const ir::HostFunction& function) {
  std::string out = "(Host& host";
  switch (function.access) {
    case ir::HostAccess::kNone:
      break;
    case ir::HostAccess::kReadsState:
      out += ", const State&";
      break;
    case ir::HostAccess::kWritesState:
      out += ", State&";
      break;
    case ir::HostAccess::kReadsRetentive:
      out += ", const Retentive& retentive";
      break;
    case ir::HostAccess::kWritesRetentive:
      out += ", Retentive& retentive";
      break;
  }
  for (const ir::Parameter& parameter : function.parameters) {
    out += ", " +
           (parameter.enumerators.empty() ? std::string(ir::CppName(parameter.type))
                                          : function.name + "_" + parameter.name) +
           " " + parameter.name;
  }
  return out + ") noexcept";
}

std::string HostFunctions(const emit::Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  std::string out;
  for (uint32_t i = 0; i < program.host_functions.size(); ++i) {
    if (!emittable.host_used[i]) continue;
    const ir::HostFunctionId id(i);
    const ir::HostFunction& function = program.host_functions[id];
    const bool loads = function.access == ir::HostAccess::kWritesRetentive;
    out += (loads ? "void" : std::string(ir::CppName(function.result))) + " " + function.name + Parameters(function) +
           " {\n";
    out += "  static_cast<void>(host);\n";
    if (id == program.schedule.now) {
      out += "  return host.now;\n";
    } else if (loads) {
      out += "  if (host.has_stored) retentive = host.stored;\n";
    } else {
      if (function.access == ir::HostAccess::kReadsRetentive)
        out += "  host.stored = retentive;\n  host.has_stored = true;\n";
      if (!function.routine_exchange) {
        out += "  host.events.push_back({" + std::to_string(i) + ", {";
        for (size_t k = 0; k < function.parameters.size(); ++k) {
          out += (k == 0 ? "" : ", ") + ("static_cast<uint64_t>(" + function.parameters[k].name + ")");
        }
        out += "}});\n";
      }
      if (function.result != ir::Type::kNone) out += "  return {};\n";
    }
    out += "}\n";
  }
  return out;
}

}  // namespace

std::string HarnessText(const emit::Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  const bool retentive = emittable.layout.retentive_bytes > 0;
  std::string out =
      "#include <stdio.h>\n#include <stdlib.h>\n#include <vector>\n#include \"" + emittable.options.name + ".hpp\"\n";
  out += "namespace " + emittable.namespace_name + " {\n";
  out += "struct Host {\n  struct Event { uint32_t function; std::vector<uint64_t> arguments; };\n";
  out += "  uint32_t now = 0;\n  std::vector<Event> events;\n";
  if (retentive) out += "  Retentive stored{};\n  bool has_stored = false;\n";
  out += "};\n" + HostFunctions(emittable) + "}\n";
  out += "namespace program = " + emittable.namespace_name + ";\n";
  out += "constexpr size_t kStateBytes = " + std::to_string(emittable.layout.size) + ";\n";
  const auto runner = [&](std::string_view name, ir::RoutineId routine) {
    out += "static void " + std::string(name) +
           "(program::State& m, program::Host& host) {\n  static_cast<void>(m);\n  static_cast<void>(host);\n";
    if (routine.valid()) out += "  program::" + program.routines[routine].name + "(m, host);\n";
    out += "}\n";
  };
  runner("RunPeriod", program.schedule.period);
  runner("RunFastOnly", program.schedule.fast_only);
  out += "static void SendText(program::State& m, const char* text, size_t length) {\n";
  out += program.text_inbox.valid()
             ? "  program::send_operator_text(m, text, length);\n"
             : "  static_cast<void>(m);\n  static_cast<void>(text);\n  static_cast<void>(length);\n";
  out += "}\nstatic void StoreRetentive(const program::State& m, program::Host& host) {\n";
  out += retentive ? "  host.stored = m.retentive;\n  host.has_stored = true;\n"
                   : "  static_cast<void>(m);\n  static_cast<void>(host);\n";
  out += "}\n";
  return out + std::string(kMain);
}

}  // namespace plcxx::driver
