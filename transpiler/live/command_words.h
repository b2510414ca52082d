// The words of a command of the page: JSON from outside, of which nothing is believed.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "transpiler/live/session.h"

namespace plcxx::live {

inline constexpr size_t kMostText = 4096;  // bytes of a word of a command

/// The words of a command; the first that is not as it should be is noted.
class Words {
 public:
  explicit Words(const nlohmann::ordered_json& command) : command_(command) {}

  std::string Text(const char* key) {
    const auto found = command_.find(key);
    if (found == command_.end() || !found->is_string()) {
      return Fail<std::string>(key, "a text");
    }
    const auto& text = found->get_ref<const std::string&>();
    if (text.size() > kMostText || text.find('\0') != std::string::npos) return Fail<std::string>(key, "a short text");
    return text;
  }
  uint64_t Number(const char* key, uint64_t most) {
    const auto found = command_.find(key);
    if (found == command_.end() || !found->is_number_unsigned() || found->get<uint64_t>() > most) {
      return Fail<uint64_t>(key, "a number from 0 to " + std::to_string(most));
    }
    return found->get<uint64_t>();
  }
  double Real(const char* key) {
    const auto found = command_.find(key);
    if (found == command_.end() || !found->is_number()) return Fail<double>(key, "a number");
    return found->get<double>();
  }
  bool Truth(const char* key) {
    const auto found = command_.find(key);
    if (found == command_.end() || !found->is_boolean()) return Fail<bool>(key, "true or false");
    return found->get<bool>();
  }
  std::vector<std::string> Texts(const char* key, size_t most) {
    const auto found = command_.find(key);
    std::vector<std::string> texts;
    if (found == command_.end() || !found->is_array() || found->size() > most) {
      return Fail<std::vector<std::string>>(key, "a list of at most " + std::to_string(most) + " texts");
    }
    for (const nlohmann::ordered_json& item : *found) {
      if (!item.is_string() || item.get_ref<const std::string&>().size() > kMostText) {
        return Fail<std::vector<std::string>>(key, "a list of texts");
      }
      texts.push_back(item.get<std::string>());
    }
    return texts;
  }
  const std::string& wrong() const { return wrong_; }
  /// What the command does when all its words are as they should be; else which is not.
  template <class Action>
  Refusal IfRight(const Action& action) const {
    return wrong_.empty() ? action() : wrong_;
  }

 private:
  template <class T>
  T Fail(const char* key, const std::string& what) {
    if (wrong_.empty()) wrong_ = "'" + std::string(key) + "' of the command is " + what;
    return T{};
  }
  const nlohmann::ordered_json& command_;
  std::string wrong_;
};

/// What the page asks of the trigger.
inline TriggerWish TriggerWishOf(Words& words) {
  constexpr uint64_t kMost = 3'600'000;
  return {.edge = words.Text("edge"),
          .text = words.Text("text"),
          .base_ms = static_cast<uint32_t>(words.Number("baseMs", kMost)),
          .delay_ms = static_cast<uint32_t>(words.Number("delayMs", kMost)),
          .samples = static_cast<uint32_t>(words.Number("samples", kMost)),
          .before_percent = static_cast<uint32_t>(words.Number("before", 100))};
}

}  // namespace plcxx::live
