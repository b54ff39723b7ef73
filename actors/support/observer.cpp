#include "actors/support/observer.hpp"

#include <utility>

#include "actors/support/thrown.hpp"

namespace parlour::actors {

namespace {

Inspection inspection_of(const Message& message, const std::string& way) {
  Inspection seen;
  seen.kind = InspectionKind::message;
  seen.session = message.session;
  seen.subject = message.source + "." + message.command;
  seen.detail = to_string(message);
  seen.message = std::make_shared<const Message>(message);
  seen.way = way;
  return seen;
}

} // namespace

Observer::Observer(Watcher watcher, const std::atomic<bool>& left_behind)
    : watcher_(std::move(watcher)), left_behind_(left_behind),
      discretion_(watcher_.is_heard
                      ? std::make_unique<Discretion>(
                            [this](const Inspection& seen) { show(seen); },
                            watcher_.is_heard)
                      : nullptr) {}

void Observer::inspect(Inspection seen) {
  if (!watcher_.on_inspection)
    log_instead(seen);
  else if (discretion_ && !watcher_.exact)
    discretion_->show(std::move(seen));
  else
    show(seen);
}

void Observer::follow(const Message& message, const std::string& way) {
  if (discretion_)
    discretion_->pass(message, way);
  if (watches_all())
    inspect(inspection_of(message, way));
}

void Observer::log(const std::string& line) {
  write(discretion_ ? discretion_->masked(line) : line);
}

// What is thrown is written as it is: Discretion, which calls this, cannot be
// asked meanwhile.
void Observer::show(const Inspection& seen) {
  if (left_behind_)
    return;
  const std::lock_guard lock(showing_);
  if (auto reason = thrown_by([&] { watcher_.on_inspection(seen); }))
    write("who watches failed: " + *reason);
}

void Observer::log_instead(const Inspection& seen) {
  using Kind = InspectionKind;
  if (seen.kind == Kind::unhandled)
    log(to_string(*seen.message) + ": " + seen.detail);
  else if (seen.kind == Kind::error || seen.kind == Kind::log)
    log(seen.subject + ": " + seen.detail);
}

void Observer::write(const std::string& line) {
  if (left_behind_)
    return;
  const std::lock_guard lock(logging_);
  if (watcher_.on_log)
    watcher_.on_log(line);
}

} // namespace parlour::actors
