#include <gtest/gtest.h>

#include "tests/source/loading.h"
#include "transpiler/source/detect.h"
#include "transpiler/source/source.h"

namespace plcxx::source {
namespace {

constexpr Encoding kEightBit[] = {Encoding::kCp866, Encoding::kCp1251, Encoding::kKoi8R};
constexpr Encoding kLatin[] = {Encoding::kMazovia, Encoding::kKamenicky, Encoding::kCp852, Encoding::kCp1250};

TEST(EncodingNames, BothWays) {
  for (const std::string_view name : EncodingNames()) EXPECT_EQ(Name(EncodingByName(name).value()), name);
  EXPECT_EQ(EncodingNames(), (std::vector<std::string_view>{"utf-8", "cp866", "cp1251", "koi8-r", "mazovia",
                                                            "kamenicky", "cp852", "cp1250", "gb18030"}));
  EXPECT_EQ(EncodingByName("KEYBCS2"), Encoding::kKamenicky);
  EXPECT_EQ(EncodingByName("gbk"), Encoding::kGb18030);
  EXPECT_EQ(EncodingByName("CP936"), Encoding::kGb18030);
  EXPECT_EQ(EncodingByName("IBM866"), Encoding::kCp866);
  EXPECT_EQ(EncodingByName("Windows-1251"), Encoding::kCp1251);
  EXPECT_EQ(EncodingByName("UTF8"), Encoding::kUtf8);
  EXPECT_EQ(EncodingByName("ebcdic"), std::nullopt);
  EXPECT_EQ(EncodingByName(""), std::nullopt);
}

TEST(Utf8, WellFormed) {
  for (const std::string_view text :
       {"", "abc", "é", "Ж", "€", "\uFFFD", "\U0001F600", "\U0010FFFF", "abcdefghЖabcdefgh"}) {
    EXPECT_TRUE(IsValidUtf8(text)) << text;
  }
}

TEST(Utf8, NotWellFormed) {
  for (const std::string_view text :
       {"\x80", "\xC0\x80", "\xC1\xBF", "\xE0\x80\x80", "\xED\xA0\x80", "\xF0\x80\x80\x80", "\xF4\x90\x80\x80",
        "\xF5\x80\x80\x80", "\xFF", "\xD0", "abcdefgh\xD0", "\xE2\x82", "\xF0\x9F\x98", "\xD0 ", "\xD0\xD0\x96"}) {
    EXPECT_FALSE(IsValidUtf8(text));
  }
}

TEST(Utf8, CutOffAtTheEndIsEightBit) {
  SourceManager sources;
  const FileId file = Loaded(sources.AddBytes("a.plc", ";Насо\xD1", {}));
  EXPECT_NE(sources.Get(file).encoding, Encoding::kUtf8);
}

TEST(Forced, Utf8ReplacesEveryBadByte) {
  SourceManager sources;
  const FileId file = Loaded(sources.AddBytes("a.plc", "a\xE2\x82z\xFF", {.encoding = Encoding::kUtf8}));
  EXPECT_EQ(sources.Get(file).text, "a\uFFFD\uFFFDz\uFFFD");
  EXPECT_EQ(sources.Get(file).replaced.size(), 3u);
}

TEST(Forced, AlwaysIfTheDialectSaysSo) {
  SourceManager sources;
  const LoadOptions options{.encoding = Encoding::kMazovia, .choice = Choice::kAlways};
  const File& file = sources.Get(Loaded(sources.AddBytes("a.plc", "\xC3\xB3 \xA2", options)));
  EXPECT_EQ(file.text, "├│ ó");
  EXPECT_EQ(file.origin, EncodingOrigin::kChosen);
  EXPECT_EQ(sources.Get(Loaded(sources.AddBytes("b.plc", "\xEF\xBB\xBFó", options))).text, "ó");
}

TEST(Fallback, WithoutDetection) {
  SourceManager sources;
  const LoadOptions options{.detection = Detection::kFallback, .fallback = Encoding::kMazovia};
  const File& polish = sources.Get(Loaded(sources.AddBytes("a.plc",
                                                           "Z\x92"
                                                           "a\xA4",
                                                           options)));
  EXPECT_EQ(polish.text, "Złań");
  EXPECT_EQ(polish.origin, EncodingOrigin::kFallback);
  EXPECT_EQ(sources.Get(Loaded(sources.AddBytes("b.plc", "Złań", options))).origin, EncodingOrigin::kValidUtf8);
  EXPECT_EQ(sources.Get(Loaded(sources.AddBytes("c.plc", "\xEF\xBB\xBFx", options))).origin, EncodingOrigin::kBom);
}

TEST(Forced, ValidUtf8StaysUtf8) {
  SourceManager sources;
  const FileId file = Loaded(sources.AddBytes("a.plc", "Ж", {.encoding = Encoding::kCp1251}));
  EXPECT_EQ(sources.Get(file).text, "Ж");
}

TEST(Forced, EightBitWithoutDetection) {
  SourceManager sources;
  const FileId file = Loaded(sources.AddBytes("a.plc", "\xC6", {.encoding = Encoding::kCp1251}));
  EXPECT_EQ(sources.Get(file).text, "Ж");
}

TEST(Decoding, EveryByteIsOneCharacter) {
  std::string all;
  for (int byte = 1; byte < 256; ++byte) all += static_cast<char>(byte);
  for (const Encoding encoding : kEightBit) {
    const Decoded decoded = DecodeEightBit(all, encoding);
    EXPECT_TRUE(IsValidUtf8(decoded.text));
    EXPECT_EQ(decoded.text.substr(0, 0x7F), all.substr(0, 0x7F)) << "controls stay, in " << Name(encoding);
  }
}

TEST(Decoding, EveryByteOfLatinEncodingsIsOneCharacter) {
  std::string all;
  for (int byte = 1; byte < 256; ++byte) all += static_cast<char>(byte);
  for (const Encoding encoding : kLatin) {
    const Decoded decoded = DecodeEightBit(all, encoding);
    EXPECT_TRUE(IsValidUtf8(decoded.text));
    EXPECT_EQ(decoded.text.substr(0, 0x7F), all.substr(0, 0x7F)) << Name(encoding);
    EXPECT_EQ(decoded.replaced.size(), encoding == Encoding::kCp1250 ? 5u : 0u) << Name(encoding);
  }
}

TEST(Decoding, Letters) {
  // Bytes from published tables of the four encodings.
  EXPECT_EQ(DecodeEightBit("\x8F\x95\x90\x9C\xA5\xA3\x98\xA0\xA1", Encoding::kMazovia).text, "ĄĆĘŁŃÓŚŹŻ");
  EXPECT_EQ(DecodeEightBit("\x86\x8D\x91\x92\xA4\xA2\x9E\xA6\xA7 \x81\xC9\xF8", Encoding::kMazovia).text,
            "ąćęłńóśźż ü╔°");
  EXPECT_EQ(DecodeEightBit("\xA4\x8F\xA8\x9D\xE3\xE0\x97\x8D\xBD", Encoding::kCp852).text, "ĄĆĘŁŃÓŚŹŻ");
  EXPECT_EQ(DecodeEightBit("\xA5\xC6\xCA\xA3\xD1\xD3\x8C\x8F\xAF", Encoding::kCp1250).text, "ĄĆĘŁŃÓŚŹŻ");
  EXPECT_EQ(DecodeEightBit("P\xA9\xA1li\xA8 \x91lu\x9Fou\x87k\x98 k\x96\xA4", Encoding::kKamenicky).text,
            "Příliš žluťoučký kůň");
  EXPECT_EQ(DecodeEightBit("\x83\x9F\x88\x82\x80\xAB\xAD\xE1", Encoding::kKamenicky).text, "ďťěéČŔ§ß");
}

TEST(Decoding, Gb18030) {
  const std::string_view coolant = "\xC0\xE4\xC8\xB4\xB1\xC3";
  EXPECT_EQ(DecodeGb18030(std::string(coolant) + "1").text, "冷却泵1");
  EXPECT_EQ(DecodeGb18030("\xA1\xE3 \xA3\xAC").text, "° ，");
  EXPECT_EQ(DecodeGb18030("\x90\x30\x81\x30").text, "\U00010000");
  EXPECT_TRUE(DecodeGb18030(coolant).replaced.empty());
}

TEST(Decoding, BrokenGb18030NeverSwallowsAscii) {
  for (const std::string_view broken : {"\x81", "\xFF", "\x80", "\xB1", "\x84\x31\xA4"}) {
    const Decoded decoded = DecodeGb18030(std::string(broken) + "\r\nx");
    EXPECT_TRUE(decoded.text.ends_with("\r\nx")) << decoded.text;
    EXPECT_FALSE(decoded.replaced.empty());
  }
  const Decoded among = DecodeGb18030("\xC0\xE4\xFE\x39\xFE\x39\xC8\xB4");
  EXPECT_TRUE(among.text.starts_with("冷\uFFFD")) << among.text;
  EXPECT_TRUE(IsValidUtf8(among.text));
}

TEST(Decoding, UndefinedByteIsReplaced) {
  const Decoded decoded = DecodeEightBit("a\x98z", Encoding::kCp1251);
  EXPECT_EQ(decoded.text, "a\uFFFDz");
  EXPECT_EQ(decoded.replaced, std::vector<uint32_t>{1});
  EXPECT_TRUE(DecodeEightBit("a\x98z", Encoding::kCp866).replaced.empty());
}

TEST(Decoding, KnownBytes) {
  EXPECT_EQ(DecodeEightBit("\x91\xAC\xA0\xA7\xAA\xA0 \xC9\xCD\xBB \xFC", Encoding::kCp866).text, "Смазка ╔═╗ №");
  EXPECT_EQ(DecodeEightBit("\xD1\xEC\xE0\xE7\xEA\xE0 \xB9", Encoding::kCp1251).text, "Смазка №");
  EXPECT_EQ(DecodeEightBit("\xF3\xCD\xC1\xDA\xCB\xC1", Encoding::kKoi8R).text, "Смазка");
}

class DetectedComment : public testing::TestWithParam<const char*> {};

TEST_P(DetectedComment, InEveryEncodingWhateverTheFallback) {
  for (const Encoding encoding : kEightBit) {
    for (const Encoding fallback : kEightBit) {
      const std::string bytes = "$\r\nU4A0=I0A7 ;" + Encoded(GetParam(), encoding) + "\r\n";
      EXPECT_EQ(Name(DetectEightBit(bytes, fallback)), Name(encoding)) << "fallback " << Name(fallback);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Comments, DetectedComment,
                         testing::Values("Смазка направляющих", "ЗАЖИМ ИНСТРУМЕНТА", "Насос", "Аварийный останов",
                                         "АВАРИЯ", "готовность", "Шпиндель вперёд", "ОХЛАЖДЕНИЕ", "дверь открыта",
                                         "Ось X в нуле", "Давление масла", "смена инструмента", "ПИНОЛЬ ОТВЕДЕНА",
                                         "Револьверная головка: поиск позиции", "уровень СОЖ ниже нормы",
                                         "транспортёр стружки", "ОГРАЖДЕНИЕ ЗАКРЫТО", "Контроль скорости S", "включить",
                                         "СТОП", "пуск", "М3, М4 - вращение шпинделя"));

TEST(Detection, FramesOfCp866) {
  const char* frames[] = {"; ════════════════════\n",
                          ";╔═══════════════╗\n;║ Смазка        ║\n;╚═══════════════╝\n",
                          ";┌────────┐\n;│ ЗАЖИМ  │\n;└────────┘\n",
                          "; ──────── насос ────────\n",
                          ";████████\n",
                          ";░▒▓ ПУСК ▓▒░\n"};
  for (const char* frame : frames) {
    for (const Encoding fallback : kEightBit) {
      EXPECT_EQ(Name(DetectEightBit(Encoded(frame, Encoding::kCp866), fallback)), "cp866") << frame;
    }
  }
}

TEST(Detection, FramesOfKoi8) {
  const std::string bytes = Encoded(";╔═══════════╗\n;║ смазка    ║\n;╚═══════════╝\n", Encoding::kKoi8R);
  EXPECT_EQ(Name(DetectEightBit(bytes, Encoding::kCp866)), "koi8-r");
}

TEST(Detection, SymbolsBesideLetters) {
  EXPECT_EQ(Name(DetectEightBit(Encoded("Насос №1, +5°C", Encoding::kCp866), Encoding::kCp1251)), "cp866");
  EXPECT_EQ(Name(DetectEightBit(Encoded("Насос №1, +5°C – «да»", Encoding::kCp1251), Encoding::kCp866)), "cp1251");
}

TEST(Detection, WithoutEvidenceTheFallback) {
  for (const Encoding fallback : kEightBit) EXPECT_EQ(Name(DetectEightBit("; no letters", fallback)), Name(fallback));
  // One symbol is no evidence: a degree sign of CP1251 is a piece of shading in CP866.
  EXPECT_EQ(Name(DetectEightBit("+5\xB0", Encoding::kCp866)), "cp866");
  EXPECT_EQ(Name(DetectEightBit("+5\xB0", Encoding::kCp1251)), "cp1251");
}

TEST(Detection, SameAnswerWhenAskedAgain) {
  std::string noise;
  for (uint32_t i = 0, x = 12345; i < 5000; ++i, x = x * 1664525 + 1013904223) noise += static_cast<char>(x >> 24 | 1);
  EXPECT_EQ(DetectEightBit(noise, Encoding::kCp866), DetectEightBit(noise, Encoding::kCp866));
}

TEST(Detection, ThroughLoading) {
  for (const Encoding encoding : kEightBit) {
    SourceManager sources;
    const File& file = sources.Get(Loaded(sources.AddBytes("a.plc", Encoded(";Смазка направляющих", encoding), {})));
    EXPECT_EQ(file.encoding, encoding);
    EXPECT_EQ(file.text, ";Смазка направляющих");
  }
}

}  // namespace
}  // namespace plcxx::source
