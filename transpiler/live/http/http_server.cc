// The web server of plcxx live: cpp-httplib between sockets and a handler. A module, for the library brings others that
// no other command needs.
#include <httplib.h>
#include <malloc.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <string>
#include <thread>
#include <variant>

#include "transpiler/live/http.h"

namespace plcxx::live {
namespace {

/// Each thread of glibc gets a heap of its own, which keeps what the largest answer took there; with one for all of
/// them the memory is that of the answers that are on their way. They wait for the session anyway.
void ShareOneHeap() {
#ifdef M_ARENA_MAX
  mallopt(M_ARENA_MAX, 1);
#endif
}

constexpr size_t kMostBytes = size_t{1} << 20;  // of a request's body
constexpr int kThreads = 24;                    // requests at a time; a page that looks holds one
constexpr int kTimeout = 5;                     // seconds, for a client that does not read or write
constexpr int kKeepAlive = 1;                   // seconds; the end waits for it

HttpRequest RequestOf(const httplib::Request& from) {
  HttpRequest request{.method = from.method,
                      .path = from.path,
                      .body = from.body,
                      .query = {},
                      .host = from.get_header_value("Host"),
                      .origin = from.get_header_value("Origin"),
                      .fetch_site = from.get_header_value("Sec-Fetch-Site"),
                      .content_type = from.get_header_value("Content-Type"),
                      .token = from.get_header_value("X-Plcxx-Token")};
  for (const auto& [name, value] : from.params) request.query.emplace_back(name, value);
  return request;
}

class HttplibServer : public HttpServer {
 public:
  explicit HttplibServer(HttpHandler& handler) : handler_(handler) {
    server_.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    server_.set_payload_max_length(kMostBytes);
    server_.set_read_timeout(kTimeout);
    server_.set_write_timeout(kTimeout);
    server_.set_keep_alive_timeout(kKeepAlive);
    server_.set_tcp_nodelay(true);
    // Not SO_REUSEPORT, the library's own choice: with it another server could share the port.
    server_.set_socket_options([](socket_t socket) {
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
    });
    // Before routing, so that the handler alone decides what there is.
    server_.set_default_headers(
        {{"Content-Security-Policy",
          "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src 'self'; base-uri "
          "'none'; form-action 'none'; frame-ancestors 'none'"},
         {"X-Content-Type-Options", "nosniff"},
         {"Referrer-Policy", "no-referrer"},
         {"Cross-Origin-Resource-Policy", "same-origin"},
         {"Cache-Control", "no-store"}});
    const auto answer = [this](const httplib::Request& request, httplib::Response& response) {
      Answer(request, response);
    };
    server_.Get(".*", answer);
    server_.Post(".*", answer);
  }

  std::variant<int, ListenProblem> Bind(const std::string& address, int port) override {
    errno = 0;
    if (port == 0) {
      const int chosen = server_.bind_to_any_port(address.c_str());
      if (chosen > 0) return chosen;
    } else if (server_.bind_to_port(address.c_str(), port)) {
      return port;
    }
    // The library says that it failed; why is what the system's last call has left.
    if (errno == EADDRINUSE) return ListenProblem::kPortInUse;
    if (errno == EACCES) return ListenProblem::kPortNotPermitted;
    return ListenProblem::kNoSuchAddress;
  }
  void Serve() override {
    server_.listen_after_bind();
    has_ended_ = true;
  }
  /// Also right before it begins: the library forgets a stop that comes too early.
  void Stop() override {
    while (!server_.is_running() && !has_ended_) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    server_.stop();
  }

 private:
  void Answer(const httplib::Request& request, httplib::Response& response) {
    HttpResponse given = handler_.Answer(RequestOf(request));
    response.status = given.status;
    if (!given.stream) {
      response.set_content(given.body, given.type.c_str());
      return;
    }
    response.set_chunked_content_provider(given.type.c_str(),
                                          [stream = std::move(given.stream)](size_t, httplib::DataSink& sink) {
                                            std::string piece;
                                            if (!sink.is_writable() || !stream(piece)) {
                                              sink.done();
                                              return false;
                                            }
                                            return sink.write(piece.data(), piece.size());
                                          });
  }

  HttpHandler& handler_;
  httplib::Server server_;
  std::atomic<bool> has_ended_ = false;
};

}  // namespace
}  // namespace plcxx::live

extern "C" __attribute__((visibility("default"))) plcxx::live::HttpServer* PlcxxMakeHttpServer(
    plcxx::live::HttpHandler& handler) {
  plcxx::live::ShareOneHeap();
  return new plcxx::live::HttplibServer(handler);
}
