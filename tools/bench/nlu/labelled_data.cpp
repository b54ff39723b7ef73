#include "tools/bench/nlu/labelled_data.hpp"

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>

#include <nlohmann/json.hpp>

namespace parlour::tools {

namespace fs = std::filesystem;

namespace {

// A text with a label, and with a tag for each of its words, if there are
// tags: "O", "B-slot", "I-slot".
struct Labelled {
  std::string text;
  std::string label;
  std::vector<std::string> tags;
};

// A point in the name of a slot would separate it from its topic.
std::string slot_name(std::string tag) {
  std::ranges::replace(tag, '.', '_');
  return tag.substr(2);
}

// The words of a text with marks, and its slots. A text without tags has no
// slots.
struct Marked {
  explicit Marked(const Labelled& row) {
    std::istringstream words(row.text);
    std::string word;
    for (std::size_t at = 0; words >> word; ++at)
      add(unmarked(word), at < row.tags.size() ? row.tags[at] : "O");
    close();
    if (row.tags.empty())
      marked = unmarked(row.text);
  }

  std::string marked;
  std::vector<std::pair<std::string, std::string>> slots;

private:
  void add(const std::string& word, const std::string& tag) {
    if (open_ && !tag.starts_with("I-"))
      close();
    if (!marked.empty())
      marked += ' ';
    if (tag.starts_with("B-")) {
      marked += '[';
      slots.emplace_back(slot_name(tag), word);
      open_ = true;
    } else if (open_) {
      slots.back().second += ' ' + word;
    }
    marked += word;
  }

  void close() {
    if (open_)
      marked += "](" + slots.back().first + ")";
    open_ = false;
  }

  bool open_ = false;
};

void learn(NluData& data, const Labelled& row) {
  const Marked marked(row);
  auto& topic = topic_of(data, row.label);
  for (const auto& slot : marked.slots)
    add_slot(topic, slot.first);
  topic.examples.push_back(marked.marked);
}

void measure(NluData& data, const Labelled& row) {
  data.texts.push_back({row.text, row.label, Marked(row).slots});
}

NluData data_of(const std::vector<Labelled>& train,
                const std::vector<Labelled>& test) {
  NluData data;
  for (const auto& row : train)
    learn(data, row);
  for (const auto& row : test)
    measure(data, row);
  return data;
}

// Every so manieth row is held out.
void learn_or_measure(NluData& data, const std::vector<Labelled>& rows,
                      std::size_t one_in, std::size_t turn) {
  for (std::size_t at = 0; at < rows.size(); ++at)
    if (at % one_in == turn)
      measure(data, rows[at]);
    else
      learn(data, rows[at]);
}

// -- files of lines -----------------------------------------------------------

std::vector<std::string> lines_of(const fs::path& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);)
    lines.push_back(std::move(line));
  return lines;
}

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
    words.push_back(std::move(word));
  return words;
}

// seq.in, label and, if there is one, seq.out.
std::vector<Labelled> read_lines(const fs::path& folder) {
  const auto texts = lines_of(folder / "seq.in");
  const auto labels = lines_of(folder / "label");
  const auto tags = lines_of(folder / "seq.out");
  std::vector<Labelled> rows;
  for (std::size_t at = 0; at < std::min(texts.size(), labels.size()); ++at)
    rows.push_back(
        {texts[at], labels[at],
         at < tags.size() ? words_of(tags[at]) : std::vector<std::string>()});
  return rows;
}

Expected<NluSets> read_set(const fs::path& folder, const std::string& name,
                           const char* train, DataPart part) {
  const auto place =
      first_there(folder, {"Few-Shot-Intent-Detection/Datasets/" + name,
                           "Datasets/" + name, name});
  if (!place)
    return tl::make_unexpected(place.error());
  return NluSets{data_of(
      read_lines(*place / train),
      read_lines(*place / (part == DataPart::test ? "test" : "valid")))};
}

// Texts between empty lines, a word and its tag on each line; the first is a
// heading.
std::vector<Labelled> read_tagged(const fs::path& path) {
  std::vector<Labelled> rows;
  Labelled row;
  const auto finish = [&] {
    if (!row.text.empty() && row.text != "-DOCSTART-")
      rows.push_back({row.text, "find", row.tags});
    row = {};
  };
  for (const auto& line : lines_of(path)) {
    const auto words = words_of(line);
    if (words.size() == 2) {
      row.text += (row.text.empty() ? "" : " ") + words[0];
      row.tags.push_back(words[1]);
    } else {
      finish();
    }
  }
  finish();
  return rows;
}

