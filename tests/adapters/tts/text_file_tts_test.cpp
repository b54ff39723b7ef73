#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/tts/text_file_tts.hpp"
#include "tests/support/fake_plugin_host.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class TextFileTtsTest : public testing::Test {
protected:
  TextFileTtsTest() {
    host.data = folder.path().string();
    host.time.set(*parse_timestamp("2026-11-21 09:00"));
  }

  Expected<void> start(const Options& options = {}) {
    plugin = text_file_tts_factory().create();
    return plugin->start(host, options);
  }
  void send(std::string command, std::vector<Value> params = {}) {
    plugin->receive(test::message(std::move(command), std::move(params)));
  }
  std::string written(const std::string& name = "speech.txt") const {
    std::ifstream file(folder.path() / name);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  test::TemporaryFolder folder;
  test::FakePluginHost host;
  std::unique_ptr<IPlugin> plugin;
};

TEST_F(TextFileTtsTest, WritesWhatItSpeaks) {
  ASSERT_TRUE(start({{"rate", "0"}}));
  send("Speak", {"Good\nmorning.", 1});
  send("SetVoice", {"Anna"});
  send("Speak", {"Hello.", 2});
  EXPECT_EQ(written(), "09:00:00\tGood morning.\n09:00:00\tAnna: Hello.\n");
  EXPECT_THAT(host.take_events(), ElementsAre("Finished(1)", "Finished(2)"));
}

TEST_F(TextFileTtsTest, TakesItsTimeAndMarksEachWord) {
  ASSERT_TRUE(start({{"rate", "120"}}));
  send("Speak", {"one two", "a"});
  EXPECT_THAT(host.take_events(), ElementsAre("Mark(a, one, 0)"));
  host.advance(Milliseconds(999));
  EXPECT_THAT(host.take_events(), ElementsAre("Mark(a, two, 500)"));
  host.advance(Milliseconds(1));
  ASSERT_EQ(host.events.size(), 1u);
  EXPECT_EQ(host.events[0].correlation, 7u);
  EXPECT_EQ(host.events[0].session, "s1");
  EXPECT_THAT(host.take_events(), ElementsAre("Finished(a)"));
  EXPECT_EQ(host.pending(), 0u);
}

TEST_F(TextFileTtsTest, SpeaksOneAfterTheOther) {
  ASSERT_TRUE(start({{"rate", "60"}}));
  send("Speak", {"one", 1});
  send("Speak", {"", 2});
  send("Speak", {"three", 3});
  EXPECT_EQ(written(), "09:00:00\tone\n");
  host.advance(Milliseconds(1000));
  EXPECT_EQ(written(), "09:00:00\tone\n09:00:01\t\n09:00:01\tthree\n");
  EXPECT_THAT(host.take_events(),
              ElementsAre("Mark(1, one, 0)", "Finished(1)", "Finished(2)",
                          "Mark(3, three, 0)"));
}

TEST_F(TextFileTtsTest, StopsOneOrAll) {
  ASSERT_TRUE(start({{"rate", "60"}}));
  for (int i = 1; i <= 4; ++i)
    send("Speak", {"word", i});
  host.take_events();
  send("Stop", {3});
  EXPECT_THAT(host.take_events(), ElementsAre("Finished(3)"));
  send("Stop", {1});
  EXPECT_THAT(host.take_events(),
              ElementsAre("Finished(1)", "Mark(2, word, 0)"));
  EXPECT_EQ(host.pending(), 1u);
  send("Stop");
  EXPECT_THAT(host.take_events(), ElementsAre("Finished(2)", "Finished(4)"));
  EXPECT_EQ(host.pending(), 0u);
  send("Stop");
  EXPECT_THAT(host.events, IsEmpty());
}

TEST_F(TextFileTtsTest, StopsNothingOfAnotherSession) {
  ASSERT_TRUE(start({{"rate", "60"}}));
  send("Speak", {"word", 1});
  host.take_events();
  auto stop = test::message("Stop", {1});
  stop.session = "s2";
  plugin->receive(stop);
  EXPECT_THAT(host.take_events(), IsEmpty());
  send("Stop", {1});
  EXPECT_THAT(host.take_events(), ElementsAre("Finished(1)"));
}

TEST_F(TextFileTtsTest, RefusesWhatItCannot) {
  ASSERT_TRUE(start());
  for (int i = 0; i < 101; ++i)
    send("Speak", {"word", i});
  EXPECT_THAT(host.take_events().back(), HasSubstr("too much to say"));
  send("Sing");
  EXPECT_THAT(host.take_events(),
              ElementsAre("Failed(TextFileTTS does not know the command "
                          "'Sing'.)"));
  plugin->stop();
  EXPECT_EQ(host.pending(), 0u);
}

TEST_F(TextFileTtsTest, KnowsItsOptions) {
  EXPECT_TRUE(start({{"file", "voice/a.txt"}, {"rate", "0"}}));
  send("Speak", {"Hello.", 1});
  EXPECT_EQ(written("voice/a.txt"), "09:00:00\tHello.\n");
  EXPECT_THAT(start({{"file", "../a.txt"}}).error().message,
              HasSubstr("leaves its folder"));
  EXPECT_THAT(start({{"rate", "fast"}}).error().message,
              HasSubstr("words a minute"));
  std::filesystem::create_directory(folder.path() / "taken");
  EXPECT_EQ(start({{"file", "taken"}}).error().kind, ErrorKind::file);
}

} // namespace
} // namespace parlour::adapters
