#include "adapters/audio/playout_speaker.hpp"

namespace parlour::adapters {

PlayoutSpeaker::PlayoutSpeaker() : RolePlugin("Speaker") {
  on("Play", &PlayoutSpeaker::on_play);
  on("Mark", &PlayoutSpeaker::on_mark);
  on("Finish", &PlayoutSpeaker::on_finish);
  on("Stop", &PlayoutSpeaker::on_stop);
}

void PlayoutSpeaker::tell(const std::vector<PlayoutEvent>& events) {
  for (const auto& event : events)
    answer(event.to, event.command, event.params);
}

template <class Action>
void PlayoutSpeaker::order(Action action) {
  const auto done = with_playout([&](Playout& playout) {
    auto is_ready = ready();
    return is_ready ? action(playout) : is_ready;
  });
  if (!done)
    return refuse(done.error().message);
  changed();
}

void PlayoutSpeaker::on_play(const Value& audio, std::int64_t utterance) {
  order([&](Playout& playout) {
    return playout.play(current(), utterance, audio);
  });
}

void PlayoutSpeaker::on_mark(std::int64_t utterance, const std::string& word,
                             std::int64_t position) {
  order([&](Playout& playout) {
    return playout.mark(current(), utterance, word, position);
  });
}

void PlayoutSpeaker::on_finish(std::int64_t utterance) {
  order([&](Playout& playout) { return playout.finish(current(), utterance); });
}

void PlayoutSpeaker::on_stop(std::optional<std::int64_t> utterance) {
  order([&](Playout& playout) {
    playout.stop(current().session, utterance);
    return Expected<void>();
  });
}

} // namespace parlour::adapters
