#include "transpiler/driver/command_word.h"

#include <algorithm>
#include <string_view>

#include "transpiler/support/near_words.h"

namespace plcxx::driver {
namespace {

constexpr size_t kLongestWord = 40;  // of what may be a command written wrongly

bool IsCommand(const CLI::App& app, const std::string& word) {
  const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
  return std::ranges::any_of(commands, [&](const CLI::App* command) { return command->get_name() == word; });
}

std::vector<std::string> LongNames(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

}  // namespace

std::string OptionsInFront(const CLI::App& app, const std::vector<std::string>& words) {
  if (words.empty() || !words.front().starts_with('-')) return {};
  const std::string name = words.front().substr(0, words.front().find('='));
  if (name == "-" || app.get_option_no_throw(name) != nullptr) return {};
  const auto command = std::ranges::find_if(words, [&](const std::string& word) { return IsCommand(app, word); });
  if (command == words.end()) {
    const std::vector<std::string> names = LongNames(app);
    const std::string_view near = support::NearestWord(name, std::vector<std::string_view>(names.begin(), names.end()));
    return "'" + name + "' is no option of plcxx itself" +
           (near.empty() ? "; the command comes first" : ", did you mean '" + std::string(near) + "'");
  }
  std::string right = *command;
  for (auto word = words.begin(); word != words.end(); ++word)
    if (word != command) right += " " + *word;
  return "the command comes first, its options after it: plcxx " + right;
}

std::string TakeHelpWord(const CLI::App& app, std::vector<std::string>& words) {
  if (words.empty() || words.front().starts_with('-')) return {};
  if (words.front() == "help") {
    words.erase(words.begin());
    words.emplace_back("--help");
    if (words.size() == 1) return {};
  }
  const std::string& word = words.front();
  std::string nearest;
  constexpr size_t kFar = 3;
  size_t distance = kFar;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == word) return {};
    const size_t found = support::EditDistance(word.substr(0, kLongestWord), command->get_name());
    if (found < distance) {
      distance = found;
      nearest = command->get_name();
    }
  }
  return "unknown command '" + word + "'" + (nearest.empty() ? "" : "; did you mean '" + nearest + "'?");
}

std::string DidYouMeanOption(const CLI::App& app, const CLI::App& command, const std::vector<std::string>& words) {
  const std::vector<std::string> names = LongNames(command);
  const std::vector<std::string_view> views(names.begin(), names.end());
  for (const std::string& word : words) {
    const std::string name = word.substr(0, word.find('='));
    if (!name.starts_with("--") || name.size() > kLongestWord || std::ranges::find(names, name) != names.end())
      continue;
    const std::string_view near = support::NearestWord(name, views);
    if (!near.empty()) return ", did you mean '" + std::string(near) + "'";
    std::string others;
    for (const CLI::App* other : app.get_subcommands([](const CLI::App*) { return true; })) {
      const std::vector<std::string> own = LongNames(*other);
      if (std::ranges::find(own, name) != own.end()) others += (others.empty() ? "" : ", ") + other->get_name();
    }
    return others.empty() ? std::string() : "; it is an option of: " + others;
  }
  return {};
}

std::string UsageProblem(const CLI::ParseError& error) {
  std::string text = error.what();
  if (text == "A subcommand is required") return "a command is missing";
  constexpr std::string_view kTooOften = ": At Most 1 required but received ";
  if (const size_t at = text.find(kTooOften); at != std::string::npos)
    return text.substr(0, at) + " is given " + text.substr(at + kTooOften.size()) + " times: write it once";
  // Its sentences begin with capitals, behind the name of an option, too; what is all in capitals is a word of ours.
  const auto lower = [&text](size_t at) {
    const auto is = [&text](size_t i, char first, char last) {
      return i < text.size() && text[i] >= first && text[i] <= last;
    };
    if (is(at, 'A', 'Z') && is(at + 1, 'a', 'z')) text[at] = static_cast<char>(text[at] - 'A' + 'a');
  };
  lower(0);
  if (const size_t colon = text.find(": "); text.starts_with('-') && colon != std::string::npos) lower(colon + 2);
  return text;
}

std::string EmptyValue(const CLI::App& app) {
  for (const CLI::App* command : app.get_subcommands()) {
    for (const CLI::Option* option : command->get_options()) {
      const std::vector<std::string>& values = option->results();
      const bool is_text = option->get_type_name() == "TEXT";  // words that are looked for: none are any
      if ((is_text && !option->get_positional()) || std::ranges::find(values, std::string()) == values.end()) continue;
      const bool is_argument = option->get_positional();
      return "'" + option->get_name(is_argument) +
             (is_argument ? "' is given an empty word: write one, or leave it out"
                          : "' is given an empty value: write one behind it, or leave it out");
    }
  }
  return {};
}

}  // namespace plcxx::driver
