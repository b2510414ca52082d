#include "transpiler/live/linked_machine.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "transpiler/live/linked_cells.h"
#include "transpiler/live/locations.h"
#include "transpiler/live/wishes.h"

namespace plcxx::live {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kBetweenTries{1000};  // to connect again
constexpr milliseconds kBetweenCounts{200};
constexpr milliseconds kBetweenRounds{100};  // of reading State: a page is not looked at more often
constexpr milliseconds kBetweenShows{50};    // within a round that takes longer
constexpr milliseconds kIdle{5};             // when nothing new was there

std::string NamesOf(const std::vector<Forced>& forced) {
  std::string names;
  for (const Forced& one : forced) names += (names.empty() ? "" : ", ") + one.name;
  return names;
}

}  // namespace

LinkedMachine::LinkedMachine(Session& session, std::string address, Open open, debug_link::MatchIdentity match)
    : session_(session), names_(session.program()), open_(std::move(open)), match_(std::move(match)) {
  status_.address = std::move(address);
  session_.link().Show(status_);
}

LinkedMachine::~LinkedMachine() { End(); }

void LinkedMachine::ApplyNow(const std::function<void()>& change) {
  if (apply_) return apply_(change);
  change();
}

/// False: it has ended.
bool LinkedMachine::WaitUntil(Clock::time_point when) {
  std::unique_lock lock(mutex_);
  changed_.wait_until(lock, when, [this] { return is_ended_ || !orders_.empty(); });
  return !is_ended_;
}

std::string LinkedMachine::OpenConnection(Connection& made) {
  debug_link::OpenedTransport opened = open_();
  if (!opened.transport) return opened.reason;
  made.transport = std::move(opened.transport);
  made.client = std::make_unique<debug_link::Client>(*made.transport);
  const debug_link::Result<debug_link::Bytes> identity = made.client->ReadIdentity();
  if (const auto* failure = std::get_if<debug_link::Failure>(&identity)) return failure->text;
  made.program = match_(std::get<debug_link::Bytes>(identity));
  if (!made.program.difference.empty()) return "the machine runs another program: " + made.program.difference;
  made.target = std::make_unique<debug_link::Target>(*made.client, made.program.layout);
  return made.target->Begin(made.program.length);
}

std::string LinkedMachine::Connect() {
  auto made = std::make_unique<Connection>();
  if (std::string reason = OpenConnection(*made); !reason.empty()) {
    status_.is_connected = false;
    status_.reason = reason;
    ApplyNow([&] { session_.link().Show(status_); });
    return reason;
  }
  ApplyNow([&] {
    made->mirror = std::make_unique<Mirror>(session_.program(), made->program.layout, session_.timeline().machine());
  });
  connection_ = std::move(made);
  status_.can_write = connection_->target->limits().can_write != 0;
  if (std::string reason = WatchAll(*connection_); !reason.empty()) return Lose(reason), reason;
  if (std::string reason = ReadCounts(); !reason.empty()) return Lose(reason), reason;
  const std::lock_guard lock(mutex_);
  reason_.clear();
  return {};
}

void LinkedMachine::Begin(Apply apply) {
  apply_ = std::move(apply);
  thread_ = std::thread([this] { Follow(); });
}

void LinkedMachine::End() {
  {
    const std::lock_guard lock(mutex_);
    is_ended_ = true;
    changed_.notify_all();
  }
  if (thread_.joinable()) thread_.join();
}

void LinkedMachine::Follow() {
  bool goes_on = true;
  while (goes_on) {
    if (!connection_) {
      goes_on = WaitUntil(Clock::now() + kBetweenTries);
      if (goes_on && Connect().empty()) TakeBack();
      continue;
    }
    RunOrders();
    if (std::string reason = Turn(); !reason.empty()) Lose(reason);
    const std::lock_guard lock(mutex_);
    goes_on = !is_ended_;
  }
  if (connection_) ReleaseForced("");
  Lose("plcxx live has ended");
}

/// The connection is there again, with a machine that may have been started anew meanwhile.
void LinkedMachine::TakeBack() {
  ApplyNow([&] { session_.link().AddNote("connected again"); });
  ReleaseForced("released after the connection was lost: ");
}

