// The objects that a Box refers to, the heap that accounts for them (one for
// each session, with its interpreter), and the pool of a program's constants.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"
#include "script/values/box.hpp"

namespace parlour::script {

// Counts the bytes that a session's values hold. Owned by the interpreter and
// its activations; keeps the program alive, as boxes point into its constants.
class Heap {
public:
  Heap(std::shared_ptr<const void> keep, std::size_t limit)
      : keep_(std::move(keep)), limit_(limit) {}
  Heap(const Heap&) = delete;
  Heap& operator=(const Heap&) = delete;

  void* allocate(std::size_t bytes);
  void release(void* block, std::size_t bytes);
  // What an object holds beside its block: texts and values of the runtime.
  void account(std::size_t bytes) {
    used_ += bytes;
  }
  void discount(std::size_t bytes) {
    used_ -= bytes;
  }

  bool has_room(std::size_t bytes) const {
    return bytes <= limit_ && used_ <= limit_ - bytes;
  }
  bool over_limit() const {
    return used_ > limit_;
  }
  std::size_t used() const {
    return used_;
  }
  std::size_t limit() const {
    return limit_;
  }

private:
  friend void destroy(Object* object) noexcept;

  std::shared_ptr<const void> keep_;
  std::size_t limit_;
  std::size_t used_ = 0;
  std::vector<Object*> doomed_; // so that deep structures need no deep stack
  bool destroying_ = false;
};

// An allocator for the containers' arrays, so that they are accounted too.
template <class T>
struct HeapAllocator {
  using value_type = T;
  Heap* heap;

  explicit HeapAllocator(Heap* owner) : heap(owner) {}
  template <class U>
  HeapAllocator(const HeapAllocator<U>& other) : heap(other.heap) {}
  T* allocate(std::size_t count) {
    return static_cast<T*>(heap->allocate(count * sizeof(T)));
  }
  void deallocate(T* block, std::size_t count) {
    heap->release(block, count * sizeof(T));
  }
  bool operator==(const HeapAllocator& other) const {
    return heap == other.heap;
  }
};

using Boxes = std::vector<Box, HeapAllocator<Box>>;

struct StringObject : Object {
  std::uint32_t size;         // bytes
  std::uint32_t code_points;  // equal to size: plain ASCII
  mutable std::uint32_t hash; // 0: not computed yet
  bool interned;              // two interned strings are equal if identical

  char* data() {
    return reinterpret_cast<char*>(this + 1);
  }
  std::string_view text() const {
    return {reinterpret_cast<const char*>(this + 1), size};
  }
};

struct ListObject : Object {
  Boxes elements;
};

// String keys in insertion order; an index of hashes once it is not small.
struct MapObject : Object {
  struct Entry {
    Box key;
    Box value;
  };
  std::vector<Entry, HeapAllocator<Entry>> entries;
  std::vector<std::uint32_t, HeapAllocator<std::uint32_t>> index;
  std::size_t found = 0; // the entry found last: what is read is often written

  Box* find(const StringObject& key) {
    if (found < entries.size() && entries[found].key.object() == &key)
      return &entries[found].value;
    return look_up(key);
  }
  Box* find(std::string_view key);
  void set(const Box& key, Box value);
  bool remove(std::string_view key, Box& removed);
  // Whether set() may have left an index of so many places.
  bool fits_index(std::size_t places) const;
  // With such an index. False where a key is there twice.
  bool rebuild_index(std::size_t places);

private:
  Box* look_up(const StringObject& key);
  std::size_t position(std::string_view key, std::uint32_t hash,
                       const StringObject* same) const;
  void rebuild_index();
};

// A result set, which is immutable, or a binary.
struct ResultObject : Object {
  Value value;
  std::size_t bytes; // that the value holds
  Box rows;          // list of maps, made when first asked for
};

struct ErrorObject : Object {
  ErrorKind kind;
  std::string message;
  Place place;
  Box value; // of <throw>
};

struct IntegerObject : Object {
  std::int64_t value;
};

std::uint32_t hash_of(std::string_view text);
std::uint32_t hash_of(const StringObject& string);
std::uint32_t count_code_points(std::string_view text);

Box make_string(Heap& heap, std::string_view text);
// The same, where the number of code points is known.
Box make_string(Heap& heap, std::string_view text, std::uint32_t code_points);
// Room for `size` bytes, to be filled in before anything else; then finish.
StringObject* raw_string(Heap& heap, std::size_t size);
Box finish_string(StringObject* string);
Box finish_string(StringObject* string, std::uint32_t code_points);
Box make_integer(Heap& heap, std::int64_t value);
Box make_list(Heap& heap, std::size_t reserve = 0);
Box make_map(Heap& heap);
Box make_foreign(Heap& heap, const Value& value); // result set or binary
Box make_error(Heap& heap, ErrorKind kind, std::string message, Place place);

bool equal_strings(const StringObject& left, const StringObject& right);

// The interned strings and large integers of one program. Filled by the
// compiler, then read by any thread.
class ConstantPool {
public:
  ConstantPool() = default;
  ConstantPool(const ConstantPool&) = delete;
  ConstantPool& operator=(const ConstantPool&) = delete;
  ~ConstantPool();

  Box string(std::string_view text);
  Box integer(std::int64_t value);
  // Nothing where there is no such constant.
  std::optional<Box> find(std::string_view text) const;
  std::optional<Box> find(std::int64_t value) const;

  // Of the program that they belong to, 0 until it is asked for; see
  // program_identity.hpp.
  mutable std::atomic<std::uint64_t> identity = 0;

private:
  std::unordered_map<std::string_view, StringObject*> strings_;
  std::vector<IntegerObject*> integers_;
};

inline StringObject* Box::string() const {
  return static_cast<StringObject*>(object());
}
inline ListObject* Box::list() const {
  return static_cast<ListObject*>(object());
}
inline MapObject* Box::map() const {
  return static_cast<MapObject*>(object());
}
inline ResultObject* Box::result() const {
  return static_cast<ResultObject*>(object());
}
inline ErrorObject* Box::error() const {
  return static_cast<ErrorObject*>(object());
}
inline std::string_view Box::text() const {
  return string()->text();
}
inline std::int64_t Box::as_integer() const {
  return is_small() ? as_small() : static_cast<IntegerObject*>(object())->value;
}

} // namespace parlour::script
