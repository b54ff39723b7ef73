#include "adapters/asr/sphinx/recogniser_pool.hpp"

#include <utility>

namespace parlour::adapters::asr {

namespace {

using Renewed = RecogniserPool::Renewed;

// The first recogniser is made here, so that the slow part is done where nobody
// waits.
Expected<Renewed> make_renewed(const LanguageSources& sources,
                               const std::string& model) {
  auto vocabulary = make_vocabulary(sources, model);
  if (!vocabulary)
    return tl::make_unexpected(vocabulary.error());
  Renewed made;
  made.vocabulary = std::make_shared<const Vocabulary>(std::move(*vocabulary));
  if (made.vocabulary->made->language.sentences().arc_count() == 0)
    return made;
  auto first = Hearing::make(made.vocabulary, model);
  if (!first)
    return tl::make_unexpected(first.error());
  made.first.emplace(std::move(*first));
  return made;
}

} // namespace

Expected<std::unique_ptr<RecogniserPool>>
RecogniserPool::make(LanguageSources sources, const std::string& model,
                     std::size_t most) {
  auto pool = std::unique_ptr<RecogniserPool>(
      new RecogniserPool(std::move(sources), model, most));
  auto first = make_renewed(pool->sources_, model);
  if (!first)
    return tl::make_unexpected(first.error());
  pool->use(std::move(*first));
  return pool;
}

RecogniserPool::RecogniserPool(LanguageSources sources, std::string model,
                               std::size_t most)
    : model_(std::move(model)), most_(most),
      columns_(std::make_shared<nlu::KnownColumns>()),
      sources_(std::move(sources)) {
  sources_.columns = [known = columns_, read = std::move(sources_.columns)](
                         const std::string& name) {
    return known->read(name, read);
  };
}

// Beside the free ones, one more is made where there may be more.
std::optional<Hearing> RecogniserPool::take() {
  if (free_.empty() && made_ < most_ && !is_deaf_)
    if (auto made = Hearing::make(vocabulary_, model_)) {
      free_.push_back(std::move(*made));
      ++made_;
    }
  if (free_.empty())
    return {};
  std::optional<Hearing> taken(std::move(free_.back()));
  free_.pop_back();
  return taken;
}

// One of an old vocabulary is done with.
void RecogniserPool::give_back(Hearing hearing) {
  if (hearing.vocabulary() == vocabulary_)
    free_.push_back(std::move(hearing));
}

bool RecogniserPool::set_values(const std::string& column, const List& values) {
  return columns_->set(column, values);
}

// The values as they are now: others may come while it works.
RecogniserPool::Maker RecogniserPool::maker() const {
  auto sources = sources_;
  sources.columns = [values = *columns_](const std::string& name) mutable {
    return values.read(name, [](const std::string& unknown) {
      return fail(ErrorKind::database, "nobody has read " + unknown);
    });
  };
  return [sources = std::move(sources), model = model_] {
    return make_renewed(sources, model);
  };
}

RecogniserPool::Outcome RecogniserPool::renew() const {
  return std::make_shared<Expected<Renewed>>(maker()());
}

void RecogniserPool::renew(Loop& loop,
                           std::function<void(Outcome)> made) const {
  loop.post([maker = maker(), made = std::move(made)] {
    made(std::make_shared<Expected<Renewed>>(maker()));
  });
}

// Those that are lent now belong to the vocabulary before, and do not count.
void RecogniserPool::use(Renewed renewed) {
  vocabulary_ = std::move(renewed.vocabulary);
  is_deaf_ = !renewed.first;
  free_.clear();
  made_ = 0;
  if (is_deaf_)
    return;
  free_.push_back(std::move(*renewed.first));
  made_ = 1;
}

} // namespace parlour::adapters::asr
