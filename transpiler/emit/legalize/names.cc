#include "transpiler/emit/legalize/names.h"

#include <algorithm>
#include <iterator>

#include "transpiler/ir/op.h"

namespace plcxx::emit::legalize {
namespace {

/// Nothing can be called that, wherever it is.
constexpr std::string_view kReserved[] = {
    // C++20 keywords and alternative tokens
    "alignas", "alignof", "and", "and_eq", "asm", "auto", "bitand", "bitor", "bool", "break", "case", "catch", "char",
    "char8_t", "char16_t", "char32_t", "class", "compl", "concept", "const", "consteval", "constexpr", "constinit",
    "const_cast", "continue", "co_await", "co_return", "co_yield", "decltype", "default", "delete", "do", "double",
    "dynamic_cast", "else", "enum", "explicit", "export", "extern", "false", "float", "for", "friend", "goto", "if",
    "inline", "int", "long", "mutable", "namespace", "new", "noexcept", "not", "not_eq", "nullptr", "operator", "or",
    "or_eq", "private", "protected", "public", "register", "reinterpret_cast", "requires", "return", "short", "signed",
    "sizeof", "static", "static_assert", "static_cast", "struct", "switch", "template", "this", "thread_local", "throw",
    "true", "try", "typedef", "typeid", "typename", "union", "unsigned", "using", "virtual", "void", "volatile",
    "wchar_t", "while", "xor", "xor_eq", "final", "override", "import", "module",
    // macros and types that <stdint.h>, <stddef.h> and usual platform headers bring
    "NULL", "offsetof", "size_t", "ptrdiff_t", "max_align_t", "nullptr_t", "errno", "assert", "EOF", "stdin", "stdout",
    "stderr", "WCHAR_MAX", "WCHAR_MIN", "WINT_MAX", "WINT_MIN", "PTRDIFF_MAX", "PTRDIFF_MIN", "SIG_ATOMIC_MAX",
    "SIG_ATOMIC_MIN", "SIZE_MAX", "CHAR_BIT", "linux", "unix", "i386", "TRUE", "FALSE", "ERROR", "IN", "OUT", "min",
    "max", "main", "std", "plcxx"};

/// Names of the generated code.
constexpr std::string_view kTaken[] = {"State",        "Host",     "Retentive",  "Bit",
                                       "Byte",         "Word16",   "Word32",     "Word64",
                                       "Float32",      "Float64",  "PackedBit",  "RetentiveByte",
                                       "RetentiveBit", "Space",    "m",          "host",
                                       "init",         "fast",     "slow",       "period",
                                       "fast_only",    "slice",    "round",      "copy",
                                       "layout",       "At",       "F32OfBits",  "F64OfBits",
                                       "kValues",      "messages", "menu_texts", "send_operator_text",
                                       "get_byte",     "set_byte", "retentive",  "Clear",
                                       "ReapplyForces"};

constexpr uint32_t kFirstNumber = 2;  // of the second one that has a name

constexpr std::string_view kMacros[] = {
#include "transpiler/emit/legalize/platform_macros.def"
};

bool IsLetter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
bool IsDigit(char c) { return c >= '0' && c <= '9'; }

/// "INT32_MAX", "UINT8_C", "uint_fast16_t", "INTPTR_MIN": the macros and types of <stdint.h>, and those that a later
/// standard may add, which reserves the whole pattern (C11 7.31.10).
bool IsStdintName(std::string_view name) {
  if (name.starts_with("uint") || name.starts_with("int")) return name.ends_with("_t");
  if (!name.starts_with("UINT") && !name.starts_with("INT")) return false;
  return name.ends_with("_MAX") || name.ends_with("_MIN") || name.ends_with("_C") || name.ends_with("_WIDTH");
}

/// "t1", "round2": what the generated functions call their locals.
bool IsLocalName(std::string_view name) {
  const size_t digits = name.starts_with("round") ? 5 : name.starts_with("t") ? 1 : std::string_view::npos;
  if (digits == std::string_view::npos || digits >= name.size()) return false;
  for (const char c : name.substr(digits)) {
    if (!IsDigit(c)) return false;
  }
  return true;
}

}  // namespace

std::string SafeIdentifier(std::string_view name) {
  std::string out;
  const auto append = [&out](std::string_view text) {
    for (const char c : text) {
      if (c == '_' && !out.empty() && out.back() == '_') continue;  // two in a row are reserved in C++
      out += c;
    }
  };
  for (const char c : name) {
    if (IsLetter(c) || IsDigit(c)) {
      out += c;
    } else if (c == '@') {
      append("_at");
    } else if (c == '#') {
      append("_no");
    } else if (c == '\'') {
      append("_q");
    } else if (c == '?') {
      append("_is");
    } else {
      append("_");
    }
  }
  if (out.empty() || !IsLetter(out.front())) out.insert(0, out.empty() || out.front() != '_' ? "n_" : "n");
  return out;
}

std::string NamespaceOf(std::string_view program) {
  std::string name = SafeIdentifier(program);
  const bool reserved = std::ranges::find(kReserved, name) != std::end(kReserved) ||
                        std::ranges::find(kMacros, name) != std::end(kMacros) || IsStdintName(name);
  return reserved ? name + "_program" : name;
}

NameTable::NameTable() {
  taken_.reserve(std::size(kReserved) + std::size(kTaken) + std::size(kMacros) + 2 * ir::OpCount());
  for (const std::string_view word : kReserved) taken_.emplace(word);
  for (const std::string_view word : kTaken) taken_.emplace(word);
  for (const std::string_view word : kMacros) taken_.emplace(word);
  for (uint32_t i = 0; i < ir::OpCount(); ++i) {
    const std::string_view spelling = ir::Info(static_cast<ir::OpKind>(i)).spelling;
    const size_t bracket = spelling.find('(');
    if (bracket != std::string_view::npos && bracket > 0) taken_.emplace(spelling.substr(0, bracket));
  }
  for (uint32_t i = 0; i < ir::StateKindCount(); ++i) {
    const auto kind = static_cast<ir::StateKind>(i);
    taken_.emplace(ir::Info(kind).struct_name);
    taken_.emplace(ir::Info(kind).text);
    taken_.insert(std::string(ir::Info(kind).struct_name) + "Tag");
    for (const ir::FieldInfo& field : ir::Info(kind).fields) {
      taken_.insert(std::string(ir::Info(kind).struct_name) + "_" + std::string(field.name));
    }
  }
}

uint32_t FunctionNames::FirstNumber(const std::string& base) const {
  const auto found = first_free_.find(base);
  return found == first_free_.end() ? kFirstNumber : found->second;
}

void FunctionNames::TakeNumber(const std::string& base, uint32_t number) {
  uint32_t& first = first_free_.try_emplace(base, kFirstNumber).first->second;
  // Numbers that other functions only have passed may be free in this one.
  if (first == number) ++first;
}

std::string NameTable::Allocate(std::string_view name, std::string_view address) {
  std::string candidate = SafeIdentifier(name);
  if (!IsLocalName(candidate) && !IsStdintName(candidate) && taken_.insert(candidate).second) return candidate;
  // Through the rule once more: no name may get two underscores in a row.
  candidate = SafeIdentifier(candidate + "_" + (address.empty() ? "n" : std::string(address)));
  if (taken_.insert(candidate).second) return candidate;
  uint32_t& number = first_free_.try_emplace(candidate, kFirstNumber).first->second;
  for (;; ++number) {
    std::string unique = SafeIdentifier(candidate + "_" + std::to_string(number));
    if (taken_.insert(unique).second) return unique;
  }
}

std::string NameTable::AllocateIn(const std::vector<FunctionNames*>& functions, std::string_view name) const {
  const auto take = [&](const std::string& candidate) {
    if (IsLocalName(candidate) || IsStdintName(candidate) || taken_.contains(candidate)) return false;
    for (const FunctionNames* names : functions) {
      if (names->Has(candidate)) return false;
    }
    for (FunctionNames* names : functions) names->Take(candidate);
    return true;
  };
  const std::string candidate = SafeIdentifier(name);
  if (take(candidate)) return candidate;
  const std::string base = SafeIdentifier(candidate + "_local");
  if (take(base)) return base;
  uint32_t number = kFirstNumber;
  for (const FunctionNames* names : functions) number = std::max(number, names->FirstNumber(base));
  for (;; ++number) {
    std::string unique = SafeIdentifier(base + "_" + std::to_string(number));
    if (!take(unique)) continue;
    for (FunctionNames* names : functions) names->TakeNumber(base, number);
    return unique;
  }
}

}  // namespace plcxx::emit::legalize
