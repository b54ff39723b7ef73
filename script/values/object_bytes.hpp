// The objects that a stored state refers to, and the boxes that refer to them,
// as bytes (runtime/base/bytes.hpp). Every object is written once, those that
// it holds before it, so that reading needs no recursion and can make no ring;
// what is shared stays shared. What the heap accounts is the same afterwards.
//
// A box:
//   0 unknown   1 false   2 true
//   3 integer   signed, within 48 bits
//   4 number    fixed, the bits of an IEEE double, finite
//   5 object    its number, from 0 in the order of the objects
//
// An object:
//   0 string            text
//   1 constant string   text, one of the program's constants
//   2 integer           signed
//   3 constant integer  signed, one of the program's constants
//   4 list              count, boxes; room for so many more
//   5 map               count, for each the number of a string and a box; room
//                       for so many more, places of its index, room for more
//   6 result            value (value_bytes.hpp), box: its rows or unknown
//   7 binary            value
//   8 error             kind, message, file, line, column, box
#pragma once

#include <unordered_map>
#include <vector>

#include "runtime/base/bytes.hpp"
#include "script/values/objects.hpp"

namespace parlour::script {

class ObjectWriter {
public:
  // A box that holds a value. The objects stand before all boxes.
  void write(ByteWriter& bytes, const Box& box);
  void write_objects(ByteWriter& bytes) const;

private:
  struct Open {
    const Object* object;
    std::size_t next; // child
  };
  void number(const Box& box);
  const Object* the_one(const Box& box);
  void mention(ByteWriter& bytes, const Box& box);
  void complete(const Object* object);
  void write_list(const ListObject& list);
  void write_map(const MapObject& map);
  void write_error(const ErrorObject& error);

  std::unordered_map<const Object*, std::size_t> numbers_;
  // Constants by their value: a program may have equal ones, but reading knows
  // only one of them.
  std::unordered_map<std::int64_t, const Object*> constants_;
  std::vector<Open> open_;
  ByteWriter objects_;
};

class ObjectReader {
public:
  ObjectReader(ByteReader& bytes, Heap& heap, const ConstantPool& constants)
      : bytes_(bytes), heap_(heap), constants_(constants) {}

  void read_objects();
  // What an array may grow by until it takes more memory; none where that is
  // more than the session may hold.
  std::size_t room_for_more(std::size_t size_of_each);
  // Unknown where the reader failed.
  Box read() {
    return read(bytes_.byte());
  }
  Box read(std::uint8_t tag); // which has been read

private:
  Box read_object();
  Box read_string();
  Box read_constant_string();
  Box read_constant_integer();
  Box read_integer();
  Box read_list();
  Box read_map();
  Box read_key();
  void read_index(MapObject& map);
  Box read_foreign(ValueType type);
  Box read_error();
  Box integer();
  Box number();
  Box object();
  ByteReader& bytes_;
  Heap& heap_;
  const ConstantPool& constants_;
  std::vector<Box> objects_;
};

} // namespace parlour::script
