#include "script/dialogue/acts/acts.hpp"

#include <optional>
#include <utility>

#include "runtime/message/understanding.hpp"

namespace parlour::dialogue {

namespace {

// Reads one frame list. All problems are collected, as one act that is wrong
// must not hide another.
class Parser {
public:
  ParsedActs parse(const Value& frames) {
    add(frames, 0);
    return std::move(parsed_);
  }

private:
  void problem(std::string sentence) {
    parsed_.problems.push_back(std::move(sentence));
  }

  void wrong_type(std::string_view what, const Value& value) {
    problem("an act's " + std::string(what) + " cannot be of type " +
            std::string(parlour::name_of(value.type())));
  }

  // A list of maps, one map, or what <getlist> makes of FrameInfo: a list with
  // the list in it. Deeper lists are none: `depth` ends the recursion.
  void add(const Value& frames, int depth) {
    if (const auto* list = frames.if_list(); list && depth < 2) {
      for (const auto& entry : *list)
        add(entry, depth + 1);
      return;
    }
    if (!frames.if_map()) {
      problem("a frame list holds maps, not values of type " +
              std::string(parlour::name_of(frames.type())));
      return;
    }
    if (auto parsed = act(frames, parsed_.acts.empty()))
      parsed_.acts.push_back(std::move(*parsed));
  }

  // Alternatives are other readings of the utterance as a whole, so only its
  // first act has them, and they have none themselves.
  std::optional<Act> act(const Value& frame, bool with_alternatives) {
    Act result;
    auto kind = this->kind(frame[act_key::act]);
    if (!kind)
      return std::nullopt;
    result.kind = *kind;
    const auto& topic = frame[act_key::topic];
    result.topic = string(frame, act_key::topic);
    if (!topic.is_unknown() && !topic.if_string()) // it may not be any other's
      return std::nullopt;
    result.text = string(frame, act_key::text);
    result.confidence = confidence(frame[act_key::confidence]);
    result.elliptical = flag(frame, act_key::elliptical);
    slots(frame[act_key::slots], result.slots);
    if (with_alternatives)
      alternatives(frame[act_key::alternatives], result.alternatives);
    return result;
  }

  std::optional<ActKind> kind(const Value& name) {
    if (name.is_unknown())
      return ActKind::inform;
    if (!name.if_string()) {
      wrong_type(act_key::act, name);
      return std::nullopt;
    }
    auto kind = act_kind(*name.if_string());
    if (!kind)
      problem("there is no act named '" + *name.if_string() + "'");
    return kind;
  }

  std::string string(const Value& map, const char* key) {
    const auto& value = map[key];
    if (!value.is_unknown() && !value.if_string())
      wrong_type(key, value);
    return value.if_string() ? *value.if_string() : std::string();
  }

  bool flag(const Value& map, const char* key) {
    const auto& value = map[key];
    if (!value.is_unknown() && !value.if_boolean())
      wrong_type(key, value);
    return value.if_boolean() && *value.if_boolean();
  }

  Value confidence(const Value& value) {
    if (value.is_unknown())
      return value;
    if (!value.if_integer() && !value.if_number()) {
      wrong_type(act_key::confidence, value);
      return {};
    }
    auto number = value.number_or(0);
    if (number >= 0 && number <= 1)
      return number;
    problem("a confidence lies between 0 and 1, not at " + to_string(value));
    return {};
  }

  // `items` are several values of one slot: a SlotValue each, in their order.
  void slots(const Value& map, std::vector<SlotValue>& slots) {
    if (map.is_unknown())
      return;
    if (!map.if_map()) {
      wrong_type(act_key::slots, map);
      return;
    }
    for (const auto& [name, value] : map.if_map()->entries())
      if (const auto* items = value[act_key::items].if_list())
        for (const auto& item : *items)
          add_slot(name, item, slots);
      else
        add_slot(name, value, slots);
  }

  void add_slot(const std::string& name, const Value& value,
                std::vector<SlotValue>& slots) {
    if (auto parsed = slot(name, value))
      slots.push_back(std::move(*parsed));
  }

  // Words alone are enough: the slot's cardinality may still make a value of
  // them.
  std::optional<SlotValue> slot(const std::string& name, const Value& given) {
    SlotValue slot;
    slot.slot = name;
    if (given.if_map())
      described(given, slot);
    else
      slot.value = given;
    check_value(slot);
    if (slot.value.is_unknown() && slot.candidates.empty() &&
        slot.text.empty()) {
      problem("slot '" + name + "' of an act has no value");
      return std::nullopt;
    }
    return slot;
  }

