// The objects that boxes refer to; the heap that accounts for them, one for
// each session; and the pool of a program's constants.
//
// Life of an object: make_… creates it with one count inside of a Box; boxes
// share it by counting; the last box frees it, and its memory returns to the
// session's account at once.
#pragma once

#include <atomic>
#include <cassert>
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

// Counts the bytes that a session's values hold (language rule 9.6). It does
// not enforce the limit: the interpreter asks over_limit() and has_room().
// Owned by the interpreter and its activations. It keeps the program alive,
// because boxes point to the program's constants. Used by one thread at a time.
class Heap {
public:
  // `keep` is whatever must live as long as the boxes: the program.
  Heap(std::shared_ptr<const void> keep, std::size_t limit)
      : keep_(std::move(keep)), limit_(limit) {}
  Heap(const Heap&) = delete;
  Heap& operator=(const Heap&) = delete;

  // Memory from the thread's cache of blocks, which is accounted for.
  void* allocate(std::size_t bytes);
  void release(void* block, std::size_t bytes);
  // Counts what an object holds outside of its own block, such as texts of
  // errors and values of the runtime.
  void account(std::size_t bytes) {
    used_ += bytes;
  }
  void discount(std::size_t bytes) {
    assert(bytes <= used_);
    used_ -= bytes;
  }

  // Whether this many bytes more would still be within the limit.
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
  std::vector<Object*> doomed_; // objects to destroy; see destroy()
  bool destroying_ = false;
};

// The standard allocator of the containers' arrays, so that these are accounted
// for, too.
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

// The bytes of the text follow the object in the same block. Immutable once
// finished.
struct StringObject : Object {
  std::uint32_t size;         // bytes
  std::uint32_t code_points;  // equal to size: plain ASCII
  mutable std::uint32_t hash; // 0: not computed yet
  bool interned; // two interned strings are equal only if identical

  char* data() {
    return reinterpret_cast<char*>(this + 1);
  }
  std::string_view text() const {
    return {reinterpret_cast<const char*>(this + 1), size};
  }
};

// A list (language rule 2.6): shared by all boxes that refer to it.
struct ListObject : Object {
  Boxes elements;
};

// A map with string keys in insertion order (language rule 2.10). From nine
// entries on an index of hashes is used: open addressing, position plus one, 0
// for free.
struct MapObject : Object {
  struct Entry {
    Box key;
    Box value;
  };
  using Entries = std::vector<Entry, HeapAllocator<Entry>>;

  Entries entries;
  std::vector<std::uint32_t, HeapAllocator<std::uint32_t>> index;
  std::size_t found = 0; // the entry found last, which is often the next one

  // Looks at the entry found last first: m.x = m.x + 1 finds it twice.
  Box* find(const StringObject& key) {
    if (found < entries.size() && entries[found].key.object() == &key)
      return &entries[found].value;
    return look_up(key);
  }
  // The same by text, for keys that are not constants.
  Box* find(std::string_view key);
  void set(const Box& key, Box value);
  // Takes an entry out; false if the key is missing. Linear in the map.
  bool remove(std::string_view key, Box& removed);
  // Whether set() could have made an index with this number of places.
  bool fits_index(std::size_t places) const;
  // Rebuilds the index with this number of places. Returns false if a key
  // occurs twice.
  bool rebuild_index(std::size_t places);
  // The index that so many entries need.
  void rebuild_index();

private:
  Box* look_up(const StringObject& key);
  std::size_t position(std::string_view key, std::uint32_t hash,
                       const StringObject* same) const;
};

// A result set or a binary: an immutable value of the runtime.
struct ResultObject : Object {
  Value value;
  std::size_t bytes; // held by the value
  Box rows;          // list of maps; made when first asked for
};

// An error as <catch> gets it (language rule 9.1).
struct ErrorObject : Object {
  ErrorKind kind;
  std::string message;
  SourceLocation place;
  Box value; // of <throw>
};

// An integer that does not fit into 48 bits.
struct IntegerObject : Object {
  std::int64_t value;
};

// The FNV-1a hash; never 0.
std::uint32_t hash_of(std::string_view text);
std::uint32_t hash_of(const StringObject& string);
// Linear in the text, eight bytes at a time.
std::uint32_t count_code_points(std::string_view text);

Box make_string(Heap& heap, std::string_view text);
// The same if the number of code points is known, which saves counting them.
Box make_string(Heap& heap, std::string_view text, std::uint32_t code_points);
// Allocates a string of `size` bytes to be filled in. Call finish_string before
// anything else is done with it.
StringObject* raw_string(Heap& heap, std::size_t size);
Box finish_string(StringObject* string);
Box finish_string(StringObject* string, std::uint32_t code_points);
// Small if the integer fits into 48 bits, else an object.
Box make_integer(Heap& heap, std::int64_t value);
Box make_list(Heap& heap, std::size_t reserve = 0);
Box make_map(Heap& heap, MapObject::Entries entries); // whose keys differ
inline Box make_map(Heap& heap) {
  return make_map(heap,
                  MapObject::Entries(HeapAllocator<MapObject::Entry>(&heap)));
}
Box make_foreign(Heap& heap, const Value& value); // a result set or a binary
Box make_error(Heap& heap, ErrorKind kind, std::string message,
               SourceLocation place);

// Compares pointers if both strings are interned, bytes otherwise.
bool equal_strings(const StringObject& left, const StringObject& right);

// The interned strings and the large integers of one program. The compiler
// fills it; afterwards it is immutable and read by any thread.
class ConstantPool {
public:
  ConstantPool() = default;
  ConstantPool(const ConstantPool&) = delete;
  ConstantPool& operator=(const ConstantPool&) = delete;
  ~ConstantPool();

  // Returns the constant that is equal, or makes one.
  Box string(std::string_view text);
  Box integer(std::int64_t value);
  // Return nothing if the program has no such constant.
  std::optional<Box> find(std::string_view text) const;
  std::optional<Box> find(std::int64_t value) const;

  // The identity of the program, computed when first asked for; 0 until then.
  // See program_identity.hpp.
  mutable std::atomic<std::uint64_t> identity = 0;

private:
  std::unordered_map<std::string_view, StringObject*> strings_;
  std::vector<IntegerObject*> integers_;
};

inline StringObject* Box::string() const {
  assert(is_string());
  return static_cast<StringObject*>(object());
}
inline ListObject* Box::list() const {
  assert(is_list());
  return static_cast<ListObject*>(object());
}
inline MapObject* Box::map() const {
  assert(is_map());
  return static_cast<MapObject*>(object());
}
inline ResultObject* Box::result() const {
  assert(is(ObjectType::result) || is(ObjectType::binary));
  return static_cast<ResultObject*>(object());
}
inline ErrorObject* Box::error() const {
  assert(is(ObjectType::error));
  return static_cast<ErrorObject*>(object());
}
inline std::string_view Box::text() const {
  return string()->text();
}
inline std::int64_t Box::as_integer() const {
  assert(is_integer());
  return is_small() ? as_small() : static_cast<IntegerObject*>(object())->value;
}

} // namespace parlour::script
