// Program: a compiled application, as plain data. Immutable; shared by all
// sessions and by the actors that work for them. script/compiler makes it.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "runtime/base/settings.hpp"
#include "runtime/base/value.hpp"
#include "runtime/message/understanding.hpp"
#include "script/program/code.hpp"
#include "script/program/initial_values.hpp"
#include "script/source/source.hpp"

namespace parlour::script {

class ConstantPool;

// Indices into the lists of a Program or a Topic.
using TopicId = std::uint32_t;
using SlotId = std::uint32_t;
using StateId = std::uint32_t;
inline constexpr std::uint32_t no_id = 0xffffffff;

// Pseudo-slots: what the last query found, as topic code reads it by
// `this.rows`, `this.asked` and `this.relaxed` (engine rule 6.4).
inline constexpr SlotId slot_rows = 0xfffffff0;
inline constexpr SlotId slot_asked = 0xfffffff1;
inline constexpr SlotId slot_relaxed = 0xfffffff2;
// `this.last`: what the topic was completed with before, by slot.
inline constexpr SlotId slot_last = 0xfffffff3;

// Which values a slot takes (engine rule 5.6).
struct Cardinality {
  std::string type; // "", set, range, pattern, number, …, query, boolean
  std::vector<CodeId> values; // of a set
  CodeId minimum = no_code;   // of a range
  CodeId maximum = no_code;
  std::string pattern; // RE2
  std::string source;  // of a query: "db:table.column"
  Position position;
};

// When a slot's value is confirmed (engine rule 5.5).
enum class ConfirmPolicy : std::uint8_t {
  automatic,
  explicitly,
  implicitly,
  never
};
// How a value is compared with a column.
enum class Match : std::uint8_t { equal, prefix, contains };

// <noinput count="2"> or <nomatch count="3">: runs from the count-th time on.
struct CountedBody {
  std::uint32_t count = 1;
  CodeId body = no_code;
};

// A slot of a topic. A CodeId is no_code if the element is missing.
struct Slot {
  std::string name;
  bool functional = false;
  bool is_private = false;
  bool commits = false;  // confirmed unless certain (engine rule 5.5)
  bool many = false;     // several values (engine rule 5.14)
  TopicId part = no_id;  // the topic that fills it (engine rule 5.15)
  CodeId with = no_code; // a map: what that one has from the start
  ConfirmPolicy confirm = ConfirmPolicy::automatic;
  Match match = Match::equal;
  std::string grammar;
  // Texts and values, computed when they are wanted.
  CodeId initial = no_code;
  CodeId condition = no_code; // asked for only while it holds
  CodeId offer = no_code;     // a value that is offered before the question
  CodeId label = no_code;     // gives its text
  CodeId question = no_code;  // gives its text
  CodeId more = no_code;      // of many: what is asked after each
  std::vector<CodeId> help;   // further wordings
  std::vector<CodeId> explain;
  // Which values are accepted, and what runs then.
  Cardinality cardinality;
  CodeId filled = no_code;
  CodeId invalid = no_code;
  CodeId ambiguous = no_code;
  std::vector<CountedBody> no_input;
  std::vector<CountedBody> no_match;
  Position position;
};

// A <by>: a slot that narrows a query (engine rule 6.2).
struct QueryBy {
  SlotId slot = no_id;
  std::string column;
  Match match = Match::equal;
  std::uint32_t relax = 0; // 0: never left out
};

// A <query>: how a topic is answered (engine rule 6.1).
struct KnowledgeSource {
  std::string kind; // db, facts, aiml, ontology
  std::string name; // after the colon; may be empty
  std::string statement;
  std::uint32_t facts = no_id; // the table of facts, if `kind` is facts
  std::string order;
  std::vector<QueryBy> by;
  Position position;
};

// What must hold between slots; `message` explains why if it does not.
struct Constraint {
  CodeId condition = no_code;
  CodeId message = no_code;
  Position position;
};

// A <rule>: runs when slots change and the condition holds.
struct Rule {
  CodeId condition = no_code;
  CodeId body = no_code;
  Position position;
};

// A slot of another topic, as `Booking.Room` reads it, in the place of a
// SlotId: the highest bit, the topic and the slot. The highest ones are those
// above.
inline constexpr SlotId foreign_slot(TopicId topic, SlotId slot) {
  return 0x80000000U | topic << 16 | slot;
}
inline constexpr bool is_foreign(SlotId slot) {
  return slot >= 0x80000000U && slot < 0xffff0000U;
}
inline constexpr TopicId topic_of_foreign(SlotId slot) {
  return (slot & 0x7fffffffU) >> 16;
}
inline constexpr SlotId slot_of_foreign(SlotId slot) {
  return slot & 0xffffU;
}

enum class TopicKind : std::uint8_t { task, enquiry };
enum class Initiative : std::uint8_t { user, system, mixed };
enum class ResumePolicy : std::uint8_t { always, ask, never };
// Whether all that a topic was told is confirmed before it is done (engine rule
// 5.13).
enum class Summary : std::uint8_t { never, always, unless_certain };

// A topic (engine rule 5). Its slots are in the order in which they are asked
// for.
struct Topic {
  std::string name;
  TopicKind kind = TopicKind::task;
  Initiative initiative = Initiative::mixed;
  ResumePolicy resume = ResumePolicy::always;
  Summary summary = Summary::never;
  bool is_part = false;   // begun by slots and scripts only (engine rule 5.15)
  CodeId label = no_code; // gives its text
  // Topics that must be completed before.
  std::vector<std::string> needs;
  std::vector<Slot> slots;
  std::vector<Constraint> constraints;
  std::vector<Rule> rules;
  std::vector<KnowledgeSource> queries;
  // The session variables that conditions and texts of the slots and
  // constraints may read, in ascending order.
  std::vector<std::size_t> read_variables;
  // What runs when the topic's status changes (engine rule 5).
  CodeId started = no_code;
  CodeId suspended = no_code;
  CodeId resumed = no_code;
  CodeId filled = no_code;
  CodeId completed = no_code;
  CodeId cancelled = no_code;
  Position position;

