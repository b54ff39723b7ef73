#include <algorithm>
#include <string>

#include <gmock/gmock.h>

#include "adapters/nlu/values/value_fits.hpp"

namespace parlour::adapters::nlu {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

class ValueFitsTest : public testing::Test {
protected:
  std::vector<std::vector<ValueFits::Fit>> fits(const std::string& text) const {
    const auto tokens = tokenize(text);
    const std::vector<bool> plain(tokens.list.size(), false);
    return ValueFits(index, tokens, plain).run();
  }

  // The numbers of the values that fit at a token.
  static std::vector<std::uint32_t>
  values(const std::vector<ValueFits::Fit>& fits) {
    std::vector<std::uint32_t> numbers;
    for (const auto& fit : fits)
      numbers.push_back(fit.value);
    return numbers;
  }

  ValueIndex index;
};

TEST_F(ValueFitsTest, AreSortedByValueAtEachToken) {
  index.add({"green tea", "black coffee", "black tea"});
  const auto found = fits("teas black blakc");
  ASSERT_THAT(found, SizeIs(3));
  EXPECT_THAT(values(found[0]), ElementsAre(0, 2));
  EXPECT_THAT(values(found[1]), ElementsAre(1, 2));
  EXPECT_THAT(values(found[2]), ElementsAre(1, 2));
  EXPECT_EQ(found[1][0].similarity, 1);
  EXPECT_LT(found[2][0].similarity, 1);
}

TEST_F(ValueFitsTest, TellWhichWordsOfTheValue) {
  index.add({"coffee shop"});
  const auto found = fits("coffee shop");
  ASSERT_THAT(found[0], SizeIs(2));
  EXPECT_EQ(found[0][0].mask, 1);
  EXPECT_EQ(found[0][0].length, 1);
  EXPECT_EQ(found[0][1].mask, 3);
  EXPECT_EQ(found[0][1].length, 2);
  EXPECT_EQ(found[1][0].mask, 2);
}

TEST_F(ValueFitsTest, ReadLettersAsAWord) {
  index.add({"Tan Wei"});
  const auto found = fits("t a n");
  ASSERT_THAT(found[0], SizeIs(1));
  EXPECT_TRUE(found[0][0].spelt);
  EXPECT_EQ(found[0][0].length, 3);
}

// Two letters for each number from 0 to 399.
std::string coded(std::size_t number) {
  std::string made = "aa";
  made[0] = static_cast<char>('a' + number / 20);
  made[1] = static_cast<char>('a' + number % 20);
  return made;
}

// 400 people called Hakim and 400 called Hakam, whose other names are said by
// nobody else; the last one is "bin", too.
class CommonNames : public ValueFitsTest {
protected:
  void SetUp() override {
    std::vector<std::string> people;
    for (std::size_t number = 0; number < 400; ++number) {
      people.push_back("Xy" + coded(number) + "qo Hakim");
      people.push_back("Zu" + coded(number) + "po Hakam");
    }
    people.push_back("Osman bin Hakam");
    index.add(people);
  }
};

TEST_F(CommonNames, LeaveOutWhoIsMuchLessLikelyAndFitsNowhereElse) {
  const auto found = fits("hakim");
  EXPECT_THAT(found[0], SizeIs(400));
  EXPECT_TRUE(std::ranges::all_of(
      found[0], [](const auto& fit) { return fit.similarity == 1; }));
}

TEST_F(CommonNames, KeepWhoFitsElsewhereAsWell) {
  const auto found = fits("osman bin hakim");
  EXPECT_THAT(values(found[1]), ElementsAre(800));
  EXPECT_THAT(found[2], SizeIs(401));
  EXPECT_EQ(found[2].back().value, 800);
}

TEST_F(CommonNames, LeaveOutWhoFitsByALightWordOnly) {
  EXPECT_THAT(fits("bin hakim")[0],
              ElementsAre(testing::Field(&ValueFits::Fit::value, 800)));
  EXPECT_THAT(fits("bin hakam hakim nobody")[3], IsEmpty());
}

} // namespace
} // namespace parlour::adapters::nlu
