// Numbers between commas, and variables: what the parts of a project are made of.

#include <charconv>
#include <limits>

#include "transpiler/dialects/classicladder/parser/internal.h"

namespace plcxx::classicladder {
namespace {

constexpr std::string_view kBlanks = " \t";

bool ToNumber(std::string_view text, int32_t& into) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), into);
  return error == std::errc() && end == text.data() + text.size() && !text.empty();
}

}  // namespace

std::vector<Field> Parser::FieldsOf(std::string_view text, source::Range range) {
  std::vector<Field> fields;
  for (size_t begin = 0; begin <= text.size();) {
    const size_t end = std::min(text.find(',', begin), text.size());
    size_t first = begin, last = end;
    while (first < last && kBlanks.find(text[first]) != std::string_view::npos) ++first;
    while (last > first && kBlanks.find(text[last - 1]) != std::string_view::npos) --last;
    const auto place = [&](size_t at) { return range.begin + static_cast<source::Offset>(at); };
    fields.push_back({text.substr(first, last - first), {place(first), place(last)}});
    begin = end + 1;
  }
  return fields;
}

bool Parser::HasFields(const std::vector<Field>& fields, size_t count, const Line& line, std::string_view names) {
  if (fields.size() == count) return true;
  diagnostics_.Report(line.range, diag::ClassicladderFields, static_cast<int64_t>(fields.size()),
                      std::to_string(count) + ", " + std::string(names));
  return false;
}

bool Parser::ReadNumber(const Field& field, std::string_view what, int32_t& into) {
  if (ToNumber(field.text, into)) return true;
  diagnostics_.Report(field.range, diag::ClassicladderNumber, field.text, what);
  return false;
}

bool Parser::ReadNumberIn(const Field& field, std::string_view what, int32_t low, int32_t high, int32_t& into) {
  int32_t value = 0;
  if (!ReadNumber(field, what, value)) return false;
  if (value >= low && value <= high) {
    into = value;
    return true;
  }
  diagnostics_.Report(field.range, diag::ClassicladderRange, what, field.text, std::to_string(low),
                      std::to_string(high));
  return false;
}

bool Parser::ReadIndex(const Field& field, std::string_view what, uint32_t count, uint32_t& into) {
  int32_t value = 0;
  if (!ReadNumberIn(field, what, 0, static_cast<int32_t>(count) - 1, value)) return false;
  into = static_cast<uint32_t>(value);
  return true;
}

bool Parser::ReadVariable(std::string_view text, source::Range range, Address& into) {
  const size_t slash = text.find('/');
  int32_t type = 0, number = 0;
  if (slash == std::string_view::npos || !ToNumber(text.substr(0, slash), type) ||
      !ToNumber(text.substr(slash + 1), number) || number < 0) {
    diagnostics_.Report(range, diag::ClassicladderNumber, text, "a variable, type/number,");
    return false;
  }
  const auto kind = type < 0 ? std::nullopt : VariableByNumber(static_cast<uint32_t>(type), program_.sizes.version);
  if (!kind) {
    diagnostics_.Report(range, diag::ClassicladderVariableType, std::to_string(type));
    return false;
  }
  into = {*kind, static_cast<uint32_t>(number)};
  return true;
}

}  // namespace plcxx::classicladder
