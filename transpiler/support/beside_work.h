// Work on a thread of its own with a stack of its own size: what follows the nesting of a program by recursion needs a
// deep one, and what only reads the same tree as its neighbour need not wait for it.
#pragma once

#include <pthread.h>

#include <cstddef>
#include <exception>
#include <functional>

namespace plcxx::support {

/// Of the command line, and of what runs beside it and follows the same nesting. A chain of DOE members is a nest of
/// else arms, and the phases walk regions by recursion.
inline constexpr size_t kDeepStackBytes = size_t{256} << 20;

class BesideWork {
 public:
  /// `stack_bytes`: address space, of which only what is used becomes memory. Where that much is not to be had, a
  /// quarter or a sixteenth has to do; where no thread is to be had at all, Wait does the work.
  BesideWork(size_t stack_bytes, std::function<void()> work);
  /// Waits; what the work threw is lost then.
  ~BesideWork();
  BesideWork(const BesideWork&) = delete;
  BesideWork& operator=(const BesideWork&) = delete;

  /// Until the work is done. What it threw, as where memory is over, is thrown here, once: out of a thread nothing
  /// leads but the end of the process.
  void Wait();

 private:
  bool Start(size_t stack_bytes);
  void Do();

  std::function<void()> work_;
  bool is_guarded_;  // as the thread that asks for it: a failed check is thrown
  pthread_t thread_{};
  enum class Progress { kNotStarted, kRuns, kDone } progress_ = Progress::kNotStarted;
  std::exception_ptr thrown_;
};

/// `work`, to its end, on a stack of `stack_bytes` as above. Throws what it throws.
void RunOnDeepStack(size_t stack_bytes, std::function<void()> work);

}  // namespace plcxx::support
