#include "transpiler/dialects/nc110/control/stub.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <map>

#include "transpiler/dialects/nc110/control/locate.h"
#include "transpiler/dialects/nc110/machine/machine.h"
#include "transpiler/dialects/nc110/nc110.h"

namespace plcxx::nc110 {
namespace {

/// Memory of the packages, named as scenarios name it.
class Image final : public dialects::ImagePort {
 public:
  uint8_t Get(ir::SpaceId space, uint32_t offset) const override { return bytes_[space.index][offset]; }
  void Set(ir::SpaceId space, uint32_t offset, uint8_t value) override {
    bytes_[space.index][offset] = value;
    ++writes;
  }
  void StoreRetentive() override {}
  void LookAtMessages() override {}

  uint8_t operator[](std::string_view name) const {
    const ir::Place place = Locate(ir::NameIndex(ir::Program{}), name)->place;
    const uint8_t byte = bytes_[place.space.index][place.offset];
    return place.bit == ir::kNoBit ? byte : byte >> place.bit & 1;
  }
  void Write(std::string_view name, uint8_t value) {
    const ir::Place place = Locate(ir::NameIndex(ir::Program{}), name)->place;
    uint8_t& byte = bytes_[place.space.index][place.offset];
    if (place.bit == ir::kNoBit) {
      byte = value;
    } else {
      byte = static_cast<uint8_t>((byte & ~(1u << place.bit)) | (value & 1u) << place.bit);
    }
  }
  uint32_t writes = 0;

