// plcxx live: the program runs in the simulator, and a browser shows it.
#include "transpiler/driver/live_command.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <variant>

#include "transpiler/driver/accepted_warnings.h"
#include "transpiler/driver/diagnostics_output.h"
#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/linked_program.h"
#include "transpiler/driver/live_link.h"
#include "transpiler/driver/output_files.h"
#include "transpiler/driver/plant_choice.h"
#include "transpiler/driver/project_choice.h"
#include "transpiler/driver/report_page.h"
#include "transpiler/driver/scenario_source.h"
#include "transpiler/driver/simulated_control.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/driver/traced_input.h"
#include "transpiler/link/transport.h"
#include "transpiler/live/http.h"
#include "transpiler/live/linked_machine.h"
#include "transpiler/live/opened.h"
#include "transpiler/live/service.h"
#include "transpiler/scenarios/plan.h"
#include "transpiler/support/check.h"
#include "transpiler/support/hex.h"

extern char** environ;

namespace plcxx::driver {
namespace {

constexpr const char* kLiveFooter = R"(Examples:
  plcxx live                          the program of the plcxx.yaml here
  plcxx live samples/nc110/lathe      that of another folder
  plcxx live turret.sym turret.plc    these sources
  plcxx live found/U4A0.yaml          a scenario, where it fails: the way back shows how it came to that
  plcxx live --vcd machine.vcd        a recorded trace: the program runs with its inputs, from power-on
  plcxx live --link tcp:10.0.0.7:5020 the page of the machine itself, built with plcxx/debug_link.h
  plcxx live --link tcp:10.0.0.7:5020 --watch U4A8,W3K0 --for 10s
                                      the same, on the terminal

The page is served to this machine alone. With --listen others can see and operate the simulation: then a token
is needed, which the printed address has. Scenarios that are recorded are saved in the project's folder, and no
file is overwritten. The control itself answers as the simulated one does unless --set nc-stub=off.
docs/live.md and docs/debug_link.md tell more. Ctrl+C ends it.
Exit codes: 0 ended, 1 the program has errors, 2 wrong use.)";

constexpr const char* kLoopback = "127.0.0.1";
constexpr int kUsualPort = 8420;

struct LiveSettings {
  CommonOptions common;
  std::string waveform;      // --vcd
  std::string plant, panel;  // files; kNoPlant; empty: those of plcxx.yaml
  LinkWords link;
  std::string listen = kLoopback;
  int port = 0;
  bool no_browser = false;
};

std::string NewToken() {
  std::random_device device;
  std::string token;
  for (int i = 0; i < 32; ++i) token += support::HexDigits(device() & 15);
  return token;
}

void OpenBrowser(const std::string& address) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return;
  std::string program = "xdg-open", argument = address;
  char* arguments[] = {program.data(), argument.data(), nullptr};
  pid_t child = 0;
  posix_spawnp(&child, "xdg-open", nullptr, nullptr, arguments, environ);
}

/// The simulated control answers unless somebody said that it does not; a recorded scenario says so, too.
void SwitchStubOn(compilation::CompilationRequest& request) {
  for (const auto& [key, value] : request.options) {
    if (key == kStubOption) return;
  }
  const compilation::Compilation loaded = compilation::Compile(request, compilation::Stage::kLoaded);
  if (loaded.ok() && loaded.dialect != nullptr && HasStub(*loaded.dialect)) {
    request.options.emplace_back(kStubOption, "on");
  }
}

/// Where recorded scenarios are saved.
std::string FolderOf(const CommonOptions& common) {
  if (common.program) return common.program->folder;
  if (IsScenario(common)) return std::filesystem::path(common.sources.front()).parent_path().generic_string();
  return "";
}

/// Done in the session; false: reported.
bool OpenRun(const scenarios::Scenario& scenario, const compilation::Compilation& compilation, live::Session& session) {
  if (!scenario.steps) {
    PrintUsageError(scenario.path + ": no 'steps': nothing runs that could be opened");
    return false;
  }
  const auto plan = scenarios::PlanScenario(scenario, *compilation.dialect, compilation.program);
  if (const auto* errors = std::get_if<std::vector<scenarios::ScenarioError>>(&plan)) {
    for (const scenarios::ScenarioError& error : *errors) std::cerr << ToText(error) << "\n";
    return false;
  }
  const live::Opened opened = live::OpenScenario(session, scenario, std::get<scenarios::ScenarioPlan>(plan));
  if (!opened.refusal.empty()) {
    PrintUsageError(opened.refusal);
    return false;
  }
  std::cout << opened.text << "\n";
  return true;
}

int end_pipe[2] = {-1, -1};

/// Says into the pipe that a signal has come; nothing else may be done there.
void AskForTheEnd(int /*signal*/) {
  const char byte = 0;
  [[maybe_unused]] const ssize_t written = write(end_pipe[1], &byte, 1);
}

/// From now on Ctrl+C and its like are read from `end_pipe`.
bool CatchSignals() {
  if (pipe2(end_pipe, O_CLOEXEC) != 0) return false;
  struct sigaction action = {};
  action.sa_handler = AskForTheEnd;
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
  return true;
}

