#include "tools/bench/speech/listener.hpp"

#include <utility>

#include "tools/parlour/application/understanding.hpp"

namespace parlour::tools {

namespace {

using adapters::Sound;

// In ms of the noise alone: detectors learn it, and the turn ends in it.
constexpr std::int64_t before = 1'000;
constexpr std::int64_t behind = 1'600;

Sound surrounded(const Sound& line, const Sound& noise) {
  Sound all(adapters::samples_in(before) + line.size() +
            adapters::samples_in(behind));
  for (std::size_t at = 0; at < all.size() && !noise.empty();
       at += noise.size())
    adapters::add(all, noise, at);
  adapters::add(all, line, adapters::samples_in(before));
  return all;
}

// Components that answer at once, so that time may be virtual.
Application waited_for(Application application, bool told) {
  for (auto& component : application.composition.components)
    for (const auto& option : component.factory.description.options)
      if (option.name == "one-by-one")
        component.options[option.name] = "true";
      else if (option.name == "conversations" && !told)
        component.options[option.name] = "none";
  return application;
}

Expected<adapters::nlu::NluEngine> engine_of(const Application& application) {
  const auto* component = first_of_role(application.composition, "NLU");
  if (!component)
    return fail(ErrorKind::settings, "there is no component of the role NLU");
  auto built = build_engine(application, *component,
                            column_reader(rehearsed(application.composition),
                                          application.folder, ""));
  if (!built)
    return tl::make_unexpected(built.error().front());
  return std::move(*built);
}

} // namespace

Listener::Listener(Application application, adapters::nlu::NluEngine engine,
                   Map context)
    : application_(std::move(application)), engine_(std::move(engine)),
      context_(std::move(context)) {}

Expected<std::unique_ptr<Listener>> Listener::start(const Application& spoken,
                                                    bool told) {
  auto engine = engine_of(spoken);
  if (!engine)
    return tl::make_unexpected(engine.error());
  // The morning of a Monday, whenever the bench runs.
  auto context =
      first_context(*spoken.program, *parse_timestamp("2026-11-23 09:00"));
  std::unique_ptr<Listener> made(new Listener(
      waited_for(spoken, told), std::move(*engine), std::move(context)));
  auto ears = Ears::start(made->application_);
  if (!ears)
    return tl::make_unexpected(ears.error());
  made->ears_ = std::move(*ears);
  return made;
}

Expected<HeardLine> Listener::hear(const Sound& line, const Sound& noise) {
  const auto heard = ears_->hear(surrounded(line, noise));
  if (!heard)
    return tl::make_unexpected(heard.error());
  HeardLine made;
  for (const auto& turn : heard->turns) {
    if (turn.text.empty())
      continue;
    made.rejected = false;
    made.text += (made.text.empty() ? "" : " ") + turn.text;
    if (made.acts.empty())
      made.acts = understand(turn.text, turn.alternatives);
  }
  return made;
}

List Listener::understand(const std::string& text,
                          const List& alternatives) const {
  return engine_.understand(text, with_alternatives(context_, alternatives))
      .acts;
}

} // namespace parlour::tools
