#include "tests/adapters/nlu/stages.hpp"

namespace parlour::adapters::nlu::test {
namespace {

// Every kind of value is looked for.
constexpr const char* grammar = R"(
  public <a> = x @time; public <b> = x @level; public <c> = x @words;
  public <d> = x @db:staff.name; public <e> = x @Facility.Category;)";

using Lines = std::vector<std::string>;

// The words of each span, and those of its value where they are fewer.
Lines texts(const Stages& stages, Spans::Indices spans) {
  Lines made;
  for (const auto index : spans) {
    const auto& span = stages.spans[index];
    made.push_back(stages.words(span.begin, span.end));
    if (span.core != span.begin)
      made.back() += " (" + stages.words(span.core, span.end) + ")";
  }
  return made;
}

Lines known(const char* reference, const char* text, std::size_t position) {
  Stages stages(grammar, text);
  return texts(stages, stages.spans.at(stages.entity(reference), position));
}

Lines open(const char* reference, const char* text, std::size_t position) {
  Stages stages(grammar, text);
  return texts(stages,
               stages.spans.open(stages.entity(reference), position, 3));
}

TEST(Spans, AreWhereValuesStand) {
  EXPECT_EQ(known("time", "come at half past ten", 2), Lines{"half past ten"});
  EXPECT_EQ(known("time", "come at half past ten", 0), Lines());
  EXPECT_EQ(known("level", "on level b1", 1), Lines{"level b1"});
  EXPECT_EQ(known("date", "tomorrow", 0), Lines()); // no grammar has a date
  EXPECT_EQ(known("Facility.Category", "a food court", 1), Lines{"food court"});
}

TEST(Spans, TakeNoPronounForANumber) {
  EXPECT_EQ(known("level", "on level one", 1), Lines{"level one"});
  EXPECT_EQ(known("level", "one", 0), Lines{"one"});
  EXPECT_EQ(known("level", "one of those", 0), Lines());
  EXPECT_EQ(known("level", "I have got one", 3), Lines());
}

TEST(Spans, CountTitlesAndDeterminersIn) {
  EXPECT_EQ(known("db:staff.name", "meet Dr. Jeffery Ho", 1),
            Lines{"Dr. Jeffery Ho (Jeffery Ho)"});
  EXPECT_EQ(known("db:staff.name", "meet Dr. Jeffery Ho", 2),
            Lines{"Jeffery Ho"});
  EXPECT_EQ(known("Facility.Category", "any food court", 0),
            Lines{"any food court (food court)"});
  EXPECT_EQ(known("Facility.Category", "any, food court", 0), Lines());
}

TEST(Spans, KeepEquallyGoodValues) {
  Stages stages(grammar, "Hui Min");
  const auto found = stages.spans.at(stages.entity("db:staff.name"), 0);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(stages.spans[found[0]].values, (std::vector<std::uint32_t>{1, 3}));
}

TEST(Spans, OfOpenWordsEndWhereTheyMust) {
  EXPECT_EQ(open("words", "Comptec Asia Pacific East", 0),
            (Lines{"Comptec", "Comptec Asia", "Comptec Asia Pacific"}));
  EXPECT_EQ(open("words", "Comptec, Asia", 0), Lines{"Comptec"});
  EXPECT_EQ(open("words", "Bank of China", 0),
            (Lines{"Bank", "Bank of China"})); // not after "of"
  EXPECT_EQ(open("words", "to Bedok", 0), Lines());
  EXPECT_EQ(open("words", "the Fullerton", 0),
            Lines{"the Fullerton (Fullerton)"});
}

TEST(Spans, OfTheRestGoUpToTheEndOfTheClause) {
  Stages stages(grammar, "remind me to find the food court, please");
  EXPECT_EQ(
      texts(stages, stages.spans.rest(3)),
      (Lines{"find", "find the", "find the food", "find the food court"}));
  EXPECT_EQ(texts(stages, stages.spans.rest(7)), Lines{"please"});
}

TEST(Spans, OfWordsThatASetDoesNotHave) {
  EXPECT_EQ(open("Facility.Category", "helipad", 0), Lines{"helipad"});
  EXPECT_EQ(open("Facility.Category", "toilet", 0), Lines());
  Stages stages(grammar, "helipad");
  const auto entity = stages.entity("Facility.Category");
  const auto made = stages.spans.open(entity, 0, 3);
  EXPECT_TRUE(stages.spans[made.front()].unmatched);
  const auto again = stages.spans.open(entity, 0, 3);
  EXPECT_EQ(again.data(), made.data()); // made once
  EXPECT_TRUE(stages.spans.at(entity, 0).empty());
}

// The spans of hosts: words, candidates and confidence.
Lines hosts(const char* text, bool heard) {
  std::vector<Error> errors;
  const Schema schema(sample_model(), sample_people, errors);
  const auto entity = schema.at(0).find("Host")->entity;
  const Automaton automaton;
  const auto utterance = make_utterance(text, automaton);
  const Spans spans(schema, utterance, {entity}, {}, heard);
  Lines made;
  for (const auto& span : spans.all())
    made.push_back(
        std::string(words_of(text, utterance.tokens, span.begin, span.end)) +
        (span.weak ? " weakly " : " ") + std::to_string(span.values.size()) +
        (span.only_heard ? " doubted" : ""));
  return made;
}

TEST(Spans, OfHeardNamesAreWeakAndDoubted) {
  EXPECT_EQ(hosts("Koh Sok Hui", true).back(), "Koh Sok Hui weakly 1 doubted");
  EXPECT_EQ(hosts("Jeffery Ho", true).back(), "Jeffery Ho 1");
  for (const auto& line : hosts("Koh Sok Hui", false))
    EXPECT_EQ(line.find("doubted"), std::string::npos) << line;
}

TEST(Spans, OfNumbersHaveNoPronoun) {
  const auto is_number = [](const char* text, std::size_t at) {
    Stages stages("public <a> = @number {Host};", text);
    return !stages.spans.at(stages.entity("number"), at).empty();
  };
  EXPECT_FALSE(is_number("for the little one", 3));
  EXPECT_FALSE(is_number("the one for moles", 1));
  EXPECT_TRUE(is_number("in room one", 2));
}

} // namespace
} // namespace parlour::adapters::nlu::test
