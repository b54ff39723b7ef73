#include "script/phrase_evaluator.hpp"

#include <mutex>

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

  std::optional<std::string> render(const Value& say) const override {
    auto interpreter = take(say);
    auto words = choose(*interpreter, say);
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(interpreter));
    return words;
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

  std::optional<std::string> choose(Interpreter& interpreter,
                                    const Value& say) const {
    for (int wanted = most_specific; wanted > 0; --wanted) {
      std::vector<const Phrase*> found;
      for (const auto& phrase : program_->phrases)
        if (rank(phrase, say) == wanted && holds(interpreter, phrase, say))
          found.push_back(&phrase);
      if (found.empty())
        continue;
      const auto turn =
          static_cast<std::uint64_t>(say["rotation"].integer_or(0));
      const auto text =
          evaluate(interpreter, found[turn % found.size()]->text, say);
      if (text)
        return text->text();
    }
    return {};
  }

  static bool holds(Interpreter& interpreter, const Phrase& phrase,
                    const Value& say) {
    if (phrase.condition == no_code)
      return true;
    const auto value = evaluate(interpreter, phrase.condition, say);
    return value && static_cast<bool>(*value);
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
