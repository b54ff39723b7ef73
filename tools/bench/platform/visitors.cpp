#include "tools/bench/platform/visitors.hpp"

#include <algorithm>

#include "tools/parlour/application/node_options.hpp"

namespace parlour::tools {

namespace {

// A morning.
constexpr Timestamp start = 1'795'252'500'000;

} // namespace

Expected<Visitors> Visitors::arrive(const Application& application) {
  auto data = DataFolder::temporary();
  if (!data)
    return tl::make_unexpected(data.error());
  auto node = actors::Node::start(
      node_options(application, rehearsed(application.composition),
                   {data->path().string(), start, 1}));
  if (!node)
    return tl::make_unexpected(node.error());
  return Visitors(std::move(*data), std::move(*node));
}

void Visitors::open(std::size_t count) {
  for (std::size_t opened = 0; opened < count; ++opened) {
    const auto visitor = seats_.size();
    told_->emplace_back();
    seats_.push_back(node_->open_seat(
        {[told = told_.get(), visitor](const SessionId&,
                                       const dialogue::Output& output) {
           (*told)[visitor] += output.text + '\n';
         },
         {}}));
    node_->open(seats_.back());
  }
}

void Visitors::wait(Milliseconds time) {
  node_->advance(time);
}

void Visitors::say(const std::vector<std::string>& turns) {
  for (const auto& seat : seats_) {
    node_->enter(seat, turns);
    node_->run_until_quiet();
  }
}

std::size_t Visitors::misled() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(*told_, [this](const std::string& told) {
        return told != told_->front();
      }));
}

} // namespace parlour::tools
