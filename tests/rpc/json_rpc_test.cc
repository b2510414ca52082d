#include "transpiler/rpc/json_rpc.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "transpiler/support/check.h"
#include "transpiler/support/fault_guard.h"

namespace plcxx::rpc {
namespace {

/// A server of three methods, and what it has sent.
struct Fixture {
  Fixture() : server(Framing::kLines, [this](std::string_view text) { sent.push_back(Json::parse(text)); }) {
    server.Add("add", [](const Json& params) -> Json { return NumberOf(params, "a") + NumberOf(params, "b"); });
    server.Add("fault", [](const Json&) -> Json {
      const support::FaultGuard guard;
      PLCXX_CHECK(false);
      return nullptr;
    });
    server.Add("note", [this](const Json&) -> Json {
      ++notes;
      return nullptr;
    });
    server.SetCancel("cancel", "id");
  }

  std::vector<Json> Answers(std::string_view lines) {
    sent.clear();
    server.Feed(lines);
    while (server.HasWork()) server.Work();
    return sent;
  }
  int CodeOf(std::string_view line) {
    const std::vector<Json> answers = Answers(std::string(line) + "\n");
    if (answers.size() != 1 || !answers[0].contains("error")) return 0;
    return answers[0]["error"]["code"];
  }

  std::vector<Json> sent;
  Server server;
  int notes = 0;
};

TEST(JsonRpc, ARequestIsAnswered) {
  Fixture fixture;
  const std::vector<Json> answers =
      fixture.Answers(R"({"jsonrpc":"2.0","id":"x","method":"add","params":{"a":1,"b":2}})"
                      "\n");
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0], (Json{{"jsonrpc", "2.0"}, {"id", "x"}, {"result", 3}}));
}

TEST(JsonRpc, WhatIsWrongGetsTheErrorOfTheProtocol) {
  Fixture fixture;
  EXPECT_EQ(fixture.CodeOf("{"), kParseError);
  EXPECT_EQ(fixture.CodeOf("\xFF\xFE"), kParseError);
  EXPECT_EQ(fixture.CodeOf(R"({"id":1,"method":"add","params":{"a":"\xff"}})"), kParseError);
  EXPECT_EQ(fixture.CodeOf(std::string(100'000, '[')), kParseError);
  EXPECT_EQ(fixture.CodeOf(std::string(1000, '[') + std::string(1000, ']')), kParseError);
  EXPECT_EQ(fixture.CodeOf("1"), kInvalidRequest);
  EXPECT_EQ(fixture.CodeOf("[]"), kInvalidRequest);
  EXPECT_EQ(fixture.CodeOf("{}"), kInvalidRequest);
  EXPECT_EQ(fixture.CodeOf(R"({"id":1,"method":7})"), kInvalidRequest);
  EXPECT_EQ(fixture.CodeOf(R"({"id":[1],"method":"add"})"), kInvalidRequest);
  EXPECT_EQ(fixture.CodeOf(R"({"id":1,"method":"substract"})"), kMethodNotFound);
  EXPECT_EQ(fixture.CodeOf(R"({"id":1,"method":"add"})"), kInvalidParams);
  EXPECT_EQ(fixture.CodeOf(R"({"id":1,"method":"add","params":7})"), kInvalidParams);
  EXPECT_EQ(fixture.CodeOf(R"({"id":1,"method":"add","params":[1,2]})"), kInvalidParams);
  EXPECT_EQ(fixture.CodeOf(R"({"id":1,"method":"add","params":{"a":1,"b":"2"}})"), kInvalidParams);
  EXPECT_EQ(fixture.CodeOf(R"({"id":1,"method":"add","params":{"a":1.5,"b":2}})"), kInvalidParams);
  EXPECT_EQ(fixture.CodeOf(R"({"id":1,"method":"fault"})"), kInternalError);
  EXPECT_EQ(fixture.CodeOf(R"({"id":1,"method":"add","params":{"a":1,"b":2}})"), 0);
}

TEST(JsonRpc, ANotificationIsNeverAnswered) {
  Fixture fixture;
  EXPECT_TRUE(fixture
                  .Answers(R"({"method":"note"})"
                           "\n")
                  .empty());
  EXPECT_TRUE(fixture
                  .Answers(R"({"method":"fault"})"
                           "\n")
                  .empty());
  EXPECT_TRUE(fixture
                  .Answers(R"({"method":"nobody"})"
                           "\n")
                  .empty());
  EXPECT_TRUE(fixture
                  .Answers(R"({"id":1,"result":{}})"
                           "\n")
                  .empty())
      << "the answer to a request of ours";
  EXPECT_EQ(fixture.notes, 1);
}

TEST(JsonRpc, ARequestThatWaitsCanBeTakenBack) {
  Fixture fixture;
  const std::vector<Json> answers = fixture.Answers(R"({"id":1,"method":"add","params":{"a":1,"b":2}})"
                                                    "\n"
                                                    R"({"id":2,"method":"add","params":{"a":1,"b":2}})"
                                                    "\n"
                                                    R"({"method":"cancel","params":{"id":2}})"
                                                    "\n"
                                                    R"({"method":"cancel","params":{"id":9}})"
                                                    "\n"
                                                    R"({"method":"cancel","params":7})"
                                                    "\n");
  ASSERT_EQ(answers.size(), 2u);
  EXPECT_EQ(answers[0]["result"], 3);
  EXPECT_EQ(answers[1]["error"]["code"], kRequestCancelled);
}

TEST(JsonRpc, ABatchGetsOneAnswer) {
  Fixture fixture;
  const std::vector<Json> answers =
      fixture.Answers(R"([{"id":1,"method":"add","params":{"a":1,"b":2}},{"method":"note"},7])"
                      "\n");
  ASSERT_EQ(answers.size(), 1u);
  ASSERT_EQ(answers[0].size(), 2u);
  EXPECT_EQ(answers[0][0]["result"], 3);
  EXPECT_EQ(answers[0][1]["error"]["code"], kInvalidRequest);
}

}  // namespace
}  // namespace plcxx::rpc
