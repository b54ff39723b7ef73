#include <gtest/gtest.h>

#include "adapters/nlu/acts/parts_of_values.hpp"
#include "tests/adapters/nlu/sample.hpp"

namespace parlour::adapters::nlu::test {
namespace {

// The value of the host, or how many it may be.
std::string host(const char* text, const char* asked = "") {
  static const auto engine = [] {
    return NluEngine::build(sample_model(),
                            [](const std::string&) {
                              return Expected<std::vector<std::string>>(
                                  {"Geetha Nair", "Geetha Rao", "Priya Nair",
                                   "Priya Kaur", "Anna Lim", "Bela Lim"});
                            },
                            {0.4, {generic_grammar()}});
  }();
  const auto made = engine->understand(text, sample_context(asked));
  if (made.acts.empty())
    return "";
  const auto& said = made.acts[0]["slots"]["Host"];
  const auto* const candidates = said["candidates"].if_list();
  return candidates ? std::to_string(candidates->size()) : said["value"].text();
}

TEST(PartsOfValues, AreOneValueTogether) {
  EXPECT_EQ(host("I want to meet Geetha"), "2");
  EXPECT_EQ(host("I want to meet Geetha, surname Nair"), "Geetha Nair");
  EXPECT_EQ(host("Nair. It is Priya, please."), "Priya Nair");
}

TEST(PartsOfValues, AreNotWhatIsNegated) {
  EXPECT_EQ(host("I want to meet Geetha but it is not Nair"), "2");
}

TEST(PartsOfValues, FitEachOther) {
  EXPECT_EQ(host("I want to meet Geetha, surname Lim"), "2");
}

TEST(PartsOfValues, AreNotWhatAStoryMentions) {
  EXPECT_EQ(host("Geetha. He zorked Nair yesterday", "Appointment.Host"), "2");
}

} // namespace
} // namespace parlour::adapters::nlu::test
