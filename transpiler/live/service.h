// The session behind a web server: pages that look, commands, and a thread that lets time pass.
//
// In: requests. Out: the page's files, the program, the state as a stream of events, answers to commands. One lock is
// around the session; the thread that runs it gives it up between batches of a few milliseconds. Not its job: sockets.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "transpiler/live/commands.h"
#include "transpiler/live/guard.h"
#include "transpiler/live/http.h"
#include "transpiler/live/linked_machine.h"
#include "transpiler/live/program_view.h"
#include "transpiler/live/session.h"

namespace plcxx::live {

class Service : public HttpHandler {
 public:
  /// The session and what the place names outlive it.
  Service(Session& session, RecordingPlace place);
  ~Service() override;

  /// Before the first request.
  void Guard(GuardOptions options) { guard_ = std::move(options); }
  /// Before the first request: a running machine is shown, which takes the commands. It ends before the service.
  void Attach(LinkedMachine& machine) { linked_ = &machine; }
  /// Changes the session, and shows it.
  void Apply(const std::function<void()>& change);
  HttpResponse Answer(const HttpRequest& request) override;
  /// Streams end, time stands still.
  void End();

 private:
  HttpResponse Command(const std::string& body);
  CommandResult Run(const nlohmann::ordered_json& command);
  HttpResponse Rows(const HttpRequest& request);
  HttpResponse Events();
  void LetTimePass();

  Session& session_;
  RecordingPlace place_;
  GuardOptions guard_;
  LinkedMachine* linked_ = nullptr;
  std::mutex mutex_;  // of the session and of all below
  std::condition_variable changed_;
  ProgramView program_;
  uint64_t version_ = 0;   // of the state
  uint64_t commands_ = 0;  // so many have been done
  bool is_ended_ = false;
  std::atomic<int> streams_ = 0;
  std::thread clock_;
};

}  // namespace plcxx::live
