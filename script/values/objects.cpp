// The layout of objects in memory: a head (heap, count, type), then the members
// of the type. A string has its bytes behind the members, in the same block;
// lists and maps own arrays from the same heap; errors and results own memory
// of the standard library, which is only accounted for.

#include "script/values/objects.hpp"

#include <cstring>

#include "runtime/base/text/utf8.hpp"
#include "script/support/block_cache.hpp"
#include "script/support/estimated_size.hpp"

namespace parlour::script {
namespace {

// Constructs an object with a count of one in memory of the heap.
template <class T, class... Arguments>
T* create(Heap& heap, ObjectType type, Arguments&&... arguments) {
  auto* memory = heap.allocate(sizeof(T));
  return new (memory)
      T{{&heap, 1, type}, std::forward<Arguments>(arguments)...};
}

template <class T>
void remove(Object* object, std::size_t bytes = sizeof(T)) {
  auto* heap = object->heap;
  static_cast<T*>(object)->~T();
  heap->release(object, bytes);
}

// The bytes that an object holds outside of the heap's blocks.
std::size_t held(const ErrorObject& error) {
  return error.message.size() + error.place.file.size();
}

std::size_t held(const ResultObject& result) {
  return result.bytes;
}

template <class T>
void remove_holder(Object* object) {
  object->heap->discount(held(*static_cast<T*>(object)));
  remove<T>(object);
}

template <class T>
Box account(T* object) {
  object->heap->account(held(*object));
  return Box::adopt(object);
}

// Runs the destructor of the object's type and returns its block.
void remove(Object* object) {
  switch (object->type) {
  case ObjectType::string:
    return remove<StringObject>(object,
                                sizeof(StringObject) +
                                    static_cast<StringObject*>(object)->size);
  case ObjectType::list:
    return remove<ListObject>(object);
  case ObjectType::map:
    return remove<MapObject>(object);
  case ObjectType::result:
  case ObjectType::binary:
    return remove_holder<ResultObject>(object);
  case ObjectType::error:
    return remove_holder<ErrorObject>(object);
  case ObjectType::integer:
    return remove<IntegerObject>(object);
  }
}

StringObject* new_string(void* memory, Heap* heap, std::string_view text) {
  auto* string =
      new (memory) StringObject{{heap, 1, ObjectType::string},
                                static_cast<std::uint32_t>(text.size()),
                                count_code_points(text),
                                0,
                                false};
  if (!text.empty())
    std::memcpy(string->data(), text.data(), text.size());
  return string;
}

} // namespace

// The limit is not checked here, but when an instruction has finished
// (Machine::within_limits); what may be large is checked before (has_room).
void* Heap::allocate(std::size_t bytes) {
  used_ += bytes;
  return BlockCache::take(bytes);
}

void Heap::release(void* block, std::size_t bytes) {
  discount(bytes);
  BlockCache::give(block, bytes);
}

// Destroying a list can make the counts of its elements 0. These are queued
// instead of destroyed at once, so that a long chain of objects needs no deep
// native stack. Strings hold nothing and are freed directly.
void destroy(Object* object) noexcept {
  auto& heap = *object->heap;
  if (object->type == ObjectType::string) {
    remove(object);
    return;
  }
  heap.doomed_.push_back(object);
  if (heap.destroying_)
    return;
  heap.destroying_ = true;
  while (!heap.doomed_.empty()) {
    auto* next = heap.doomed_.back();
    heap.doomed_.pop_back();
    remove(next);
  }
  heap.destroying_ = false;
}

std::uint32_t hash_of(std::string_view text) {
  std::uint32_t hash = 2166136261u;
  for (const char byte : text)
    hash = (hash ^ static_cast<unsigned char>(byte)) * 16777619u;
  return hash ? hash : 1; // 0 means "not computed"
}

std::uint32_t hash_of(const StringObject& string) {
  if (string.hash == 0)
    string.hash = hash_of(string.text());
  return string.hash;
}

// Counts all bytes but continuation bytes. These have the highest bit set and
// the second highest clear; shifting by one brings the second bit below the
// first. Of eight bytes at a time, the marked bits are summed by a
// multiplication into the topmost byte.
std::uint32_t count_code_points(std::string_view text) {
  auto count = static_cast<std::uint32_t>(text.size());
  std::uint64_t eight = 0;
  std::size_t i = 0;
  for (; i + sizeof eight <= text.size(); i += sizeof eight) {
    std::memcpy(&eight, text.data() + i, sizeof eight);
    const auto continuing = eight & ~(eight << 1) & 0x8080808080808080;
    count -= static_cast<std::uint32_t>(
        (continuing >> 7) * 0x0101010101010101 >> 56);
  }
  for (; i < text.size(); ++i)
    count -= continues_code_point(text[i]);
  return count;
}

Box make_string(Heap& heap, std::string_view text) {
  auto* memory = heap.allocate(sizeof(StringObject) + text.size());
  return Box::adopt(new_string(memory, &heap, text));
}

Box make_string(Heap& heap, std::string_view text, std::uint32_t code_points) {
  auto* string = raw_string(heap, text.size());
  if (!text.empty())
    std::memcpy(string->data(), text.data(), text.size());
  return finish_string(string, code_points);
}

StringObject* raw_string(Heap& heap, std::size_t size) {
  auto* memory = heap.allocate(sizeof(StringObject) + size);
  return new (memory) StringObject{{&heap, 1, ObjectType::string},
                                   static_cast<std::uint32_t>(size),
                                   0,
                                   0,
                                   false};
}

Box finish_string(StringObject* string) {
  return finish_string(string, count_code_points(string->text()));
}

Box finish_string(StringObject* string, std::uint32_t code_points) {
  string->code_points = code_points;
  return Box::adopt(string);
}

Box make_integer(Heap& heap, std::int64_t value) {
  return Box::fits(value) ? Box::small(value)
                          : Box::adopt(create<IntegerObject>(
                                heap, ObjectType::integer, value));
}

Box make_list(Heap& heap, std::size_t reserve) {
  auto* list = create<ListObject>(heap, ObjectType::list,
                                  Boxes(HeapAllocator<Box>(&heap)));
  list->elements.reserve(reserve);
  return Box::adopt(list);
}

Box make_map(Heap& heap, MapObject::Entries entries) {
  using Index = decltype(MapObject::index);
  auto* map = create<MapObject>(heap, ObjectType::map, std::move(entries),
                                Index(HeapAllocator<std::uint32_t>(&heap)));
  map->rebuild_index();
  return Box::adopt(map);
}

Box make_foreign(Heap& heap, const Value& value) {
  const auto type = value.type() == ValueType::result ? ObjectType::result
                                                      : ObjectType::binary;
  return account(
      create<ResultObject>(heap, type, value, estimated_size(value), Box()));
}

Box make_error(Heap& heap, ErrorKind kind, std::string message,
               SourceLocation place) {
  return account(create<ErrorObject>(heap, ObjectType::error, kind,
                                     std::move(message), std::move(place),
                                     Box()));
}

bool equal_strings(const StringObject& left, const StringObject& right) {
  if (&left == &right)
    return true;
  if (left.size != right.size || (left.interned && right.interned))
    return false;
  return std::memcmp(left.text().data(), right.text().data(), left.size) == 0;
}

// -- maps ---------------------------------------------------------------------

namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);
constexpr std::size_t indexed_from = 9;