void WaitForTheEnd() {
  char byte = 0;
  while (read(end_pipe[0], &byte, 1) < 0 && errno == EINTR) {
  }
}

/// What the command line names beside the program: a scenario, or a recorded trace.
bool OpenNamed(const LiveSettings& settings, const compilation::Compilation& compilation, live::Session& session) {
  if (!settings.waveform.empty()) {
    const std::optional<sim::Vcd> trace = ReadWaveform(settings.waveform);
    if (!trace) return false;
    const scenarios::TracedRun run = scenarios::RunOfTrace(compilation, *trace, settings.waveform);
    PrintTraceNotes(TraceNotes(run, scenarios::Departures(compilation, *trace, run)));
    return OpenRun(run.scenario, compilation, session);
  }
  if (!IsScenario(settings.common)) {
    session.BeginAnew();
    return true;
  }
  const std::optional<scenarios::Scenario> scenario = ReadScenario(settings.common.sources.front(), settings.common);
  return scenario && OpenRun(*scenario, compilation, session);
}

/// What keeps the page from an address, and what to do.
std::string CannotListen(const LiveSettings& settings, live::ListenProblem problem) {
  const std::string where = "cannot listen at " + settings.listen +
                            (settings.port == 0 ? "" : ", port " + std::to_string(settings.port)) + ": ";
  switch (problem) {
    case live::ListenProblem::kPortInUse:
      return where + "another program listens there; choose another --port, or end that one";
    case live::ListenProblem::kPortNotPermitted:
      return where + "ports below 1024 are for the administrator; choose another --port";
    case live::ListenProblem::kNoSuchAddress:
      return where + "this machine has no such address; --listen 0.0.0.0 means all that it has";
  }
  PLCXX_UNREACHABLE();
}

/// As a browser has it.
std::string PageAddress(const std::string& host, int port, const std::string& token) {
  const bool is_numeric6 = host.find(':') != std::string::npos;
  return "http://" + (is_numeric6 ? "[" + host + "]" : host) + ":" + std::to_string(port) + "/" +
         (token.empty() ? "" : "#token=" + token);
}

/// Not an address that others could write.
bool IsEveryAddress(const std::string& host) { return host == "0.0.0.0" || host == "::"; }

/// Serves until a signal comes.
int Serve(const LiveSettings& settings, live::Service& service, const std::string& name) {
  if (!CatchSignals()) return UsageError("there are too many open files");
  live::LoadedServer loaded = live::LoadHttpServer(service);
  if (!loaded.server) return UsageError("there is no web server: " + loaded.reason);
  auto bound = loaded.server->Bind(settings.listen, settings.port != 0 ? settings.port : kUsualPort);
  if (settings.port == 0 && std::holds_alternative<live::ListenProblem>(bound)) {
    loaded = live::LoadHttpServer(service);
    bound = loaded.server->Bind(settings.listen, 0);
  }
  if (const auto* problem = std::get_if<live::ListenProblem>(&bound))
    return UsageError(CannotListen(settings, *problem));
  const int port = std::get<int>(bound);
  const bool is_local = settings.listen == kLoopback;
  live::GuardOptions guard{.port = port, .token = is_local ? "" : NewToken()};
  const std::string address = PageAddress(settings.listen, port, guard.token);
  service.Guard(std::move(guard));
  if (!is_local) {
    std::cerr << "plcxx: everybody who knows this address can operate the simulation, and what is sent is not "
                 "encrypted\n";
  }
  if (IsEveryAddress(settings.listen)) {
    std::cerr << "plcxx: others write the name of this machine, or one of its addresses, instead of " << settings.listen
              << "\n";
  }
  std::cout << name << ": " << address << "\nCtrl+C ends it.\n" << std::flush;
  if (!settings.no_browser) OpenBrowser(address);
  std::thread waits([&] {
    WaitForTheEnd();
    service.End();
    loaded.server->Stop();
  });
  loaded.server->Serve();
  waits.join();
  return kDone;
}

/// The page shows the machine at the other end of the link, as long as that is this program.
int ServeMachine(const LiveSettings& settings, const compilation::Compilation& compilation, live::Session& session) {
  const std::string& address = settings.link.address;
  live::Service service(session, {});
  live::LinkedMachine machine(
      session, address, [&] { return debug_link::OpenTransport(address); },
      [&](const debug_link::Bytes& identity) { return MatchProgram(compilation, identity); });
  if (const std::string reason = machine.Connect(); !reason.empty()) {
    std::cerr << "plcxx: " << address << ": " << reason << "\n";
    return kProgramHasErrors;
  }
  service.Attach(machine);
  machine.Begin([&](const std::function<void()>& change) { service.Apply(change); });
  return Serve(settings, service, compilation.name);
}

