// Value: what a message parameter, a frame's slot or a query's cell is
// (language rule 2). Immutable and cheap to copy; safe to share between
// threads. The interpreter works on its own mutable values and copies at this
// border, so that no two actors ever share something that changes.
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

// String keys in insertion order; found by looking, or in a large map by an
// index, which only the changing functions touch.
class Map {
public:
  using Entry = std::pair<std::string, Value>;

  Map() = default;
  Map(std::initializer_list<Entry> entries);

  // Null where the key is missing.
  const Value* find(std::string_view key) const;

  // Setting a key that is there keeps its place.
  void set(std::string_view key, Value value);
  void erase(std::string_view key);

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
  // Positions plus one by the keys' hashes, at most half full; 0 is free.
  std::vector<std::uint32_t> index_;
};

// The names of a result's columns. Immutable, so that all results of a
// statement share them: a copy takes no memory.
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

// What a query returns; cells row by row.
struct ResultSet {
  Columns columns;
  List cells;

  std::size_t row_count() const;
  // Null where there is no such cell; column names regardless of case.
  const Value* cell(std::size_t row, std::string_view column) const;
  bool operator==(const ResultSet& other) const;
};

// Audio and other payloads; never copied into a script.
struct Binary {
  std::string format; // such as "pcm_s16le;rate=16000;channels=1"
  std::vector<std::byte> bytes;

  bool operator==(const Binary&) const = default;
};

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

// "unknown", "boolean" … as the built-in type(x) says it.
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
  // A text that others share, or that is part of something larger.
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

  // Null where the value is of another type.
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

  // Conveniences for readers of messages and frames.
  // A map's entry, or unknown for a missing key or another type.
  const Value& operator[](std::string_view key) const;
  // A list's element, or unknown past its end or for another type.
  const Value& at(std::size_t position) const;
  // The text of a string, else what would be printed.
  std::string text() const;
  // An integer or number as a double; `otherwise` for other types.
  double number_or(double otherwise) const;
  std::int64_t integer_or(std::int64_t otherwise) const;

  // Truth (language rule 2.3): false, unknown, 0, '' and empty are false.
  explicit operator bool() const;

  // Equality of language rule 3.5 (a string equals the number that it is
  // written like).
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

// As <print> shows it (language rule 2.2).
std::string to_string(const Value& value);

// The shortest text that reads back as this number; "2" for 2.0.
std::string number_text(double number);

// The number that a string is written like (language rule 3.5); unknown where
// it is like none.
Value parse_number(std::string_view text);

} // namespace parlour
