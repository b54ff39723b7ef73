#include "runtime/text/json_text.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "runtime/base/result_rows.hpp"

namespace parlour {

namespace {

using Json = nlohmann::ordered_json;

// Makes values while the parser goes through the text. The library's own
// objects search their keys one by one, so a large one would take too long.
class ValueMaker : public nlohmann::json_sax<Json> {
public:
  bool null() override {
    return add(Value());
  }
  bool boolean(bool value) override {
    return add(value);
  }
  bool number_integer(number_integer_t value) override {
    return add(std::int64_t{value});
  }
  bool number_unsigned(number_unsigned_t value) override {
    if (value > std::uint64_t{INT64_MAX})
      return add(static_cast<double>(value));
    return add(static_cast<std::int64_t>(value));
  }
  bool number_float(number_float_t value, const string_t&) override {
    return add(value);
  }
  bool string(string_t& value) override {
    return add(Value(std::move(value)));
  }
  bool binary(binary_t&) override {
    return false; // JSON has none
  }
  bool start_object(std::size_t) override {
    return open(false);
  }
  bool key(string_t& value) override {
    open_.back().key = std::move(value);
    return true;
  }
  bool end_object() override {
    return close();
  }
  bool start_array(std::size_t) override {
    return open(true);
  }
  bool end_array() override {
    return close();
  }
  bool parse_error(std::size_t, const std::string&,
                   const nlohmann::detail::exception&) override {
    return false;
  }

  bool too_deep = false;
  Value result;

private:
  // A list or an object that has begun.
  struct Container {
    bool is_list = false;
    List list = {};
    Map map = {};
    std::string key = {};
  };

  bool open(bool is_list) {
    too_deep = open_.size() >= json_depth;
    if (!too_deep)
      open_.push_back({is_list});
    return !too_deep;
  }
  bool close() {
    auto done = std::move(open_.back());
    open_.pop_back();
    return add(done.is_list ? Value(std::move(done.list))
                            : Value(std::move(done.map)));
  }
  bool add(Value value) {
    if (open_.empty())
      result = std::move(value);
    else if (open_.back().is_list)
      open_.back().list.push_back(std::move(value));
    else
      open_.back().map.set(open_.back().key, std::move(value));
    return true;
  }

  std::vector<Container> open_;
};

void write(std::string& text, const Value& value);

void write_text(std::string& text, const std::string& value) {
  text += Json(value).dump(-1, ' ', false, Json::error_handler_t::replace);
}

void write_list(std::string& text, const List& list) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    text += i == 0 ? "" : ",";
    write(text, list[i]);
  }
}

void write_map(std::string& text, const Map& map) {
  bool is_first = true;
  for (const auto& [key, entry] : map.entries()) {
    text += std::exchange(is_first, false) ? "" : ",";
    write_text(text, key);
    text += ':';
    write(text, entry);
  }
}

void write(std::string& text, const Value& value) {
  switch (value.type()) {
  case ValueType::unknown:
  case ValueType::binary:
    text += "null";
    return;
  case ValueType::boolean:
    text += *value.if_boolean() ? "true" : "false";
    return;
  case ValueType::integer:
    text += Json(*value.if_integer()).dump();
    return;
  case ValueType::number:
    text += Json(*value.if_number()).dump();
    return;
  case ValueType::string:
    return write_text(text, *value.if_string());
  case ValueType::list:
    text += '[';
    write_list(text, *value.if_list());
    text += ']';
    return;
  case ValueType::map:
    text += '{';
    write_map(text, *value.if_map());
    text += '}';
    return;
  case ValueType::result:
    text += '[';
    write_list(text, rows_as_maps(*value.if_result()));
    text += ']';
    return;
  }
}

} // namespace

tl::expected<Value, JsonFault> read_json(std::string_view text) {
  ValueMaker maker;
  if (Json::sax_parse(text, &maker))
    return std::move(maker.result);
  return tl::make_unexpected(maker.too_deep ? JsonFault::too_deep
                                            : JsonFault::not_json);
}

std::string json_text(const Value& value) {
  std::string text;
  write(text, value);
  return text;
}

} // namespace parlour