int RunLive(const LiveSettings& settings) {
  std::optional<compilation::CompilationRequest> request = MakeRequest(settings.common);
  if (!request) return kWrongUse;
  const bool is_simulated = settings.link.address.empty();
  if (is_simulated && !IsScenario(settings.common) && settings.waveform.empty()) SwitchStubOn(*request);
  ProgressLine progress;
  request->progress = [&progress](std::string_view phase) { progress.Show(phase); };
  std::optional<compilation::Compilation> compiled = CompileProgram(settings.common, *request);
  if (!compiled) return kWrongUse;
  progress.Clear();
  compilation::Compilation& compilation = *compiled;
  PrintDiagnosticsBeside(compilation, MessagesOf(settings.common));
  if (!compilation.ok()) return ExitCodeOf(compilation);
  if (!compilation.has_program) return UsageError("the sources are data only: there is nothing to run");
  request->progress = nullptr;
  if (IsForTerminal(settings.link)) return RunLink(settings.link, compilation);

  const report::ProgramInput input = PageInput(compilation);
  live::Session session(compilation, input);
  if (!is_simulated) return ServeMachine(settings, compilation, session);
  // A trace has the machine's inputs as they were.
  const std::string& named = settings.plant.empty() && !settings.waveform.empty() ? kNoPlant : settings.plant;
  const auto plant = ChoosePlant(named, settings.common, compilation);
  if (!plant) return kWrongUse;
  const auto panel = ChoosePanel(settings.panel, settings.common, compilation, plant->get());
  if (!panel) return kWrongUse;
  session.Equip(*plant, *panel);
  if (!OpenNamed(settings, compilation, session)) return kWrongUse;
  live::Service service(session, {&compilation, &*request, FolderOf(settings.common)});
  return Serve(settings, service, compilation.name);
}

int RunLiveForOne(LiveSettings settings) {
  NameProject(settings.common);
  if (!settings.waveform.empty() && IsScenario(settings.common)) {
    return UsageError("a scenario and a trace are named: leave one of them out");
  }
  if (const std::string wrong = WrongAbout(settings.link); !wrong.empty()) return UsageError(wrong);
  if (!settings.link.address.empty() && (!settings.waveform.empty() || IsScenario(settings.common))) {
    return UsageError("a machine runs what it runs: leave the scenario or the trace out, or --link");
  }
  if (!settings.link.address.empty() && (!settings.plant.empty() || !settings.panel.empty())) {
    return UsageError("the machine itself is around the program: leave --plant and --panel out, or --link");
  }
  if (settings.common.all || settings.common.program_names.size() > 1) {
    return UsageError("live shows one program: name it with --program");
  }
  return RunForPrograms(settings, RunLive);
}

}  // namespace

void AddLive(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("live", "Run the program in the simulator, with a page that shows it");
  const auto settings = std::make_shared<LiveSettings>();
  AddCommonOptions(*command, settings->common);
  command->add_option("--vcd", settings->waveform, "A recorded trace: the program runs with its inputs first")
      ->type_name("FILE");
  command
      ->add_option("--plant", settings->plant,
                   "What the machine does around the program; else that of plcxx.yaml or the scenario, 'none': nothing")
      ->type_name("FILE");
  command->add_option("--panel", settings->panel, "The operator's panel; else that of plcxx.yaml, 'none': no panel")
      ->type_name("FILE");
  command->add_option("--port", settings->port, "Of the page; 8420, or any that is free")
      ->type_name("N")
      ->check(CLI::Range(1, 65535))
      ->group("Page");
  command->add_option("--listen", settings->listen, "An address of this machine, for others to reach it")
      ->type_name("ADDRESS")
      ->default_str(kLoopback)
      ->group("Page");
  command->add_flag("--no-browser", settings->no_browser, "Print the address, and open nothing")->group("Page");
  const auto repeated = [&](const char* name, std::vector<std::string>& values, const char* placeholder,
                            const char* meaning) {
    command->add_option(name, values, meaning)
        ->type_name(placeholder)
        ->allow_extra_args(false)
        ->delimiter(',')
        ->group("Machine");
  };
  command
      ->add_option("--link", settings->link.address,
                   "A running machine: tcp:HOST:PORT, serial:DEVICE:BAUD, socket:PATH; its program must be this one")
      ->type_name("ADDRESS")
      ->group("Machine");
  repeated("--read", settings->link.read, "LOC,...", "What to read once");
  repeated("--watch", settings->link.watch, "LOC,...",
           "What to show after each scan that changes it, up to 16 locations");
  repeated("--write", settings->link.write, "LOC=VALUE,...", "What to write once");
  repeated("--force", settings->link.force, "LOC=VALUE,...", "What to hold until the command ends");
  command->add_option("--for", settings->link.duration, "So long; else until Ctrl+C")
      ->type_name("TIME")
      ->group("Machine");
  command->add_option("--save", settings->link.waveform, "Write what was watched as a waveform (VCD)")
      ->type_name("FILE")
      ->group("Machine");
  command->footer(kLiveFooter);
  command->callback([settings, &run] { run = [settings] { return RunLiveForOne(*settings); }; });
}

}  // namespace plcxx::driver
