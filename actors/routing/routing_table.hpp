// RoutingTable: who fills which role, and the application's <routes>, as an
// immutable snapshot that any sender may apply itself (engine rule 1: "through
// the message centre" means stamped, routed by its table, counted and tapped,
// not one more mailbox).
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "actors/protocol/interfaces.hpp"
#include "actors/routing/component_mailbox.hpp"
#include "actors/routing/instance_list.hpp"
#include "actors/routing/round_limit.hpp"
#include "runtime/base/clock.hpp"
#include "runtime/message/message.hpp"
#include "runtime/message/roles.hpp"
#include "runtime/plugin/plugin.hpp"
#include "script/run/interpreter_pool.hpp"

namespace parlour::actors {

// One component as the table knows it. Copied from table to table; what it
// points to is shared with the supervisor, which changes it (all of it is safe
// from any thread).
struct Target {
  std::string name;
  std::vector<std::string> roles;
  std::shared_ptr<ComponentMailbox> mailbox;
  // Callable in a session's own turn; null: only by its mailbox.
  std::shared_ptr<const InlinePlugin> direct;
  // False before it has started and after it has gone down; shared.
  std::shared_ptr<const std::atomic<bool>> up;
  // Where each seat or session has its own: those of the sessions, and the
  // three above are null.
  std::shared_ptr<const InstanceList> by_session = nullptr;
  std::vector<RoleEvent> events = {}; // of its own

  // For messages of that session.
  bool is_up(const SessionId& session) const;
  // Null where the session has none.
  std::shared_ptr<ComponentMailbox> mailbox_of(const SessionId& session) const;
};

// One mailbox or inline component that gets the message. The table that made it
// must be kept until it is delivered.
struct Delivery {
  const Target* target; // lives as long as the table
  SharedMessage message;
};

// A sink that nobody fills, and what was for it.
struct Unreached {
  std::string sink;
  SharedMessage message;
};

// Where a message goes: to components, to its session, or to nobody.
struct Routed {
  std::vector<Delivery> deliveries;
  std::optional<Message> for_session; // what its session gets
  std::vector<Unreached> unreached;
};

// What went through, of all tables of a node.
// Only count up, and are read while others count: two of them need not fit each
// other exactly.
struct Counters {
  std::atomic<std::uint64_t> numbers = 0; // of stamps
  std::atomic<std::uint64_t> copies = 0;  // which have numbers of their own
  std::atomic<std::uint64_t> to_sessions = 0;
  std::atomic<std::uint64_t> relayed = 0;
  std::atomic<std::uint64_t> filtered = 0;
  std::atomic<std::uint64_t> dropped = 0;
  std::atomic<std::uint64_t> unhandled = 0;
  std::atomic<std::uint64_t> failed_conditions = 0;
  std::atomic<std::uint64_t> circled = 0; // dropped, as they went in a ring
  RoundLimit rounds;

  // Without the copies of relays: what was said, not what was delivered.
  std::uint64_t messages() const {
    const auto copied = copies.load(); // first: there are never more of them
    return numbers - copied;
  }
};

// Sees each message once, with the way it took: "relay -> ASR", "-> NLU",
// "filter -> NLG", "dropped", "session". Called from any thread; influences
// nothing.
using Tap = std::function<void(const Message&, const std::string& way)>;

// Told of what goes wrong with a message on its way: the condition of a filter
// fails, or it goes in a ring. Called from any thread; may be empty.
using Complaint = std::function<void(const Message&, const Error&)>;

// Made by the bus whenever the supervisor publishes other targets, never
// changed afterwards, and kept by each sender for as long as it uses it. So
// routing takes no lock of its own.
class RoutingTable {
public:
  struct Parts {
    std::shared_ptr<const script::Program> program;
    std::vector<Target> targets; // in order of preference
    // Another name of a role: "Record" is "Microphone".
    std::map<std::string, std::string, std::less<>> aliases;
    const Clock* clock = nullptr; // outlives the table
    std::shared_ptr<Counters> counters;
    std::vector<Tap> taps;
    // Whether they want to see anything now; null: always.
    const std::atomic<bool>* is_tapped = nullptr;
    Complaint complain;
  };

  // `parts.program` and `parts.counters` are not null.
  explicit RoutingTable(Parts parts);

  // Stamps, relays, filters, finds the sinks. Safe from any thread.
  Routed route(Message message) const;
  // The same for who knows the time.
  Routed route(Message&& message, Timestamp now) const;

  // By instance name, else the first component that is up for the session and
  // fills the role or alias; null where there is none. "Role*" is found like
  // "Role".
  const Target* find(std::string_view module, const SessionId& session) const;
  // Whether a message's source is meant by `module`: "*", the same name, or a
  // role or alias that it fills.
  bool is_source(std::string_view module, std::string_view source) const;
  // What an event means to the request that it answers.
  Reply reply_to_request(const Message& event) const;
  // Whether it is a user's turn: what a recogniser heard (engine rule 3).
  bool begins_turn(const Message& message) const;
  // An event that nobody has to take, as its role says.
  bool is_routine(const Message& message) const;
  // Whether a handler or a state of the program takes such a message.
  bool is_listened_to(const Message& message) const;
  // Whether an <open> says that the message opens a conversation at the seat of
  // that name (engine rule 1.8).
  bool opens(const Message& message, std::string_view seat) const;
  // Whether a component has an instance for each seat or session.
  bool has_instances_by_session() const;

  Counters& counters() const {
    return *parts_.counters;
  }
  const std::vector<Target>& targets() const {
    return parts_.targets;
  }

private:
  // Views into the table, or into `name`.
  std::string_view role(std::string_view name) const;
  const Target* named(std::string_view name) const;
  // All that a sink means: for "Role*" each that is up (engine rule 1c).
  template <class Take>
  void for_targets_of(std::string_view sink, const SessionId& session,
                      Take&& take) const;
  void stamp(Message& message, Timestamp now) const;
  // Whether the message is to be dropped (engine rule 1.6).
  bool goes_in_a_ring(const Message& message) const;
  // Whether a route or an opening is for such messages.
  template <class Rule>
  bool matches(const Rule& rule, const Message& message) const;
  // Unknown where it fails, which is told.
  Value evaluate(script::CodeId code, const Message& message) const;
  bool holds(script::CodeId condition, const Message& message) const;
  // With the route's `as` and parameters, where it has some.
  Message copy_for(const script::Route& route, const Message& message,
                   const std::string& to) const;
  void send_copies(const script::Route& route, const Message& message,
                   Routed& routed) const;
  // Notes all that `to` means, or that nobody fills it.
  void deliver(const SharedMessage& message, const std::string& to,
               Routed& routed) const;
  bool apply_routes(const Message& message, Routed& routed) const;
  // For an event other than ValuesChanged it does nothing.
  void pass_on_values(const Message& message, Routed& routed) const;
  bool is_tapped() const;
  void tap(const Message& message, const std::string& way) const;

  Parts parts_;
  std::shared_ptr<const script::InterpreterPool> conditions_;
};

} // namespace parlour::actors
