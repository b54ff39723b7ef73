#include "script/dialogue/knowledge/knowledge_query.hpp"
#include "tests/script/dialogue/dialogue_fixture.hpp"

namespace parlour::dialogue {

namespace {

class Facts : public testing::Test {
protected:
  Facts() {
    auto& source = topic().queries[0];
    source.kind = "facts";
    source.facts = 0;
    app.program.facts.push_back(
        {"places",
         {{"name", "category", "level"},
          {"Starbucks", "Coffee shop", "1", "Food Chain", "Food court", "-1",
           "Ya Kun", "coffee  shop", "1", "Bank of Sand", "Bank", Value()}}});
  }
  script::Topic& topic() {
    return app.program.topics[app.facility];
  }
  ResultSet rows(std::vector<FrameChange> changes, bool relax = false) {
    auto frame = app.change(app.frame(app.facility), std::move(changes)).frame;
    KnowledgeQuery query(topic(), frame);
    auto statement = query.first();
    if (relax)
      statement = query.next();
    return query_facts(app.program, topic(), *statement);
  }
  static List names(const ResultSet& rows) {
    List names;
    for (std::size_t row = 0; row < rows.row_count(); ++row)
      names.push_back(*rows.cell(row, "name"));
    return names;
  }

  Receptionist app;
  SlotId category = app.id(app.facility, "Category");
  SlotId location = app.id(app.facility, "Location");
};

TEST_F(Facts, AreFoundByEqualValuesWhateverTheCase) {
  EXPECT_EQ(names(rows({fill(category, "COFFEE shop")})),
            (List{"Starbucks", "Ya Kun"}));
  EXPECT_EQ(names(rows({fill(location, -1)})), (List{"Food Chain"}));
  EXPECT_EQ(rows({}).row_count(), 4u);
}

TEST_F(Facts, AreFoundWithLess) {
  const std::vector changes{fill(category, "food court"), fill(location, 2)};
  EXPECT_TRUE(names(rows(changes)).empty());
  EXPECT_EQ(names(rows(changes, true)), (List{"Food Chain"}));
}

TEST_F(Facts, AreFoundByPrefixAndPart) {
  auto& by = topic().queries[0].by[0];
  by.match = script::Match::prefix;
  EXPECT_EQ(names(rows({fill(category, "food")})), (List{"Food Chain"}));
  EXPECT_TRUE(names(rows({fill(category, "court")})).empty());
  by.match = script::Match::contains;
  EXPECT_EQ(names(rows({fill(category, "court")})), (List{"Food Chain"}));
}

TEST_F(Facts, ComeInOrder) {
  topic().queries[0].order = "name desc";
  EXPECT_EQ(names(rows({})),
            (List{"Ya Kun", "Starbucks", "Food Chain", "Bank of Sand"}));
  topic().queries[0].order = "name";
  EXPECT_EQ(names(rows({}))[0], Value("Bank of Sand"));
}

TEST_F(Facts, ComeInTheOrderOfSeveralColumnsAndOfNumbers) {
  auto& rows_there = app.program.facts[0].rows;
  rows_there.cells = {"A", "x", "10", "B", "y", "9", "C", "y", "-1"};
  topic().queries[0].order = "level";
  EXPECT_EQ(names(rows({})), (List{"C", "B", "A"}));
  topic().queries[0].order = "category desc, level";
  EXPECT_EQ(names(rows({})), (List{"C", "B", "A"}));
  topic().queries[0].order = "category desc, level desc";
  EXPECT_EQ(names(rows({})), (List{"B", "C", "A"}));
}

} // namespace

} // namespace parlour::dialogue
