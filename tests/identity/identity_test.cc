#include "transpiler/identity/identity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "transpiler/identity/intel_hex.h"

namespace plcxx::identity {
namespace {

const Identity kDoor{.program = "door",
                     .version = {1, 2, 3},
                     .options = "0123abcd",
                     .sources = "00112233445566778899aabbccddeeff",
                     .generated = "ffeeddccbbaa99887766554433221100"};

std::string Bytes(const Identity& identity) {
  const auto bytes = BytesOf(identity);
  return {bytes.begin(), bytes.end()};
}

/// Records of 16 bytes from an address on.
std::string HexOf(const std::string& bytes, uint32_t address) {
  constexpr size_t kPerRecord = 16;
  std::string text = ":020000040800F2\r\n";
  for (size_t at = 0; at < bytes.size(); at += kPerRecord) {
    const std::string data = bytes.substr(at, kPerRecord);
    const auto here = static_cast<uint32_t>(address + at);
    std::string record{static_cast<char>(data.size()), static_cast<char>(here >> 8), static_cast<char>(here), '\0'};
    record += data;
    uint8_t sum = 0;
    text += ':';
    for (const char c : record) {
      char digits[3];
      std::snprintf(digits, sizeof digits, "%02X", static_cast<unsigned>(static_cast<uint8_t>(c)));
      text += digits;
      sum = static_cast<uint8_t>(sum + static_cast<uint8_t>(c));
    }
    char digits[3];
    std::snprintf(digits, sizeof digits, "%02X", static_cast<unsigned>(static_cast<uint8_t>(-sum)));
    text += std::string(digits) + "\r\n";
  }
  return text + ":00000001FF\r\n";
}

TEST(Identity, IsFoundAmongOtherBytes) {
  EXPECT_EQ(Bytes(kDoor).size(), kBytes);
  Identity turret = kDoor;
  turret.program = "turret";
  const std::string image =
      "\x7F"
      "ELF" +
      std::string(99, '\0') + Bytes(kDoor) + "code" + Bytes(turret) + Bytes(kDoor);
  EXPECT_THAT(FindIdentities(image), testing::ElementsAre(kDoor, turret));
}

TEST(Identity, AnImageWithoutOneHasNone) {
  EXPECT_THAT(FindIdentities(""), testing::IsEmpty());
  EXPECT_THAT(FindIdentities("plcxx-id"), testing::IsEmpty());
  EXPECT_THAT(FindIdentities(Bytes(kDoor).substr(0, kBytes - 1)), testing::IsEmpty());
  std::string other_layout = Bytes(kDoor);
  other_layout[8] = 2;
  EXPECT_THAT(FindIdentities(other_layout), testing::IsEmpty());
  EXPECT_THAT(FindIdentities("plcxx-id\x01" + std::string(kBytes, '\0')), testing::IsEmpty());
}

TEST(Identity, ALongNameEndsWithAWholeCharacter) {
  Identity identity = kDoor;
  identity.program = "fifteen bytes: \xC3\xA4\xC3\xB6";
  const std::vector<Identity> found = FindIdentities(Bytes(identity));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.front().program, "fifteen bytes: ");
}

TEST(Identity, DigestsThatNobodyComputedAreZeros) {
  EXPECT_EQ(FirstDigits("", 8), "00000000");
  EXPECT_EQ(FirstDigits("0123456789abcdef", 8), "01234567");
}

TEST(Identity, IsFoundInIntelHex) {
  EXPECT_THAT(FindIdentities(HexOf("begin" + Bytes(kDoor) + "end", 0x1000)), testing::ElementsAre(kDoor));
}

TEST(Identity, ARecordThatIsDamagedIsLeftOut) {
  std::string text = HexOf(Bytes(kDoor), 0x1000);
  const size_t digit = text.find("\r\n:10") + 20;
  text[digit] = text[digit] == '0' ? '1' : '0';
  EXPECT_THAT(FindIdentities(text), testing::IsEmpty());
  EXPECT_EQ(DecodeIntelHex(":"), "");
  EXPECT_EQ(DecodeIntelHex(":zz\n:0\n:00000001FF"), "");
  EXPECT_EQ(DecodeIntelHex("no hex"), "");
}

TEST(Identity, TheConstantIsSixtyFourBytesOfCxx) {
  const std::string text = ConstantText(kDoor);
  EXPECT_THAT(text, testing::HasSubstr("kPlcxxIdentity[64]"));
  size_t count = 0;
  for (size_t at = text.find("0x"); at != std::string::npos; at = text.find("0x", at + 1)) ++count;
  EXPECT_EQ(count, kBytes);
}

}  // namespace
}  // namespace plcxx::identity
