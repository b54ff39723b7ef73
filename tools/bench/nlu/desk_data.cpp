#include "tools/bench/nlu/desk_data.hpp"

#include <algorithm>
#include <fstream>
#include <map>

#include <nlohmann/json.hpp>

namespace parlour::tools {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr std::size_t turns = 4;

// Intents that every application understands, and their acts.
const std::map<std::string, std::string>& generic_acts() {
  static const std::map<std::string, std::string> acts{{"greeting", "greet"},
                                                       {"affirm", "confirm"},
                                                       {"goodbye", "bye"},
                                                       {"deny", "deny"}};
  return acts;
}

struct Row {
  NluText text;
  std::string marked;
  std::string template_text; // names of slots in the place of their values
};

Row row_of(const json& read) {
  Row row{{read.at("text"), read.at("intent"), {}}, "", ""};
  const auto& tags = read.at("tags");
  const auto is = [&](std::size_t at, char kind) {
    return at < tags.size() && tags[at].get<std::string>()[0] == kind;
  };
  for (std::size_t at = 0; at < tags.size(); ++at) {
    const auto word = read.at("toks")[at].get<std::string>();
    const auto blank = at > 0 ? " " : "";
    if (is(at, 'B')) {
      row.text.slots.emplace_back(tags[at].get<std::string>().substr(2), word);
      row.template_text += '@' + row.text.slots.back().first;
      row.marked += std::string(blank) + "[" + word;
    } else {
      if (is(at, 'I'))
        row.text.slots.back().second += ' ' + word;
      else
        row.template_text += ' ' + word;
      row.marked += blank + word;
    }
    if (!is(at, 'O') && !is(at + 1, 'I'))
      row.marked += "](" + row.text.slots.back().first + ")";
  }
  return row;
}

// Times and dates are normal forms, all others are values that are known.
void add_slot_of(TopicModel& topic, const std::string& slot) {
  if (std::ranges::find(topic.slots, slot, &SlotModel::name) !=
      topic.slots.end())
    return;
  if (slot == "time" || slot == "date")
    topic.slots.push_back({slot, slot, {}, "", true, false});
  else
    topic.slots.push_back({slot, "query", {}, "db:desk." + slot, true, false});
}

ColumnReader columns_of(const json& gazetteer) {
  return [gazetteer](const std::string& name) {
    return Expected<std::vector<std::string>>(
        gazetteer.at(name.substr(name.rfind('.') + 1))
            .get<std::vector<std::string>>());
  };
}

// All topics have all their slots in every turn, whatever is held back.
NluData data_of(const std::vector<Row>& rows,
                const std::map<std::string, std::size_t>& numbers,
                std::size_t turn, const ColumnReader& columns) {
  NluData data;
  data.columns = columns;
  for (const auto& row : rows) {
    auto text = row.text;
    const auto generic = generic_acts().find(text.topic);
    const bool is_generic = generic != generic_acts().end();
    if (is_generic)
      text.topic = generic->second;
    else
      for (const auto& slot : text.slots)
        add_slot_of(topic_of(data, text.topic), slot.first);
    if (numbers.at(row.template_text) % turns == turn)
      data.texts.push_back(std::move(text));
    else if (!is_generic)
      topic_of(data, text.topic).examples.push_back(row.marked);
  }
  return data;
}

} // namespace

Expected<NluSets> read_desk(const fs::path& folder, DataPart) {
  const auto place = first_there(folder, {"desk/train.jsonl"});
  if (!place)
    return tl::make_unexpected(place.error());
  std::ifstream values(folder / "desk/gazetteer.json");
  const auto gazetteer = json::parse(values, nullptr, false);
  std::ifstream file(*place);
  std::vector<Row> rows;
  std::map<std::string, std::size_t> numbers;
  for (std::string line; std::getline(file, line);) {
    const auto read = json::parse(line, nullptr, false);
    if (read.is_discarded() || gazetteer.is_discarded())
      return fail(ErrorKind::file, "cannot be read as JSON",
                  {place->string(), 0, 0});
    rows.push_back(row_of(read));
    numbers.try_emplace(rows.back().template_text, numbers.size());
  }
  NluSets sets;
  for (std::size_t turn = 0; turn < turns; ++turn)
    sets.push_back(data_of(rows, numbers, turn, columns_of(gazetteer)));
  return sets;
}

} // namespace parlour::tools
