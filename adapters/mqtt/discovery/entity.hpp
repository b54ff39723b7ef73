// Entity is one thing that a device measures or switches, in the form that is
// the same for all kinds of things: where it tells its state and what its
// payloads mean, and which payloads switch it. discovery.hpp makes it from what
// a device announces.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "adapters/mqtt/discovery/value_template.hpp"
#include "runtime/base/clock.hpp"
#include "runtime/base/value.hpp"

namespace parlour::adapters::mqtt {

// Where something is read.
struct Source {
  std::string topic; // empty: it is not told at all
  ValueTemplate value;
};

// How the text that the template makes becomes a value.
enum class Meaning : std::uint8_t {
  word,     // one of Entity::words
  number,   // a number, or a text that is none
  position, // a number between `closed` and `open`, which becomes that word
};

// One word that an application may set.
// Such as "on", with what is published for it.
struct Order {
  std::string word;
  std::string payload;
  // The states that show that it is carried out: a blind that opens has obeyed.
  std::vector<std::string> shown_by;
};

// Numbers that an application may set.
// The payload is a template over the number.
struct NumberOrder {
  std::string topic;
  ValueTemplate payload;
  double from = 0;
  double to = 0;
};

struct AvailabilitySource {
  Source source;
  std::string available;
  std::string unavailable;

  enum class State : std::uint8_t { unknown, available, unavailable };
};

// Which of several sources count.
enum class AvailabilityMode : std::uint8_t { latest, all, any };

struct Entity {
  // The discovery topic, and the part of the message if there are several.
  std::string id;
  // As Home Assistant calls it: "light", "binary_sensor".
  std::string kind;
  std::string device_class;
  std::string name;
  std::string device;
  std::string area;

  Source state;
  Meaning meaning = Meaning::word;
  std::map<std::string, std::string> words; // by payload
  double closed = 0;
  double open = 100;
  // The state counts no longer than this.
  std::optional<Milliseconds> expires_after;
  // Each message is news, although it says the same as the last one.
  bool repeats = false;

  std::string command_topic; // empty: it cannot be switched
  std::vector<Order> orders;
  std::optional<NumberOrder> numbers;
  bool retains_commands = false;
  // It does not tell whether it has obeyed.
  bool is_optimistic = false;
  // It must not be obeyed by guess: several in one room are not switched
  // together, and a state that was told before counts for nothing.
  bool is_lock = false;

  std::vector<AvailabilitySource> availability;
  AvailabilityMode availability_mode = AvailabilityMode::latest;

  // Whether an application can change it.
  bool can_be_set() const {
    return !orders.empty() || numbers.has_value();
  }
};

// The value that a text of the state topic means; unknown for "None", nothing
// if the entity has no such state.
std::optional<Value> meaning_of(const Entity& entity, const std::string& text);

} // namespace parlour::adapters::mqtt
