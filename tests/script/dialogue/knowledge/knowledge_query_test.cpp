#include "script/dialogue/knowledge/knowledge_query.hpp"
#include "tests/script/dialogue/dialogue_fixture.hpp"

namespace parlour::dialogue {

namespace {

class Knowledge : public testing::Test {
protected:
  KnowledgeQuery query(std::vector<FrameChange> changes) {
    auto frame = app.frame(app.facility);
    return {topic(), app.change(frame, std::move(changes)).frame};
  }
  script::Topic& topic() {
    return app.program.topics[app.facility];
  }

  Receptionist app;
  SlotId category = app.id(app.facility, "Category");
  SlotId location = app.id(app.facility, "Location");
};

using Relaxed = std::vector<std::string>;

TEST_F(Knowledge, AsksWithTheFilledSlotsBound) {
  auto both = query({fill(category, "coffee shop"), fill(location, 2)});
  auto statement = both.first();
  ASSERT_TRUE(statement);
  EXPECT_EQ(statement->kind, "db");
  EXPECT_EQ(statement->sql, "select name, level from rr_facility where "
                            "lower(category) = lower(?) and level = ?");
  EXPECT_EQ(statement->values, (List{"coffee shop", 2}));
  EXPECT_EQ(statement->asked,
            Value(Map{{"Category", "coffee shop"}, {"Location", 2}}));
  EXPECT_TRUE(statement->relaxed.empty());
}

TEST_F(Knowledge, LeavesOutWhatMayBeRelaxedThenGivesUp) {
  auto both = query({fill(category, "coffee shop"), fill(location, 2)});
  both.first();
  auto relaxed = both.next();
  ASSERT_TRUE(relaxed);
  EXPECT_EQ(relaxed->sql, "select name, level from rr_facility where "
                          "lower(category) = lower(?)");
  EXPECT_EQ(relaxed->values, (List{"coffee shop"}));
  EXPECT_EQ(relaxed->relaxed, (Relaxed{"Location"}));
  EXPECT_EQ(relaxed->asked,
            Value(Map{{"Category", "coffee shop"}, {"Location", 2}}));
  EXPECT_FALSE(both.next());
  EXPECT_FALSE(both.next());
}

TEST_F(Knowledge, WhatWasNotAskedIsNotRelaxed) {
  auto one = query({fill(category, "bank")});
  EXPECT_TRUE(one.first());
  EXPECT_FALSE(one.next());
}

TEST_F(Knowledge, TheLowestRelaxGoesFirst) {
  topic().queries[0].by[0].relax = 2;
  auto both = query({fill(category, "bank"), fill(location, 2)});
  both.first();
  EXPECT_EQ(both.next()->relaxed, (Relaxed{"Location"}));
  auto last = both.next();
  EXPECT_EQ(last->relaxed, (Relaxed{"Location", "Category"}));
  EXPECT_EQ(last->sql, "select name, level from rr_facility");
  EXPECT_FALSE(both.next());
}

TEST_F(Knowledge, TheNextSourceIsAskedWhole) {
  script::KnowledgeSource facts;
  facts.kind = "facts";
  facts.name = "places";
  facts.by = topic().queries[0].by;
  topic().queries.push_back(facts);
  auto both = query({fill(category, "bank"), fill(location, 2)});
  both.first();
  both.next();
  auto second = both.next();
  ASSERT_TRUE(second);
  EXPECT_EQ(second->kind, "facts");
  EXPECT_EQ(second->name, "places");
  EXPECT_EQ(second->source, 1u);
  EXPECT_TRUE(second->sql.empty());
  EXPECT_TRUE(second->relaxed.empty());
  EXPECT_EQ(both.next()->relaxed, (Relaxed{"Location"}));
  EXPECT_FALSE(both.next());
}

TEST_F(Knowledge, PrefixAndContainsAreLike) {
  topic().queries[0].by[0].match = script::Match::contains;
  topic().queries[0].order = "name";
  auto part = query({fill(category, "50%")});
  auto statement = part.first();
  EXPECT_EQ(statement->sql,
            "select name, level from rr_facility where "
            "lower(category) like lower(?) escape '!' order by name");
  EXPECT_EQ(statement->values, (List{"%50!%%"}));
  topic().queries[0].by[0].match = script::Match::equal;
  topic().slots[category].match = script::Match::prefix; // the slot's own
  EXPECT_EQ(part.first()->values, (List{"50!%%"}));
}

TEST_F(Knowledge, UnconfirmedSlotsAreNotAskedWith) {
  auto unsure = query({fill(category, "bank"), fill(location, 2, 0.5)});
  EXPECT_EQ(unsure.first()->values, (List{"bank"}));
}

TEST_F(Knowledge, ATopicWithoutQueryAsksNothing) {
  KnowledgeQuery none(app.program.topics[app.taxi],
                      std::make_shared<const TopicFrame>(app.frame(app.taxi)));
  EXPECT_FALSE(none.first());
  EXPECT_FALSE(none.next());
}

} // namespace

} // namespace parlour::dialogue
