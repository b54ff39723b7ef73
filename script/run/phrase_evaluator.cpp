#include "script/run/phrase_evaluator.hpp"

#include <optional>
#include <utility>
#include <vector>

#include "runtime/base/random.hpp"
#include "script/program/computing_host.hpp"
#include "script/run/interpreter_pool.hpp"

namespace parlour::script {

namespace {

// The host of a phrase: it has the time of the utterance and random numbers.
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
      : pool_(std::move(program)) {}

  // A phrase that fails leaves its turn to the next one (language rule 12.7).
  Rendering render(const Value& say) const override {
    Rendering rendering;
    const auto turn = static_cast<std::uint64_t>(say["rotation"].integer_or(0));
    // From the most specific rank down, until a phrase gives words.
    for (int wanted = max_specific; wanted > 0; --wanted) {
      const auto found = that_hold(say, wanted, rendering);
      for (std::size_t i = 0; i < found.size() && !rendering.words; ++i) {
        const auto& phrase = *found[(turn + i) % found.size()];
        if (auto text = computed(phrase.text, say, rendering))
          rendering.words = text->text();
      }
      if (rendering.words)
        break;
    }
    return rendering;
  }

private:
  static constexpr int max_specific = 16;

  // How specific a phrase is; 0 if it does not apply. A topic counts most, then
  // a slot, then belonging to the application, then having a condition.
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

  // The phrases of one rank whose conditions hold.
  std::vector<const Phrase*> that_hold(const Value& say, int wanted,
                                       Rendering& rendering) const {
    std::vector<const Phrase*> found;
    for (const auto& phrase : pool_.program().phrases) {
      if (rank(phrase, say) != wanted)
        continue;
      if (phrase.condition == no_code ||
          computed(phrase.condition, say, rendering).value_or(false))
        found.push_back(&phrase);
    }
    return found;
  }

  // Computes code of a phrase; errors are collected in `rendering`.
  std::optional<Value> computed(CodeId code, const Value& say,
                                Rendering& rendering) const {
    PhraseHost host(say);
    auto value = pool_.evaluate(
        code, {say["act"], say["topic"], say["slot"], say["data"]}, {}, host);
    if (value)
      return std::move(*value);
    rendering.failures.push_back(std::move(value.error()));
    return std::nullopt;
  }

  InterpreterPool pool_;
};

} // namespace

std::shared_ptr<const PhraseEvaluator>
make_phrase_evaluator(std::shared_ptr<const Program> program) {
  return std::make_shared<Evaluator>(std::move(program));
}

} // namespace parlour::script
