// Reads a reference grammar (grammars/*.ebnf, ISO 14977) and makes sentences of it, so that the grammar is executed.
//
// In: the text of a grammar. Out: its productions with the functions that read them (behind "->" in the comment of a
// production), what is wrong with it, random sentences as lists of terminals, and whether a list is a sentence. Not its
// job: parsing.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace plcxx::testing_support {

/// The same numbers on every machine.
class Numbers {
 public:
  explicit Numbers(uint64_t seed) : state_(seed * 2862933555777941757u + 3037000493u) {}
  uint64_t Below(uint64_t limit) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return (state_ >> 24) % limit;
  }
  bool OneIn(uint64_t count) { return Below(count) == 0; }

 private:
  uint64_t state_;
};

class Grammar {
 public:
  /// How long sentences get. What repeats does so once more unless one in so many says no; below `top` productions in
  /// one another whole parts of a program repeat; below `deep` each ends as soon as it can.
  struct Shape {
    uint32_t top = 4, deep = 30;
    uint64_t top_rounds = 10, rounds = 4;
  };

  /// Gives a text for what stands between question marks; "? 0 to 9 ?" needs none.
  using Special = std::function<std::string(const std::string& name, Numbers& numbers)>;

  explicit Grammar(std::string_view text) : rest_(text) {
    Skip();
    while (!rest_.empty() && problems_.empty()) ReadProduction();
    Link();
  }

  /// Undefined names, productions that nothing reaches, productions without a reader, syntax.
  std::vector<std::string> Problems() const { return problems_; }
  std::vector<std::string> Names() const { return names_; }
  /// Behind "->" in the comment of a production: the function that reads it; empty where none is named.
  const std::string& ReaderOf(const std::string& name) const { return productions_.at(name).reader; }

  /// The terminals of one sentence, in order.
  std::vector<std::string> Sentence(Numbers& numbers, const Special& special) const {
    return Sentence(numbers, special, Shape());
  }
  std::vector<std::string> Sentence(Numbers& numbers, const Special& special, const Shape& shape) const {
    std::vector<std::string> terminals;
    Expand(productions_.at(names_.front()).body, 0, shape, numbers, special, terminals);
    return terminals;
  }

  /// Whether a terminal is one that stands between question marks.
  using IsSpecial = std::function<bool(const std::string& name, const std::string& terminal)>;
  /// Whether this is a sentence; the grammar has no left recursion.
  bool Accepts(const std::vector<std::string>& terminals, const IsSpecial& is_special) const {
    Recognizer recognizer{.terminals = terminals, .is_special = is_special, .known = {}};
    return Ends(productions_.at(names_.front()).body, 0, recognizer).contains(terminals.size());
  }

 private:
  enum class Kind : uint8_t { kTerminal, kName, kSpecial, kSequence, kChoice, kOptional, kRepeat };
  struct Node {
    Kind kind = Kind::kSequence;
    std::string text;
    std::vector<Node> children;
  };
  struct Production {
    Node body;
    std::string reader;
    uint32_t depth = kInfinite;  // of the shortest sentence
  };
  static constexpr uint32_t kInfinite = 1'000'000;

