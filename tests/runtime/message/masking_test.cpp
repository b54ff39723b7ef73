#include <gtest/gtest.h>

#include "runtime/message/masking.hpp"

namespace parlour {

namespace {

Secrets secrets(std::initializer_list<const char*> texts) {
  Secrets all;
  for (const auto* text : texts)
    all.add(text);
  return all;
}

TEST(Secrets, AreMaskedInTexts) {
  const auto all = secrets({"Ann Lee", "91234567"});
  EXPECT_EQ(all.masked("I am ANN LEE, call 91234567."), "I am ***, call ***.");
  EXPECT_EQ(all.masked("9123 4567 or +6591234567"), "*** or +65***");
  EXPECT_EQ(all.masked("9123-45.67"), "***");
  EXPECT_EQ(all.masked("9123  4567"), "9123  4567");
  EXPECT_EQ(Secrets().masked("Ann Lee"), "Ann Lee");
}

TEST(Secrets, ThatAreShortStandAlone) {
  const auto all = secrets({"42", "é"});
  EXPECT_EQ(all.masked("42, 142, 42nd (42)"), "***, 142, 42nd (***)");
  EXPECT_EQ(all.masked("é été"), "*** été");
}

TEST(Secrets, ThatAreLongerComeFirst) {
  EXPECT_EQ(secrets({"1234", "12345"}).masked("12345"), "***");
  EXPECT_EQ(secrets({"12345", "1234"}).masked("12345 1234"), "*** ***");
}

TEST(Secrets, ThatAreBlankMaskNothing) {
  EXPECT_TRUE(secrets({"", " \n"}).empty());
  EXPECT_EQ(secrets({" 1234 "}).masked("1234"), "***");
}

TEST(Secrets, AreMaskedInValues) {
  const auto all = secrets({"1234"});
  const Value given = Map{{"list", List{1234, "pin 1234", true, 5}},
                          {"rows", ResultSet{{"pin"}, {"1234"}}}};
  EXPECT_EQ(to_string(all.masked_value(given)),
            "{list: [***, pin ***, true, 5], rows: [***]}");
  Message message;
  message.source = "Script";
  message.command = "Send";
  message.params = {1234, "hello"};
  EXPECT_EQ(to_string(all.masked_message(message)), "Script.Send(***, hello)");
}

TEST(AllMasked, LeavesNothingButTheForm) {
  EXPECT_EQ(to_string(all_masked(List{"a", 1, true, Map{{"b", 0.5}}})),
            "[***, ***, true, {b: ***}]");
}

} // namespace

} // namespace parlour