  // The slot's index; no_id if there is none.
  SlotId slot(std::string_view slot_name) const;
  bool has_part(TopicId topic) const; // whether a slot is filled by it
  bool has_rule(CodeId body) const;
};

// One event that a handler or a state reacts to. `source` may be a role, a name
// or "*"; `event` may be "*".
struct Reaction {
  std::string source;
  std::string event;
  CodeId body = no_code;
  Position position;
};

// Reacts to messages in every state (engine rule 1).
struct Handler {
  std::string name;
  std::vector<Reaction> reactions;
  Position position;
};

// What a state keeps for itself (engine rule 4.4).
enum class Capture : std::uint8_t { none, acts, all };

// A state of the dialogue (engine rule 4).
struct State {
  std::string name;
  Capture capture = Capture::none;
  std::string grammar;
  // What runs when the state is entered or left (engine rule 4.1).
  CodeId entrance = no_code;
  CodeId exit = no_code;
  // Reactions while the state is active (engine rule 4.1).
  std::vector<Reaction> messages;
  std::vector<Reaction> online; // source: the agent, "*" for any
  std::vector<Reaction> offline;
  Position position;
};

// A <relay> or <filter> (engine rule 1). Its code sees the message only.
struct Route {
  bool is_filter = false;
  std::string source;
  std::string command;
  CodeId condition = no_code;
  bool drop = false;
  // Sinks; with `drop` there are none.
  std::vector<std::string> to;
  std::string as;             // empty: the command is kept
  std::vector<CodeId> params; // empty: the parameters are kept
  bool has_params = false;
  Position position;
};

// An <open>: a message that opens a conversation at a seat without one (engine
// rule 1.8). Its condition sees the message only.
struct Opening {
  std::string source;
  std::string command;
  CodeId condition = no_code;
  std::string seat; // empty: every seat
  Position position;
};

// <facts>: a table that is queried like one of a database.
struct FactTable {
  std::string name;
  ResultSet rows;
  TopicId topic = no_id; // the only topic that sees it; no_id: all do
};

// A wording for what the engine says. Its code takes (act, topic, slot, data).
struct Phrase {
  std::string act;   // required
  std::string topic; // empty: any
  std::string slot;  // empty: any
  CodeId condition = no_code;
  CodeId text = no_code;
  // False for the application's own, which come first.
  bool of_platform = false;
  Position position;
};

// A <repair>: the reaction to an act about the conversation itself, or to
// silence or words that were not understood (engine rule 5.10). Its code takes
// (data).
struct Repair {
  std::string act; // of the user; no_match, no_input
  TopicId topic = no_id;
  SlotId slot = no_id;
  std::uint32_t count = 0; // no_match, no_input: from which time on
  CodeId condition = no_code;
  CodeId body = no_code;
  bool of_platform = false;
  Position position;
};

// A session variable. Its index is its position in Program::variables.
struct Variable {
  std::string name;
  CodeId initial = no_code;
  bool is_constant = false;
  bool is_private = false;
};

// CodeId, TopicId, SlotId, StateId and Position::file are indices into these
// lists.
struct Program {
  std::shared_ptr<ConstantPool> pool; // first: must outlive `code`
  // Of the application; defaults for a single file.
  Settings settings;
  bool single_file = false;       // no application around it
  std::vector<std::string> files; // what Position::file indexes
  std::vector<Code> code;         // what CodeId indexes
  std::map<std::string, CodeId, std::less<>> functions; // session-wide
  // Declarations, in the order of the files.
  std::vector<Variable> variables;
  std::shared_ptr<InitialValues> initial_values =
      std::make_shared<InitialValues>();
  std::vector<Handler> handlers;
  std::vector<State> states;
  std::vector<Topic> topics;
  std::vector<TopicId> read_elsewhere; // whose slots another topic reads
  std::vector<Route> routes;
  std::vector<Opening> openings;
  std::vector<FactTable> facts;
  std::vector<Phrase> phrases; // the application's first, then the platform's
  std::vector<Repair> repairs; // likewise
  std::vector<CodeId> ladder;  // <ladder> of the settings; empty: the standard
  // For components that understand language.
  std::shared_ptr<const UnderstandingModel> understanding;

  TopicId topic(std::string_view name) const; // no_id if there is none
  StateId state(std::string_view name) const;
  SourceLocation place(Position position) const;
};

// Whether any variable or slot is private (engine rule 7.6).
bool has_private(const Program& program);

} // namespace parlour::script
