#include "adapters/mqtt/discovery/entity_kinds.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace parlour::adapters::mqtt {

namespace {

// What all kinds have in common.
// Where several sources tell whether it is there, the latest counts unless the
// message says otherwise.
Entity common(const std::string& id, const std::string& kind, Fields& fields) {
  Entity made;
  made.id = id;
  made.kind = kind;
  made.device_class = fields.text("device_class", "");
  made.name = fields.text("name", "");
  made.device = fields.device_text("name");
  made.area = fields.device_text("suggested_area");
  made.availability = fields.availability();
  const auto mode = fields.text("availability_mode", "latest");
  made.availability_mode = mode == "all"   ? AvailabilityMode::all
                           : mode == "any" ? AvailabilityMode::any
                                           : AvailabilityMode::latest;
  made.retains_commands = fields.truth("retain", false);
  return made;
}

// Where it tells its state and takes its commands.
void read_topics(Entity& made, Fields& fields) {
  made.state = fields.source("state_topic", "value_template");
  made.command_topic = fields.topic("command_topic");
  made.is_optimistic = fields.truth("optimistic", made.state.topic.empty());
}

// `name`: the field that may give another payload for the word.
void add_word(Entity& made, const Fields& fields, const std::string& name,
              const std::string& payload, const std::string& word) {
  made.words.emplace(fields.text(name, payload), word);
}

// The word itself is always among the states that show it.
void add_order(Entity& made, const std::string& word,
               const std::string& payload,
               std::vector<std::string> shown_by = {}) {
  shown_by.insert(shown_by.begin(), word);
  made.orders.push_back({word, payload, std::move(shown_by)});
}

// A command in the form that the device wants.
std::string dressed(const ValueTemplate& command, const std::string& payload) {
  return command.apply(Payload(payload)).value_or(payload);
}

// What it is sent and what it says may be different words: state_on is
// payload_on unless the message says otherwise.
void read_switch(Entity& made, Fields& fields) {
  read_topics(made, fields);
  const auto on = fields.text("payload_on", "ON");
  const auto off = fields.text("payload_off", "OFF");
  add_word(made, fields, "state_on", on, "on");
  add_word(made, fields, "state_off", off, "off");
  const auto command = fields.value_template("command_template");
  add_order(made, "on", dressed(command, on));
  add_order(made, "off", dressed(command, off));
}

// Lights have three forms. A template light builds its commands with
// conditions, which are not read.
void read_light(Entity& made, Fields& fields) {
  const auto schema = fields.text("schema", "basic");
  if (schema == "template" ||
      fields.text("on_command_type", "last") == "brightness")
    fields.note("a light that is switched by a template or by its brightness "
                "is not supported");
  read_switch(made, fields);
  if (schema != "json") {
    if (fields.find("state_value_template"))
      made.state.value = fields.value_template("state_value_template");
    return;
  }
  made.state.value = *ValueTemplate::parse("{{ value_json.state }}");
  made.words = {{"ON", "on"}, {"OFF", "off"}};
  made.orders.clear();
  add_order(made, "on", R"({"state":"ON"})");
  add_order(made, "off", R"({"state":"OFF"})");
}

// To be open is to be unlocked; a lock that can also draw its latch does that
// for "open".
void read_lock(Entity& made, Fields& fields) {
  read_topics(made, fields);
  made.is_lock = true;
  add_word(made, fields, "state_locked", "LOCKED", "closed");
  add_word(made, fields, "state_unlocked", "UNLOCKED", "open");
  add_word(made, fields, "state_open", "OPEN", "open");
  add_word(made, fields, "state_locking", "LOCKING", "closing");
  add_word(made, fields, "state_unlocking", "UNLOCKING", "opening");
  add_word(made, fields, "state_opening", "OPENING", "opening");
  add_word(made, fields, "state_jammed", "JAMMED", "jammed");
  if (fields.text("code_format"))
    return; // it wants a code, which nobody here has
  const auto command = fields.value_template("command_template");
  const auto lock = dressed(command, fields.text("payload_lock", "LOCK"));
  const auto unlock = dressed(command, fields.text("payload_unlock", "UNLOCK"));
  const auto latch = fields.text("payload_open");
  add_order(made, "open", latch ? dressed(command, *latch) : unlock);
  add_order(made, "closed", lock);
  add_order(made, "unlocked", unlock, {"open"});
  add_order(made, "locked", lock, {"closed"});
}

// A cover without a state topic may tell its position instead.
void read_cover(Entity& made, Fields& fields) {
  read_topics(made, fields);
  add_word(made, fields, "state_open", "open", "open");
  add_word(made, fields, "state_opening", "opening", "opening");
  add_word(made, fields, "state_closed", "closed", "closed");
  add_word(made, fields, "state_closing", "closing", "closing");
  add_word(made, fields, "state_stopped", "stopped", "stopped");
  if (made.state.topic.empty()) {
    made.state = fields.source("position_topic", "position_template");
    made.meaning = Meaning::position;
    made.closed = fields.number("position_closed", 0);
    made.open = fields.number("position_open", 100);
    made.is_optimistic = fields.truth("optimistic", made.state.topic.empty());
  }
  add_order(made, "open", fields.text("payload_open", "OPEN"), {"opening"});
  add_order(made, "closed", fields.text("payload_close", "CLOSE"), {"closing"});
}

// Its value is the temperature that it was set to; 7 and 35 are Home
// Assistant's bounds where the device says none.
void read_climate(Entity& made, Fields& fields) {
  made.meaning = Meaning::number;
  made.state =
      fields.source("temperature_state_topic", "temperature_state_template");
  made.is_optimistic = fields.truth("optimistic", made.state.topic.empty());
  if (auto topic = fields.topic("temperature_command_topic"); !topic.empty())
    made.numbers = {
        std::move(topic), fields.value_template("temperature_command_template"),
        fields.number("min_temp", 7), fields.number("max_temp", 35)};
}

void read_sensor(Entity& made, Fields& fields) {
  read_topics(made, fields);
  made.command_topic.clear();
  made.meaning = Meaning::number;
  if (const auto seconds = fields.number("expire_after", 0); seconds > 0)
    made.expires_after =
        Milliseconds(static_cast<std::int64_t>(std::min(seconds, 1e7) * 1000));
}

// What opens tells so; everything else is on or off.
void read_binary_sensor(Entity& made, Fields& fields) {
  read_sensor(made, fields);
  made.meaning = Meaning::word;
  constexpr const char* what_opens[] = {"door", "garage_door", "lock",
                                        "opening", "window"};
  const bool opens =
      std::ranges::find(what_opens, made.device_class) != std::end(what_opens);
  add_word(made, fields, "payload_on", "ON", opens ? "open" : "on");
  add_word(made, fields, "payload_off", "OFF", opens ? "closed" : "off");
  made.repeats = fields.number("off_delay", 0) > 0;
}

// A button: each message tells that something has happened.
void read_event(Entity& made, Fields& fields) {
  read_sensor(made, fields);
  made.repeats = true;
  if (!fields.find("value_template"))
    made.state.value = *ValueTemplate::parse("{{ value_json.event_type }}");
}

using Reader = std::function<void(Entity&, Fields&)>;

const std::map<std::string, Reader>& readers() {
  static const std::map<std::string, Reader> all = {
      {"light", read_light},
      {"switch", read_switch},
      {"lock", read_lock},
      {"cover", read_cover},
      {"climate", read_climate},
      {"sensor", read_sensor},
      {"binary_sensor", read_binary_sensor},
      {"event", read_event}};
  return all;
}

// What a heating measures is a thermometer of its own.
// It shares the heating's device, area and availability.
std::optional<Entity> thermometer_of(const Entity& climate, Fields& fields) {
  auto source = fields.source("current_temperature_topic",
                              "current_temperature_template");
  if (source.topic.empty())
    return {};
  Entity made = climate;
  made.id += "#temperature";
  made.kind = "sensor";
  made.device_class = "temperature";
  made.state = std::move(source);
  made.numbers.reset();
  return made;
}

} // namespace

bool is_known_kind(const std::string& kind) {
  return readers().contains(kind);
}

// A switch without a command topic only tells; what neither tells nor obeys is
// a mistake.
std::vector<Entity> entities_of(const std::string& id, const std::string& kind,
                                Fields& fields) {
  auto made = common(id, kind, fields);
  readers().at(kind)(made, fields);
  if (made.command_topic.empty())
    made.orders.clear();
  std::vector<Entity> all;
  if (kind == "climate")
    if (auto thermometer = thermometer_of(made, fields))
      all.push_back(std::move(*thermometer));
  if (made.can_be_set() || !made.state.topic.empty())
    all.push_back(std::move(made));
  if (all.empty())
    fields.note("it has neither a state_topic nor a command_topic");
  return all;
}

} // namespace parlour::adapters::mqtt
