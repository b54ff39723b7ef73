#include "tools/parlour/understand/example_report.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace parlour::tools {

namespace {

using adapters::nlu::LeftOutExample;

constexpr std::size_t enough = 5; // examples of a topic
constexpr std::size_t shown = 3;  // examples of a kind
constexpr std::size_t shown_words = 12;

// "a", "b", "c" and 2 more
std::string quoted(const std::vector<std::string>& examples) {
  std::string made;
  for (std::size_t at = 0; at < std::min(shown, examples.size()); ++at)
    made += (at > 0 ? ", \"" : "\"") + examples[at] + '"';
  if (examples.size() > shown)
    made += fmt::format(" and {} more", examples.size() - shown);
  return made;
}

class TopicReport {
public:
  void add(const LeftOutExample& example) {
    ++examples_;
    if (example.repeats)
      repeats_.push_back(example.example);
    if (example.own)
      return;
    auto& taken = taken_[example.taken_for];
    taken.examples.push_back(example.example);
    if (!example.like.empty())
      taken.like.insert(example.like);
    lone_.insert(example.lone.begin(), example.lone.end());
    ++lost_;
  }

  std::size_t lost() const {
    return lost_;
  }
  bool is_fine() const {
    return lost_ == 0 && examples_ >= enough && repeats_.size() * 2 < examples_;
  }

  void print(const std::string& topic, std::vector<std::string>& lines) const {
    lines.push_back(fmt::format("{}: {} of {} understood", topic,
                                examples_ - lost_, examples_));
    for (const auto& [other, taken] : taken_)
      print(other, taken, lines);
    if (!repeats_.empty())
      lines.push_back(
          fmt::format("  the same but for values and small words ({}): {}",
                      repeats_.size(), quoted(repeats_)));
    advise(lines);
  }

private:
  struct Taken {
    std::vector<std::string> examples;
    std::set<std::string> like; // examples of the other topic
  };

  static void print(const std::string& other, const Taken& taken,
                    std::vector<std::string>& lines) {
    lines.push_back(
        fmt::format("  {} ({}): {}",
                    other.empty() ? "not understood" : "taken for " + other,
                    taken.examples.size(), quoted(taken.examples)));
    if (!taken.like.empty())
      lines.push_back("    which has: " +
                      quoted({taken.like.begin(), taken.like.end()}));
  }

  void advise(std::vector<std::string>& lines) const {
    if (examples_ < enough)
      lines.emplace_back(
          "  add examples in other words: five to ten that differ do");
    else if (repeats_.size() * 2 >= examples_)
      lines.emplace_back(
          "  put others in their place: they teach the same again");
    if (!lone_.empty())
      lines.push_back(fmt::format(
          "  add another example with: {}",
          fmt::join(std::vector(lone_.begin(),
                                std::next(lone_.begin(),
                                          std::ptrdiff_t(std::min(
                                              shown_words, lone_.size())))),
                    ", ")));
  }

  std::size_t examples_ = 0;
  std::size_t lost_ = 0;
  std::vector<std::string> repeats_;
  std::map<std::string, Taken> taken_; // by topic; "" is none
  std::set<std::string> lone_;         // words of those that are lost
};

std::string summary(const std::vector<LeftOutExample>& examples,
                    std::size_t topics) {
  const auto own = std::ranges::count_if(examples, &LeftOutExample::own);
  const auto nothing = std::ranges::count_if(examples, [](const auto& example) {
    return !example.own && example.taken_for.empty();
  });
  const auto all = std::ssize(examples);
  return fmt::format("{} examples of {} topics. If each were not there, {} "
                     "({} %) would be understood, {} taken for another topic, "
                     "{} for none.",
                     all, topics, own, own * 100 / all, all - own - nothing,
                     nothing);
}

} // namespace

std::vector<std::string>
example_report(const std::vector<LeftOutExample>& examples) {
  std::map<std::string, TopicReport> by_topic;
  for (const auto& example : examples)
    by_topic[example.topic].add(example);
  if (by_topic.empty())
    return {};
  std::vector<std::pair<std::string, const TopicReport*>> topics;
  for (const auto& [topic, report] : by_topic)
    if (!report.is_fine())
      topics.emplace_back(topic, &report);
  std::ranges::stable_sort(topics, std::greater(), [](const auto& topic) {
    return topic.second->lost();
  });
  std::vector lines{summary(examples, by_topic.size())};
  for (const auto& [topic, report] : topics) {
    lines.emplace_back();
    report->print(topic, lines);
  }
  return lines;
}

} // namespace parlour::tools