// Compares all pairs, as a map without an index is small.
template <class Entries>
bool are_distinct(const Entries& entries) {
  for (auto one = entries.begin(); one != entries.end(); ++one)
    for (auto other = entries.begin(); other != one; ++other)
      if (equal_strings(*one->key.string(), *other->key.string()))
        return false;
  return true;
}

} // namespace

// `same` is the key as an object, if known: comparing pointers comes first.
std::size_t MapObject::position(std::string_view key, std::uint32_t hash,
                                const StringObject* same) const {
  if (index.empty()) {
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const auto* string = entries[i].key.string();
      if (string == same ||
          (string->size == key.size() && string->text() == key))
        return i;
    }
    return none;
  }
  const auto mask = index.size() - 1;
  for (auto i = hash & mask; index[i] != 0; i = (i + 1) & mask) {
    const auto* string = entries[index[i] - 1].key.string();
    if (string == same || (string->hash == hash && string->text() == key))
      return index[i] - 1;
  }
  return none;
}

void MapObject::rebuild_index() {
  if (entries.size() < indexed_from)
    index.clear();
  else
    // Between three and six places for each entry; set() rebuilds at two.
    rebuild_index(std::bit_ceil(entries.size() * 3));
}

bool MapObject::fits_index(std::size_t places) const {
  if (entries.size() < indexed_from)
    return places == 0;
  return std::has_single_bit(places) && places >= entries.size() * 2 &&
         places < entries.size() * 6;
}

