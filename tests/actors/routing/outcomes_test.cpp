#include "actors/routing/outcomes.hpp"
#include "tests/actors/bench.hpp"

namespace parlour::actors {
namespace {

TEST(Outcomes, OfEachEvent) {
  Message event;
  event.command = "Result";
  EXPECT_EQ(outcome_of(event)->if_result()->row_count(), 0u);
  event.command = "Error";
  event.params = {"Database", "locked"};
  EXPECT_EQ(outcome_of(event).error().message, "locked");
  struct {
    const char* named;
    ErrorKind kind;
  } const cases[] = {
      {"Database", ErrorKind::database}, {"Refused", ErrorKind::refused},
      {"Limit", ErrorKind::limit},       {"Timeout", ErrorKind::timeout},
      {"Offline", ErrorKind::offline},   {"Whatever", ErrorKind::database}};
  for (const auto& [named, kind] : cases) {
    event.params = {named, "no"};
    EXPECT_EQ(outcome_of(event).error().kind, kind) << named;
  }
  event.params = {"Timeout"}; // words, no kind
  EXPECT_EQ(outcome_of(event).error().kind, ErrorKind::database);
  event.command = "Failed";
  event.params = {"Timeout", "no"};
  EXPECT_EQ(outcome_of(event).error().kind, ErrorKind::database);
}

// Only a database names the kind of its errors.
TEST(Outcomes, ARefusalNamesWhoRefused) {
  Bench bench;
  bench.set_table(
      {bench.target("db", {"Database"}), bench.target("Oven", {"Robot"})});
  const auto table = bench.bus.table();
  auto refused = event("db", "Error", {"Timeout", "locked"});
  EXPECT_EQ(refusal_of(*table, refused).kind, ErrorKind::timeout);
  EXPECT_EQ(refusal_of(*table, refused).message, "db: locked");
  refused = event("Oven", "Error", {"Timeout", "too hot"});
  EXPECT_EQ(refusal_of(*table, refused).kind, ErrorKind::refused);
  EXPECT_EQ(refusal_of(*table, refused).message, "Oven: too hot");
}

TEST(Outcomes, RowsAreNotCopied) {
  Message event;
  event.command = "Result";
  event.params = {ResultSet{{"name"}, {"Ann"}}};
  EXPECT_EQ(outcome_of(event)->if_result(), event.params[0].if_result());
}

} // namespace
} // namespace parlour::actors
