// Writer: a conversation's parts to bytes (archive.hpp).
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "runtime/base/bytes.hpp"
#include "script/dialogue/saved/archive.hpp"
#include "script/vm/interpreter.hpp"

namespace parlour::dialogue {

// For one conversation or part, once: write() the parts, then finish() with the
// interpreter, or take() without one. Nothing can fail.
class Writer : public Archive<Writer> {
public:
  static constexpr bool reads = false;

  explicit Writer(const script::Program& program) : Archive(program) {}

  // All of a part. It lists its fields once, for reading too, and is not
  // changed by writing.
  template <class Part>
  void write(const Part& part) {
    (*this)(const_cast<Part&>(part));
  }
  // One that waits; they are a part of the interpreter's state.
  void activation(std::unique_ptr<script::Activation>& one) {
    activations_.push_back(one.get());
  }
  void reaction(const script::Reaction*& field);
  // What was written, without an interpreter's state: of single parts.
  std::string take() {
    return bytes_.take();
  }
  // All of a conversation: behind the interpreter's state and its activations
  // come the parts that were written.
  std::string finish(const script::Interpreter& interpreter);

private:
  friend class Archive<Writer>;

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
  // In the same form as number(): the end is only for who reads.
  void below(std::uint64_t value, std::uint64_t, const char*) {
    bytes_.number(value);
  }
  void signed_number(std::int64_t value) {
    bytes_.signed_number(value);
  }
  void text(const std::string& value) {
    bytes_.text(value);
  }
  void value(const Value& value);
  std::size_t count(std::size_t size) {
    bytes_.number(size);
    return size;
  }

  // An object is numbered when it is complete, behind those that it holds, as
  // the reader does it.
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

  ByteWriter bytes_;
  // Of what is shared: where each object stands, from 2. Addresses are keys
  // only and leave no trace in the bytes.
  std::map<const void*, std::uint64_t> places_;
  // Those that were met, in order; the interpreter saves them.
  std::vector<const script::Activation*> activations_;
};

} // namespace parlour::dialogue
