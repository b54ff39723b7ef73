#include "adapters/standins/log_devices.hpp"

#include "runtime/plugin/folder.hpp"

namespace parlour::adapters {

namespace {

// A cell of the table as a number, if it is one.
Value value_of(const Value& cell) {
  const auto number = parse_number(cell.text());
  return number.is_unknown() ? cell : number;
}

// Why the device does not take the value; empty if it does. Only a device with
// a range restricts its values.
std::string refusal(const Value& device, const Value& value) {
  const auto from = parse_number(device["from"].text());
  const auto to = parse_number(device["to"].text());
  if (from.is_unknown() || to.is_unknown())
    return value.is_unknown() ? "There is no value to set." : "";
  const auto number = parse_number(value.text());
  if (!number.is_unknown() && number.number_or(0) >= from.number_or(0) &&
      number.number_or(0) <= to.number_or(0))
    return {};
  return "The " + device["device"].text() + " takes " + from.text() + " to " +
         to.text() + ", not " + value.text() + ".";
}

} // namespace

Expected<void> LogDevices::on_options(const Options& options) {
  const auto path = inside(host().application_folder(),
                           option_or(options, "devices", ""), "devices");
  if (!path)
    return tl::make_unexpected(path.error());
  auto table = ReportTable::read(*path, {"device", "room"}, "value");
  if (!table)
    return tl::make_unexpected(table.error());
  table_ = std::move(*table);
  return {};
}

bool LogDevices::carry_out(const Message& message) {
  // Set and Ask have the same answer.
  const bool sets = message.command == "Set";
  if (!sets && message.command != "Ask")
    return false;
  const DeviceKey key{text_param(message, 0), text_param(message, 1)};
  const auto& [device, room] = key;
  // Names are kept in lower case, so that the spelling of a command does
  // not matter.
  const DeviceKey folded_key{folded(device), folded(room)};
  const auto found = table_.find({device, room});
  const Value value = message.params.size() > 2 ? message.params[2] : Value();
  if (device.empty() || room.empty() || !found)
    fire_event("Failed", {"There is no '" + device + "' in '" + room + "'."});
  else if (const auto wrong = sets ? refusal(found->data, value) : "";
           !wrong.empty())
    fire_event("Failed", {wrong});
  else if (sets)
    tell(key, values_[folded_key] = value);
  else if (const auto set = values_.find(folded_key); set != values_.end())
    tell(key, set->second);
  else
    tell(key, value_of(found->text));
  return true;
}

void LogDevices::tell(const DeviceKey& key, const Value& value) {
  fire_event("State", {key.first, key.second, value});
}

PluginFactory log_devices_factory() {
  auto description = describe_stand_in(
      "LogDevices", "Devices", "the devices of a house",
      {{"devices", "", "what there is, a .tsv file of the application", true}});
  return {description, [] { return std::make_unique<LogDevices>(); }};
}

} // namespace parlour::adapters
