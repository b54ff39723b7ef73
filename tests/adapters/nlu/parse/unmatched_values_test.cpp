#include "adapters/nlu/parse/unmatched_values.hpp"
#include "tests/adapters/nlu/stages.hpp"

namespace parlour::adapters::nlu::test {
namespace {

constexpr const char* grammar = R"(
  public <ask> = (where is | what is) @Facility.Category [near here]
    {act=request} {topic=Facility};
  public <for> = for the @Facility.Category;)";

// The words of the values that are left; each once.
template <class Filter>
std::string left(const char* text, const Value& context, Filter filter) {
  Stages stages(grammar, text, context);
  auto islands = stages.islands;
  filter(islands, stages);
  std::string made;
  for (const auto& island : islands)
    for (const auto& fill : island.fills) {
      const auto words = stages.words(fill.begin, fill.end);
      if (made.find(words) == std::string::npos)
        made += (made.empty() ? "" : ", ") + words;
    }
  return made;
}

std::string likely(const char* text, const char* asked = "") {
  return left(text, sample_context(asked),
              [](std::vector<Island>& islands, Stages& stages) {
                leave_out_unlikely_values(islands, stages.utterance,
                                          stages.spans, stages.schema,
                                          stages.context);
              });
}

TEST(UnlikelyValues, NeedAWordThatSaysWhatIsWanted) {
  EXPECT_EQ(likely("where is a helipad"), "helipad");
  EXPECT_EQ(likely("what is a helipad"), "");
  EXPECT_EQ(likely("what is a helipad near here"), "helipad");
  EXPECT_EQ(likely("for the helipad"), "helipad");
  EXPECT_EQ(likely("granny pays for the helipad"), "");
  // What is known is known.
  EXPECT_EQ(likely("what is a bank"), "bank");
}

TEST(UnlikelyValues, AreNoneBesideOtherWords) {
  EXPECT_EQ(likely("tell granny where is a helipad"), "");
  EXPECT_EQ(likely("granny, where is a helipad"), "helipad");
}

TEST(UnlikelyValues, AreNames) {
  EXPECT_EQ(likely("where is a helipad to land on"), "");
  EXPECT_EQ(likely("where is big red round old helipad"), "");
  EXPECT_EQ(likely("where is a red bank"), "bank");
}

// The acts that an application with rules, people and places understands.
std::string acts_of(const char* text) {
  UnderstandingModel model;
  const std::vector<std::string> people{
      "Ann Lee",   "Bo Tan",   "Cai Wu",    "Dee Kay",  "Eva Sim",
      "Finn Hale", "Gus Moor", "Hetty Orr", "Ivo Lund", "Jan Pohl"};
  model.topics = {
      {"Call", false, {{"Who", "set", people, "", true, false}}, {}},
      {"Way",
       true,
       {{"Clinic", "set", {"Lung clinic", "Eye clinic"}, "", false, true}},
       {}},
      {"Visit",
       true,
       {{"Ward", "set", {"Ward 4B lungs", "Ward 2A eyes"}, "", false, true}},
       {}}};
  model.grammars = {{"x",
                     "#JSGF V1.0; grammar x;"
                     "public <call> = call @Call.Who;"
                     "public <has> = does @Call.Who have [a meeting];"
                     "public <mum> = my mum up to @Visit.Ward;",
                     {}}};
  const auto engine = NluEngine::build(model, sample_column, {0.4, {}});
  return engine ? summary(engine->understand(text, sample_context("")).acts)
                : to_string(engine.error().front());
}

TEST(UnlikelyValues, PeopleHaveNoDeterminer) {
  EXPECT_EQ(acts_of("does my computer have a meeting"), "");
  EXPECT_EQ(acts_of("does zorro have a meeting"), "inform Call Who=zorro?");
  EXPECT_EQ(acts_of("call my wife"), "inform Call Who=wife?");
}

TEST(FarFetchedValues, AreInSentencesThatAreHardlyUnderstood) {
  EXPECT_EQ(acts_of("well, call zorro"), "inform Call Who=zorro?");
  EXPECT_EQ(acts_of("granny call zorro"), "");
  // A capital letter within the text tells a name.
  EXPECT_EQ(acts_of("granny call Zorro"), "inform Call Who=Zorro?");
  EXPECT_EQ(acts_of("granny call ann lee"), "inform Call Who=Ann Lee");
}

TEST(UnlikelyValues, AreExpectedWhereTheConversationIsAboutThem) {
  EXPECT_EQ(likely("what is a helipad", "Facility"), "helipad");
  EXPECT_EQ(likely("what is a helipad", "Facility.Category"), "helipad");
}

TEST(Lookalikes, AreLeftOutBesideOtherWords) {
  EXPECT_EQ(acts_of("Hetti Ore"), "~inform Call Who=Hetty Orr");
  EXPECT_EQ(acts_of("what colour has hetti ore"), "");
  EXPECT_EQ(acts_of("call hetti ore"), "inform Call Who=Hetty Orr");
}

TEST(PiecesOfValues, BelongToTheWhole) {
  EXPECT_EQ(acts_of("my mum up to the lungs"),
            "~request Visit Ward=Ward 4B lungs");
  EXPECT_EQ(acts_of("my mum up to the lung clinic"),
            "~request Way Clinic=Lung clinic");
}

// Topic 2 takes any words; the time is asked for.
TEST(RivalsOfAnswers, AreLeftOut) {
  constexpr const char* rivals = R"(
    public <at> = at @time {Time} {topic=Appointment} {act=inform};
    public <there> = at @time and @Facility.Name {topic=Facility}
      {act=request};)";
  const auto topics = [&](const char* asked) {
    Stages stages(rivals, "at three and tomfoolery", sample_context(asked));
    auto islands = stages.islands;
    leave_out_rivals_of_answers(islands, stages.spans, stages.context);
    return std::ranges::any_of(islands, [](const Island& island) {
      return island.find("Name") != nullptr;
    });
  };
  EXPECT_FALSE(topics("Appointment.Time"));
  EXPECT_TRUE(topics("Appointment.Visitor"));
  EXPECT_TRUE(topics(""));
}

} // namespace
} // namespace parlour::adapters::nlu::test
