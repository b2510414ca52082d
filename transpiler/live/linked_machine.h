// A running machine that the session shows: what its link says goes into the session, what the operator wants goes to
// the machine.
//
// In: a wire that can be opened again, and orders. One thread has the wire: it reads all of State in blocks, one after
// the other, what is watched by the samples of each scan, and does the orders between two requests. A wire that breaks
// is opened again each second, and its machine must be this program again. Out: a session that looks as if it ran the
// program, but for what only a simulation can do (linked_commands.h). Not its job: bytes on the wire (link/).
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "transpiler/link/linked_program.h"
#include "transpiler/live/mirror.h"
#include "transpiler/live/session.h"

namespace plcxx::live {

class LinkedMachine {
 public:
  using Open = std::function<debug_link::OpenedTransport()>;
  /// Changes the session while no other thread looks at it, and shows what has changed.
  using Apply = std::function<void(const std::function<void()>& change)>;

  /// The session outlives it. `address` is for the reader.
  LinkedMachine(Session& session, std::string address, Open open, debug_link::MatchIdentity match);
  ~LinkedMachine();

  /// The first time, while nobody else has the session. Why there is no connection; empty: there is one.
  std::string Connect();
  /// From now on it is followed, until End.
  void Begin(Apply apply);
  /// What this one has forced is released.
  void End();

  // Orders of the operator, from any thread that does not hold the session; they wait for the machine.
  Refusal Write(const std::string& name, const std::string& value);
  Refusal Toggle(const std::string& name);
  Refusal Force(const std::string& name, const std::string& value);
  Refusal Release(const std::string& name);
  Refusal ReleaseAll();
  Refusal Watch(const std::string& name);
  Refusal Unwatch(size_t number);
  Refusal Arm(const TriggerWish& wish);
  Refusal Disarm();

 private:
  using Clock = std::chrono::steady_clock;
  struct WatchedCells {
    dialects::Location location;
    std::vector<debug_link::Cell> cells;
  };
  struct Connection {
    std::unique_ptr<debug_link::Transport> transport;
    std::unique_ptr<debug_link::Client> client;
    debug_link::LinkedProgram program;
    std::unique_ptr<debug_link::Target> target;
    std::unique_ptr<Mirror> mirror;
    std::vector<WatchedCells> watched;  // as the machine samples them
    uint32_t next_byte = 0;             // of State, that is to be read
    Clock::time_point round_began, shown, counted;
    uint32_t last_scan = 0;
    bool has_sample = false;
  };
  using Order = std::function<Refusal(Connection&)>;
  struct WaitingOrder {
    Order order;
    std::promise<Refusal> done;
  };

  Refusal Do(Order order);
  std::string OpenConnection(Connection& made);
  void Follow();
  /// The next question to the machine, and what follows from its answer. Why the connection is lost; empty: it is not.
  std::string Turn();
  std::string ReadCounts();
  std::string TakeSamples(bool& is_news);
  std::string ReadBlock();
  void RunOrders();
  void Lose(const std::string& reason);
  void TakeBack();
  /// Lets go what is forced by names, and tells why.
  void ReleaseForced(const std::string& note);
  /// Sets up what the session watches; why the machine cannot.
  std::string WatchAll(Connection& connection);
  using Found = std::variant<WatchedCells, Refusal>;
  Found Find(const Connection& connection, const std::string& name) const;
  enum class Change : uint8_t { kWrite, kForce };
  Refusal ChangeValue(Connection& connection, Change change, const std::string& name, const std::string& value);
  void ApplyNow(const std::function<void()>& change);
  bool WaitUntil(Clock::time_point when);

  Session& session_;
  const ir::NameIndex names_;  // of the thread, for the session's is its own
  Open open_;
  debug_link::MatchIdentity match_;
  Apply apply_;                             // none: nobody else has the session
  LinkStatus status_;                       // of the thread
  std::unique_ptr<Connection> connection_;  // of the thread
  std::mutex mutex_;                        // of what is below
  std::condition_variable changed_;
  std::deque<WaitingOrder> orders_;
  std::string reason_;  // why no order is taken; empty: they are
  bool is_ended_ = false;
  std::thread thread_;
};

}  // namespace plcxx::live
