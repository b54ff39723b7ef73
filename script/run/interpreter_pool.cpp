#include "script/run/interpreter_pool.hpp"

#include <utility>

namespace parlour::script {

namespace {

// Passes all on to another host, and notices whether it is asked for what
// differs from one caller to the next.
class AskedHost final : public Host {
public:
  explicit AskedHost(Host& host) : host_(host) {}

  Performed perform(Activation& activation, const Effect& effect) override {
    return host_.perform(activation, effect);
  }
  Value slot(TopicId topic, SlotId slot) const override {
    return asked().slot(topic, slot);
  }
  void set_slot(TopicId topic, SlotId slot, Value value) override {
    asked().set_slot(topic, slot, std::move(value));
  }
  Value system(const Activation& activation,
               SystemVariable variable) const override {
    return asked().system(activation, variable);
  }
  bool online(const std::string& agent) const override {
    return asked().online(agent);
  }
  Timestamp now() const override {
    return asked().now();
  }
  double random() override {
    return asked().random();
  }
  bool was_asked() const {
    return was_asked_;
  }

private:
  Host& asked() const {
    was_asked_ = true;
    return host_;
  }

  Host& host_;
  mutable bool was_asked_ = false;
};

} // namespace

InterpreterPool::InterpreterPool(std::shared_ptr<const Program> program)
    : program_(std::move(program)) {}

// The interpreter returns to the pool also after an error, but not if anything
// was changed in it.
Expected<Value> InterpreterPool::evaluate(CodeId code,
                                          const std::vector<Value>& arguments,
                                          ActivationContext context,
                                          Host& host) const {
  auto [interpreter, suits_all] = take(host);
  interpreter->new_event();
  const auto writes = interpreter->writes();
  auto value = interpreter->evaluate(code, arguments, std::move(context), host);
  if (suits_all && interpreter->writes() == writes) {
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(interpreter));
  }
  return value;
}

InterpreterPool::Ready InterpreterPool::take(Host& host) const {
  {
    const std::lock_guard lock(mutex_);
    if (!free_.empty()) {
      auto interpreter = std::move(free_.back());
      free_.pop_back();
      return {std::move(interpreter)};
    }
  }
  AskedHost asked(host);
  auto interpreter = std::make_unique<Interpreter>(program_);
  interpreter->initialise_what_computes(asked);
  return {std::move(interpreter), !asked.was_asked()};
}

} // namespace parlour::script
