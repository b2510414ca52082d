// How the runs of a diff are told on one page: each one once, others by what they add to it.
//
// In: the groups in the order in which they stand on the page. Out: a line for each run. Not its job: which runs are
// shown, how lines are set.
#pragma once

#include <string>
#include <vector>

#include "transpiler/review/diff/groups.h"

namespace plcxx::driver {

class ToldRuns {
 public:
  std::vector<std::string> Of(const review::diff::DiffGroup& group);

 private:
  struct Told {
    std::string steps, name;
  };

  std::string StepsOf(const review::diff::Counterexample& example, const std::string& name);

  std::vector<Told> told_;
  size_t of_this_group_ = 0;  // told_ from here on
};

}  // namespace plcxx::driver
