// Schema holds the application's topics and slots, numbered, with the kind of
// value that belongs to each slot. It also resolves the references (`@…`) of
// grammars.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "adapters/nlu/forms/normal_forms.hpp"
#include "adapters/nlu/values/value_index.hpp"
#include "runtime/message/understanding.hpp"

namespace parlour::adapters::nlu {

// The index of a topic in Schema::topics().
using TopicNumber = std::uint32_t;
inline constexpr TopicNumber no_topic = 0xFFFFFFFF;

// What may stand at a place in a grammar: a normal form, any words (`@words`,
// `@rest`), the value that the context asks for (`@asked`), or a value of a
// set. One number covers all of them, so that an arc of the automaton needs
// only one field:
//
//  0 …                  the normal forms, as in enum Form
//  words_entity         any words
//  asked_entity         what the last question wants
//  rest_entity          all words up to the end of the clause
//  first_set_entity …   the sets of values, by SetId
using EntityId = std::uint32_t;
inline constexpr EntityId words_entity = form_count;
inline constexpr EntityId asked_entity = form_count + 1;
inline constexpr EntityId rest_entity = form_count + 2;
inline constexpr EntityId first_set_entity = form_count + 3;

inline bool is_form(EntityId entity) {
  return entity < form_count;
}
inline bool is_set(EntityId entity) {
  return entity >= first_set_entity;
}
// Not any words.
inline bool has_known_values(EntityId entity) {
  return is_form(entity) || is_set(entity);
}

// One of 64 bits for each entity, by which a set of them is known not to have
// one. Only sets share their bits.
constexpr std::uint64_t entity_bit(EntityId entity) {
  constexpr EntityId of_sets = 64 - first_set_entity;
  return std::uint64_t{1} << (entity < first_set_entity
                                  ? entity
                                  : first_set_entity +
                                        (entity - first_set_entity) % of_sets);
}
inline constexpr std::uint64_t form_bits = entity_bit(form_count) - 1;

// Built once, then only read, by any number of threads; resolve() belongs to
// building.
class Schema {
public:
  struct Slot {
    std::string name;
    EntityId entity = words_entity;
    bool many = false; // several values of it may be said in one act
    // A smaller number is none of it, unless it is asked for: where all have
    // five digits, one of three may be a mistake, and "six" means another
    // thing.
    std::int64_t fewest = 0;
  };
  struct Topic {
    std::string name;
    bool enquiry = false;
    bool part = false; // spoken about only while it goes on
    std::vector<Slot> slots;

    // What is said about it, where nothing says otherwise.
    const char* usual_act() const {
      return enquiry ? "request" : "inform";
    }
    const Slot* find(std::string_view slot) const;
    bool takes_many(std::string_view slot) const;
  };
  // What `@…` in a grammar stands for.
  struct Reference {
    EntityId entity = words_entity;
    // If the reference names a slot, its topic and name.
    TopicNumber topic = no_topic;
    std::string slot;
  };

  // Reads the columns that slots name. One that cannot be read is an error and
  // counts as an empty set.
  Schema(const UnderstandingModel& model, const ColumnReader& reader,
         std::vector<Error>& errors);

  // Resolves "Facility.Category", "db:rr_staff.staff_name", "time", "words" or
  // "asked". Reads a column that was not named before.
  std::optional<Reference> resolve(std::string_view text,
                                   const SourceLocation& place,
                                   std::vector<Error>& errors);

  // no_topic if there is none of that name.
  TopicNumber topic(std::string_view name) const;
  const Topic& at(TopicNumber number) const {
    return topics_[number];
  }
  const std::vector<Topic>& topics() const {
    return topics_;
  }
  // All topics that have a slot of this name.
  std::vector<TopicNumber> topics_with(std::string_view slot) const;
  std::vector<std::string> topic_names() const;
  // The slots of one topic, or of all for no_topic. For error messages.
  std::vector<std::string> slot_names(TopicNumber topic) const;

  // Other words for those of values; see ValueIndex.
  void add_synonyms(const std::vector<std::vector<std::string>>& groups) {
    values_.add_synonyms(groups);
  }
  const ValueIndex& values() const {
    return values_;
  }

private:
  Slot slot_of(const SlotModel& slot, std::vector<Error>& errors);
  EntityId entity_of(const SlotModel& slot, const SourceLocation& place,
                     std::vector<Error>& errors);
  EntityId column(const std::string& name, const SourceLocation& place,
                  std::vector<Error>& errors);
  EntityId add_set(const std::vector<std::string>& values);
  std::optional<Reference> slot_reference(std::string_view topic_name,
                                          std::string_view slot_name,
                                          const SourceLocation& place,
                                          std::vector<Error>& errors) const;

  ColumnReader reader_;
  std::vector<Topic> topics_;
  ValueIndex values_;
  std::vector<std::int64_t> fewest_; // by set
  TextMap<EntityId> columns_;
};

} // namespace parlour::adapters::nlu
