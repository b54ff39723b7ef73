#include <fstream>

#include <gtest/gtest.h>

#include "tools/bench/nlu/nlu_data.hpp"

namespace parlour::tools {
namespace {

namespace fs = std::filesystem;

class NluDataTest : public testing::Test {
protected:
  NluDataTest() {
    std::string name = testing::TempDir() + "nlu-data-XXXXXX";
    folder_ = mkdtemp(name.data());
  }
  ~NluDataTest() override {
    fs::remove_all(folder_);
  }

  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
  }

  // Each topic with so many examples, and one text for the test.
  void write_snips(int examples) const {
    for (const std::string topic :
         {"AddToPlaylist", "BookRestaurant", "GetWeather", "PlayMusic",
          "RateBook", "SearchCreativeWork", "SearchScreeningEvent"}) {
      const auto folder = "2017-06-custom-intent-engines/" + topic + "/";
      const std::string row = "{\"data\": [{\"text\": \"play \"}, {\"text\": "
                              "\"caf\xE9\", \"entity\": \"track\"}]}";
      auto rows = row;
      for (int more = 1; more < examples; ++more)
        rows += ", " + row;
      write(folder + "train_" + topic + "_full.json",
            "{\"" + topic + "\": [" + rows + "]}");
      write(folder + "validate_" + topic + ".json",
            "{\"" + topic + "\": [" + row + "]}");
    }
  }

  fs::path folder_;
};

TEST_F(NluDataTest, ReadsClinc) {
  write("data_full.json",
        R"({"train": [["hi there", "greet"]], "test": [["hello", "greet"]],
            "oos_test": [["who won", "oos"]], "val": [["hey", "greet"]],
            "oos_val": [["who lost", "oos"]]})");
  const auto sets = read_clinc(folder_, DataPart::test);
  ASSERT_TRUE(sets) << to_string(sets.error());
  const auto* data = &sets->at(0);
  ASSERT_EQ(data->model.topics.size(), 1U);
  EXPECT_EQ(data->model.topics[0].examples[0], "hi there");
  ASSERT_EQ(data->texts.size(), 2U);
  EXPECT_EQ(data->texts[0].topic, "greet");
  EXPECT_EQ(data->texts[1].topic, "");
  EXPECT_EQ(read_clinc(folder_, DataPart::validation)->at(0).texts[0].text,
            "hey");
}

TEST_F(NluDataTest, ReadsSnipsAlsoInLatin1) {
  write_snips(1);
  const auto sets = read_snips(folder_, DataPart::test);
  ASSERT_TRUE(sets) << to_string(sets.error());
  const auto* data = &sets->at(0);
  ASSERT_EQ(data->model.topics.size(), 7U);
  EXPECT_EQ(data->model.topics[0].examples[0], "play [caf\xC3\xA9](track)");
  EXPECT_EQ(data->model.topics[0].slots[0].name, "track");
  EXPECT_EQ(data->texts.size(), 7U);
}

TEST_F(NluDataTest, HoldsATenthOfSnipsOut) {
  write_snips(20);
  const auto sets = read_snips(folder_, DataPart::validation);
  ASSERT_TRUE(sets) << to_string(sets.error());
  const auto* data = &sets->at(0);
  EXPECT_EQ(data->model.topics[0].examples.size(), 18U);
  EXPECT_EQ(data->texts.size(), 7U * 2);
  EXPECT_EQ(read_snips(folder_, DataPart::test)
                ->at(0)
                .model.topics[0]
                .examples.size(),
            20U);
}

TEST_F(NluDataTest, SaysWhatIsNotThere) {
  ASSERT_FALSE(read_clinc(folder_, DataPart::test));
  EXPECT_NE(read_snips(folder_, DataPart::test).error().message.find("2017-06"),
            std::string::npos);
}

} // namespace
} // namespace parlour::tools
