#include <gtest/gtest.h>

#include "tools/parlour/reference/entry_text.hpp"

namespace parlour::tools {
namespace {

const Entry& lift() {
  static const Entry entry{
      "lift",
      "<lift>",
      "a lift [of](a) *hotel*",
      {{"stands in", "<hotel>, and in whatever else has more than one floor "
                     "where guests live"},
       {"told in", "5.1"}},
      {{"floor", "needed; a number", "where it <stops>"}},
      "<lift floor=\"2\"/>\n<lift/>"};
  return entry;
}

TEST(EntryText, StandsInColumnsThatFitATerminal) {
  EXPECT_EQ(
      entry_text(lift()),
      "<lift>: a lift [of](a) *hotel*\n"
      "  stands in  <hotel>, and in whatever else has more than one floor "
      "where guests\n"
      "             live\n"
      "  told in    language rule 5.1 (script/LANGUAGE.md)\n"
      "\n"
      "  floor      needed; a number; where it <stops>\n"
      "\n"
      "  <lift floor=\"2\"/>\n"
      "  <lift/>\n");
}

TEST(EntryText, SaysNothingTwice) {
  const Entry entry{"a", "<a>", "b", {}, {{"c", "needed; a key", "a key"}}};
  EXPECT_EQ(entry_text(entry), "<a>: b\n  c  needed; a key\n");
}

TEST(EntryText, KnowsPlaces) {
  EXPECT_EQ(place_text("engine 4.5"), "engine rule 4.5 (docs/engine.md)");
  EXPECT_EQ(place_text("docs/test.md"), "docs/test.md");
}

} // namespace
} // namespace parlour::tools
