#include "transpiler/driver/engine_choice.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <iostream>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "transpiler/driver/terminal.h"
#include "transpiler/fleet/library.h"
#include "transpiler/support/near_words.h"

namespace plcxx::driver {
namespace {

/// One word between commas.
struct Word {
  std::string_view name;
  uint32_t one_in = 1;
};

std::optional<Word> ReadWord(std::string_view text) {
  const size_t slash = text.find('/');
  if (slash == std::string_view::npos) return Word{text};
  Word word{text.substr(0, slash)};
  const std::string_view digits = text.substr(slash + 1);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), word.one_in);
  if (error != std::errc() || end != digits.data() + digits.size() || word.one_in == 0) return std::nullopt;
  return word;
}

bool RunsAllScenarios() {
  const char* value = std::getenv("PLCXX_ALL_TARGETS");
  return value != nullptr && *value != '\0' && std::string_view(value) != "0";
}

class Choice {
 public:
  Choice(const std::string& compiler, scenarios::SuiteOptions& options) : compiler_(compiler), options_(options) {}

  bool Add(Word word) {
    if (RunsAllScenarios()) word.one_in = 1;
    if (word.name == "sim") return options_.simulator = true;
    if (word.name == "host") return AddHost(word.one_in);
    if (word.name == "all") {
      options_.simulator = true;
      if (compiler_.empty() && engines::FindCompiler().empty()) {
        std::cerr << "plcxx: note: no C++ compiler found; scenarios run in the simulator only\n";
        return true;
      }
      return AddHost(word.one_in);
    }
    if (word.name.starts_with("fleet")) return AddFleet(word);
    const std::vector<std::string_view> machines = engines::EmulatedMachines();
    if (std::ranges::find(machines, word.name) == machines.end()) return PrintUnknown(word.name);
    options_.simulator = true;
    return AddPlatform(engines::MakeEmulatedPlatform(word.name), word.one_in);
  }

 private:
  bool AddHost(uint32_t one_in) {
    const std::optional<std::string> compiler = CompilerOf("host", compiler_);
    return compiler && AddPlatform(engines::MakeHostPlatform(*compiler), one_in);
  }

  /// "fleet", as wide as this processor has it, or with a number of machines.
  bool AddFleet(Word word) {
    unsigned lanes = 0;
    if (word.name == "fleet64") lanes = 64;
    if (word.name == "fleet256") lanes = 256;
    if (word.name == "fleet512") lanes = 512;
    if (lanes == 0 && word.name != "fleet") return PrintUnknown(word.name);
    if (const std::string reason = fleet::TooWide(lanes); !reason.empty()) {
      PrintUsageError("'--engine " + std::string(word.name) + "': " + reason);
      return false;
    }
    const std::optional<std::string> compiler = CompilerOf("fleet", compiler_);
    if (!compiler) return false;
    options_.simulator = true;
    // Compiling takes longer than a scenario; level 1 keeps what a fleet is made of and costs half.
    options_.fleet = {.library = {.compiler = *compiler, .level = "1", .lanes = lanes}, .one_in = word.one_in};
    return true;
  }

  static bool PrintUnknown(std::string_view name) {
    // Both run a whole scenario at once, in a process of their own; an engine here does one period and is asked what it
    // has.
    if (name == "hal" || name == "classicladder") {
      const std::string script = name == "hal" ? "tests/host/linuxcnc.py" : "tests/judges/classicladder/run.py";
      PrintUsageError("'" + std::string(name) + "' runs in LinuxCNC (dev/install linuxcnc) by " + script +
                      " of plcxx's sources, and is no engine of this command");
      return false;
    }
    PrintUsageError("there is no engine '" + std::string(name) + "'" + support::ThereAre(name, EngineNames()));
    return false;
  }

  bool AddPlatform(engines::PlatformOrFailure made, uint32_t one_in) {
    if (const auto* failure = std::get_if<engines::CompileFailure>(&made)) {
      PrintUsageError(failure->message);
      return false;
    }
    auto platform = std::get<std::shared_ptr<const engines::Platform>>(std::move(made));
    const auto same = [&](const scenarios::PlatformUse& use) { return use.platform->name == platform->name; };
    if (std::ranges::none_of(options_.platforms, same)) options_.platforms.push_back({std::move(platform), one_in});
    return true;
  }

  std::string compiler_;
  scenarios::SuiteOptions& options_;
};

}  // namespace

std::optional<std::string> CompilerOf(std::string_view engine, const std::string& named) {
  std::string compiler = named.empty() ? engines::FindCompiler() : named;
  if (!compiler.empty()) return compiler;
  PrintUsageError("there is no C++ compiler for '--engine " + std::string(engine) +
                  "': install g++ or name one with --cxx");
  return std::nullopt;
}

std::vector<std::string_view> EngineNames() {
  std::vector<std::string_view> names = {"sim", "host", "all", "fleet", "fleet64", "fleet256", "fleet512"};
  for (const std::string_view machine : engines::EmulatedMachines()) names.push_back(machine);
  return names;
}

bool ChooseEngines(const std::string& choice, const std::string& compiler, scenarios::SuiteOptions& options) {
  options.simulator = false;
  options.platforms.clear();
  options.fleet.reset();
  Choice chosen(compiler, options);
  for (size_t at = 0; at <= choice.size();) {
    const size_t end = std::min(choice.find(',', at), choice.size());
    const std::string_view text = std::string_view(choice).substr(at, end - at);
    const std::optional<Word> word = ReadWord(text);
    if (!word) {
      PrintUsageError("'--engine " + std::string(text) + "': a whole number from 1 on stands behind '/'");
      return false;
    }
    if (!chosen.Add(*word)) return false;
    at = end + 1;
  }
  return true;
}

}  // namespace plcxx::driver
