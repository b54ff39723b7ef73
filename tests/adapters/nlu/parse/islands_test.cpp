#include "tests/adapters/nlu/stages.hpp"

namespace parlour::adapters::nlu::test {
namespace {

// "Topic|Topic act Slot='words' Slot=literal", for each island.
std::vector<std::string> read(const Stages& stages) {
  std::vector<std::string> made;
  for (const auto& island : stages.islands) {
    std::string text;
    for (const auto topic : island.topics)
      text += (text.empty() ? "" : "|") + stages.schema.at(topic).name;
    text += " " + island.act + (island.denies ? "!" : "");
    for (const auto& fill : island.fills)
      text += " " + fill.slot + "=" +
              (fill.literal ? fill.literal->text()
                            : "'" + stages.words(fill.begin, fill.end) + "'");
    made.push_back(text);
  }
  return made;
}

using Lines = std::vector<std::string>;

TEST(Islands, SayWhatARuleFills) {
  struct {
    const char* rule;
    const char* text;
    Lines expected;
  } const cases[] = {
      {"from @words {Organisation}",
       "from Comptec",
       {"Appointment  Organisation='Comptec'"}},
      // the value without what stands before it
      {"meet @db:staff.name {Host}",
       "meet Dr. Jeffery Ho",
       {"Appointment  Host='Jeffery Ho'"}},
      // the words of the part where there is no value in it
      {"a (big room) {Organisation}",
       "a big room",
       {"Appointment  Organisation='big room'"}},
      {"upstairs {Location=2}", "upstairs", {"Facility  Location=2"}},
      {"at @time {Time}", "at ten", {"Appointment|Taxi  Time='ten'"}},
      {"at @time {Taxi.Time}", "at ten", {"Taxi  Time='ten'"}},
      {"at @time {Time} to @words {Destination}",
       "at ten to Bedok",
       {"Taxi  Time='ten' Destination='Bedok'"}},
      {"@Facility.Category here",
       "toilet here",
       {"Facility  Category='toilet'"}},
      {"thank you {act=thank}", "thank you", {" thank"}},
      {"cab {topic=Taxi} {act=inform}", "cab", {"Taxi inform"}},
      {"not {act=deny} {denies=next}", "not", {" deny!"}},
  };
  for (const auto& [rule, text, expected] : cases)
    EXPECT_EQ(read(Stages(std::string("public <r> = ") + rule + ";", text)),
              expected)
        << rule;
}

TEST(Islands, ThatMixTopicsMakeNoSense) {
  EXPECT_EQ(read(Stages("public <r> = (@level {Location}|@words {Visitor}) "
                        "for @words {Destination};",
                        "Bob for Bedok")),
            Lines());
}

TEST(Islands, FillWhatWasAskedFor) {
  const Stages stages("public <r> = it is @asked;", "it is ten",
                      sample_context("Taxi.Time"));
  EXPECT_EQ(read(stages), Lines{"Taxi  Time='ten'"});
  EXPECT_TRUE(stages.islands.at(0).asked);
}

TEST(Islands, AreOfTheQuestionsOwnGrammarOnly) {
  const auto* grammar = "public <r> = cab {topic=Taxi};";
  const auto of = [&](const char* name) {
    return read(Stages(grammar, "cab", Value(Map{{"grammar", name}})));
  };
  EXPECT_EQ(of("g").size(), 1U);
  EXPECT_EQ(of("other").size(), 0U);
}

TEST(Islands, AreMarkersOrContent) {
  const Stages stages("public <a> = no {act=deny}; public <b> = "
                      "hello {act=greet}; public <c> = cab {topic=Taxi};",
                      "no hello cab");
  ASSERT_EQ(stages.islands.size(), 3U);
  const bool expected[][2] = {{true, false}, {false, false}, {false, true}};
  for (std::size_t at = 0; at < 3; ++at) {
    EXPECT_EQ(stages.islands[at].is_marker(), expected[at][0]) << at;
    EXPECT_EQ(stages.islands[at].is_content(), expected[at][1]) << at;
  }
}

TEST(Islands, StandBeforeASentenceOrInIt) {
  const Stages stages("public <a> = no {act=deny}; public <c> = cab "
                      "{topic=Taxi}; public <d> = bus {topic=Taxi};",
                      "no, bus. cab");
  ASSERT_EQ(stages.islands.size(), 3U);
  const auto at = [&](std::uint32_t token) -> const Island& {
    return *std::ranges::find(stages.islands, token, &Island::begin);
  };
  const auto& tokens = stages.utterance.tokens;
  EXPECT_FALSE(is_before_sentence(at(0), at(1), tokens));
  EXPECT_TRUE(is_before_sentence(at(0), at(2), tokens));
  EXPECT_FALSE(is_before_sentence(at(2), at(0), tokens));
}

} // namespace
} // namespace parlour::adapters::nlu::test
