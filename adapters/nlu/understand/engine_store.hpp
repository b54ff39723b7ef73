// EngineStore remembers the engines that were built last. The same one is
// wanted again and again: when an application is checked and then started, by
// several instances of the component, after a reload that left grammars and
// values as they were, and by each conversation of a test. To build one takes a
// tenth of a second, to find it a hundredth of that.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "adapters/nlu/understand/nlu_engine.hpp"

namespace parlour::adapters::nlu {

// Thread-safe. Where several threads want the same engine that is not there
// yet, each builds it.
class EngineStore {
public:
  // Keeps at most `capacity` engines; the one that was not wanted for longest
  // goes first. Whoever has it may go on using it.
  explicit EngineStore(std::size_t capacity = 2);

  // The same as NluEngine::build. Columns are read in any case, since an engine
  // knows the values that they had when it was built.
  tl::expected<NluEngine, std::vector<Error>>
  get(const UnderstandingModel& model, const NluEngine::Options& options,
      const ColumnReader& columns);

private:
  // An engine, and all that it was built from.
  struct Kept {
    UnderstandingModel model;
    NluEngine::Options options;
    std::map<std::string, std::vector<std::string>> columns;
    NluEngine engine;
  };
  using KeptEngines = std::vector<std::shared_ptr<const Kept>>;

  KeptEngines kept() const;
  // Puts it last, where those are that are kept longest.
  void keep(std::shared_ptr<const Kept> latest);

  const std::size_t capacity_;
  mutable std::mutex mutex_;
  KeptEngines kept_; // the one that was wanted last is the last
};

// The store of this process.
EngineStore& engine_store();

} // namespace parlour::adapters::nlu
