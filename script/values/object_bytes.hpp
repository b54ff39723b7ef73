// Writes the boxes of a stored state and the objects that they refer to as
// bytes, and reads them back (runtime/base/bytes.hpp; language rule 10.4). Each
// object is written once and after the objects that it holds. Therefore reading
// needs no recursion, a corrupt file cannot form a ring, and what is shared
// stays shared. The capacity of arrays is stored as well, so that the heap
// accounts for the same number of bytes afterwards and a limit strikes at the
// same place.
//
// A box:
//   0 unknown   1 false   2 true
//   3 integer   signed, within 48 bits
//   4 number    fixed, the bits of an IEEE double, finite
//   5 object    its number, counted from 0 in the order of the objects
//
// An object:
//   0 string            text
//   1 constant string   text, one of the program's constants
//   2 integer           signed
//   3 constant integer  signed, one of the program's constants
//   4 list              count, boxes; unused capacity
//   5 map               count, for each the number of a string and a box;
//                       unused capacity; places of its index, unused capacity
//                       of the index
//   6 result            value (value_bytes.hpp), box: its rows or unknown
//   7 binary            value
//   8 error             kind, message, file, line, column, box
#pragma once

#include <unordered_map>
#include <vector>

#include "runtime/base/bytes.hpp"
#include "script/values/objects.hpp"

namespace parlour::script {

// Collects objects while boxes are written elsewhere. Afterwards
// write_objects() gives the part that must stand before those boxes. Keeps
// pointers to the objects, which must not change meanwhile.
class ObjectWriter {
public:
  // Writes a box that holds a value and numbers the objects below it.
  void write(ByteWriter& bytes, const Box& box);
  void write_objects(ByteWriter& bytes) const;

private:
  // An object whose children are being numbered.
  struct Open {
    const Object* object;
    std::size_t next; // index of the next child
  };
  void number(const Box& box);
  const Object* the_one(const Box& box);
  void mention(ByteWriter& bytes, const Box& box);
  void complete(const Object* object);
  void write_list(const ListObject& list);
  void write_map(const MapObject& map);
  void write_error(const ErrorObject& error);

  std::unordered_map<const Object*, std::size_t> numbers_;
  // Integer constants by value. A program may have several equal ones, which
  // must become the same constant, as a reader finds constants by value.
  std::unordered_map<std::int64_t, const Object*> constants_;
  std::vector<Open> open_;
  ByteWriter objects_;
};

// Reads the objects first, then any number of boxes. Trusts nothing: what is
// inconsistent fails the ByteReader.
class ObjectReader {
public:
  ObjectReader(ByteReader& bytes, Heap& heap, const ConstantPool& constants)
      : bytes_(bytes), heap_(heap), constants_(constants) {}

  void read_objects();
  // Reads the unused capacity of an array; 0 if it is more than the session may
  // hold.
  std::size_t room_for_more(std::size_t size_of_each);
  // Reads a box; unknown if the reader failed.
  Box read() {
    return read(bytes_.byte());
  }
  Box read(std::uint8_t tag); // the tag has been read

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
