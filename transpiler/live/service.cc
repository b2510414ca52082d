#include "transpiler/live/service.h"

#include <charconv>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "transpiler/live/linked_commands.h"
#include "transpiler/live/pace.h"
#include "transpiler/live/page_files.h"
#include "transpiler/live/state_view.h"

namespace plcxx::live {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr milliseconds kBatch{8};           // of simulation between two looks at the lock
constexpr milliseconds kBetweenEvents{33};  // while it runs; after a command at once
constexpr milliseconds kHeartbeat{2000};    // so that a page that is gone is noticed
constexpr int kMostStreams = 8;
constexpr size_t kMostRows = 128;  // of one request
constexpr const char* kJson = "application/json; charset=utf-8";

std::string Dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

HttpResponse Failure(int status, const std::string& text) {
  return {.status = status, .type = kJson, .body = Dumped({{"error", text}}), .stream = {}};
}

uint64_t MicrosecondsNow() {
  return static_cast<uint64_t>(
      std::chrono::duration_cast<std::chrono::microseconds>(Clock::now().time_since_epoch()).count());
}

constexpr const char* TypeOf(std::string_view name) {
  if (name.ends_with(".html")) return "text/html; charset=utf-8";
  if (name.ends_with(".css")) return "text/css; charset=utf-8";
  return name.ends_with(".svg") ? "image/svg+xml" : "text/javascript; charset=utf-8";
}

size_t NumberIn(const HttpRequest& request, std::string_view key) {
  size_t number = 0;
  for (const auto& [name, value] : request.query) {
    if (name == key) std::from_chars(value.data(), value.data() + value.size(), number);
  }
  return number;
}

}  // namespace

Service::Service(Session& session, RecordingPlace place)
    : session_(session), place_(std::move(place)), program_(session), clock_([this] { LetTimePass(); }) {}

Service::~Service() {
  End();
  clock_.join();
}

void Service::End() {
  const std::lock_guard lock(mutex_);
  is_ended_ = true;
  changed_.notify_all();
}

void Service::LetTimePass() {
  std::unique_lock lock(mutex_);
  Pace pace;
  double speed = -1;
  while (!is_ended_) {
    if (!session_.is_running()) {
      changed_.wait(lock);
      speed = -1;
      continue;
    }
    if (speed != session_.speed()) {
      speed = session_.speed();
      pace.Begin(MicrosecondsNow(), session_.unit_ms(), speed);
    }
    const Clock::time_point end = Clock::now() + kBatch;
    const uint64_t due = pace.Due(MicrosecondsNow());
    uint64_t done = 0;
    while (done < due && session_.is_running() && Clock::now() < end) done += session_.RunPeriods(1);
    if (done != 0) {
      ++version_;
      changed_.notify_all();
    }
    // Never without a break: who waits for the lock gets it.
    const auto wait = std::chrono::microseconds(std::max<uint64_t>(300, pace.UsUntilNext(MicrosecondsNow())));
    lock.unlock();
    std::this_thread::sleep_for(std::min(wait, std::chrono::microseconds(20'000)));
    lock.lock();
  }
}

HttpResponse Service::Answer(const HttpRequest& request) {
  if (const std::string refused = RefusedFor(request, guard_); !refused.empty()) return Failure(403, refused);
  if (request.path == "/api/command") {
    return request.method == "POST" ? Command(request.body) : Failure(405, "commands are sent by POST");
  }
  if (request.method != "GET") return Failure(405, "there is nothing to be sent to");
  if (request.path == "/api/program") {
    const std::lock_guard lock(mutex_);
    return {.status = 200, .type = kJson, .body = Dumped(program_.Outline()), .stream = {}};
  }
  if (request.path == "/api/rows") return Rows(request);
  if (request.path == "/api/events") return Events();
  const std::string name = request.path == "/" ? "index.html" : request.path.substr(1);
  for (unsigned i = 0; i < kLivePageFilesCount; ++i) {
    const EmbeddedFile& file = kLivePageFiles[i];
    if (name == file.name) {
      return {.status = 200, .type = TypeOf(name), .body = std::string(file.text, file.size), .stream = {}};
    }
  }
  return Failure(404, "there is no such page");
}

HttpResponse Service::Rows(const HttpRequest& request) {
  const size_t begin = std::min(NumberIn(request, "from"), program_.rows());
  const size_t end = std::min(NumberIn(request, "to"), begin + kMostRows);
  const std::lock_guard lock(mutex_);
  return {.status = 200, .type = kJson, .body = Dumped(program_.Rows(begin, end)), .stream = {}};
}

HttpResponse Service::Command(const std::string& body) {
  const Json command = Json::parse(body, nullptr, false);
  if (command.is_discarded()) return Failure(400, "this is no JSON");
  const CommandResult result = Run(command);
  if (!result.refusal.empty()) {
    Json refused = {{"error", result.refusal}};
    return {.status = 400, .type = kJson, .body = Dumped(refused), .stream = {}};
  }
  return {.status = 200, .type = kJson, .body = Dumped(result.answer), .stream = {}};
}

CommandResult Service::Run(const Json& command) {
  CommandResult result;
  if (linked_ != nullptr) result = RunLinkedCommand(*linked_, command);
  const std::lock_guard lock(mutex_);
  if (linked_ == nullptr) result = RunCommand(session_, place_, command);
  ++version_;
  ++commands_;
  changed_.notify_all();
  return result;
}

void Service::Apply(const std::function<void()>& change) {
  const std::lock_guard lock(mutex_);
  change();
  ++version_;
  changed_.notify_all();
}

HttpResponse Service::Events() {
  struct Stream {
    Stream(Session& session, const ProgramView& program, std::atomic<int>& the_count)
        : view(session, program), count(the_count) {}
    ~Stream() { --count; }
    StateView view;
    std::atomic<int>& count;
    uint64_t version = 0, commands = 0;
    Clock::time_point sent;
    bool is_first = true;
  };
  if (++streams_ > kMostStreams) {
    --streams_;
    return Failure(503, "there are too many pages already");
  }
  const auto stream = std::make_shared<Stream>(session_, program_, streams_);
  return {.status = 200, .type = "text/event-stream", .body = {}, .stream = [this, stream](std::string& piece) {
            std::unique_lock lock(mutex_);
            if (!stream->is_first) {
              const auto is_news = [&] { return is_ended_ || stream->version != version_; };
              if (!changed_.wait_for(lock, kHeartbeat, is_news)) {
                piece = ": still here\n\n";
                return true;
              }
              // What runs is shown some thirty times a second; what was commanded, at once.
              changed_.wait_until(lock, stream->sent + kBetweenEvents,
                                  [&] { return is_ended_ || stream->commands != commands_; });
            }
            if (is_ended_) return false;
            stream->is_first = false;
            stream->version = version_;
            stream->commands = commands_;
            const Json changes = stream->view.Changes();
            stream->sent = Clock::now();
            lock.unlock();
            piece = "data: " + Dumped(changes) + "\n\n";
            return true;
          }};
}

}  // namespace plcxx::live
