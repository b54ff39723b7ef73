// Conversion in both directions. Outwards it is limited by a budget, inwards by
// the heap's limit, which the interpreter checks afterwards.

#include "script/values/convert.hpp"

#include <algorithm>

namespace parlour::script {

namespace {

constexpr int deepest = 1000;

// Copies inwards. The heap's limit is not checked here; the machine does so
// afterwards.
class Importer {
public:
  // `constants` may be null.
  Importer(Heap& heap, const ConstantPool* constants)
      : heap_(heap), constants_(constants) {}

  // One value, and all below it.
  Box take(const Value& value) const {
    switch (value.type()) {
    case ValueType::unknown:
      return {};
    case ValueType::boolean:
      return Box::boolean(*value.if_boolean());
    case ValueType::integer:
      return make_integer(heap_, *value.if_integer());
    case ValueType::number:
      return Box::number(*value.if_number());
    case ValueType::string:
      return string(*value.if_string());
    case ValueType::list:
      return list(*value.if_list());
    case ValueType::map:
      return map(*value.if_map());
    case ValueType::result:
    case ValueType::binary:
      return make_foreign(heap_, value);
    }
    return {};
  }

private:
  Box string(std::string_view text) const {
    if (constants_)
      if (auto constant = constants_->find(text))
        return *std::move(constant);
    return make_string(heap_, text);
  }

  Box list(const List& values) const {
    auto box = make_list(heap_, values.size());
    for (const auto& value : values)
      box.list()->elements.push_back(take(value));
    return box;
  }

  Box map(const Map& map) const {
    MapObject::Entries entries{HeapAllocator<MapObject::Entry>(&heap_)};
    entries.reserve(map.size());
    for (const auto& [key, value] : map.entries())
      entries.push_back({string(key), take(value)});
    return make_map(heap_, std::move(entries));
  }

  Heap& heap_;
  const ConstantPool* constants_;
};

// Copies outwards. A small structure that shares parts can have an
// exponentially large copy (each level holding the previous one twice), hence
// the budget.
class Copier {
public:
  explicit Copier(WalkBudget& budget) : budget_(budget) {}

  // One value, and all below it.
  Value copy(const Box& box, int depth) {
    if (depth > deepest)
      budget_.exhaust();
    if (!budget_.values() || box.is_unknown())
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

  Value string(std::string_view text) {
    return budget_.bytes(text.size()) ? Value(text) : Value();
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
      if (budget_.bytes(entry.key.string()->size))
        copied.set(entry.key.text(), copy(entry.value, depth + 1));
    return copied;
  }

  // Outside of scripts an error is a map with the same fields.
  Value error(const ErrorObject& error, int depth) {
    return Map{{"message", error.message},
               {"kind", name_of(error.kind)},
               {"file", error.place.file},
               {"line", static_cast<std::int64_t>(error.place.line)},
               {"value", copy(error.value, depth + 1)}};
  }

  WalkBudget& budget_;
};

// Computes the cost of the copy without making it. It must agree with Copier.
class SizeMeter {
public:
  explicit SizeMeter(WalkBudget& budget) : budget_(budget) {}

  // Whether the budget suffices for the value and all below it.
  bool holds(const Box& given, int depth) {
    const auto& box = given.resolved();
    if (depth > deepest)
      budget_.exhaust();
    if (!budget_.values())
      return false;
    if (!box.is_object())
      return true;
    switch (box.object()->type) {
    case ObjectType::string:
      return budget_.bytes(box.text().size());
    case ObjectType::list:
      return std::all_of(
          box.list()->elements.begin(), box.list()->elements.end(),
          [&](const Box& element) { return holds(element, depth + 1); });
    case ObjectType::map:
      return std::all_of(box.map()->entries.begin(), box.map()->entries.end(),
                         [&](const auto& entry) {
                           return budget_.bytes(entry.key.string()->size) &&
                                  holds(entry.value, depth + 1);
                         });
    case ObjectType::error:
      return holds(box.error()->value, depth + 1);
    default:
      return true;
    }
  }

private:
  WalkBudget& budget_;
};

} // namespace

Box to_box(Heap& heap, const Value& value) {
  return Importer(heap, nullptr).take(value);
}

Box to_box(Heap& heap, const Value& value, const ConstantPool& constants) {
  return Importer(heap, &constants).take(value);
}

Value to_value(const Box& box, WalkBudget& budget) {
  return Copier(budget).copy(box, 0);
}

Value to_value(const Box& box) {
  WalkBudget ample(std::size_t{1} << 25);
  return to_value(box, ample);
}

void measure(const Box& box, WalkBudget& budget) {
  SizeMeter(budget).holds(box, 0);
}

Error to_error(const ErrorObject& error) {
  return {error.kind, error.message, error.place};
}

} // namespace parlour::script
