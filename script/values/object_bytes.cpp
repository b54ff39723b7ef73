// Writing numbers the objects in an order in which every object follows those
// that it holds (a post-order walk); reading makes them in that order.

#include "script/values/object_bytes.hpp"

#include <bit>
#include <cmath>

#include "runtime/base/value_bytes.hpp"

namespace parlour::script {

namespace {

enum class BoxTag : std::uint8_t {
  unknown,
  no,
  yes,
  integer,
  number,
  object,
};

enum class ObjectTag : std::uint8_t {
  string,
  constant_string,
  integer,
  constant_integer,
  list,
  map,
  result,
  binary,
  error,
};

void put(ByteWriter& bytes, BoxTag tag) {
  bytes.byte(static_cast<std::uint8_t>(tag));
}

void put(ByteWriter& bytes, ObjectTag tag) {
  bytes.byte(static_cast<std::uint8_t>(tag));
}

constexpr std::uint64_t end_of_lines = std::uint64_t{1} << 32;
constexpr std::uint64_t error_kinds = 0
#define X(name, text, sentence) +1
    PARLOUR_ERROR_KINDS(X)
#undef X
    ;

template <class T>
const T& as(const Object* object) {
  return *static_cast<const T*>(object);
}

// The boxes that an object holds, by index; null after the last. Keys and
// values of a map alternate.
const Box* child(const Object* object, std::size_t at) {
  switch (object->type) {
  case ObjectType::list: {
    const auto& elements = as<ListObject>(object).elements;
    return at < elements.size() ? &elements[at] : nullptr;
  }
  case ObjectType::map: {
    const auto& entries = as<MapObject>(object).entries;
    if (at / 2 >= entries.size())
      return nullptr;
    return at % 2 ? &entries[at / 2].value : &entries[at / 2].key;
  }
  case ObjectType::error:
    return at == 0 ? &as<ErrorObject>(object).value : nullptr;
  case ObjectType::result:
    return at == 0 ? &as<ResultObject>(object).rows : nullptr;
  default:
    return nullptr;
  }
}

// The capacity that is stored with an array.
template <class Array>
std::size_t room_for_more(const Array& array) {
  return array.capacity() - array.size();
}

} // namespace

// -- writing ------------------------------------------------------------------

// Objects that the box refers to are written to the part of the objects, if
// they are new; the box itself is written here.
void ObjectWriter::write(ByteWriter& bytes, const Box& box) {
  if (box.is_object())
    number(box);
  mention(bytes, box);
}

// The object that represents this one in the bytes.
const Object* ObjectWriter::the_one(const Box& box) {
  const auto* object = box.object();
  if (object->heap || object->type != ObjectType::integer)
    return object;
  const auto value = as<IntegerObject>(object).value;
  return constants_.try_emplace(value, object).first->second;
}

// Numbers an object after all that it holds, with a stack of its own, because
// values can be nested deeper than the native stack allows.
void ObjectWriter::number(const Box& box) {
  const auto open = [this](const Object* object) {
    if (!numbers_.contains(object))
      open_.push_back({object, 0});
  };
  open(the_one(box));
  while (!open_.empty()) {
    auto& top = open_.back();
    const auto* held = child(top.object, top.next++);
    if (!held) {
      complete(top.object);
      open_.pop_back();
    } else if (held->is_object()) {
      open(the_one(*held));
    }
  }
}

// Writes a box whose object is numbered already.
void ObjectWriter::mention(ByteWriter& bytes, const Box& box) {
  if (box.is_object()) {
    put(bytes, BoxTag::object);
    bytes.number(numbers_.at(the_one(box)));
  } else if (box.is_number()) {
    put(bytes, BoxTag::number);
    bytes.fixed(std::bit_cast<std::uint64_t>(box.as_number()));
  } else if (box.is_small()) {
    put(bytes, BoxTag::integer);
    bytes.signed_number(box.as_small());
  } else {
    put(bytes, !box.is_boolean() ? BoxTag::unknown
               : box.is_true()   ? BoxTag::yes
                                 : BoxTag::no);
  }
}

// Writes an object whose children are all numbered.
void ObjectWriter::complete(const Object* object) {
  numbers_.emplace(object, numbers_.size());
  const bool constant = !object->heap;
  switch (object->type) {
  case ObjectType::string:
    put(objects_, constant ? ObjectTag::constant_string : ObjectTag::string);
    return objects_.text(as<StringObject>(object).text());
  case ObjectType::integer:
    put(objects_, constant ? ObjectTag::constant_integer : ObjectTag::integer);
    return objects_.signed_number(as<IntegerObject>(object).value);
  case ObjectType::list:
    return write_list(as<ListObject>(object));
  case ObjectType::map:
    return write_map(as<MapObject>(object));
  case ObjectType::result:
    put(objects_, ObjectTag::result);
    parlour::write(objects_, as<ResultObject>(object).value);
    return mention(objects_, as<ResultObject>(object).rows);
  case ObjectType::binary:
    put(objects_, ObjectTag::binary);
    return parlour::write(objects_, as<ResultObject>(object).value);
  case ObjectType::error:
    return write_error(as<ErrorObject>(object));
  }
}

void ObjectWriter::write_list(const ListObject& list) {
  put(objects_, ObjectTag::list);
  objects_.number(list.elements.size());
  for (const auto& element : list.elements)
    mention(objects_, element);
  objects_.number(room_for_more(list.elements));
}

// The entries in their order; the index is rebuilt from them when reading.
void ObjectWriter::write_map(const MapObject& map) {
  put(objects_, ObjectTag::map);
  objects_.number(map.entries.size());
  for (const auto& [key, value] : map.entries) {
    objects_.number(numbers_.at(key.object()));
    mention(objects_, value);
  }
  objects_.number(room_for_more(map.entries));
  objects_.number(map.index.size());
  objects_.number(room_for_more(map.index));
}

// Errors keep their place, so a restored one reports the same line.
void ObjectWriter::write_error(const ErrorObject& error) {
  put(objects_, ObjectTag::error);
  objects_.byte(static_cast<std::uint8_t>(error.kind));
  objects_.text(error.message);
  objects_.text(error.place.file);
  objects_.number(error.place.line);
  objects_.number(error.place.column);
  mention(objects_, error.value);
}

void ObjectWriter::write_objects(ByteWriter& bytes) const {
  bytes.number(numbers_.size());
  bytes.add(objects_);
}

// -- reading ------------------------------------------------------------------

// Each object may refer to those before it only.
void ObjectReader::read_objects() {
  const auto count = bytes_.count("objects");
  for (std::size_t i = 0; i < count && bytes_.ok(); ++i)
    objects_.push_back(read_object());
}

Box ObjectReader::read(std::uint8_t tag) {
  switch (static_cast<BoxTag>(tag)) {
  case BoxTag::unknown:
    return {};
  case BoxTag::no:
    return Box::boolean(false);
  case BoxTag::yes:
    return Box::boolean(true);
  case BoxTag::integer:
    return integer();
  case BoxTag::number:
    return number();
  case BoxTag::object:
    return object();
  }
  bytes_.fail("no value begins so");
  return {};
}

Box ObjectReader::integer() {
  const auto value = bytes_.signed_number();
  if (!Box::fits(value))
    bytes_.fail("an integer beyond 48 bits is an object");
  return bytes_.ok() ? Box::small(value) : Box();
}

Box ObjectReader::number() {
  const auto value = std::bit_cast<double>(bytes_.fixed());
  if (!std::isfinite(value))
    bytes_.fail("a number is not finite");
  return bytes_.ok() ? Box::number(value) : Box();
}

// Only objects that were read before can be referred to, so no ring can arise.
Box ObjectReader::object() {
  const auto at = bytes_.below(objects_.size(), "object");
  return bytes_.ok() ? objects_[at] : Box();
}

// One object by its tag.
Box ObjectReader::read_object() {
  switch (static_cast<ObjectTag>(bytes_.byte())) {
  case ObjectTag::string:
    return make_string(heap_, bytes_.text());
  case ObjectTag::constant_string:
    return read_constant_string();
  case ObjectTag::integer:
    return read_integer();
  case ObjectTag::constant_integer:
    return read_constant_integer();
  case ObjectTag::list:
    return read_list();
  case ObjectTag::map:
    return read_map();
  case ObjectTag::result:
    return read_foreign(ValueType::result);
  case ObjectTag::binary:
    return read_foreign(ValueType::binary);
  case ObjectTag::error:
    return read_error();
  }
  bytes_.fail("no object begins so");
  return {};
}

// Every value has one form, so an integer that fits into a box must not be an
// object.
Box ObjectReader::read_integer() {
  const auto value = bytes_.signed_number();
  if (Box::fits(value))
    bytes_.fail("an integer within 48 bits is no object");
  return make_integer(heap_, value);
}

// Constants are found in the program, so that they stay shared with its code.
Box ObjectReader::read_constant_string() {
  const auto text = bytes_.text();
  if (auto constant = constants_.find(text))
    return *constant;
  bytes_.fail("the program has no such constant");
  return {};
}

Box ObjectReader::read_constant_integer() {
  if (auto constant = constants_.find(bytes_.signed_number()))
    return *constant;
  bytes_.fail("the program has no such constant");
  return {};
}

// The limit is checked first, as a corrupt number could be huge.
std::size_t ObjectReader::room_for_more(std::size_t size_of_each) {
  const auto count = bytes_.number();
  const auto max = heap_.limit() / size_of_each;
  return bytes_.ok() && count <= max && heap_.has_room(count * size_of_each)
             ? count
             : 0;
}

Box ObjectReader::read_list() {
  // The elements are collected first, so that the list is allocated once with
  // exactly the stored capacity.
  std::vector<Box> elements;
  const auto count = bytes_.count("elements of a list");
  for (std::size_t i = 0; i < count && bytes_.ok(); ++i)
    elements.push_back(read());
  auto list = make_list(heap_, count + room_for_more(sizeof(Box)));
  for (auto& element : elements)
    list.list()->elements.push_back(std::move(element));
  return list;
}

// The index is not stored, only its size: it follows from the keys.
Box ObjectReader::read_map() {
  std::vector<MapObject::Entry> entries;
  const auto count = bytes_.count("entries of a map");
  for (std::size_t i = 0; i < count && bytes_.ok(); ++i) {
    auto key = read_key();
    entries.push_back({std::move(key), read()});
  }
  if (!bytes_.ok())
    return {};
  auto map = make_map(heap_);
  map.map()->entries.reserve(count + room_for_more(sizeof(MapObject::Entry)));
  for (auto& entry : entries)
    map.map()->entries.push_back(std::move(entry));
  read_index(*map.map());
  return bytes_.ok() ? map : Box();
}

Box ObjectReader::read_key() {
  auto key = object();
  if (!key.is_string())
    bytes_.fail("a map's key is no string");
  return key;
}

// The size must be one that set() could have made; the entries are then entered
// again, which also finds repeated keys.
void ObjectReader::read_index(MapObject& map) {
  constexpr auto size_of_each = sizeof(std::uint32_t);
  const auto places = bytes_.number();
  if (!map.fits_index(places))
    return bytes_.fail("a map's index has not its size");
  map.index.reserve(places + room_for_more(size_of_each));
  if (bytes_.ok() && !map.rebuild_index(places))
    bytes_.fail("a map has a key twice");
}

// A result or binary: a value of the runtime, and for a result the rows that
// were converted already.
Box ObjectReader::read_foreign(ValueType type) {
  auto value = read_value(bytes_);
  if (value.type() != type) {
    bytes_.fail("there is no " + std::string(name_of(type)));
    return {};
  }
  auto box = make_foreign(heap_, value);
  if (type == ValueType::result) {
    auto rows = read();
    if (!rows.is_unknown() && !rows.is_list())
      bytes_.fail("the rows of a result are no list");
    else
      box.result()->rows = std::move(rows);
  }
  return box;
}

// The kind is an index into the table of kinds and is checked like any index.
Box ObjectReader::read_error() {
  const auto kind = bytes_.below(error_kinds, "kind of error");
  std::string message(bytes_.text());
  SourceLocation place;
  place.file = bytes_.text();
  place.line = static_cast<std::uint32_t>(bytes_.below(end_of_lines, "line"));
  place.column =
      static_cast<std::uint32_t>(bytes_.below(end_of_lines, "column"));
  auto box = make_error(heap_, static_cast<ErrorKind>(kind), std::move(message),
                        std::move(place));
  box.error()->value = read();
  return box;
}

} // namespace parlour::script
