#include "transpiler/support/beside_work.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <stdexcept>

#include "transpiler/support/check.h"
#include "transpiler/support/fault_guard.h"

namespace plcxx::support {
namespace {

constexpr size_t kStackBytes = size_t{64} << 20;
/// More than any address space: of no size that is tried a thread is to be had.
constexpr size_t kTooMuch = size_t{1} << 60;

size_t StackOfThisThread() {
  pthread_attr_t attributes;
  size_t bytes = 0;
  pthread_getattr_np(pthread_self(), &attributes);
  pthread_attr_getstacksize(&attributes, &bytes);
  pthread_attr_destroy(&attributes);
  return bytes;
}

TEST(BesideWork, HasAStackOfItsOwn) {
  size_t stack = 0;
  pthread_t worker = pthread_self();
  RunOnDeepStack(kStackBytes, [&] {
    stack = StackOfThisThread();
    worker = pthread_self();
  });
  EXPECT_EQ(stack, kStackBytes);
  EXPECT_FALSE(pthread_equal(worker, pthread_self()));
}

TEST(BesideWork, IsDoneByTheOneWhoWaitsWhereNoThreadIsToBeHad) {
  bool is_done = false;
  pthread_t worker{};
  BesideWork work(kTooMuch, [&] {
    is_done = true;
    worker = pthread_self();
  });
  EXPECT_FALSE(is_done);
  work.Wait();
  EXPECT_TRUE(is_done);
  EXPECT_TRUE(pthread_equal(worker, pthread_self()));
}

TEST(BesideWork, IsDoneOnce) {
  for (const size_t stack : {kStackBytes, kTooMuch}) {
    int times = 0;
    {
      BesideWork work(stack, [&] { ++times; });
      work.Wait();
      work.Wait();
    }
    EXPECT_EQ(times, 1);
  }
}

TEST(BesideWork, ThrowsWhereItIsWaitedFor) {
  for (const size_t stack : {kStackBytes, kTooMuch}) {
    BesideWork work(stack, [] { throw std::runtime_error("no more memory"); });
    EXPECT_THROW(work.Wait(), std::runtime_error);
    work.Wait();  // once
  }
}

TEST(BesideWork, AFaultIsThrownWhereTheOneWhoAsksIsGuarded) {
  const FaultGuard guard;
  BesideWork work(kStackBytes, [] { PLCXX_CHECK(1 + 1 == 3); });
  EXPECT_THROW(work.Wait(), FaultError);
  EXPECT_TRUE(FaultGuard::IsActive());
}

TEST(BesideWorkDeathTest, AFaultEndsTheProcessWhereNobodyIsGuarded) {
  EXPECT_DEATH(RunOnDeepStack(kStackBytes, [] { PLCXX_CHECK(1 + 1 == 3); }), "internal fault");
}

}  // namespace
}  // namespace plcxx::support
