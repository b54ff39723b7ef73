// What all stand-ins have in common: they take the place of a service outside,
// do what is asked on paper only, say so, and keep a record of it in
// <data folder>/records/<record>.log.
#pragma once

#include <string>

#include "adapters/standins/record.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

class StandIn : public IPlugin {
protected:
  // `record` is the file's name unless the option `record` says another.
  explicit StandIn(std::string record) : record_name_(std::move(record)) {}

  Expected<void> on_start(const Options& options) final;

  // Every message is recorded, then carried out; an unknown command answers
  // Failed(reason).
  void on_message(const Message& message) final;

  // Reads the stand-in's own options.
  virtual Expected<void> on_options(const Options& options) = 0;
  // False for a command that it does not know.
  virtual bool carry_out(const Message& message) = 0;

private:
  std::string record_name_;
  Record record_;
};

// The option's text, or the fallback.
std::string option_or(const Options& options, const std::string& name,
                      const std::string& fallback);

// One of the texts allowed; an error of kind Settings lists them.
Expected<std::string> option_of(const Options& options, const std::string& name,
                                const std::vector<std::string>& allowed);

// The names in an option, which commas separate.
std::vector<std::string> list_option(const Options& options,
                                     const std::string& name);

// The parameter's text without blanks around; empty where there is none.
std::string text_param(const Message& message, std::size_t index);

// Digits with an optional '+' and the usual blanks and hyphens between.
bool is_phone_number(const std::string& text);

// A description with what every stand-in says of itself; `service` is such as
// "the telephone exchange".
PluginDescription describe_stand_in(std::string name, std::string role,
                                    const std::string& service,
                                    std::vector<OptionDescription> options);

} // namespace parlour::adapters