  // Reading.
  static bool IsNameCharacter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  }
  void Skip() {
    while (true) {
      rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size()));
      if (!rest_.starts_with("(*")) return;
      const size_t end = std::min(rest_.find("*)"), rest_.size() - 2);
      comment_ = rest_.substr(2, end - 2);
      rest_.remove_prefix(end + 2);
      const size_t arrow = comment_.find("->");
      if (arrow != std::string::npos && !names_.empty()) productions_.at(names_.back()).reader = Word(arrow + 2);
    }
  }
  std::string Word(size_t from) const {
    const size_t begin = comment_.find_first_not_of(' ', from);
    if (begin == std::string::npos) return {};
    return comment_.substr(begin, comment_.find_first_of(" \n", begin) - begin);
  }
  bool Take(char c) {
    if (!rest_.starts_with(c)) return false;
    rest_.remove_prefix(1);
    Skip();
    return true;
  }
  void Expect(char c) {
    if (!Take(c) && problems_.empty()) {
      problems_.push_back(std::string("'") + c + "' expected in front of: " + std::string(rest_.substr(0, 40)));
    }
  }
  std::string TakeName() {
    const auto end = std::ranges::find_if_not(rest_, IsNameCharacter);
    std::string name(rest_.begin(), end);
    rest_.remove_prefix(name.size());
    Skip();
    return name;
  }
  void ReadProduction() {
    const std::string name = TakeName();
    if (name.empty() || productions_.contains(name)) {
      problems_.push_back("no new name in front of: " + std::string(rest_.substr(0, 40)));
      return;
    }
    Expect('=');
    Node body = ReadChoice();
    productions_[name] = {.body = std::move(body), .reader = {}};
    names_.push_back(name);
    Expect(';');  // the comment with the reader stands behind it
  }
  Node ReadChoice() {
    Node choice{.kind = Kind::kChoice, .text = {}, .children = {ReadSequence()}};
    while (Take('|')) choice.children.push_back(ReadSequence());
    return choice.children.size() == 1 ? std::move(choice.children.front()) : choice;
  }
  Node ReadSequence() {
    Node sequence{.kind = Kind::kSequence, .text = {}, .children = {ReadItem()}};
    while (Take(',')) sequence.children.push_back(ReadItem());
    return sequence.children.size() == 1 ? std::move(sequence.children.front()) : sequence;
  }
  Node ReadItem() {
    Node node;
    if (rest_.starts_with('"') || rest_.starts_with('\'') || rest_.starts_with('?')) {
      const char quote = rest_.front();
      const size_t end = std::min(rest_.find(quote, 1), rest_.size() - 1);
      std::string text(rest_.substr(1, end - 1));
      if (quote == '?') text = text.substr(1, text.size() - 2);
      node = {.kind = quote == '?' ? Kind::kSpecial : Kind::kTerminal, .text = std::move(text), .children = {}};
      rest_.remove_prefix(end + 1);
      Skip();
      return node;
    }
    if (Take('(')) {
      node = ReadChoice();
      Expect(')');
    } else if (Take('[')) {
      node = {.kind = Kind::kOptional, .text = {}, .children = {ReadChoice()}};
      Expect(']');
    } else if (Take('{')) {
      node = {.kind = Kind::kRepeat, .text = {}, .children = {ReadChoice()}};
      Expect('}');
    } else {
      node = {.kind = Kind::kName, .text = TakeName(), .children = {}};
      if (node.text.empty() && problems_.empty()) {
        problems_.push_back("no symbol in front of: " + std::string(rest_.substr(0, 40)));
      }
    }
    return node;
  }

  // Checking.
  void Link() {
    if (!problems_.empty() || names_.empty()) return;
    std::set<std::string> reached;
    Reach(names_.front(), reached);
    for (const std::string& name : names_) {
      if (!reached.contains(name)) problems_.push_back("nothing reaches " + name);
      if (productions_.at(name).reader.empty()) problems_.push_back("no reader of " + name);
    }
    for (bool changed = true; changed;) {
      changed = false;
      for (auto& [name, production] : productions_) {
        const uint32_t depth = std::min(kInfinite, DepthOf(production.body) + 1);
        changed |= depth < production.depth;
        production.depth = std::min(production.depth, depth);
      }
    }
    for (const auto& [name, production] : productions_) {
      if (production.depth == kInfinite) problems_.push_back(name + " never ends");
    }
  }
  void Reach(const std::string& name, std::set<std::string>& reached) {
    if (!reached.insert(name).second) return;
    const auto production = productions_.find(name);
    if (production == productions_.end()) {
      problems_.push_back(name + " is not defined");
    } else {
      ReachFrom(production->second.body, reached);
    }
  }
  void ReachFrom(const Node& node, std::set<std::string>& reached) {
    if (node.kind == Kind::kName) Reach(node.text, reached);
    for (const Node& child : node.children) ReachFrom(child, reached);
  }
  uint32_t DepthOf(const Node& node) const {
    uint32_t depth = node.kind == Kind::kChoice ? kInfinite : 0;
    switch (node.kind) {
      case Kind::kTerminal:
      case Kind::kSpecial:
      case Kind::kOptional:
      case Kind::kRepeat:
        return 0;
      case Kind::kName: {
        const auto production = productions_.find(node.text);
        return production == productions_.end() ? 0 : production->second.depth;
      }
      case Kind::kSequence:
        for (const Node& child : node.children) depth = std::max(depth, DepthOf(child));
        return depth;
      case Kind::kChoice:
        for (const Node& child : node.children) depth = std::min(depth, DepthOf(child));
        return depth;
    }
    return depth;
  }

  // Recognizing.
  struct Recognizer {
    const std::vector<std::string>& terminals;
    const IsSpecial& is_special;
    std::map<std::pair<const Node*, size_t>, std::set<size_t>> known;
  };
  /// Where the node can end that begins in front of a terminal.
  const std::set<size_t>& Ends(const Node& node, size_t at, Recognizer& recognizer) const {
    const auto key = std::pair(&node, at);
    if (const auto found = recognizer.known.find(key); found != recognizer.known.end()) return found->second;
    std::set<size_t> ends;
    const bool more = at < recognizer.terminals.size();
    switch (node.kind) {
      case Kind::kTerminal:
        if (more && recognizer.terminals[at] == node.text) ends.insert(at + 1);
        break;
      case Kind::kSpecial:
        if (more && recognizer.is_special(node.text, recognizer.terminals[at])) ends.insert(at + 1);
        break;
      case Kind::kName:
        ends = Ends(productions_.at(node.text).body, at, recognizer);
        break;
      case Kind::kSequence:
        ends.insert(at);
        for (const Node& child : node.children) {
          std::set<size_t> next;
          for (const size_t end : ends) next.merge(std::set(Ends(child, end, recognizer)));
          ends = std::move(next);
        }
        break;
      case Kind::kOptional:
      case Kind::kRepeat: {
        std::vector<size_t> open{at};
        ends.insert(at);
        while (!open.empty()) {
          const size_t from = open.back();
          open.pop_back();
          for (const size_t end : Ends(node.children.front(), from, recognizer)) {
            if (ends.insert(end).second && node.kind == Kind::kRepeat) open.push_back(end);
          }
        }
        break;
      }
      case Kind::kChoice:
        for (const Node& child : node.children) ends.merge(std::set(Ends(child, at, recognizer)));
        break;
    }
    return recognizer.known[key] = std::move(ends);
  }

  // Making sentences.
  static std::string NumberIn(const std::string& range, Numbers& numbers) {
    const size_t to = range.find(" to ");
    const int64_t low = std::stoll(range.substr(0, to)), high = std::stoll(range.substr(to + 4));
    // The limits more often than their share.
    if (numbers.OneIn(8)) return std::to_string(low);
    if (numbers.OneIn(8)) return std::to_string(high);
    return std::to_string(low + static_cast<int64_t>(numbers.Below(static_cast<uint64_t>(high - low) + 1)));
  }
  void Expand(const Node& node, uint32_t depth, const Shape& shape, Numbers& numbers, const Special& special,
              std::vector<std::string>& terminals) const {
    const bool deep = depth > shape.deep;
    switch (node.kind) {
      case Kind::kTerminal:
        terminals.push_back(node.text);
        return;
      case Kind::kSpecial:
        terminals.push_back(node.text.find(" to ") != std::string::npos ? NumberIn(node.text, numbers)
                                                                        : special(node.text, numbers));
        return;
      case Kind::kName:
        return Expand(productions_.at(node.text).body, depth + 1, shape, numbers, special, terminals);
      case Kind::kSequence:
        for (const Node& child : node.children) Expand(child, depth, shape, numbers, special, terminals);
        return;
      case Kind::kOptional:
        if (!deep && numbers.OneIn(3)) Expand(node.children.front(), depth, shape, numbers, special, terminals);
        return;
      case Kind::kRepeat:
        while (!deep && !numbers.OneIn(depth < shape.top ? shape.top_rounds : shape.rounds))
          Expand(node.children.front(), depth, shape, numbers, special, terminals);
        return;
      case Kind::kChoice: {
        const Node* chosen = &node.children[numbers.Below(node.children.size())];
        if (deep) {
          chosen = &*std::ranges::min_element(node.children, {}, [this](const Node& child) { return DepthOf(child); });
        }
        return Expand(*chosen, depth, shape, numbers, special, terminals);
      }
    }
  }

  std::string_view rest_;
  std::string comment_;
  std::map<std::string, Production> productions_;
  std::vector<std::string> names_;  // in the order of the text
  std::vector<std::string> problems_;
};

inline std::string Contents(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The sources of a dialect that make words and trees, where the functions that read a production are.
inline std::string FrontEndOf(const std::string& dialect) {
  std::string text;
  for (const char* const room : {"source", "parser"}) {
    const std::filesystem::path folder = std::filesystem::path(PLCXX_ROOT) / "transpiler/dialects" / dialect / room;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() == ".cc") text += Contents(entry.path());
    }
  }
  return text;
}

/// grammars/<name>.ebnf of the repository.
inline Grammar GrammarOf(const std::string& name) {
  return Grammar(Contents(std::filesystem::path(PLCXX_ROOT) / "grammars" / (name + ".ebnf")));
}

}  // namespace plcxx::testing_support
