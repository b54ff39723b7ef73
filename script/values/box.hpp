// Box: a value inside of the interpreter in eight bytes (language rule 2). It
// uses NaN boxing: a double is stored as it is, and all other values are stored
// in the bit patterns of negative NaNs, which no calculation produces (language
// rule 2.5).
//
//    63       48 47                                  0
//   +-----------+------------------------------------+
//   | below fff9  a double                           |
//   |   fff9    | integer of 48 bits, plus 2^47      |
//   |   fffa    | unknown 0, false 2, true 3,        |
//   |           | missing argument or value 4        |
//   |   fffb    | Box*: a variable bound to a        |
//   |           | parameter                          |
//   |   fffc    | StringObject*                      |
//   |   fffd    | ListObject*                        |
//   |   fffe    | MapObject*                         |
//   |   ffff    | another Object*: see its `type`    |
//   +-----------+------------------------------------+
//
// Objects are reference counted. The counts are not atomic, because a session
// is run by one thread at a time. Objects in a program's pool of constants are
// immortal and immutable, so sessions share them without counting. A container
// can never contain itself (this is refused when it is set), so counting alone
// frees everything and no garbage collector is needed.
#pragma once

#include <bit>
#include <cassert>
#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>

namespace parlour::script {

class Heap;

enum class ObjectType : std::uint8_t {
  string,
  list,
  map,
  result,
  binary,
  error,
  integer, // beyond 48 bits
};

// The head of every object on a session's heap or in a pool of constants.
struct Object {
  Heap* heap; // null: immortal
  std::uint32_t count;
  ObjectType type;
};

struct StringObject;
struct ListObject;
struct MapObject;
struct ResultObject;
struct ErrorObject;

// Frees an object whose count has become 0, and what it held.
void destroy(Object* object) noexcept;

// Copying costs a test and, for objects, a count; moving costs no count.
class Box {
public:
  Box() = default; // unknown
  Box(const Box& other) : bits_(other.bits_) {
    retain();
  }
  Box(Box&& other) noexcept : bits_(std::exchange(other.bits_, unknown_bits)) {}
  Box& operator=(const Box& other) {
    other.retain();
    replace(other.bits_);
    return *this;
  }
  Box& operator=(Box&& other) noexcept {
    replace(std::exchange(other.bits_, unknown_bits));
    return *this;
  }
  ~Box() {
    release(bits_);
  }

  // Moves `other` into this box, which must not hold an object: unlike an
  // assignment it need not release anything.
  void take(Box& other) {
    bits_ = std::exchange(other.bits_, unknown_bits);
  }

  // -- small integers: fast paths of the instructions ------------------------
  static bool both_small(const Box& left, const Box& right) {
    constexpr auto tag = integer_tag << 48;
    return (((left.bits_ ^ tag) | (right.bits_ ^ tag)) >> 48) == 0;
  }
  // Sets this box to the sum of two small integers. Returns false and changes
  // nothing if the sum does not fit into 48 bits. Because integers are stored
  // with an offset, adding the bits adds the integers, and an overflow shows as
  // a changed tag. The two functions below work likewise.
  bool take_sum(const Box& left, const Box& right) {
    return take_small(left.bits_ + (right.bits_ - zero_bits));
  }
  bool take_difference(const Box& left, const Box& right) {
    return take_small(left.bits_ - (right.bits_ - zero_bits));
  }
  bool take_product(const Box& left, const Box& right) {
    std::int64_t product = 0;
    return !__builtin_mul_overflow(left.as_small(), right.as_small(),
                                   &product) &&
           take_small(zero_bits + static_cast<std::uint64_t>(product));
  }
  // The bits of small integers compare in the same order as the integers.
  std::uint64_t ordered_bits() const {
    return bits_;
  }

  // Copies `other`. Neither box may hold an object, so nothing is counted.
  void set_uncounted(const Box& other) {
    bits_ = other.bits_;
  }

  // Makes boxes of values that need no object.
  static Box boolean(bool value) {
    return Box(value ? true_bits : false_bits);
  }
  static Box number(double value) {
    return Box(std::bit_cast<std::uint64_t>(value));
  }
  // The value must fit into 48 bits (see fits).
  static Box small(std::int64_t value) {
    assert(fits(value));
    return Box(zero_bits + static_cast<std::uint64_t>(value));
  }
  static bool fits(std::int64_t value) {
    return value >= -(std::int64_t{1} << 47) && value < std::int64_t{1} << 47;
  }
  // Makes a box of an object and takes over one count of it.
  static Box adopt(Object* object) {
    return Box(tag_of(object->type) << 48 |
               (reinterpret_cast<std::uint64_t>(object) & payload_mask));
  }
  // Makes a box of an object and adds a count.
  static Box share(Object* object) {
    assert(object);
    auto box = adopt(object);
    box.retain();
    return box;
  }
  // The register of a parameter that is passed by reference (language rule
  // 7.3). It points to the caller's variable and must not outlive it.
  static Box reference(Box* target) {
    return Box(reference_tag << 48 |
               (reinterpret_cast<std::uint64_t>(target) & payload_mask));
  }

