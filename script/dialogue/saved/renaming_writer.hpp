// RenamingWriter: a conversation's parts to bytes as another program reads them
// (archive.hpp): each id becomes that of the same name. For conversations at
// rest: activations and reactions are not written.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/bytes.hpp"
#include "runtime/base/value_bytes.hpp"
#include "script/dialogue/saved/archive.hpp"
#include "script/dialogue/saved/renames.hpp"
#include "script/vm/interpreter.hpp"

namespace parlour::dialogue {

// For one part of a conversation that another program takes over; a Reader of
// the other program reads it (engine/conversation_taken_over.cpp). What it
// cannot name it writes as none, and notes that.
class RenamingWriter : public Archive<RenamingWriter> {
public:
  static constexpr bool reads = false;

  explicit RenamingWriter(const Renames& renames)
      : Archive(renames.from()), renames_(renames) {}

  // As Writer does it.
  template <class Part>
  void write(const Part& part) {
    (*this)(const_cast<Part&>(part));
  }
  std::string take() {
    return bytes_.take();
  }
  // Something that the part names is not there any more.
  bool misses() const {
    return misses_;
  }

  // -- ids, in place of those of Archive
  void topic(script::TopicId& id) {
    put(id, renames_.topic(id));
  }
  void topic(std::optional<script::TopicId>& id) {
    auto known = id.value_or(script::no_id);
    topic(known);
  }
  void topic(const script::Topic*& field) { // of a step that runs
    misses_ = true;
    Archive::topic(field);
  }
  // `of` is the topic in the first program, whose slots have their ids there.
  void slot_of(script::TopicId of, script::SlotId& id) {
    put(id, renames_.slot(of, id));
  }
  void slot(script::TopicId& of, script::SlotId& id) {
    topic(of);
    slot_of(of, id);
  }
  void state(script::StateId& id) {
    put(id, renames_.state(id));
  }
  void code(script::CodeId& id) {
    put(id, renames_.code(id));
  }
  void topics(std::vector<script::TopicId>& ids) {
    put_all(ids, [&](auto id) { return renames_.topic(id); });
  }
  void slots_of(script::TopicId of, std::vector<script::SlotId>& ids) {
    put_all(ids, [&](auto id) { return renames_.slot(of, id); });
  }
  void codes(std::vector<script::CodeId>& ids) {
    put_all(ids, [&](auto id) { return renames_.code(id); });
  }
  // Nothing is written in place of an activation or a reaction: what has one is
  // not at rest, and so is not taken over.
  void activation(std::unique_ptr<script::Activation>&) {
    misses_ = true;
  }
  void reaction(const script::Reaction*&) {
    misses_ = true;
  }

private:
  friend class Archive<RenamingWriter>;

  // As Archive writes an id: plus one, 0 for none.
  void put(std::uint32_t before, std::uint32_t id) {
    misses_ |= before != script::no_id && id == script::no_id;
    bytes_.number(static_cast<std::uint32_t>(id + 1));
  }
  // Of a list, those that are missing there are left out: a reader takes no
  // gaps.
  template <class Rename>
  void put_all(const std::vector<std::uint32_t>& ids, Rename rename) {
    std::vector<std::uint32_t> there;
    for (auto id : ids)
      if (const auto here = rename(id); here != script::no_id)
        there.push_back(here);
    misses_ |= there.size() < ids.size();
    bytes_.number(there.size());
    for (auto id : there)
      put(id, id);
  }

  bool ok() const {
    return true;
  }
  void fail(const char*) {} // what a reader relies on holds while it runs
  bool enter() {
    return true;
  }
  void leave() {}
  void number(std::uint64_t value) {
    bytes_.number(value);
  }
  void below(std::uint64_t value, std::uint64_t, const char*) {
    bytes_.number(value);
  }
  void signed_number(std::int64_t value) {
    bytes_.signed_number(value);
  }
  void text(const std::string& value) {
    bytes_.text(value);
  }
  void value(const Value& value) {
    parlour::write(bytes_, value);
  }
  std::size_t count(std::size_t size) {
    bytes_.number(size);
    return size;
  }
  // As Writer does it: what is shared stays shared within this one part.
  template <class T>
  void shared(const std::shared_ptr<T>& object) {
    if (!object)
      return bytes_.number(0);
    if (const auto known = places_.find(object.get()); known != places_.end())
      return bytes_.number(known->second);
    bytes_.number(1);
    (*this)(const_cast<std::remove_const_t<T>&>(*object));
    const auto place = places_.size() + 2;
    places_[object.get()] = place;
  }

  const Renames& renames_;
  ByteWriter bytes_;
  std::map<const void*, std::uint64_t> places_; // of what is shared
  // An id, activation or reaction was met that has no counterpart.
  bool misses_ = false;
};

} // namespace parlour::dialogue
