// Fields reads the fields of a discovery message: long or short names, and
// topics that begin or end with '~', which stands for the base topic.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "adapters/mqtt/discovery/entity.hpp"
#include "adapters/mqtt/discovery/payload.hpp"

namespace parlour::adapters::mqtt {

// Most devices use short names, such as "stat_t" for "state_topic":
// discovery_fields.def has both. A name that is not there is ignored.
// Refers to the message, which must outlive it. Mistakes are kept: the first
// one is the reason why the entity cannot be used.
//
//   {"name": "Lamp", "~": "home/lamp", "stat_t": "~/state", "cmd_t": "~/set"}
class Fields {
public:
  // What the message does not have is looked for in
  // `outside`, if there is one: the message around a part.
  explicit Fields(const Map& message, const Fields* outside = nullptr);

  // The value of a field; null if there is none.
  const Value* find(const std::string& name) const;
  // The field as a text; a number or a boolean as templates write it.
  std::optional<std::string> text(const std::string& name) const;
  std::string text(const std::string& name, const std::string& otherwise) const;
  bool truth(const std::string& name, bool otherwise) const;
  // `otherwise` also where the field is no number.
  double number(const std::string& name, double otherwise) const;

  // Empty if there is none. One that cannot be used is a mistake.
  std::string topic(const std::string& name);
  // A topic and the template beside it.
  Source source(const std::string& topic, const std::string& value);
  ValueTemplate value_template(const std::string& name);
  // A field of the device.
  std::string device_text(const std::string& name) const;
  std::vector<AvailabilitySource> availability();

  void note(const std::string& mistake);
  // Empty: there was none.
  const std::string& mistake() const {
    return mistake_;
  }

private:
  std::string whole_topic(const std::string& topic) const;

  const Fields* outside_;
  std::map<std::string, const Value*> fields_; // by their long names
  std::string base_;
  std::string mistake_;
};

} // namespace parlour::adapters::mqtt
