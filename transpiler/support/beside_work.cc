#include "transpiler/support/beside_work.h"

#include <optional>
#include <utility>

#include "transpiler/support/fault_guard.h"

namespace plcxx::support {

BesideWork::BesideWork(size_t stack_bytes, std::function<void()> work)
    : work_(std::move(work)), is_guarded_(FaultGuard::IsActive()) {
  for (const size_t bytes : {stack_bytes, stack_bytes / 4, stack_bytes / 16}) {
    if (!Start(bytes)) continue;
    progress_ = Progress::kRuns;
    return;
  }
}

BesideWork::~BesideWork() {
  if (progress_ == Progress::kRuns) pthread_join(thread_, nullptr);
}

bool BesideWork::Start(size_t stack_bytes) {
  pthread_attr_t attributes;
  if (pthread_attr_init(&attributes) != 0) return false;
  const auto body = [](void* self) -> void* {
    static_cast<BesideWork*>(self)->Do();
    return nullptr;
  };
  const bool started = pthread_attr_setstacksize(&attributes, stack_bytes) == 0 &&
                       pthread_create(&thread_, &attributes, body, this) == 0;
  pthread_attr_destroy(&attributes);
  return started;
}

void BesideWork::Do() {
  try {
    std::optional<FaultGuard> guard;
    if (is_guarded_) guard.emplace();
    work_();
  } catch (...) {
    thrown_ = std::current_exception();
  }
}

void BesideWork::Wait() {
  switch (std::exchange(progress_, Progress::kDone)) {
    case Progress::kNotStarted:
      Do();
      break;
    case Progress::kRuns:
      pthread_join(thread_, nullptr);
      break;
    case Progress::kDone:
      return;
  }
  if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
}

void RunOnDeepStack(size_t stack_bytes, std::function<void()> work) { BesideWork(stack_bytes, std::move(work)).Wait(); }

}  // namespace plcxx::support
