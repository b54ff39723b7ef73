// The application's topics and slots, numbered, and what kind of value belongs
// to each; resolves the `@…` of grammars. Built once, then only read.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "adapters/nlu/forms/normal_forms.hpp"
#include "adapters/nlu/values/value_index.hpp"
#include "runtime/base/understanding.hpp"

namespace parlour::adapters::nlu {

using TopicNumber = std::uint32_t;
inline constexpr TopicNumber no_topic = 0xFFFFFFFF;

// What a place in a grammar takes: a normal form, any words, the value that
// the context asks for, or one of a set.
using EntityId = std::uint32_t;
inline constexpr EntityId words_entity = form_count;
inline constexpr EntityId asked_entity = form_count + 1;
inline constexpr EntityId first_set_entity = form_count + 2;

inline bool is_form(EntityId entity) {
  return entity < form_count;
}
inline bool is_set(EntityId entity) {
  return entity >= first_set_entity;
}

class Schema {
public:
  struct Slot {
    std::string name;
    EntityId entity = words_entity;
  };
  struct Topic {
    std::string name;
    bool enquiry = false;
    std::vector<Slot> slots;

    const Slot* find(std::string_view slot) const;
  };
  struct Reference {
    EntityId entity = words_entity;
    TopicNumber topic = no_topic; // where the reference names a slot
    std::string slot;
  };

  // A column that cannot be read is an error and an empty set.
  Schema(const UnderstandingModel& model, const ColumnReader& reader,
         std::vector<Error>& errors);

  // "Facility.Category", "db:rr_staff.staff_name", "time", "words", "asked".
  std::optional<Reference> resolve(std::string_view text, const Place& place,
                                   std::vector<Error>& errors);

  TopicNumber topic(std::string_view name) const; // no_topic for none
  const Topic& at(TopicNumber number) const {
    return topics_[number];
  }
  const std::vector<Topic>& topics() const {
    return topics_;
  }
  // All topics that have this slot.
  std::vector<TopicNumber> topics_with(std::string_view slot) const;
  std::vector<std::string> topic_names() const;
  std::vector<std::string> slot_names(TopicNumber topic) const; // or of all

  const ValueIndex& values() const {
    return values_;
  }

private:
  EntityId entity_of(const SlotModel& slot, const Place& place,
                     std::vector<Error>& errors);
  EntityId column(const std::string& name, const Place& place,
                  std::vector<Error>& errors);
  EntityId add_set(const std::vector<std::string>& values);
  std::optional<Reference> slot_reference(std::string_view topic_name,
                                          std::string_view slot_name,
                                          const Place& place,
                                          std::vector<Error>& errors) const;

  ColumnReader reader_;
  std::vector<Topic> topics_;
  ValueIndex values_;
  TextMap<EntityId> columns_;
};

} // namespace parlour::adapters::nlu
