// SpokenLines: seats for conversations in which voices speak some lines
// (`U(voice=rms, noise=babble@20): …`).
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "tools/parlour/conversation_test/spoken_seat.hpp"
#include "tools/parlour/conversation_test/test_suite.hpp"
#include "tools/parlour/voice_test/background.hpp"
#include "tools/parlour/voice_test/kept_component.hpp"
#include "tools/parlour/voice_test/speech_bank.hpp"

namespace parlour::tools {

class SpokenLines : public SpokenSeats {
public:
  // Speaks all lines of the suite that have a voice. `application` has a voice
  // seat with files as microphone and speaker (add_voice); `voices` has the
  // plug-ins that speak. The findings say which line cannot be spoken.
  SpokenLines(Application application, const TestSuite& suite,
              std::shared_ptr<PluginCatalogue> voices);

  const std::vector<script::Finding>& findings() const {
    return findings_;
  }
  const Application& application() const override {
    return application_;
  }
  std::unique_ptr<SpokenSeat> make() override;

  // What the step says, and what is behind it.
  const adapters::Sound& line(const Step& step) const;
  const adapters::Sound& noise(const Step& step) const;

private:
  void add(const Conversation& conversation, const Step& step);

  Application application_;
  KeptComponents recognisers_;
  SpeechBank bank_;
  // By voice and noise.
  std::map<std::pair<std::string, std::string>, adapters::Sound> noises_;
  adapters::Sound sniff_;
  std::vector<script::Finding> findings_;
};

// Whether a voice speaks something in one of them.
bool is_spoken(const TestSuite& suite);

} // namespace parlour::tools
