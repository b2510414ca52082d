// The number in a message, as the NC shows it (specification 8.3). Expectations are worked out from the table there.
#include "tests/dialects/prostep_lowered.h"
#include "transpiler/dialects/prostep/control/stub.h"
#include "transpiler/dialects/prostep/machine/memory.h"

namespace plcxx::prostep {
namespace {

/// Memory of a program: all bytes are 0 but those that are set.
class Image final : public dialects::ImagePort {
 public:
  explicit Image(const ir::Program& program) : memory_(program) {}
  void Set(Space space, uint32_t address, uint8_t value) {
    const Cell cell = memory_.At(space, address);
    Set(cell.space, cell.offset, value);
  }
  uint8_t Get(ir::SpaceId space, uint32_t offset) const override {
    const auto found = bytes_.find({space.index, offset});
    return found == bytes_.end() ? 0 : found->second;
  }
  void Set(ir::SpaceId space, uint32_t offset, uint8_t value) override { bytes_[{space.index, offset}] = value; }
  void StoreRetentive() override {}
  void LookAtMessages() override {}

 private:
  Memory memory_;
  std::map<std::pair<uint32_t, uint32_t>, uint8_t> bytes_;
};

/// Message 2, whose text is "X =", with these bytes at DB 100.
std::string Shown(const std::vector<uint8_t>& field) {
  LoweredProgram lowered;
  LowerInto(lowered, "DM 2 .X =\n:MOD PM 9\n:A I 0.0\n:= F 213.1\n:END PM 9\n");
  Image image(lowered.program());
  image.Set(Space::kF, 223, 100);
  for (uint32_t i = 0; i < field.size(); ++i) image.Set(Space::kD, 100 + i, field[i]);
  return MessageText(lowered.program(), 2, image);
}

constexpr uint8_t kShow = 0x01, kDouble = 0x20, kMinus = 0x40, kBcd = 0x80;

// covers: PS-276
TEST(ProstepMessages, NumbersAreFormatted) {
  EXPECT_EQ(Shown({kShow, 4, 0, 0xD2, 0x04}), "X = 1234");
  EXPECT_EQ(Shown({kShow, 4, 2, 0x2E, 0xFB}), "X = -12.34");
  EXPECT_EQ(Shown({kShow, 4, 3, 5, 0}), "X = 0.005");
  EXPECT_EQ(Shown({kShow, 4, 0, 0, 0}), "X = 0");
  EXPECT_EQ(Shown({kShow | kDouble, 4, 0, 0xFF, 0xFF, 0xFF, 0xFF}), "X = -1");
  EXPECT_EQ(Shown({kShow | kDouble, 4, 0, 0, 0, 0, 0x80}), "X = -2147483648");
  EXPECT_EQ(Shown({kShow | kBcd, 4, 0, 0x34, 0x12}), "X = 1234");
  EXPECT_EQ(Shown({kShow | kBcd | kMinus, 4, 1, 0x42, 0x00}), "X = -4.2");
  EXPECT_EQ(Shown({kShow | kBcd | kDouble, 4, 0, 0x78, 0x56, 0x34, 0x12}), "X = 12345678");
  EXPECT_EQ(Shown({kShow | kBcd, 4, 0, 0x0A, 0x01}), "X = 10A");
}

// covers: PS-276
TEST(ProstepMessages, WhereAndWhetherTheNumberIsShown) {
  EXPECT_EQ(Shown({0, 4, 0, 1, 0}), "X =");
  EXPECT_EQ(Shown({kShow, 0, 0, 12, 0}), "12=");                  // over the text
  EXPECT_EQ(Shown({kShow, 1 << 6 | 3, 0, 12, 0}), "X =\n   12");  // in the next line
  EXPECT_EQ(Shown({kShow, 3 << 6 | 5, 2, 0x2E, 0xFB}), "X =\n\n\n     -12.34");
}

}  // namespace
}  // namespace plcxx::prostep
