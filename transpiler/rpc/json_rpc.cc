#include "transpiler/rpc/json_rpc.h"

#include <algorithm>
#include <utility>

namespace plcxx::rpc {
namespace {

/// Deeper values would need a deep stack to be written and destroyed; no message of a protocol has them.
constexpr int kMaxDepth = 128;

std::optional<Json> Parsed(const std::string& text) {
  bool too_deep = false;
  const auto limit = [&too_deep](int depth, Json::parse_event_t, Json&) {
    too_deep = too_deep || depth > kMaxDepth;
    return !too_deep;
  };
  Json value = Json::parse(text, limit, false);
  if (too_deep || value.is_discarded()) return std::nullopt;
  return value;
}

bool IsId(const Json& id) { return id.is_string() || id.is_number() || id.is_null(); }

Json ErrorAnswer(const Json& id, int code, const std::string& text) {
  return {{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", code}, {"message", text}}}};
}

Json IdOf(const Json& message) {
  const auto id = message.is_object() ? message.find("id") : message.end();
  return id != message.end() && IsId(*id) ? *id : Json();
}

[[noreturn]] void Refuse(const char* key, std::string_view type) {
  throw Error(kInvalidParams, "parameter '" + std::string(key) + "' is not " + std::string(type));
}

const Json* Member(const Json& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() || found->is_null() ? nullptr : &*found;
}

}  // namespace

std::optional<std::string> OptionalText(const Json& object, const char* key) {
  const Json* member = Member(object, key);
  if (member == nullptr) return std::nullopt;
  if (!member->is_string()) Refuse(key, "a string");
  return member->get<std::string>();
}

std::optional<int64_t> OptionalNumber(const Json& object, const char* key) {
  const Json* member = Member(object, key);
  if (member == nullptr) return std::nullopt;
  if (!member->is_number_integer()) Refuse(key, "an integer");
  return member->get<int64_t>();
}

std::optional<bool> OptionalFlag(const Json& object, const char* key) {
  const Json* member = Member(object, key);
  if (member == nullptr) return std::nullopt;
  if (!member->is_boolean()) Refuse(key, "true or false");
  return member->get<bool>();
}

std::string TextOf(const Json& object, const char* key) {
  std::optional<std::string> text = OptionalText(object, key);
  if (!text) Refuse(key, "a string");
  return *std::move(text);
}

int64_t NumberOf(const Json& object, const char* key) {
  const std::optional<int64_t> number = OptionalNumber(object, key);
  if (!number) Refuse(key, "an integer");
  return *number;
}

const Json& ObjectOf(const Json& object, const char* key) {
  const Json* member = Member(object, key);
  if (member == nullptr || !member->is_object()) Refuse(key, "an object");
  return *member;
}

const Json& ArrayOf(const Json& object, const char* key) {
  const Json* member = Member(object, key);
  if (member == nullptr || !member->is_array()) Refuse(key, "an array");
  return *member;
}

Server::Server(Framing framing, std::function<void(std::string_view text)> send)
    : reader_(framing), send_(std::move(send)) {}

void Server::SetCancel(std::string method, std::string key) {
  cancel_method_ = std::move(method);
  cancel_key_ = std::move(key);
}

std::string Written(const Json& value) {
  // A text that is no UTF-8 (a name of a file) must not cost the answer.
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string Quoted(std::string_view text) {
  const auto stands_for_itself = [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; };
  if (!std::ranges::all_of(text, stands_for_itself)) return Written(text);
  std::string quoted;
  quoted.reserve(text.size() + 2);
  quoted += '"';
  quoted += text;
  quoted += '"';
  return quoted;
}

void Server::Send(const Json& message) { send_(Written(message)); }

void Server::SendError(const Json& id, int code, const std::string& text) { Send(ErrorAnswer(id, code, text)); }

void Server::Notify(std::string_view method, Json params) {
  Send({{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}});
}

void Server::NotifyWritten(std::string_view method, std::string_view params) {
  std::string text = R"({"jsonrpc":"2.0","method":)" + Written(method) + R"(,"params":)";
  text.append(params).push_back('}');
  send_(text);
}

void Server::Feed(std::string_view bytes) {
  reader_.Feed(bytes);
  while (std::optional<Frame> frame = reader_.Next()) {
    if (frame->error.empty()) {
      Take(frame->text);
    } else {
      SendError(Json(), kParseError, frame->error);
    }
  }
}

void Server::Take(const std::string& text) {
  std::optional<Json> message = Parsed(text);
  if (!message) {
    SendError(Json(), kParseError, "a message is no JSON, or nests too deep");
    reader_.Reread(text);
    return;
  }
  TakeCancel(*message);
  waiting_.push_back(*std::move(message));
}

/// Looked at when it arrives, not when its turn comes: then the request would have been answered.
void Server::TakeCancel(const Json& message) {
  if (cancel_method_.empty() || !message.is_object() || message.value("method", Json()) != Json(cancel_method_)) return;
  const auto params = message.find("params");
  if (params == message.end() || !params->is_object() || !params->contains(cancel_key_)) return;
  const Json& id = (*params)[cancel_key_];
  for (const Json& waiting : waiting_) {
    if (IdOf(waiting) == id && !id.is_null()) cancelled_.insert(id.dump());
  }
}

void Server::Work() {
  const Json message = std::move(waiting_.front());
  waiting_.pop_front();
  if (!message.is_array()) {
    if (const std::optional<Json> answer = Answer(message)) Send(*answer);
    return;
  }
  if (message.empty()) return SendError(Json(), kInvalidRequest, "a batch is empty");
  Json answers = Json::array();
  for (const Json& part : message) {
    if (std::optional<Json> answer = Answer(part)) answers.push_back(*std::move(answer));
  }
  if (!answers.empty()) Send(answers);
}

std::optional<Json> Server::Answer(const Json& message) {
  const Json id = IdOf(message);
  if (!message.is_object()) return ErrorAnswer(id, kInvalidRequest, "a message is no object");
  const auto method = message.find("method");
  if (method == message.end()) {
    // Answers to what we asked have a result or an error; we ask nothing that needs one.
    if (message.contains("result") || message.contains("error")) return std::nullopt;
    return ErrorAnswer(id, kInvalidRequest, "a message has no method");
  }
  if (!method->is_string()) return ErrorAnswer(id, kInvalidRequest, "the method of a message is not a string");
  const bool is_notification = !message.contains("id");
  if (!is_notification && !IsId(message["id"])) {
    return ErrorAnswer(Json(), kInvalidRequest, "the id of a request is neither a string nor a number");
  }
  try {
    if (cancelled_.erase(id.dump()) != 0) throw Error(kRequestCancelled, "the request was taken back");
    Json result = Call(message);
    if (is_notification) return std::nullopt;
    return Json{{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}};
  } catch (const Error& error) {
    if (is_notification) return std::nullopt;
    return ErrorAnswer(id, error.code, error.what());
  } catch (const std::exception& fault) {
    if (is_notification) return std::nullopt;
    return ErrorAnswer(id, kInternalError, std::string("internal fault: ") + fault.what());
  }
}

Json Server::Call(const Json& message) {
  const std::string& name = message["method"].get_ref<const std::string&>();
  if (gate_) gate_(name);
  const auto method = methods_.find(name);
  if (method == methods_.end()) throw Error(kMethodNotFound, "unknown method '" + name + "'");
  const auto params = message.find("params");
  if (params == message.end() || params->is_null()) return method->second(Json::object());
  if (!params->is_object() && !params->is_array()) throw Error(kInvalidParams, "the parameters are not an object");
  return method->second(*params);
}

}  // namespace plcxx::rpc
