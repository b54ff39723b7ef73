#include "adapters/nlu/parse/context.hpp"

#include <algorithm>
#include <utility>

#include "adapters/nlu/text/tokens.hpp"

namespace parlour::adapters::nlu {

namespace {

// Sets the question only if both topic and slot exist.
void read_asked(const Value& asked, const Schema& schema, Context& context) {
  if (!asked.if_map())
    return;
  const auto topic = schema.topic(asked["topic"].text());
  if (topic == no_topic)
    return;
  const auto* slot = schema.at(topic).find(asked["slot"].text());
  if (!slot)
    return;
  context.asked_topic = topic;
  context.asked_slot = slot->name;
  context.asked_entity_id = slot->entity;
}

void read_said(const Value& said, const Schema& schema, Context& context) {
  if (context.asked_topic == no_topic || !said.if_list())
    return;
  for (const auto& name : *said.if_list())
    if (const auto* slot = schema.at(context.asked_topic).find(name.text()))
      context.said.push_back(*slot);
}

// Those of the tokenizer, so that they can be compared with tokens.
std::vector<std::string> words_in(const std::string& text) {
  std::vector<std::string> words;
  for (auto& token : tokenize(text).list)
    words.push_back(std::move(token.word));
  return words;
}

// Without statements of what is not: "Shall I block it? I cannot take that
// back." is answered by nobody who takes something back.
std::vector<std::string> words_asked(const std::string& text) {
  std::vector<std::string> words;
  std::vector<std::string> sentence;
  bool is_denied = false;
  const auto tokens = tokenize(text).list;
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    const auto& word = tokens[at].word;
    sentence.push_back(word);
    is_denied = is_denied || word == "not" || word == "cannot";
    const bool is_last = at + 1 == tokens.size();
    if (!is_last && tokens[at + 1].before != Break::sentence)
      continue;
    const auto next = is_last ? text.size() : tokens[at + 1].begin;
    const auto end = text.substr(tokens[at].end, next - tokens[at].end);
    if (!is_denied || end.find('?') != std::string::npos)
      words.insert(words.end(), sentence.begin(), sentence.end());
    sentence.clear();
    is_denied = false;
  }
  return words;
}

void read_changes(const Value& changes, const Schema& schema,
                  Context& context) {
  const auto* slots = changes.if_map() ? changes["slots"].if_map() : nullptr;
  if (!slots)
    return;
  context.changes_topic = schema.topic(changes["topic"].text());
  for (const auto& [slot, name] : slots->entries())
    if (name.if_string())
      context.changes.push_back({slot, words_in(*name.if_string())});
}

} // namespace

double Context::bonus(TopicNumber topic) const {
  if (topic == no_topic)
    return 0;
  if (topic == current)
    return 0.2;
  // What was just spoken about, or is to be spoken about again, is half as
  // likely as the current topic.
  const bool waits = topic == resting || topic == completed ||
                     std::ranges::find(unfinished, topic) != unfinished.end();
  return waits ? 0.1 : 0;
}

double Context::waiting_bonus(TopicNumber topic, bool fills_it) const {
  return topic != no_topic && topic == waiting_topic && fills_it
             ? asked_bonus / 2
             : 0;
}

bool Context::goes_on(TopicNumber topic) const {
  return topic == asked_topic || topic == current ||
         std::ranges::find(unfinished, topic) != unfinished.end();
}

Context read_context(const Value& context, const Schema& schema) {
  Context read;
  read_asked(context["asked"], schema, read);
  if (read.asked_topic == no_topic) {
    read_asked(context["waiting"], schema, read);
    read.waiting_topic = std::exchange(read.asked_topic, no_topic);
    read.waiting_slot = std::exchange(read.asked_slot, {});
  }
  read_said(context["said"], schema, read);
  read.current = schema.topic(context["current"].text());
  read.resting = schema.topic(context["resting"].text());
  read.completed = schema.topic(context["completed"].text());
  if (const auto* unfinished = context["unfinished"].if_list())
    for (const auto& name : *unfinished)
      if (const auto topic = schema.topic(name.text()); topic != no_topic)
        read.unfinished.push_back(topic);
  if (const auto* grammar = context["grammar"].if_string())
    read.grammar = *grammar;
  if (const auto* question = context["confirms"].if_string())
    read.confirms = words_asked(*question);
  read_changes(context["changes"], schema, read);
  if (const auto* choices = context["choices"].if_list())
    for (const auto& choice : *choices)
      read.choices.push_back(choice.text());
  if (const auto* now = context["now"].if_integer())
    read.now = *now;
  read.heard = context["heard"].if_list() != nullptr;
  return read;
}

} // namespace parlour::adapters::nlu
