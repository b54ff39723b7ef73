#include <gtest/gtest.h>

#include "actors/support/life_table.hpp"

namespace parlour::actors {
namespace {

enum class State { asleep, awake };
enum class Event { morning, evening };
enum class Deed { stretch, yawn };
using Row = LifeRow<State, Event, Deed>;
using Table = LifeTable<Row, 2, 2>;

constexpr Table table{{{{State::asleep,
                         Event::morning,
                         State::awake,
                         {Deed::yawn, Deed::stretch}},
                        {State::asleep, Event::evening, std::nullopt},
                        {State::awake, Event::morning, std::nullopt},
                        {State::awake, Event::evening, State::asleep}}}};
static_assert(table.is_complete());

TEST(LifeTable, KnowsWhatFollowsAndWhatIsToBeDone) {
  const auto& row = table.at(State::asleep, Event::morning);
  EXPECT_EQ(row.next, State::awake);
  EXPECT_EQ(std::vector(row.deeds.begin(), row.deeds.end()),
            (std::vector{Deed::yawn, Deed::stretch}));
  EXPECT_EQ(table.at(State::asleep, Event::evening).next, std::nullopt);
}

TEST(LifeTable, ARowThatIsMissingOrTwiceOrElsewhereIsSeen) {
  auto wrong = table;
  std::swap(wrong.rows[0], wrong.rows[1]);
  EXPECT_FALSE(wrong.is_complete());
  wrong = table;
  wrong.rows[3] = wrong.rows[2];
  EXPECT_FALSE(wrong.is_complete());
}

} // namespace
} // namespace parlour::actors
