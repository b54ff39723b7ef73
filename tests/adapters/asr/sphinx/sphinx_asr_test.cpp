#include <condition_variable>
#include <mutex>
#include <regex>
#include <set>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/asr/sphinx/sphinx_asr.hpp"
#include "adapters/asr/sphinx/sphinx_decoder.hpp"
#include "runtime/plugin/conformance.hpp"
#include "tests/adapters/asr/sphinx/small_application.hpp"

namespace parlour::adapters {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

// Another thread may have something done here.
class LaterHost : public test::FakePluginHost {
public:
  DelayId after(Milliseconds delay, std::function<void()> action) override {
    if (std::this_thread::get_id() == home_)
      return FakePluginHost::after(delay, std::move(action));
    const std::lock_guard lock(mutex_);
    posted_.push_back(std::move(action));
    changed_.notify_all();
    return 0;
  }
  // Does what is due, and then the first thing that a thread wants.
  void advance_and_wait() {
    advance(Milliseconds(0));
    std::unique_lock lock(mutex_);
    ASSERT_TRUE(changed_.wait_for(lock, std::chrono::minutes(1),
                                  [&] { return !posted_.empty(); }));
    posted_.front()();
  }

private:
  const std::thread::id home_ = std::this_thread::get_id();
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::function<void()>> posted_;
};

class SphinxAsrTest : public testing::Test {
protected:
  void SetUp() override {
    if (!asr::SphinxDecoder::is_built_in() || !test::can_speak())
      GTEST_SKIP() << "built without PocketSphinx or flite";
    host.model = std::make_shared<UnderstandingModel>(asr::small_application());
    host.columns = asr::small_columns;
  }
  Expected<void> start(Options options = {}) {
    options.emplace("platform", test::source_path("config/platform"));
    plugin = sphinx_asr_factory().create();
    return plugin->start(host, options);
  }
  void send(std::string command, std::vector<Value> params = {},
            const SessionId& session = "s1") {
    plugin->receive(
        test::message(std::move(command), std::move(params), session));
  }
  void say(const std::string& text, const SessionId& session = "s1") {
    const auto sound = asr::said(text);
    for (std::size_t at = 0; at < sound.size(); at += frame_samples)
      send("DoRecognition",
           {pcm_value(std::span(sound).subspan(
               at, std::min(frame_samples, sound.size() - at)))},
           session);
  }
  // The last event.
  const Message& last() const {
    return host.events.back();
  }

