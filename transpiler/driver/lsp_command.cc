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

constexpr int kMappedBytes = 4 << 20, kFreeBytes = 16 << 20;

/// After each key a large C program is a few arrays of megabytes for a moment, which the next key needs again: they are
/// kept, for what goes back to the system comes again page by page. The parser of C has a thread of its own; that the
/// memory of one is not kept beside that of the other, there is one heap.
void KeepMemory() {
  mallopt(M_ARENA_MAX, 1);
  mallopt(M_MMAP_THRESHOLD, kMappedBytes);
  mallopt(M_TRIM_THRESHOLD, kFreeBytes);
}

}  // namespace

void AddLsp(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("lsp", "Serve an editor: messages, meanings and names while typing");
  const auto stdio = std::make_shared<bool>(false);
  command->add_flag("--stdio", *stdio, "Standard input and output, which are used in any case");
  command->footer(kLspFooter);
  command->callback([&run, stdio] {
    run = [] {
      KeepMemory();
      return lsp::Serve(AnswersOfScenarios());
    };
  });
}

}  // namespace plcxx::driver