 private:
  std::array<std::array<uint8_t, 1024>, 4> bytes_{};
};

class Nc110Stub : public testing::Test {
 protected:
  Nc110Stub() { stub_->PowerOn(image_); }
  /// `count` periods of 10 ms; `slices` of them make a slow cycle.
  void Run(uint32_t count = 1, uint32_t slices = 1) {
    for (uint32_t i = 0; i < count; ++i) {
      stub_->BeforePeriod(now_, image_);
      now_ += 10;
      if (++periods_ % slices == 0) ++slow_cycles_;
      stub_->AfterPeriod(now_, slow_cycles_, image_);
    }
  }
  Image image_;
  std::unique_ptr<dialects::ControlStub> stub_ = MakeStub({}, {{"nc-stub", "on"}, {"stub-ms", "30"}});
  uint32_t now_ = 0, slow_cycles_ = 0, periods_ = 0;
};

// covers: NC110-239
TEST_F(Nc110Stub, PowerOnAndMachineOn) {
  EXPECT_EQ(image_["I6K21"], 1);
  EXPECT_EQ(image_["I0K4"], 1);
  EXPECT_EQ(image_["W8K3"], 1);
  image_.Write("U10K0", 1);
  Run(4);
  EXPECT_EQ(image_["I0K2"], 0);
  EXPECT_EQ(image_["I0K1"], 0);
  image_.Write("W10K1", 3);
  image_.Write("U10K0", 0);
  Run();
  EXPECT_EQ(image_["I0K2"], 1);
  EXPECT_EQ(image_["I0K1"], 1);
  EXPECT_EQ(image_["W0K1"], 3);
  Run();
  EXPECT_EQ(image_["I0K1"], 1);
  Run();
  EXPECT_EQ(image_["I0K1"], 0);
  image_.Write("U10K0", 1);
  Run();
  EXPECT_EQ(image_["I0K2"], 0);
  EXPECT_EQ(image_["W0K1"], 0);
  EXPECT_EQ(image_["I0K1"], 1);
}

TEST_F(Nc110Stub, PulsesLastTwoCompleteSlowCycles) {
  Run(1, 3);
  image_.Write("U10K1", 1);
  Run(2, 3);  // the cycle is under way: the pulse waits for the next one
  EXPECT_EQ(image_["I0K1"], 0);
  image_.Write("U10K1", 0);
  Run(6, 3);
  EXPECT_EQ(image_["I0K1"], 1);
  Run(1, 3);
  EXPECT_EQ(image_["I0K1"], 0);
}

// covers: NC110-239
TEST_F(Nc110Stub, StrobesOfFunctions) {
  image_.Write("W3K0", 0x33);
  Run(3);
  EXPECT_EQ(image_["I4K18"], 0);  // CEFA is missing
  image_.Write("U10K25", 1);
  Run();
  EXPECT_EQ(image_["I4K18"], 1);
  Run();
  EXPECT_EQ(image_["W3K0"], 0x33);
  EXPECT_EQ(image_["I4K18"], 1);
  Run();
  EXPECT_EQ(image_["I4K18"], 0);
  EXPECT_EQ(image_["W3K0"], 0);

  image_.Write("W4K0", 0x05);
  image_.Write("W8K1", 0x10);
  Run();
  EXPECT_EQ(image_["I4K17"], 1);
  EXPECT_EQ(image_["I4K16"], 1);
  EXPECT_EQ(image_["W2K2"], 0x05);
  EXPECT_EQ(image_["W6N1"], 1);
  Run(2);
  EXPECT_EQ(image_["I4K17"], 0);
  EXPECT_EQ(image_["I4K16"], 0);
  EXPECT_EQ(image_["W4K0"], 0x05);

  image_.Write("U10K1", 1);  // a reset clears the codes
  Run();
  EXPECT_EQ(image_["W4K0"], 0);
  EXPECT_EQ(image_["W8K1"], 0);
}

// covers: NC110-239
TEST_F(Nc110Stub, FilmasAndStart) {
  image_.Write("W12K1", 7);
  Run();
  EXPECT_EQ(image_["I0K4"], 0);
  Run(2);
  EXPECT_EQ(image_["I0K24"], 0);
  Run();
  EXPECT_EQ(image_["I0K24"], 1);
  EXPECT_EQ(image_["I0K4"], 1);
  image_.Write("W12K1", 0);
  Run();
  EXPECT_EQ(image_["I0K24"], 0);

  image_.Write("U10K4", 1);
  Run();
  EXPECT_EQ(image_["I0K3"], 1);
  Run(3);
  EXPECT_EQ(image_["I4K30"], 1);
  EXPECT_EQ(image_["I0K3"], 0);
  image_.Write("U10K4", 0);
  Run();
  EXPECT_EQ(image_["I4K30"], 0);
  image_.Write("I0K0", 1);
  image_.Write("U10K4", 1);
  Run();
  EXPECT_EQ(image_["I4K31"], 1);
}

// covers: NC110-239
TEST_F(Nc110Stub, RequestsAndAnswers) {
  image_.Write("U10K21", 1);  // tool update while CEFAB is 0
  image_.Write("U10N4", 1);
  image_.Write("U10N5", 1);
  image_.Write("W17K1", 4);
  Run();
  EXPECT_EQ(image_["I0K27"], 1);
  EXPECT_EQ(image_["I0N1"], 1);
  EXPECT_EQ(image_["U10N5"], 0);
  EXPECT_EQ(image_["W6K0"], 4);
  image_.Write("U10K21", 0);
  image_.Write("U10N4", 0);
  Run();
  EXPECT_EQ(image_["I0K27"], 0);
  EXPECT_EQ(image_["I0N1"], 0);
  image_.Write("U10K26", 1);
  image_.Write("U10K21", 1);
  Run();
  EXPECT_EQ(image_["I0K26"], 1);
  EXPECT_EQ(image_["I0K1"], 1);

  Run(3);
  image_.Write("U10K18", 1);  // no selection in W17K0
  Run();
  EXPECT_EQ(image_["I5K31"], 1);
  image_.Write("U10K18", 0);
  Run();
  EXPECT_EQ(image_["I5K31"], 0);
  image_.Write("W17K0", 3);
  image_.Write("U10K23", 1);
  image_.Write("U10K18", 1);
  Run();
  EXPECT_EQ(image_["I5K30"], 1);
  EXPECT_EQ(image_["I0K1"], 1);
}

TEST_F(Nc110Stub, SpindleAndPointToPointAxes) {
  image_.Write("U11K0", 1);
  image_.Write("W11K3", 'S');
  image_.Write("W20K0", 2);
  image_.Write("W18K1", 0x25);
  Run();
  EXPECT_EQ(image_["I6K23"], 1);
  EXPECT_EQ(image_["I0K25"], 0);
  EXPECT_EQ(image_["I0K29"], 0);
  EXPECT_EQ(image_["I5K26"], 1);
  EXPECT_EQ(image_["I5K16"], 1);
  Run(3);
  EXPECT_EQ(image_["I0K25"], 1);
  EXPECT_EQ(image_["I0K29"], 1);
  EXPECT_EQ(image_["I5K24"], 1);
  EXPECT_EQ(image_["I5K16"], 0);
  EXPECT_EQ(image_["W4N1"], 0x25);
  image_.Write("W20K0", 0);
  image_.Write("U11K0", 0);
  Run();
  EXPECT_EQ(image_["I5K26"], 0);
  EXPECT_EQ(image_["I0K25"], 0);
}

TEST_F(Nc110Stub, OneModeAndTheUserWins) {
  image_.Write("I8K25", 1);
  Run();
  EXPECT_EQ(image_["W8K3"], 2);
  image_.Write("U15K2", 1);
  image_.Write("W15K1", 8);
  Run();
  EXPECT_EQ(image_["W8K3"], 8);
  image_.Write("W15K1", 3);  // more than one bit is ignored
  Run();
  EXPECT_EQ(image_["W8K3"], 8);
  // What the stub does not change it does not write.
  image_.Write("W0K1", 5);
  image_.Write("I0K2", 0);
  const uint32_t before = image_.writes;
  Run(5);
  EXPECT_EQ(image_["W0K1"], 5);
  EXPECT_EQ(image_.writes, before);
}

}  // namespace
}  // namespace plcxx::nc110
