// Conversation::Implementation: what happens with each input. An internal
// header of this folder; the door is conversation.hpp.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "script/dialogue/context/activation_runner.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/reactions.hpp"
#include "script/dialogue/context/waits.hpp"
#include "script/dialogue/engine/answers.hpp"
#include "script/dialogue/engine/conversation.hpp"
#include "script/dialogue/engine/effect_handler.hpp"
#include "script/dialogue/engine/lane_entry.hpp"
#include "script/dialogue/engine/pipeline.hpp"
#include "script/dialogue/engine/sockets.hpp"
#include "script/dialogue/engine/state_machine.hpp"
#include "script/dialogue/output/output_manager.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"

namespace parlour::dialogue {

class Conversation::Implementation final : private Waits::Others {
public:
  Implementation(std::shared_ptr<const script::Program> program,
                 Options options, Port& port);

  void open();
  void receive(std::shared_ptr<const Message> message);
  void take_acts(std::span<const ActPointer> acts);
  bool has_work();
  void take_input();
  // A new external event: what scripts may do is counted anew.
  void begin_event();
  // After each input: the lane runs as far as it can; what silence leads to.
  void go_on();
  void timer_fired(TimerId id);
  void close();
  std::vector<Message> take_unread();

  // The parts, each of which knows those that it was made with.
  DialogueContext context;
  Reactions reactions;
  ActivationRunner runner;
  Waits waits;
  OutputManager output;
  TopicEngine topics;
  StateMachine machine;
  LaneEntry entry;
  Answers answers;
  ScriptSockets sockets;
  Pipeline pipeline;
  EffectHandler effects;

private:
  struct Watch {
    TimerId id = 0;
    Timer::Purpose purpose = Timer::Purpose::silence;
    Milliseconds length{0};
  };

  void resume_in_pipeline(WaitId wait, Expected<Value> outcome) override;
  std::vector<WaitId> waits_in_pipeline() const override;
  void forget_request(WaitId wait) override;

  StepList beginning() const;
  Fifo<Input>::Place next_input();
  void process(Input&& input);
  void user_begins();
  bool hear_speech(const Message& message);
  bool hear_speaker(const Message& message);
  void act_on(Timer timer);
  void ring(Timer timer);
  void run_lane();
  void drop_what_was_too_much();
  void take(Step&& step);
  void run_body(Step&& step);
  void resume(Step&& step);
  void started(WaitId wait);
  void start_over();

  void leave();
  void take_internal();
  bool at_rest() const;
  void finish();
  void tell_lost_timers();
  void give_up_turns();

  void watch_silence();
  void watch_nobody();
  void watch_for(Milliseconds length, Timer::Purpose purpose);
  void stop_silence();

  // The session's end: its Exits run, then Session.Ended has been told.
  enum class Leaving : std::uint8_t { no, exits, told };

  std::optional<Watch> watch_;
  Leaving leaving_ = Leaving::no;
};

} // namespace parlour::dialogue