  // Stands for an argument that the caller left out; the callee replaces it by
  // the default before its body runs. In a session variable it stands for an
  // initial value that nobody has looked at (Machine::variable). Scripts never
  // see it.
  static Box missing() {
    return Box(missing_bits);
  }

  bool is_missing() const {
    return bits_ == missing_bits;
  }
  bool is_unknown() const {
    return bits_ == unknown_bits;
  }
  bool is_boolean() const {
    return bits_ == true_bits || bits_ == false_bits;
  }
  bool is_true() const {
    return bits_ == true_bits;
  }
  bool is_number() const {
    return bits_ < integer_tag << 48;
  }
  bool is_small() const {
    return bits_ >> 48 == integer_tag;
  }
  bool is_reference() const {
    return bits_ >> 48 == reference_tag;
  }
  bool is_object() const {
    return bits_ >= string_tag << 48;
  }
  bool is_string() const {
    return bits_ >> 48 == string_tag;
  }
  // Neither a container nor a bound parameter: it can be stored anywhere
  // without a search for rings.
  bool is_simple() const {
    return bits_ < list_tag << 48 && !is_reference();
  }
  bool is_list() const {
    return bits_ >> 48 == list_tag;
  }
  bool is_map() const {
    return bits_ >> 48 == map_tag;
  }
  // Whether it refers to an object of this type; for strings, lists and maps
  // the functions above are faster.
  bool is(ObjectType type) const {
    return is_object() && object()->type == type;
  }

  // Each may be called only if the box is of that kind; debug builds assert it.
  double as_number() const {
    assert(is_number());
    return std::bit_cast<double>(bits_);
  }
  std::int64_t as_small() const {
    assert(is_small());
    return static_cast<std::int64_t>(bits_ - zero_bits);
  }
  Object* object() const {
    assert(is_object());
    return reinterpret_cast<Object*>(bits_ & payload_mask);
  }
  Box* target() const {
    assert(is_reference());
    return reinterpret_cast<Box*>(bits_ & payload_mask);
  }
  // The value itself: looks through a bound parameter.
  const Box& resolved() const {
    return is_reference() ? *target() : *this;
  }
  Box& resolved() {
    return is_reference() ? *target() : *this;
  }
  // The object by its type; the caller must have checked the type.
  StringObject* string() const;
  ListObject* list() const;
  MapObject* map() const;
  ResultObject* result() const;
  ErrorObject* error() const;
  std::string_view text() const;   // of a string
  std::int64_t as_integer() const; // small or boxed
  bool is_integer() const {
    return is_small() || is(ObjectType::integer);
  }

  bool same_bits(const Box& other) const {
    return bits_ == other.bits_;
  }

private:
  static constexpr std::uint64_t payload_mask = 0xffffffffffff;
  static constexpr std::uint64_t integer_tag = 0xfff9;
  // Small integers are stored with an offset of 2^47, so that sums, differences
  // and the order of the bits are those of the integers.
  static constexpr std::uint64_t zero_bits =
      integer_tag << 48 | std::uint64_t{1} << 47;
  static constexpr std::uint64_t special_tag = 0xfffa;
  static constexpr std::uint64_t reference_tag = 0xfffb;
  static constexpr std::uint64_t string_tag = 0xfffc;
  static constexpr std::uint64_t list_tag = 0xfffd;
  static constexpr std::uint64_t map_tag = 0xfffe;
  static constexpr std::uint64_t other_tag = 0xffff;
  static constexpr std::uint64_t unknown_bits = special_tag << 48;
  static constexpr std::uint64_t false_bits = unknown_bits | 2;
  static constexpr std::uint64_t true_bits = unknown_bits | 3;
  static constexpr std::uint64_t missing_bits = unknown_bits | 4;

  explicit Box(std::uint64_t bits) : bits_(bits) {}
  static std::uint64_t tag_of(ObjectType type) {
    return type == ObjectType::string ? string_tag
           : type == ObjectType::list ? list_tag
           : type == ObjectType::map  ? map_tag
                                      : other_tag;
  }
  // Constants have no heap and are not counted.
  void retain() const {
    if (is_object() && object()->heap)
      ++object()->count;
  }
  bool take_small(std::uint64_t bits) {
    if (bits >> 48 != integer_tag) [[unlikely]]
      return false;
    replace(bits);
    return true;
  }
  // Releases the old value last, as freeing it may run any number of
  // destructors.
  void replace(std::uint64_t bits) {
    const auto old = bits_;
    bits_ = bits;
    release(old);
  }
  static void release(std::uint64_t bits) {
    if (bits < string_tag << 48) [[likely]]
      return;
    auto* object = reinterpret_cast<Object*>(bits & payload_mask);
    assert(!object->heap || object->count > 0);
    if (object->heap && --object->count == 0)
      destroy(object);
  }

  std::uint64_t bits_ = unknown_bits;
};

static_assert(sizeof(Box) == 8);

} // namespace parlour::script
