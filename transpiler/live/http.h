// What a web server and what it serves know of each other. The server itself (http/) is a module that is loaded.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace plcxx::live {

struct HttpRequest {
  std::string method, path, body;
  std::vector<std::pair<std::string, std::string>> query;
  std::string host, origin, fetch_site, content_type, token;  // headers; empty: not there
};

struct HttpResponse {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::string body;
  /// Instead of a body: gives the next piece, which may take a while; false ends it.
  std::function<bool(std::string& piece)> stream;
};

class HttpHandler {
 public:
  virtual ~HttpHandler() = default;
  /// Called from several threads.
  virtual HttpResponse Answer(const HttpRequest& request) = 0;
};

/// Why an address cannot be listened at.
enum class ListenProblem : uint8_t { kPortInUse, kPortNotPermitted, kNoSuchAddress };

class HttpServer {
 public:
  virtual ~HttpServer() = default;
  /// The port that it listens on; `port` 0: any that is free.
  virtual std::variant<int, ListenProblem> Bind(const std::string& address, int port) = 0;
  /// Serves until Stop.
  virtual void Serve() = 0;
  /// From another thread, or from a signal's thread.
  virtual void Stop() = 0;
};

struct LoadedServer {
  std::unique_ptr<HttpServer> server;
  std::string reason;  // why there is none
};
/// The handler outlives the server.
LoadedServer LoadHttpServer(HttpHandler& handler);

inline constexpr const char* kHttpModule = "plcxx_http.so";
inline constexpr const char* kMakeHttpServer = "PlcxxMakeHttpServer";
using MakeHttpServerFunction = HttpServer*(HttpHandler& handler);

}  // namespace plcxx::live
