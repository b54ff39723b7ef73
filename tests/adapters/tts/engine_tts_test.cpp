#include "adapters/tts/engine_tts.hpp"
#include "tests/adapters/tts/fake_synthesizer.hpp"
#include "tests/adapters/tts/tts_fixture.hpp"

namespace parlour::adapters::tts {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class EngineTtsTest : public test::TtsTest {
protected:
  ~EngineTtsTest() override {
    state.open();
  }

  Expected<void> start(const Options& options = {}) {
    const auto known = voice_options("anna");
    return TtsTest::start(
        {{}, [&] { return std::make_unique<EngineTTS>(engine, known); }},
        options);
  }
  // The ids of the events, in order.
  static std::vector<std::int64_t> ids(const std::vector<Message>& events,
                                       std::size_t param = 0) {
    std::vector<std::int64_t> found;
    for (const auto& event : events)
      if (const auto* id = event.params.at(param).if_integer())
        found.push_back(*id);
    return found;
  }

  test::FakeSynthesizerState state;
  SharedEngine engine{[this] { return test::make_fake_synthesizer(state); }};
};

TEST_F(EngineTtsTest, speaks_in_frames_and_marks_the_words) {
  ASSERT_TRUE(start());
  send("Speak", {"one two three", 4});
  const auto events = events_until("Finished");
  EXPECT_THAT(marks(events), ElementsAre("one@0", "two@100", "three@200"));
  EXPECT_THAT(sound(events), SizeIs(300 * speech_rate / 1'000));
  EXPECT_EQ(events.front().command, "Mark");
  EXPECT_EQ(events.back().params.at(0), Value(4));
  EXPECT_EQ(events.back().session, "s1");
  EXPECT_EQ(events.back().correlation, 7u);
}

TEST_F(EngineTtsTest, resamples_and_fills_the_last_frame) {
  state.rate = 22'050;
  ASSERT_TRUE(start());
  send("Speak", {"one", 1});
  const auto samples = sound(events_until("Finished"));
  EXPECT_THAT(samples, SizeIs(100 * speech_rate / 1'000));
  EXPECT_NEAR(samples[samples.size() / 2], test::fake_sample, 40);
}

TEST_F(EngineTtsTest, tells_the_words_of_all_pieces) {
  state.length = {1, 10};
  ASSERT_TRUE(start());
  state.silent = "-";
  send("Speak", {"Sentence. - another. three -", 1});
  EXPECT_THAT(marks(events_until("Finished")),
              ElementsAre("Sentence.@0", "-@100", "another.@100", "three@200",
                          "-@300"));
}

TEST_F(EngineTtsTest, has_nothing_to_say_and_finishes) {
  ASSERT_TRUE(start());
  send("Speak", {" \x01 ", 1});
  EXPECT_THAT(events_until("Finished"), SizeIs(1));
}

TEST_F(EngineTtsTest, delivers_ahead_but_not_far) {
  ASSERT_TRUE(start({{"ahead", "1s"}, {"one-by-one", "true"}}));
  send("Speak", {test::words(100), 1}); // 10 s
  EXPECT_THAT(only(host.take_events(), "Audio"), SizeIs(50));
  host.advance(Milliseconds(2'000));
  EXPECT_THAT(only(host.take_events(), "Audio"), SizeIs(100));
  host.advance(Milliseconds(6'900));
  EXPECT_THAT(only(host.take_events(), "Finished"), IsEmpty());
  host.advance(Milliseconds(250));
  EXPECT_THAT(only(host.take_events(), "Finished"), SizeIs(1));
}

TEST_F(EngineTtsTest, does_not_synthesize_far_ahead_either) {
  state.length = {1, 100};
  ASSERT_TRUE(start({{"ahead", "1s"}, {"one-by-one", "true"}}));
  send("Speak", {test::words(1'000), 1}); // 100 s in pieces of about 2 s
  engine.use().value()->run([](Synthesizer&) {});
  EXPECT_LT(state.words_spoken(), 100);
  host.advance(Milliseconds(100'000));
  EXPECT_THAT(only(host.take_events(), "Finished"), SizeIs(1));
  EXPECT_EQ(state.words_spoken(), 1'000);
}

TEST_F(EngineTtsTest, speaks_a_session_s_texts_in_order) {
  ASSERT_TRUE(start());
  for (int i = 1; i <= 3; ++i)
    send("Speak", {"word", i});
  const auto events = events_until("Finished", 3);
  EXPECT_THAT(ids(only(events, "Mark")), ElementsAre(1, 2, 3));
  EXPECT_THAT(ids(only(events, "Finished")), ElementsAre(1, 2, 3));
}

TEST_F(EngineTtsTest, gives_sessions_their_turns) {
  state.length = {1, 100};
  ASSERT_TRUE(start());
  send("SetVoice", {"berta"}, "s2");
  state.close();
  send("Speak", {test::words(60), 1});
  state.wait_for_caller();
  send("Speak", {"short", 2}, "s2");
  state.open();
  events_until("Finished", 2);
  EXPECT_THAT(state.voices(), ElementsAre("anna", "berta", "anna", "anna"));
}

TEST_F(EngineTtsTest, stops_one_while_it_is_synthesized) {
  ASSERT_TRUE(start());
  state.close();
  send("Speak", {test::words(50), 1});
  send("Speak", {"next", 2});
  state.wait_for_caller();
  host.take_events();
  send("Stop", {1});
  EXPECT_THAT(ids(only(host.take_events(), "Finished")), ElementsAre(1));
  state.open();
  const auto events = events_until("Finished");
  EXPECT_THAT(ids(only(events, "Audio"), 1), Each(2));
  EXPECT_LT(state.words_spoken(), 10);
}

TEST_F(EngineTtsTest, stops_one_that_waits_or_all_of_the_session) {
  ASSERT_TRUE(start({{"one-by-one", "true"}}));
  for (int i = 1; i <= 4; ++i)
    send("Speak", {test::words(50), i});
  send("Speak", {test::words(50), 1}, "s2");
  host.take_events();
  send("Stop", {3});
  EXPECT_THAT(ids(only(host.take_events(), "Finished")), ElementsAre(3));
  send("Stop");
  EXPECT_THAT(ids(only(host.take_events(), "Finished")), ElementsAre(1, 2, 4));
  send("Stop");
  EXPECT_THAT(host.take_events(), IsEmpty());
  host.advance(Milliseconds(5'000));
  const auto events = host.take_events();
  EXPECT_THAT(ids(only(events, "Finished")), ElementsAre(1));
  EXPECT_EQ(events.back().session, "s2");
}

TEST_F(EngineTtsTest, has_a_voice_for_each_session) {
  ASSERT_TRUE(start());
  send("SetVoice", {"berta"});
  send("Speak", {"word", 1});
  send("Speak", {"word", 1}, "s2");
  events_until("Finished", 2);
  EXPECT_THAT(state.voices(), testing::UnorderedElementsAre("berta", "anna"));
  send("SetVoice", {"nobody"});
  const auto events = host.take_events();
  ASSERT_THAT(events, SizeIs(1));
  EXPECT_EQ(events[0].command, "Failed");
  EXPECT_THAT(events[0].params.at(0).text(), HasSubstr("no voice 'nobody'"));
}

TEST_F(EngineTtsTest, refuses_too_much) {
  ASSERT_TRUE(start());
  send("Speak", {std::string(10'001, 'a'), 1});
  auto events = host.take_events();
  ASSERT_THAT(events, SizeIs(1));
  EXPECT_THAT(events[0].params.at(0).text(), HasSubstr("at most 10000"));
  state.close();
  for (int i = 0; i < 101; ++i)
    send("Speak", {"word", i}, "s" + std::to_string(i % 7));
  events = only(host.take_events(), "Failed");
  ASSERT_THAT(events, SizeIs(1));
  EXPECT_THAT(events[0].params.at(0).text(), HasSubstr("100 texts wait"));
}

TEST_F(EngineTtsTest, says_why_it_fails_and_goes_on) {
  ASSERT_TRUE(start());
  send("Speak", {"fail", 1});
  EXPECT_THAT(events_until("Failed").back().params.at(0).text(),
              HasSubstr("cannot say this"));
  send("Speak", {"word", 2});
  events_until("Finished");
}

TEST_F(EngineTtsTest, stops_in_the_middle) {
  ASSERT_TRUE(start());
  state.close();
  send("Speak", {test::words(1'000), 1});
  state.wait_for_caller();
  state.open();
  plugin->stop();
  EXPECT_EQ(state.instances(), 0);
}

TEST_F(EngineTtsTest, knows_its_options) {
  EXPECT_THAT(start({{"voice", "nobody"}}).error().message,
              HasSubstr("no voice 'nobody'"));
  for (const auto& [name, value] : Options{{"rate", "79"},
                                           {"pitch", "100"},
                                           {"volume", "-1"},
                                           {"ahead", "99ms"}}) {
    const auto started = start({{name, value}});
    ASSERT_FALSE(started) << name;
    EXPECT_THAT(started.error().message, HasSubstr("option '" + name));
  }
  state.is_missing = true;
  EXPECT_THAT(start().error().message, HasSubstr("not installed"));
}

} // namespace
} // namespace parlour::adapters::tts
