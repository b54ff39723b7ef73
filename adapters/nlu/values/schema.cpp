#include "adapters/nlu/values/schema.hpp"

#include <algorithm>
#include <limits>
#include <span>

#include "adapters/nlu/text/similarity.hpp"

namespace parlour::adapters::nlu {

namespace {

void report(std::vector<Error>& errors, const SourceLocation& place,
            std::string message) {
  errors.push_back({ErrorKind::compile, std::move(message), place});
}

std::optional<EntityId> named_entity(std::string_view name) {
  if (const auto form = form_of(name))
    return static_cast<EntityId>(*form);
  if (name == "words")
    return words_entity;
  if (name == "asked")
    return asked_entity;
  if (name == "rest")
    return rest_entity;
  return {};
}

// Fewer digits may be any number.
constexpr std::size_t least_digits = 3;

// The smallest number of a digit less, if all from `least` to `most` have as
// many digits and may be what things are known by; else 0.
std::int64_t fewest_of(std::int64_t least, std::int64_t most) {
  const auto digits = std::to_string(least).size();
  if (least <= 0 || most < least || digits < least_digits ||
      std::to_string(most).size() != digits)
    return 0;
  std::int64_t fewest = 1;
  for (std::size_t digit = 2; digit < digits; ++digit)
    fewest *= 10;
  return fewest;
}

// The same for values, if all of them are numbers.
std::int64_t fewest_of(std::span<const std::string> values) {
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  std::int64_t most = 0;
  for (const auto& value : values) {
    const auto number = parse_number(value).integer_or(0);
    if (number <= 0)
      return 0;
    least = std::min(least, number);
    most = std::max(most, number);
  }
  return values.empty() ? 0 : fewest_of(least, most);
}

} // namespace

const Schema::Slot* Schema::Topic::find(std::string_view slot) const {
  const auto found = std::ranges::find(slots, slot, &Slot::name);
  return found == slots.end() ? nullptr : &*found;
}

bool Schema::Topic::takes_many(std::string_view slot) const {
  const auto* found = find(slot);
  return found && found->many;
}

Schema::Schema(const UnderstandingModel& model, const ColumnReader& reader,
               std::vector<Error>& errors)
    : reader_(reader) {
  for (const auto& topic : model.topics) {
    Topic made{topic.name, topic.enquiry, topic.part, {}};
    for (const auto& slot : topic.slots)
      made.slots.push_back(slot_of(slot, errors));
    topics_.push_back(std::move(made));
  }
}

Schema::Slot Schema::slot_of(const SlotModel& slot,
                             std::vector<Error>& errors) {
  const auto entity = entity_of(slot, {}, errors);
  return {slot.name, entity, slot.many,
          is_set(entity) ? fewest_[entity - first_set_entity]
                         : fewest_of(slot.least, slot.most)};
}

// The kind of value of a slot: its own set, a column, a range of numbers, a
// normal form, or any words.
EntityId Schema::entity_of(const SlotModel& slot, const SourceLocation& place,
                           std::vector<Error>& errors) {
  // The order matters: a slot of a set or column may have a type as well.
  if (!slot.values.empty() || slot.type == "boolean" || slot.type == "part")
    return add_set(slot.values);
  if (!slot.source.empty())
    return column(slot.source, place, errors);
  if (slot.type == "range")
    return static_cast<EntityId>(Form::number);
  if (const auto form = form_of(slot.type))
    return static_cast<EntityId>(*form);
  return words_entity;
}

EntityId Schema::add_set(const std::vector<std::string>& values) {
  fewest_.push_back(fewest_of(values));
  return first_set_entity + values_.add(values);
}

// Each column is read once; slots and grammars that name it share its set.
EntityId Schema::column(const std::string& name, const SourceLocation& place,
                        std::vector<Error>& errors) {
  if (const auto found = columns_.find(name); found != columns_.end())
    return found->second;
  std::vector<std::string> values;
  if (!reader_) {
    report(errors, place, "there is no database for @" + name);
  } else if (auto read = reader_(name)) {
    values = std::move(*read);
  } else {
    auto error = read.error();
    error.message = "@" + name + ": " + error.message;
    // An error of the reader may have a better place, such as a file of SQL.
    if (error.place.file.empty())
      error.place = place;
    errors.push_back(std::move(error));
  }
  return columns_[name] = add_set(values);
}

// A name with a point is a slot; without one it is a normal form, "words" or
// "asked".
std::optional<Schema::Reference> Schema::resolve(std::string_view text,
                                                 const SourceLocation& place,
                                                 std::vector<Error>& errors) {
  if (text.starts_with("db:"))
    return Reference{column(std::string(text), place, errors), no_topic, ""};
  if (const auto entity = named_entity(text))
    return Reference{*entity, no_topic, ""};
  if (const auto point = text.find('.'); point != std::string_view::npos)
    return slot_reference(text.substr(0, point), text.substr(point + 1), place,
                          errors);
  const std::vector<std::string> known{"time",     "date",  "number",
                                       "duration", "phone", "email",
                                       "level",    "words", "asked"};
  report(errors, place,
         "there is no value @" + std::string(text) + did_you_mean(text, known));
  return {};
}

// Resolves "Topic.Slot"; an error suggests the most similar name.
std::optional<Schema::Reference>
Schema::slot_reference(std::string_view topic_name, std::string_view slot_name,
                       const SourceLocation& place,
                       std::vector<Error>& errors) const {
  const auto number = topic(topic_name);
  if (number == no_topic) {
    report(errors, place,
           "there is no topic '" + std::string(topic_name) + "'" +
               did_you_mean(topic_name, topic_names()));
    return {};
  }
  if (const auto* slot = topics_[number].find(slot_name))
    return Reference{slot->entity, number, slot->name};
  report(errors, place,
         "the topic '" + std::string(topic_name) + "' has no slot '" +
             std::string(slot_name) + "'" +
             did_you_mean(slot_name, slot_names(number)));
  return {};
}

TopicNumber Schema::topic(std::string_view name) const {
  const auto found = std::ranges::find(topics_, name, &Topic::name);
  return found == topics_.end()
             ? no_topic
             : static_cast<TopicNumber>(found - topics_.begin());
}

std::vector<TopicNumber> Schema::topics_with(std::string_view slot) const {
  std::vector<TopicNumber> found;
  for (TopicNumber number = 0; number < topics_.size(); ++number)
    if (topics_[number].find(slot))
      found.push_back(number);
  return found;
}

std::vector<std::string> Schema::topic_names() const {
  std::vector<std::string> names;
  for (const auto& topic : topics_)
    names.push_back(topic.name);
  return names;
}

std::vector<std::string> Schema::slot_names(TopicNumber number) const {
  std::vector<std::string> names;
  for (TopicNumber at = 0; at < topics_.size(); ++at)
    if (number == no_topic || at == number)
      for (const auto& slot : topics_[at].slots)
        names.push_back(slot.name);
  return names;
}

} // namespace parlour::adapters::nlu
