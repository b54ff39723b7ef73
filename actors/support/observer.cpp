#include "actors/support/observer.hpp"

#include <algorithm>
#include <utility>

#include "actors/support/exception_text.hpp"

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
      discretion_([this](const Inspection& seen) { show(seen); },
                  watcher_.is_heard),
      all_(watcher_.on_inspection && watcher_.all),
      follows_(discretion_.hides() || all_) {}

void Observer::inspect(Inspection seen) {
  if (seen.kind == InspectionKind::error)
    metrics_.script_errors.add();
  if (!watcher_.on_inspection)
    log_instead(seen);
  else if (!watcher_.exact)
    discretion_.show(std::move(seen));
  else
    show(seen);
}

void Observer::watch_all(bool wanted) {
  all_ = watcher_.on_inspection && (wanted || watcher_.all);
  follows_ = discretion_.hides() || all_;
}

// Discretion hears of each message even where nobody watches: it has to know
// what is private before it is in a log.
void Observer::follow(const Message& message, const std::string& way) {
  discretion_.pass(message, way);
  if (watches_all())
    inspect(inspection_of(message, way));
}

bool Observer::traces(std::string_view kind, std::string_view name) const {
  return watcher_.on_inspection &&
         std::ranges::any_of(watcher_.actors, [&](const std::string& wanted) {
           return wanted == kind || wanted == name;
         });
}

void Observer::log(const std::string& line) {
  write(discretion_.masked(line));
}

// What the watcher throws is not its caller's fault, and is only logged.
void Observer::show(const Inspection& seen) {
  if (left_behind_)
    return;
  const std::lock_guard lock(showing_);
  if (auto reason = catch_to_string([&] { watcher_.on_inspection(seen); }))
    log("who watches failed: " + *reason);
}

void Observer::log_instead(const Inspection& seen) {
  using Kind = InspectionKind;
  if (seen.kind == Kind::unhandled)
    log(to_string(*seen.message) + ": " + seen.detail + concern_of(seen));
  else if (seen.kind == Kind::error || seen.kind == Kind::log)
    log(seen.subject + ": " + seen.detail + concern_of(seen));
}

void Observer::write(const std::string& line) {
  if (left_behind_)
    return;
  const std::lock_guard lock(logging_);
  if (watcher_.on_log)
    watcher_.on_log(line);
}

} // namespace parlour::actors
