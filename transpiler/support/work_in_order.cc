#include "transpiler/support/work_in_order.h"

#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include "transpiler/support/beside_work.h"
#include "transpiler/support/check.h"

namespace plcxx::support {
namespace {

/// One run: what is left to do.
class OneRun {
 public:
  OneRun(const Store<PieceId, std::vector<PieceId>>& needs, const std::function<void(PieceId, size_t)>& work,
         const std::function<void(PieceId)>& is_done)
      : work_(work), is_done_(is_done), pieces_(needs.size()), end_(needs.size()) {
    for (uint32_t i = 0; i < needs.size(); ++i) {
      for (const PieceId need : needs[PieceId(i)]) pieces_[need.index].needed_by.push_back(i);
      pieces_[i].open_needs = needs[PieceId(i)].size();
      if (pieces_[i].open_needs == 0) ready_.insert(i);
    }
  }

  /// Until there is nothing left that this worker could do.
  void Work(size_t worker) {
    std::unique_lock<std::mutex> lock(guard_);
    while (const std::optional<uint32_t> at = Take(lock)) {
      lock.unlock();
      std::exception_ptr thrown;
      try {
        work_(PieceId(*at), worker);
      } catch (...) {
        thrown = std::current_exception();
      }
      lock.lock();
      Finish(*at, std::move(thrown));
      changed_.notify_all();
    }
  }

  void Rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  struct Piece {
    std::vector<uint32_t> needed_by;
    size_t open_needs = 0;
    bool is_done = false;
  };

  /// The first in the order; waits while what others are at may make one ready.
  std::optional<uint32_t> Take(std::unique_lock<std::mutex>& lock) {
    const auto is_ready = [this] { return !ready_.empty() && *ready_.begin() < end_; };
    changed_.wait(lock, [&] { return is_ready() || at_work_ == 0; });
    if (!is_ready()) return std::nullopt;
    ++at_work_;
    return ready_.extract(ready_.begin()).value();
  }

  void Finish(uint32_t at, std::exception_ptr thrown) {
    --at_work_;
    if (thrown != nullptr) return End(at, std::move(thrown));
    pieces_[at].is_done = true;
    for (const uint32_t other : pieces_[at].needed_by) {
      if (--pieces_[other].open_needs == 0) ready_.insert(other);
    }
    for (; told_ < end_ && pieces_[told_].is_done; ++told_) {
      try {
        is_done_(PieceId(told_));
      } catch (...) {
        return End(told_, std::current_exception());
      }
    }
  }

  /// Nothing is begun from here on; what stands before may throw, too, and then it counts.
  void End(uint32_t at, std::exception_ptr thrown) {
    if (at >= end_) return;
    end_ = at;
    thrown_ = std::move(thrown);
  }

  const std::function<void(PieceId, size_t)>& work_;
  const std::function<void(PieceId)>& is_done_;
  std::mutex guard_;  // of all below; not held while a piece is worked at
  std::condition_variable changed_;
  std::vector<Piece> pieces_;
  std::set<uint32_t> ready_;
  size_t at_work_ = 0;
  uint32_t told_ = 0, end_;
  std::exception_ptr thrown_;
};

}  // namespace

PieceId WorkInOrder::Add(std::vector<PieceId> needs) {
  for (const PieceId need : needs) PLCXX_CHECK(need.index < needs_.size());
  return needs_.Add(std::move(needs));
}

void WorkInOrder::Run(size_t workers, const std::function<void(PieceId piece, size_t worker)>& work,
                      const std::function<void(PieceId piece)>& is_done) const {
  OneRun run(needs_, work, is_done);
  std::vector<std::unique_ptr<BesideWork>> others;
  for (size_t worker = 1; worker < workers; ++worker)
    others.push_back(std::make_unique<BesideWork>(kDeepStackBytes, [&run, worker] { run.Work(worker); }));
  run.Work(0);
  for (const std::unique_ptr<BesideWork>& other : others) other->Wait();
  run.Rethrow();
}

}  // namespace plcxx::support
