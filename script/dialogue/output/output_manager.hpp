// OutputManager: how what the engine wants to say becomes words, and when they
// leave (engine rule 3; understanding, "Phrases"). If an NLG component is
// there, a `say` goes to it as Generate, and its Speak event brings the words
// back, by a handler's <speak> or by itself; if not, the phrase is spoken
// directly. What is released goes to the session's seat, and to a TTS component
// if one is there.
//
// For example, the topic Appointment misses its time: say({question,
// "question", Appointment, Time, …}) makes an entry that waits for its words.
// NLG.Speak brings "What's the time of your appointment?". With the next input
// the entry leaves, or, if the visitor has begun to speak, is withdrawn.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "script/dialogue/agenda/output_queue.hpp"
#include "script/dialogue/agenda/timers.hpp"
#include "script/dialogue/context/apologies.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/messenger.hpp"
#include "script/dialogue/context/open_question.hpp"
#include "script/dialogue/context/reactions.hpp"

namespace parlour::dialogue {

// What the engine wants to say: a phrase by act, topic and slot, or a text.
// Made by whoever asks or answers; the manager makes an Output of it.
struct Say {
  OutputAct as = OutputAct::answer;
  // Of the phrase, such as "question" or "answer"; unused where `text` is
  // given.
  std::string act;
  TopicId topic = script::no_id;
  SlotId slot = script::no_id;
  // What the phrase may use, as `data`.
  Value data;
  std::string text;
  // The user turn that it answers; 0: none.
  TurnId turn = 0;
  bool awaited = false; // a script waits for the answer
  bool interruptible = true;
};

// Owned by ConversationImplementation. It words, releases and withdraws;
// whether a question is open is known by OpenQuestion, which is told what
// became of its words.
class OutputManager {
public:
  OutputManager(DialogueContext& context, const Reactions& reactions,
                Messenger& messenger, Timers& timers, OpenQuestion& question)
      : context_(context), reactions_(reactions), messenger_(messenger),
        timers_(timers), question_(question) {}

  // Returns the entry's id; 0 where there are no words for it (no phrase fits,
  // which is shown). With NLG the words may still turn out to be missing later.
  OutputId say(Say&& what);
  // A <speak>. Where it handles the Speak event of a `say`, it words that
  // entry, else it is an answer.
  OutputId speak(std::string text, Correlation handled, TurnId turn,
                 bool interruptible);
  // The handlers of an NLG event are done: an entry that none of them worded
  // takes the event's own text, or is dropped where a handler that names the
  // event took it.
  // Any other event that ends the request means that there are no words to
  // come.
  void handled(const Message& event, bool taken);
  // An event that nobody is to handle any more; what hangs on it goes on.
  void drop(const Input& input);
  // Where the event tells of a phrase that could not be computed: shown, and
  // raised as Script.Error for who listens to it. False: the event is another
  // one.
  bool hear_failure(const Message& event, TurnId turn);
  // The NLG component did not answer in time. The phrase is used then.
  void give_up_wording(Correlation correlation);

  // Whether one more apology is due; then it counts as made.
  bool may_apologise() {
    return apologies_.due(context_.now);
  }
  void user_speaks() {
    apologies_.user_speaks();
  }
  // With another port: words that were asked for and have not come are asked
  // for again, and what was not heard to its end is said again. What belongs to
  // an earlier turn of the robot counts as heard.
  void resume();

