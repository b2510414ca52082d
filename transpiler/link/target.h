// A running machine whose program is known: its values by location, forces, and samples of each scan.
//
// In: a wire whose other end has said that it is this program, and the layout of its State. Out: values. Not its job:
// whether it is this program (the caller asks the client for the identity first), and how values are written.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transpiler/link/cells.h"
#include "transpiler/link/client.h"

namespace plcxx::debug_link {

/// The watched bytes after one scan.
struct TraceSample {
  uint32_t scan = 0;
  KnownBytes bytes;
};

class Target {
 public:
  /// Both outlive it.
  Target(Client& client, const emit::layout::Layout& layout) : client_(client), layout_(layout) {}

  /// Empty: it answers, and its State is as long as the layout says. `longer`: the debug flavour's has more after it.
  enum class Length : uint8_t { kExact, kLonger };
  std::string Begin(Length length);
  const LinkLimits& limits() const { return limits_; }

  Result<uint64_t> Read(const std::vector<Cell>& cells);
  std::string Write(const std::vector<Cell>& cells, uint64_t value);
  std::string Force(const std::vector<Cell>& cells, uint64_t value);
  std::string Release(const std::vector<Cell>& cells);
  Result<LinkCounts> Counts() { return client_.ReadCounts(); }

  /// From now on all these are sampled together, after each scan.
  std::string Watch(const std::vector<std::vector<Cell>>& watched);
  /// What has come since the last time; empty: nothing yet.
  Result<std::vector<TraceSample>> TakeSamples();

 private:
  enum class Order : uint8_t { kWrite, kForce };
  std::string Change(Order order, const std::vector<Cell>& cells, uint64_t value);

  Client& client_;
  const emit::layout::Layout& layout_;
  LinkLimits limits_{};
  std::vector<Run> runs_;  // what a sample has, in its order
  Bytes pending_;          // of a sample that is not complete
  uint32_t position_ = 0;
};

}  // namespace plcxx::debug_link
