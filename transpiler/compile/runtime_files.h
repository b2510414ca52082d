// The headers of runtime_support as files beside generated code.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace plcxx::compile {

struct RuntimeFile {
  std::string name;  // "plcxx/timers.h", as generated code includes it
  std::string_view text;
};

/// All of them, by name.
std::vector<RuntimeFile> RuntimeFiles();
/// Those of runtime_support/plcxx_host, which a host's files include: "plcxx_host/pins.h".
std::vector<RuntimeFile> HostFiles();

/// Writes them to `directory`/plcxx, which is made when missing. False when one of them cannot be written.
bool WriteRuntime(const std::string& directory);

}  // namespace plcxx::compile
