// Archive: the walk through all that a conversation knows, for writing (writer)
// and reading (reader) alike. A part says what it consists of:
//
//   template <class Archive>
//   void serialize(Archive& archive) {
//     archive(turn, text, candidates);         // by their types
//     archive.slot(topic, slot);               // ids, checked against the
//     archive.code(body);                      //   program when read
//     archive.up_to(purpose, For::which_topic); // the last of an enumeration
//     archive.check(text.size() < 9, "…");     // what else the part relies on
//     archive.without(port_);                  // not kept: known otherwise
//   }
//
// The whole (runtime/base/bytes.hpp has the words):
//
//   version        a byte, conversation_version
//   interpreter    block: its variables and the activations that wait
//                  (script/vm/interpreter_state.hpp), bound to the program
//   parts          in the order of ConversationImplementation::serialize
//
// A field takes no name and no tag; one that is a
//
//   bool           is a byte
//   enumeration    is a number
//   unsigned       is a number, one of 32 bits as an id
//   signed, time   is signed
//   text, value    is a text, or the bytes of a value (value_bytes.hpp)
//   list, map      is a count and its elements; keys rise
//   optional       is a byte, and where it is 1 the object
//   id             is a number plus one, in 32 bits; 0: none
//   shared object  is 0 for none, 1 and the object where it is met first, or
//                  the place from 2 of one that was met, so that what is shared
//                  stays shared
//
// Equal states have equal bytes, and reading what was written gives the same
// state. Bytes that are damaged or made up give an error of kind File.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/random.hpp"
#include "runtime/base/value.hpp"
#include "runtime/message/message.hpp"
#include "runtime/message/subscription.hpp"
#include "script/program/program.hpp"

namespace parlour::dialogue {

// To be raised with each change of what a part writes. Bytes of another version
// are refused; there is no way to read older ones.
inline constexpr std::uint8_t conversation_version = 9;

// `Self` moves numbers, texts, values and shared objects; the rest is made of
// these. It is Writer, Reader or RenamingWriter, which know what is not the
// same in both directions. Not for several threads.
template <class Self>
class Archive {
public:
  template <class... Fields>
  void operator()(Fields&... fields) {
    (one(fields), ...);
  }

  // Does nothing: it says that these fields were not forgotten
  // (tools/check/saved).
  template <class... Fields>
  void without(const Fields&...) {}

  // What a part relies on. A reader fails with this text where it does not
  // hold.
  void check(bool holds, const char* otherwise) {
    if (!holds)
      self().fail(otherwise);
  }

  // An enumeration whose last one is `last`.
  template <class Enumeration>
  void up_to(Enumeration& field, Enumeration last) {
    auto number = static_cast<std::uint64_t>(field);
    self().below(number, static_cast<std::uint64_t>(last) + 1, "choice");
    field = static_cast<Enumeration>(number);
  }

  void topic(script::TopicId& id) {
    one(id);
    is_below(id, program_.topics.size(), "there is no such topic");
  }
  void slot(script::TopicId& of, script::SlotId& id) {
    topic(of);
    slot_of(of, id);
  }
  void slot_of(script::TopicId of, script::SlotId& id) {
    one(id);
    is_slot(of, id);
  }
  void state(script::StateId& id) {
    one(id);
    is_below(id, program_.states.size(), "there is no such state");
  }
  void code(script::CodeId& id) {
    one(id);
    is_below(id, program_.code.size(), "there is no such code");
  }
  void topic(std::optional<script::TopicId>& id) {
    auto known = id.value_or(script::no_id);
    topic(known);
    id = known == script::no_id ? std::nullopt : std::optional(known);
  }
  void topics(std::vector<script::TopicId>& ids) {
    each(ids, [&](script::TopicId& id) {
      topic(id);
      needs(id);
    });
  }
  void slots_of(script::TopicId of, std::vector<script::SlotId>& ids) {
    each(ids, [&](script::SlotId& id) {
      slot_of(of, id);
      needs(id);
    });
  }
  void codes(std::vector<script::CodeId>& ids) {
    each(ids, [&](script::CodeId& id) {
      code(id);
      needs(id);
    });
  }

