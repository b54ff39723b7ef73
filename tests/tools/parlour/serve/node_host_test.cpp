#include <condition_variable>
#include <mutex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tools/parlour/application_fixture.hpp"
#include "tools/parlour/application/node_options.hpp"
#include "tools/parlour/serve/node_host.hpp"

namespace parlour::tools {
namespace {

// Notes what it is told.
class NotingServer : public web::TextServer {
public:
  std::string address() const override {
    return {};
  }
  void began(web::VisitorId visitor, std::string session) override {
    last_session = session;
    note("began " + std::to_string(visitor));
  }
  void said(web::VisitorId, std::string, web::Said what) override {
    note(what.act + " " + std::to_string(what.output) + " " + what.text);
  }
  void done(web::VisitorId, std::string, std::uint64_t turn) override {
    note("done " + std::to_string(turn));
  }
  void ended(web::VisitorId visitor, std::string) override {
    note("ended " + std::to_string(visitor));
  }
  void stop_accepting() override {}
  Counts counts() override {
    return {};
  }

  std::vector<std::string> seen;
  std::string last_session;

private:
  void note(std::string what) {
    seen.push_back(std::move(what));
  }
};

constexpr const char* desk = R"(<dialogue>
  <state name="Desk"><Entrance><speak param="Hello."/></Entrance>
    <Exit><speak param="Bye."/></Exit></state>
  <handler name="H"><messages><component><ASR><RecognitionResult>
    <speak param="You said: {_LPARAM1}"/>
  </RecognitionResult></ASR></component></messages></handler>
</dialogue>)";

class NodeHostTest : public testing::Test {
protected:
  NodeHostTest() {
    actors::NodeOptions options;
    test::TemporaryFolder folder;
    folder.write("settings.xml",
                 "<settings name=\"desk\" start=\"Desk\"><Scripts><Script>"
                 "desk.xml</Script></Scripts></settings>");
    folder.write("desk.xml", desk);
    options.program = script::compile_application(folder.path(), {}).program;
    options.virtual_start = *parse_timestamp("2026-11-21 09:00");
    node = std::move(*actors::Node::start(std::move(options)));
    host.connect(*node, server);
  }
  std::vector<std::string> take() {
    node->run_until_quiet();
    return std::exchange(server.seen, {});
  }

  NotingServer server;
  NodeHost host;
  std::unique_ptr<actors::Node> node;
};

TEST_F(NodeHostTest, GivesEachVisitorAConversation) {
  host.open(7);
  EXPECT_THAT(take(), testing::ElementsAre("began 7", "answer 1 Hello."));
  EXPECT_EQ(server.last_session.size(), 32);
  host.take(7, {1, {"a", "b"}});
  EXPECT_THAT(take(), testing::ElementsAre("answer 2 You said: a",
                                           "answer 3 You said: b", "done 1"));
  host.close(7);
  EXPECT_THAT(take(), testing::ElementsAre("answer 4 Bye.", "ended 7"));
  host.close(7);
  host.take(7, {2, {"late"}});
  EXPECT_THAT(take(), testing::IsEmpty());
}

TEST_F(NodeHostTest, TellsThePlatformsTime) {
  EXPECT_EQ(host.clock(), "2026-11-21 09:00:00");
}

} // namespace
} // namespace parlour::tools
