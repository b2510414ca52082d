#include "transpiler/live/http.h"
#include "transpiler/support/module.h"

namespace plcxx::live {

LoadedServer LoadHttpServer(HttpHandler& handler) {
  const support::ModuleFunction function = support::LoadFunction(kHttpModule, kMakeHttpServer);
  if (function.address == nullptr) return {.server = nullptr, .reason = function.reason};
  auto* const make = reinterpret_cast<MakeHttpServerFunction*>(function.address);
  return {.server = std::unique_ptr<HttpServer>(make(handler)), .reason = {}};
}

}  // namespace plcxx::live
