#include "tools/parlour/journal/session_replay.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "runtime/message/masking.hpp"
#include "runtime/message/roles.hpp"
#include "script/dialogue/inputs/recovery.hpp"
#include "script/vm/program_identity.hpp"
#include "tools/parlour/talk/trace.hpp"

namespace parlour::tools {

namespace {

using dialogue::InputTaken;
using dialogue::SessionHistory;

// One session's repetition. Lines are held back until the session has settled,
// as only then all of what is private in them is known; then they are printed
// with `***`.
//
//   take()     the kept input goes to the conversation, with the kept answers
//   note()     what the user said becomes a line that may still be hidden
//   on_output  what the robot says becomes a line
//   show()     the session has settled: secrets are known, lines are printed
class SessionReplay {
public:
  SessionReplay(const SessionHistory& kept, dialogue::Replay& replay,
                const std::shared_ptr<const script::Program>& program,
                const ReplayWishes& wishes,
                const std::function<void(const std::string&)>& print)
      : kept_(kept), replay_(replay), program_(program), wishes_(wishes),
        print_(print), form_(wishes.form) {
    auto& port = replay_.port();
    port.on_output = [this](const dialogue::Output& output) {
      add(form_.robot(place_, output.text));
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
  // The first input that leads to something else ends it: what follows would
  // differ because of that.
  bool run() {
    const auto count =
        std::min(kept_.inputs.size(), wishes_.until.value_or(~std::size_t{0}));
    place_.input = kept_.before;
    for (std::size_t i = 0; i < count; ++i, ++inputs_)
      if (const auto same = take(kept_.inputs[i]); !same) {
        show();
        print_(fmt::format("input {} differs from what was kept: {}",
                           kept_.before + i + 1, same.error().message));
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
    LinePlace place;
    std::string words;
  };

  void add(const SessionLines::Lines& lines) {
    lines_.insert(lines_.end(), lines.begin(), lines.end());
  }

  // The time of each input is the kept one: the conversation asks no clock.
  Expected<void> take(const InputTaken& taken) {
    auto input = dialogue::read_input(program_, taken.input);
    if (!input)
      return tl::make_unexpected(input.error());
    auto answers = dialogue::read_answers(program_, taken.answers);
    if (!answers)
      return tl::make_unexpected(answers.error());
    if (place_.input == kept_.before)
      add(form_.heading(kept_, input->now));
    ++place_.input;
    place_.now = input->now;
    note(input->what);
    auto same = replay_.take(*std::move(input), *std::move(answers));
    // Only then is known what of it is private.
    if (is_settled())
      show();
    return same;
  }

  // A message that answers something, or that the platform raised, follows from
  // others: in a test it would come by itself, so it is no line there.
  void note(const dialogue::SessionInput& what) {
    const auto* got = std::get_if<dialogue::input::Received>(&what);
    if (!got)
      return add(form_.other(place_, dialogue::name_of(what)));
    const auto& message = *got->message;
    if (message.command == "RecognitionResult" && !message.params.empty()) {
      auto words = to_string(message.params.front());
      add(form_.user(place_, words));
      turns_.push_back({lines_.size() - 1, place_, std::move(words)});
      return;
    }
    const auto* role = find_role(message.source);
    if (message.correlation == 0 && !(role && role->reserved))
      add(form_.event(place_, message));
    else
      add(form_.other(place_, dialogue::name_of(what)));
  }

  // Where the session has not dealt with a turn yet, nobody knows whether it is
  // private.
  // Words of a turn that is private are secrets for the lines after it, too.
  void show() {
    const bool hides = std::exchange(hides_turn_, false) || !is_settled();
    for (const auto& turn : turns_)
      if (hides) {
        secrets_.add(turn.words);
        lines_[turn.line] = form_.hidden(turn.place);
      }
    turns_.clear();
    for (const auto& line : std::exchange(lines_, {}))
      print_(secrets_.masked(line));
  }

  // While an answer is to come, the script may still say that the turn is
  // private.
  bool is_settled() const {
    const auto& conversation = replay_.conversation();
    return !conversation.has_work() && !conversation.waits_for_answer();
  }

  const SessionHistory& kept_;
  dialogue::Replay& replay_;
  const std::shared_ptr<const script::Program>& program_;
  const ReplayWishes& wishes_;
  const std::function<void(const std::string&)>& print_;
  SessionLines form_;
  LinePlace place_; // the input that is taken
  Secrets secrets_;
  bool hides_turn_ = false;        // what the user has just said
  std::vector<std::string> lines_; // not shown yet
  std::vector<Turn> turns_;        // of the user, among them
  std::size_t inputs_ = 0;
};

} // namespace

ReplayOutcome
replay_sessions(const std::vector<dialogue::SessionHistory>& sessions,
                const std::shared_ptr<const script::Program>& program,
                const std::shared_ptr<const PhraseEvaluator>& phrases,
                const ReplayWishes& wishes,
                const std::function<void(const std::string&)>& print) {
  ReplayOutcome outcome;
  for (const auto& kept : sessions) {
    if (!wishes.session.empty() && kept.id != wishes.session)
      continue;
    if (kept.opened.program != script::identity_of(*program)) {
      ++outcome.others;
      continue;
    }
    ++outcome.sessions;
    const auto replay = dialogue::replay_of(program, phrases, kept);
    if (!replay) {
      print(fmt::format("session {}: {}", kept.id, replay.error().message));
      ++outcome.differ;
      continue;
    }
    SessionReplay session(kept, **replay, program, wishes, print);
    outcome.differ += !session.run();
    outcome.inputs += session.inputs();
  }
  return outcome;
}

} // namespace parlour::tools
