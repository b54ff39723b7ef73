#include "adapters/nlu/understand/engine_store.hpp"

#include <algorithm>
#include <utility>

#include "adapters/nlu/values/known_columns.hpp"

namespace parlour::adapters::nlu {

EngineStore::EngineStore(std::size_t capacity) : capacity_(capacity) {}

// No lock is held while columns are read and while an engine is built: both
// call what is not ours, and take long.
tl::expected<NluEngine, std::vector<Error>>
EngineStore::get(const UnderstandingModel& model,
                 const NluEngine::Options& options,
                 const ColumnReader& columns) {
  KnownColumns once; // whoever asks for a column, it is read once
  const auto values_of = [&](const std::string& name) {
    return once.read(name, columns);
  };
  const auto has_these_values = [&](const auto& column) {
    const auto values = values_of(column.first);
    return values && *values == column.second;
  };
  std::shared_ptr<const Kept> taught;
  for (auto& each : kept()) {
    if (each->model != model || each->options != options)
      continue;
    if (std::ranges::all_of(each->columns, has_these_values)) {
      keep(each);
      return each->engine;
    }
    taught = each;
  }
  std::map<std::string, std::vector<std::string>> read;
  auto built = NluEngine::build(
      model,
      [&](const auto& name) {
        auto values = values_of(name);
        if (values)
          read[name] = *values;
        return values;
      },
      options, taught ? &taught->engine : nullptr);
  if (built)
    keep(std::make_shared<const Kept>(
        Kept{model, options, std::move(read), *built}));
  return built;
}

EngineStore::KeptEngines EngineStore::kept() const {
  const std::lock_guard lock(mutex_);
  return kept_;
}

void EngineStore::keep(std::shared_ptr<const Kept> latest) {
  const std::lock_guard lock(mutex_);
  std::erase(kept_, latest);
  kept_.push_back(std::move(latest));
  if (kept_.size() > capacity_)
    kept_.erase(kept_.begin());
}

EngineStore& engine_store() {
  static EngineStore store;
  return store;
}

} // namespace parlour::adapters::nlu
