#include "actors/support/privacy/discretion.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace parlour::actors {

namespace {

// More is shown, with all that was heard masked.
constexpr std::size_t max_held = 10'000;
constexpr std::size_t max_ended = 100;
constexpr std::size_t max_heard = 1'000; // of one turn

constexpr const char* to_session = "session";

void collect_texts(const Value& value, std::vector<std::string>& texts) {
  if (const auto* text = value.if_string())
    texts.push_back(*text);
  if (const auto* list = value.if_list())
    for (const auto& element : *list)
      collect_texts(element, texts);
  if (const auto* map = value.if_map())
    for (const auto& entry : map->entries())
      collect_texts(entry.second, texts);
}

Inspection all_masked(Inspection seen) {
  auto message = *seen.message;
  for (auto& param : message.params)
    param = parlour::all_masked(param);
  seen.detail = to_string(message);
  seen.message = std::make_shared<const Message>(std::move(message));
  return seen;
}

Inspection masked_by(const Secrets& secrets, Inspection seen) {
  seen.subject = secrets.masked(seen.subject);
  seen.detail = secrets.masked(seen.detail);
  if (seen.message)
    seen.message =
        std::make_shared<const Message>(secrets.masked_message(*seen.message));
  return seen;
}

} // namespace

Discretion::Discretion(Show show, IsHeard is_heard)
    : show_(std::move(show)), is_heard_(std::move(is_heard)) {}

// -- sessions -----------------------------------------------------------------

// A private value that is new in an open turn was said in it: so its words are
// hidden as a whole, as they may name the value in another form.
void Discretion::conceal(const SessionId& session,
                         const std::vector<std::string>& texts) {
  if (!hides())
    return;
  const std::lock_guard lock(mutex_);
  auto& of = known(session);
  for (const auto& text : texts)
    of.hides_turn |= of.secrets.add(text) && of.is_open;
}

void Discretion::conceal_turn(const SessionId& session) {
  if (!hides())
    return;
  const std::lock_guard lock(mutex_);
  auto& of = known(session);
  of.hides_turn = of.is_open;
}

// Something may have been heard since, in another line: then all is held until
// that is understood.
void Discretion::settled(const SessionId& session, std::uint64_t received) {
  if (!hides())
    return;
  const std::lock_guard turn(showing_);
  std::unique_lock lock(mutex_);
  const auto found = sessions_.find(session);
  if (found == sessions_.end() || received < found->second.opened)
    return;
  auto ready = end_turn(found->second);
  lock.unlock();
  show_masked(std::move(ready));
}

void Discretion::ended(const SessionId& session) {
  if (!hides())
    return;
  const std::lock_guard turn(showing_);
  std::unique_lock lock(mutex_);
  const auto found = sessions_.find(session);
  if (found == sessions_.end())
    return;
  auto ready = end_turn(found->second);
  ended_.push_back(session);
  drop_oldest();
  lock.unlock();
  show_masked(std::move(ready));
}

// Late messages of the first are masked, too, if it has said anything private.
void Discretion::goes_on(const SessionId& from, const SessionId& to) {
  if (!hides() || from == to)
    return;
  const std::lock_guard lock(mutex_);
  const auto found = sessions_.find(from);
  if (found == sessions_.end())
    return;
  if (found->second.is_open)
    move_turn(found->second, known(to));
  if (found->second.secrets.secrets().empty())
    sessions_.erase(found);
}

void Discretion::move_turn(Session& from, Session& to) {
  std::ranges::move(std::exchange(from.heard, {}),
                    std::back_inserter(to.heard));
  std::ranges::move(std::exchange(from.held, {}), std::back_inserter(to.held));
  to.hides_turn |= std::exchange(from.hides_turn, false);
  to.opened = std::max(to.opened, from.opened);
  to.is_open = std::exchange(from.is_open, false);
}

Discretion::Session& Discretion::known(const SessionId& session) {
  return sessions_.try_emplace(session, all_).first->second;
}

void Discretion::drop_oldest() {
  for (; ended_.size() > max_ended; ended_.pop_front())
    sessions_.erase(ended_.front());
}

// -- observers ----------------------------------------------------------------

void Discretion::pass(const Message& message, const std::string& way) {
  if (!hides() || message.session.empty() || way != to_session ||
      !is_heard_(message))
    return;
  const std::lock_guard lock(mutex_);
  auto& session = known(message.session);
  session.is_open = true;
  session.opened = message.number;
  if (session.heard.size() < max_heard)
    for (const auto& param : message.params)
      collect_texts(param, session.heard);
}

// What was heard and goes elsewhere than to its session is understood by
// nobody that we know.
void Discretion::show(Inspection seen) {
  if (!hides())
    return show_(seen);
  const std::lock_guard turn(showing_);
  if (seen.message && seen.way != to_session && is_heard_(*seen.message))
    show_(all_masked(std::move(seen)));
  else
    show_masked(taken(std::move(seen)));
}

// Nothing where it is held back.
//
// What exceeds `max_held` is no reason to hold memory without a bound: the turn
// counts as private and is shown.
Discretion::Ready Discretion::taken(Inspection seen) {
  const std::lock_guard lock(mutex_);
  const auto found = sessions_.find(seen.session);
  Ready ready;
  if (found == sessions_.end() || !found->second.is_open) {
    ready.seen.push_back(std::move(seen));
    if (found != sessions_.end())
      ready.secrets = found->second.secrets.secrets();
    return ready;
  }
  auto& session = found->second;
  session.held.push_back(std::move(seen));
  if (session.held.size() <= max_held)
    return ready;
  session.hides_turn = true;
  return end_turn(session);
}

Discretion::Ready Discretion::end_turn(Session& session) {
  Ready ready{session.secrets.secrets(), std::exchange(session.held, {})};
  if (session.hides_turn)
    ready.secrets.add(note_private_turn(session));
  session.heard.clear();
  session.is_open = session.hides_turn = false;
  return ready;
}

// All that was heard, and other ways to hear it.
Secrets Discretion::note_private_turn(Session& session) {
  Secrets secrets;
  for (const auto& text : session.heard) {
    secrets.add(text);
    words_.add(text);
  }
  return secrets;
}

void Discretion::show_masked(Ready ready) const {
  for (auto& seen : ready.seen)
    show_(ready.secrets.empty() ? seen
                                : masked_by(ready.secrets, std::move(seen)));
}

// Without the words of private turns: "yes" was said in one, and would be
// masked in every line of the log.
std::string Discretion::masked(const std::string& text) const {
  if (!hides())
    return text;
  const std::lock_guard lock(mutex_);
  return all_.masked(text);
}

std::string Discretion::masked_afterwards(const std::string& text) const {
  if (!hides())
    return text;
  const auto shown = masked(text);
  const std::lock_guard lock(mutex_);
  return words_.secrets().masked(shown);
}

bool Discretion::is_private(const std::string& words) const {
  if (masked(words) != words)
    return true;
  const std::lock_guard lock(mutex_);
  return words_.contains(words);
}

} // namespace parlour::actors
