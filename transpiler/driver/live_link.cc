#include "transpiler/driver/live_link.h"

#include <signal.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <iostream>
#include <optional>
#include <thread>
#include <utility>
#include <variant>

#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/linked_program.h"
#include "transpiler/driver/output_files.h"
#include "transpiler/driver/program_output.h"
#include "transpiler/driver/sim_plan.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/link/target.h"
#include "transpiler/live/linked_cells.h"
#include "transpiler/live/locations.h"
#include "transpiler/scenarios/control.h"
#include "transpiler/sim/clock.h"
#include "transpiler/sim/trace.h"
#include "transpiler/sim/value_text.h"

namespace plcxx::driver {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr size_t kMostWatched = 16;
constexpr milliseconds kBetween{5};  // two questions, when nothing new was there

volatile sig_atomic_t must_end = 0;
void NoteTheEnd(int /*signal*/) { must_end = 1; }

/// A location as it was named, and where it is in State.
struct Linked {
  std::string name;
  dialects::Location location;
  std::vector<debug_link::Cell> cells;
  uint64_t value = 0;  // of one that is written or forced
};

class LinkSession {
 public:
  LinkSession(const LinkWords& words, const compilation::Compilation& compilation)
      : words_(words), compilation_(compilation), names_(compilation.program) {}

  int Run();

 private:
  bool Connect();
  bool FindAll();
  bool FindPlaces(const std::vector<std::string>& names, std::vector<Linked>& found);
  bool FindValues(const std::vector<std::string>& assignments, std::vector<Linked>& found);
  bool Locate(std::string_view name, Linked& linked);
  int Exchange();
  int Follow();
  bool Take(std::vector<debug_link::TraceSample> samples);
  void PrintRow(uint64_t time_ms, const std::vector<uint64_t>& values);
  int Save();
  bool IsOver() const { return must_end != 0 || (end_ && Clock::now() >= *end_); }
  uint64_t ValueOf(const Linked& linked, const debug_link::KnownBytes& bytes) const {
    return scenarios::FittingField(linked.location, debug_link::ValueOf(linked.cells, bytes));
  }

  int Refused(const std::string& text) const {
    std::cerr << "plcxx: " << words_.address << ": " << text << "\n";
    return kProgramHasErrors;
  }

