#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/asr/words/program_output.hpp"
#include "adapters/asr/words/pronunciations.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters::asr {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

TEST(PronunciationsTest, ComeFromTheDictionary) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "words.dict";
  std::ofstream(file) << "a AH\na(2) EY\nlemon L EH M AH N\r\nodd Q Q\nbare\n";
  const auto sounds = dictionary_sounds(file, {"a", "lemon", "odd", "none"});
  ASSERT_TRUE(sounds);
  EXPECT_THAT(*sounds, ElementsAre(Pair("a", ElementsAre("AH", "EY")),
                                   Pair("lemon", ElementsAre("L EH M AH N"))));
  EXPECT_EQ(dictionary_text(*sounds), "a AH\na(2) EY\nlemon L EH M AH N\n");
  EXPECT_FALSE(dictionary_sounds(folder.path() / "none", {}));
}

TEST(PronunciationsTest, ComeFromEspeakForOtherWords) {
  EXPECT_THAT(espeak_sounds({}), IsEmpty());
  if (!program_output({"espeak-ng", "--version"}, "", std::chrono::seconds(30)))
    GTEST_SKIP() << "espeak-ng is not installed";
  EXPECT_THAT(espeak_sounds({"comptec", "jeffery"}),
              ElementsAre(Pair("comptec", ElementsAre("K AH M P T EH K")),
                          Pair("jeffery", ElementsAre("JH EH F ER R IY"))));
}

TEST(PronunciationsTest, AreThoseThatAnApplicationGives) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / "cmudict-en-us.dict") << "ho HH OW\na AH\n";
  const auto given = given_sounds(
      {{"Ho", "HH UW"}, {"Ho", "HH AA"}, {"Other", "AH"}, {"two words", "AH"}});
  EXPECT_THAT(given, ElementsAre(Pair("ho", ElementsAre("HH UW", "HH AA")),
                                 Pair("other", ElementsAre("AH"))));
  const auto sounds = model_sounds(folder.path(), {"a", "ho"}, given);
  ASSERT_TRUE(sounds);
  EXPECT_THAT(*sounds, ElementsAre(Pair("a", ElementsAre("AH")),
                                   Pair("ho", ElementsAre("HH UW", "HH AA"))));
}

} // namespace
} // namespace parlour::adapters::asr
