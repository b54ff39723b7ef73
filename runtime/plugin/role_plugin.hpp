// RolePlugin: what the role classes of adaptors.hpp have in common. It
// dispatches commands to typed handlers, and refuses a command whose parameters
// do not fit by the refusal of the role (roles.def).
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "runtime/plugin/parameters.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour {

// Reads a parameter that may be missing.
template <class T>
bool read(const Value& value, std::optional<T>& to) {
  return value.is_unknown() || read(value, to.emplace());
}

// Handlers are registered in the constructor and run on the plug-in's own
// thread.
class RolePlugin : public IPlugin {
public:
  const Role& role() const {
    return role_;
  }
  // The commands that have a handler.
  std::vector<std::string> commands() const;

protected:
  // The role must exist in roles.def.
  explicit RolePlugin(std::string_view role);

  // Registers a handler for a command. Its parameter types say what the command
  // takes: std::string, std::int64_t, double, bool, List, Map, Binary,
  // ResultSet, Value, or std::optional of one of them. Call it in the
  // constructor; a plug-in may add commands of its own:
  //
  //   on("SetSpeed", &MyRobot::on_set_speed); // void on_set_speed(double)
  template <class Self, class... Parameters>
  void on(std::string command, void (Self::*handler)(Parameters...)) {
    handlers_[std::move(command)] = [this, handler](const Message& message) {
      std::tuple<std::decay_t<Parameters>...> values;
      const auto wrong =
          read_all(message, values, std::index_sequence_for<Parameters...>());
      if (wrong)
        return wrong;
      std::apply(
          [&](auto&... each) { (static_cast<Self*>(this)->*handler)(each...); },
          values);
      return std::optional<std::size_t>();
    };
  }

  void on_message(const Message& message) override;
  // Called for a command without a handler; refuses it.
  virtual void on_other(const Message& message);

  // Fires the role's refusal: Failed(reason) or Error(kind, message).
  void refuse(const std::string& reason);

private:
  // Reads the parameters in order; returns the index of the first that does not
  // fit.
  template <class Values, std::size_t... Index>
  static std::optional<std::size_t> read_all(const Message& message,
                                             Values& values,
                                             std::index_sequence<Index...>) {
    static const Value missing;
    std::optional<std::size_t> wrong;
    [[maybe_unused]] auto fits = [&](std::size_t index, auto& to) {
      const auto& params = message.params;
      if (!read(index < params.size() ? params[index] : missing, to))
        wrong = index;
      return !wrong;
    };
    (void)(fits(Index, std::get<Index>(values)) && ...);
    return wrong;
  }

  // The reason for refusing a message because of a parameter.
  std::string complaint(const Message& message, std::size_t index) const;

  using Handler =
      std::function<std::optional<std::size_t>(const Message& message)>;
  const Role& role_;
  std::map<std::string, Handler, std::less<>> handlers_;
};

} // namespace parlour
