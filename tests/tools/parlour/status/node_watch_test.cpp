#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "script/compiler/compiler.hpp"
#include "tests/support/tcp_client.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/parlour/status/node_watch.hpp"
#include "tools/parlour/status/running_nodes.hpp"
#include "tools/parlour/status/status_client.hpp"

namespace parlour::tools {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* desk = R"(<dialogue>
  <topic name="Card"><slot name="Pin" type="Functional" private="true"
    question="Your number?"><cardinality type="set">
      <value>one two three</value></cardinality></slot></topic>
  <handler name="H"><messages><component><ASR><RecognitionResult>
    <speak param="You said: {_LPARAM1}"/>
  </RecognitionResult></ASR></component></messages></handler>
</dialogue>)";

class NodeWatchTest : public testing::Test {
protected:
  NodeWatchTest() : watch({"desk", "/apps/desk", {}}) {
    test::TemporaryFolder app;
    app.write("settings.xml", "<settings name=\"desk\"><Scripts><Script>"
                              "desk.xml</Script></Scripts></settings>");
    app.write("desk.xml", desk);
    actors::NodeOptions options;
    options.program = script::compile_application(app.path(), {}).program;
    options.inspect_all = false;
    options.on_inspection = [this](const auto& seen) { watch.see(seen); };
    node = std::move(*actors::Node::start(std::move(options)));
    watch.connect(*node, {}, [] {
      return Metrics{metric("visitors", MetricKind::gauge, "Here.", 7)};
    });
    seat = node->open_seat({});
  }
  ~NodeWatchTest() override {
    watch.end();
  }
  std::string get(const std::string& url) {
    parlour::test::Client client(url.substr(0, url.rfind('/')));
    client.send("GET " + url.substr(url.rfind('/')) +
                " HTTP/1.1\r\nHost: x\r\n\r\n");
    return client.receive_all();
  }

  test::TemporaryFolder folder;
  NodeWatch watch; // before the node, which it outlives
  std::unique_ptr<actors::Node> node;
  actors::SeatId seat;
};

TEST_F(NodeWatchTest, TellsPrometheusAndWhetherItIsWell) {
  const auto where = watch.serve_pages({"127.0.0.1", 0}, {});
  ASSERT_TRUE(where) << to_string(where.error());
  node->enter(seat, {"hello"});
  node->run_until_quiet();
  EXPECT_THAT(get(*where),
              AllOf(StartsWith("HTTP/1.1 200 "), HasSubstr("version=0.0.4"),
                    HasSubstr("\nparlour_turns_total 1\n"),
                    HasSubstr("\nparlour_turn_seconds_count 1\n"),
                    HasSubstr("\nvisitors 7\n"),
                    HasSubstr("\nprocess_resident_memory_bytes ")));
  EXPECT_THAT(get(where->substr(0, where->rfind('/')) + "/health"),
              AllOf(StartsWith("HTTP/1.1 200 "), EndsWith("well\n")));
  EXPECT_FALSE(watch.serve_pages({"nowhere", 0}, {}));
}

TEST_F(NodeWatchTest, AnswersTheCommandsOfItsUser) {
  const auto sockets = folder.path() / "parlour";
  ASSERT_TRUE(watch.serve_commands(sockets));
  const auto socket = sockets / (std::to_string(getpid()) + ".sock");
  EXPECT_EQ(node_from_json(*answer_to(socket, questions::who))->application,
            "desk");
  const auto metrics =
      metrics_from_json(*answer_to(socket, questions::metrics));
  ASSERT_TRUE(metrics);
  EXPECT_NE(find(metrics->metrics, "parlour_uptime_seconds"), nullptr);
  EXPECT_NE(find(metrics->metrics, "visitors"), nullptr);
  EXPECT_TRUE(ask_status(sockets).at(0));
}

TEST_F(NodeWatchTest, IsFollowed) {
  const auto sockets = folder.path() / "parlour";
  ASSERT_TRUE(watch.serve_commands(sockets));
  const auto reader = ask(sockets / (std::to_string(getpid()) + ".sock"),
                          std::string(questions::tail) + " " +
                              to_json(TailFilter{.kinds = {"message", "log"}}));
  ASSERT_TRUE(reader);
  // Another question is answered later than that one.
  answer_to(sockets / (std::to_string(getpid()) + ".sock"), questions::who);
  node->enter(seat, {"hello"});
  node->run_until_quiet();
  std::string text;
  char byte = 0;
  while (text.find("hello") == std::string::npos &&
         recv(reader->get(), &byte, 1, 0) == 1)
    text += byte;
  EXPECT_THAT(text, HasSubstr("  message     ASR.RecognitionResult(hello"));
}

} // namespace
} // namespace parlour::tools
