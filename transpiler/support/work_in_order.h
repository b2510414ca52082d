// Pieces of work of which some need what others have made, done side by side by several threads.
//
// A piece names those that it needs when it is added, and only pieces that are there can be named: none waits for one
// that waits for it. In: pieces. Out: each is done once, after those that it needs; what is told of them, and what is
// thrown, is the same however many work. Not its job: what the pieces are.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "transpiler/support/ids.h"

namespace plcxx::support {

using PieceId = Id<struct PieceTag>;

class WorkInOrder {
 public:
  /// `needs`: that have been added before; one may be named more than once.
  PieceId Add(std::vector<PieceId> needs);
  uint32_t size() const { return needs_.size(); }

  /// `work(piece, worker)` for each piece, by `workers` threads, worker 0 being the one that asks; the others have deep
  /// stacks. What a piece writes, those that need it may read. `is_done(piece)`, one at a time, in the order of Add:
  /// this one and all before it are done.
  /// What the first piece in the order throws, is thrown here when those before it are done and told.
  void Run(size_t workers, const std::function<void(PieceId piece, size_t worker)>& work,
           const std::function<void(PieceId piece)>& is_done) const;

 private:
  Store<PieceId, std::vector<PieceId>> needs_;
};

}  // namespace plcxx::support
