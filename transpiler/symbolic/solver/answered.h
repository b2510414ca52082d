// What has been found out about terms of a form (form.h): programs do the same with many timers, and one of them is
// asked about.
//
// Kept beyond one question and one Terms; only of questions where nothing was assumed.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>

#include "transpiler/symbolic/solver/solver.h"

namespace plcxx::solver {

struct Answered {
  Answer answer = Answer::kUnknown;
  uint32_t milliseconds = 0;      // how much effort was made; less than asked for where a deadline was near
  bool has_tried_values = false;  // before a solver was asked

  /// Whether nothing more is found out in such a time.
  bool Settles(uint32_t time) const { return answer != Answer::kUnknown || time <= milliseconds; }
};

class AnsweredForms {
 public:
  AnsweredForms() = default;
  /// Begins with what `before` knows; that outlives this one and is not changed meanwhile.
  explicit AnsweredForms(const AnsweredForms* before) : before_(before) {}

  Answered& operator[](const std::string& form) {
    const auto [at, is_new] = own_.try_emplace(form);
    for (const AnsweredForms* known = before_; is_new && known != nullptr; known = known->before_) {
      const auto found = known->own_.find(form);
      if (found == known->own_.end()) continue;
      at->second = found->second;
      break;
    }
    return at->second;
  }

 private:
  std::unordered_map<std::string, Answered> own_;  // looked up only
  const AnsweredForms* before_ = nullptr;
};

}  // namespace plcxx::solver