  // An id, or what is pointed at, that must be there.
  void needs(std::uint32_t id) {
    check(id != script::no_id, "an id is missing");
  }
  template <class T>
  void needs(const std::shared_ptr<T>& object) {
    check(object != nullptr, "an object is missing");
  }
  // One of so many places.
  void place(std::uint64_t& field, std::uint64_t end) {
    self().below(field, end, "place");
  }
  // A slot that must be there.
  void is_there(script::TopicId of, script::SlotId id) {
    is_slot(of, id);
    needs(id);
  }
  // A frame has as many slots as its topic.
  void has_slots(script::TopicId of, std::size_t count) {
    check(of < program_.topics.size() &&
              program_.topics[of].slots.size() == count,
          "a frame has other slots than its topic");
  }
  // No id, or one of so many.
  void is_below(std::uint32_t id, std::size_t size, const char* otherwise) {
    check(id == script::no_id || id < size, otherwise);
  }
  void is_slot(script::TopicId of, script::SlotId id) {
    is_below(id,
             of < program_.topics.size() ? program_.topics[of].slots.size() : 0,
             "there is no such slot");
  }
  // The topic of a program that a part points at.
  void topic(const script::Topic*& field) {
    const auto* first = program_.topics.data();
    auto id = static_cast<std::uint64_t>(field ? field - first : 0);
    self().below(id, program_.topics.size(), "topic");
    if (self().ok())
      field = first + id;
  }

  // What stands in a list that is made elsewhere: `add` gives the next element.
  template <class List, class Add, class Visit>
  void each(List& list, std::size_t size, Add add, Visit visit) {
    const auto count = self().count(size);
    if constexpr (Self::reads) {
      for (std::size_t i = 0; i < count && self().ok(); ++i)
        visit(add());
    } else {
      for (auto& element : list)
        visit(element);
    }
  }
  template <class List, class Visit>
  void each(List& list, Visit visit) {
    if constexpr (Self::reads)
      list.clear();
    each(
        list, list.size(), [&]() -> auto& { return list.emplace_back(); },
        visit);
  }

  const script::Program& program() const {
    return program_;
  }

protected:
  explicit Archive(const script::Program& program) : program_(program) {}
  ~Archive() = default;

private:
  // Times and counts that one can still reckon with.
  static constexpr std::int64_t max_number = std::int64_t{1} << 53;
  static constexpr std::int64_t max_count = std::int64_t{1} << 30;

  Self& self() {
    return static_cast<Self&>(*this);
  }

  template <class Part>
  requires requires(Part& part, Self& self) {
    part.serialize(self);
  }
  void one(Part& part) {
    if (!self().enter())
      return;
    part.serialize(self());
    self().leave();
  }
  template <class Part>
  requires requires(Part& part, Self& self) {
    serialize_step(self, part);
  }
  void one(Part& part) {
    serialize_step(self(), part);
  }
  void one(bool& field) {
    std::uint64_t number = field;
    self().below(number, 2, "flag");
    field = number != 0;
  }
  void one(std::uint64_t& field) {
    self().number(field);
  }
  void one(std::uint32_t& field) {
    std::uint64_t number = field + std::uint32_t{1}; // no id: 0
    self().below(number, std::uint64_t{1} << 32, "number");
    field = static_cast<std::uint32_t>(number) - 1;
  }
  void one(int& field) {
    auto number = static_cast<std::int64_t>(field);
    self().signed_number(number);
    check(number >= -max_count && number <= max_count, "a count is too large");
    field = static_cast<int>(number);
  }
  void one(std::int64_t& field) {
    self().signed_number(field);
    check(field >= -max_number && field <= max_number, "a number is too large");
  }
  void one(Milliseconds& field) {
    auto count = static_cast<std::int64_t>(field.count());
    one(count);
    field = Milliseconds(count);
  }
  void one(std::string& field) {
    self().text(field);
  }
  void one(Value& field) {
    self().value(field);
  }
  void one(Random& random) {
    auto state = random.state();
    one(state);
    random = Random(state);
  }
  void one(SourceLocation& place) {
    auto& [file, line, column] = place;
    (*this)(file, line, column);
  }
  void one(Error& error) {
    auto& [kind, message, place] = error;
    up_to(kind, ErrorKind::settings);
    (*this)(message, place);
  }
  void one(Message& message) {
    auto& [time, number, source, command, params, sinks, session, correlation,
           rounds] = message;
    (*this)(time, number, source, command, params, sinks, session, correlation,
            rounds);
  }
  void one(Subscription& subscription) {
    auto& [source, command] = subscription;
    (*this)(source, command);
  }

