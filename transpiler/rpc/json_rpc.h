// JSON-RPC 2.0 over standard input and output: what the language server and the MCP server have in common.
//
// A Server has a table of methods. Whatever a client sends, it gets an answer of the protocol: a text that is no JSON,
// an object that is no request, an unknown method, parameters of a wrong type, a fault of plcxx itself. Nothing that
// arrives ends the process; the end of the input does, and a method that asks for it.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>

#include "transpiler/rpc/frames.h"

namespace plcxx::rpc {

using Json = nlohmann::json;

enum ErrorCode : int {
  kParseError = -32700,
  kInvalidRequest = -32600,
  kMethodNotFound = -32601,
  kInvalidParams = -32602,
  kInternalError = -32603,
  kServerNotInitialized = -32002,  // of the Language Server Protocol, as the following
  kRequestCancelled = -32800,
  kRequestFailed = -32803,
};

/// Thrown by a method: the answer is this error.
struct Error : std::runtime_error {
  Error(int error_code, const std::string& message) : std::runtime_error(message), code(error_code) {}
  int code;
};

/// The member of an object of parameters, with the type that the protocol says; else Error with kInvalidParams.
std::string TextOf(const Json& object, const char* key);
int64_t NumberOf(const Json& object, const char* key);
const Json& ObjectOf(const Json& object, const char* key);
const Json& ArrayOf(const Json& object, const char* key);
/// As it is sent.
std::string Written(const Json& value);
/// A text as it is sent, without making a value of it.
std::string Quoted(std::string_view text);

/// None: there is no such member, or it is null; a wrong type is an error.
std::optional<std::string> OptionalText(const Json& object, const char* key);
std::optional<int64_t> OptionalNumber(const Json& object, const char* key);
std::optional<bool> OptionalFlag(const Json& object, const char* key);

class Server {
 public:
  /// Gives the result; what it gives for a notification is dropped.
  using Method = std::function<Json(const Json& params)>;

  /// `send` gets each message as text, without a frame.
  Server(Framing framing, std::function<void(std::string_view text)> send);

  void Add(std::string name, Method method) { methods_[std::move(name)] = std::move(method); }
  /// Asked before each method; throws Error to refuse it.
  void SetGate(std::function<void(std::string_view method)> gate) { gate_ = std::move(gate); }
  /// The notification that takes back a request that has not been begun; its parameter `key` is the id.
  void SetCancel(std::string method, std::string key);

  void Notify(std::string_view method, Json params);
  /// The same with parameters that are JSON already: thousands of diagnostics cost more as a tree than as text.
  void NotifyWritten(std::string_view method, std::string_view params);

  /// Bytes that have arrived, in any pieces.
  void Feed(std::string_view bytes);
  bool HasWork() const { return !waiting_.empty(); }
  /// Answers the oldest message that waits.
  void Work();

 private:
  void Take(const std::string& text);
  void TakeCancel(const Json& message);
  /// None: a notification.
  std::optional<Json> Answer(const Json& message);
  Json Call(const Json& message);
  void Send(const Json& message);
  void SendError(const Json& id, int code, const std::string& text);

  FrameReader reader_;
  std::function<void(std::string_view)> send_;
  std::map<std::string, Method, std::less<>> methods_;
  std::function<void(std::string_view)> gate_;
  std::string cancel_method_, cancel_key_;
  std::set<std::string> cancelled_;  // ids as JSON
  std::deque<Json> waiting_;
};

}  // namespace plcxx::rpc
