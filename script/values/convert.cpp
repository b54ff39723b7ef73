#include "script/values/convert.hpp"

#include <algorithm>

namespace parlour::script {

namespace {

constexpr int deepest = 1000;

Box list_of(Heap& heap, const List& values) {
  auto box = make_list(heap, values.size());
  for (const auto& value : values)
    box.list()->elements.push_back(to_box(heap, value));
  return box;
}

Box map_of(Heap& heap, const Map& map) {
  auto box = make_map(heap);
  for (const auto& [key, value] : map.entries())
    box.map()->set(make_string(heap, key), to_box(heap, value));
  return box;
}

// Copies outwards; a structure may be shared inside so that its copy is far
// larger than itself, hence the budget.
class Copier {
public:
  explicit Copier(std::size_t budget) : left_(budget) {}

  Value copy(const Box& box, int depth) {
    if (left_ == 0 || depth > deepest) {
      truncated = true;
      return {};
    }
    --left_;
    if (box.is_unknown())
      return {};
    if (box.is_boolean())
      return box.is_true();
    if (box.is_number())
      return box.as_number();
    if (box.is_small())
      return box.as_small();
    if (box.is_reference())
      return copy(*box.target(), depth);
    return object(box, depth);
  }

  bool truncated = false;

private:
  Value object(const Box& box, int depth) {
    switch (box.object()->type) {
    case ObjectType::string:
      return string(box.text());
    case ObjectType::list:
      return list(*box.list(), depth);
    case ObjectType::map:
      return map(*box.map(), depth);
    case ObjectType::result:
    case ObjectType::binary:
      return box.result()->value;
    case ObjectType::integer:
      return box.as_integer();
    case ObjectType::error:
      return error(*box.error(), depth);
    }
    return {};
  }

  // A long text counts for as many values as would take its memory.
  Value string(std::string_view text) {
    const auto cost = text.size() / sizeof(Value);
    truncated |= cost > left_;
    left_ -= std::min(left_, cost);
    return truncated ? Value() : Value(text);
  }

  Value list(const ListObject& list, int depth) {
    List copied;
    copied.reserve(list.elements.size());
    for (const auto& element : list.elements)
      copied.push_back(copy(element, depth + 1));
    return copied;
  }

  Value map(const MapObject& map, int depth) {
    Map copied;
    for (const auto& entry : map.entries)
      copied.set(entry.key.text(), copy(entry.value, depth + 1));
    return copied;
  }

  Value error(const ErrorObject& error, int depth) {
    return Map{{"message", error.message},
               {"kind", name_of(error.kind)},
               {"file", error.place.file},
               {"line", static_cast<std::int64_t>(error.place.line)},
               {"value", copy(error.value, depth + 1)}};
  }

  std::size_t left_;
};

// The same walk without the copy: false where it would be truncated.
class Scales {
public:
  explicit Scales(std::size_t& left) : left_(left) {}

  bool holds(const Box& given, int depth) {
    const auto& box = given.resolved();
    if (left_ == 0 || depth > deepest)
      return false;
    --left_;
    if (!box.is_object())
      return true;
    switch (box.object()->type) {
    case ObjectType::string:
      return take(box.text().size() / sizeof(Value));
    case ObjectType::list:
      return std::all_of(
          box.list()->elements.begin(), box.list()->elements.end(),
          [&](const Box& element) { return holds(element, depth + 1); });
    case ObjectType::map:
      return std::all_of(
          box.map()->entries.begin(), box.map()->entries.end(),
          [&](const auto& entry) { return holds(entry.value, depth + 1); });
    case ObjectType::error:
      return holds(box.error()->value, depth + 1);
    default:
      return true;
    }
  }

private:
  bool take(std::size_t cost) {
    if (cost > left_)
      return false;
    left_ -= cost;
    return true;
  }

  std::size_t& left_;
};

} // namespace

Box to_box(Heap& heap, const Value& value) {
  switch (value.type()) {
  case ValueType::unknown:
    return {};
  case ValueType::boolean:
    return Box::boolean(*value.if_boolean());
  case ValueType::integer:
    return make_integer(heap, *value.if_integer());
  case ValueType::number:
    return Box::number(*value.if_number());
  case ValueType::string:
    return make_string(heap, *value.if_string());
  case ValueType::list:
    return list_of(heap, *value.if_list());
  case ValueType::map:
    return map_of(heap, *value.if_map());
  case ValueType::result:
  case ValueType::binary:
    return make_foreign(heap, value);
  }
  return {};
}

Value to_value(const Box& box, std::size_t budget, bool* truncated) {
  Copier copier(budget);
  auto value = copier.copy(box, 0);
  if (truncated)
    *truncated = copier.truncated;
  return value;
}

void weigh(const Box& box, std::size_t& budget) {
  if (!Scales(budget).holds(box, 0))
    budget = 0;
}

Error to_error(const ErrorObject& error) {
  return {error.kind, error.message, error.place};
}

} // namespace parlour::script
