#include "adapters/mqtt/device_list.hpp"

#include <utility>

#include "adapters/mqtt/discovery/entity_kinds.hpp"
#include "adapters/standins/report_table.hpp"

namespace parlour::adapters::mqtt {

namespace {

std::optional<double> number_in(const Map& row, const char* column) {
  const auto* cell = row.find(column);
  const auto number = cell ? parse_number(cell->text()) : Value();
  return number.is_unknown() ? std::nullopt
                             : std::optional(number.number_or(0));
}

std::string text_in(const Map& row, const char* column) {
  const auto* cell = row.find(column);
  return cell ? cell->text() : std::string();
}

// "sensor:temperature" is the kind and, behind the colon, the class.
ListedDevice listed(const Map& row) {
  ListedDevice made{text_in(row, "device"), text_in(row, "room"),
                    text_in(row, "kind"),   {},
                    number_in(row, "from"), number_in(row, "to")};
  const auto colon = std::min(made.kind.find(':'), made.kind.size());
  if (colon < made.kind.size())
    made.device_class = made.kind.substr(colon + 1);
  made.kind.resize(colon);
  made.device_words = words_of(made.device);
  made.room_words = words_of(made.room);
  made.class_words = words_of(made.device_class);
  return made;
}

// The row as if the device had announced itself.
Discovery announced(const Map& row, const ListedDevice& device) {
  Map message;
  for (const auto& [column, cell] : row.entries())
    if (column != "device" && !cell.text().empty())
      message.set(column, cell);
  message.set("name", device.device);
  message.set("device", Map{{"suggested_area", device.room}});
  if (!device.device_class.empty())
    message.set("device_class", device.device_class);
  return read_discovery(device.device + " in " + device.room, device.kind,
                        Payload(json_text(message)));
}

bool has_topic(const Map& row) {
  for (const auto& [column, cell] : row.entries())
    if (column.ends_with("_topic") && !cell.text().empty())
      return true;
  return false;
}

} // namespace

// The first mistake ends the reading: the file is the application's own, and is
// to be right.
Expected<DeviceList> DeviceList::read(const std::filesystem::path& file) {
  const auto table = ReportTable::read(file, {"device", "room"}, "kind");
  if (!table)
    return tl::make_unexpected(table.error());
  const auto reports = table->reports();
  DeviceList made;
  for (const auto& report : reports) {
    const auto wrong = [&](const std::string& what) {
      return fail(ErrorKind::settings, what, {file.string(), report.line, 0});
    };
    const auto& row = *report.data.if_map();
    auto device = listed(row);
    if (!is_known_kind(device.kind))
      return wrong("the kind of '" + device.device +
                   "' is one that Home Assistant knows, such as light or "
                   "sensor:temperature, not '" +
                   report.text + "'");
    if (has_topic(row)) {
      auto found = announced(row, device);
      if (!found.mistakes.empty())
        return wrong(found.mistakes.front());
      for (auto& entity : found.entities)
        made.entities.push_back(std::move(entity));
    }
    made.devices.push_back(std::move(device));
  }
  return made;
}

} // namespace parlour::adapters::mqtt