  const LinkWords& words_;
  const compilation::Compilation& compilation_;
  const ir::NameIndex names_;
  std::unique_ptr<debug_link::Transport> transport_;
  std::optional<debug_link::Client> client_;
  debug_link::LinkedProgram program_;
  std::optional<debug_link::Target> target_;
  std::vector<Linked> read_, watched_, written_, forced_;
  std::optional<milliseconds> lasts_;
  std::optional<Clock::time_point> end_;  // from when all is set up
  // Of what is watched.
  std::optional<sim::Trace> trace_;
  std::optional<uint32_t> first_scan_;
  uint32_t last_scan_ = 0;
  uint64_t samples_ = 0, lost_ = 0;
  std::vector<uint64_t> shown_;
};

bool LinkSession::Locate(std::string_view name, Linked& linked) {
  auto found = live::FindLocation(*compilation_.dialect, names_, name);
  if (const auto* reason = std::get_if<std::string>(&found)) return UsageError(*reason), false;
  linked.name = name;
  linked.location = std::get<dialects::Location>(std::move(found));
  if (const std::string reason = live::CannotBeForced(compilation_, linked.location); !reason.empty()) {
    return UsageError("'" + linked.name + "' is not in the machine's State: " + reason), false;
  }
  return true;
}

bool LinkSession::FindPlaces(const std::vector<std::string>& names, std::vector<Linked>& found) {
  for (const std::string& name : names) {
    if (!Locate(name, found.emplace_back())) return false;
  }
  return true;
}

bool LinkSession::FindValues(const std::vector<std::string>& assignments, std::vector<Linked>& found) {
  for (const std::string& assignment : assignments) {
    const size_t equals = assignment.find('=');
    if (equals == std::string::npos)
      return UsageError("'" + assignment + "' has no value: write LOCATION=VALUE"), false;
    Linked& linked = found.emplace_back();
    if (!Locate(std::string_view(assignment).substr(0, equals), linked)) return false;
    const auto value =
        live::FindValue(compilation_, linked.name, linked.location, std::string_view(assignment).substr(equals + 1));
    if (const auto* reason = std::get_if<std::string>(&value)) return UsageError(*reason), false;
    linked.value = std::get<uint64_t>(value);
    if (std::ranges::count(found, linked.name, &Linked::name) > 1) {
      return UsageError("'" + linked.name + "' is given two values"), false;
    }
  }
  return true;
}

bool LinkSession::FindAll() {
  if (!FindPlaces(words_.read, read_) || !FindPlaces(words_.watch, watched_) || !FindValues(words_.write, written_) ||
      !FindValues(words_.force, forced_)) {
    return false;
  }
  if (watched_.size() > kMostWatched) return UsageError("16 locations can be watched at a time"), false;
  return true;
}

/// To a machine that runs this program; false: reported.
bool LinkSession::Connect() {
  debug_link::OpenedTransport opened = debug_link::OpenTransport(words_.address);
  if (!opened.transport) return Refused(opened.reason), false;
  transport_ = std::move(opened.transport);
  client_.emplace(*transport_);
  const debug_link::Result<debug_link::Bytes> identity = client_->ReadIdentity();
  if (const auto* failure = std::get_if<debug_link::Failure>(&identity)) return Refused(failure->text), false;
  program_ = MatchProgram(compilation_, std::get<debug_link::Bytes>(identity));
  if (!program_.difference.empty()) {
    return Refused("the machine runs another program: " + program_.difference), false;
  }
  target_.emplace(*client_, program_.layout);
  if (const std::string reason = target_->Begin(program_.length); !reason.empty()) return Refused(reason), false;
  for (std::vector<Linked>* list : {&read_, &watched_, &written_, &forced_}) {
    for (Linked& linked : *list) {
      linked.cells = live::CellsOf(compilation_.program, program_.layout, linked.location);
      if (linked.cells.empty()) {
        return Refused("'" + linked.name + "' is not in the machine's State: the program does not use it"), false;
      }
    }
  }
  return true;
}

void LinkSession::PrintRow(uint64_t time_ms, const std::vector<uint64_t>& values) {
  std::cout << time_ms << " ms";
  for (size_t i = 0; i < values.size(); ++i) {
    const dialects::Location& location = watched_[i].location;
    std::cout << "  " << watched_[i].name << " "
              << sim::ValueDigits(location.place.type, values[i], scenarios::SignOf(location));
  }
  std::cout << "\n" << std::flush;
}

bool LinkSession::Take(std::vector<debug_link::TraceSample> samples) {
  for (const debug_link::TraceSample& sample : samples) {
    if (!first_scan_) {
      first_scan_ = sample.scan;
    } else {
      lost_ += sample.scan - last_scan_ - 1;
    }
    last_scan_ = sample.scan;
    ++samples_;
    const uint64_t time_ms = uint64_t{sample.scan - *first_scan_} * sim::UnitMs(compilation_.program.schedule);
    std::vector<uint64_t> values;
    for (const Linked& linked : watched_) values.push_back(ValueOf(linked, sample.bytes));
    if (values != shown_) PrintRow(time_ms, values);
    shown_ = std::move(values);
    if (words_.waveform.empty()) continue;
    size_t next = 0;
    trace_->Record(time_ms, [&](const sim::Watched&) { return shown_[next++]; });
  }
  return !samples.empty();
}

/// Shows what is watched, and holds what is forced, until the time is over.
int LinkSession::Follow() {
  Clock::time_point looked = Clock::now();
  if (lasts_) end_ = looked + *lasts_;
  while (!IsOver()) {
    bool is_news = false;
    if (!watched_.empty()) {
      debug_link::Result<std::vector<debug_link::TraceSample>> samples = target_->TakeSamples();
      if (const auto* failure = std::get_if<debug_link::Failure>(&samples)) return Refused(failure->text);
      is_news = Take(std::get<std::vector<debug_link::TraceSample>>(std::move(samples)));
    }
    if (!forced_.empty() && Clock::now() - looked > milliseconds(200)) {
      looked = Clock::now();
      const debug_link::Result<LinkCounts> counts = target_->Counts();
      if (const auto* failure = std::get_if<debug_link::Failure>(&counts)) return Refused(failure->text);
      if (std::get<LinkCounts>(counts).forced == 0) return Refused("the machine has let go what was forced");
    }
    if (!is_news) std::this_thread::sleep_for(kBetween);
  }
  return kDone;
}

int LinkSession::Save() {
  if (words_.waveform.empty() || !trace_) return kDone;
  const OutputRequest output{{},
                             {{words_.waveform, sim::WriteVcd(*trace_, compilation_.name)}},
                             PathsRead(compilation_, {}),
                             {words_.waveform}};
  if (const auto failure = WriteWithFolders(output)) return CannotWrite(*failure);
  return kDone;
}

int LinkSession::Exchange() {
  for (const Linked& linked : written_) {
    if (const std::string reason = target_->Write(linked.cells, linked.value); !reason.empty()) {
      return Refused(linked.name + ": " + reason);
    }
  }
  for (const Linked& linked : forced_) {
    if (const std::string reason = target_->Force(linked.cells, linked.value); !reason.empty()) {
      return Refused(linked.name + ": " + reason);
    }
  }
  for (const Linked& linked : read_) {
    const debug_link::Result<uint64_t> value = target_->Read(linked.cells);
    if (const auto* failure = std::get_if<debug_link::Failure>(&value))
      return Refused(linked.name + ": " + failure->text);
    const uint64_t fitting = scenarios::FittingField(linked.location, std::get<uint64_t>(value));
    std::cout << linked.name << " = "
              << sim::ValueDigits(linked.location.place.type, fitting, scenarios::SignOf(linked.location)) << "\n";
  }
  std::cout << std::flush;
  if (watched_.empty() && forced_.empty()) return kDone;
  if (!watched_.empty()) {
    std::vector<std::vector<debug_link::Cell>> cells;
    std::vector<sim::Watched> columns;
    for (const Linked& linked : watched_) {
      cells.push_back(linked.cells);
      columns.push_back(scenarios::WatchLocation(compilation_.program, linked.name, linked.location));
    }
    trace_.emplace(std::move(columns));
    if (const std::string reason = target_->Watch(cells); !reason.empty()) return Refused(reason);
  }
  return Follow();
}

int LinkSession::Run() {
  if (!FindAll() || !CanBeWritten({words_.waveform})) return kWrongUse;
  if (!words_.duration.empty()) {
    const std::optional<uint64_t> ms = ParseDuration(words_.duration);
    if (!ms) return UsageError("'" + words_.duration + "' is no time; write for example 30s");
    lasts_ = milliseconds(*ms);
  }
  if (!Connect()) return kProgramHasErrors;
  struct sigaction action = {};
  action.sa_handler = NoteTheEnd;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
  const int code = Exchange();
  // Nothing stays forced by a command that has ended.
  for (const Linked& linked : forced_) {
    if (const std::string reason = target_->Release(linked.cells); !reason.empty() && code == kDone) {
      return Refused(linked.name + " is not released: " + reason);
    }
  }
  if (!watched_.empty()) std::cerr << samples_ << " samples, " << lost_ << " lost\n";
  const int saved = Save();
  return code != kDone ? code : saved;
}

}  // namespace

std::string WrongAbout(const LinkWords& words) {
  const bool says_what = !words.read.empty() || !words.watch.empty() || !words.write.empty() || !words.force.empty() ||
                         !words.duration.empty() || !words.waveform.empty();
  if (words.address.empty()) {
    return says_what ? "--read, --watch, --write, --force, --for and --save are about a machine: name it with --link"
                     : "";
  }
  if (const std::string wrong = debug_link::WrongAddress(words.address); !wrong.empty()) return "--link: " + wrong;
  if (!words.duration.empty() && words.watch.empty() && words.force.empty()) {
    return "--for is how long --watch and --force last: the page of --link alone is there until Ctrl+C";
  }
  if (!words.waveform.empty() && words.watch.empty()) return "--save needs locations to --watch";
  return "";
}

bool IsForTerminal(const LinkWords& words) {
  return !words.read.empty() || !words.watch.empty() || !words.write.empty() || !words.force.empty();
}

int RunLink(const LinkWords& words, const compilation::Compilation& compilation) {
  return LinkSession(words, compilation).Run();
}

}  // namespace plcxx::driver
