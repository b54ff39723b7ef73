// Program: a compiled application. Immutable; shared by all sessions and by
// the actors that work for them. Made by compiler.hpp.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "runtime/base/settings.hpp"
#include "runtime/base/understanding.hpp"
#include "runtime/base/value.hpp"
#include "script/program/code.hpp"
#include "script/source/source.hpp"

namespace parlour::script {

class ConstantPool;

using TopicId = std::uint32_t;
using SlotId = std::uint32_t;
using StateId = std::uint32_t;
inline constexpr std::uint32_t no_id = 0xffffffff;

// Pseudo-slots that topic code reads as `this.rows` … (engine rule 5).
inline constexpr SlotId slot_rows = 0xfffffff0;
inline constexpr SlotId slot_asked = 0xfffffff1;
inline constexpr SlotId slot_relaxed = 0xfffffff2;

struct Cardinality {
  std::string type; // "", set, range, pattern, number, date, …, query
  std::vector<CodeId> values; // of a set
  CodeId minimum = no_code;   // of a range
  CodeId maximum = no_code;
  std::string pattern; // RE2
  std::string source;  // of a query: "db:table.column"
  Position position;
};

enum class ConfirmPolicy : std::uint8_t {
  automatic,
  explicitly,
  implicitly,
  never
};
enum class Match : std::uint8_t { equal, prefix, contains };

// <noinput count="2"> and <nomatch count="3">.
struct CountedBody {
  std::uint32_t count = 1;
  CodeId body = no_code;
};

// Bodies are no_code where the element is missing.
struct Slot {
  std::string name;
  bool functional = false;
  bool is_private = false;
  ConfirmPolicy confirm = ConfirmPolicy::automatic;
  Match match = Match::equal;
  std::string grammar;
  CodeId initial = no_code;
  CodeId question = no_code; // its text
  std::vector<CodeId> help;  // further wordings
  std::vector<CodeId> explain;
  Cardinality cardinality;
  CodeId filled = no_code;
  CodeId invalid = no_code;
  CodeId ambiguous = no_code;
  std::vector<CountedBody> no_input;
  std::vector<CountedBody> no_match;
  Position position;
};

struct QueryBy {
  SlotId slot = no_id;
  std::string column;
  Match match = Match::equal;
  std::uint32_t relax = 0; // 0: never left out
};

struct KnowledgeSource {
  std::string kind; // db, facts, aiml, ontology
  std::string name; // after the colon; may be empty
  std::string statement;
  std::uint32_t facts = no_id; // which table, of the kind facts
  std::string order;
  std::vector<QueryBy> by;
  Position position;
};

struct Constraint {
  CodeId condition = no_code;
  CodeId message = no_code;
  Position position;
};

struct Rule {
  CodeId condition = no_code;
  CodeId body = no_code;
  Position position;
};

enum class TopicKind : std::uint8_t { task, enquiry };
enum class Initiative : std::uint8_t { user, system, mixed };
enum class ResumePolicy : std::uint8_t { always, ask, never };

struct Topic {
  std::string name;
  TopicKind kind = TopicKind::task;
  Initiative initiative = Initiative::mixed;
  ResumePolicy resume = ResumePolicy::always;
  std::vector<std::string> needs;
  std::vector<Slot> slots;
  std::vector<Constraint> constraints;
  std::vector<Rule> rules;
  std::vector<KnowledgeSource> queries;
  CodeId started = no_code;
  CodeId suspended = no_code;
  CodeId resumed = no_code;
  CodeId filled = no_code;
  CodeId completed = no_code;
  CodeId cancelled = no_code;
  Position position;

  // no_id where there is none.
  SlotId slot(std::string_view slot_name) const;
  bool has_rule(CodeId body) const;
};

// One event that a handler or a state takes. `source` may be a role, a name or
// "*"; `event` may be "*".
struct Reaction {
  std::string source;
  std::string event;
  CodeId body = no_code;
  Position position;
};

struct Handler {
  std::string name;
  std::vector<Reaction> reactions;
  Position position;
};

enum class Capture : std::uint8_t { none, acts, all };

struct State {
  std::string name;
  Capture capture = Capture::none;
  std::string grammar;
  CodeId entrance = no_code;
  CodeId exit = no_code;
  std::vector<Reaction> messages;
  std::vector<Reaction> online; // source: the agent, "*" for any
  std::vector<Reaction> offline;
  Position position;
};

// <relay> and <filter> (engine rule 1); conditions see only the message.
struct Route {
  bool is_filter = false;
  std::string source;
  std::string command;
  CodeId condition = no_code;
  bool drop = false;
  std::vector<std::string> to;
  std::string as;             // empty: the command stays
  std::vector<CodeId> params; // empty: the parameters stay
  bool has_params = false;
  Position position;
};

// <facts name><fact a="…" b="…"/></facts>, read like a table.
struct FactTable {
  std::string name;
  ResultSet rows;
  TopicId topic = no_id; // the only one that sees it; no_id: all do
};

// The code takes (act, topic, slot, data) as its arguments.
struct Phrase {
  std::string act;   // required
  std::string topic; // empty: any
  std::string slot;  // empty: any
  CodeId condition = no_code;
  CodeId text = no_code;
  bool of_platform = false;
  Position position;
};

// <repair>: what is done about the conversation itself, or when nothing was
// understood or said. The code takes (data) as its argument.
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

// <var> and <const> of a script; the variable's index is its position.
struct Variable {
  std::string name;
  CodeId initial = no_code;
  bool is_constant = false;
  bool is_private = false;
};

struct Program {
  std::shared_ptr<ConstantPool> pool; // first, so that it outlives `code`
  Settings settings;
  bool single_file = false; // checked or run by itself, not in an application
  std::vector<std::string> files; // what Position::file indexes
  std::vector<Code> code;         // what CodeId indexes
  std::map<std::string, CodeId, std::less<>> functions; // session-wide
  std::vector<Variable> variables;
  std::vector<Handler> handlers;
  std::vector<State> states;
  std::vector<Topic> topics;
  std::vector<Route> routes;
  std::vector<FactTable> facts;
  std::vector<Phrase> phrases; // the application's first, then the platform's
  std::vector<Repair> repairs; // likewise
  std::vector<CodeId> ladder;  // <ladder> of the settings; empty: the standard
  std::shared_ptr<const UnderstandingModel> understanding;

  TopicId topic(std::string_view name) const; // no_id where there is none
  StateId state(std::string_view name) const;
  Place place(Position position) const;
};

// Whether a variable or slot is private="true".
bool has_private(const Program& program);

} // namespace parlour::script
