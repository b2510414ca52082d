// The command line of plcxx. Nothing is initialized before a subcommand is chosen, so that the start costs nothing.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/driver/command_word.h"
#include "transpiler/driver/common_options.h"
#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/live_command.h"
#include "transpiler/driver/mutate_command.h"
#include "transpiler/driver/soak_command.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/driver/test_command.h"
#include "transpiler/driver/why_command.h"
#include "transpiler/support/beside_work.h"

namespace plcxx::driver {
namespace {

constexpr const char* kMainFooter = R"(Examples:
  plcxx init                                        make a project of this folder: plcxx.yaml
  plcxx check                                       its program; and so test, emit, prove, diff main..
  plcxx emit turret.sym turret.plc -o generated     C++ for any toolchain
  plcxx build turret.plc --target cortex-m4f        a library for a controller, audited and measured
  plcxx check turret.sym turret.plc                 what is wrong or doubtful
  plcxx test turret.yaml                            run scenarios
  plcxx sim turret.plc --for 3s --watch U4A8,W2K2   watch it run
  plcxx diff old new                                which outputs behave differently, and when
  plcxx prove turret.plc --property turret.prop     what holds for all inputs, and what does not
  plcxx explain nc110-41                            what a message means

plcxx COMMAND --help tells more about one command.
Exit codes: 0 done, 1 the program has errors or a scenario failed, 2 wrong use, 3 a fault of plcxx.)";

int InternalFault(const char* what) {
  std::cerr << "plcxx: internal fault: " << what
            << "\nThis is a fault of plcxx, not of your program; please report it.\n";
  return kInternalFault;
}

/// The exit code when everything has been written: standard output is a result like any file.
int Written(int code) {
  std::cout.flush();
  if (std::cout.good()) return code;
  PrintUsageError("cannot write to standard output");
  return std::max<int>(code, kWrongUse);
}

int Main(int argc, char** argv) {
  CLI::App app("plcxx: from the PLC languages of machine tool controls to C++", "plcxx");
  Run run;
  app.set_version_flag("-v,--version", "plcxx " PLCXX_VERSION, "Show the version");
  app.set_help_flag("-h,--help", "Show this help");
  app.require_subcommand(1);
  app.footer(kMainFooter);
  AddEmit(app, run);
  AddBuild(app, run);
  AddCheck(app, run);
  AddPrint(app, run);
  AddTest(app, run);
  AddSim(app, run);
  AddLive(app, run);
  AddWhy(app, run);
  AddSoak(app, run);
  AddMutate(app, run);
  AddExplain(app, run);
  AddReport(app, run);
  AddVerify(app, run);
  AddDiff(app, run);
  AddProve(app, run);
  AddInit(app, run);
  AddCompletion(app, run);
  AddManual(app, run);
  AddLsp(app, run);
  AddMcp(app, run);
  AddIdentify(app, run);
  std::vector<std::string> words(argv + 1, argv + argc);
  std::string unknown = OptionsInFront(app, words);
  if (unknown.empty()) unknown = TakeHelpWord(app, words);
  if (!unknown.empty()) {
    PrintUsageError(unknown);
    std::cerr << "plcxx --help tells how it is used\n";
    return kWrongUse;
  }
  const std::vector<std::string> words_given = words;
  std::ranges::reverse(words);  // as the parser takes them
  try {
    app.parse(std::move(words));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
      app.exit(error);  // --help and --version
      return Written(kDone);
    }
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    PrintUsageError(UsageProblem(error) +
                    (chosen.empty() ? std::string() : DidYouMeanOption(app, *chosen.front(), words_given)));
    std::cerr << "plcxx " << (chosen.empty() ? "" : chosen.front()->get_name() + " ")
              << "--help tells how it is used\n";
    return kWrongUse;
  }
  if (const std::string problem = EmptyValue(app); !problem.empty()) return UsageError(problem);
  return Written(run());
}

int GuardedMain(int argc, char** argv) {
  try {
    return Main(argc, argv);
  } catch (const std::bad_alloc&) {
    std::cerr << "plcxx: out of memory\n";
    return kInternalFault;
  } catch (const std::exception& fault) {
    return InternalFault(fault.what());
  }
}

/// What a long chain of nested statements needs is stack (beside_work.h).
int MainOnDeepStack(int argc, char** argv) {
  int code = kInternalFault;
  support::RunOnDeepStack(support::kDeepStackBytes, [&] { code = GuardedMain(argc, argv); });
  return code;
}

}  // namespace
}  // namespace plcxx::driver

int main(int argc, char** argv) { return plcxx::driver::MainOnDeepStack(argc, argv); }
