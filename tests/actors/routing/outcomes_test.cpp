#include <gtest/gtest.h>

#include "actors/routing/outcomes.hpp"

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

TEST(Outcomes, RowsAreNotCopied) {
  Message event;
  event.command = "Result";
  event.params = {ResultSet{{"name"}, {"Ann"}}};
  EXPECT_EQ(outcome_of(event)->if_result(), event.params[0].if_result());
}

} // namespace
} // namespace parlour::actors
