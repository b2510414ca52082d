// plcxx mcp: the server for agents.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <system_error>

#include "transpiler/driver/common_options.h"
#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/mcp/server.h"

namespace plcxx::driver {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMcpFooter =
    R"(Examples:
  plcxx mcp machines/lathe     what an agent starts, for this folder and what is below it

An agent starts it and talks to it over standard input and output (Model Context Protocol,
one JSON object a line). docs/mcp.md lists the tools. They read and write below DIR alone; what is only shown is made in
a temporary folder that is removed.
Exit codes: 0 when the agent has closed its side, 2 wrong use.)";

struct McpSettings {
  std::string folder = ".";
  int most_seconds = 600;
};

int RunMcp(const McpSettings& settings) {
  std::error_code error;
  const fs::path folder = fs::canonical(settings.folder, error);
  if (error || !fs::is_directory(folder)) {
    return UsageError("'" + settings.folder + "' is no folder");
  }
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  if (error) {
    return UsageError("this system does not tell where plcxx itself is");
  }
  return mcp::Serve({.plcxx = self.string(), .folder = folder.string(), .most_seconds = settings.most_seconds});
}

}  // namespace

void AddMcp(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("mcp", "Serve an agent: check, simulate, test, compare and prove programs");
  const auto settings = std::make_shared<McpSettings>();
  command->add_option("DIR", settings->folder, "The folder that the tools work in; else the current one")
      ->type_name("");
  command->add_option("--time-limit", settings->most_seconds, "Of real time, at most, for a call (600)")
      ->check(CLI::Range(1, 86400))
      ->type_name("SECONDS");
  command->footer(kMcpFooter);
  command->callback([settings, &run] { run = [settings] { return RunMcp(*settings); }; });
}

}  // namespace plcxx::driver
