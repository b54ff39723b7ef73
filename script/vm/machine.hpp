// Machine: the inside of an interpreter. Frames live on the heap, exactly as
// large as their code needs, so that suspending is to keep a pointer. One
// session's machine is used by one thread at a time.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "script/values/operations.hpp"
#include "script/vm/interpreter.hpp"

#if defined(__GNUC__)
#define PARLOUR_INLINE [[gnu::always_inline]] inline
#else
#define PARLOUR_INLINE inline
#endif

namespace parlour::script {

// One call in progress. The frame above stays for the next call when its own
// call ends; its registers are unknown then.
struct Frame {
  const Code* code;
  Frame* caller;
  const Instruction* pc;  // the one being carried out
  Frame* above;           // null: not made yet
  std::uint32_t capacity; // registers that there is room for
  std::uint32_t depth;    // from 1

  Box* registers() {
    return reinterpret_cast<Box*>(this + 1);
  }
  static Frame* of(Box* registers) {
    return reinterpret_cast<Frame*>(registers) - 1;
  }
  void clear() {
    const auto* end = registers() + code->register_count;
    for (auto* box = registers(); box != end; ++box)
      *box = Box();
  }
};

// A by-reference parameter whose callee waited: its value goes back to the
// session variable when that frame ends (language rule 7.3).
struct CopyOut {
  Frame* frame;
  std::uint16_t parameter;
  std::uint32_t variable;
};

class Execution : public Activation {
public:
  Execution(std::shared_ptr<Heap> heap, ActivationContext context)
      : Activation(std::move(context)), heap_(std::move(heap)) {}
  ~Execution() override;

  void begin(ActivationContext context) { // one that has finished
    set_context(std::move(context));
  }
  // A new top frame; its registers are unknown. Not deeper than the caller
  // of this checks. A new one has room for so many more registers.
  Frame* push(const Code& code, std::uint32_t room = 0);
  void pop(); // the top frame
  // While it waits or has yielded it holds no frames but those in use, so that
  // what it holds is the same once its state was written and read back.
  void release_above();

  Frame* top = nullptr;
  bool waiting = false;
  std::unique_ptr<std::vector<CopyOut>> copy_outs; // null: none

private:
  Frame* make_above(std::uint32_t registers);
  void release(Frame* frame); // and those above

  std::shared_ptr<Heap> heap_;
};

// Why the dispatch loop was left.
enum class Stop : std::uint8_t { none, finished, waiting, yielded, failed };

// What an event may still use.
struct EventFuel {
  std::uint64_t instructions = 0; // of one event
  std::uint64_t left = 0;
  bool grace_given = false; // the cleaning up after a limit
};

class Machine {
  std::shared_ptr<Heap> heap_; // first: it outlives every box below

public:
  explicit Machine(std::shared_ptr<const Program> shared_program);

  // Runs the activation until it stops.
  RunResult run(Execution& activation, Host& current_host, bool to_the_end);
  // One that was just started; nothing where it finished.
  std::optional<RunResult> run_body(Execution& activation, Host& current_host);
  RunResult resume(Execution& activation,
                   const Expected<Value>& outcome_of_wait, Host& current_host);
  std::unique_ptr<Execution> start(CodeId body,
                                   const std::vector<Value>& values,
                                   ActivationContext context);
  // One that has finished is used again.
  void keep_spare(std::unique_ptr<Execution> finished) {
    finished->begin({}); // what it belonged to is let go
    spare_ = std::move(finished);
  }

  std::unique_ptr<Execution> adopt(ActivationContext context);

  void new_event();
  EventFuel event_fuel() const {
    return {instructions, left_, grace_given_};
  }
  void set_event_fuel(const EventFuel& event_fuel);

  // -- for operations and built-ins -------------------------------------------
  bool raise(ErrorKind kind, std::string message); // always false
  bool raise(Failure failure);
  bool raise_box(const Box& error_or_value);
  bool check(Outcome outcome); // false: raised
  bool within_limits();        // false: raised
  // Counts work beyond the instruction's own; false: raised.
  bool charge(std::size_t units) {
    fuel -= static_cast<std::int64_t>(units);
    return fuel > 0 || goes_on_beyond_slice();
  }
  // Boxes looked at that count as one instruction.
  static constexpr std::size_t boxes_per_unit = 4;
  // How many boxes may still be compared or copied: as many as the fuel allows,
  // and no more than a session may hold.
  std::size_t walk_budget() const;

