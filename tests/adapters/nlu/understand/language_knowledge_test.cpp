#include <chrono>
#include <cstdlib>

#include <gmock/gmock.h>

#include "adapters/nlu/understand/language_knowledge.hpp"
#include "tests/adapters/nlu/encoder/small_encoder.hpp"
#include "tests/adapters/nlu/learning/small_vectors.hpp"

namespace parlour::adapters::nlu {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class LanguageKnowledgeTest : public testing::Test {
protected:
  LanguageKnowledgeTest() {
    setenv("XDG_CACHE_HOME", folder_.path().c_str(), 1);
  }
  LanguageKnowledge read() {
    return store_.read(folder_.path(), errors_);
  }
  // Later than before, however coarse the clock of the file system is.
  void write(const std::string& name, const std::string& bytes) {
    folder_.write(name, bytes);
    written_ += std::chrono::seconds(10);
    std::filesystem::last_write_time(folder_.path() / name, written_);
  }

  parlour::test::TemporaryFolder folder_;
  std::filesystem::file_time_type written_ =
      std::filesystem::file_time_type::clock::now();
  LanguageStore store_;
  std::vector<Error> errors_;
};

TEST_F(LanguageKnowledgeTest, IsNoneWithoutFiles) {
  const auto language = read();
  EXPECT_EQ(language.vectors, nullptr);
  EXPECT_EQ(language.encoder, nullptr);
  EXPECT_EQ(language.known_sentences, "");
  EXPECT_THAT(errors_, IsEmpty());
}

TEST_F(LanguageKnowledgeTest, KeepsWhatTheEncoderMakesInTheCacheOfTheUser) {
  write("sentences.encoder", small::small_encoder_file());
  EXPECT_EQ(read().known_sentences, folder_.path() / "parlour/sentences.known");
}

TEST_F(LanguageKnowledgeTest, IsReadOnce) {
  write("words.vectors", test::small_vectors_file());
  write("sentences.encoder", small::small_encoder_file());
  const auto first = read();
  ASSERT_NE(first.vectors, nullptr);
  ASSERT_NE(first.encoder, nullptr);
  const auto second = read();
  EXPECT_EQ(first.vectors, second.vectors);
  EXPECT_EQ(first.encoder, second.encoder);
  EXPECT_EQ(first, second);
}

TEST_F(LanguageKnowledgeTest, IsReadAgainIfAFileChanged) {
  write("sentences.encoder", small::small_encoder_file());
  const auto first = read();
  write("sentences.encoder", small::encoder_file_with_layer());
  const auto second = read();
  EXPECT_NE(first.encoder, second.encoder);
  EXPECT_NE(first, second);
  EXPECT_NE(first, LanguageKnowledge());
}

TEST_F(LanguageKnowledgeTest, TellsEachTimeThatAFileIsBroken) {
  write("words.vectors", "something else");
  for (std::size_t times = 1; times <= 2; ++times) {
    EXPECT_EQ(read().vectors, nullptr);
    ASSERT_THAT(errors_, SizeIs(times));
    EXPECT_THAT(errors_.back().place.file, HasSubstr("words.vectors"));
  }
}

} // namespace
} // namespace parlour::adapters::nlu
