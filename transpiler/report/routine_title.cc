#include "transpiler/report/routine_title.h"

#include <algorithm>

namespace plcxx::report {

std::string RoutineTitle(const ir::Routine& routine) {
  // What is in front of an empty line is about the file.
  const size_t file_end = routine.comment.find("\n\n");
  const std::string comment = file_end == std::string::npos ? routine.comment : routine.comment.substr(file_end + 2);
  std::string title = routine.name + (comment.empty() ? "" : ": " + comment);
  std::ranges::replace(title, '\n', ' ');
  return title;
}

}  // namespace plcxx::report