  // Releases what can go, and withdraws questions where a user turn is open;
  // returns whether anything was released.
  bool release();
  // Also those that still wait for their words (engine rule 3.5).
  void withdraw_questions();
  // What was heard of the robot's last turn, again.
  void repeat_last(TurnId turn);
  // The user has spoken, or been silent: what is released from now on is
  // another robot turn.
  void turn_begins() {
    queue_.turn_begins();
    failed_phrases_.clear();
  }
  // Nothing goes on since now, unless it did not before either.
  void falls_silent() {
    if (!silent_since_)
      silent_since_ = context_.now;
  }
  // Something happens: after a silence that is long enough to be no answer,
  // what it leads to is another robot turn (engine rule 3.6).
  void event_begins();
  bool said_anything() const {
    return !queue_.last_turn().empty();
  }
  // An output was played to its end, or shown where there is no voice.
  void finished(OutputId id);
  // Voice or loudspeaker has given up: nothing is being played any more.
  void voice_failed();
  // Whether outputs are played by a loudspeaker, which tells when it has
  // finished.
  bool is_voiced() const;
  // The user broke in: of this output only these words were heard; an empty
  // text: none of it.
  void interrupted(OutputId id, const std::string& heard);
  // The user has said something after all: what was broken off stays so.
  void give_up_interrupted() {
    interrupted_.clear();
  }
  bool was_interrupted() const {
    return !interrupted_.empty();
  }
  // Nothing came of it: what was broken off is said again, a few times in a
  // row at most, as what breaks in may be a noise that does not end.
  void take_up_interrupted();
  // Whether something is being played that the user may break in on.
  bool can_be_interrupted() const;

  // Something has changed in the queue since the last release().
  bool wants_release() const {
    return changed_;
  }
  // The queue is empty: nothing waits for words or release.
  bool all_released() const {
    return queue_.empty();
  }
  bool waits_for_words() const {
    return !wording_.empty();
  }
  bool plays() const {
    return !playing_.empty();
  }
  // Nothing waits for words or release, and nothing is being played.
  bool silent() const;
  // How many outputs were made so far: who compares two counts knows whether
  // anything was said in between.
  std::uint64_t spoken() const {
    return made_;
  }
  // Of these, how many were answers.
  std::uint64_t told() const {
    return told_;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, reactions_, messenger_, timers_, question_);
    archive(queue_, wording_, uses_, made_, told_, failed_phrases_, playing_,
            interrupted_, taken_up_, changed_, apologies_, silent_since_);
  }

private:
  // An entry whose words an NLG component was asked for.
  struct Wording {
    OutputId output = 0;
    Value params; // to word it ourselves after all
    // The TimerId of its time-out; 0: the answer had come at once.
    std::uint64_t timer = 0;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(output, params, timer);
    }
  };

  OutputId push(OutputAct as, std::string text, const Say& what,
                OutputState state);
  Value generate_params(const Say& what);
  void ask_for_words(OutputId id, Value params, TurnId turn);
  void ask_again_for_words();
  std::string words_of(const Value& params, TurnId turn);
  void phrase_failed(const Error& error, TurnId turn);
  void word(OutputId id, std::string text);
  void voice(const Output& output);
  void inspect(const Output& output, const char* what);
  void no_longer_playing(OutputId id);

  DialogueContext& context_;
  const Reactions& reactions_;
  Messenger& messenger_;
  Timers& timers_;
  OpenQuestion& question_;
  OutputQueue queue_;
  std::map<Correlation, Wording> wording_;
  // How often each act was said about each topic ("question/Appointment"), for
  // the rotation of wordings.
  std::map<std::string, std::int64_t> uses_;
  std::uint64_t made_ = 0;
  std::uint64_t told_ = 0;
  // Told of in this robot turn: who listens may have said them himself.
  std::vector<SourceLocation> failed_phrases_;
  struct Playing {
    OutputId id = 0;
    bool interruptible = true;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(id, interruptible);
    }
  };
  // What has left and was not told to be finished.
  ShortLivedList<Playing> playing_;
  // What was broken off and may be said again, with the words that are then
  // said.
  std::vector<Output> interrupted_; // in the order in which they were said
  int taken_up_ = 0;                // since something was played to its end
  // A release is worth while.
  bool changed_ = false;
  Apologies apologies_;
  // Since the last release; none: it was not silent yet.
  std::optional<Timestamp> silent_since_;
};

} // namespace parlour::dialogue
