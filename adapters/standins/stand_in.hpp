// StandIn is the base class of plug-ins that take the place of an outside
// service. A stand-in does nothing outside of this machine. It answers as the
// service would, and records every command in the data folder, in the file
// records/<record>.log.
#pragma once

#include <string>

#include "adapters/standins/record.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

// A derived class reads its options and carries out its commands; the base
// class records them.
class StandIn : public IPlugin {
protected:
  // `record` is the name of the file, unless the option `record` gives another
  // one.
  explicit StandIn(std::string record) : record_name_(std::move(record)) {}

  Expected<void> on_start(const Options& options) final;

  // Records the message, then carries it out. An unknown command is answered by
  // Failed(reason).
  void on_message(const Message& message) final;

  // Reads the stand-in's own options.
  virtual Expected<void> on_options(const Options& options) = 0;
  // Returns false for an unknown command.
  virtual bool carry_out(const Message& message) = 0;

private:
  std::string record_name_;
  Record record_;
};

// The text of the option, or the fallback.
std::string option_or(const Options& options, const std::string& name,
                      const std::string& fallback);

// The option as one of the allowed texts, of which the first is the default.
// The error, of kind Settings, lists them.
Expected<std::string> option_of(const Options& options, const std::string& name,
                                const std::vector<std::string>& allowed);

// The names in an option, separated by commas.
std::vector<std::string> list_option(const Options& options,
                                     const std::string& name);

// The parameter as a text without surrounding blanks; empty if it is missing.
std::string text_param(const Message& message, std::size_t index);

// Three to fifteen digits, with blanks and hyphens between and an optional '+'
// before them.
bool is_phone_number(const std::string& text);

// A description with what all stand-ins have in common. `service` completes the
// sentence "a stand-in for …", and `options` are the plug-in's own.
PluginDescription describe_stand_in(std::string name, std::string role,
                                    const std::string& service,
                                    std::vector<OptionDescription> options);

} // namespace parlour::adapters
