#include "transpiler/driver/end_request.h"

#include <signal.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <ctime>

namespace plcxx::driver {
namespace {

constexpr std::array kRequests = {SIGINT, SIGTERM, SIGHUP};
std::array<struct sigaction, kRequests.size()> actions_before;
std::atomic<bool> are_ignored = false;
std::atomic<int64_t> requested_s = 0;  // 0: not yet
constexpr int64_t kOneRequestSeconds = 3;

int64_t NowSeconds() {
  timespec now = {};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec + 1;
}

/// System calls and atomic values only: it is a signal handler.
void TakeRequest(int signal) {
  int64_t none = 0;
  const int64_t now = NowSeconds();
  if (requested_s.compare_exchange_strong(none, now) || are_ignored || now - requested_s < kOneRequestSeconds) return;
  for (size_t i = 0; i < kRequests.size(); ++i) {
    if (kRequests[i] != signal) continue;
    sigaction(signal, &actions_before[i], nullptr);
    raise(signal);  // as soon as this handler returns
  }
}

}  // namespace

EndRequest::EndRequest() {
  are_ignored = false;
  struct sigaction action = {};
  action.sa_handler = TakeRequest;
  action.sa_flags = SA_RESTART;
  for (size_t i = 0; i < kRequests.size(); ++i) {
    sigaction(kRequests[i], nullptr, &actions_before[i]);
    // What the caller wants to be ignored stays so: nohup does.
    if (actions_before[i].sa_handler != SIG_IGN) sigaction(kRequests[i], &action, nullptr);
  }
}

EndRequest::~EndRequest() {
  for (size_t i = 0; i < kRequests.size(); ++i) sigaction(kRequests[i], &actions_before[i], nullptr);
}

bool EndRequest::IsMade() { return requested_s != 0; }

void EndRequest::IgnoreFurther() { are_ignored = true; }

}  // namespace plcxx::driver
