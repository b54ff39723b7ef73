#include <gtest/gtest.h>

#include "adapters/asr/sphinx/sphinx_decoder.hpp"
#include "tests/adapters/asr/sphinx/small_application.hpp"

namespace parlour::adapters::asr {
namespace {

TEST(SphinxDecoderTest, HearsAGrammar) {
  if (!SphinxDecoder::is_built_in() || !test::can_speak())
    GTEST_SKIP() << "built without PocketSphinx or flite";
  auto decoder = SphinxDecoder::make(std::string(english_model) + "/en-us",
                                     "yes Y EH S\nno N OW\n");
  ASSERT_TRUE(decoder);
  ASSERT_TRUE(decoder->add_grammar(
      "answer", "FSG_BEGIN a\nNUM_STATES 2\nSTART_STATE 0\nFINAL_STATE 1\n"
                "TRANSITION 0 1 0.5 yes\nTRANSITION 0 1 0.5 no\nFSG_END\n"));
  for (const std::string word : {"yes", "no"}) {
    ASSERT_TRUE(decoder->begin("answer"));
    decoder->hear(said(word));
    EXPECT_EQ(decoder->text(), word);
    const auto words = decoder->finish();
    ASSERT_EQ(words.size(), 1u);
    EXPECT_EQ(words[0].word, word);
    EXPECT_GT(words[0].begin, 100);
    EXPECT_GT(words[0].end, words[0].begin);
  }
  EXPECT_FALSE(decoder->begin("no such search"));
  EXPECT_TRUE(decoder->finish().empty());
}

TEST(SphinxDecoderTest, TellsWhatIsWrong) {
  if (!SphinxDecoder::is_built_in())
    GTEST_SKIP() << "built without PocketSphinx";
  EXPECT_NE(SphinxDecoder::make("/no/such/folder", "yes Y EH S\n")
                .error()
                .message.find("pocketsphinx-en-us"),
            std::string::npos);
  auto decoder = SphinxDecoder::make(std::string(english_model) + "/en-us",
                                     "yes Y EH S\n");
  ASSERT_TRUE(decoder);
  EXPECT_FALSE(decoder->add_grammar("g", "this is no grammar"));
  EXPECT_FALSE(decoder->add_domain("d", "this is no model"));
}

} // namespace
} // namespace parlour::adapters::asr
