// What the operator does to the machine, and what he asks to be told of.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transpiler/live/session.h"

namespace plcxx::live {

Refusal Set(Session& session, const std::string& name, const std::string& value);
Refusal Toggle(Session& session, const std::string& name);
Refusal Force(Session& session, const std::string& name, const std::string& value);
Refusal Release(Session& session, const std::string& name);
Refusal ReleaseAll(Session& session);
Refusal SwitchStatement(Session& session, ir::StatementId statement, bool on);
Refusal SwitchAllOn(Session& session);
/// Between two periods: what is so now becomes an expectation of the recording.
Refusal Expect(Session& session, const std::vector<std::string>& names);
Refusal ExpectMessages(Session& session);
/// Numbers and texts of those that the program shows now.
std::vector<std::string> ActiveMessages(Session& session);

Refusal BreakAtChange(Session& session, const std::string& name);
Refusal BreakAtCondition(Session& session, const std::string& text);

Refusal Watch(Session& session, const std::string& name);
Refusal Unwatch(Session& session, size_t number);
Refusal Arm(Session& session, const TriggerWish& wish);

}  // namespace plcxx::live
