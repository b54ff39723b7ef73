// Value: a message's parameter, a slot's value or a cell of a query's result
// (language rule 2). Immutable and cheap to copy: contents of variable size are
// shared by reference counts. Safe to share between threads. The interpreter
// works on mutable values of its own (script/values) and converts at its
// border, so no two actors ever share anything that changes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace parlour {

class Value;

using List = std::vector<Value>;

// A map with string keys in insertion order (language rule 2.10). Small maps
// are searched linearly, larger ones by a hash index, which only set() and
// erase() change. Concurrent readers are therefore safe.
class Map {
public:
  using Entry = std::pair<std::string, Value>;

  Map() = default;
  Map(std::initializer_list<Entry> entries);

  // Returns null for a missing key. The pointer is valid until the map changes.
  const Value* find(std::string_view key) const;

  // A key that exists keeps its position.
  void set(std::string_view key, Value value);
  void erase(std::string_view key);

  // In insertion order.
  const std::vector<Entry>& entries() const {
    return entries_;
  }
  std::size_t size() const;
  bool empty() const;
  bool operator==(const Map& other) const; // by content, order aside

private:
  std::size_t position(std::string_view key) const; // or size()
  void index(std::size_t position);
  void rebuild_index();

  std::vector<Entry> entries_;
  // Open addressing with linear probing: position plus one by the key's hash, 0
  // for a free place. At most half of the places are used, so probing ends.
  std::vector<std::uint32_t> index_;
};

// The names of a result's columns. Immutable, and shared by all results of a
// statement, so a copy takes no memory.
class Columns {
public:
  using value_type = std::string;
  using const_iterator = std::vector<std::string>::const_iterator;
  using iterator = const_iterator;

  Columns() = default;
  Columns(std::vector<std::string> names);
  Columns(std::initializer_list<std::string> names);

  std::size_t size() const {
    return names().size();
  }
  bool empty() const {
    return !names_;
  }
  const std::string& operator[](std::size_t position) const {
    return names()[position];
  }
  const_iterator begin() const {
    return names().begin();
  }
  const_iterator end() const {
    return names().end();
  }
  bool operator==(const Columns& other) const;

private:
  const std::vector<std::string>& names() const {
    return names_ ? *names_ : none();
  }
  static const std::vector<std::string>& none();

  std::shared_ptr<const std::vector<std::string>> names_; // null: none
};

// The rows that a query returned. The cells lie row by row in one list.
struct ResultSet {
  Columns columns;
  List cells;

  std::size_t row_count() const;
  // Returns null if there is no such cell. Column names ignore case. Takes time
  // linear in the number of columns.
  const Value* cell(std::size_t row, std::string_view column) const;
  bool operator==(const ResultSet& other) const;
};

// Audio and other opaque bytes. A script passes them on but cannot look inside.
struct Binary {
  std::string format; // such as "pcm_s16le;rate=16000;channels=1"
  std::vector<std::byte> bytes;

  bool operator==(const Binary&) const = default;
};

// In the order of the alternatives of Value's variant.
enum class ValueType : std::uint8_t {
  unknown,
  boolean,
  integer,
  number,
  string,
  list,
  map,
  result,
  binary,
};

// The name that the built-in type(x) returns: "unknown", "boolean" ….
std::string_view name_of(ValueType type);

class Value {
public:
  Value() = default; // unknown
  Value(bool value) : data_(value) {}
  Value(int value) : data_(std::int64_t{value}) {}
  Value(std::int64_t value) : data_(value) {}
  Value(double value) : data_(value) {}
  Value(std::string value);
  Value(std::string_view value);
  Value(const char* value) : Value(std::string_view(value)) {}
  // Shares a text that exists already.
  explicit Value(std::shared_ptr<const std::string> text)
      : data_(std::move(text)) {}
  Value(List value);
  Value(Map value);
  Value(ResultSet value);
  Value(Binary value);

  ValueType type() const {
    return static_cast<ValueType>(data_.index());
  }
  bool is_unknown() const {
    return type() == ValueType::unknown;
  }

  // Each returns null if the value is of another type. The pointer is valid as
  // long as the value.
  const bool* if_boolean() const {
    return std::get_if<bool>(&data_);
  }
  const std::int64_t* if_integer() const {
    return std::get_if<std::int64_t>(&data_);
  }
  const double* if_number() const {
    return std::get_if<double>(&data_);
  }
  const std::string* if_string() const {
    return shared<std::string>();
  }
  const List* if_list() const {
    return shared<List>();
  }
  const Map* if_map() const {
    return shared<Map>();
  }
  const ResultSet* if_result() const {
    return shared<ResultSet>();
  }
  const Binary* if_binary() const {
    return shared<Binary>();
  }

  // Lenient access for code that reads messages and frames.
  //
  // A map's entry, or unknown for a missing key or another type.
  const Value& operator[](std::string_view key) const;
  // A list's element, or unknown beyond its end or for another type.
  const Value& at(std::size_t position) const;
  // A string as it is; any other value as it would be printed.
  std::string text() const;
  // An integer or number as a double; `otherwise` for any other type.
  double number_or(double otherwise) const;
  // The same, with a fraction cut off.
  std::int64_t integer_or(std::int64_t otherwise) const;

  // Truth (language rule 2.3): false, unknown, 0 and everything empty are
  // false.
  explicit operator bool() const;

  // Equality of language rule 3.5: a string equals the number that it is
  // written like.
  bool operator==(const Value& other) const;

private:
  template <class T>
  const T* shared() const {
    const auto* pointer = std::get_if<std::shared_ptr<const T>>(&data_);
    return pointer ? pointer->get() : nullptr;
  }

  std::variant<std::monostate, bool, std::int64_t, double,
               std::shared_ptr<const std::string>, std::shared_ptr<const List>,
               std::shared_ptr<const Map>, std::shared_ptr<const ResultSet>,
               std::shared_ptr<const Binary>>
      data_;
};

// The value as <print> shows it (language rule 2.2).
std::string to_string(const Value& value);

// The shortest text that reads back as this number; "2" for 2.0. It must be
// finite.
std::string number_text(double number);

// The number that a text is written like (language rule 3.5); unknown if the
// text has no such form. Blanks around it are ignored.
Value parse_number(std::string_view text);

} // namespace parlour
