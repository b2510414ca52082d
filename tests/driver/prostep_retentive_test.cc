// PRONUM's D memory with every pair of borders of its retentive part near the ends and the middle: bytes, words and
// double words at fixed and at computed addresses, across the borders, too, read and write what one array of bytes
// would hold, and the program can be emitted.
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "tests/driver/run_plcxx.h"
#include "transpiler/compilation/compilation.h"
#include "transpiler/emit/emittable.h"
#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/sim/simulator.h"

namespace plcxx::driver {
namespace {

constexpr uint32_t kBytes = 1000;
constexpr uint32_t kBorders[] = {0, 1, 2, 499, 500, 501, 750, 997, 998, 999};

std::string Lines(std::initializer_list<std::string> lines) {
  std::string text;
  for (const std::string& line : lines) text += ":" + line + "\n";
  return text;
}

/// Inputs: address and value for each of the four accesses at a computed address, IW 100 and IW 102 for the fixed ones.
std::string ProgramText(uint32_t first, uint32_t last, std::set<uint32_t>& words, std::set<uint32_t>& doubles) {
  std::string code = Lines({"JU FM 15", " DB 0", " IW 60", "T FB 0", "JU FM 16", " DB 0", " IW 62", "T FW 2"}) +
                     Lines({"L IB 66", "JU FM 17", " DB 0", " IW 64", "L IW 70", "JU FM 18", " DB 0", " IW 68"});
  for (const uint32_t border : {first, last + 1}) {
    if (border > 0 && border < kBytes) words.insert(border - 1);
    for (uint32_t from = border < 3 ? 0 : border - 3; from < border; ++from) {
      if ((from <= 496 || from >= 500) && from <= 996) doubles.insert(from);
    }
  }
  for (const uint32_t at : words) code += Lines({"L IW 100", "T DW " + std::to_string(at)});
  for (const uint32_t at : doubles) code += Lines({"JU FM 64", " IB 104", " IB 104", " DB " + std::to_string(at)});
  for (const uint32_t at : doubles) {
    code += Lines({"JU FM 64", " DB " + std::to_string(at), " DB " + std::to_string(at), " FB 8"});
  }
  for (const uint32_t at : words) code += Lines({"L DW " + std::to_string(at), "T FW 4"});
  return ":MOD PM 0\n" + Lines({"AN I 20.0", "S F 250.0"}) + ":END PM 0\n:MOD PM 1\n" + code + ":END PM 1\n";
}

class RetentiveMachine {
 public:
  explicit RetentiveMachine(const compilation::Compilation& compilation)
      : compilation_(compilation), simulator_(compilation.program) {
    simulator_.PowerOn();
  }
  void Write(const std::string& name, uint64_t value) { simulator_.Write(PlaceOf(name), value); }
  uint64_t Read(const std::string& name) { return simulator_.Read(PlaceOf(name)); }
  void Run() { simulator_.RunPeriod(now_ += 12); }

 private:
  ir::Place PlaceOf(const std::string& name) const {
    const auto location = compilation_.dialect->locate(ir::NameIndex(compilation_.program), name);
    EXPECT_TRUE(location && location->place.space.valid()) << name;
    return location->place;
  }
  const compilation::Compilation& compilation_;
  sim::Simulator simulator_;
  uint32_t now_ = 0;
};

void Check(uint32_t first, uint32_t last) {
  std::set<uint32_t> words, doubles;
  const Workplace work;
  compilation::CompilationRequest request;
  request.sources = {work.Write("data.plc", ProgramText(first, last, words, doubles))};
  request.dialect = "prostep";
  request.options = {{"retentive", std::to_string(first) + "-" + std::to_string(last)}};
  const compilation::Compilation compilation = compilation::Compile(request);
  ASSERT_TRUE(compilation.ok()) << compilation.diagnostics.all().front().text;
  EXPECT_FALSE(emit::legalize::Legalize(compilation.program, {.name = "data"}).layout.places.empty());

  RetentiveMachine machine(compilation);
  std::array<uint8_t, kBytes> data{};
  std::mt19937 random(first * kBytes + last);
  const auto any_address = [&]() -> int32_t {
    const int32_t near[] = {0, static_cast<int32_t>(first), static_cast<int32_t>(last) + 1, 999};
    return near[random() % 4] + static_cast<int32_t>(random() % 7) - 3;
  };
  for (uint32_t round = 0; round < 12; ++round) {
    const int32_t byte_read = any_address(), word_read = any_address(), byte_at = any_address(),
                  word_at = any_address();
    const uint32_t byte = random() & 0xFF, word = random() & 0xFFFF, fixed = random() & 0xFFFF;
    const uint32_t wide = static_cast<uint32_t>(random());
    const auto as_word = [](int32_t address) { return static_cast<uint64_t>(address) & 0xFFFF; };
    machine.Write("IW60", as_word(byte_read));
    machine.Write("IW62", as_word(word_read));
    machine.Write("IW64", as_word(byte_at));
    machine.Write("IW68", as_word(word_at));
    machine.Write("IB66", byte);
    machine.Write("IW70", word);
    machine.Write("IW100", fixed);
    for (uint32_t i = 0; i < 4; ++i) machine.Write("IB" + std::to_string(104 + i), wide >> 8 * i & 0xFF);
    machine.Run();

    const auto inside = [](int32_t address, int32_t bytes) { return address >= 0 && address + bytes <= 1000; };
    const auto get = [&](int32_t address, int32_t bytes) {
      uint32_t value = 0;
      for (int32_t i = 0; i < bytes && inside(address, bytes); ++i) value |= data[address + i] << 8 * i;
      return value;
    };
    const auto put = [&](int32_t address, int32_t bytes, uint32_t value) {
      for (int32_t i = 0; i < bytes && inside(address, bytes); ++i) {
        data[address + i] = static_cast<uint8_t>(value >> 8 * i);
      }
    };
    const std::string where = std::to_string(first) + "-" + std::to_string(last) + ", " + std::to_string(round);
    ASSERT_EQ(machine.Read("FB0"), get(byte_read, 1)) << where;
    ASSERT_EQ(machine.Read("FW2"), get(word_read, 2)) << where;
    put(byte_at, 1, byte);
    put(word_at, 2, word);
    for (const uint32_t at : words) put(static_cast<int32_t>(at), 2, fixed);
    for (const uint32_t at : doubles) put(static_cast<int32_t>(at), 4, wide);
    if (!doubles.empty()) {
      ASSERT_EQ(machine.Read("FW8") | machine.Read("FW10") << 16, get(static_cast<int32_t>(*doubles.rbegin()), 4))
          << where;
    }
    if (!words.empty()) {
      ASSERT_EQ(machine.Read("FW4"), get(static_cast<int32_t>(*words.rbegin()), 2)) << where;
    }
    for (uint32_t at = 0; at < kBytes; ++at) {
      if (data[at] != machine.Read("DB" + std::to_string(at))) FAIL() << where << ": DB " << at;
    }
  }
}

TEST(ProstepRetentive, EveryPairOfBordersIsOneMemory) {
  for (const uint32_t first : kBorders) {
    for (const uint32_t last : kBorders) {
      if (first <= last && !testing::Test::HasFailure()) Check(first, last);
    }
  }
}

}  // namespace
}  // namespace plcxx::driver
