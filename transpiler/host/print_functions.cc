// The program's host functions on its pins, and what one period is.

#include "transpiler/emit/print/host_function_head.h"
#include "transpiler/host/pins_printer.h"

namespace plcxx::host {

std::string_view Member(PinType type) {
  switch (type) {
    case PinType::kBit:
      return "bit";
    case PinType::kS32:
      return "s32";
    case PinType::kU32:
      return "u32";
    case PinType::kFloat:
      return "real";
  }
  return "";
}
void PinsPrinter::Inputs(std::string& out) const {
  for (const WiredInput& input : wiring_.inputs) {
    const ir::Type type = program_.places[input.place].type;
    out += "  " + Place(input.place) + " = ";
    if (input.parts.size() > 1) {
      std::string sum;
      for (const InputPart& part : input.parts) {
        const WiredPin& pin = wiring_.pins[part.pin];
        const std::string value = pin.type == PinType::kBit ? "(" + Of(part.pin) + " ? 1U : 0U)"
                                                            : "uint32_t{plcxx::host::Fit8(" + Of(part.pin) + ")}";
        sum += (sum.empty() ? "" : " |\n      ") + value + (part.shift > 0 ? " << " + Number(part.shift) : "");
      }
      out += "static_cast<" + std::string(ir::CppName(type)) + ">(" + sum + ");\n";
      continue;
    }
    out += FromPin(input.place, input.parts.front().pin) + ";\n";
  }
}

std::string PinsPrinter::FromPin(ir::PlaceId place, uint32_t pin) const {
  const bool has_sign = wiring_.pins[pin].type == PinType::kS32;
  const std::string value = Of(pin), whole = has_sign ? "static_cast<uint32_t>(" + value + ")" : value;
  switch (program_.places[place].type) {
    case ir::Type::kI8:
      return has_sign ? "static_cast<uint8_t>(" + whole + ")" : "plcxx::host::Fit8(" + whole + ")";
    case ir::Type::kI16:
      return has_sign ? "static_cast<uint16_t>(" + whole + ")" : "plcxx::host::Fit16(" + whole + ")";
    case ir::Type::kF32:
      return "static_cast<float>(" + value + ")";
    case ir::Type::kBit:
    case ir::Type::kF64:
      return value;
    case ir::Type::kI32:
    case ir::Type::kI64:
    case ir::Type::kNone:
      return whole;
  }
  return whole;
}

/// A parameter goes both ways: what somebody wrote since the last period counts once.
void PinsPrinter::TakeParameters(std::string& out) const {
  for (const WiredOutput& parameter : wiring_.parameters) {
    const std::string pin = Of(parameter.pin), shown = "host.shown" + pin.substr(std::string("host.pins").size());
    const bool is_float = wiring_.pins[parameter.pin].type == PinType::kFloat;
    const std::string differs = is_float ? pin + " < " + shown + " || " + pin + " > " + shown : pin + " != " + shown;
    out += "  if (" + differs + ") " + Place(parameter.place) + " = " + FromPin(parameter.place, parameter.pin) + ";\n";
  }
}
void PinsPrinter::GiveParameters(std::string& out) const {
  for (const WiredOutput& parameter : wiring_.parameters) {
    const std::string pin = Of(parameter.pin), shown = "host.shown" + pin.substr(std::string("host.pins").size());
    out += "  " + pin + " = " + ToPin(parameter) + ";\n  " + shown + " = " + pin + ";\n";
  }
}

std::string PinsPrinter::ToPin(const WiredOutput& output) const {
  const ir::Type type = program_.places[output.place].type;
  const std::string value = Place(output.place);
  if (type == ir::Type::kF32) return "static_cast<double>(" + value + ")";
  if (wiring_.pins[output.pin].type != PinType::kS32) return value;
  // A narrow value's sign first.
  if (type == ir::Type::kI8) return "static_cast<int8_t>(" + value + ")";
  if (type == ir::Type::kI16) return "static_cast<int16_t>(" + value + ")";
  return "static_cast<int32_t>(" + value + ")";
}

void PinsPrinter::Outputs(std::string& out) const {
  for (const WiredOutput& output : wiring_.outputs) out += "  " + Of(output.pin) + " = " + ToPin(output) + ";\n";
}

namespace {

std::string Fitting(ir::Type type, const std::string& value) {
  if (type == ir::Type::kI8) return "plcxx::host::Fit8(" + value + ")";
  if (type == ir::Type::kI16) return "plcxx::host::Fit16(" + value + ")";
  if (type == ir::Type::kF32) return "static_cast<float>(" + value + ")";
  return value;
}

}  // namespace

void PinsPrinter::Event(const WiredCall& call, uint64_t index, std::string& out) const {
  const ir::HostFunction& function = program_.host_functions[call.function];
  uint32_t pin = call.first_pin;
  out += "  ++" + Of(pin++) + ";\n";
  std::string arguments;
  for (const ir::Parameter& parameter : function.parameters) {
    const bool is_float = wiring_.pins[pin].type == PinType::kFloat;
    const std::string value = !parameter.enumerators.empty() ? "static_cast<uint32_t>(" + parameter.name + ")"
                              : is_float                     ? "static_cast<double>(" + parameter.name + ")"
                                                             : parameter.name;
    out += "  " + Of(pin) + " = " + value + ";\n";
    if (!is_float)
      arguments += (arguments.empty() ? "" : ", ") +
                   (parameter.enumerators.empty() ? "static_cast<uint32_t>(" + parameter.name + ")" : value);
    ++pin;
  }
  // What the program asks for again in every period would fill the log.
  if (!function.polled && !function.routine_exchange)
    out += "  host.events.Push({" + Number(index) + ", {" + arguments + "}});\n";
  const std::string result = function.result != ir::Type::kNone ? Of(pin++) : "";
  if (!function.out.name.empty()) out += "  " + function.out.name + " = " + Fitting(function.out.type, Of(pin)) + ";\n";
  if (!result.empty()) out += "  return " + Fitting(function.result, result) + ";\n";
  const bool uses_parameter = function.access != ir::HostAccess::kNone;
  if (uses_parameter)
    out = out + "  static_cast<void>(" +
          (function.access == ir::HostAccess::kReadsState || function.access == ir::HostAccess::kWritesState
               ? "m"
               : "retentive") +
          ");\n";
}

void PinsPrinter::Port(const WiredCall& call, std::string& out) const {
  const ir::HostFunction& function = program_.host_functions[call.function];
  const bool reads = function.result != ir::Type::kNone;
  out += "  switch (" + function.parameters[0].name + ") {\n";
  for (const WiredPort& port : call.ports) {
    out += "    case " + Number(port.number) + ":\n";
    if (reads) {
      out += "      return plcxx::host::ByteOf(&" + Pin(port.first_pin) + ");\n";
    } else {
      out += "      plcxx::host::PutBits(" + function.parameters[1].name + ", &" + Pin(port.first_pin) +
             ");\n      break;\n";
    }
  }
  out += reads ? "    default:\n      return 0;\n  }\n" : "    default:\n      break;\n  }\n";
}

void PinsPrinter::Functions(std::string& out) const {
  uint64_t event = 0;
  for (const WiredCall& call : wiring_.calls) {
    const ir::HostFunction& function = program_.host_functions[call.function];
    out += emit::print::HostFunctionHead(function) + " {\n";
    switch (call.role) {
      case CallRole::kClock:
        out += "  return static_cast<uint32_t>(host.time_ms);\n";
        break;
      case CallRole::kTakeInputs:
        Inputs(out);
        if (wiring_.inputs.empty()) out += "  static_cast<void>(host), static_cast<void>(m);\n";
        break;
      case CallRole::kGiveOutputs:
        Outputs(out);
        if (wiring_.outputs.empty()) out += "  static_cast<void>(host), static_cast<void>(m);\n";
        break;
      case CallRole::kLoad:
        out += "  if (host.stored_is_there) __builtin_memcpy(&retentive, host.stored, sizeof retentive);\n";
        break;
      case CallRole::kStore:
        out += "  host.retentive.Give(&retentive);\n";
        break;
      case CallRole::kPort:
        Port(call, out);
        break;
      case CallRole::kEvent:
        Event(call, event++, out);
        break;
    }
    out += "}\n";
  }
}

void PinsPrinter::Messages(std::string& out) const {
  if (wiring_.messages.empty()) return;
  out +=
      "/// Says once that a message is shown, and notes the lowest number.\n"
      "void Look(Host& host, uint32_t index, bool shown, uint32_t& lowest) noexcept {\n"
      "  if (shown && !host.active[index]) host.events.Push({plcxx::host::Event::kMessage, {index}});\n"
      "  host.active[index] = shown;\n  const uint32_t number = Machine::messages[index].number;\n"
      "  if (shown && (lowest == 0 || number < lowest)) lowest = number;\n}\n\n"
      "void LookAtMessages(const State& m, Host& host) noexcept {\n  uint32_t lowest = 0;\n";
  for (size_t i = 0; i < wiring_.messages.size(); ++i) {
    const WiredMessage& message = wiring_.messages[i];
    std::string shown = message.bit.valid() ? Place(message.bit) : "";
    for (const ir::PlaceId word : wiring_.message_words)
      shown += (shown.empty() ? "" : " | ") + ("(" + Place(word) + " == " + Number(message.number) + ")");
    out += "  Look(host, " + Number(i) + ", " + shown + ", lowest);\n";
  }
  out += "  " + Of(wiring_.message_pin) + " = lowest;\n}\n\n";
}

void PinsPrinter::Step(std::string& out) const {
  const ir::Schedule& schedule = program_.schedule;
  const auto routine = [&](ir::RoutineId id) { return emittable_.routine_names[id.index] + "(m, host);\n"; };
  const std::string base = Number(wiring_.base_ms), period = Number(std::max(1U, schedule.period_ms));
  out += "void Machine::Step(State& m, Host& host) noexcept {\n  if (!host.started) {\n    host.started = true;\n    " +
         std::string(schedule.init.valid() ? routine(schedule.init) : "") + "  }\n";
  TakeParameters(out);
  const bool parts = schedule.fast_ms != 0 || schedule.elapses_every_ms;
  if (parts) {
    out += "  const uint64_t before = host.time_ms;\n  host.time_ms += " + base +
           " + host.skipped_ms;\n  host.skipped_ms = 0;\n";
    if (schedule.fast_ms != 0) {
      const std::string fast = Number(schedule.fast_ms);
      out += schedule.fast_ms == wiring_.base_ms
                 ? "  " + routine(schedule.fast_only)
                 : "  if (host.time_ms / " + fast + " != before / " + fast + ") " + routine(schedule.fast_only);
    }
    out += "  const bool due = host.time_ms / " + period + " != before / " + period + ";\n  if (due) " +
           routine(schedule.period);
    if (schedule.elapses_every_ms && schedule.elapse.valid()) out += "  if (!due) " + routine(schedule.elapse);
  } else {
    const std::string passes = "  host.time_ms += " + base + " + host.skipped_ms;\n  host.skipped_ms = 0;\n";
    if (schedule.period_ends_its_time) {
      out += passes + "  " + routine(schedule.period);
    } else {
      out += "  host.time_ms += host.skipped_ms;\n  host.skipped_ms = 0;\n  " + routine(schedule.period) +
             "  host.time_ms += " + base + ";\n";
    }
  }
  GiveParameters(out);
  if (wiring_.stores_by_itself) {
    const ir::PlaceId asked = schedule.retain_at_power_off;
    const bool conditional = asked.valid() && !emittable_.place_names[asked.index].empty();
    out +=
        std::string("  ") + (conditional ? "if (" + Place(asked) + ") " : "") + "host.retentive.Give(&m.retentive);\n";
  }
  if (!wiring_.messages.empty()) out += "  LookAtMessages(m, host);\n";
  out += "}\n";
}

}  // namespace plcxx::host
