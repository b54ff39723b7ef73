#include "adapters/standins/stand_in.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <utility>

namespace parlour::adapters {

namespace {

// No slash, so that a record cannot lie elsewhere.
bool is_file_name(const std::string& text) {
  return !text.empty() && text.front() != '.' &&
         text.find_first_of("/\\") == std::string::npos;
}

std::string trimmed(std::string text) {
  constexpr auto blanks = " \t\r\n";
  text.erase(0, std::min(text.find_first_not_of(blanks), text.size()));
  text.erase(text.find_last_not_of(blanks) + 1);
  return text;
}

std::string listed(const std::vector<std::string>& texts) {
  std::string list;
  for (const auto& text : texts)
    list += (list.empty() ? "'" : ", '") + text + "'";
  return list;
}

} // namespace

Expected<void> StandIn::on_start(const Options& options) {
  const auto name = option_or(options, "record", record_name_);
  if (!is_file_name(name))
    return fail(ErrorKind::settings,
                "option 'record' is a file's name, not '" + name + "'");
  if (auto read = on_options(options); !read)
    return read;
  return record_.open(std::filesystem::path(host().data_folder()) / "records" /
                      (name + ".log"));
}

void StandIn::on_message(const Message& message) {
  // A record that cannot be written does not keep the stand-in from answering.
  if (!record_.write(host().clock().now(), message))
    host().log("The record of " + message.command + " could not be written.");
  if (!carry_out(message))
    fire_event("Failed",
               {"There is no command '" + message.command + "' here."});
}

std::string option_or(const Options& options, const std::string& name,
                      const std::string& fallback) {
  const auto found = options.find(name);
  return found == options.end() ? fallback : found->second;
}

Expected<std::string> option_of(const Options& options, const std::string& name,
                                const std::vector<std::string>& allowed) {
  const auto text = option_or(options, name, allowed.front());
  if (std::find(allowed.begin(), allowed.end(), text) == allowed.end())
    return fail(ErrorKind::settings, "option '" + name + "' is one of " +
                                         listed(allowed) + ", not '" + text +
                                         "'");
  return text;
}

std::vector<std::string> list_option(const Options& options,
                                     const std::string& name) {
  std::vector<std::string> names;
  std::istringstream text(option_or(options, name, ""));
  for (std::string one; std::getline(text, one, ',');)
    if (one = trimmed(one); !one.empty())
      names.push_back(one);
  return names;
}

std::string text_param(const Message& message, std::size_t index) {
  if (index >= message.params.size() || message.params[index].is_unknown())
    return {};
  return trimmed(message.params[index].text());
}

bool is_phone_number(const std::string& text) {
  const auto digits = std::count_if(
      text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  // A plus sign is skipped at the beginning only.
  return digits >= 3 && digits <= 15 &&
         text.find_first_not_of("0123456789 -", text[0] == '+') ==
             std::string::npos;
}

PluginDescription describe_stand_in(std::string name, std::string role,
                                    const std::string& service,
                                    std::vector<OptionDescription> options) {
  PluginDescription description;
  description.name = std::move(name);
  description.roles = {std::move(role)};
  description.sentence = "a stand-in for " + service +
                         ": nothing leaves this machine; it keeps a record";
  description.options = std::move(options);
  description.options.push_back(
      {"record", "", "the record's name in records/, without .log", false});
  return description;
}

} // namespace parlour::adapters
