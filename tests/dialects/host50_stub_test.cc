// The simulated machine: inputs last until they are set again (specification 4.3).
#include "transpiler/dialects/host50/control/stub.h"

#include "host50_lowered.h"
#include "transpiler/dialects/host50/control/locate.h"

namespace plcxx::host50 {
namespace {

class Image final : public dialects::ImagePort {
 public:
  explicit Image(const ir::Program& program) {
    for (const ir::Space& space : program.spaces) bytes_.emplace_back(space.bytes);
  }
  uint8_t Get(ir::SpaceId space, uint32_t offset) const override { return bytes_[space.index][offset]; }
  void Set(ir::SpaceId space, uint32_t offset, uint8_t value) override { bytes_[space.index][offset] = value; }
  void StoreRetentive() override {}
  void LookAtMessages() override {}
  void Clear() {
    for (std::vector<uint8_t>& space : bytes_) std::ranges::fill(space, uint8_t{0});
  }

 private:
  std::vector<std::vector<uint8_t>> bytes_;
};

struct Machine {
  LoweredProgram lowered;
  std::unique_ptr<dialects::ControlStub> stub;
  std::unique_ptr<Image> image;

  explicit Machine(const std::string& text) {
    LowerInto(lowered, {text});
    stub = MakeStub(lowered.program, {});
    image = std::make_unique<Image>(lowered.program);
  }
  ir::Place At(std::string_view name) const { return Locate(ir::NameIndex(lowered.program), name)->place; }
  uint64_t Read(std::string_view name) const {
    const ir::Place place = At(name);
    if (place.type == ir::Type::kBit) return image->Get(place.space, place.offset) >> place.bit & 1;
    uint64_t value = 0;
    for (uint32_t i = 0; i < 4; ++i) value |= uint64_t{image->Get(place.space, place.offset + i)} << (8 * i);
    return value;
  }
  void Write(std::string_view name, uint64_t value) {
    const ir::Place place = At(name);
    for (uint32_t i = 0; i < ir::Bytes(place.type); ++i) {
      image->Set(place.space, place.offset + i, static_cast<uint8_t>(value >> (8 * i)));
    }
  }
  bool Set(std::string_view name, uint64_t value) { return stub->Written(At(name), value, *image); }
  void Call(std::string_view function) {
    for (const ir::HostFunction& host : lowered.program.host_functions) {
      std::optional<uint64_t> out;
      if (host.name == function) stub->Call(host, {}, *image, out);
    }
  }
};

// covers: HOST50-030 HOST50-045
TEST(Host50Stub, DeliversInputsAtEveryReadInputs) {
  Machine machine(Slow("LD %I0\nOUT %Q0\n"));
  EXPECT_TRUE(machine.Set("I0", 1));
  EXPECT_TRUE(machine.Set("I9", 1));
  EXPECT_TRUE(machine.Set("IW5", 0xFFFFFFFF));
  EXPECT_TRUE(machine.Set("IF300", 0x3F800000));
  machine.Call("write_outputs");
  EXPECT_EQ(machine.Read("I0"), 0u) << "only read_inputs writes the image";
  machine.Call("read_inputs");
  EXPECT_EQ(machine.Read("I0"), 1u);
  EXPECT_EQ(machine.Read("I1"), 0u);
  EXPECT_EQ(machine.Read("I9"), 1u);
  EXPECT_EQ(machine.Read("IW5"), 0xFFFFFFFFu);
  EXPECT_EQ(machine.Read("IF300"), 0x3F800000u);
  machine.stub->PowerOff();
  machine.image->Clear();
  machine.Call("read_inputs");  // of init
  EXPECT_EQ(machine.Read("I9"), 1u);
  machine.Set("I9", 0);
  machine.Call("read_inputs");
  EXPECT_EQ(machine.Read("I9"), 0u);
  EXPECT_EQ(machine.Read("I0"), 1u);
}

// covers: HOST50-059
TEST(Host50Stub, TakesBackWhatTheProgramWritesIntoInputs) {
  Machine machine(Slow("LD 1\nMOV 7, %IW5\nMOV 1.0, %IF6\nMOV 8, %QW5\n"));
  machine.Write("IW5", 7);
  machine.Write("IF6", 0x3F800000);
  machine.Write("QW5", 8);
  machine.Call("read_inputs");
  EXPECT_EQ(machine.Read("IW5"), 0u);
  EXPECT_EQ(machine.Read("IF6"), 0u);
  EXPECT_EQ(machine.Read("QW5"), 8u);
  machine.Set("IW5", 3);
  machine.Write("IW5", 7);
  machine.Call("read_inputs");
  EXPECT_EQ(machine.Read("IW5"), 3u);
}

TEST(Host50Stub, LeavesOtherPlacesToTheScenario) {
  Machine machine(Slow("LD %I0\nTONS %TM1, 3\nOUT %Q0\n"));
  EXPECT_FALSE(machine.Set("Q0", 1));
  EXPECT_FALSE(machine.Set("B500", 1));
  EXPECT_FALSE(machine.Set("TM1.V", 1));
}

}  // namespace
}  // namespace plcxx::host50
