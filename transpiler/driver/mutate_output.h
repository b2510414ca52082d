// What plcxx mutate says of a program: in text, and for machines.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "transpiler/compilation/compilation.h"
#include "transpiler/mutate/mutate.h"

namespace plcxx::driver {

inline constexpr unsigned kPercent = 100;

/// How many changes have an outcome.
size_t CountOf(const mutate::Mutated& mutated, mutate::Outcome outcome);

/// For people: how much was noticed, then by statement what was not.
std::string MutateText(const mutate::Mutated& mutated, const compilation::Compilation& compilation, size_t scenarios);
/// Every change with its place and outcome.
nlohmann::json MutateJson(const mutate::Mutated& mutated, const compilation::Compilation& compilation,
                          size_t scenarios);

}  // namespace plcxx::driver
