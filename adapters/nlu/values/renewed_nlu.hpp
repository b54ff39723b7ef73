// RenewedNLU: a plug-in for the role NLU whose understanding knows the values
// of columns. Where a column has new values (engine rule 1.9), another engine
// takes its place, and whoever asks meanwhile is answered by the one before.
//
// `Engine` is cheap to copy and may be used by any number of threads: a handle.
#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "adapters/nlu/values/known_columns.hpp"
#include "runtime/plugin/adaptors.hpp"

namespace parlour::adapters::nlu {

// Joins errors to one with a line for each. An error of data stands alone: if
// the database cannot be read, all others follow from that.
Error joined(const std::vector<Error>& errors);

template <class Engine>
class RenewedNLU : public NLUPlugin {
protected:
  // Makes an engine with the values that the reader gives, or tells all that is
  // wrong. It reads no files: what is known is what the messages say.
  using Make = std::function<tl::expected<Engine, std::vector<Error>>(
      const ColumnReader&)>;

  // To be called by on_start().
  Expected<void> begin(Make make) {
    make_ = std::move(make);
    auto made = made_with(columns_);
    if (!made)
      return tl::make_unexpected(std::move(made.error()));
    engine_ = std::move(*made);
    return {};
  }
  virtual std::vector<Value> acts(const Engine& engine, const std::string& text,
                                  const Map& context) const = 0;

  // Times such as "in ten minutes" need the present time. If the context does
  // not give it, the platform's clock does.
  std::vector<Value> understand(const std::string& text,
                                const Map& given) const override {
    auto context = given;
    if (!context.find("now"))
      context.set("now", host().clock().now());
    return acts(engine(), text, context);
  }

  // Values with which nothing can be made are not kept, so that they are tried
  // again when somebody tells them again.
  void set_values(const std::string& column,
                  const List& values) const override {
    const std::lock_guard one_after_the_other(changing_);
    auto columns = columns_;
    if (!columns.set(column, values))
      return;
    auto made = made_with(columns);
    if (!made)
      return host().log("The new values of " + column +
                        " are not used: " + made.error().message);
    columns_ = std::move(columns);
    const std::lock_guard lock(mutex_);
    engine_ = std::move(*made);
  }

private:
  Expected<Engine> made_with(KnownColumns& columns) const {
    auto made = make_([&](const std::string& name) {
      return columns.read(name, [this](const std::string& column) {
        return host().column(column);
      });
    });
    if (!made)
      return tl::make_unexpected(joined(made.error()));
    return std::move(*made);
  }

  Engine engine() const {
    const std::lock_guard lock(mutex_);
    return *engine_;
  }

  Make make_;
  // New values may come in the turns of several sessions.
  mutable std::mutex changing_; // guards the columns
  mutable KnownColumns columns_;
  mutable std::mutex mutex_;             // guards the engine
  mutable std::optional<Engine> engine_; // from the start on
};

} // namespace parlour::adapters::nlu
