// Reader: a conversation's parts from bytes (archive.hpp). It trusts nothing:
// counts are held against the bytes that are left, ids against the program.
// After its first failure it gives what is empty.
#pragma once

#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/base/bytes.hpp"
#include "script/dialogue/saved/archive.hpp"
#include "script/vm/interpreter.hpp"

namespace parlour::dialogue {

// For one conversation or part, once: begin() where an interpreter's state
// comes first, then the parts, then finish().
class Reader : public Archive<Reader> {
public:
  static constexpr bool reads = true;

  // The bytes outlive the reader.
  Reader(std::shared_ptr<const script::Program> program,
         std::string_view bytes);

  // The version and the interpreter's state, which come first.
  void begin(script::Interpreter& interpreter);
  // The next of the activations that wait.
  void activation(std::unique_ptr<script::Activation>& field);
  // By its number among all of the program (reactions_of.hpp).
  void reaction(const script::Reaction*& field);
  // Whether all was read, and nothing else is there; the first failure
  // otherwise. What was read may be used only after this.
  Expected<void> finish();

  // Whether nothing has failed so far: to be asked before what was read leads
  // to work or to memory.
  bool ok() const {
    return bytes_.ok();
  }
  // Only the first failure is kept.
  void fail(const char* what) {
    bytes_.fail(what);
  }

private:
  friend class Archive<Reader>;

  // An object that was read, for later places that share it.
  struct Shared {
    std::shared_ptr<void> object;
    const char* type; // type_of it
  };

  void number(std::uint64_t& field) {
    field = bytes_.number();
  }
  void below(std::uint64_t& field, std::uint64_t end, const char* what) {
    field = bytes_.below(end, what);
  }
  void signed_number(std::int64_t& field) {
    field = bytes_.signed_number();
  }
  void text(std::string& field) {
    field = bytes_.text();
  }
  void value(Value& field);
  // Not more than the bytes that are left: each element takes one at least.
  std::size_t count(std::size_t) {
    return bytes_.count("elements");
  }

  template <class T>
  static constexpr char type_of = 0; // its address tells a type from others

  // An object holds others that were complete before it: no rings.
  template <class T>
  void shared(std::shared_ptr<T>& field) {
    const auto place = bytes_.below(shared_.size() + 2, "shared object");
    field = nullptr;
    if (place == 1) {
      auto object = std::make_shared<std::remove_const_t<T>>();
      (*this)(*object);
      shared_.push_back({object, &type_of<std::remove_const_t<T>>});
      field = std::move(object);
    } else if (place > 1) {
      const auto& known = shared_[place - 2];
      check(known.type == &type_of<std::remove_const_t<T>>,
            "what is shared is something else");
      if (ok())
        field = std::static_pointer_cast<T>(known.object);
    }
  }
  bool enter(); // a part within others; false: too deep
  void leave() {
    --depth_;
  }

  std::shared_ptr<const script::Program> program_;
  ByteReader bytes_;
  std::vector<Shared> shared_; // by their places
  // Of the part that is read, within others.
  int depth_ = 0;
  std::vector<std::unique_ptr<script::Activation>> activations_;
  std::size_t next_ = 0; // of these
};

} // namespace parlour::dialogue
