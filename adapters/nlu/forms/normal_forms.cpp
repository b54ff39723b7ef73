#include "adapters/nlu/forms/normal_forms.hpp"

#include <array>

#include "adapters/nlu/forms/form_reader.hpp"

namespace parlour::adapters::nlu {

namespace {

// One entry for each form: its name, and the function that reads it.
struct FormEntry {
  std::string_view name;
  std::optional<FormAt> (*read)(FormReader, Now);
};

// In the order of the enumeration Form.
constexpr std::array<FormEntry, form_count> forms{{
    {"time", time_form},
    {"date", date_form},
    {"number", number_form},
    {"duration", duration_form},
    {"phone", phone_form},
    {"email", email_form},
    {"level", level_form},
}};

} // namespace

std::optional<Form> form_of(std::string_view name) {
  for (std::size_t index = 0; index < forms.size(); ++index)
    if (forms[index].name == name)
      return static_cast<Form>(index);
  return {};
}

std::string_view name_of(Form form) {
  return forms[static_cast<std::size_t>(form)].name;
}

std::optional<FormAt> form_at(Form form, const Tokens& tokens,
                              std::size_t position, Now now) {
  return forms[static_cast<std::size_t>(form)].read(
      FormReader(tokens, position), now);
}

} // namespace parlour::adapters::nlu
