// TopicEngine: the paper's frame manager and topic engine at work (engine
// rule 5): acts to topics, filling events, what a filled slot or frame leads
// to, which question comes next, and what happens when nobody says anything.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "script/dialogue/agenda/port.hpp"
#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/activation_runner.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/reactions.hpp"
#include "script/dialogue/context/waits.hpp"
#include "script/dialogue/output/output_manager.hpp"
#include "script/dialogue/topic_engine/asked.hpp"
#include "script/dialogue/topic_engine/pushed_states.hpp"
#include "script/dialogue/topics/classifier.hpp"

namespace parlour::dialogue {

class TopicEngine final : public OutputManager::Listener,
                          public ActivationRunner::Listener {
public:
  TopicEngine(DialogueContext& context, ActivationRunner& runner, Waits& waits,
              const Reactions& reactions, OutputManager& output,
              PushedStates& pushed_states);

  // A step that belongs to topics; it may put further ones in front.
  void take(Step&& step);
  void restart();

  // Silence has lasted: the next question, resume or reprompt.
  void silence();
  // How long silence must last now; nothing where it leads nowhere.
  std::optional<Milliseconds> silence_wanted() const;

  void released(const Output& output) override;
  void withdrawn(const Output& output) override;
  void unspoken(OutputId output) override;
  void broken_off(const Output& output, const std::string& heard) override;
  void said_again(OutputId before, OutputId now) override;
  void wait_is_over(WaitId wait) override;
  void body_failed(TopicId topic, CodeId body) override;
  // A <confirm>'s question, for the wait of its activation; about that slot,
  // or no_id.
  void confirm(std::string question, TopicId topic, SlotId slot, WaitId wait,
               TurnId turn);
  // The <confirm> that waits so is being ended.
  void forget_confirm(WaitId wait);
  // A script has set or cleared a slot: what is asked about the topic is asked
  // anew.
  void slot_changed(TopicId topic);
  // All waits, and all <confirm>s, are ended, but these (Waits::cancel).
  [[nodiscard]] StepList cancel_waits(const std::vector<WaitId>& but = {});
  // The <confirm>s of all other topics.
  std::vector<WaitId> confirms_but_of(const std::vector<TopicId>& topics) const;
  // What the body that begins puts an end to, before it runs.
  StepList overtaken_by(const Step& step);
  // What a phrase of that act sees where a script's <say> gives no data.
  Value data_of(const std::string& act, TopicId topic, SlotId slot);
  void repeat(TurnId turn); // what was heard last
  // A topic whose wait for the user is over is the current one: the steps that
  // this takes.
  StepList back_to(TopicId topic);
  // <consume/> in a reaction to what was offered with this number, also after
  // it waited.
  void consume(std::uint64_t offered) {
    consumed_.insert(offered);
  }
  bool consumed(std::uint64_t offered) const {
    return consumed_.contains(offered);
  }
  // Whether what the user says now is private in any case.
  bool asks_in_private() const;
  // Whether a script waits for this act: by a <confirm>, or in a pushed state
  // that listens to it. Who wants out is always waited for.
  bool is_waited_for(const Act& act) const;

  bool awaiting_frame() const {
    return awaiting_.has_value();
  }
  // A yes or no waited for what else might follow in the same breath, and
  // nothing did: it is queued.
  bool nothing_followed();
  // The session ends: the frame's answer is wanted no more.
  void forget_frame() {
    awaiting_.reset();
  }
  void frame_applied(FrameResult result);
  bool query_answered(QueryId id, Expected<ResultSet>& outcome);
  bool waits_for_answer() const {
    return query_.has_value();
  }

  // The context of DoNLU (runtime/base/understanding.hpp).
  Value understanding_context() const;
  void change(TopicId topic, const FrameChange& change);

private:
  struct Query {
    QueryId id = 0;
    Step step;
  };
  struct SlotOf {
    TopicId topic = script::no_id;
    SlotId slot = script::no_id;
  };

  // The steps.
  void take_act(Step& step);
  void offer_act(Step& step);
  void topic_act(Step& step);
  void no_match(Step& step);
  void not_understood(Step& step);
  void no_input(Step& step);
  void conclude(Step& step);
  void activate(Step& step);
  void fill(Step& step);
  void tell_filled(Step& step, FrameResult result);
  void filled(Step& step);
  void rule(Step& step);
  void report(Step& step);
  void settle(Step& step);
  void finish(Step& step);
  void complete(Step& step);
  void wind_up(Step& step);
  void reset(Step& step);
  void look_up(Step& step);
  void looked_up(Step& step);
  void answer(Step& step);
  void ask(Step& step);
  void ask_next(Step& step);
  void ask_still(Step& step);
  void resume_topic(Step& step);
  void ask_again(Step& step);
  void cancel(Step& step);
  void cancel_topic(Step& step);

  // Acts.
  // To the reactions that listen to source Dialogue; `otherwise` follows
  // unless one of them keeps it for itself.
  void offer(std::string command, Value parameter, Step otherwise);
  bool was_consumed(const Step& otherwise); // who offered it asks once
  // Nothing was understood: counts on the question that was asked, which
  // comes again; without one an apology, unless somebody else made it.
  void not_understood(TurnId turn, bool apologise);
  // The same, offered first to who listens to Dialogue.no_match.
  void misunderstood(Step step);
  bool is_generic(const Act& act) const;
  void generic_act(const Step& step);
  // What <repair> says is to be done; false where none does.
  struct Trouble {
    std::string_view act;
    TopicId topic = script::no_id;
    SlotId slot = script::no_id;
    std::uint32_t count = 0;
    TurnId turn = 0;
    bool refused = false; // understood, and does not fit
  };
  bool repair(const Trouble& trouble);
  Value situation(const Trouble& trouble);
  bool corrects_what_is_done(const Step& step);
  SlotId slot_asked_for(TopicId topic) const;
  void keep_what_is_asked(Step& step);
  // Whether the act might be about several topics: they are asked for.
  bool ask_which(const Step& step);
  void ask_which_again(Asked asked, OutputAct as, TurnId turn);
  // The answer to that: what was said before, about the topic that it names.
  void complete_by_answer(Step& step);
  bool asks_which() const;
  bool leaves_open_which(const Step& step);
  TopicId to_cancel() const;
  bool can_be_cancelled(TopicId topic) const;
  // Whether its <completed> waits for a yes and has done nothing so far: the
  // topic is not done yet.
  bool is_completing(TopicId topic) const;
  TopicId completing() const; // the latest such
  std::vector<TopicId> unfinished() const;

  // Questions of yes or no.
  using ConfirmPredicate = std::function<bool(const Asked&)>;
  struct Beside {             // what the same utterance says besides
    bool contradicts = false; // a no beside a yes
    bool wishes = false;      // something that comes before the answer
  };
  bool answer_to_question(const Step& step);
  void prefer_named_confirm(TopicId topic);
  bool ask_confirm_again();
  void read_answer(const Step& step);
  Beside said_beside(const Step& step) const;
  void drop_beside(const std::function<bool(const Act&)>& wanted);
  bool echoes(const Act& act) const;
  bool is_about_it(const Act& act) const;
  bool says_the_same(const Act& act) const;
  void take_answer(bool yes, TurnId turn);
  bool waits_for_more(const Step& step);
  bool joins(Step& step);
  bool still_asked(const Unsettled& answer) const;
  void answer_confirm(const Asked& asked, bool yes);
  void settle_confirmed(const Asked& asked, bool yes);
  void confirm_slot(TopicId topic, SlotId slot, bool yes, TurnId turn);
  const Asked* latest_confirm() const;   // null: none
  bool wants_a_yes(TopicId topic) const; // a <confirm> of its waits
  bool asked_here() const;               // not below a pushed state
  bool confirms_first(const Step& step);
  void note_question_before(Asked& asked, TurnId turn) const;
  void back_to_question_before(const Asked& asked);
  bool may_be_answered(const Asked& asked) const;
  void forget_question(const Asked& confirm);
  // The steps that end them, with kind Cancelled.
  StepList end_confirms(const ConfirmPredicate& wanted);
  StepList end_confirms_of(TopicId topic);
  StepList overtaken_by_filling(TopicId topic);
  // A script of the topic ended with an error, or with a no: the topic is not
  // completed after all, where the script leads there.
  void note_refusal(TopicId topic, CodeId body, std::uint64_t told);
  void doubt_earlier_value(TopicId topic, SlotId slot);
  void heed_denial(TopicId topic, SlotId slot);
  bool gives_up(const Refusal& refusal) const;
  std::vector<Refusal> take_refusals(TopicId topic);
  bool is_dealt_with(const Refusal& refusal) const;
  bool heeds_refusals(const Step& step);

  // Topics.
  void begin_topic(TopicId topic, StepList& steps, bool keep = false);
  void begin_needs(TopicId topic, StepList& steps);
  void suspend(TopicId topic, StepList& steps);
  void take_up(TopicId topic);
  void answer_resume(TopicId topic, bool yes, TurnId turn);
  void rest(TopicId topic);
  void set_status(TopicId topic, TopicStatus status);
  TopicId needed_by(TopicId topic) const;
  void leave_enquiry(TopicId next);
  List unfinished_names() const;

  // Frames.
  void request(Step&& step, std::vector<FrameChange>& changes);
  void note_changes(const Step& step, std::vector<FrameChange>& changes) const;
  FrameChange inherit(const Step& step) const;
  Value refusal(TopicId topic, const SlotReport& report);
  void inspect_report(TopicId topic, const SlotReport& report);
  bool asks_for_refused(const Step& step);
  void settle_enquiry(Step& step);
  void answer_enquiry(const Step& step);
  void look_up_facts(Step& step);
  void refuse_source(Step& step);
  SlotId missing(TopicId topic) const;
  SlotId doubtful(TopicId topic) const;

  // Whether a slot may be asked for because it is missing.
  bool may_ask(TopicId topic) const;

  // Questions.
  // What silence leads to.
  enum class Due : std::uint8_t {
    nothing,
    reprompt,     // the question that was heard
    again,        // the one that was withdrawn
    confirmation, // a <confirm>'s, that others were put in front of
    question,     // the current topic's next
    state,        // nothing is asked, but the state listens to silence
    topic,        // another topic
  };
  Due due() const;
  bool state_listens() const;
  void ask_what_misses(OutputAct as, TurnId turn); // of the current topic
  SlotId to_ask(TopicId topic) const;
  bool waits_for_user(TopicId topic) const;
  void ask_again();
  void unmark(TopicId topic);
  void ask_slot(TopicId topic, SlotId slot, OutputAct as, TurnId turn);
  Value with_type(Map data, TopicId topic, SlotId slot) const;
  void ask_confirmation(TopicId topic, SlotId slot, TurnId turn);
  void ask_choice(TopicId topic, SlotId slot, TurnId turn, bool aloud);
  void put(Asked&& asked, const char* act, Value data, std::string text,
           OutputAct as, TurnId turn);
  void reprompt(TurnId turn, bool heard_something);
  void climb(const Trouble& trouble);
  bool run_own_words(const Trouble& trouble);
  std::uint32_t count_miss(bool heard_something);
  void climb_own(const Trouble& trouble);
  // An answer that does not fit counts as one that was not understood.
  void count_refusal(TopicId topic, SlotId slot);
  bool climb_after_refusal(TopicId topic, SlotId slot, TurnId turn);
  // Never silent: a topic that may not ask has heard what was said.
  void acknowledge_unasked(TurnId turn);
  void repeat_question(TurnId turn);
  Value choices_of(TopicId topic, SlotId slot);
  std::string text_of(CodeId code, TopicId topic);
  void say(const char* act, TopicId topic, SlotId slot, Value data,
           TurnId turn);
  Value with_marks(TopicId topic, Value data) const;
  void say_text(std::string text, TurnId turn);

  ClassifierContext classifier_context() const;
  const std::string* yes_or_no_asked() const;
  List names_said_before(SlotId asked) const;
  const std::string& narrowing_grammar(const ClassifierContext& context) const;
  void note_what_was_said(const Step& step);
  void conceal_values(const Act& act);
  void run_body(CodeId code, TopicId topic, SlotId slot, TurnId turn,
                StepList& steps) const;

  DialogueContext& context_;
  ActivationRunner& runner_;
  Waits& waits_;
  const Reactions& reactions_;
  OutputManager& output_;
  PushedStates& pushed_states_;
  std::vector<bool> listens_to_silence_; // each state
  std::optional<Asked> asked_;
  std::optional<SlotOf> refused_; // by this act, though it had been asked for
  struct Said {
    TopicId topic = script::no_id;
    std::vector<SlotId> slots;
  } said_; // what the user gave values for last, fitting or not
  struct TurnOf {
    TopicId topic = script::no_id;
    TurnId turn = 0;
  } spoken_of_;                      // what the latest utterance was about
  std::vector<FrameChange> changes_; // empty between two steps: its memory
  std::optional<Step> awaiting_;     // for the frame's actor
  std::optional<Query> query_;
  TurnId turn_ = 0;               // the latest
  std::uint64_t said_before_ = 0; // outputs that were made before that
  std::vector<Asked> confirms_;   // <confirm>s that wait, innermost last
  std::optional<Unsettled> unsettled_;
  std::vector<Refusal> refusals_; // that a topic has not settled with yet
  std::optional<Act> late_;       // a correction of a completed topic
  Timestamp completed_at_ = 0;    // the latest one
  int no_input_ = 0;              // unanswered questions in a row
  std::uint32_t misses_ = 0;  // not understood in a row, nothing being asked
  std::uint64_t offered_ = 0; // acts and the like, counted
  std::set<std::uint64_t> consumed_; // of these
};

} // namespace parlour::dialogue
