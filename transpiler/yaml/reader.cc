#include "transpiler/yaml/reader.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <system_error>

#include "transpiler/diagnostics/terminal_text.h"
#include "transpiler/support/listed.h"
#include "transpiler/support/near_words.h"

namespace plcxx::yaml {

namespace {

/// The lines of a message that are its own are indented. A line's end before anything else is of a word that the file
/// has, and begins no line.
std::string MessageLines(std::string_view message) {
  std::string text;
  for (size_t begin = 0;;) {
    const size_t end = message.find("\n  ", begin);
    text += diag::Escaped(message.substr(begin, end - begin));
    if (end == std::string_view::npos) return text;
    text += '\n';
    begin = end + 1;
  }
}

}  // namespace

std::string ToText(const Error& error) {
  std::string text = diag::Escaped(error.path) + ":";
  if (error.mark.line != 0) text += std::to_string(error.mark.line) + ":" + std::to_string(error.mark.column) + ":";
  text += " " + MessageLines(error.message);
  if (!error.remedy.empty()) text += "\n  help: " + MessageLines(error.remedy);
  return text;
}

void Reader::Fail(Place mark, std::string message, std::string remedy) {
  errors_.push_back({path_, mark, std::move(message), std::move(remedy)});
}

Place Reader::Mark(const YAML::Node& node) {
  const YAML::Mark mark = node.Mark();
  return {static_cast<uint32_t>(mark.line + 1), static_cast<uint32_t>(mark.column + 1)};
}

std::vector<Entry> Reader::Map(const YAML::Node& node, std::string_view what) {
  std::vector<Entry> entries;
  if (!node.IsMap()) {
    Fail(Mark(node), std::string(what) + " is a map '{key: value}'");
    return entries;
  }
  for (const auto& pair : node) {
    const std::optional<MarkedText> key = Word(pair.first, "a key");
    if (!key) continue;
    const bool twice =
        std::any_of(entries.begin(), entries.end(), [&](const Entry& e) { return e.key.text == key->text; });
    if (twice)
      Fail(key->mark, "'" + key->text + "' is given twice");
    else
      entries.push_back({*key, pair.second});
  }
  return entries;
}

std::vector<YAML::Node> Reader::ListOrSingle(const YAML::Node& node) {
  if (!node.IsSequence()) return {node};
  return {node.begin(), node.end()};
}

std::optional<MarkedText> Reader::Word(const YAML::Node& node, std::string_view what) {
  if (words_left_ == 0) return std::nullopt;
  if (--words_left_ == 0) {
    Fail(Mark(node), "the file says too much: aliases repeat it", "write less, or without '*'");
    return std::nullopt;
  }
  if (node.IsScalar()) return MarkedText{node.Scalar(), Mark(node)};
  if (node.IsNull()) {
    Fail(Mark(node), std::string(what) + " is missing", "write it behind its key, a colon and a blank: 'KEY: 1'");
  } else {
    Fail(Mark(node), std::string(what) + " is a single word or number");
  }
  return std::nullopt;
}

std::optional<uint32_t> Reader::Number(const YAML::Node& node, std::string_view what) {
  const std::optional<MarkedText> word = Word(node, what);
  if (!word) return std::nullopt;
  uint32_t number = 0;
  const char* end = word->text.data() + word->text.size();
  const auto [last, error] = std::from_chars(word->text.data(), end, number);
  if (error == std::errc() && last == end) return number;
  Fail(word->mark, "'" + word->text + "': " + std::string(what) + " is a whole number from 0 to " +
                       std::to_string(std::numeric_limits<uint32_t>::max()));
  return std::nullopt;
}

std::vector<MarkedText> Reader::MarkedWords(const YAML::Node& node, std::string_view what) {
  std::vector<MarkedText> words;
  for (const YAML::Node& item : ListOrSingle(node)) {
    if (std::optional<MarkedText> word = Word(item, what)) words.push_back(std::move(*word));
  }
  return words;
}

std::vector<std::string> Reader::Words(const YAML::Node& node, std::string_view what) {
  std::vector<std::string> words;
  for (MarkedText& word : MarkedWords(node, what)) words.push_back(std::move(word.text));
  return words;
}

void Reader::RefuseKey(const MarkedText& key, std::string_view where, std::span<const std::string_view> known) {
  const std::string_view near = support::NearestWord(key.text, known);
  Fail(key.mark,
       "'" + key.text + "' is no key of " + std::string(where) + "; there are: " + support::CommaSeparated(known),
       near.empty() ? "" : "did you mean '" + std::string(near) + "'");
}

}  // namespace plcxx::yaml
