// The files that join a program to a machine: `plcxx emit --host`.
//
// In: the emittable program, of which this knows places, host functions and the schedule, and never the language. Out:
// NAME_pins.hpp and NAME_pins.cpp, which all hosts share, and one small file of the host; for LinuxCNC also NAME.hal
// and the manual page NAME.9. What they have in common with every program is in runtime_support/plcxx_host.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/emit/emittable.h"
#include "transpiler/emit/output_file.h"

namespace plcxx::host {

enum class Kind : uint8_t {
#define PLCXX_HOST(Id, Text, Meaning) k##Id,
#include "transpiler/host/hosts.def"
#undef PLCXX_HOST
};

struct HostRow {
  Kind kind;
  std::string_view text;
  std::string_view meaning;
};
const std::vector<HostRow>& Hosts();
std::optional<Kind> FindHost(std::string_view text);

/// The files of a host, of a program that was legalized with EmitOptions::simulated; none of kOwn. Pins that cannot be
/// are reported, and then nothing is written.
std::vector<emit::OutputFile> PrintHost(const emit::Emittable& emittable, Kind kind, diag::Engine& diagnostics);
/// Their names, for build systems.
std::vector<std::string> HostFiles(const std::string& program, Kind kind);

}  // namespace plcxx::host
