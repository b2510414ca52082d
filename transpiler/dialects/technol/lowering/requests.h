// The requests of the program to its control: sent to the host after each slow pass (specification 8.2 to 8.4).
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "transpiler/dialects/technol/lowering/context.h"
#include "transpiler/dialects/technol/lowering/host_calls.h"

namespace plcxx::technol {

class CellPlaces;

class Requests : Context {
 public:
  Requests(const Context& context, CellPlaces& cells, HostCalls& host) : Context(context), cells_(cells), host_(host) {}

  /// Each request whose bit is set: its data is handed over, and the host asked whether it is done (8.2).
  void Serve();

 private:
  /// Whether the program can set a request: by its bit, its byte, or an index.
  bool CanRequest(std::string_view bit) const;
  /// Runs `transfer` with the fields of SET_NCTAB when they are valid, else tells the host which one is not (8.4).
  void CheckNcTable(const std::function<void(std::vector<ir::ValueId>)>& transfer);

  CellPlaces& cells_;
  HostCalls& host_;
};

}  // namespace plcxx::technol