  Heap& heap() {
    return *heap_;
  }

  // -- slow ways of the instructions (machine_operations.cpp) -----------------
  bool add(const Box& left, const Box& right, Box& result);
  bool arithmetic(Arithmetic operation, const Box& left, const Box& right,
                  Box& result);
  bool negate(const Box& operand, Box& result);
  bool equal(const Box& left, const Box& right, bool& result);
  bool order(const Box& left, const Box& right, Order& result);
  bool contained(const Box& element, const Box& container, Box& result);
  bool get_index(const Box& container, const Box& key, Box& result);
  bool get_field(const Box& container, const Box& name, Box& result);
  bool set_index(const Box& container, const Box& key, const Box& value);
  bool append(const Box& list, const Box& value);
  bool new_list(const Box* elements, std::size_t count, Box& result);
  bool new_map(const Box* pairs, std::size_t count, Box& result);
  bool new_array(const Box& size, Box& result);
  bool concatenate(const Box* parts, std::size_t count, Box& result);
  bool milliseconds(const Box& text, Box& result);
  bool for_prepare(Box* loop, bool& enters);
  bool for_next(Box* loop);
  bool each_prepare(const Box& collection, Box* loop);

  // -- calls, effects, the world (machine_calls.cpp) --------------------------
  // The callee's frame; null: raised.
  PARLOUR_INLINE Frame* enter(Frame* caller, const Code& callee, Box* arguments,
                              std::size_t count) {
    auto* frame = caller->above;
    if (!frame || frame->capacity < callee.register_count) [[unlikely]] {
      if (!may_call(callee))
        return nullptr;
      frame = execution->push(callee);
    }
    frame->code = &callee;
    frame->pc = callee.instructions.data();
    execution->top = frame;
    auto* registers = frame->registers();
    for (std::size_t i = 0; i < count; ++i)
      registers[i].take(arguments[i]);
    if (callee.body > 0) [[unlikely]] // has defaults
      for (auto i = count; i < callee.parameter_count; ++i)
        registers[i] = Box::missing();
    return frame;
  }
  bool call(const Code& callee, Box* arguments, std::size_t count);
  bool call_builtin(std::uint16_t index, Box* arguments, std::size_t count,
                    Box& result);
  bool call_named(Box* named, std::size_t count);
  bool give_back(Box value); // false: the activation has finished
  bool perform(const EffectShape& shape, const Box* operands, Box& result);
  void load_slot(SlotId slot, Box& result);
  void store_slot(SlotId slot, const Box& value);
  void load_system(SystemVariable variable, Box& result);
  void load_message_parameter(std::size_t index, Box& result);
  void load_message_parameters(Box& result);
  bool refuel(); // false: yielded or raised

  // After a false: to the catching frame; false: the loop must be left.
  bool recover();

  std::shared_ptr<const Program> program;
  const Code* code; // of the program
  std::vector<Box> variables;
  // Of the run in progress.
  Host* host = nullptr;
  Execution* execution = nullptr;
  std::int64_t fuel = 0; // of this slice
  bool watched = false;
  std::uint64_t instructions = 0; // of one event
  std::uint64_t slice = defaults::slice;

private:
  friend class RunScope;

  void dispatch();
  bool may_call(const Code& callee); // false: too deep, raised
  std::uint64_t fuel_left() const;
  void take_slice();
  void give_back_fuel();
  bool goes_on_beyond_slice(); // false: raised
  void note_stack();
  Box taken_in(const Value& value); // copied from outside
  void release_bindings();          // before a wait
  void copy_out(Frame& frame);
  RunResult outcome();
  const CatchRange* find_catch(const Frame& frame) const;

  Box error_;
  bool raised_ = false;
  bool grace_given_ = false;
  Stop stop_ = Stop::none;
  bool to_the_end_ = false;
  Box value_;
  std::vector<std::string> stack_;
  std::uint64_t left_ = 0; // instructions of this event beyond the slice
  std::unique_ptr<Execution> spare_; // null: none has finished
};

} // namespace parlour::script