// Returns false as soon as a key is found twice. Only a corrupt state has that.
bool MapObject::rebuild_index(std::size_t places) {
  index.clear();
  index.resize(places);
  if (places == 0)
    return are_distinct(entries);
  const auto mask = places - 1;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto& key = *entries[i].key.string();
    auto slot = hash_of(key) & mask;
    for (; index[slot] != 0; slot = (slot + 1) & mask)
      if (equal_strings(*entries[index[slot] - 1].key.string(), key))
        return false;
    index[slot] = static_cast<std::uint32_t>(i + 1);
  }
  return true;
}

// Usually the key is the very constant that was put in, so comparing pointers
// finds it without reading any text.
Box* MapObject::look_up(const StringObject& key) {
  if (index.empty()) {
    const auto at = position(key.text(), 0, &key);
    if (at == none)
      return nullptr;
    found = at;
    return &entries[at].value;
  }
  const auto hash = hash_of(key);
  const auto mask = index.size() - 1;
  for (auto i = hash & mask; index[i] != 0; i = (i + 1) & mask) {
    auto& entry = entries[index[i] - 1];
    const auto* string = entry.key.string();
    if (string == &key ||
        (string->hash == hash && equal_strings(*string, key))) {
      found = index[i] - 1;
      return &entry.value;
    }
  }
  return nullptr;
}

Box* MapObject::find(std::string_view key) {
  const auto at = position(key, index.empty() ? 0 : hash_of(key), nullptr);
  return at == none ? nullptr : &entries[at].value;
}

void MapObject::set(const Box& key, Box value) {
  if (auto* there = find(*key.string())) {
    *there = std::move(value);
    return;
  }
  entries.push_back({key, std::move(value)});
  if (entries.size() < indexed_from)
    return;
  if (entries.size() * 2 > index.size())
    return rebuild_index();
  const auto mask = index.size() - 1;
  auto slot = hash_of(*key.string()) & mask;
  while (index[slot] != 0)
    slot = (slot + 1) & mask;
  index[slot] = static_cast<std::uint32_t>(entries.size());
}

bool MapObject::remove(std::string_view key, Box& removed) {
  const auto at = position(key, index.empty() ? 0 : hash_of(key), nullptr);
  if (at == none)
    return false;
  removed = std::move(entries[at].value);
  entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(at));
  rebuild_index();
  return true;
}

// -- constants ----------------------------------------------------------------

ConstantPool::~ConstantPool() {
  for (auto& [text, string] : strings_)
    std::free(string);
  for (auto* integer : integers_)
    delete integer;
}

// Equal texts are one object, so constants are compared by their addresses.
Box ConstantPool::string(std::string_view text) {
  if (auto there = strings_.find(text); there != strings_.end())
    return Box::adopt(there->second);
  // Not from the cache of blocks, whose lists belong to a thread.
  auto* memory = std::malloc(sizeof(StringObject) + text.size());
  if (!memory)
    throw std::bad_alloc();
  auto* string = new_string(memory, nullptr, text);
  string->interned = true;
  string->hash = hash_of(text); // now: readers in other threads must not write
  strings_.emplace(string->text(), string);
  return Box::adopt(string);
}

Box ConstantPool::integer(std::int64_t value) {
  if (Box::fits(value))
    return Box::small(value);
  integers_.push_back(
      new IntegerObject{{nullptr, 1, ObjectType::integer}, value});
  return Box::adopt(integers_.back());
}

std::optional<Box> ConstantPool::find(std::string_view text) const {
  const auto there = strings_.find(text);
  return there == strings_.end() ? std::nullopt
                                 : std::optional(Box::adopt(there->second));
}

std::optional<Box> ConstantPool::find(std::int64_t value) const {
  for (auto* integer : integers_)
    if (integer->value == value)
      return Box::adopt(integer);
  return {};
}

} // namespace parlour::script
