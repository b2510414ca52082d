#include "transpiler/report/routine_title.h"

#include <algorithm>

namespace plcxx::report {

std::string RoutineTitle(const ir::Routine& routine) {
  std::string title = routine.name + (routine.comment.empty() ? "" : ": " + routine.comment);
  std::ranges::replace(title, '\n', ' ');
  return title;
}

}  // namespace plcxx::report