  template <class First, class Second>
  void one(std::pair<First, Second>& pair) {
    (*this)(pair.first, pair.second);
  }
  template <class T>
  void one(std::optional<T>& field) {
    bool there = field.has_value();
    one(there);
    if constexpr (Self::reads)
      field.reset();
    if (there && !field)
      field.emplace(T());
    if (there)
      one(*field);
  }
  template <class T>
  void one(Expected<T>& field) {
    bool good = field.has_value();
    one(good);
    if constexpr (Self::reads)
      if (!good)
        field = tl::make_unexpected(Error());
    if (good)
      one(*field);
    else
      one(field.error());
  }
  void one(Expected<void>& field) {
    bool good = field.has_value();
    one(good);
    if constexpr (Self::reads)
      field = good ? Expected<void>() : tl::make_unexpected(Error());
    if (!good)
      one(field.error());
  }
  template <class T, class Allocator>
  void one(std::vector<T, Allocator>& list) {
    each(list, [&](T& element) { one(element); });
  }
  void one(std::vector<bool>& list) { // of a length that is known
    for (auto&& element : list) {
      bool flag = element;
      one(flag);
      element = flag;
    }
  }
  template <class Key, class T, class Less>
  void one(std::map<Key, T, Less>& map) {
    if constexpr (Self::reads)
      read_keys(map, [&](Key key) {
        one(map.emplace_hint(map.end(), std::move(key), T())->second);
      });
    else
      write_keys(map, [&](auto& entry) {
        auto key = entry.first;
        (*this)(key, entry.second);
      });
  }
  template <class Key, class Less>
  void one(std::set<Key, Less>& set) {
    if constexpr (Self::reads)
      read_keys(set, [&](Key key) { set.insert(set.end(), std::move(key)); });
    else
      write_keys(set, [&](auto key) { one(key); });
  }
  template <class T>
  void one(std::shared_ptr<T>& field) {
    self().shared(field);
  }
  template <class T>
  void one(std::unique_ptr<T>& field) {
    if constexpr (Self::reads)
      field = std::make_unique<T>();
    one(*field);
  }

  // Keys must rise, so that equal states have equal bytes and none comes twice.
  template <class Keyed, class Add>
  void read_keys(Keyed& keyed, Add add) {
    keyed.clear();
    const auto count = self().count(0);
    for (std::size_t i = 0; i < count && self().ok(); ++i) {
      typename Keyed::key_type key{};
      one(key);
      check(keyed.upper_bound(key) == keyed.end() && !keyed.contains(key),
            "keys do not rise");
      if (self().ok())
        add(std::move(key));
    }
  }
  template <class Keyed, class Write>
  void write_keys(Keyed& keyed, Write write) {
    self().count(keyed.size());
    for (auto& entry : keyed)
      write(entry);
  }

  const script::Program& program_;
};

} // namespace parlour::dialogue
