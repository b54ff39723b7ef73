#include "tools/parlour/journal/session_replay.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "adapters/journal/journal_format.hpp"
#include "runtime/message/masking.hpp"
#include "script/dialogue/inputs/replay.hpp"
#include "script/dialogue/inputs/session_record.hpp"
#include "script/vm/program_identity.hpp"
#include "tools/parlour/talk/trace.hpp"

namespace parlour::tools {

namespace {

using dialogue::InputTaken;
using dialogue::SessionOpened;
using dialogue::SessionRecord;

// The records of one session, which views the journal.
struct Kept {
  SessionId id;
  SessionOpened opened;
  std::vector<InputTaken> taken;
};

// In the order in which the sessions were opened. An id may come twice, where
// a run with the same seed went on with the same file.
struct Journaled {
  std::vector<Kept> sessions;
  std::size_t torn = 0;
  std::optional<Error> damage;
};

Journaled read_sessions(adapters::JournalReader reader) {
  Journaled all;
  std::map<SessionId, std::size_t> place;
  while (const auto bytes = reader.next()) {
    auto record =
        *bytes ? dialogue::read_record(**bytes)
               : Expected<SessionRecord>(tl::make_unexpected(bytes->error()));
    if (!record) {
      all.damage = record.error();
      return all;
    }
    if (const auto* opened = std::get_if<SessionOpened>(&record->what)) {
      place[record->session] = all.sessions.size();
      all.sessions.push_back({record->session, *opened, {}});
    } else if (const auto found = place.find(record->session);
               found != place.end()) {
      all.sessions[found->second].taken.push_back(
          std::get<InputTaken>(std::move(record->what)));
    }
  }
  all.torn = reader.torn_bytes();
  return all;
}

class SessionReplay {
public:
  SessionReplay(const Kept& kept,
                const std::shared_ptr<const script::Program>& program,
                const std::shared_ptr<const PhraseEvaluator>& phrases,
                const ReplayWishes& wishes,
                const std::function<void(const std::string&)>& print)
      : kept_(kept), program_(program), wishes_(wishes), print_(print),
        replay_(program, {kept.id, kept.opened.seed, phrases}) {
    auto& port = replay_.port();
    port.on_output = [this](const dialogue::Output& output) {
      lines_.push_back("P: " + as_one_line(output.text));
    };
    port.on_secret = [this](const auto& texts) {
      for (const auto& text : texts)
        secrets_.add(text);
      hides_turn_ |= texts.empty();
    };
    if (wishes.trace)
      port.on_inspection = [this](const Inspection& seen) {
        lines_.push_back("    " + trace_line(seen));
      };
  }

  // Whether it was the same.
  bool run() {
    const auto count =
        std::min(kept_.taken.size(), wishes_.until.value_or(~std::size_t{0}));
    print_(fmt::format("session {}, {} inputs", kept_.id, kept_.taken.size()));
    for (std::size_t i = 0; i < count; ++i, ++inputs_)
      if (const auto same = take(kept_.taken[i]); !same) {
        show();
        print_(fmt::format("input {} differs from what was kept: {}", i + 1,
                           same.error().message));
        return false;
      }
    show();
    return true;
  }
  std::size_t inputs() const {
    return inputs_;
  }

private:
  struct Turn {
    std::size_t line;
    std::string words;
  };

  Expected<void> take(const InputTaken& taken) {
    auto input = dialogue::read_input(program_, taken.input);
    if (!input)
      return tl::make_unexpected(input.error());
    auto answers = dialogue::read_answers(program_, taken.answers);
    if (!answers)
      return tl::make_unexpected(answers.error());
    note_turn(input->what);
    auto same = replay_.take(*std::move(input), *std::move(answers));
    // Only then is known what of it is private.
    if (is_settled())
      show();
    return same;
  }

  void note_turn(const dialogue::SessionInput& what) {
    const auto* got = std::get_if<dialogue::input::Received>(&what);
    if (!got || got->message->command != "RecognitionResult" ||
        got->message->params.empty())
      return;
    turns_.push_back({lines_.size(), to_string(got->message->params.front())});
    lines_.push_back("U: " + as_one_line(turns_.back().words));
  }

  // Where the session has not dealt with a turn yet, nobody knows whether it is
  // private.
  void show() {
    const bool hides = std::exchange(hides_turn_, false) || !is_settled();
    for (const auto& turn : turns_)
      if (hides) {
        secrets_.add(turn.words);
        lines_[turn.line] = "U: ***";
      }
    turns_.clear();
    for (const auto& line : std::exchange(lines_, {}))
      print_(secrets_.masked(line));
  }

  bool is_settled() const {
    const auto& conversation = replay_.conversation();
    return !conversation.has_work() && !conversation.waits_for_answer();
  }

  const Kept& kept_;
  const std::shared_ptr<const script::Program>& program_;
  const ReplayWishes& wishes_;
  const std::function<void(const std::string&)>& print_;
  dialogue::Replay replay_;
  Secrets secrets_;
  bool hides_turn_ = false;        // what the user has just said
  std::vector<std::string> lines_; // not shown yet
  std::vector<Turn> turns_;        // of the user, among them
  std::size_t inputs_ = 0;
};

} // namespace

Expected<ReplayOutcome>
replay_sessions(std::string_view bytes,
                const std::shared_ptr<const script::Program>& program,
                const std::shared_ptr<const PhraseEvaluator>& phrases,
                const ReplayWishes& wishes,
                const std::function<void(const std::string&)>& print) {
  auto reader = adapters::JournalReader::over(bytes);
  if (!reader)
    return tl::make_unexpected(reader.error());
  const auto all = read_sessions(*std::move(reader));
  ReplayOutcome outcome;
  outcome.torn = all.torn;
  for (const auto& kept : all.sessions) {
    if (!wishes.session.empty() && kept.id != wishes.session)
      continue;
    if (kept.opened.program != script::identity_of(*program)) {
      ++outcome.others;
      continue;
    }
    SessionReplay replay(kept, program, phrases, wishes, print);
    outcome.differ += !replay.run();
    outcome.inputs += replay.inputs();
    ++outcome.sessions;
  }
  if (all.damage)
    return tl::make_unexpected(*all.damage);
  return outcome;
}

} // namespace parlour::tools
