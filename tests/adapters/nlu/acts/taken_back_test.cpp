#include <gtest/gtest.h>

#include "adapters/nlu/acts/taken_back.hpp"
#include "tests/adapters/nlu/sample.hpp"

namespace parlour::adapters::nlu::test {
namespace {

// An order of several dishes.
std::string ordered(const std::string& text, const std::string& asked = "") {
  UnderstandingModel model;
  model.topics = {
      {"Order",
       false,
       {{"Dish",
         "set",
         {"burger", "chips", "beer", "cola", "orange juice", "tomato soup"},
         "",
         true,
         false,
         true}},
       {"I take a [burger](Dish)"}}};
  model.grammars = {{"order",
                     R"(<dish> = [a | an | the | some | those | two | three]
            (@Order.Dish | [paper] (napkin | napkins) {Dish=napkin});
          public <order> = [i take | bring me] <dish> [[and | or] <dish>]
            [[and] <dish>] {topic=Order} {act=inform};
          public <amount> = (make it | instead) <dish> {topic=Order} {act=correct};)",
                     {"order.jsgf", 1, 1}}};
  static const auto built =
      NluEngine::build(model, {}, {0.4, {generic_grammar()}});
  std::string line;
  for (const auto& act : built->understand(text, sample_context(asked)).acts) {
    line += (line.empty() ? "" : " + ") + act["act"].text();
    if (const auto* items = act["slots"]["Dish"]["items"].if_list())
      for (const auto& item : *items)
        line += " " + item["value"].text();
  }
  return line;
}

TEST(TakenBack, IsWhatIsSaidNotToBeWanted) {
  EXPECT_EQ(ordered("Bring me the soup and chips. And a beer. Oh, no, no beer, "
                    "an orange juice."),
            "inform tomato soup chips orange juice");
  EXPECT_EQ(ordered("a burger and a beer. No, not the beer, a cola"),
            "inform burger cola");
  EXPECT_EQ(ordered("a burger and chips, no beer"), "inform burger chips");
}

TEST(TakenBack, IsSaidInManyWays) {
  for (const auto* how :
       {"drop the", "forget the", "leave out the", "leave off the", "scrap the",
        "no", "no more", "actually no"})
    EXPECT_EQ(ordered(std::string("a cola, a burger and a beer, oh, ") + how +
                      " beer"),
              "inform cola burger")
        << how;
}

TEST(TakenBack, IsDeniedWhereItMayHaveBeenSaidEarlier) {
  EXPECT_EQ(ordered("a burger without chips", "Order"),
            "deny chips + inform burger");
  EXPECT_EQ(ordered("a cola instead of the beer", "Order"),
            "deny beer + inform cola");
}

TEST(TakenBack, IsWhatIsMendedAtOnce) {
  EXPECT_EQ(ordered("a burger, no, sorry, the chips"), "inform chips");
  EXPECT_EQ(ordered("a beer, I mean a cola, and chips"), "inform cola chips");
}

TEST(TakenBack, MayBeWhatARuleWrites) {
  EXPECT_EQ(ordered("some chips and a paper napkin, without the napkin"),
            "inform chips");
  EXPECT_EQ(ordered("a napkin and a beer, no, no napkins"), "inform beer");
  EXPECT_EQ(ordered("two beers and a cola without those beers"), "inform cola");
}

TEST(TakenBack, IsNothingBehindANoThatStandsAlone) {
  EXPECT_EQ(ordered("no, a beer", "Order"), "correct beer");
  EXPECT_EQ(ordered("a burger, oh, and a beer"), "inform burger beer");
}

// Summaries of what is left of the breath.
std::string left(const char* text, const std::string& asked = "",
                 const char* question = nullptr) {
  static const auto engine = sample();
  auto context = *sample_context(asked).if_map();
  if (question)
    context.set("confirms", question);
  return summary(engine.understand(text, Value(context)).acts);
}

TEST(TakenBack, MayBeAllThatIsWanted) {
  for (const auto* text : {"I need a taxi, no, don't", "I need a taxi? No."})
    EXPECT_EQ(left(text), "deny") << text;
  for (const auto* text :
       {"I need a taxi, forget it", "I need a taxi at 10:00. Never mind."})
    EXPECT_EQ(left(text), "cancel") << text;
}

TEST(TakenBack, IsNotWhatIsAllThatIsWanted) {
  for (const auto* text :
       {"I need a taxi. No, nothing else, thanks.",
        "I need a taxi, no, that's all", "I need a taxi. Is it far? No."})
    EXPECT_EQ(left(text).find("inform Taxi"), 0U) << text << left(text);
}

TEST(TakenBack, IsNoEnquiryNorWhatIsSaidBehindIt) {
  EXPECT_EQ(left("where is the bank, forget it").find("request Facility"), 0U);
  EXPECT_EQ(left("forget it, I need a taxi"), "cancel + inform Taxi");
}

// A no may be the answer then.
TEST(TakenBack, NeedsMoreThanANoWhileSomethingIsAsked) {
  EXPECT_EQ(left("I need a taxi, no", "Appointment.Visitor"),
            "inform Taxi + deny");
  EXPECT_EQ(left("I need a taxi, no", "", "Is it you?"), "inform Taxi + deny");
  EXPECT_EQ(left("I need a taxi, forget it", "Taxi.Time"), "cancel");
}

} // namespace
} // namespace parlour::adapters::nlu::test
