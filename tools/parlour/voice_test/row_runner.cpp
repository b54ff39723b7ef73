// In virtual time the microphone moves the clock, 20 ms at a time.
#include "tools/parlour/voice_test/row_runner.hpp"

#include <algorithm>
#include <functional>

#include "adapters/audio/file_speaker.hpp"
#include "tools/parlour/application/data_folder.hpp"
#include "tools/parlour/application/node_options.hpp"
#include "tools/parlour/conversation_test/conversation_runner.hpp"
#include "tools/parlour/conversation_test/directive_reader.hpp"
#include "tools/parlour/talk/trace.hpp"
#include "tools/parlour/voice_test/user_microphone.hpp"

namespace parlour::tools {

namespace {

// All in virtual time.
constexpr Milliseconds longest_turn{60'000};
constexpr Milliseconds robot_talks_at_most{120'000};
// After the robot has spoken the user takes so long to answer.
constexpr Milliseconds before_answer{300};
// Speech in which no turn was found is over after so long.
constexpr Milliseconds unheard{2'500};
// The next line of a row cuts in so long after the robot's first sound, or
// after this if the robot is silent.
constexpr Milliseconds before_cut{600};
constexpr Milliseconds before_next_line{1'500};

bool has_role(const ChosenComponent& component, const std::string& role) {
  return std::ranges::count(component.factory.description.roles, role) > 0;
}

// The application with the user's microphone, and a speaker whose file goes
// with the data folder.
Composition for_user(Composition composition,
                     const std::shared_ptr<UserSound>& user,
                     const std::filesystem::path& data,
                     const Speaking& speaking) {
  composition = rehearsed(std::move(composition));
  for (auto& component : composition.components) {
    const auto plugin = component.factory.description.name;
    for (const auto& option : component.factory.description.options)
      if (option.name == "conversations" && !speaking.told)
        component.options[option.name] = "none";
    if (plugin == "FileMicrophone") {
      component.factory = user_microphone_factory(user);
      component.options.clear();
    } else if (plugin == "FileSpeaker") {
      component.factory = adapters::file_speaker_factory(data / "robot.wav");
    } else if (speaking.recognisers && has_role(component, "ASR")) {
      component.factory = speaking.recognisers->keep(
          component.name, std::move(component.factory),
          forgetting_of_recognisers());
    }
  }
  return composition;
}

class RowRunner {
public:
  RowRunner(const Application& application, const Conversation& conversation)
      : application_(application), conversation_(conversation) {}

  RowRunner& by_voice(const Speaking& speaking,
                      const std::vector<Row>& expected, std::size_t typed) {
    speaking_ = &speaking;
    expected_ = &expected;
    typed_ = typed;
    user_ = std::make_shared<UserSound>(speaking.noise);
    return *this;
  }

  RowsHeld run() {
    if (start())
      hold();
    node_ = nullptr;
    return std::move(held_);
  }

private:
  bool start() {
    auto data = DataFolder::temporary();
    if (!data)
      return give_up(data.error());
    data_.emplace(std::move(*data));
    const auto composition = user_ ? for_user(application_.composition, user_,
                                              data_->path(), *speaking_)
                                   : rehearsed(application_.composition);
    auto options = node_options(
        application_, composition,
        {data_->path().string(), conversation_.start, conversation_.seed});
    options.on_inspection = [this](const Inspection& seen) { log_.note(seen); };
    options.exact_inspections = true;
    auto node = actors::Node::start(std::move(options));
    if (!node)
      return give_up(node.error());
    node_ = std::move(*node);
    seat_ = node_->open_seat(
        {[this](const SessionId&, const dialogue::Output& output) {
           log_.released(output.id,
                         std::string(trimmed(as_one_line(output.text))));
         },
         {}});
    node_->open(seat_);
    return true;
  }

  bool give_up(const Error& error) {
    held_.trouble = to_string(error);
    return false;
  }

  // -- the steps --------------------------------------------------------------

  void hold() {
    for (const auto& step : conversation_.steps) {
      if (step.kind == StepKind::user) {
        lines_.push_back(&step);
        continue;
      }
      if (!lines_.empty() && !enter_row())
        return;
      take(step);
    }
    if (lines_.empty() || enter_row())
      (void)close_row();
  }

  void take(const Step& step) {
    switch (step.kind) {
    case StepKind::robot:
    case StepKind::robot_pattern:
      ++awaited_;
      return until([this] { return log_.answers().size() >= awaited_; },
                   longest_silence);
    case StepKind::wait:
      settle();
      return node_->advance(step.duration);
    case StepKind::clock:
      settle();
      if (step.time > node_->now())
        node_->advance(Milliseconds(step.time - node_->now()));
      return;
    case StepKind::event:
      return inject(step);
    default: // expectations are those of the run by text
      return;
    }
  }

  void inject(const Step& step) {
    Message message;
    message.source = step.target;
    message.command = step.command;
    message.params = step.params;
    node_->inject(node_->session_at(seat_), std::move(message));
  }

  // The user's lines, after what came of those before. False: the conversation
  // has taken another way than by text.
  bool enter_row() {
    if (!close_row())
      return false;
    auto& row = held_.rows.emplace_back();
    row.line = lines_.front()->line;
    for (const auto* line : lines_)
      row.said.push_back(line->text);
    lines_.clear();
    log_.begin_row();
    awaited_ = 0;
    if (is_spoken())
      speak(row);
    else
      node_->enter(seat_, row.said);
    return true;
  }

  bool is_spoken() const {
    return user_ && held_.rows.size() > typed_;
  }

  // True if there is no row yet, or it went as expected.
  bool close_row() {
    settle();
    if (held_.rows.empty())
      return true;
    auto& row = held_.rows.back();
    row.heard = log_.heard();
    row.understood = log_.understood();
    row.answers = log_.answers();
    row.latencies = log_.latencies();
    return !is_spoken() || (held_.rows.size() <= expected_->size() &&
                            row.is_as((*expected_)[held_.rows.size() - 1]));
  }

  // -- speaking ---------------------------------------------------------------

  void speak(const Row& row) {
    pass(before_answer);
    for (std::size_t i = 0; i < row.said.size(); ++i) {
      if (i > 0)
        cut_in();
      say(row.said[i]);
    }
  }

  void say(const std::string& text) {
    const auto turns = log_.recognised();
    user_->say(*speaking_->bank->find(text, speaking_->voice));
    until([this] { return user_->is_silent(); }, longest_turn);
    log_.line_ended(node_->now());
    const auto end = node_->now() + unheard.count();
    until(
        [&] {
          return !log_.in_turn() &&
                 (log_.recognised() > turns || node_->now() >= end);
        },
        longest_turn);
  }

  // In the middle of what the robot says, if it says something.
  void cut_in() {
    until([this] { return log_.robot_sounds(); }, before_next_line);
    pass(before_cut);
  }

  // -- time -------------------------------------------------------------------

  // Lets time pass until it holds, or nothing is due for so long.
  void until(const std::function<bool()>& holds, Milliseconds at_most) {
    const auto end = node_->now() + at_most.count();
    node_->run_until_quiet();
    while (!holds() && node_->now() < end &&
           node_->step_to_next_due(Milliseconds(end - node_->now()))) {
    }
  }

  void pass(Milliseconds time) {
    node_->advance(time);
    node_->run_until_quiet();
  }

  // By voice, the robot speaks to the end of what it says now.
  void settle() {
    node_->run_until_quiet();
    if (user_)
      until([this] { return !log_.robot_speaks(); }, robot_talks_at_most);
  }

  const Application& application_;
  const Conversation& conversation_;
  const Speaking* speaking_ = nullptr;
  const std::vector<Row>* expected_ = nullptr;
  std::size_t typed_ = 0;
  std::shared_ptr<UserSound> user_; // null: by text
  TurnLog log_;
  RowsHeld held_;
  std::vector<const Step*> lines_; // of the row that is read
  std::size_t awaited_ = 0;        // answers, by `R:`
  actors::SeatId seat_;
  std::optional<DataFolder> data_; // must outlive the node
  std::unique_ptr<actors::Node> node_;
};

} // namespace

std::string unspeakable(const Conversation& conversation) {
  for (const auto& step : conversation.steps)
    if (step.kind == StepKind::partial || step.kind == StepKind::barge_in)
      return "line " + std::to_string(step.line) +
             " says what a recogniser or a speaker reports";
  return {};
}

RowsHeld hold_by_text(const Application& application,
                      const Conversation& conversation) {
  return RowRunner(application, conversation).run();
}

RowsHeld hold_by_voice(const Application& application,
                       const Conversation& conversation,
                       const Speaking& speaking,
                       const std::vector<Row>& expected, std::size_t typed) {
  return RowRunner(application, conversation)
      .by_voice(speaking, expected, typed)
      .run();
}

} // namespace parlour::tools
