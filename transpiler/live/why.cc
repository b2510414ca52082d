#include "transpiler/live/why.h"

#include <memory>
#include <utility>

#include "transpiler/explanation/recorder.h"
#include "transpiler/scenarios/why.h"

namespace plcxx::live {
namespace {

constexpr size_t kMaxLines = 40;
/// Periods that are repeated at least, where there are so many: what was kept is followed back in them.
constexpr uint64_t kRepeated = 64;

}  // namespace

Reasons WhyNow(Session& session, const std::string& name) {
  const compilation::Compilation& compilation = session.compilation();
  const auto found = session.Find(name);
  if (const auto* refusal = std::get_if<std::string>(&found)) return {{}, *refusal};
  const auto& location = std::get<dialects::Location>(found);
  if (std::string why = scenarios::CannotBeExplained(compilation, location); !why.empty()) return {{}, why};
  for (const bool off : session.timeline().machine().off()) {
    if (off) return {{}, "statements are switched off: switch them on to ask why"};
  }
  if (session.timeline().period() == session.timeline().first()) return {{}, "nothing has run yet"};
  const scenarios::WhyQuestion question{.name = name, .location = location, .steps = {}, .time_ms = {}};
  const scenarios::WhyAnswer answer =
      scenarios::ExplainInRun(compilation, question,
                              [&](std::unique_ptr<explanation::Recorder> recorder,
                                  const std::function<void()>& look) -> std::optional<std::string> {
                                Machine copy(compilation, std::move(recorder));
                                session.timeline().RepeatOn(copy, kRepeated);
                                look();
                                return std::nullopt;
                              });
  if (!answer.refusal.empty()) return {{}, answer.refusal};
  return {scenarios::WhyText(answer, question, compilation, kMaxLines), {}};
}

}  // namespace plcxx::live
