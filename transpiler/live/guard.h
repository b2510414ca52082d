// Who may ask: requests of the page itself, and of nobody else's page.
//
// A browser sends requests of any page to the loopback. What tells them apart are the Host that was asked for (a name
// that an attacker lets point to the loopback is not ours), the Origin, and what the browser says of the fetch;
// commands are JSON, which no form of another page can send unasked. Beyond the loopback a token has to be known, too.
#pragma once

#include <string>

#include "transpiler/live/http.h"

namespace plcxx::live {

struct GuardOptions {
  int port = 0;
  std::string token;  // empty: the loopback alone
};

/// Why the request is refused, for its sender; empty: it is not.
std::string RefusedFor(const HttpRequest& request, const GuardOptions& options);
/// What the page itself consists of has no secrets.
bool NeedsToken(const std::string& path);

}  // namespace plcxx::live
