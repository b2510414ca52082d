#include "transpiler/host/host.h"

#include "transpiler/host/print_pins.h"
#include "transpiler/host/wiring.h"

namespace plcxx::host {

const std::vector<HostRow>& Hosts() {
  static const std::vector<HostRow> rows = {
#define PLCXX_HOST(Id, Text, Meaning) {Kind::k##Id, Text, Meaning},
#include "transpiler/host/hosts.def"
#undef PLCXX_HOST
  };
  return rows;
}

std::optional<Kind> FindHost(std::string_view text) {
  for (const HostRow& row : Hosts()) {
    if (row.text == text) return row.kind;
  }
  return std::nullopt;
}

std::vector<std::string> HostFiles(const std::string& program, Kind kind) {
  std::vector<std::string> files = {program + "_pins.hpp", program + "_pins.cpp"};
  switch (kind) {
    case Kind::kOwn:
      return {};
    case Kind::kPosix:
      files.push_back(program + "_posix.cpp");
      break;
    case Kind::kLinuxcnc:
      for (const char* suffix : {"_linuxcnc.cpp", ".hal", ".9"}) files.push_back(program + suffix);
      break;
    case Kind::kModbus:
      files.push_back(program + "_modbus.cpp");
      break;
  }
  return files;
}

std::vector<emit::OutputFile> PrintHost(const emit::Emittable& emittable, Kind kind, diag::Engine& diagnostics) {
  if (kind == Kind::kOwn) return {};
  const size_t errors = diagnostics.error_count();
  const Wiring wiring = Wire(emittable, diagnostics);
  if (diagnostics.error_count() != errors) return {};
  std::vector<std::string> texts = {PrintPinsHeader(emittable, wiring), PrintPinsSource(emittable, wiring)};
  switch (kind) {
    case Kind::kOwn:
      break;
    case Kind::kPosix:
      texts.push_back(PrintPosixSource(emittable));
      break;
    case Kind::kLinuxcnc:
      texts.push_back(PrintHalSource(emittable));
      texts.push_back(PrintHalFile(emittable, wiring));
      texts.push_back(PrintHalManual(emittable, wiring));
      break;
    case Kind::kModbus:
      texts.push_back(PrintModbusSource(emittable));
      break;
  }
  std::vector<emit::OutputFile> files;
  const std::vector<std::string> names = HostFiles(emittable.options.name, kind);
  for (size_t i = 0; i < texts.size(); ++i) files.push_back({names[i], std::move(texts[i])});
  return files;
}

}  // namespace plcxx::host
