#include <fstream>

#include <gtest/gtest.h>

#include "tools/bench/nlu_data.hpp"

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

  fs::path folder_;
};

TEST_F(NluDataTest, ReadsClinc) {
  write("data_full.json",
        R"({"train": [["hi there", "greet"]], "test": [["hello", "greet"]],
            "oos_test": [["who won", "oos"]]})");
  const auto data = read_clinc(folder_);
  ASSERT_TRUE(data) << to_string(data.error());
  ASSERT_EQ(data->model.topics.size(), 1U);
  EXPECT_EQ(data->model.topics[0].examples[0], "hi there");
  ASSERT_EQ(data->texts.size(), 2U);
  EXPECT_EQ(data->texts[0].topic, "greet");
  EXPECT_EQ(data->texts[1].topic, "");
}

TEST_F(NluDataTest, ReadsSnipsAlsoInLatin1) {
  for (const std::string topic :
       {"AddToPlaylist", "BookRestaurant", "GetWeather", "PlayMusic",
        "RateBook", "SearchCreativeWork", "SearchScreeningEvent"}) {
    const auto folder = "2017-06-custom-intent-engines/" + topic + "/";
    write(folder + "train_" + topic + "_full.json",
          "{\"" + topic +
              "\": [{\"data\": [{\"text\": \"play \"}, {\"text\": "
              "\"caf\xE9\", \"entity\": \"track\"}]}]}");
    write(folder + "validate_" + topic + ".json", "{\"" + topic + "\": []}");
  }
  const auto data = read_snips(folder_);
  ASSERT_TRUE(data) << to_string(data.error());
  ASSERT_EQ(data->model.topics.size(), 7U);
  EXPECT_EQ(data->model.topics[0].examples[0], "play [caf\xC3\xA9](track)");
  EXPECT_EQ(data->model.topics[0].slots[0].name, "track");
}

TEST_F(NluDataTest, SaysWhatIsNotThere) {
  ASSERT_FALSE(read_clinc(folder_));
  EXPECT_NE(read_snips(folder_).error().message.find("2017-06"),
            std::string::npos);
}

} // namespace
} // namespace parlour::tools
