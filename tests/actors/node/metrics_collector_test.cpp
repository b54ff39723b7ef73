#include "actors/node/metrics_collector.hpp"
#include "tests/actors/node_fixture.hpp"

namespace parlour::actors {
namespace {

class MetricsCollectorTest : public NodeFixture {
protected:
  // The sample with these labels, or the first.
  double value(const std::string& name, const std::string& label = "") {
    const auto all = node->metrics();
    const auto* metric = find(all, name);
    if (metric)
      for (const auto& sample : metric->samples)
        if (label.empty() ||
            (!sample.labels.empty() && sample.labels[0].second == label))
          return sample.value;
    ADD_FAILURE() << "nobody tells of " << name << " " << label;
    return -1;
  }
  std::uint64_t turns_timed() {
    const auto all = node->metrics();
    return find(all, "parlour_turn_seconds")->samples.at(0).time.count();
  }
};

TEST_F(MetricsCollectorTest, CountsSessionsTurnsAndMessages) {
  start(echo);
  EXPECT_EQ(value("parlour_sessions"), 0);
  say({"hello"});
  say({"one", "two"});
  EXPECT_EQ(value("parlour_sessions"), 1);
  EXPECT_EQ(value("parlour_turns_total"), 3);
  EXPECT_EQ(turns_timed(), 3u);
  EXPECT_GE(value("parlour_messages_total"), 3);
  EXPECT_GE(value("parlour_messages_to_sessions_total"), 3);
  EXPECT_EQ(value("parlour_routes_total", "drop"), 0);
  EXPECT_EQ(value("parlour_actor_answers", "message_centre"), 1);
  EXPECT_EQ(value("parlour_actor_mailbox_messages", "message_centre"), 0);
  node->end(node->session_at(seat));
  node->run_until_quiet();
  EXPECT_EQ(value("parlour_sessions"), 0);
  EXPECT_EQ(value("parlour_sessions_opened_total"), 1);
  EXPECT_EQ(value("parlour_sessions_ended_total"), 1);
  EXPECT_EQ(value("parlour_sessions_lost_total"), 0);
}

TEST_F(MetricsCollectorTest, TurnsWithNumbersAreCountedAsTheyAreNumbered) {
  options.virtual_start.reset();
  start(echo);
  const auto visit = node->begin_visit({});
  node->run_until_quiet();
  node->enter_turn(visit, 1, {"one"});
  node->run_until_quiet();
  node->enter_turn(visit, 2, {"two", "in", "lines"});
  node->run_until_quiet();
  EXPECT_EQ(value("parlour_turns_total"), 2);
  EXPECT_EQ(turns_timed(), 2u);
}

TEST_F(MetricsCollectorTest, TellsHowComponentsAre) {
  int calls = 0;
  options.components = {component("Ear", "ASR",
                                  [&](FunctionPlugin&, const Message&) {
                                    if (++calls == 1)
                                      throw std::runtime_error("deaf");
                                  }),
                        inline_component("Words", "NLU", [](const Message&) {
                          return std::vector<Answer>();
                        })};
  start(R"(<handler name="Pipeline"><messages><component>
    <ASR><RecognitionResult>
      <post module="Ear" command="Hark"/>
      <post module="Words" command="DoNLU" param="_LPARAM1"/>
    </RecognitionResult></ASR></component></messages></handler>)");
  EXPECT_EQ(value("parlour_component_up", "Ear"), 1);
  say({"hello"});
  node->advance(1s);
  say({"again"});
  EXPECT_EQ(value("parlour_component_up", "Ear"), 1);
  EXPECT_EQ(value("parlour_component_failures_total", "Ear"), 1);
  EXPECT_EQ(value("parlour_component_restarts_total", "Ear"), 1);
  EXPECT_EQ(value("parlour_component_messages_total", "Ear"), 2);
  EXPECT_EQ(value("parlour_component_messages_total", "Words"), 2);
  EXPECT_EQ(value("parlour_component_mailbox_messages", "Ear"), 0);
}

TEST_F(MetricsCollectorTest, ASessionThatIsLostIsCounted) {
  options.phrases = std::make_shared<ThrowingPhrases>();
  start(std::string(echo) + loses_its_session);
  say({"hello"});
  Message breaks;
  breaks.source = "Bell";
  breaks.command = "Breaks";
  node->inject(node->session_at(seat), breaks);
  node->run_until_quiet();
  EXPECT_EQ(value("parlour_sessions_lost_total"), 1);
  EXPECT_EQ(value("parlour_sessions"), 0);
}

} // namespace
} // namespace parlour::actors