// Without a validation part.
NluSets split(const std::vector<Labelled>& train,
              const std::vector<Labelled>& test, DataPart part) {
  if (part == DataPart::test)
    return {data_of(train, test)};
  NluData data;
  learn_or_measure(data, train, held_out_of, held_out_of - 1);
  return {std::move(data)};
}

Expected<NluSets> read_mit(const fs::path& folder, const std::string& name,
                           DataPart part) {
  const auto place =
      first_there(folder, {"DeepKE/example/ner/few-shot/data/" + name, name});
  if (!place)
    return tl::make_unexpected(place.error());
  return split(read_tagged(*place / "500-shot-train.txt"),
               read_tagged(*place / "test.txt"), part);
}

// -- BANKING77 ----------------------------------------------------------------

// The rows of a file of comma-separated values with two columns. A column in
// quotes may have commas, lines and doubled quotes.
class CommaReader {
public:
  explicit CommaReader(const fs::path& path) : file_(path) {}

  std::optional<Labelled> next() {
    Labelled row;
    if (!column(row.text) || !column(row.label))
      return {};
    return row;
  }

private:
  bool column(std::string& made) {
    bool quoted = false;
    char byte = 0;
    for (made.clear(); file_.get(byte);) {
      if (byte == '"')
        quoted = !quoted;
      else if (!quoted && (byte == ',' || byte == '\n'))
        return true;
      else if (byte != '\r')
        made += byte;
    }
    return !made.empty();
  }

  std::ifstream file_;
};

std::vector<Labelled> read_commas(const fs::path& path) {
  CommaReader reader(path);
  std::vector<Labelled> rows;
  reader.next(); // the names of the columns
  while (auto row = reader.next())
    rows.push_back(std::move(*row));
  return rows;
}

// -- small corpora ------------------------------------------------------------

// So few examples are held out in turns.
constexpr std::size_t turns = 5;

struct Corpus {
  std::vector<Labelled> train;
  std::vector<Labelled> test;
};

Expected<Corpus> read_corpus(const fs::path& path) {
  std::ifstream file(path);
  const auto read = nlohmann::json::parse(file, nullptr, false);
  if (!file || read.is_discarded())
    return fail(ErrorKind::file, "cannot be read as JSON",
                {path.string(), 0, 0});
  Corpus corpus;
  for (const auto& row : read.at("sentences")) {
    Labelled one{row.at("text"), row.at("intent"), {}};
    if (one.label == "None")
      one.label.clear();
    if (!row.at("training").get<bool>())
      corpus.test.push_back(std::move(one));
    else if (!one.label.empty())
      corpus.train.push_back(std::move(one));
  }
  return corpus;
}

void add_corpus(NluSets& sets, const Corpus& corpus, DataPart part) {
  if (part == DataPart::test) {
    sets.push_back(data_of(corpus.train, corpus.test));
    return;
  }
  for (std::size_t turn = 0; turn < turns; ++turn)
    learn_or_measure(sets.emplace_back(), corpus.train, turns, turn);
}

} // namespace

Expected<NluSets> read_banking(const fs::path& folder, DataPart part) {
  const auto place =
      first_there(folder, {"task-specific-datasets/banking_data/train.csv",
                           "banking_data/train.csv"});
  if (!place)
    return tl::make_unexpected(place.error());
  return split(read_commas(*place),
               read_commas(place->parent_path() / "test.csv"), part);
}

Expected<NluSets> read_hwu(const fs::path& folder, DataPart part) {
  return read_set(folder, "HWU64", "train", part);
}

Expected<NluSets> read_atis(const fs::path& folder, DataPart part) {
  return read_set(folder, "ATIS", "train", part);
}

Expected<NluSets> read_restaurants(const fs::path& folder, DataPart part) {
  return read_mit(folder, "mit-restaurant", part);
}

Expected<NluSets> read_films(const fs::path& folder, DataPart part) {
  return read_mit(folder, "mit-movie", part);
}

Expected<NluSets> read_ten_of_banking(const fs::path& folder, DataPart part) {
  return read_set(folder, "BANKING77", "train_10", part);
}

Expected<NluSets> read_ten_of_clinc(const fs::path& folder, DataPart part) {
  return read_set(folder, "CLINC150", "train_10", part);
}

Expected<NluSets> read_corpora(const fs::path& folder, DataPart part) {
  NluSets sets;
  for (const std::string name : {"Chatbot", "AskUbuntu", "WebApplications"}) {
    const auto path =
        first_there(folder, {"NLU-Evaluation-Corpora/" + name + "Corpus.json",
                             name + "Corpus.json"});
    if (!path)
      return tl::make_unexpected(path.error());
    const auto corpus = read_corpus(*path);
    if (!corpus)
      return tl::make_unexpected(corpus.error());
    add_corpus(sets, *corpus, part);
  }
  return sets;
}

} // namespace parlour::tools
