// Machine: the implementation of the interpreter. handlers_*.hpp have the fast
// paths of the instructions; this class has everything else: frames, errors,
// fuel, slow paths, effects.
//
// The call stack of an activation is a list of frames on the session's heap:
//
//   Execution::top --> frame --caller--> frame --caller--> null
//                        |
//                      above --> left from an earlier call, to be reused
//
// Each frame is as large as its code needs: a head, then its registers.
// Suspending an activation keeps the pointer to its top frame and costs nothing
// else. The price, a linked list instead of one array, is small because frames
// are reused.
//
// One session's machine is used by one thread at a time.
#pragma once

#include <algorithm>
#include <cassert>
#include <limits>
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

// A call in progress. When it ends, the frame stays above its caller for the
// next call; its registers are then unknown.
struct CallFrame {
  const Code* code;
  CallFrame* caller;
  const Instruction* pc;  // being executed
  CallFrame* above;       // null: not made yet
  std::uint32_t capacity; // registers that fit
  std::uint32_t depth;    // from 1

  Box* registers() {
    return reinterpret_cast<Box*>(this + 1);
  }
  // The frame that has these registers.
  static CallFrame* of(Box* registers) {
    return reinterpret_cast<CallFrame*>(registers) - 1;
  }
  // Releases what the registers hold.
  void clear() {
    const auto* end = registers() + code->register_count;
    for (auto* box = registers(); box != end; ++box)
      *box = Box();
  }
};

// A parameter by reference whose callee has waited: it became a copy, which is
// stored back to the session variable when its frame ends (language rule 7.3).
struct CopyOut {
  CallFrame* frame;
  std::uint16_t parameter;
  std::uint32_t variable;
};

// The machine's side of an Activation: its call stack. It shares the ownership
// of the heap, so it can be destroyed after the machine.
class Execution : public Activation {
public:
  Execution(std::shared_ptr<Heap> heap, ActivationContext context)
      : Activation(std::move(context)), heap_(std::move(heap)) {}
  ~Execution() override;

  void begin(ActivationContext context) { // reuses a finished one
    set_context(std::move(context));
  }
  // Pushes a frame whose registers are unknown. The caller has checked the
  // depth. A frame that has to be made gets `room` for further registers.
  CallFrame* push(const Code& code, std::uint32_t room = 0);
  void pop(); // the top frame
  // Frees the frames above the top. While an activation waits or has yielded it
  // holds only frames in use, so that its size is the same after it was written
  // to bytes and read back.
  void release_above();

  CallFrame* top = nullptr;
  bool waiting = false;
  std::unique_ptr<std::vector<CopyOut>> copy_outs; // null: none

private:
  CallFrame* make_above(std::uint32_t registers);
  void release(CallFrame* frame); // and those above

  std::shared_ptr<Heap> heap_;
};

// Why the dispatch loop has ended.
enum class Stop : std::uint8_t { none, finished, waiting, yielded, failed };

// The fuel of an event (language rule 9.6), as a stored state has it.
struct EventFuel {
  std::uint64_t instructions = 0; // of one event
  std::uint64_t left = 0;
  bool grace_given = false; // for cleaning up after a limit
};

// Public members are used by the handlers and built-ins, which are part of the
// machine; nothing outside of script/vm and script/builtins sees it.
class Machine {
  std::shared_ptr<Heap> heap_; // first: outlives all boxes below

public:
  explicit Machine(std::shared_ptr<const Program> shared_program);

  // Runs an activation until it stops.
  RunResult run(Execution& activation, Host& current_host, bool to_the_end);
  // Runs an activation that was just started; returns nothing if it finished.
  std::optional<RunResult> run_body(Execution& activation, Host& current_host);
  RunResult resume(Execution& activation,
                   const Expected<Value>& outcome_of_wait, Host& current_host);
  std::unique_ptr<Execution> start(CodeId body,
                                   const std::vector<Value>& values,
                                   ActivationContext context);
  // Keeps a finished activation for the next start().
  void keep_spare(std::unique_ptr<Execution> finished) {
    finished->begin({}); // releases its message
    spare_ = std::move(finished);
  }

  // Makes an activation without frames, for a state that is read.
  std::unique_ptr<Execution> adopt(ActivationContext context);

  void new_event();
  // Fuel as part of a stored state.
  EventFuel event_fuel() const {
    return {instructions, left_, grace_given_};
  }
  void set_event_fuel(const EventFuel& event_fuel);