void LinkedMachine::ReleaseForced(const std::string& note) {
  std::vector<Forced> forced;
  ApplyNow([&] { forced = session_.forced(); });
  if (forced.empty()) return;
  for (const Forced& one : forced) {
    const Found found = Find(*connection_, one.name);
    if (const auto* place = std::get_if<WatchedCells>(&found)) connection_->target->Release(place->cells);
  }
  ApplyNow([&] {
    session_.SetForced({});
    if (!note.empty()) session_.link().AddNote(note + NamesOf(forced));
  });
}

void LinkedMachine::Lose(const std::string& reason) {
  connection_.reset();
  std::deque<WaitingOrder> waiting;
  {
    const std::lock_guard lock(mutex_);
    reason_ = "there is no connection to the machine: " + reason;
    waiting.swap(orders_);
  }
  for (WaitingOrder& order : waiting) order.done.set_value("there is no connection to the machine: " + reason);
  const bool was_connected = std::exchange(status_.is_connected, false);
  status_.reason = reason;
  ApplyNow([&] {
    session_.link().Show(status_);
    if (was_connected) session_.link().AddNote("the connection was lost: " + reason);
  });
}

void LinkedMachine::RunOrders() {
  for (;;) {
    WaitingOrder next;
    {
      const std::lock_guard lock(mutex_);
      if (orders_.empty()) return;
      next = std::move(orders_.front());
      orders_.pop_front();
    }
    next.done.set_value(next.order(*connection_));
  }
}

Refusal LinkedMachine::Do(Order order) {
  std::future<Refusal> done;
  {
    const std::lock_guard lock(mutex_);
    if (is_ended_) return "plcxx live has ended";
    if (!reason_.empty()) return reason_;
    WaitingOrder waiting{.order = std::move(order), .done = {}};
    done = waiting.done.get_future();
    orders_.push_back(std::move(waiting));
    changed_.notify_all();
  }
  return done.get();
}

std::string LinkedMachine::Turn() {
  Connection& connection = *connection_;
  const Clock::time_point now = Clock::now();
  if (now - connection.counted >= kBetweenCounts) {
    if (std::string reason = ReadCounts(); !reason.empty()) return reason;
  }
  bool is_news = false;
  if (!connection.watched.empty()) {
    if (std::string reason = TakeSamples(is_news); !reason.empty()) return reason;
  }
  if (connection.next_byte != 0 || now - connection.round_began >= kBetweenRounds) return ReadBlock();
  if (!is_news) WaitUntil(now + kIdle);
  return {};
}

std::string LinkedMachine::ReadCounts() {
  Connection& connection = *connection_;
  connection.counted = Clock::now();
  const debug_link::Result<LinkCounts> read = connection.target->Counts();
  if (const auto* failure = std::get_if<debug_link::Failure>(&read)) return failure->text;
  const LinkCounts& counts = std::get<LinkCounts>(read);
  status_.is_connected = true;
  status_.reason.clear();
  status_.may_write = counts.may_write != 0;
  status_.forced_bytes = counts.forced;
  status_.scans = counts.scans;
  ApplyNow([&] {
    session_.link().Show(status_);
    if (counts.forced != 0 || session_.forced().empty()) return;
    const std::string names = NamesOf(session_.forced());
    session_.SetForced({});
    session_.link().AddNote("the machine has let go what was forced: " + names);
  });
  return {};
}

std::string LinkedMachine::TakeSamples(bool& is_news) {
  Connection& connection = *connection_;
  debug_link::Result<std::vector<debug_link::TraceSample>> read = connection.target->TakeSamples();
  if (const auto* failure = std::get_if<debug_link::Failure>(&read)) return failure->text;
  const auto& samples = std::get<std::vector<debug_link::TraceSample>>(read);
  is_news = !samples.empty();
  if (!is_news) return {};
  for (const auto& [offset, byte] : samples.back().bytes) connection.mirror->Take(offset, {&byte, 1});
  ApplyNow([&] {
    for (const debug_link::TraceSample& sample : samples) {
      if (connection.has_sample) status_.lost += sample.scan - connection.last_scan - 1;
      connection.has_sample = true;
      connection.last_scan = sample.scan;
      std::vector<uint64_t> values;
      for (const WatchedCells& one : connection.watched) {
        values.push_back(scenarios::FittingField(one.location, debug_link::ValueOf(one.cells, sample.bytes)));
      }
      session_.link().TakeSample(sample.scan, values);
    }
    connection.mirror->Show();
  });
  return {};
}

