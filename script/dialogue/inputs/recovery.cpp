#include "script/dialogue/inputs/recovery.hpp"

#include <utility>

#include "script/vm/program_identity.hpp"

namespace parlour::dialogue {

namespace {

using Program = std::shared_ptr<const script::Program>;

// A session while it is repeated: counts its inputs, and gathers what its seat
// and the components may not have got.
class Recovered {
public:
  Recovered(const SessionHistory& history, Replay& replay)
      : history_(history), replay_(replay), input_(history.before),
        turns_(history.turns) {
    auto& port = replay_.port();
    port.on_output = [this](const Output& output) { turns_.release(output); };
    // Without a strict journal what was posted had left before it was kept.
    if (history.opened.strict)
      port.on_post = [this](const Message& message) {
        if (input_ > history_.posted)
          posts_.push_back(message);
      };
  }

  // One input, with the answers that it met. The turns are noted in the order
  // in which the session noted them when it was alive: input, outputs, dealt
  // with.
  Expected<void> take(const Program& program, const InputTaken& taken) {
    auto input = read_input(program, taken.input);
    if (!input)
      return tl::make_unexpected(std::move(input.error()));
    auto answers = read_answers(program, taken.answers);
    if (!answers)
      return tl::make_unexpected(std::move(answers.error()));
    ++input_;
    turns_.take(input->what);
    const auto now = input->now;
    auto taken_same = replay_.take(std::move(*input), std::move(*answers));
    turns_.dealt_with(replay_.conversation(), now);
    return taken_same;
  }

  std::uint64_t input() const {
    return input_;
  }

  // The session as it is now, once. The outcome of a request is in doubt, and
  // it is not asked again: what a <request> has posted is left out of what is
  // posted anew.
  SavedSession saved() {
    const auto& conversation = replay_.conversation();
    std::erase_if(posts_, [&](const Message& message) {
      return conversation.awaits_reply(message.correlation);
    });
    return {history_.id,         history_.opened.seed, input_,
            conversation.save(), std::move(posts_),    std::move(turns_),
            history_.opened.seat};
  }

private:
  const SessionHistory& history_;
  Replay& replay_;
  std::uint64_t input_;
  std::vector<Message> posts_;
  TurnLog turns_;
};

} // namespace

Expected<std::unique_ptr<Replay>>
replay_of(const Program& program,
          const std::shared_ptr<const PhraseEvaluator>& phrases,
          const SessionHistory& history) {
  Conversation::Options options{history.id, history.opened.seed, phrases,
                                history.opened.seat};
  if (history.state.empty())
    return std::make_unique<Replay>(program, std::move(options));
  return Replay::from(program, std::move(options), history.state);
}

// The end shows in two ways: by its record, or, where a crash came between the
// end and that record, by the conversation itself.
Expected<std::unique_ptr<SavedSession>>
recover(const Program& program,
        const std::shared_ptr<const PhraseEvaluator>& phrases,
        const SessionHistory& history) {
  if (history.closed)
    return nullptr;
  if (history.opened.program != script::identity_of(*program))
    return fail(ErrorKind::file, "it was held with other scripts");
  auto replay = replay_of(program, phrases, history);
  if (!replay)
    return tl::make_unexpected(std::move(replay.error()));
  Recovered recovered(history, **replay);
  for (const auto& input : history.inputs)
    if (auto taken = recovered.take(program, input); !taken)
      return fail(ErrorKind::file, "input " +
                                       std::to_string(recovered.input()) +
                                       ": " + taken.error().message);
  if ((*replay)->conversation().ended())
    return nullptr;
  return std::make_unique<SavedSession>(recovered.saved());
}

} // namespace parlour::dialogue
