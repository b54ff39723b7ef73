#include "tools/bench/nlu/nlu_data.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include <nlohmann/json.hpp>

namespace parlour::tools {

namespace fs = std::filesystem;
using nlohmann::json;

Expected<fs::path> first_there(const fs::path& folder,
                               const std::vector<std::string>& places) {
  for (const auto& place : places)
    if (fs::exists(folder / place))
      return folder / place;
  return fail(ErrorKind::file,
              "there is no " + places.front() + " in " + folder.string());
}

std::string unmarked(std::string text) {
  std::ranges::replace(text, '[', '(');
  std::ranges::replace(text, '\n', ' ');
  return text;
}

TopicModel& topic_of(NluData& data, const std::string& name) {
  auto& topics = data.model.topics;
  const auto found = std::ranges::find(topics, name, &TopicModel::name);
  if (found != topics.end())
    return *found;
  topics.push_back({name, false, {}, {}});
  return topics.back();
}

void add_slot(TopicModel& topic, const std::string& slot) {
  if (std::ranges::find(topic.slots, slot, &SlotModel::name) ==
      topic.slots.end())
    topic.slots.push_back({slot, "", {}, "", false, false});
}

namespace {

// The topics of SNIPS, which are also names of folders.
const char* const snips_topics[] = {
    "AddToPlaylist", "BookRestaurant",     "GetWeather",          "PlayMusic",
    "RateBook",      "SearchCreativeWork", "SearchScreeningEvent"};

// Some files are Latin-1, and some have halves of surrogate pairs ("\ud83d"
// alone). Converts the former to UTF-8 and replaces the latter by '?'.
std::string mended(const std::string& bytes) {
  if (json::accept(bytes))
    return bytes;
  std::string made;
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    const auto byte = static_cast<unsigned char>(bytes[at]);
    if (bytes.compare(at, 3, "\\ud") == 0) {
      made += '?';
      at += 5;
    } else if (byte < 0x80) {
      made += bytes[at];
    } else {
      made += static_cast<char>(0xC0 | byte >> 6);
      made += static_cast<char>(0x80 | (byte & 0x3F));
    }
  }
  return made;
}

// Parses without exceptions.
Expected<json> read_json(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  auto read = json::parse(mended(bytes), nullptr, false);
  if (!file || read.is_discarded())
    return fail(ErrorKind::file, "cannot be read as JSON",
                {path.string(), 0, 0});
  return read;
}

// An example of SNIPS: parts of text, with or without a slot.
struct Parts {
  // A part without "entity" belongs to no slot.
  explicit Parts(const json& row) {
    for (const auto& part : row.at("data")) {
      const auto words = unmarked(part.at("text").get<std::string>());
      const auto slot = part.value("entity", "");
      text += words;
      marked += slot.empty() ? words : "[" + words + "](" + slot + ")";
      if (!slot.empty())
        slots.emplace_back(slot, words);
    }
  }

  std::string text;
  std::string marked;
  std::vector<std::pair<std::string, std::string>> slots;
};

// Adds one topic: its examples, its slots, and the texts to be measured.
Expected<void> add_snips(NluData& data, const fs::path& folder,
                         const std::string& name, DataPart part) {
  const auto train =
      read_json(folder / name / ("train_" + name + "_full.json"));
  if (!train)
    return tl::make_unexpected(train.error());
  const auto test = read_json(folder / name / ("validate_" + name + ".json"));
  if (!test)
    return tl::make_unexpected(test.error());
  auto& topic = topic_of(data, name);
  std::size_t number = 0;
  for (const auto& row : train->at(name)) {
    const Parts parts(row);
    for (const auto& slot : parts.slots)
      add_slot(topic, slot.first);
    if (part == DataPart::validation && ++number % held_out_of == 0)
      data.texts.push_back({parts.text, name, parts.slots});
    else
      topic.examples.push_back(parts.marked);
  }
  if (part == DataPart::test)
    for (const auto& row : test->at(name)) {
      const Parts parts(row);
      data.texts.push_back({parts.text, name, parts.slots});
    }
  return {};
}

// The texts of CLINC about a topic, and those about none.
std::vector<NluText> texts_of(const json& data, const char* inside,
                              const char* outside) {
  std::vector<NluText> texts;
  for (const auto& row : data.at(inside))
    texts.push_back({row.at(0), row.at(1), {}});
  for (const auto& row : data.at(outside))
    texts.push_back({row.at(0), "", {}});
  return texts;
}

} // namespace

Expected<NluSets> read_clinc(const fs::path& folder, DataPart part) {
  const auto path =
      first_there(folder, {"data_full.json", "data/data_full.json",
                           "oos-eval/data/data_full.json"});
  if (!path)
    return tl::make_unexpected(path.error());
  const auto read = read_json(*path);
  if (!read)
    return tl::make_unexpected(read.error());
  NluData data;
  for (const auto& row : read->at("train"))
    topic_of(data, row.at(1)).examples.push_back(unmarked(row.at(0)));
  data.texts = part == DataPart::test ? texts_of(*read, "test", "oos_test")
                                      : texts_of(*read, "val", "oos_val");
  return NluSets{std::move(data)};
}

Expected<NluSets> read_snips(const fs::path& folder, DataPart part) {
  const auto path =
      first_there(folder, {"2017-06-custom-intent-engines",
                           "nlu-benchmark/2017-06-custom-intent-engines"});
  if (!path)
    return tl::make_unexpected(path.error());
  NluData data;
  for (const auto* topic : snips_topics)
    if (auto added = add_snips(data, *path, topic, part); !added)
      return tl::make_unexpected(added.error());
  return NluSets{std::move(data)};
}

} // namespace parlour::tools
