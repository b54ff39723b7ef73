#include "adapters/nlu/acts/act_value.hpp"
#include "tests/adapters/nlu/stages.hpp"

namespace parlour::adapters::nlu::test {
namespace {

constexpr const char* marks = R"(
  public <no> = no {act=deny};
  public <not> = not {act=deny} {denies=next};
  public <mend> = sorry {act=correct};
  public <other> = make that @time {Appointment.Time} {act=correct};
  public <wait> = wait {act=wait};
  public <thanks> = thank you {act=thank};
  public <leads> = how about;
  public <kind> = @Facility.Category;
  public <when> = @time {Appointment.Time};
  public <rain> = (umbrella | raincoat) {Category=shop} {act=request}
    {topic=Facility};)";

List acts(const std::string& text, double threshold = 0.4) {
  const Stages stages(std::string(sample_grammar) + marks, text);
  const auto chains =
      best_chains(stages.islands, stages.utterance.size(), stages.context);
  List made;
  for (const auto& act : build_acts(chains.at(0), stages.utterance,
                                    stages.schema, stages.context, threshold))
    made.push_back(
        act_value(act, stages.utterance, stages.spans, stages.schema));
  return made;
}

// Nobody is to wait who mends what he has said.
TEST(Acts, AreMendedAfterAWait) {
  EXPECT_EQ(summary(acts("to meet Anand Menon at three, no, wait, at four")),
            "inform Appointment Host=Anand Menon Time=16:00");
  EXPECT_EQ(
      summary(acts("to meet Anand Menon at three, no, wait, make that four")),
      summary(acts("to meet Anand Menon at three, no, make that four")));
  EXPECT_EQ(summary(acts("no, wait")), "deny");
  EXPECT_EQ(summary(acts("no, wait, is there a bank")),
            "deny + request Facility Category=bank");
}

// Other sentences take nothing from an act; other words of its own do.
TEST(Acts, CountTheWordsOfTheirSentences) {
  EXPECT_EQ(summary(acts("Zork gronk blarg flimm dork plim. Need a taxi")),
            "inform Taxi");
  EXPECT_EQ(summary(acts("Need a taxi. Zork gronk blarg flimm dork plim")),
            "inform Taxi");
  EXPECT_EQ(summary(acts("zork gronk blarg flimm dork plim need a taxi")), "");
}

// "How about" in another sentence leads to nothing here.
TEST(Acts, AreLedToByWordsOfTheirSentence) {
  EXPECT_EQ(summary(acts("How about it all. Bank")),
            "~request Facility Category=bank");
  EXPECT_EQ(
      acts(
          "How about zork gronk blarg flimm. Is there a bank")[0]["confidence"],
      acts("Is there a bank")[0]["confidence"]);
}

TEST(Acts, AreDoneOnceThoughSaidTwice) {
  EXPECT_EQ(summary(acts("an umbrella, any raincoat")),
            "request Facility Category=shop");
}

TEST(Acts, AreMadeOfIslands) {
  struct {
    const char* text;
    const char* expected;
  } const cases[] = {
      {"", ""},
      // islands of one topic together
      {"I am Bob from Comptec at ten",
       "inform Appointment Visitor=Bob Organisation=Comptec Time=10:00"},
      // the topic's own act where the rule says none
      {"on the second floor", "~request Facility Location=2"},
      {"how about toilet", "~request Facility Category=toilet"},
      {"need a taxi", "inform Taxi"},
      // two sentences of one topic
      {"is there a bank and where is a toilet",
       "request Facility Category=bank + request Facility Category=toilet"},
      // corrections: before, between, of what is not wanted
      {"no, at ten", "correct Appointment Time=10:00"},
      {"at three sorry at four", "inform Appointment Time=16:00"},
      {"not at three", "deny Appointment Time=15:00"},
      {"not at three at four", "correct Appointment Time=16:00"},
      {"no", "deny"},
      {"no, where is a toilet", "deny + request Facility Category=toilet"},
      // courtesy is left out beside what matters, and said once
      {"thank you is there a bank", "request Facility Category=bank"},
      {"thank you thank you", "thank"},
  };
  for (const auto& [text, expected] : cases)
    EXPECT_EQ(summary(acts(text)), expected) << text;
}

TEST(Acts, BelowTheThresholdAreLeftOut) {
  const auto* text = "zig zag zog is there a bank";
  EXPECT_EQ(acts(text, 0.4).size(), 1U);
  EXPECT_EQ(acts(text, 0.9).size(), 0U);
}

} // namespace
} // namespace parlour::adapters::nlu::test
