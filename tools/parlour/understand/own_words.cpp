#include "tools/parlour/understand/own_words.hpp"

#include <utility>

#include "tools/parlour/application/node_options.hpp"

namespace parlour::tools {

OwnWords::OwnWords(DataFolder data) : data_(std::move(data)) {}

OwnWords::~OwnWords() = default;

Expected<std::unique_ptr<OwnWords>> OwnWords::start(const Application& of,
                                                    Timestamp clock) {
  auto data = DataFolder::temporary();
  if (!data)
    return tl::make_unexpected(data.error());
  std::unique_ptr<OwnWords> made(new OwnWords(std::move(*data)));
  // The seed is any: it has to be the same every time.
  auto options = node_options(of, rehearsed(of.composition),
                              {made->data_.path().string(), clock, 1});
  options.on_inspection = [own = made.get()](const auto& seen) {
    own->watch(seen);
  };
  options.exact_inspections = true;
  auto node = actors::Node::start(std::move(options));
  if (!node)
    return tl::make_unexpected(node.error());
  made->node_ = std::move(*node);
  made->seat_ = made->node_->open_seat({});
  return made;
}

// A message is seen when it is posted, and again when it is taken.
void OwnWords::watch(const Inspection& seen) {
  if (sent_ || !seen.message || seen.message->command != "DoNLU" ||
      seen.message->sinks.empty() || seen.message->params.empty())
    return;
  const auto& params = seen.message->params;
  const auto* context = params.size() > 1 ? params[1].if_map() : nullptr;
  sent_ = SentWords{params[0].text(), context ? *context : Map()};
}

std::optional<SentWords> OwnWords::say(const std::string& text) {
  const auto session = node_->open(seat_);
  sent_.reset();
  node_->enter(seat_, {text});
  node_->run_until_quiet();
  auto sent = std::exchange(sent_, {});
  // Wait until it has ended: the next sentence would be said in it.
  node_->end(session);
  node_->run_until_quiet();
  return sent;
}

} // namespace parlour::tools
