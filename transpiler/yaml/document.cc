#include "transpiler/yaml/document.h"

#include <yaml-cpp/eventhandler.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <sstream>
#include <system_error>

#include "transpiler/source/near_file.h"
#include "transpiler/support/byte_order_mark.h"
#include "transpiler/support/read_file.h"
#include "transpiler/support/system_words.h"
#include "transpiler/yaml/missing_values.h"

namespace plcxx::yaml {
namespace {

/// Each takes some 800 bytes of memory, and a line of commas is as many as it is long.
constexpr uint32_t kMostValues = 400'000;

Place PlaceAt(const YAML::Mark& mark) {
  return {static_cast<uint32_t>(mark.line + 1), static_cast<uint32_t>(mark.column + 1)};
}

/// Thrown through the parser, which cannot be told to stop.
struct TooManyValues {
  Place mark;
};

/// Where the documents of a stream begin. The parser gives documents without end for some texts, such as ",", as it
/// does not move on at what begins none; so nobody asks it for more than two.
struct Documents : YAML::EventHandler {
  std::optional<Place> first, second;
  uint32_t values = 0;

  void Count(const YAML::Mark& mark) {
    if (++values > kMostValues) throw TooManyValues{PlaceAt(mark)};
  }
  void OnDocumentStart(const YAML::Mark& mark) override { (first ? second : first) = PlaceAt(mark); }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override { Count(mark); }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override { Count(mark); }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t, const std::string&) override {
    Count(mark);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {
    Count(mark);
  }
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {
    Count(mark);
  }
  void OnMapEnd() override {}
};

Documents FirstDocuments(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  Documents documents;
  if (parser.HandleNextDocument(documents)) parser.HandleNextDocument(documents);
  return documents;
}

/// Why a text does not end where its first document does; JSON's habit of a last comma is told as what it is.
std::string WhyNotTwo(const std::string& text, Place second) {
  std::istringstream lines(text);
  std::string line;
  for (uint32_t i = 0; i < second.line; ++i) std::getline(lines, line);
  const size_t at = line.find_first_not_of(" \t", second.column - 1);
  if (at != std::string::npos && std::string_view(",]}").find(line[at]) != std::string_view::npos) {
    return std::string("not YAML: '") + line[at] + "' belongs to no list and no map: delete it";
  }
  return "the file holds more than one YAML document";
}

/// Names of locations with signs that YAML takes for its own: Y[0], %I0, !LAMP. After its message, or nothing.
std::string QuotesMissing(const std::string& text, uint32_t number) {
  std::istringstream lines(text);
  std::string line;
  for (uint32_t i = 0; i < number; ++i) std::getline(lines, line);
  if (const size_t tab = line.find_first_not_of(' '); tab != std::string::npos && line[tab] == '\t') {
    return "; indent with blanks, not with tabs";
  }
  const auto is_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  bool quoted = false;
  for (size_t at = 0; at < line.size(); ++at) {
    if (line[at] == '"' || line[at] == '\'') quoted = !quoted;
    if (quoted || line[at] == '#') continue;
    const bool begins = at > 0 && std::string_view(" {[,").find(line[at - 1]) != std::string_view::npos;
    const bool sign = begins && (line[at] == '%' || line[at] == '@' || line[at] == '!');
    const bool bracket = at > 0 && line[at] == '[' && is_word(line[at - 1]);
    if (!sign && !bracket) continue;
    size_t first = at, last = at;
    while (bracket && first > 0 && is_word(line[first - 1])) --first;
    while (last + 1 < line.size() && (is_word(line[last + 1]) || line[last + 1] == ']' || line[last + 1] == '.'))
      ++last;
    return "; write names with such signs in quotes: \"" + line.substr(first, last + 1 - first) + "\"";
  }
  return {};
}

/// "- run: ms: 10", a map in the line of another one: how that is written. After the parser's message, or nothing.
std::string BracesMissing(const std::string& text, uint32_t number) {
  std::istringstream lines(text);
  std::string line;
  for (uint32_t i = 0; i < number; ++i) std::getline(lines, line);
  constexpr std::string_view kColon = ": ";
  const size_t first = line.find(kColon);
  const size_t second = first == std::string::npos ? first : line.find(kColon, first + 1);
  if (second == std::string::npos || line.find_first_of("{[\"'#") != std::string::npos) return {};
  const size_t key = line.find_first_not_of(" -");
  return "; a map in a line of another one stands in braces: '" + line.substr(key, first - key) + ": {" +
         line.substr(first + kColon.size()) + "}'";
}

/// Of 16 or 32 bits a character, which the parser reads.
bool IsWide(const std::string& text) {
  return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF") ||
         (text.size() > 1 && (text[0] == '\0' || text[1] == '\0'));
}

/// The parser takes 0 and 4 for the end of what it reads, and tells something else then. Wide texts have zeros.
std::optional<Place> EndWithin(const std::string& text) {
  const size_t at = IsWide(text) ? std::string::npos : text.find_first_of(std::string_view("\0\4", 2));
  if (at == std::string::npos) return std::nullopt;
  const size_t line = text.rfind('\n', at);
  return Place{
      static_cast<uint32_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n') + 1),
      static_cast<uint32_t>(line == std::string::npos ? at + 1 : at - line)};
}

/// `error`: of the system; 0: it says nothing.
Fault CannotBeRead(int error) {
  const std::string why = error == 0 ? "" : ": " + support::SystemWords(error);
  return {{}, "the file cannot be read" + why + "; check the path and the rights"};
}

}  // namespace

std::variant<YAML::Node, Fault> Load(const std::string& text) {
  if (const std::optional<Place> end = EndWithin(text)) {
    return Fault{*end, "not YAML: a byte with the value 0 or 4: the file is no text, or it is damaged"};
  }
  try {
    const Documents documents = FirstDocuments(text);
    if (documents.second) return Fault{*documents.second, WhyNotTwo(text, *documents.second)};
    YAML::Node root = YAML::Load(text);
    if (!IsWide(text)) PlaceMissingValues(root, text);
    return root;
  } catch (const TooManyValues& fault) {
    return Fault{fault.mark, "more than " + std::to_string(kMostValues) + " values: divide the file"};
  } catch (const YAML::Exception& fault) {
    const bool placed = !fault.mark.is_null();
    const auto line = static_cast<uint32_t>(placed ? fault.mark.line + 1 : 0);
    const auto column = static_cast<uint32_t>(placed ? fault.mark.column + 1 : 0);
    return Fault{{line, column}, "not YAML: " + fault.msg + QuotesMissing(text, line) + BracesMissing(text, line)};
  }
}

std::variant<std::string, Fault> ReadText(const std::string& path, size_t most, std::string_view what) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (error && status.type() != std::filesystem::file_type::not_found) return CannotBeRead(error.value());
  if (!std::filesystem::exists(status)) return Fault{{}, "there is no such file" + source::DidYouMeanFile(path)};
  if (std::filesystem::is_directory(status))
    return Fault{{}, "a directory: name the file in it that is the " + std::string(what)};
  if (!std::filesystem::is_regular_file(status)) return Fault{{}, "not a file, but a device or a pipe"};
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  if (!error && bytes > most) {
    constexpr int kMega = 20;  // bits
    return Fault{{}, "the file is larger than " + std::to_string(most >> kMega) + " MB: not a " + std::string(what)};
  }
  errno = 0;
  std::optional<std::string> text = support::ReadFile(path);
  if (!text) return CannotBeRead(errno);
  support::RemoveByteOrderMark(*text);
  return *std::move(text);
}

}  // namespace plcxx::yaml
