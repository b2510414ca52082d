// plcxx lsp: the language server.
#include <malloc.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "transpiler/driver/common_options.h"
#include "transpiler/driver/lsp_scenarios.h"
#include "transpiler/lsp/server.h"

namespace plcxx::driver {
namespace {

constexpr const char* kLspFooter =
    R"(Examples:
  plcxx lsp                    what an editor starts: it waits for the editor's first message

An editor starts it and talks to it over standard input and output (Language Server
Protocol 3.17). docs/editor.md says what Neovim, Helix, Kate and Emacs have to know of it.
Exit codes: 0 after 'shutdown' and 'exit', 1 when the editor is gone without them.)";

constexpr int kMappedBytes = 1 << 20;

/// A large C program is a few arrays of megabytes for a moment, after each key. The C library would keep them for
/// the next time, and apart from each other for each thread: the parser of C has one of its own. So that an editor's
/// server stays small, they go back to the system, and what is small has one heap.
void KeepMemorySmall() {
  mallopt(M_ARENA_MAX, 1);
  mallopt(M_MMAP_THRESHOLD, kMappedBytes);
}

}  // namespace

void AddLsp(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("lsp", "Serve an editor: messages, meanings and names while typing");
  const auto stdio = std::make_shared<bool>(false);
  command->add_flag("--stdio", *stdio, "Standard input and output, which are used in any case");
  command->footer(kLspFooter);
  command->callback([&run, stdio] {
    run = [] {
      KeepMemorySmall();
      return lsp::Serve(AnswersOfScenarios());
    };
  });
}

}  // namespace plcxx::driver
