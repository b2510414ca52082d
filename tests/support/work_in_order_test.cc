#include "transpiler/support/work_in_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace plcxx::support {
namespace {

using ::testing::ElementsAre;

const auto kTellsNothing = [](PieceId) {};

/// Of a row of pieces in which each needs the two before it, what each has made of what they made.
std::vector<int> Fibonacci(uint32_t pieces, size_t workers) {
  WorkInOrder order;
  for (uint32_t i = 0; i < pieces; ++i)
    order.Add(i < 2 ? std::vector<PieceId>() : std::vector<PieceId>{PieceId(i - 1), PieceId(i - 2)});
  std::vector<int> made(pieces);
  order.Run(
      workers,
      [&](PieceId piece, size_t) {
        made[piece.index] = piece.index < 2 ? 1 : made[piece.index - 1] + made[piece.index - 2];
      },
      kTellsNothing);
  return made;
}

TEST(WorkInOrder, APieceIsDoneAfterThoseThatItNeeds) {
  for (const size_t workers : {1, 2, 5}) EXPECT_THAT(Fibonacci(8, workers), ElementsAre(1, 1, 2, 3, 5, 8, 13, 21));
}

TEST(WorkInOrder, NothingIsToBeDone) {
  WorkInOrder().Run(3, [](PieceId, size_t) { FAIL(); }, [](PieceId) { FAIL(); });
}

TEST(WorkInOrder, OneThatNeedsAnotherTwiceIsDoneOnce) {
  WorkInOrder order;
  const PieceId first = order.Add({});
  order.Add({first, first});
  std::atomic<int> done = 0;
  order.Run(2, [&](PieceId, size_t) { ++done; }, kTellsNothing);
  EXPECT_EQ(done, 2);
}

/// The first waits for the last: with as many workers as there are pieces all are worked at together.
TEST(WorkInOrder, PiecesThatNeedNoOtherAreDoneSideBySide) {
  WorkInOrder order;
  for (int i = 0; i < 3; ++i) order.Add({});
  std::mutex guard;
  std::condition_variable met;
  int here = 0;
  std::vector<size_t> workers(3);
  order.Run(
      3,
      [&](PieceId piece, size_t worker) {
        workers[piece.index] = worker;
        std::unique_lock<std::mutex> lock(guard);
        ++here;
        met.notify_all();
        met.wait(lock, [&] { return here == 3; });
      },
      kTellsNothing);
  EXPECT_THAT(workers, ::testing::UnorderedElementsAre(0, 1, 2));
}

TEST(WorkInOrder, IsToldInTheOrderWhoeverIsFirst) {
  WorkInOrder order;
  for (int i = 0; i < 3; ++i) order.Add({});
  std::mutex guard;
  std::condition_variable changed;
  bool others_are_done = false;
  int done = 0;
  std::vector<uint32_t> told;
  order.Run(
      2,
      [&](PieceId piece, size_t) {
        std::unique_lock<std::mutex> lock(guard);
        if (piece.index == 0) {
          changed.wait(lock, [&] { return others_are_done; });
        } else if (++done == 2) {
          others_are_done = true;
          EXPECT_TRUE(told.empty());
          changed.notify_all();
        }
      },
      [&](PieceId piece) { told.push_back(piece.index); });
  EXPECT_THAT(told, ElementsAre(0, 1, 2));
}

/// What stands before it is told, and what throws behind it does not matter, however fast it is.
TEST(WorkInOrder, ThrowsWhatTheFirstInTheOrderThrows) {
  for (const size_t workers : {1, 2, 4}) {
    WorkInOrder order;
    for (int i = 0; i < 4; ++i) order.Add({});
    std::vector<uint32_t> told;
    try {
      order.Run(
          workers,
          [&](PieceId piece, size_t) {
            if (piece.index == 1) std::this_thread::sleep_for(std::chrono::milliseconds(5));
            if (piece.index == 1 || piece.index == 3) throw std::runtime_error(std::to_string(piece.index));
          },
          [&](PieceId piece) { told.push_back(piece.index); });
      ADD_FAILURE() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "1");
    }
    EXPECT_THAT(told, ElementsAre(0));
  }
}

TEST(WorkInOrder, ThrowsWhatTellingThrows) {
  WorkInOrder order;
  for (int i = 0; i < 4; ++i) order.Add({});
  const auto tell = [](PieceId piece) {
    if (piece.index == 2) throw std::runtime_error("no more room");
  };
  EXPECT_THROW(order.Run(2, [](PieceId, size_t) {}, tell), std::runtime_error);
}

TEST(WorkInOrderDeathTest, OnlyPiecesThatAreThereAreNeeded) {
  WorkInOrder order;
  const PieceId first = order.Add({});
  EXPECT_DEATH(order.Add({PieceId(first.index + 1)}), "internal fault");
  EXPECT_DEATH(order.Add({PieceId()}), "internal fault");
}

}  // namespace
}  // namespace plcxx::support
