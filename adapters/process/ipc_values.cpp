// A structure is a list of its members in a fixed order; writing and reading
// stand side by side. Both ends speak the same version of the protocol, which
// the handshake checks, so the format has no version of its own.
#include "adapters/process/ipc_values.hpp"

#include <utility>

namespace parlour::adapters {

namespace {

tl::unexpected<Error> none(const char* what) {
  return fail(ErrorKind::network, std::string("a value is no ") + what);
}

Value to_value(const SourceLocation& place) {
  return List{place.file, std::int64_t{place.line}, std::int64_t{place.column}};
}

SourceLocation place_from(const Value& value) {
  return {value.at(0).text(),
          static_cast<std::uint32_t>(value.at(1).integer_or(0)),
          static_cast<std::uint32_t>(value.at(2).integer_or(0))};
}

bool truth(const Value& value) {
  return static_cast<bool>(value);
}

// Lists of things of one kind.
template <class T>
Value all(const std::vector<T>& things, Value (*one)(const T&)) {
  List list;
  for (const auto& thing : things)
    list.push_back(one(thing));
  return list;
}

// Skips nothing: an entry that cannot be read becomes an empty one.
template <class T>
std::vector<T> all_from(const Value& value, T (*one)(const Value&)) {
  std::vector<T> things;
  if (const auto* list = value.if_list())
    for (const auto& entry : *list)
      things.push_back(one(entry));
  return things;
}

Value from_text(const std::string& text) {
  return text;
}

std::string text_of(const Value& value) {
  return value.text();
}

Value slot_value(const SlotModel& slot) {
  return List{slot.name,   slot.type,       all(slot.values, from_text),
              slot.source, slot.functional, slot.relevant_to_query,
              slot.many,   slot.least,      slot.most};
}

SlotModel slot_from(const Value& value) {
  return {value.at(0).text(),
          value.at(1).text(),
          all_from(value.at(2), text_of),
          value.at(3).text(),
          truth(value.at(4)),
          truth(value.at(5)),
          truth(value.at(6)),
          value.at(7).integer_or(0),
          value.at(8).integer_or(0)};
}

Value topic_value(const TopicModel& topic) {
  return List{topic.name, topic.enquiry, all(topic.slots, slot_value),
              all(topic.examples, from_text), topic.part};
}

TopicModel topic_from(const Value& value) {
  return {value.at(0).text(), truth(value.at(1)),
          all_from(value.at(2), slot_from), all_from(value.at(3), text_of),
          truth(value.at(4))};
}

Value grammar_value(const GrammarModel& grammar) {
  return List{grammar.name, grammar.text, to_value(grammar.place)};
}

GrammarModel grammar_from(const Value& value) {
  return {value.at(0).text(), value.at(1).text(), place_from(value.at(2))};
}

Value pronunciation_value(const PronunciationModel& sound) {
  return List{sound.word, sound.phones};
}

PronunciationModel pronunciation_from(const Value& value) {
  return {value.at(0).text(), value.at(1).text()};
}

} // namespace

Value to_value(const Message& message) {
  return List{
      message.time,         static_cast<std::int64_t>(message.number),
      message.source,       message.command,
      List(message.params), to_value(message.sinks),
      message.session,      static_cast<std::int64_t>(message.correlation)};
}

Expected<Message> message_from(const Value& value) {
  const auto* params = value.at(4).if_list();
  const auto* command = value.at(3).if_string();
  const auto sinks = texts_from(value.at(5));
  if (!params || !command || !sinks)
    return none("message");
  return Message{
      value.at(0).integer_or(0),
      static_cast<std::uint64_t>(value.at(1).integer_or(0)),
      value.at(2).text(),
      *command,
      *params,
      *sinks,
      value.at(6).text(),
      static_cast<Correlation>(value.at(7).integer_or(0)),
  };
}

Value to_value(const Error& error) {
  return List{std::string(name_of(error.kind)), error.message,
              to_value(error.place)};
}

Error error_from(const Value& value) {
  Error error{ErrorKind::network, value.at(1).text(), place_from(value.at(2))};
  const auto kind = value.at(0).text();
// The kinds of errors by their names, from their table.
#define X(name, text, sentence)                                                \
  if (kind == (text))                                                          \
    error.kind = ErrorKind::name;
  PARLOUR_ERROR_KINDS(X)
#undef X
  return error;
}

Value to_value(const Rendering& rendering) {
  return List{rendering.words ? Value(*rendering.words) : Value(),
              all<Error>(rendering.failures, to_value)};
}

Rendering rendering_from(const Value& value) {
  Rendering rendering;
  if (const auto* words = value.at(0).if_string())
    rendering.words = *words;
  rendering.failures = all_from(value.at(1), error_from);
  return rendering;
}

Value to_value(const Options& options) {
  Map map;
  for (const auto& [name, value] : options)
    map.set(name, value);
  return map;
}

Expected<Options> options_from(const Value& value) {
  const auto* map = value.if_map();
  if (!map)
    return none("options");
  Options options;
  for (const auto& [name, option] : map->entries())
    options[name] = option.text();
  return options;
}

Value to_value(const std::vector<std::string>& texts) {
  return all(texts, from_text);
}

Expected<std::vector<std::string>> texts_from(const Value& value) {
  if (!value.if_list())
    return none("list of texts");
  return all_from(value, text_of);
}

Value to_value(const std::shared_ptr<const UnderstandingModel>& model) {
  if (!model)
    return {};
  return List{all(model->topics, topic_value),
              all(model->grammars, grammar_value),
              all(model->pronunciations, pronunciation_value)};
}

Expected<std::shared_ptr<const UnderstandingModel>>
understanding_from(const Value& value) {
  if (value.is_unknown())
    return nullptr;
  if (!value.if_list())
    return none("understanding");
  return std::make_shared<const UnderstandingModel>(UnderstandingModel{
      all_from(value.at(0), topic_from), all_from(value.at(1), grammar_from),
      all_from(value.at(2), pronunciation_from)});
}

} // namespace parlour::adapters
