#include "adapters/standins/log_robot.hpp"

#include <algorithm>
#include <utility>

namespace parlour::adapters {

namespace {

// An empty list knows every name.
bool knows(const std::vector<std::string>& names, const std::string& name) {
  return !name.empty() &&
         (names.empty() ||
          std::find(names.begin(), names.end(), name) != names.end());
}

Expected<Milliseconds> time_option(const Options& options,
                                   const std::string& name,
                                   const std::string& fallback) {
  return parse_duration(option_or(options, name, fallback));
}

} // namespace

Expected<void> LogRobot::on_options(const Options& options) {
  auto answer = option_of(options, "answer", {"done", "failed"});
  if (!answer)
    return tl::make_unexpected(answer.error());
  fails_ = *answer == "failed";
  places_ = list_option(options, "places");
  things_ = list_option(options, "things");
  place_ = option_or(options, "place", "");
  battery_ = option_or(options, "battery", "100");
  return read_times(options);
}

Expected<void> LogRobot::read_times(const Options& options) {
  const auto travel = time_option(options, "travel", "4s");
  if (!travel)
    return tl::make_unexpected(travel.error());
  const auto grip = time_option(options, "grip", "2s");
  if (!grip)
    return tl::make_unexpected(grip.error());
  travel_ = *travel;
  grip_ = *grip;
  return {};
}

bool LogRobot::carry_out(const Message& message) {
  const auto& command = message.command;
  if (command == "Goto")
    go(message);
  else if (command == "Grasp")
    grasp(message);
  else if (command == "Release")
    hand_.clear();
  else if (command == "Stop")
    end_order("stopped");
  else if (command == "Sense")
    sense(text_param(message, 0));
  else
    // Say is recorded and needs no more.
    return command == "Say";
  return true;
}

// Orders are answered later, so the answer refers to the order.
void LogRobot::go(const Message& order) {
  const auto place = text_param(order, 0);
  if (!knows(places_, place))
    return fire_event("Failed", {"I do not know the place '" + place + "'."});
  begin(order, travel_, [this, order, place] {
    if (fails_)
      return answer(order, "Failed", {"The way is blocked."});
    place_ = place;
    answer(order, "Arrived", {place});
  });
}

void LogRobot::grasp(const Message& order) {
  const auto thing = text_param(order, 0);
  if (!knows(things_, thing))
    return fire_event("Failed", {"I do not know the thing '" + thing + "'."});
  if (!hand_.empty())
    return fire_event("Failed", {"My hand is full: " + hand_ + "."});
  begin(order, grip_, [this, order, thing] {
    if (fails_)
      return answer(order, "Failed", {"It slips out of my hand."});
    hand_ = thing;
    answer(order, "Grasped", {thing});
  });
}

// There is one sensor for each entry of the table.
void LogRobot::sense(const std::string& sensor) {
  const std::pair<const char*, Value> sensors[] = {
      {"place", place_}, {"hand", hand_}, {"battery", parse_number(battery_)}};
  for (const auto& [name, value] : sensors)
    if (sensor == name)
      return fire_event("Sensor", {sensor, value});
  fire_event("Failed", {"There is no sensor '" + sensor +
                        "'; there are place, hand, battery."});
}

void LogRobot::begin(const Message& order, Milliseconds takes,
                     std::function<void()> done) {
  end_order("another order came");
  const auto due = host().after(takes, [this, done = std::move(done)] {
    order_.reset();
    done();
  });
  order_ = Order{order, due};
}

// An order that is replaced or stopped fails with the reason.
void LogRobot::end_order(const std::string& reason) {
  if (!order_)
    return;
  host().cancel(order_->due);
  const auto order = std::exchange(order_, {})->message;
  answer(order, "Failed", {reason});
}

PluginFactory log_robot_factory() {
  auto description = describe_stand_in(
      "LogRobot", "Robot", "a robot that fetches and carries",
      {{"answer",
        "done",
        "how orders end",
        false,
        OptionType::choice,
        {"done", "failed"}},
       {"places", "", "where it can go, separated by commas; anywhere", false},
       {"things", "", "what it can take, separated by commas; anything", false},
       {"place", "", "where it stands at first", false},
       {"battery", "100", "what the sensor 'battery' says", false,
        OptionType::number},
       {"travel", "4s", "how long it goes to a place", false,
        OptionType::duration},
       {"grip", "2s", "how long it takes to grasp a thing", false,
        OptionType::duration}});
  return {description, [] { return std::make_unique<LogRobot>(); }};
}

} // namespace parlour::adapters
