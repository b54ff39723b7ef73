#include "adapters/nlu/parse/island_filters.hpp"
#include "tests/adapters/nlu/stages.hpp"

namespace parlour::adapters::nlu::test {
namespace {

constexpr const char* grammar = R"(
  public <ask> = is there @Facility.Category {act=request} {topic=Facility};
  public <meet> = with @db:staff.name {Host} {act=inform} {topic=Appointment};
  public <words> = could need;)";

// The values of a slot that a filter leaves, in their order.
template <class Filter>
std::vector<std::string> left(const char* slot, const char* text,
                              Filter filter) {
  Stages stages(grammar, text);
  auto islands = stages.islands;
  filter(islands, stages);
  std::vector<std::string> made;
  for (const auto& island : islands)
    if (const auto* fill = island.find(slot))
      made.push_back(stages.words(fill->begin, fill->end));
  return made;
}

using Lines = std::vector<std::string>;

TEST(IslandFilters, LeaveOutWhatIsNoName) {
  const auto unnamed = [](std::vector<Island>& islands, Stages& stages) {
    leave_out_unnamed(islands, stages.utterance, stages.spans);
  };
  const auto kept = [&](const char* text) {
    return left("Category", text, unnamed);
  };
  EXPECT_EQ(kept("is there a helipad"), Lines{"helipad"});
  EXPECT_EQ(kept("is there a moment"), Lines());
  EXPECT_EQ(kept("is there postponed"), Lines());
  EXPECT_EQ(kept("is there anywhere I could need"), Lines());
  EXPECT_EQ(kept("is there a bank"), Lines{"bank"});
}

TEST(IslandFilters, LeaveOutOneOfSeveralBesideACertainOne) {
  const auto guesses = [](std::vector<Island>& islands, Stages& stages) {
    static RuleInfo bare;
    bare.bare = true;
    for (auto& island : islands)
      island.rule = &bare;
    leave_out_guesses(islands, stages.spans, stages.schema);
  };
  const auto kept = [&](const char* text) {
    auto made = left("Host", text, guesses);
    made.erase(std::unique(made.begin(), made.end()), made.end());
    return made;
  };
  EXPECT_EQ(kept("with Hui Min"), Lines{"Hui Min"});
  EXPECT_EQ(kept("with Hui Min. So with Ho Hui Min"), Lines{"Ho Hui Min"});
  EXPECT_EQ(kept("with Hui Min. So with Tan"), (Lines{"Hui Min", "Tan"}));
  // Somebody else, not one of several.
  EXPECT_EQ(kept("with Ho Hui Min. So with Tan"), (Lines{"Ho Hui Min", "Tan"}));
}

TEST(IslandFilters, LeaveOutStrangersOfAnotherTopic) {
  const auto strangers = [](std::vector<Island>& islands, Stages& stages) {
    leave_out_strangers(islands, stages.utterance, stages.spans, {});
  };
  const auto kept = [&](const char* text) {
    return left("Host", text, strangers);
  };
  EXPECT_EQ(kept("Is there a bank so with clients"), Lines());
  EXPECT_EQ(kept("Is there a bank so with Clients"), Lines{"Clients"});
  EXPECT_EQ(kept("Is there a bank so with Jeffery Ho"), Lines{"Jeffery Ho"});
  EXPECT_EQ(kept("Is there a bank? I come with clients"), Lines{"clients"});
  EXPECT_EQ(kept("I come with clients"), Lines{"clients"});
}

// A story with a number in it is none the less one.
TEST(IslandFilters, LeaveOutStoriesOfStrangersWithOtherValues) {
  const auto kept = [](const char* text, const char* current) {
    Stages stages(R"(
      public <ask> = is there @Facility.Category {act=request} {topic=Facility};
      public <had> = we have @db:staff.name {Host} at @time {Time}
        {act=inform} {topic=Appointment};)",
                  text);
    auto islands = stages.islands;
    Context context;
    context.current = stages.schema.topic(current);
    leave_out_strangers(islands, stages.utterance, stages.spans, context);
    return std::ranges::any_of(islands, [](const Island& island) {
      return island.find("Host") != nullptr;
    });
  };
  EXPECT_FALSE(kept("We have meetings at ten. Is there a bank", "Taxi"));
  EXPECT_TRUE(kept("We have Jeffery Ho at ten. Is there a bank", "Taxi"));
  EXPECT_TRUE(kept("We have meetings at ten", "Taxi"));
  // Nothing else is gone on with.
  EXPECT_TRUE(kept("We have meetings at ten. Is there a bank", "Appointment"));
  EXPECT_TRUE(kept("We have meetings at ten. Is there a bank", ""));
}

