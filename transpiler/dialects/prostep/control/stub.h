// A simulated control for dialect prostep (specification 8.1): ports, a store of NC variables, and with --plc-axes the
// PLC axes of 8.7. Otherwise nothing plays the NC but the steps of a scenario (D75).
#pragma once

#include <map>
#include <memory>
#include <string>

#include "transpiler/dialects/dialect.h"

namespace plcxx::prostep {

std::unique_ptr<dialects::ControlStub> MakeStub(const ir::Program& program,
                                                const std::map<std::string, std::string>& options);

/// A message as the NC shows it: the DM text, with the number that FB 222 to FB 237 point to in its place (8.3).
std::string MessageText(const ir::Program& program, uint32_t number, const dialects::ImagePort& image);

}  // namespace plcxx::prostep
