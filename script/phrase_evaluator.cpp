#include "script/phrase_evaluator.hpp"

#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "runtime/base/random.hpp"
#include "script/computing_host.hpp"
#include "script/interpreter.hpp"

namespace parlour::script {

namespace {

class PhraseHost : public ComputingHost {
public:
  explicit PhraseHost(const Value& say)
      : ComputingHost("a phrase", say["now"].integer_or(0)),
        random_(static_cast<std::uint64_t>(say["rotation"].integer_or(0))) {}

  // From the rotation, so that equal inputs give equal words.
  double random() override {
    return random_.fraction();
  }

private:
  Random random_;
};

class Evaluator : public PhraseEvaluator {
public:
  explicit Evaluator(std::shared_ptr<const Program> program)
      : program_(std::move(program)) {}

  Rendering render(const Value& say) const override {
    auto interpreter = take(say);
    auto rendering = choose(*interpreter, say);
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(interpreter));
    return rendering;
  }

private:
  // Interpreters are kept, with the constants that phrases may read.
  std::unique_ptr<Interpreter> take(const Value& say) const {
    {
      const std::lock_guard lock(mutex_);
      if (!free_.empty()) {
        auto interpreter = std::move(free_.back());
        free_.pop_back();
        return interpreter;
      }
    }
    auto interpreter = std::make_unique<Interpreter>(program_);
    PhraseHost host(say);
    // A variable that fails stays unknown; the session reports it.
    static_cast<void>(interpreter->initialise(host));
    return interpreter;
  }

  static Expected<Value> evaluate(Interpreter& interpreter, CodeId code,
                                  const Value& say) {
    PhraseHost host(say);
    interpreter.new_event();
    return interpreter.evaluate(
        code, {say["act"], say["topic"], say["slot"], say["data"]}, {}, host);
  }

  static constexpr int most_specific = 16;

  // 0: does not apply; higher is more specific: slot, then topic, then the
  // application before the platform, then a condition before none.
  static int rank(const Phrase& phrase, const Value& say) {
    auto fits = [&](const std::string& wanted, const char* key) {
      return wanted.empty() ||
             (!say[key].is_unknown() && say[key].text() == wanted);
    };
    if (phrase.act != say["act"].text() || !fits(phrase.topic, "topic") ||
        !fits(phrase.slot, "slot"))
      return 0;
    return 1 + (phrase.condition != no_code) + 2 * !phrase.of_platform +
           4 * (2 * !phrase.topic.empty() + !phrase.slot.empty());
  }

  // One that fails leaves its turn to the next.
  Rendering choose(Interpreter& interpreter, const Value& say) const {
    Rendering rendering;
    const auto turn = static_cast<std::uint64_t>(say["rotation"].integer_or(0));
    for (int wanted = most_specific; wanted > 0; --wanted) {
      const auto found = that_hold(interpreter, say, wanted, rendering);
      for (std::size_t i = 0; i < found.size() && !rendering.words; ++i) {
        const auto& phrase = *found[(turn + i) % found.size()];
        if (auto text = computed(interpreter, phrase.text, say, rendering))
          rendering.words = text->text();
      }
      if (rendering.words)
        break;
    }
    return rendering;
  }

  std::vector<const Phrase*> that_hold(Interpreter& interpreter,
                                       const Value& say, int wanted,
                                       Rendering& rendering) const {
    std::vector<const Phrase*> found;
    for (const auto& phrase : program_->phrases) {
      if (rank(phrase, say) != wanted)
        continue;
      if (phrase.condition == no_code ||
          computed(interpreter, phrase.condition, say, rendering)
              .value_or(false))
        found.push_back(&phrase);
    }
    return found;
  }

  static std::optional<Value> computed(Interpreter& interpreter, CodeId code,
                                       const Value& say, Rendering& rendering) {
    auto value = evaluate(interpreter, code, say);
    if (value)
      return std::move(*value);
    rendering.failures.push_back(std::move(value.error()));
    return std::nullopt;
  }

  std::shared_ptr<const Program> program_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<Interpreter>> free_;
};

} // namespace

std::shared_ptr<const PhraseEvaluator>
make_phrase_evaluator(std::shared_ptr<const Program> program) {
  return std::make_shared<Evaluator>(std::move(program));
}

} // namespace parlour::script
