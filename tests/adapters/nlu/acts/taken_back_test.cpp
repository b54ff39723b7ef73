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

} // namespace
} // namespace parlour::adapters::nlu::test
