// The waveform: a VCD file as every viewer reads it.

#include <map>
#include <string>
#include <vector>

#include "transpiler/sim/trace.h"

namespace plcxx::sim {
namespace {

/// A short code for the signal: digits to the base of the 94 printable characters.
std::string Code(size_t index) {
  std::string code;
  do {
    code += static_cast<char>('!' + index % 94);
    index /= 94;
  } while (index != 0);
  return code;
}

uint32_t WidthOf(ir::Type type) { return type == ir::Type::kBit ? 1 : 8 * ir::Bytes(type); }

std::string Change(uint64_t value, ir::Type type, const std::string& code) {
  if (IsFloat(type)) return 'r' + ValueDigits(type, value) + ' ' + code + '\n';
  const uint32_t width = WidthOf(type);
  if (width == 1) return std::string(1, (value & 1) != 0 ? '1' : '0') + code + '\n';
  // Leading zeros say nothing: a reader extends with 0 to the left.
  uint32_t digits = 1;
  while (digits < width && value >> digits != 0) ++digits;
  std::string out = "b";
  for (uint32_t i = digits; i > 0; --i) out += (value >> (i - 1) & 1) != 0 ? '1' : '0';
  return out + ' ' + code + '\n';
}

}  // namespace

std::string VcdName(std::string_view name) {
  std::string safe;
  for (const char c : name) {
    const bool kept = static_cast<unsigned char>(c) > ' ' && c != 0x7F && c != '[' && c != ']' && c != '$';
    safe += kept ? c : '_';
  }
  return safe.empty() ? "_" : safe;
}

std::string WriteVcd(const Trace& trace, std::string_view program) {
  std::string out = "$timescale 1 ms $end\n$scope module " + VcdName(program) + " $end\n";
  // Scopes in the order of their first signal.
  std::vector<std::string> scopes;
  std::map<std::string, std::vector<size_t>> members;
  for (size_t i = 0; i < trace.watched().size(); ++i) {
    const std::string& scope = trace.watched()[i].scope;
    if (!members.contains(scope)) scopes.push_back(scope);
    members[scope].push_back(i);
  }
  for (const std::string& scope : scopes) {
    out += "$scope module " + VcdName(scope) + " $end\n";
    for (const size_t i : members[scope]) {
      const Watched& watched = trace.watched()[i];
      const uint32_t width = WidthOf(watched.place.type);
      const bool real = IsFloat(watched.place.type);
      out += (real ? "$var real " : "$var wire ") + std::to_string(width) + ' ' + Code(i) + ' ' + VcdName(watched.name);
      if (width > 1 && !real) out += " [" + std::to_string(width - 1) + ":0]";
      out += " $end\n";
    }
    out += "$upscope $end\n";
  }
  out += "$upscope $end\n$enddefinitions $end\n";

  const Sample* before = nullptr;
  for (const Sample& sample : trace.samples()) {
    std::string changes;
    for (size_t i = 0; i < sample.values.size(); ++i) {
      if (before != nullptr && before->values[i] == sample.values[i]) continue;
      changes += Change(sample.values[i], trace.watched()[i].place.type, Code(i));
    }
    const bool last = &sample == &trace.samples().back();  // also without a change: it is where the waveform ends
    if (before == nullptr) {
      out += '#' + std::to_string(sample.time_ms) + "\n$dumpvars\n" + changes + "$end\n";
    } else if (!changes.empty() || last) {
      out += '#' + std::to_string(sample.time_ms) + '\n' + changes;
    }
    before = &sample;
  }
  return out;
}

}  // namespace plcxx::sim
