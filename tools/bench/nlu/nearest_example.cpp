#include "tools/bench/nlu/nearest_example.hpp"

#include <cctype>
#include <set>

namespace parlour::tools {

namespace {

// Without marks: "[words](Slot)" is "words".
std::set<std::string> words_of(const std::string& text) {
  std::set<std::string> words;
  std::string word;
  bool slot = false;
  for (const char byte : text + ' ') {
    const auto one = static_cast<unsigned char>(byte);
    slot = byte == '(' || (slot && byte != ')');
    if (!slot && (std::isalnum(one) != 0 || one >= 0x80 || byte == '\'')) {
      word += static_cast<char>(std::tolower(one));
    } else if (!word.empty()) {
      words.insert(word);
      word.clear();
    }
  }
  return words;
}

} // namespace

NearestExample::NearestExample(const UnderstandingModel& model) {
  for (const auto& topic : model.topics)
    for (const auto& text : topic.examples) {
      const auto words = words_of(text);
      for (const auto& word : words)
        having_[word].push_back(examples_.size());
      examples_.push_back({topic.name, words.size()});
    }
}

std::string NearestExample::topic(const std::string& text) const {
  const auto words = words_of(text);
  std::vector<std::size_t> shared(examples_.size(), 0);
  for (const auto& word : words)
    if (const auto found = having_.find(word); found != having_.end())
      for (const auto at : found->second)
        ++shared[at];
  std::string best;
  double most = 0;
  for (std::size_t at = 0; at < examples_.size(); ++at) {
    // Shared words of all words.
    const auto all = words.size() + examples_[at].words - shared[at];
    const auto share = double(shared[at]) / double(all);
    if (share > most) {
      most = share;
      best = examples_[at].topic;
    }
  }
  return best;
}

} // namespace parlour::tools