  LaterHost host;
  std::unique_ptr<IPlugin> plugin; // goes first
};

TEST_F(SphinxAsrTest, Conforms) {
  EXPECT_THAT(conformance_errors(sphinx_asr_factory(), {}), IsEmpty());
}

TEST_F(SphinxAsrTest, HearsASentence) {
  ASSERT_TRUE(start());
  say("Call Jeffery Ho.");
  send("Finish");
  ASSERT_EQ(last().command, "RecognitionResult");
  EXPECT_EQ(last().params[0].text(), "call Jeffery Ho");
  EXPECT_EQ(last().params[1].number_or(0), 1);
  EXPECT_THAT(*last().params[2].if_list(),
              ElementsAre(Value("call Jeffery Ho"), Value("call Jeffery Ho")));
  EXPECT_THAT(*last().params[3].if_list(), SizeIs(3));
  EXPECT_EQ(last().correlation, 7u);
}

TEST_F(SphinxAsrTest, TellsWhatItHearsMeanwhile) {
  ASSERT_TRUE(start());
  say("Bring me a hot chocolate please.");
  const auto partials = host.take_events();
  EXPECT_THAT(partials, Contains(HasSubstr("bring me")));
  EXPECT_THAT(partials.back(), HasSubstr("true)"));
  send("Cancel");
  send("Finish");
  EXPECT_THAT(host.take_events(),
              ElementsAre("Rejected(nothing was said that can be heard)"));
}

TEST_F(SphinxAsrTest, RejectsWhatDoesNotBelong) {
  ASSERT_TRUE(start());
  say("Two foxes live under the shed and come out when it gets dark.");
  send("Finish");
  EXPECT_EQ(last().command, "Rejected");
  send("DoRecognition", {pcm_value(test::silence(500))});
  send("Finish");
  EXPECT_EQ(last().command, "Rejected");
}

TEST_F(SphinxAsrTest, SessionsShareRecognisers) {
  ASSERT_TRUE(start({{"recognisers", "1"}}));
  say("Call Siti Aminah.", "one");
  say("I want coffee.", "two");
  send("Finish", {}, "two");
  host.take_events();
  send("Finish", {}, "one");
  ASSERT_EQ(host.events.size(), 2u);
  EXPECT_EQ(host.events[0].session, "one");
  EXPECT_EQ(host.events[0].params[0].text(), "call Siti Aminah");
  EXPECT_EQ(host.events[1].session, "two");
  EXPECT_EQ(host.events[1].params[0].text(), "I want coffee");
}

TEST_F(SphinxAsrTest, TakesRecognisersBackFromSessionsThatAreGone) {
  ASSERT_TRUE(start({{"recognisers", "1"}}));
  say("Call Siti", "gone");
  say("I want coffee.", "two");
  send("Finish", {}, "two");
  host.take_events();
  host.advance(Milliseconds(9'000));
  EXPECT_THAT(host.events, IsEmpty());
  host.advance(Milliseconds(2'000));
  ASSERT_EQ(host.events.size(), 1u);
  EXPECT_EQ(host.events[0].session, "two");
  EXPECT_EQ(host.events[0].params[0].text(), "I want coffee");
}

// The staff of the receptionist, from its seed: (1, 'Dr.', 'Jeffery Ho', …).
std::vector<std::string> staff_names() {
  const auto seed =
      read_file(test::source_path("config/apps/receptionist/sql/seed.sql"));
  std::set<std::string> names;
  const std::regex row(R"re(\(\d+, '\w+\.', '([^']+)', )re");
  for (std::sregex_iterator at(seed->begin(), seed->end(), row), end; at != end;
       ++at)
    names.insert((*at)[1]);
  return {names.begin(), names.end()};
}

TEST_F(SphinxAsrTest, HearsHalfOfASampleOfSixHundredNames) {
  const auto names = staff_names();
  ASSERT_GT(names.size(), 600u);
  host.columns = [&](const std::string&) {
    return Expected<std::vector<std::string>>(names);
  };
  ASSERT_TRUE(start({{"least-agreement", "0"}}));
  std::vector<std::string> heard;
  for (const auto* name :
       {"Adrian Low Boon Keng", "Bernard Lim", "Cheryl Loh Jia Hui",
        "Edwin Seah Kai Xiang", "Farhana binti Rahman", "Gopal Gupta",
        "Janice Harrison", "Kenneth Lee Swee Kiat", "Marcus Koh Yi Xuan",
        "Revathi Venkataraman"}) {
    ASSERT_THAT(names, Contains(name));
    say("Call " + std::string(name) + ".");
    send("Finish");
    if (last().params[0].text().ends_with(name))
      heard.emplace_back(name);
  }
  EXPECT_GE(heard.size(), 5u) << testing::PrintToString(heard);
}

// Engine rule 1.9.
TEST_F(SphinxAsrTest, HearsANewNameInTheNextUtterance) {
  ASSERT_TRUE(start({{"one-by-one", "true"}}));
  say("Call Deborah", "before");
  send("SetValues",
       {"db:guests.name", List{"Jeffery Ho", "Siti Aminah", "Deborah Winter"}});
  host.advance(Milliseconds(0));
  say("Call Deborah Winter.");
  send("Finish");
  EXPECT_EQ(last().params[0].text(), "call Deborah Winter");
  // Who was speaking is heard to the end.
  host.take_events();
  send("Finish", {}, "before");
  ASSERT_EQ(host.events.size(), 1u);
  EXPECT_EQ(host.events[0].session, "before");
  EXPECT_THAT(host.logs, IsEmpty());
}

TEST_F(SphinxAsrTest, PreparesNewValuesBesideWhatItHears) {
  ASSERT_TRUE(start());
  send("SetValues", {"db:guests.name", List{"Deborah Winter"}});
  send("SetValues", {"db:other.name", List{"Nobody"}});
  host.advance_and_wait();
  say("Call Deborah Winter.");
  send("Finish");
  EXPECT_EQ(last().params[0].text(), "call Deborah Winter");
}

TEST_F(SphinxAsrTest, StopsWhileItPreparesNewValues) {
  ASSERT_TRUE(start());
  send("SetValues", {"db:guests.name", List{"Deborah Winter"}});
  host.advance(Milliseconds(0));
  plugin->stop();
}

TEST_F(SphinxAsrTest, NarrowsForOneSession) {
  ASSERT_TRUE(start());
  send("SetGrammar", {Value(List{"Order.Drink"})});
  say("Lemon tea.");
  send("Finish");
  EXPECT_EQ(last().params[0].text(), "lemon tea");
  send("SetGrammar", {Value(List{})});
  say("Call Jeffery Ho.");
  send("Finish");
  EXPECT_EQ(last().params[0].text(), "call Jeffery Ho");
}

TEST_F(SphinxAsrTest, RefusesWrongOptionsAndOtherAudio) {
  EXPECT_FALSE(start({{"recognisers", "0"}}));
  EXPECT_FALSE(start({{"least-agreement", "2"}}));
  EXPECT_THAT(start({{"model", "/no/such"}}).error().message,
              HasSubstr("pocketsphinx-en-us"));
  ASSERT_TRUE(start());
  send("DoRecognition", {Binary{"pcm_s16le;rate=8000;channels=1", {}}});
  EXPECT_THAT(host.take_events(), ElementsAre(HasSubstr("16,000 samples")));
}

} // namespace
} // namespace parlour::adapters
