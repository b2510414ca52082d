#include "transpiler/live/guard.h"

#include <algorithm>
#include <string_view>

namespace plcxx::live {
namespace {

/// In the same time wherever they differ.
bool SameToken(std::string_view a, std::string_view b) {
  unsigned difference = a.size() == b.size() ? 0 : 1;
  for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
  }
  return difference == 0;
}

/// A host as an address has it, for comparison: letters in either case are the same, and so is port 80, which browsers
/// leave out.
std::string Compared(std::string_view host) {
  std::string compared(host);
  for (char& c : compared) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  const bool has_port = compared.rfind(':') != std::string::npos && !compared.ends_with(']');
  return has_port ? compared : compared + ":80";
}

bool IsLoopback(const std::string& host, int port) {
  const std::string end = ":" + std::to_string(port);
  return std::ranges::any_of(std::initializer_list<const char*>{"127.0.0.1", "localhost", "[::1]"},
                             [&](const char* name) { return Compared(host) == name + end; });
}

bool IsOwnPage(std::string_view origin, const std::string& host) {
  constexpr std::string_view kScheme = "http://";
  return origin.starts_with(kScheme) && Compared(origin.substr(kScheme.size())) == Compared(host);
}

std::string TokenOf(const HttpRequest& request) {
  if (!request.token.empty()) return request.token;
  // A stream of events cannot have headers of its own.
  for (const auto& [name, value] : request.query) {
    if (name == "token") return value;
  }
  return {};
}

}  // namespace

bool NeedsToken(const std::string& path) { return path.starts_with("/api/"); }

std::string RefusedFor(const HttpRequest& request, const GuardOptions& options) {
  if (options.token.empty() && !IsLoopback(request.host, options.port)) return "this is not the host that was started";
  if (!request.origin.empty() && !IsOwnPage(request.origin, request.host)) return "requests of other pages are refused";
  if (!request.fetch_site.empty() && request.fetch_site != "same-origin" && request.fetch_site != "none") {
    return "requests of other pages are refused";
  }
  if (request.method != "GET" && !request.content_type.starts_with("application/json")) return "commands are JSON";
  if (!options.token.empty() && NeedsToken(request.path) && !SameToken(TokenOf(request), options.token)) {
    return "the token is missing or wrong";
  }
  return {};
}

}  // namespace plcxx::live
