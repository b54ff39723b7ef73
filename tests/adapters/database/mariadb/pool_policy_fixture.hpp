// PoolPolicyTest: what a pool decides, as lines.
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "adapters/database/mariadb/pool_policy.hpp"

namespace parlour::adapters {

class PoolPolicyTest : public testing::Test {
protected:
  using Kind = DatabaseCommand;
  using Lines = std::vector<std::string>;

  static constexpr Milliseconds busy_timeout{1'000};
  static constexpr Milliseconds transaction_timeout{5'000};

  explicit PoolPolicyTest(std::size_t connections = 2)
      : policy({connections, busy_timeout, transaction_timeout}) {}

  // -- what happens -----------------------------------------------------------

  void queue(const std::string& session, Kind kind, bool write = false) {
    DatabaseOrder order{kind, {}, write};
    order.message.session = session;
    if (kind == Kind::query)
      order.message.params = {"select 1"};
    policy.queue(std::move(order), now + busy_timeout);
  }
  void opens(std::size_t place) {
    policy.opened(place, StatementAnswer{}, now);
  }
  void does_not_open(std::size_t place) {
    policy.opened(place, fail(ErrorKind::offline, "nobody is there"), now);
  }
  void succeeds(std::size_t place, Access access = Access::write) {
    policy.ended(place, StatementAnswer{}, {false, false, false, access}, now);
  }
  void fails(std::size_t place, const PoolPolicy::State& state,
             ErrorKind kind = ErrorKind::database) {
    policy.ended(place, fail(kind, "it failed"), state, now);
  }
  // Starts with `count` connections that are idle.
  void connect(std::size_t count) {
    policy.begin();
    opens(0);
    for (std::size_t place = 1; place < count; ++place) {
      for (std::size_t i = 0; i <= place; ++i)
        queue("opener" + std::to_string(i), Kind::query);
      policy.decide(now);
      opens(place);
      policy.decide(now);
      for (std::size_t i = 0; i <= place; ++i)
        succeeds(i);
    }
    policy.deeds();
    policy.answers();
  }
  // The session has a transaction on the connection that this returns.
  std::size_t begin_transaction(const std::string& session) {
    queue(session, Kind::begin);
    policy.decide(now);
    const auto place = std::get<PoolPolicy::Run>(policy.deeds().at(0)).place;
    succeeds(place);
    policy.answers();
    return place;
  }

  // -- what follows -----------------------------------------------------------

  // "open 0", "set up 0", "run 0: s1", "close 0", or a warning.
  Lines deeds() {
    policy.decide(now);
    Lines lines;
    for (const auto& deed : policy.deeds())
      std::visit([&](const auto& one) { lines.push_back(text(one)); }, deed);
    return lines;
  }
  // "s1: well" or "s1: Database".
  Lines answers() {
    Lines lines;
    for (const auto& [message, outcome] : policy.answers())
      lines.push_back(
          message.session + ": " +
          (outcome ? "well" : std::string(name_of(outcome.error().kind))));
    return lines;
  }

  std::string text(const PoolPolicy::Open& deed) {
    return (deed.sets_up ? "set up " : "open ") + std::to_string(deed.place);
  }
  std::string text(const PoolPolicy::Run& deed) {
    return "run " + std::to_string(deed.place) + ": " +
           policy.order(deed.place).message.session;
  }
  std::string text(const PoolPolicy::Close& deed) {
    return "close " + std::to_string(deed.place);
  }
  std::string text(const PoolPolicy::Warn& deed) {
    return std::string(deed.text);
  }

  PoolPolicy::Moment now{std::chrono::hours(1)};
  PoolPolicy policy;
};

} // namespace parlour::adapters