  // -- for operations and built-ins; false: an error was raised ---------------
  bool raise(ErrorKind kind, std::string message); // always false
  bool raise(Failure failure);
  bool raise_box(const Box& error_or_value);
  bool check(Outcome outcome) { // false: raised
    return !outcome || raise(std::move(*outcome));
  }
  bool within_limits(); // false: raised
  // Charges fuel for work beyond that of the instruction itself, in
  // instructions or by the price of WalkBudget. The slice may be overdrawn
  // here; the next loop or call then yields.
  bool charge(std::size_t price) {
    take(price);
    return fuel > 0 || goes_on_beyond_slice();
  }
  // Charges without looking whether the fuel is used up; the next loop or call
  // does.
  void take(std::size_t price) {
    fuel -= static_cast<std::int64_t>(price);
  }
  bool charge_bytes(std::size_t count) {
    return charge(WalkBudget::price_of_bytes(count));
  }
  bool charge_values(std::size_t count) {
    return charge(WalkBudget::price_of_values(count));
  }
  // How far an operation may walk: as the fuel allows, but through no more than
  // `max_bytes` bytes and no more than a session may hold.
  WalkBudget walk_budget(
      std::size_t max_bytes = std::numeric_limits<std::size_t>::max()) const;
  // Charges what was taken from it. Raises an error if it is exhausted.
  bool pay(const WalkBudget& budget,
           const char* too_much = "too much to compare");
  // Charges the memory that was made since the heap held `before` bytes.
  bool charge_made(std::size_t before) {
    return charge_bytes(std::max(heap_->used(), before) - before);
  }

  Heap& heap() {
    return *heap_;
  }

  // -- slow paths of the instructions: machine_operations.cpp ----------------

  // Operands may be bound parameters; results never are. All of these return
  // false after raising an error.
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
  // Loops: `loop` is the first of the registers that control one.
  bool for_prepare(Box* loop, bool& enters);
  bool for_next(Box* loop);
  bool each_prepare(const Box& collection, Box* loop);

  // -- calls, effects, the world: machine_calls.cpp --------------------------
  // Makes the callee's frame and moves the arguments into its first registers.
  // Null after an error. A reused frame has cleared registers, so those behind
  // the arguments are unknown.
  PARLOUR_INLINE CallFrame* enter(CallFrame* caller, const Code& callee,
                                  Box* arguments, std::size_t count) {
    auto* frame = caller->above;
    if (!frame || frame->capacity < callee.register_count) [[unlikely]] {
      if (!may_call(callee))
        return nullptr;
      frame = execution->push(callee);
    }
    frame->code = &callee;
    frame->pc = callee.instructions.data();
    execution->top = frame;
    assert(frame->caller == caller && frame->depth == caller->depth + 1);
    assert(count <= frame->capacity);
    auto* registers = frame->registers();
    for (std::size_t i = 0; i < count; ++i)
      registers[i].take(arguments[i]);
    if (callee.body > 0) [[unlikely]] // has defaults
      for (auto i = count; i < callee.parameter_count; ++i)
        registers[i] = Box::missing();
    return frame;
  }
  // Calls compiled code; the callee's result arrives at give_back().
  bool call(const Code& callee, Box* arguments, std::size_t count);
  // A built-in takes about as long as this many instructions.
  static constexpr std::size_t builtin_cost = 10;
  // Built-ins run to their end at once; they have no frame.
  bool call_builtin(std::uint16_t index, Box* arguments, std::size_t count,
                    Box& result);
  bool call_named(Box* named, std::size_t count);
  bool give_back(Box value); // false: the activation has finished
  // Hands an effect to the host. If it waits, the activation stops here.
  bool perform(const EffectShape& shape, const Box* operands, Box& result);
  // Values from the host are copied into the session's heap.
  void load_slot(SlotId slot, Box& result);
  void store_slot(SlotId slot, const Box& value);
  void load_system(SystemVariable variable, Box& result);
  void load_message_parameter(std::size_t index, Box& result);
  void load_message_parameters(Box& result);
  bool refuel(); // false: yielded or raised
  // Converts a value from outside, which costs fuel by its size.
  Box taken_in(const Value& value);

  // Continues after a handler returned false: finds the <catch> of a raised
  // error and unwinds to its frame. Returns false if the dispatch loop must
  // end.
  bool recover();

  // A session variable that is looked at. Its initial value is made now, if it
  // is the same in all sessions and this one has not needed it yet.
  PARLOUR_INLINE Box& variable(std::size_t index) {
    auto& box = variables[index];
    if (box.is_missing()) [[unlikely]]
      make_initial(index);
    return box;
  }

  std::shared_ptr<const Program> program;
  const Code* code; // of the program
  // The session variables, by their index in Program::variables; missing: see
  // variable().
  std::vector<Box> variables;
  // How often a session variable, or a list or map, which may be in one, was
  // changed.
  std::uint64_t writes = 0;
  // The run in progress. RunScope saves and restores these members.
  Host* host = nullptr;
  Execution* execution = nullptr;
  std::int64_t fuel = 0; // left of this slice
  bool watched = false;
  std::uint64_t instructions = 0; // of one event
  std::uint64_t slice = defaults::slice;

private:
  friend class RunScope;

  void dispatch();
  void make_initial(std::size_t index); // of a variable
  bool key_for(const Box& container, const Box& key, Box& result);
  bool may_call(const Code& callee); // false: too deep, raised
  // Of the event, slice included.
  std::uint64_t fuel_left() const;
  void take_slice();
  void give_back_fuel();
  bool goes_on_beyond_slice(); // false: raised
  // Remembers the call stack of the error just raised.
  void note_stack();
  void release_bindings(); // see CopyOut
  void copy_out(CallFrame& frame);
  RunResult outcome();
  const CatchRange* find_catch(const CallFrame& frame) const;

  // The error being raised, until a <catch> or the end of the run.
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
