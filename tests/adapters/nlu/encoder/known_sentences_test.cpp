#include <chrono>
#include <future>
#include <map>

#include <gmock/gmock.h>

#include "adapters/nlu/encoder/known_sentences.hpp"
#include "tests/adapters/nlu/encoder/small_encoder.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters::nlu {
namespace {

using testing::FloatNear;
using testing::IsEmpty;
using testing::Pointwise;
using testing::SizeIs;

std::filesystem::path
file_of(const std::map<std::string, std::string>& environment) {
  return known_sentences_file(
      [&](const std::string& name) -> std::optional<std::string> {
        const auto found = environment.find(name);
        return found == environment.end() ? std::nullopt
                                          : std::optional(found->second);
      });
}

TEST(KnownSentences, AreInTheCacheOfTheUser) {
  const parlour::test::TemporaryFolder folder;
  const auto home = folder.path().string();
  const auto cache = home + "/elsewhere";
  EXPECT_EQ(file_of({{"HOME", home}}),
            home + "/.cache/parlour/sentences.known");
  EXPECT_EQ(file_of({{"HOME", home}, {"XDG_CACHE_HOME", cache}}),
            cache + "/parlour/sentences.known");
  EXPECT_EQ(file_of({{"HOME", home}, {"XDG_CACHE_HOME", "cache"}}),
            home + "/.cache/parlour/sentences.known");
}

TEST(KnownSentences, AreNowhereIfNoFolderCanBeWritten) {
  EXPECT_EQ(file_of({}), "");
  EXPECT_EQ(file_of({{"HOME", "home"}}), "");
  EXPECT_EQ(file_of({{"XDG_CACHE_HOME", "/proc/nowhere"}}), "");
}

class KnownSentencesTest : public testing::Test {
protected:
  std::vector<std::vector<float>>
  encoded(const std::vector<std::string>& texts) const {
    return encode_all(texts, *encoder_, folder_.path() / name_);
  }
  std::string written() const {
    return folder_.read(name_);
  }

  const std::string name_ = "known";
  parlour::test::TemporaryFolder folder_;
  std::shared_ptr<const SentenceEncoder> encoder_ = small::small_encoder();
};

TEST_F(KnownSentencesTest, AreNearlyWhatTheEncoderMakes) {
  const auto made = encoded({"i need a taxi", "", "a bank", "a bank"});
  ASSERT_THAT(made, SizeIs(4));
  EXPECT_THAT(made[0],
              Pointwise(FloatNear(0.005F), encoder_->encode("i need a taxi")));
  EXPECT_THAT(made[2],
              Pointwise(FloatNear(0.005F), encoder_->encode("a bank")));
  EXPECT_EQ(made[2], made[3]);
  EXPECT_THAT(encoded({}), IsEmpty());
}

TEST_F(KnownSentencesTest, AreTheSameTheNextTime) {
  const auto first = encoded({"i need a taxi"});
  const auto file = written();
  EXPECT_FALSE(file.empty());
  EXPECT_EQ(encoded({"i need a taxi"}), first);
  EXPECT_EQ(written(), file);
  EXPECT_EQ(encoded({"a bank", "i need a taxi"})[1], first[0]);
  EXPECT_GT(written().size(), file.size());
}

// Where nothing is new, nothing is written.
TEST_F(KnownSentencesTest, AreReadFromTheFile) {
  encoded({"i need a taxi", "a bank"});
  const auto file = folder_.path() / name_;
  const auto before = std::filesystem::last_write_time(file);
  const auto earlier = before - std::chrono::hours(1);
  std::filesystem::last_write_time(file, earlier);
  encoded({"a bank"});
  EXPECT_EQ(std::filesystem::last_write_time(file), earlier);
  encoded({"a taxi"});
  EXPECT_NE(std::filesystem::last_write_time(file), earlier);
}

TEST_F(KnownSentencesTest, AreMadeAnewWhereTheFileIsBroken) {
  const auto first = encoded({"i need a taxi"});
  const auto whole = written();
  for (const auto& broken :
       {std::string(), std::string("PARLOURK1"), whole.substr(0, 20),
        whole.substr(0, whole.size() - 1), "x" + whole, whole + "x"}) {
    folder_.write(name_, broken);
    EXPECT_EQ(encoded({"i need a taxi"}), first);
    EXPECT_EQ(written(), whole);
  }
}

TEST_F(KnownSentencesTest, AreMadeAnewWhereAnyByteIsOther) {
  const auto first = encoded({"i need a taxi"});
  const auto whole = written();
  for (std::size_t at = 0; at < whole.size(); ++at) {
    auto broken = whole;
    broken[at] = static_cast<char>(broken[at] ^ 0x10);
    folder_.write(name_, broken);
    EXPECT_EQ(encoded({"i need a taxi"}), first) << at;
    EXPECT_EQ(written(), whole) << at;
  }
}

TEST_F(KnownSentencesTest, AreThoseOfTheEncoder) {
  encoded({"i need a taxi"});
  const auto other = *small::encoder_of(small::encoder_file_with_layer());
  const auto made =
      encode_all({"i need a taxi"}, *other, folder_.path() / name_);
  EXPECT_EQ(made, encode_all({"i need a taxi"}, *other, ""));
}

TEST_F(KnownSentencesTest, AreLeftToWhoeverWritesJustNow) {
  folder_.write(name_ + ".new", "begun");
  EXPECT_THAT(encoded({"a bank"}), SizeIs(1));
  EXPECT_FALSE(folder_.has(name_));
  EXPECT_EQ(folder_.read(name_ + ".new"), "begun");
  // It was killed.
  std::filesystem::last_write_time(
      folder_.path() / (name_ + ".new"),
      std::filesystem::file_time_type::clock::now() - std::chrono::hours(1));
  encoded({"a bank"});
  EXPECT_TRUE(folder_.has(name_));
  EXPECT_FALSE(folder_.has(name_ + ".new"));
}

TEST_F(KnownSentencesTest, AreThoseOfAllThreads) {
  std::vector<std::future<std::vector<std::vector<float>>>> all;
  const std::vector<std::string> texts{"a taxi", "a bank", "i need a cab"};
  for (const auto& text : texts)
    all.push_back(
        std::async(std::launch::async, [&] { return encoded({text}); }));
  for (std::size_t at = 0; at < texts.size(); ++at)
    EXPECT_EQ(all[at].get(), encode_all({texts[at]}, *encoder_, ""));
  const auto file = written();
  encoded(texts);
  EXPECT_EQ(written(), file);
}

TEST_F(KnownSentencesTest, AreNotMoreThanAFileMayHave) {
  std::vector<std::string> many;
  for (std::size_t at = 0; at < most_known_sentences; ++at)
    many.push_back(std::to_string(at));
  encoded(many);
  const auto full = written().size();
  const auto made = encoded({"a bank"});
  EXPECT_LT(written().size(), full);
  EXPECT_EQ(encoded({"a bank"}), made);
}

} // namespace
} // namespace parlour::adapters::nlu
