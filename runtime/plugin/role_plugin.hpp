// RolePlugin: what the tailored adaptors have in common (paper III.D). Commands
// of the role arrive as calls with typed parameters; what is missing or does
// not fit is refused in the role's own words, by the table roles.def, before
// the plug-in sees it.
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

// One that may be missing.
template <class T>
bool read(const Value& value, std::optional<T>& to) {
  return value.is_unknown() || read(value, to.emplace());
}

class RolePlugin : public IPlugin {
public:
  const Role& role() const {
    return role_;
  }
  // What it has handlers for.
  std::vector<std::string> commands() const;

protected:
  // `role` is in the table.
  explicit RolePlugin(std::string_view role);

  // The command calls the handler, whose parameters say what it takes:
  // std::string, std::int64_t, double, bool, List, Map, Binary, ResultSet,
  // Value, or std::optional of one of them. Given in the constructor; a plug-in
  // may add commands of its own.
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
  // A command that nobody handles.
  virtual void on_other(const Message& message);

  // The event that says no in this role: Failed(reason), Error(kind, message).
  void refuse(const std::string& reason);

private:
  // The first parameter that does not fit.
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

  std::string complaint(const Message& message, std::size_t index) const;

  using Handler =
      std::function<std::optional<std::size_t>(const Message& message)>;
  const Role& role_;
  std::map<std::string, Handler, std::less<>> handlers_;
};

} // namespace parlour
