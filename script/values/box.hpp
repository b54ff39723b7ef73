// Box: a value inside the interpreter, eight bytes (language rule 2). Doubles
// stand for themselves; everything else hides in the space of negative NaNs,
// which never arise. Strings and containers are counted references; counts are
// not atomic, as a session is run by one thread at a time. Objects of a
// program's constants are immortal and immutable, so that sessions share them.
// Containers never contain themselves (refused when set), so counting frees
// everything.
#pragma once

#include <bit>
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

void destroy(Object* object) noexcept;

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

  // Moves `other` in here, where nothing was that is counted.
  void take(Box& other) {
    bits_ = std::exchange(other.bits_, unknown_bits);
  }

  // -- small integers: what the instructions do with them -------------------
  static bool both_small(const Box& left, const Box& right) {
    constexpr auto tag = integer_tag << 48;
    return (((left.bits_ ^ tag) | (right.bits_ ^ tag)) >> 48) == 0;
  }
  // Takes their sum; false: it does not fit, and nothing is taken.
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
  // By the order of small integers.
  std::uint64_t ordered_bits() const {
    return bits_;
  }

  // Takes the value of `other`, where neither is counted.
  void set_uncounted(const Box& other) {
    bits_ = other.bits_;
  }

  static Box boolean(bool value) {
    return Box(value ? true_bits : false_bits);
  }
  static Box number(double value) {
    return Box(std::bit_cast<std::uint64_t>(value));
  }
  // The caller knows that it fits (see fits).
  static Box small(std::int64_t value) {
    return Box(zero_bits + static_cast<std::uint64_t>(value));
  }
  static bool fits(std::int64_t value) {
    return value >= -(std::int64_t{1} << 47) && value < std::int64_t{1} << 47;
  }
  // Takes over one count.
  static Box adopt(Object* object) {
    return Box(tag_of(object->type) << 48 |
               (reinterpret_cast<std::uint64_t>(object) & payload_mask));
  }
  static Box share(Object* object) {
    auto box = adopt(object);
    box.retain();
    return box;
  }
  // A by-reference parameter's register (language rule 7.3): points to
  // the variable that it is bound to; lives no longer than that.
  static Box reference(Box* target) {
    return Box(reference_tag << 48 |
               (reinterpret_cast<std::uint64_t>(target) & payload_mask));
  }

  // An argument that the call leaves to the parameter's default; nothing that
  // a script ever sees.
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
  // Neither holds others nor is bound to one: may be put anywhere.
  bool is_simple() const {
    return bits_ < list_tag << 48 && !is_reference();
  }
  bool is_list() const {
    return bits_ >> 48 == list_tag;
  }
  bool is_map() const {
    return bits_ >> 48 == map_tag;
  }
  bool is(ObjectType type) const {
    return is_object() && object()->type == type;
  }

  double as_number() const {
    return std::bit_cast<double>(bits_);
  }
  std::int64_t as_small() const {
    return static_cast<std::int64_t>(bits_ - zero_bits);
  }
  Object* object() const {
    return reinterpret_cast<Object*>(bits_ & payload_mask);
  }
  Box* target() const {
    return reinterpret_cast<Box*>(bits_ & payload_mask);
  }
  // The value itself, where this may be a bound parameter.
  const Box& resolved() const {
    return is_reference() ? *target() : *this;
  }
  Box& resolved() {
    return is_reference() ? *target() : *this;
  }
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
  // Small integers count from the middle of their range, so that sums and
  // differences of the bits are those of the integers.
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
  void replace(std::uint64_t bits) {
    const auto old = bits_;
    bits_ = bits;
    release(old);
  }
  static void release(std::uint64_t bits) {
    if (bits < string_tag << 48) [[likely]]
      return;
    auto* object = reinterpret_cast<Object*>(bits & payload_mask);
    if (object->heap && --object->count == 0)
      destroy(object);
  }

  std::uint64_t bits_ = unknown_bits;
};

static_assert(sizeof(Box) == 8);

} // namespace parlour::script
