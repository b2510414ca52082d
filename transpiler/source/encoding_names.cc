#include <algorithm>
#include <cctype>

#include "transpiler/source/source.h"

namespace plcxx::source {
namespace {

struct EncodingName {
  std::string_view name;
  Encoding encoding;
};

/// The first name of an encoding is the one we print; the others are what other programs call it.
constexpr EncodingName kNames[] = {
    {"utf-8", Encoding::kUtf8},          {"utf8", Encoding::kUtf8},       {"cp866", Encoding::kCp866},
    {"ibm866", Encoding::kCp866},        {"ibm-866", Encoding::kCp866},   {"866", Encoding::kCp866},
    {"dos", Encoding::kCp866},           {"cp1251", Encoding::kCp1251},   {"windows-1251", Encoding::kCp1251},
    {"windows1251", Encoding::kCp1251},  {"win-1251", Encoding::kCp1251}, {"win1251", Encoding::kCp1251},
    {"1251", Encoding::kCp1251},         {"koi8-r", Encoding::kKoi8R},    {"koi8r", Encoding::kKoi8R},
    {"koi8", Encoding::kKoi8R},          {"mazovia", Encoding::kMazovia}, {"kamenicky", Encoding::kKamenicky},
    {"keybcs2", Encoding::kKamenicky},   {"cp895", Encoding::kKamenicky}, {"cp852", Encoding::kCp852},
    {"ibm852", Encoding::kCp852},        {"852", Encoding::kCp852},       {"cp1250", Encoding::kCp1250},
    {"windows-1250", Encoding::kCp1250}, {"1250", Encoding::kCp1250},     {"gb18030", Encoding::kGb18030},
    {"gbk", Encoding::kGb18030},         {"cp936", Encoding::kGb18030},   {"gb2312", Encoding::kGb18030},
};

bool EqualIgnoringCase(std::string_view a, std::string_view b) {
  return std::ranges::equal(
      a, b, {}, [](unsigned char c) { return std::tolower(c); }, [](unsigned char c) { return std::tolower(c); });
}

}  // namespace

std::string_view Name(Encoding encoding) {
  for (const EncodingName& row : kNames) {
    if (row.encoding == encoding) return row.name;
  }
  PLCXX_UNREACHABLE();
}

std::optional<Encoding> EncodingByName(std::string_view name) {
  for (const EncodingName& row : kNames) {
    if (EqualIgnoringCase(row.name, name)) return row.encoding;
  }
  return std::nullopt;
}

std::vector<std::string_view> EncodingNames() {
  std::vector<std::string_view> names;
  for (const EncodingName& row : kNames) {
    if (row.name == Name(row.encoding)) names.push_back(row.name);
  }
  return names;
}

}  // namespace plcxx::source
