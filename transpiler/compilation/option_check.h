// One option of a dialect, looked at before anything is read: for files that name options, at the place where they do.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/dialect.h"

namespace plcxx::compilation {

/// The name of an option in the dialect's own letters; as it is when the dialect has none such.
std::string OptionName(const dialects::Dialect& dialect, const std::string& name);

/// Puts the option behind those that are there: its value replaces that of the same one, and of those that are a part
/// of it.
void SetOption(const dialects::Dialect& dialect, const std::string& name, const std::string& value,
               std::map<std::string, std::string>& options);

/// What is wrong with an option by itself: an unknown name, or a value that it does not take. Values that do not fit
/// together are not: the others may be named elsewhere.
std::vector<diag::Diagnostic> CheckOption(const dialects::Dialect& dialect, const std::string& name,
                                          const std::string& value);

/// "trusted" or "checked", of the option kFactsOption; anything else is reported, and is trusted.
ir::Facts ReadFacts(const std::string& value, diag::Engine& diagnostics);

}  // namespace plcxx::compilation