TEST(IslandFilters, LeaveOutStrangersBesideASentenceOfAnyWords) {
  const auto kept = [](const char* text) {
    Stages stages(R"(
      public <buy> = where is the @words {Category} {act=request} {topic=Facility};
      public <meet> = my head is @db:staff.name {Host} {act=inform} {topic=Appointment};)",
                  text);
    auto islands = stages.islands;
    leave_out_strangers(islands, stages.utterance, stages.spans, {});
    return std::ranges::count_if(islands, [](const Island& island) {
      const auto* host = island.find("Host");
      return host && host->begin == 3;
    });
  };
  EXPECT_EQ(kept("My head is splitting. Where is the chemist"), 0);
  EXPECT_EQ(kept("My head is Splitting. Where is the chemist"), 1);
  EXPECT_EQ(kept("My head is Anand Menon. Where is the chemist"), 1);
  EXPECT_EQ(kept("My head is splitting"), 1);
}

// In one sentence, what is told before an order is left out, not what is asked.
TEST(IslandFilters, LeaveOutStrangersThatAreToldBeforeAnOrder) {
  const auto kept = [](const char* text) {
    Stages stages(R"(
      public <find> = find @Facility.Category {act=request} {topic=Facility};
      public <see> = we see @db:staff.name {Host} {act=inform} {topic=Appointment};
      public <is> = is it @db:staff.name {Host} {act=request} {topic=Appointment};)",
                  text);
    auto islands = stages.islands;
    leave_out_strangers(islands, stages.utterance, stages.spans, {});
    return std::ranges::any_of(islands, [](const Island& island) {
      return island.find("Host") != nullptr;
    });
  };
  EXPECT_FALSE(kept("We see clouds, find the bank"));
  EXPECT_TRUE(kept("We see Clouds, find the bank"));
  EXPECT_TRUE(kept("We see Jeffery Ho, find the bank"));
  EXPECT_TRUE(kept("Is it clouds, find the bank"));
  EXPECT_TRUE(kept("Find the bank, we see clouds"));
}

// Who rang yesterday comes on another day.
TEST(IslandFilters, LeaveOutDaysThatAreOver) {
  const auto kept = [](const char* text, const std::string& asked) {
    Stages stages(R"(
      public <meet> = with @db:staff.name {Host} {act=inform} {topic=Appointment};
      public <when> = @date {Date} {topic=Appointment};)",
                  text, sample_context(asked));
    auto islands = stages.islands;
    leave_out_stories(islands, stages.utterance, stages.spans, stages.context);
    return std::ranges::count_if(
        islands, [](const Island& island) { return island.find("Date"); });
  };
  EXPECT_EQ(kept("With Anand Menon. He rang me yesterday.", ""), 0);
  EXPECT_EQ(kept("With Anand Menon. He waits tomorrow.", ""), 1);
  EXPECT_EQ(kept("With Anand Menon yesterday.", ""), 1);
  EXPECT_EQ(kept("With Anand Menon. He rang yesterday.", "Appointment"), 1);
  EXPECT_EQ(kept("Yesterday.", ""), 1);
}

// "stop" by itself is an act, and one behind what a rule reads is, too.
TEST(IslandFilters, LeaveOutActsThatArePartsOfWhatIsAsked) {
  const auto acts = [](const char* text) {
    Stages stages(R"(
      public <stop> = stop {act=cancel};
      public <ask> = where is the bus stop {act=request} {topic=Facility};
      public <halt> = stop at the bank {act=request} {topic=Facility};)",
                  text);
    auto islands = stages.islands;
    leave_out_acts_inside(islands, stages.utterance, stages.spans);
    return std::ranges::count(islands, "cancel", &Island::act);
  };
  EXPECT_EQ(acts("where is the bus stop"), 0);
  EXPECT_EQ(acts("stop at the bank and stop"), 2);
  EXPECT_EQ(acts("stop at the bank"), 1);
  EXPECT_EQ(acts("stop"), 1);
}

} // namespace
} // namespace parlour::adapters::nlu::test
