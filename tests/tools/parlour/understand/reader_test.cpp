#include "tests/tools/parlour/application_fixture.hpp"
#include "tools/parlour/understand/reader.hpp"

namespace parlour::tools {
namespace {

class ReaderTest : public ApplicationTest {
protected:
  auto open(const std::string& columns_are_in) const {
    folder_.write("schema.sql", columns_are_in);
    application_ = load(guest_settings, "<include href=\"parlour:pipeline\"/>" +
                                            std::string(guest_topic));
    return Reader::open(application_,
                        *first_of_role(application_.composition, "NLU"),
                        *parse_timestamp("2026-11-24 09:00"));
  }

  mutable Application application_;
};

TEST_F(ReaderTest, reads_as_the_application_does) {
  auto reader = open(guest_schema);
  ASSERT_TRUE(reader);
  const auto reading = reader->read("I am looking for Ada Lovelace", {}, true);
  ASSERT_TRUE(reading.sent);
  ASSERT_FALSE(reading.made.acts.empty());
  EXPECT_EQ(reading.made.acts[0]["slots"]["Guest"]["value"].text(),
            "Ada Lovelace");
  EXPECT_FALSE(reading.made.explanation.empty());
}

TEST_F(ReaderTest, takes_a_context_beside_the_sessions) {
  auto reader = open(guest_schema);
  ASSERT_TRUE(reader);
  const Map asked{{"topic", "Visit"}, {"slot", "Guest"}};
  const auto score = [&](const Map& context) {
    return reader->read("Ada", context, false).made.score;
  };
  EXPECT_GT(score({{"asked", asked}}), score({}));
}

TEST(ReadingLine, IsJson) {
  Reading reading{SentWords{"for Jeffery", {}}, {}};
  reading.made.score = 0.88000001;
  EXPECT_EQ(reading_line("for Jeff", reading),
            R"({"text":"for Jeff","sent":"for Jeffery","acts":[],)"
            R"("score":0.88})");
  EXPECT_EQ(reading_line("moo", {}),
            R"({"text":"moo","sent":null,"acts":[],"score":0.0})");
}

} // namespace
} // namespace parlour::tools
