// Exceptions where actors meet code that is not theirs.
#pragma once

#include <exception>
#include <optional>
#include <string>

#include <caf/error.hpp>
#include <caf/sec.hpp>

namespace parlour::actors {

inline std::string exception_text(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const std::exception& exception) {
    return exception.what();
  } catch (...) {
    return "an exception of an unknown type";
  }
}

// What `action` threw, in words; nothing where it did not.
// For calls of plug-ins, callbacks and adapters: no exception crosses their
// border.
template <class Action>
std::optional<std::string> catch_to_string(Action&& action) {
  try {
    action();
    return std::nullopt;
  } catch (...) {
    return exception_text(std::current_exception());
  }
}

// What this actor's handlers throw ends it; whoever watches it hears the words,
// and nothing is printed as CAF would do by itself.
template <class Self>
void end_by_what_is_thrown(Self self) {
  self->set_exception_handler([](std::exception_ptr& thrown) {
    return caf::make_error(caf::sec::runtime_error, exception_text(thrown));
  });
}

} // namespace parlour::actors
