#include "adapters/mqtt/device_commands.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace parlour::adapters::mqtt {

namespace {

// Devices round what they are set to, at most to tenths.
constexpr double close_enough = 0.05;

// A script may set true, "On" or "ON": all are "on".
std::string word_for(const Value& value) {
  if (const auto* truth = value.if_boolean())
    return *truth ? "on" : "off";
  auto word = value.text();
  std::ranges::transform(word, word.begin(), [](unsigned char letter) {
    return static_cast<char>(std::tolower(letter));
  });
  return word;
}

tl::unexpected<Error> refused(const Spoken& spoken, const std::string& takes,
                              const Value& value) {
  return fail(ErrorKind::refused,
              subject(spoken) + " takes " + takes + ", not '" +
                  (value.is_unknown() ? "" : value.text()) + "'.");
}

Expected<DeviceCommand>
number_command(const Device& device, const Spoken& spoken, const Value& value) {
  const auto& numbers = *device.entity.numbers;
  auto from = numbers.from;
  auto to = numbers.to;
  for (const auto* listed : device.listed) {
    from = std::max(from, listed->from.value_or(from));
    to = std::min(to, listed->to.value_or(to));
  }
  const auto number = parse_number(value.text());
  const auto wanted = number.number_or(0);
  if (number.is_unknown() || wanted < from || wanted > to)
    return refused(spoken, number_text(from) + " to " + number_text(to), value);
  const auto text = number_text(wanted);
  return DeviceCommand{numbers.topic,
                       numbers.payload.apply(Payload(text)).value_or(text),
                       {number}};
}

std::string words_that_it_takes(const Entity& entity) {
  std::string words;
  for (const auto& order : entity.orders)
    words += (words.empty() ? "" : " or ") + order.word;
  return words;
}

} // namespace

Expected<DeviceCommand> command_for(const Device& device, const Spoken& spoken,
                                    const Value& value) {
  const auto& entity = device.entity;
  if (!entity.can_be_set())
    return fail(ErrorKind::refused,
                subject(spoken) + " cannot be set from here.");
  if (entity.numbers)
    return number_command(device, spoken, value);
  const auto found =
      std::ranges::find(entity.orders, word_for(value), &Order::word);
  if (found == entity.orders.end())
    return refused(spoken, words_that_it_takes(entity), value);
  return DeviceCommand{entity.command_topic,
                       found->payload,
                       {found->shown_by.begin(), found->shown_by.end()}};
}

// A heating that was set to 20.5 and says 20.50 has obeyed.
bool shows(const Value& state, const std::vector<Value>& wanted) {
  const auto is_number = [](const Value& value) {
    return value.if_integer() || value.if_number();
  };
  return std::ranges::any_of(wanted, [&](const Value& one) {
    return state == one ||
           (is_number(state) && is_number(one) &&
            std::abs(state.number_or(0) - one.number_or(0)) <= close_enough);
  });
}

std::string subject(const Spoken& spoken) {
  return "The " + spoken.device +
         (spoken.room.empty() ? "" : " in the " + spoken.room);
}

} // namespace parlour::adapters::mqtt