  // A value with what is known about it. A wrong entry is left out by itself,
  // the rest counts.
  void described(const Value& given, SlotValue& slot) {
    slot.value = given[act_key::value];
    slot.confidence = confidence(given[act_key::confidence]);
    slot.text = string(given, act_key::text);
    slot.unmatched = flag(given, act_key::unmatched);
    slot.more = flag(given, act_key::more);
    slot.heard = flag(given, act_key::heard);
    if (const auto& amount = given[act_key::amount];
        amount.if_integer() || amount.if_number())
      slot.amount = amount;
    else if (!amount.is_unknown())
      wrong_type(act_key::amount, amount);
    const auto& candidates = given[act_key::candidates];
    if (candidates.if_list())
      slot.candidates = *candidates.if_list();
    else if (!candidates.is_unknown())
      wrong_type(act_key::candidates, candidates);
  }

  // Rows of a database and bytes are no value that anybody can have said.
  void check_value(SlotValue& slot) {
    auto type = slot.value.type();
    if (type != ValueType::result && type != ValueType::binary)
      return;
    wrong_type(act_key::value, slot.value);
    slot.value = {};
  }

  void alternatives(const Value& list, std::vector<Act>& acts) {
    if (list.is_unknown())
      return;
    if (!list.if_list()) {
      wrong_type(act_key::alternatives, list);
      return;
    }
    for (const auto& entry : *list.if_list())
      if (!entry.if_map())
        wrong_type(act_key::alternatives, entry);
      else if (auto parsed = act(entry, false))
        acts.push_back(std::move(*parsed));
  }

  ParsedActs parsed_;
};

// A value of which nothing else is known stands for itself: 'Time': '10:30'. A
// value that is a map must be described, or its keys would be taken for a
// description.
Value to_value(const SlotValue& slot) {
  const bool plain = slot.confidence.is_unknown() && slot.text.empty() &&
                     slot.candidates.empty() && !slot.unmatched &&
                     slot.amount.is_unknown() && !slot.more &&
                     !slot.value.if_map();
  if (plain)
    return slot.value;
  Map map{{act_key::value, slot.value}};
  map.set(act_key::confidence, slot.confidence);
  map.set(act_key::text, slot.text);
  if (!slot.candidates.empty())
    map.set(act_key::candidates, slot.candidates);
  if (slot.unmatched)
    map.set(act_key::unmatched, true);
  if (!slot.amount.is_unknown())
    map.set(act_key::amount, slot.amount);
  if (slot.more)
    map.set(act_key::more, true);
  if (slot.heard)
    map.set(act_key::heard, true);
  return map;
}

// Several values of one slot are its items.
Value to_value(const std::vector<SlotValue>& said) {
  Map slots;
  for (const auto& slot : said) {
    const auto* known = slots.find(slot.slot);
    if (!known) {
      slots.set(slot.slot, to_value(slot));
      continue;
    }
    const auto* items = (*known)[act_key::items].if_list();
    auto all = items ? *items : List{*known};
    all.push_back(to_value(slot));
    slots.set(slot.slot, Map{{act_key::items, std::move(all)}});
  }
  return slots;
}

} // namespace

bool names_slot(const Act& act) {
  return act.kind == ActKind::correct && act.slots.size() == 1 &&
         act.slots[0].unmatched && act.slots[0].value.is_unknown() &&
         act.slots[0].candidates.empty();
}

bool is_generic(const Act& act) {
  switch (act.kind) {
  case ActKind::inform:
  case ActKind::request:
  case ActKind::correct:
  case ActKind::confirm:
  case ActKind::deny: // of a slot, or to no question: not understood
    return false;
  case ActKind::cancel: // "cancel the table for Monday" begins no booking
  case ActKind::abandon:
    return true;
  default:
    return act.slots.empty();
  }
}

ParsedActs parse_acts(const Value& frames) {
  return Parser().parse(frames);
}

Value to_value(const Act& act) {
  Map map;
  map.set(act_key::topic, act.topic.empty() ? Value() : Value(act.topic));
  map.set(act_key::act, name_of(act.kind));
  map.set(act_key::confidence, act.confidence);
  map.set(act_key::slots, to_value(act.slots));
  map.set(act_key::text, act.text);
  map.set(act_key::elliptical, act.elliptical);
  List alternatives;
  for (const auto& alternative : act.alternatives)
    alternatives.push_back(to_value(alternative));
  if (!alternatives.empty())
    map.set(act_key::alternatives, std::move(alternatives));
  return map;
}

} // namespace parlour::dialogue