std::string LinkedMachine::ReadBlock() {
  Connection& connection = *connection_;
  const uint32_t size = connection.program.layout.size;
  const Clock::time_point began = Clock::now();
  if (connection.next_byte == 0) connection.round_began = began;
  const uint32_t count = std::min<uint32_t>(kLinkPayload, size - connection.next_byte);
  const debug_link::Result<debug_link::Bytes> read = connection.client->ReadState(connection.next_byte, count);
  if (const auto* failure = std::get_if<debug_link::Failure>(&read)) return failure->text;
  connection.mirror->Take(connection.next_byte, std::get<debug_link::Bytes>(read));
  connection.next_byte += count;
  const Clock::time_point now = Clock::now();
  if (connection.next_byte < size) {
    if (now - connection.shown < kBetweenShows) return {};
    connection.shown = now;
    ApplyNow([&] { connection.mirror->Show(); });
    return {};
  }
  connection.next_byte = 0;
  connection.shown = now;
  status_.round_ms =
      static_cast<uint64_t>(std::chrono::duration_cast<milliseconds>(now - connection.round_began).count());
  ApplyNow([&] {
    session_.link().TakeFaults(connection.mirror->ComputeAgain());
    session_.link().Show(status_);
  });
  return {};
}

LinkedMachine::Found LinkedMachine::Find(const Connection& connection, const std::string& name) const {
  const compilation::Compilation& compilation = session_.compilation();
  auto found = FindLocation(*compilation.dialect, names_, name);
  if (auto* refusal = std::get_if<std::string>(&found)) return std::move(*refusal);
  WatchedCells place{.location = std::get<dialects::Location>(std::move(found)), .cells = {}};
  const std::string where = "'" + name + "' is not in the machine's State: ";
  if (const std::string why = CannotBeForced(compilation, place.location); !why.empty()) return where + why;
  place.cells = CellsOf(compilation.program, connection.program.layout, place.location);
  if (place.cells.empty()) return where + "the program does not use it";
  return place;
}

std::string LinkedMachine::WatchAll(Connection& connection) {
  std::vector<WatchedCells> watched;
  std::vector<std::vector<debug_link::Cell>> cells;
  std::string reason;
  ApplyNow([&] {
    for (const sim::Watched& one : session_.chart().watched()) {
      Found found = Find(connection, one.name);
      if (auto* refusal = std::get_if<Refusal>(&found)) {
        reason = std::move(*refusal);
        return;
      }
      watched.push_back(std::get<WatchedCells>(std::move(found)));
      cells.push_back(watched.back().cells);
    }
  });
  if (reason.empty()) reason = connection.target->Watch(cells);
  if (!reason.empty()) return reason;
  connection.watched = std::move(watched);
  connection.has_sample = false;
  status_.lost = 0;
  return {};
}

Refusal LinkedMachine::ChangeValue(Connection& connection, Change change, const std::string& name,
                                   const std::string& value) {
  const Found found = Find(connection, name);
  if (const auto* refusal = std::get_if<Refusal>(&found)) return *refusal;
  const auto& place = std::get<WatchedCells>(found);
  const auto bits = FindValue(session_.compilation(), name, place.location, value);
  if (const auto* refusal = std::get_if<std::string>(&bits)) return *refusal;
  const uint64_t number = std::get<uint64_t>(bits);
  if (change == Change::kWrite) return connection.target->Write(place.cells, number);
  if (Refusal refusal = connection.target->Force(place.cells, number); !refusal.empty()) return refusal;
  ApplyNow([&] {
    std::vector<Forced> forced = session_.forced();
    std::erase_if(forced, [&](const Forced& one) { return one.name == name; });
    forced.push_back({.name = name, .location = place.location, .value = number});
    session_.SetForced(std::move(forced));
  });
  return {};
}

Refusal LinkedMachine::Write(const std::string& name, const std::string& value) {
  return Do([&](Connection& connection) { return ChangeValue(connection, Change::kWrite, name, value); });
}

Refusal LinkedMachine::Force(const std::string& name, const std::string& value) {
  return Do([&](Connection& connection) { return ChangeValue(connection, Change::kForce, name, value); });
}

Refusal LinkedMachine::Toggle(const std::string& name) {
  bool is_on = false, is_forced = false, is_input = false;
  Refusal refusal;
  ApplyNow([&] {
    const auto found = session_.Find(name);
    if (const auto* reason = std::get_if<std::string>(&found)) {
      refusal = *reason;
      return;
    }
    const auto& location = std::get<dialects::Location>(found);
    if (location.text_input || location.place.type != ir::Type::kBit) {
      refusal = "only a bit has two values";
      return;
    }
    is_on = session_.timeline().machine().Read(location) != 0;
    is_forced = std::ranges::any_of(session_.forced(), [&](const Forced& one) { return one.name == name; });
    is_input = std::ranges::any_of(session_.signals().signals, [&](const LiveSignal& signal) {
      return signal.group == SignalGroup::kInput && (signal.name == name || signal.address == name);
    });
  });
  if (!refusal.empty()) return refusal;
  const std::string value = is_on ? "0" : "1";
  if (is_forced) return Force(name, value);
  if (is_input) return "the machine reads '" + name + "' anew in each scan: force it";
  return Write(name, value);
}

Refusal LinkedMachine::Release(const std::string& name) {
  return Do([&](Connection& connection) -> Refusal {
    std::vector<Forced> forced;
    ApplyNow([&] { forced = session_.forced(); });
    if (std::erase_if(forced, [&](const Forced& one) { return one.name == name; }) == 0) {
      return "'" + name + "' is not forced";
    }
    const Found found = Find(connection, name);
    if (const auto* refusal = std::get_if<Refusal>(&found)) return *refusal;
    const auto& place = std::get<WatchedCells>(found);
    if (Refusal refusal = connection.target->Release(place.cells); !refusal.empty()) return refusal;
    ApplyNow([&] { session_.SetForced(std::move(forced)); });
    return Refusal();
  });
}

Refusal LinkedMachine::ReleaseAll() {
  return Do([&](Connection& connection) {
    if (Refusal refusal = connection.client->ReleaseAll(); !refusal.empty()) return refusal;
    ApplyNow([&] { session_.SetForced({}); });
    return Refusal();
  });
}

Refusal LinkedMachine::Watch(const std::string& name) {
  return Do([&](Connection& connection) -> Refusal {
    const Found found = Find(connection, name);
    if (const auto* refusal = std::get_if<Refusal>(&found)) return *refusal;
    Refusal refusal;
    ApplyNow([&] { refusal = live::Watch(session_, name); });
    if (!refusal.empty()) return refusal;
    refusal = WatchAll(connection);
    if (refusal.empty()) return refusal;
    ApplyNow([&] { live::Unwatch(session_, session_.chart().watched().size() - 1); });
    WatchAll(connection);
    return refusal;
  });
}

Refusal LinkedMachine::Unwatch(size_t number) {
  return Do([&](Connection& connection) {
    Refusal refusal;
    ApplyNow([&] { refusal = live::Unwatch(session_, number); });
    return refusal.empty() ? WatchAll(connection) : refusal;
  });
}

Refusal LinkedMachine::Arm(const TriggerWish& wish) {
  if (wish.edge == "condition") {
    return "conditions are looked at in the simulation: over a link the trigger is an edge of what is watched";
  }
  Refusal refusal;
  ApplyNow([&] {
    const bool is_watched = std::ranges::any_of(session_.chart().watched(),
                                                [&](const sim::Watched& watched) { return watched.name == wish.text; });
    refusal = is_watched ? live::Arm(session_, wish)
                         : "over a link the trigger is an edge of what is watched: watch '" + wish.text + "' first";
  });
  return refusal;
}

Refusal LinkedMachine::Disarm() {
  ApplyNow([&] { session_.chart().Disarm(); });
  return {};
}

}  // namespace plcxx::live
